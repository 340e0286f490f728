# Drives a car through five gates with a GPS receiver on a serial port and a compass: the motor holds a speed, a servo steers.
from math import atan2, cos, degrees, hypot, radians

WAYPOINTS = ((33.6100541, -80.8650000), (33.6100902, -80.8649461), (33.6100361, -80.8649030), (33.6099730, -80.8649461), (33.6099910, -80.8650431))
METRES = 111320     # per degree of latitude, about
NEAR = 0.6          # metres; the receiver's last digit is 0.2 m
SPEED = 24          # rad/s of the wheels: 1.2 m/s

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/car.sear")    # backs up the present project
sear.startSimulation()

gps = Runtime.start("carGps", "GPS")
gps.connect("/dev/SEAR_GPS_01")
sear.simSleep(3)
gps.sendCommand("PMTK220,200")              # a fix every 200 ms

def wrapped(angle):
    """Wraps an angle to -180 to 180 degrees."""
    return (angle + 180) % 360 - 180

for number, (latitude, longitude) in enumerate(WAYPOINTS):
    while True:
        fix = gps.getLastFix()
        north = (latitude - fix.latitude) * METRES
        east = (longitude - fix.longitude) * METRES * cos(radians(latitude))
        if hypot(north, east) < NEAR:
            break
        error = wrapped(degrees(atan2(east, north)) - sear.getCompassResult("compass"))     # + to the right
        sear.setServo("steering", max(-30, min(30, -error)))
        sear.setMotorSpeed("engine", SPEED if abs(error) < 30 else SPEED / 2)
        sear.simSleep(0.1)
        if sear.getTime() > 200:
            raise RuntimeError("waypoint %d was not reached in 200 s" % (number + 1))
    pose = sear.getPose("car")
    print("Waypoint %d after %.0f s: latitude %.6f, longitude %.6f, x %.2f m, z %.2f m" % (number + 1, sear.getTime(), fix.latitude, fix.longitude,
        pose[0], pose[2]))
sear.setMotorSpeed("engine", 0)
sear.setServo("steering", 0)
sear.simSleep(1)
gps.disconnect()
pose = sear.getPose("car")
print("In the last gate after %.0f s: x %.2f m, z %.2f m" % (sear.getTime(), pose[0], pose[2]))
