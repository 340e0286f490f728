# Follows a line of black tape once round: three line sensors tell how far it is to the left or right, and the motors turn towards it.
from math import atan2, degrees

SPEED = 8           # rad/s of the wheels: 0.2 m/s
TURN = 300          # rad/s of the wheels for each metre that the line is off
SENSORS = (("leftLine", 0.015), ("middleLine", 0), ("rightLine", -0.015))     # metres to the left

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/line.sear")    # the present project is kept as a backup
sear.startSimulation()
sear.simSleep(1)

def wrapped(angle):
    """Brings degrees into -180 to 180."""
    return (angle + 180) % 360 - 180

def direction():
    """Degrees around the middle of the track."""
    pose = sear.getPose("follower")
    return degrees(atan2(pose[2], pose[0]))

off = 0.0           # metres that the line is to the left
lost = 0            # times that no sensor saw it
turned = 0.0        # degrees around the middle
before = direction()
while abs(turned) < 360:
    dark = [(100 - sear.getReading(name), x) for name, x in SENSORS]
    light = sum(value for value, x in dark)
    if light > 40:
        off = sum(value * x for value, x in dark) / light
    else:
        lost += 1   # it was seen last on the side that off tells
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
