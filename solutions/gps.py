# Solution: waypoints with GPS. Turn towards the waypoint, and correct continuously.
from math import atan2, cos, degrees, hypot, radians

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()
sear.simSleep(1)

WAYPOINTS = ((52.0000180, 13.0000437), (51.9999730, 13.0000437), (51.9999730, 12.9999709))
METRES = 111320

def wrapped(angle):
    return (angle + 180) % 360 - 180

for latitude, longitude in WAYPOINTS:
    while True:
        now = sear.getGpsResult("gps")
        north = (latitude - now[0]) * METRES
        east = (longitude - now[1]) * METRES * cos(radians(latitude))
        if hypot(north, east) < 0.1:
            break
        error = wrapped(degrees(atan2(east, north)) - sear.getCompassResult("compass"))     # + to the right
        if abs(error) > 20:
            sear.spin(max(-60, min(60, -2 * error)))
        else:
            sear.setWheelSpeeds(0.3 + 0.003 * error, 0.3 - 0.003 * error)
        sear.simSleep(0.1)
    print("There: %.7f, %.7f" % (latitude, longitude))
sear.driveStraight(0)
sear.simSleep(1)
