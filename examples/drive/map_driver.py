# Draws a flat of 10 by 7 metres as a ROS map, makes it the world, and drives a Roomba by its LIDAR from the bedroom to the kitchen.
import os
from math import atan2, cos, degrees, hypot, radians, sin
from org.SEAR.POJOs import Floor, FloorPlan, LIDAR, Maze, Robots

SIDE = 0.05                                 # metres per pixel
COLUMNS, ROWS = 200, 140
STOPS = ((2, -2.2), (-0.6, -2.2), (-0.6, 2.6), (1.6, 2.6))      # metres north and east: through two doors

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.newProject()                           # backs up the present project

# The map, row by row from the north: 0 is a wall, 254 is free, 205 is unknown.
pixels = [[254] * COLUMNS for row in range(ROWS)]

def wall(top, left, bottom, right):
    for row in range(top, bottom):
        pixels[row][left:right] = [0] * (right - left)

for outer in ((0, 0, 2, 200), (138, 0, 140, 200), (0, 0, 140, 2), (0, 198, 140, 200)):
    wall(*outer)
wall(62, 0, 64, 46)                         # between the rooms and the hall, with doors
wall(62, 66, 64, 144)
wall(62, 164, 64, 200)
wall(0, 100, 64, 102)                       # between bedroom and kitchen
wall(20, 186, 50, 198)                      # a cupboard

if not os.path.isdir("SEARproject/assets/maps"):
    os.makedirs("SEARproject/assets/maps")
with open("SEARproject/assets/maps/flat.pgm", "wb") as out:
    out.write("P5 %d %d 255\n" % (COLUMNS, ROWS))
    out.write("".join(chr(value) for row in pixels for value in row))
with open("SEARproject/assets/maps/flat.yaml", "w") as out:
    out.write("image: flat.pgm\nresolution: %s\norigin: [%s, %s, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
        % (SIDE, -COLUMNS * SIDE / 2, -ROWS * SIDE / 2))        # of the lower left corner: metres east and north

Floor("floor", 7, 10)
FloorPlan("flat", "maps/flat.yaml", 1.2)
shelves = Maze("shelves", " _ _\n|_  |\n|_|_|", 0.5)
shelves.setHeight(0.8)
shelves.move(-2.4, 0, -3)
robot = Robots.create("driver", "/dev/my_Robot01", "/dev/SEAR_Robot_01")
robot.move(STOPS[0][0], 0, STOPS[0][1])
lidar = LIDAR("scanner", 8, 180, 1, 0, 0.15, 0.1)
robot.addComponent(lidar)
sear.startSimulation()
sear.simSleep(1)

def wrapped(angle):
    """Wraps an angle to -180 to 180 degrees."""
    return (angle + 180) % 360 - 180

def driveTo(x, z):
    while True:
        pose = sear.getPose("driver")
        north, east = x - pose[0], z - pose[2]
        way = hypot(north, east)
        if way < 0.05:
            break
        error = wrapped(degrees(atan2(north, east)) - pose[4])
        if abs(error) > 15:
            sear.spin(max(-90, min(90, 4 * error)))
        else:
            speed = min(0.3, way + 0.05)
            sear.setWheelSpeeds(speed - 0.005 * error, speed + 0.005 * error)
        sear.simSleep(0.1)
    sear.driveStraight(0)
    sear.simSleep(0.5)

def onMap():
    """Returns how many beams of a scan end on a wall pixel of the map, and how many end within the plan's rooms."""
    x, y, z, rx, ry, rz = sear.getPose("scanner")
    scan = sear.getLidarResult("scanner")
    good, hits = 0, 0
    for i in range(len(scan)):
        angle = radians(ry + i - 90)        # the first beam is the rightmost
        north, east = x + (scan[i] + 0.01) * sin(angle), z + (scan[i] + 0.01) * cos(angle)
        row, column = int(ROWS / 2 - north / SIDE), int(east / SIDE + COLUMNS / 2)
        shelf = abs(north + 2.4) < 0.6 and abs(east + 3) < 0.6
        if scan[i] < 7.9 and not shelf:
            hits += 1
            good += pixels[row][column] == 0
    return good, hits

good, hits = 0, 0
for stop in STOPS:
    driveTo(*stop)
    seen = onMap()
    good, hits = good + seen[0], hits + seen[1]
pose = sear.getPose("driver")
print("in the kitchen at x %.2f, z %.2f; %d of %d beams end on a wall of the map" % (pose[0], pose[2], good, hits))
