# Lesson: odometry and its error. The encoders say how far the wheels have turned; from that you are to say where the robot is.
from math import cos, pi, sin

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()

COUNTS = 1000.0             # of an encoder for a turn of its wheel
RADIUS = 0.05               # metres, says the data sheet
TRACK = 0.2                 # metres between the wheels
WAY = ((6, 6, 5), (4, 7, 6), (6, 6, 5), (7, 5, 8), (0, 0, 1))     # rad/s of the left wheel, of the right one, seconds

x, z, heading = 0.0, 0.0, 90.0      # metres north, metres east, degrees from north to the east: where it is at the start

for left, right, seconds in WAY:
    sear.setMotorSpeed("leftMotor", left)
    sear.setMotorSpeed("rightMotor", right)
    for step in range(seconds * 20):
        sear.simSleep(0.05)
        # here: how far has each wheel come since the last time? sear.getEncoder("leftMotor")

print("I am at x %.3f, z %.3f, heading %.1f" % (x, z, heading))
