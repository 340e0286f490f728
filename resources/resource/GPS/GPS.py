# Prints the position whenever the receiver has sent one. The port is a real one, or the one that a simulated GPS was given with setPorts.
# With a simulation, start that first: choose the example "sensors" in SEAR's tab and press Start, or
#     sear = Runtime.start("sear", "SEAR"); sear.loadProject("resource/SEAR/sensors.sear"); sear.startSimulation()
def onGpsPosition(position):
    print "latitude %.6f, longitude %.6f, altitude %.1f m" % (position[0], position[1], position[2])

gps = Runtime.start("gps", "GPS")
gps.addListener("publishGPS", python.getName(), "onGpsPosition")
gps.connect("/dev/SEAR_GPS_01")        # at 38400 baud, as the receiver talks; onGpsPosition is called once a second
