# Listing 8 of the dissertation: prints what the GPS of Listing 7 says.
# Changed: publishGGAData (the listing has publishGGADData, which no service ever had), with the fields as the callback's argument
# (msg_gpsUnit1_... is gone from MyRobotLab); the callback is onPositionText, since input is the LIDAR's in Listings 5 and 6, and MyRobotLab would hand
# it their data; sear.simSleep() instead of sleep(); it ends after five seconds, and the robot drives meanwhile, since without a window nobody can
# steer it by keys.
sear = Runtime.start("SEAR", "SEAR")
sear.startSimulation()    # start SEAR simulation
sear.simSleep(1)

gps1 = Runtime.start("gpsUnit1", "GPS")

def onPositionText(data):
    latitude = data[2]
    longitude = data[4]
    altitude = data[9]
    print "Lat: " + latitude
    print "Long: " + longitude
    print "Alt: " + altitude + "\n"

# have python listening to GPS
gps1.addListener("publishGGAData", python.getName(), "onPositionText")
gps1.connect("/dev/SEAR_GPS_01")

print "Ready to receive Data from GPS..."
sear.drive(0.2, float("inf"))
sear.simSleep(5)
sear.stopSimulation()
