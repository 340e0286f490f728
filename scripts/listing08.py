# Listing 8 of the dissertation: prints the data of the GPS of Listing 7.
# Lines are as printed; each deviation has a comment "# SEAR:".
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
    Latitude = data[2]    # SEAR: printed "msg_gpsUnit1_publishGGADData.data[0][2]", a variable that MyRobotLab does not set
    Longitude = data[4]    # SEAR: the same
    altitude = data[9]    # SEAR: the same
    print "Lat: " + Latitude
    print "Long: " + Longitude
    print "Alt: " + altitude + "\n"

#have python listening to GPS
gps1.addListener("publishGGADData", python.name, "onPositionText")    # SEAR: printed "input", see above

print "Ready to receive Data from GPS..."
sear.drive(0.2, float("inf"))    # SEAR: added, instead of the user who drives with keys
sleep(5)    # SEAR: added, see above
sear.stopSimulation()    # SEAR: added; the next script starts its own simulation
