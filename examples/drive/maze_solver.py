# Solves the maze by the right-hand rule: three infrared sensors detect walls, and the robot turns as far right as possible at each crossing.
from math import atan2, degrees, hypot

CELL = 0.8          # metres
OPEN = 0.4          # metres: a longer reading means an opening; a wall of the cell reads 0.21 m
SPEED = 0.25        # m/s

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/maze.sear")    # backs up the present project
sear.startSimulation()
sear.simSleep(1)

def wrapped(angle):
    """Wraps an angle to -180 to 180 degrees."""
    return (angle + 180) % 360 - 180

def goalDistance():
    robot = sear.getPose("maze Roomba")
    goal = sear.getPose("goal")
    return hypot(goal[0] - robot[0], goal[2] - robot[2])

def turnTo(ry):
    """Turns in place to a rotation ry, to half a degree."""
    error = wrapped(ry - sear.getPose("maze Roomba")[4])
    while abs(error) > 0.5:
        sear.spin(max(-120, min(120, 5 * error)))
        sear.simSleep(0.05)
        error = wrapped(ry - sear.getPose("maze Roomba")[4])
    sear.spin(0)

def driveTo(x, z):
    """Drives to a place ahead, metres north and east, or until the goal is near."""
    while goalDistance() > 0.75 * CELL:
        pose = sear.getPose("maze Roomba")
        north, east = x - pose[0], z - pose[2]
        way = hypot(north, east)
        if way < 0.02:
            break
        steer = 0.004 * wrapped(degrees(atan2(north, east)) - pose[4])    # m/s between middle and wheel per degree to the left
        speed = min(SPEED, 2 * way)
        if way < 0.1:
            steer = 0
        sear.setWheelSpeeds(speed - steer, speed + steer)
        sear.simSleep(0.05)
        if way < 0.1 and speed * 0.05 >= way:
            break
    sear.driveStraight(0)

x, y, z, rx, ry, rz = sear.getPose("maze Roomba")
ry = 90 * round(ry / 90)
cells = 0
while goalDistance() > 0.75 * CELL and cells < 100:
    if sear.getDistanceResult("rightEye") > OPEN:
        ry -= 90
    elif sear.getDistanceResult("frontEye") > OPEN:
        pass
    elif sear.getDistanceResult("leftEye") > OPEN:
        ry += 90
    else:
        ry += 180
    turnTo(ry)
    north = {0: 0, 90: 1, 180: 0, -90: -1, -180: 0}[int(wrapped(ry))]
    east = {0: 1, 90: 0, 180: -1, -90: 0, -180: -1}[int(wrapped(ry))]
    x += CELL * north
    z += CELL * east
    driveTo(x, z)
    cells += 1
print("The cone is %.2f m away, after %d cells and %.0f s." % (goalDistance(), cells, sear.getTime()))
