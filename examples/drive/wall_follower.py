# Follows the wall on its right once around a room: the right sensor measures the distance, the front one detects corners.
from math import hypot
from org.SEAR.POJOs import Box, Distance, Floor, Robots

WANTED = 0.3        # distance of the right sensor to the wall, metres
SPEED = 0.2         # m/s
HALF_TRACK = 0.129  # distance of a wheel from the robot's middle, metres

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.newProject()    # backs up the present project, if there is one

# ---- a room of 4 m by 5 m with a cupboard in a corner ---------------------------------------------------------------------------------------
Floor("floor", 6, 7, False)
for name, length, width, x, z in (("north wall", 0.1, 5.2, 2.05, 0), ("south wall", 0.1, 5.2, -2.05, 0), ("east wall", 4, 0.1, 0, 2.55),
                                  ("west wall", 4, 0.1, 0, -2.55), ("cupboard", 1.5, 1.5, 1.25, 1.75)):
    wall = Box(name, length, width, 0.4, 0, "textures/brick.png")
    wall.move(x, 0.2, z)

robot = Robots.create("follower", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
robot.move(-1.5, 0, -1)
robot.addComponent(Distance("frontEye", "GP2Y0A21", 0, 0.03, 0.16, 0, 0, 0))
robot.addComponent(Distance("rightEye", "GP2Y0A21", -0.16, 0.03, 0, 0, -90, 0))

# ---- once around ----------------------------------------------------------------------------------------------------------------------------
sear.startSimulation()
sear.simSleep(1)

def steer(speed, turn):
    """@param turn radians per second, + to the left"""
    sear.setWheelSpeeds(speed - turn * HALF_TRACK, speed + turn * HALF_TRACK)

start = sear.getPose("follower")
before = sear.getDistanceResult("rightEye")
nearest = before
away = False        # whether the robot has left its start
while True:
    right = sear.getDistanceResult("rightEye")
    nearest = min(nearest, right)
    if sear.getDistanceResult("frontEye") < 0.35:
        steer(0, 0.8)                                   # a corner: turn left in place
    elif right > 0.75:
        steer(SPEED, -SPEED / 0.45)                     # the wall has ended: turn around its corner
    else:
        turn = -6 * (right - WANTED) - 11 * (right - before) / 0.05
        steer(SPEED, max(-0.8, min(0.8, turn)))
    before = right
    sear.simSleep(0.05)
    pose = sear.getPose("follower")
    far = hypot(pose[0] - start[0], pose[2] - start[2])
    away = away or far > 1.5
    if away and far < 0.3:
        break
    if sear.getTime() > 300:
        raise RuntimeError("not once round in 300 s: at x %.2f, z %.2f" % (pose[0], pose[2]))
sear.driveStraight(0)
print("Once round: %.1f m in %.0f s, the wall never nearer than %.2f m to the eye." % (sear.getOdomResult(), sear.getTime(), nearest))
