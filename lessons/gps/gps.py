# Lesson: GPS waypoints. The receiver gives latitude (degrees north) and longitude (degrees east), the compass 0 for north, 90 for east.
from math import atan2, cos, degrees, hypot, radians

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.startSimulation()
sear.simSleep(1)

WAYPOINTS = ((52.0000180, 13.0000437), (51.9999730, 13.0000437), (51.9999730, 12.9999709))
METRES = 111320             # per degree of latitude, roughly; per degree of longitude times cos(latitude)

for latitude, longitude in WAYPOINTS:
    now = sear.getGpsResult("gps")
    north = (latitude - now[0]) * METRES
    east = (longitude - now[1]) * METRES * cos(radians(latitude))
    print("%.1f m to the north, %.1f m to the east; I look to %.0f degrees" % (north, east, sear.getCompassResult("compass")))
