# Follows a loop of black tape once: three line sensors measure the lateral offset, and the motors steer towards the line.
from math import atan2, degrees

SPEED = 8           # rad/s of the wheels: 0.2 m/s
TURN = 300          # rad/s of the wheels per metre of offset
SENSORS = (("leftLine", 0.015), ("middleLine", 0), ("rightLine", -0.015))     # metres to the left

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/line.sear")    # backs up the present project
sear.startSimulation()
sear.simSleep(1)

def wrapped(angle):
    """Wraps an angle to -180 to 180 degrees."""
    return (angle + 180) % 360 - 180

def direction():
    """Returns the robot's direction from the track's middle, degrees."""
    pose = sear.getPose("follower")
    return degrees(atan2(pose[2], pose[0]))

off = 0.0           # offset of the line to the left, metres
lost = 0            # number of times without the line
turned = 0.0        # degrees around the middle
before = direction()
while abs(turned) < 360:
    dark = [(100 - sear.getReading(name), x) for name, x in SENSORS]
    light = sum(value for value, x in dark)
    if light > 40:
        off = sum(value * x for value, x in dark) / light
    else:
        lost += 1   # keep the last offset, which has the line's side
    sear.setMotorSpeed("leftMotor", SPEED - TURN * off)
    sear.setMotorSpeed("rightMotor", SPEED + TURN * off)
    sear.simSleep(0.03)
    now = direction()
    turned += wrapped(now - before)
    before = now
    if sear.getTime() > 200:
        raise RuntimeError("not once round in 200 s: %.0f degrees" % turned)
sear.setMotorSpeed("leftMotor", 0)
sear.setMotorSpeed("rightMotor", 0)
sear.simSleep(0.5)
print("Once round in %.1f s: %.2f m, the line lost %d times." % (sear.getTime(), sear.getOdomResult(), lost))
