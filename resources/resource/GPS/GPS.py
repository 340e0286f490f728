# Prints each position of the receiver. The port is a real one, or that of a simulated GPS, set with setPorts. For a
# simulated GPS, start the simulation first: choose the example "sensors" in SEAR's tab and press Start, or
#     sear = Runtime.start("sear", "SEAR"); sear.loadProject("resource/SEAR/sensors.sear"); sear.startSimulation()
def onGpsPosition(position):
    print "latitude %.6f, longitude %.6f, altitude %.1f m" % (position[0], position[1], position[2])

gps = Runtime.start("gps", "GPS")
gps.addListener("publishGPS", python.getName(), "onGpsPosition")
gps.connect("/dev/SEAR_GPS_01")        # at 38400 baud, the receiver's rate; onGpsPosition is called once per second
