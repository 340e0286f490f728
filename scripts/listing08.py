# Listing 8 of the dissertation: prints what the GPS of Listing 7 says.
# Lines are as printed; each that isn't says so behind "# SEAR:".
from time import sleep

# This script only uses the GPS sensor on the simulated robot, the user is expected to drive the robot using the i,j,k,l, and ; keys

sear = Runtime.createAndStart("SEAR", "SEAR")
sear.startSimulation(); #start SEAR simulation
initialized = 0

gps1 = Runtime.createAndStart("gpsUnit1", "GPS")
gps1.startService()
gps1.connect("/dev/SEAR_GPS_01")
sleep(1)
def onPositionText(data):    # SEAR: printed "input()"; the value is the argument, and in MyRobotLab a callback's name belongs to its first publisher
    startingAngle = 0
    Latitude = data[2]    # SEAR: printed "msg_gpsUnit1_publishGGADData.data[0][2]", a variable that MyRobotLab no longer sets
    Longitude = data[4]    # SEAR: the same
    altitude = data[9]    # SEAR: the same
    print "Lat: " + Latitude
    print "Long: " + Longitude
    print "Alt: " + altitude + "\n"

#have python listening to GPS
gps1.addListener("publishGGADData", python.name, "onPositionText")    # SEAR: printed "input", see above

print "Ready to receive Data from GPS..."
sear.drive(0.2, float("inf"))    # SEAR: added, in place of the user who drives by keys
sleep(5)    # SEAR: added, see above
sear.stopSimulation()    # SEAR: added; the next script starts a simulation of its own
