# Drives a Create 2 for 90 s among boxes and writes run.txt: poses of its LIDARs in each step, and their scans.
from math import atan2, degrees, hypot, radians

from org.SEAR.POJOs import Box, Floor, LIDAR, Robots

HALF_TRACK = 0.1175                 # metres
STOPS = ((2.2, 0.2), (2.4, 2.4), (0.0, 2.9), (-0.2, 0.3), (-1.5, -0.6), (-2.8, 0.4), (-2.9, 2.2), (-1.0, 2.6), (0.2, 0.6),
    (1.2, -0.8), (1.4, -2.0), (0.8, -3.2), (-1.0, -3.0), (-1.0, -0.8))     # metres north and east

sear = Runtime.start("sear", "SEAR")
sear.newProject()
Floor("floor", 12, 12, False)
out = open("run.txt", "w")

def box(name, length, width, x, z, turn):
    part = Box(name, length, width, 1, 0)
    part.move(x, 0.5, z)
    part.rotate(0, turn, 0)
    out.write("box %r %r %r %r %r\n" % (length, width, x, z, turn))

for side, length, width, x, z in (("north", 0.1, 8.2, 4.05, 0), ("south", 0.1, 8.2, -4.05, 0), ("east", 8, 0.1, 0, 4.05),
        ("west", 8, 0.1, 0, -4.05)):
    box(side, length, width, x, z, 0)
for number, place in enumerate(((0.6, 0.9, 1.2, 1.4, 20), (0.5, 1.2, -1.7, 1.0, -35), (1.0, 0.4, 2.6, -2.4, 60),
        (0.7, 0.7, -2.4, -2.2, 15), (0.3, 0.5, 0.2, -1.2, 80), (0.5, 0.5, 3.3, 2.9, 45), (0.8, 0.3, -3.2, 3.1, 10),
        (0.4, 0.6, -3.6, -0.3, 0))):
    box("box %d" % number, *place)

robot = Robots.create2("robot")
for name, seconds in (("instant", 0), ("rolling", 0.1)):
    lidar = LIDAR(name, 12, 360, 1, 0, 0.15, 0)
    lidar.setClosed(False)
    lidar.setScanTime(seconds)
    robot.addComponent(lidar)
robot.placeAt(0, 0, 0)
sear.startSimulation()
steps = 0

def step(number):
    global steps
    for i in range(number):
        sear.step(1)
        steps += 1
        x, y, z, rx, ry, rz = sear.getPose("instant")
        out.write("pose %r %r %r %r\n" % (sear.getTime(), x, z, ry))
        if steps % 6 == 0:
            for name in ("instant", "rolling"):
                out.write("%s %r %s\n" % (name, sear.getTime(), " ".join("%.4f" % metres for metres in sear.getLidarResult(name))))

step(60)                            # SLAM programs start at rest, and both kinds of scans end alike
stop = 0
rate = 0.0                          # degrees per second, to the left
while steps < 60 * 89:
    x, y, z, rx, ry, rz = sear.getPose("robot")
    north, east = STOPS[stop][0] - x, STOPS[stop][1] - z
    if hypot(north, east) < 0.2:
        stop = (stop + 1) % len(STOPS)
        continue
    error = (degrees(atan2(north, east)) - ry + 180) % 360 - 180
    wanted = max(-60, min(60, 2.5 * error))
    rate += max(-6, min(6, wanted - rate))
    turn = radians(rate) * HALF_TRACK
    speed = 0.3 if abs(error) < 30 else 0.12
    sear.setWheelSpeeds(speed - turn, speed + turn)
    step(4)
sear.driveStraight(0)
step(120)
out.close()
