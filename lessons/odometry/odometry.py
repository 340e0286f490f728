# Lesson: odometry and its error. Compute the robot's pose from its wheel encoders.
from math import cos, pi, sin

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

COUNTS = 1000.0             # encoder counts per wheel turn
RADIUS = 0.05               # metres, from the data sheet
TRACK = 0.2                 # metres between the wheels
WAY = ((6, 6, 5), (4, 7, 6), (6, 6, 5), (7, 5, 8), (0, 0, 1))     # rad/s of the left and right wheel, seconds

x, z, heading = 0.0, 0.0, 90.0      # start pose: metres north, metres east, degrees clockwise from north

for left, right, seconds in WAY:
    sear.setMotorSpeed("leftMotor", left)
    sear.setMotorSpeed("rightMotor", right)
    for step in range(seconds * 20):
        sear.simSleep(0.05)
        # here: how far has each wheel turned since the last step? sear.getEncoder("leftMotor")

print("I am at x %.3f, z %.3f, heading %.1f" % (x, z, heading))
