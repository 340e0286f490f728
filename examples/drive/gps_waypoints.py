# Drives from waypoint to waypoint through the yard, with a GPS receiver on a serial port and a compass.
from math import atan2, cos, degrees, hypot, radians

WAYPOINTS = ((33.6100108, -80.8649838), (33.6100361, -80.8649806), (33.6099892, -80.8649914), (33.6100000, -80.8650000))
METRES = 111320     # per degree of latitude, about
NEAR = 0.35         # metres; the receiver's last digit is 0.2 m
SPEED = 0.3         # m/s

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/sensors.sear")    # backs up the present project
sear.startSimulation()

gps = Runtime.start("waypointGps", "GPS")
gps.connect("/dev/SEAR_GPS_01")
sear.simSleep(3)
gps.sendCommand("PMTK220,200")              # a fix every 200 ms
declination = -sear.getCompassResult("compass")    # the robot starts facing true north; the compass is magnetic

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
        heading = sear.getCompassResult("compass") + declination
        error = wrapped(degrees(atan2(east, north)) - heading)      # + to the right
        if abs(error) > 25:
            sear.spin(max(-60, min(60, -2 * error)))
        else:
            sear.setWheelSpeeds(SPEED + 0.003 * error, SPEED - 0.003 * error)
        sear.simSleep(0.2)
        if sear.getTime() > 200:
            raise RuntimeError("waypoint %d was not reached in 200 s" % (number + 1))
    pose = sear.getPose("myRoomba")
    print("Waypoint %d after %.0f s: latitude %.6f, longitude %.6f, x %.2f m, z %.2f m" % (number + 1, sear.getTime(), fix.latitude, fix.longitude,
        pose[0], pose[2]))
sear.driveStraight(0)
gps.disconnect()
