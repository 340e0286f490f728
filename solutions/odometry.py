# Solution: odometry and its error. The left wheel's radius was found by driving straight: at equal speeds the robot
# drifts left.
from math import cos, pi, radians, sin

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

COUNTS = 1000.0
LEFT_RADIUS, RIGHT_RADIUS = 0.048, 0.05
TRACK = 0.2
WAY = ((6, 6, 5), (4, 7, 6), (6, 6, 5), (7, 5, 8), (0, 0, 1))

x, z, heading = 0.0, 0.0, 90.0
before = (0, 0)
for left, right, seconds in WAY:
    sear.setMotorSpeed("leftMotor", left)
    sear.setMotorSpeed("rightMotor", right)
    for step in range(seconds * 20):
        sear.simSleep(0.05)
        now = (sear.getEncoder("leftMotor"), sear.getEncoder("rightMotor"))
        leftWay = (now[0] - before[0]) / COUNTS * 2 * pi * LEFT_RADIUS
        rightWay = (now[1] - before[1]) / COUNTS * 2 * pi * RIGHT_RADIUS
        before = now
        turned = (leftWay - rightWay) / TRACK * 180 / pi        # to the right
        along = radians(heading + turned / 2)
        x += (leftWay + rightWay) / 2 * cos(along)
        z += (leftWay + rightWay) / 2 * sin(along)
        heading += turned

print("I am at x %.3f, z %.3f, heading %.1f" % (x, z, heading))
