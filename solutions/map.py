# Solution: a map with LIDAR. Scan from several places: the cells along a beam are free, the cell at its end is
# occupied.
from math import atan2, cos, degrees, hypot, radians, sin

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()
sear.simSleep(1)

CELL = 0.1
SIZE = 42
STOPS = ((0.9, -0.9), (0.2, -0.4), (-0.4, 0.4), (-1.3, 1.2), (0.3, 0.3))     # metres north and east
evidence = [[0] * SIZE for row in range(SIZE)]      # above 0: occupied, below: free

def mark(x, z, amount):
    row, column = int((2.1 - x) / CELL), int((z + 2.1) / CELL)
    if 0 <= row < SIZE and 0 <= column < SIZE:
        evidence[row][column] = max(-20, min(20, evidence[row][column] + amount))

def look():
    x, y, z, rx, ry, rz = sear.getPose("lidar")
    scan = sear.getLidarResult("lidar")
    for i in range(len(scan)):
        north, east = sin(radians(ry + i - 90)), cos(radians(ry + i - 90))
        for step in range(int(scan[i] / CELL)):
            mark(x + step * CELL * north, z + step * CELL * east, -1)
        mark(x + (scan[i] + 0.02) * north, z + (scan[i] + 0.02) * east, 4)

def wrapped(angle):
    return (angle + 180) % 360 - 180

def driveTo(x, z):
    while True:
        pose = sear.getPose("robot")
        north, east = x - pose[0], z - pose[2]
        if hypot(north, east) < 0.05:
            break
        error = wrapped(degrees(atan2(north, east)) - pose[4])
        if abs(error) > 10:
            sear.spin(max(-90, min(90, 4 * error)))
        else:
            sear.setWheelSpeeds(0.2 - 0.005 * error, 0.2 + 0.005 * error)
        sear.simSleep(0.1)
    sear.driveStraight(0)

for x, z in STOPS:
    driveTo(x, z)
    sear.simSleep(0.3)
    for turn in range(4):
        look()
        sear.spin(60)
        sear.simSleep(1.5)
    sear.spin(0)
    sear.simSleep(0.3)

file = open("map.txt", "w")
for line in evidence:
    file.write("".join("#" if value > 0 else "." if value < 0 else "?" for value in line) + "\n")
file.close()
