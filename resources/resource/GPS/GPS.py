# Prints each position of the receiver. The port is a real one, or that of a simulated GPS, set with setPorts. For a
# simulated GPS, start the simulation first: choose the example "sensors" in SEAR's tab and press Start, or
#     sear = Runtime.start("sear", "SEAR"); sear.loadProject("resource/SEAR/sensors.sear"); sear.startSimulation()
def onGpsPosition(position):
    altitude = "unknown" if position[2] is None else "%.1f m" % position[2]     # RMC and GLL have none
    print "latitude %.6f, longitude %.6f, altitude %s" % (position[0], position[1], altitude)

gps = Runtime.start("gps", "GPS")
gps.addListener("publishGPS", python.getName(), "onGpsPosition")
gps.connect("/dev/SEAR_GPS_01")        # at 38400 baud, the receiver's rate; onGpsPosition is called once per second
