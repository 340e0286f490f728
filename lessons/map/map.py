# Lesson: a map by LIDAR. Of the scanner's 181 beams the first looks right, the 91st ahead, the last left.
from math import cos, radians, sin

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()
sear.simSleep(1)

CELL = 0.1                          # metres
SIZE = 42                           # cells: from 2.1 m to -2.1 m
grid = [["?"] * SIZE for row in range(SIZE)]        # unknown

def mark(x, z, sign):
    """Writes a character at x metres north, z metres east."""
    row, column = int((2.1 - x) / CELL), int((z + 2.1) / CELL)
    if 0 <= row < SIZE and 0 <= column < SIZE:
        grid[row][column] = sign

x, y, z, rx, ry, rz = sear.getPose("lidar")
scan = sear.getLidarResult("lidar")
for i in range(len(scan)):
    angle = radians(ry + i - 90)    # heading of this beam
    mark(x + scan[i] * sin(angle), z + scan[i] * cos(angle), "#")

file = open("map.txt", "w")
file.write("\n".join("".join(row) for row in grid) + "\n")
file.close()
