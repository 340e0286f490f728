# Drives through the office and draws an occupancy grid from LIDAR scans: free cells white, occupied black, unseen grey; saved as map.png and as a ROS map, map.yaml with map.pgm.
from java.awt.image import BufferedImage
from java.io import File
from javax.imageio import ImageIO
from math import atan2, cos, degrees, hypot, radians, sin

CELL = 0.05                         # metres
NORTH, EAST = 4.5, 3.5              # metres from the middle to the edge of the map
ROWS, COLUMNS = int(2 * NORTH / CELL), int(2 * EAST / CELL)
STOPS = ((-2, -1), (1.8, -1), (1.8, 0.4), (-2.4, -0.6))     # metres north and east: places where it turns and scans
RANGE = 8.191                       # metres; reading of a beam without a hit

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/office.sear")    # backs up the present project
sear.startSimulation()
sear.simSleep(1)

evidence = [[0] * COLUMNS for row in range(ROWS)]   # above 0: occupied, below: free

def wrapped(angle):
    """Wraps an angle to -180 to 180 degrees."""
    return (angle + 180) % 360 - 180

def mark(x, z, amount):
    row, column = int((NORTH - x) / CELL), int((z + EAST) / CELL)
    if 0 <= row < ROWS and 0 <= column < COLUMNS:
        evidence[row][column] = max(-20, min(20, evidence[row][column] + amount))

def look():
    """Enters one scan: the cells along a beam are free, the cell at its end is occupied."""
    x, y, z, rx, ry, rz = sear.getPose("myLidar")
    scan = sear.getLidarResult("myLidar")
    for i in range(0, len(scan), 2):
        angle = radians(ry + i - 90)        # the first beam is the rightmost
        north, east = sin(angle), cos(angle)
        steps = int(scan[i] / CELL)
        for step in range(steps):
            mark(x + step * CELL * north, z + step * CELL * east, -1)
        if scan[i] < RANGE - 0.01:
            mark(x + (scan[i] + 0.01) * north, z + (scan[i] + 0.01) * east, 4)

def driveTo(x, z):
    while True:
        pose = sear.getPose("office Roomba")
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

scans = 0
for stop in STOPS:
    driveTo(stop[0], stop[1])
    sear.simSleep(0.3)
    for turn in range(8):
        look()
        scans += 1
        sear.spin(60)
        sear.simSleep(0.75)
    sear.spin(0)
    sear.simSleep(0.3)

picture = BufferedImage(COLUMNS, ROWS, BufferedImage.TYPE_INT_RGB)
for row in range(ROWS):
    for column in range(COLUMNS):
        value = evidence[row][column]
        picture.setRGB(column, row, 0x000000 if value > 0 else 0xffffff if value < 0 else 0xa0a0a0)
ImageIO.write(picture, "png", File("map.png"))
with open("map.pgm", "wb") as out:      # black 0 occupied, white 254 free, 205 unknown, as ROS's map_saver writes it
    out.write("P5 %d %d 255\n" % (COLUMNS, ROWS))
    out.write("".join(chr(0 if value > 0 else 254 if value < 0 else 205) for line in evidence for value in line))
with open("map.yaml", "w") as out:
    out.write("image: map.pgm\nresolution: %s\norigin: [%s, %s, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n"
        % (CELL, -EAST, -NORTH))            # of the lower left corner: metres east and north
occupied = sum(1 for line in evidence for value in line if value > 0)
free = sum(1 for line in evidence for value in line if value < 0)
print("%d scans: %.1f square metres are free, %d cells occupied; north is up in map.png" % (scans, free * CELL * CELL, occupied))
