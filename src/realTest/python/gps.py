# Gps: the receiver's sentences, read by MyRobotLab's own service.
fixes = []
def onRoverFix(data):
    fixes.append((data.latitude, data.longitude))
gps = Runtime.start("mrlGps", "Gps")
gps.addListener("publishGPS", "python", "onRoverFix")
gps.connect("/dev/SEAR_GPS_01")
until("fixes", lambda: len(fixes) > 1)
print fixes, sear.getGpsResult("fixes")
