# Drives across the office to a goal, around the obstacles that its LIDAR detects.
from math import atan2, cos, degrees, hypot, radians, sin

GOAL = (1.9, 1.8)   # metres north and east of the office's middle; a cone is in the way
ROOM = 0.27         # clearance that the robot needs on each side, metres
SPEED = 0.3         # m/s

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/office.sear")    # backs up the present project
sear.startSimulation()
sear.simSleep(1)

def wrapped(angle):
    """Wraps an angle to -180 to 180 degrees."""
    return (angle + 180) % 360 - 180

def clearance(points, direction):
    """Returns the free distance in a direction, metres. points: (left, ahead) of the LIDAR; direction: degrees, + to the left."""
    s, c = sin(radians(direction)), cos(radians(direction))
    free = 10.0
    for left, ahead in points:
        along = left * s + ahead * c
        if along > 0 and abs(left * c - ahead * s) < ROOM:
            free = min(free, along)
    return free

avoided = False
while sear.getTime() < 120:
    x, y, z, rx, ry, rz = sear.getPose("office Roomba")
    way = hypot(GOAL[0] - x, GOAL[1] - z)
    if way < 0.1:
        break
    scan = sear.getLidarResult("myLidar")       # right to left, one degree apart
    points = [(d * sin(radians(i - 90)), d * cos(radians(i - 90))) for i, d in enumerate(scan) if d < 3]
    wanted = wrapped(degrees(atan2(GOAL[0] - x, GOAL[1] - z)) - ry)
    needed = min(way, 1.0)
    choices = sorted(range(-85, 90, 5) + ([int(wanted)] if abs(wanted) < 90 else []), key=lambda a: abs(wrapped(a - wanted)))
    free = [a for a in choices if clearance(points, a) > needed]
    if not free:
        sear.spin(45 if wanted > 0 else -45)    # no free direction ahead: turn
    else:
        turn = free[0]
        avoided = avoided or abs(wrapped(turn - wanted)) > 5
        speed = SPEED * max(0, 1 - abs(turn) / 60.0) * min(1, way + 0.3)
        sear.setWheelSpeeds(speed - 0.004 * turn, speed + 0.004 * turn)
    sear.simSleep(0.1)
sear.driveStraight(0)
print("%.2f m from the goal after %.0f s%s." % (way, sear.getTime(), ", round an obstacle" if avoided else ""))
