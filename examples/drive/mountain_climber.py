# Climbs to the summit above Jacksboro, Tennessee, with a GPS receiver on a serial port and a compass.
from math import atan2, cos, degrees, hypot, radians

SUMMIT = (36.485, -84.23083)
METRES = 111320     # per degree of latitude, about
DECLINATION = -5.6  # degrees, from maps of the area: magnetic north is west of true north
NEAR = 1.5          # metres
SPEED = 1.2         # m/s

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/mountain.sear")    # backs up the present project
sear.startSimulation()

gps = Runtime.start("mountainGps", "GPS")
gps.connect("/dev/SEAR_GPS_01")
sear.simSleep(3)

def wrapped(angle):
    """Wraps an angle to -180 to 180 degrees."""
    return (angle + 180) % 360 - 180

told = 0
while True:
    fix = gps.getLastFix()
    north = (SUMMIT[0] - fix.latitude) * METRES
    east = (SUMMIT[1] - fix.longitude) * METRES * cos(radians(SUMMIT[0]))
    if sear.getTime() >= told:
        print("After %.0f s: %.0f m high, %.0f m to go" % (sear.getTime(), fix.altitude, hypot(north, east)))
        told += 30
    if hypot(north, east) < NEAR:
        break
    heading = sear.getCompassResult("compass") + DECLINATION
    error = wrapped(degrees(atan2(east, north)) - heading)      # + to the right
    if abs(error) > 30:
        sear.spin(max(-40, min(40, -error)))
    else:
        sear.setWheelSpeeds(SPEED + 0.01 * error, SPEED - 0.01 * error)
    sear.simSleep(0.25)
    if sear.getTime() > 600:
        raise RuntimeError("the summit was not reached in 600 s")
sear.driveStraight(0)
sear.simSleep(2)
fix = gps.getLastFix()
print("On the summit after %.0f s: latitude %.6f, longitude %.6f, %.1f m above the sea" % (sear.getTime(), fix.latitude, fix.longitude, fix.altitude))
gps.disconnect()
