# Gps: MyRobotLab's own service reads the receiver's sentences. It takes two digits of a longitude as degrees: 08051.9 is 8 degrees 51.9.
fixes = []
def onRoverFix(data):
    fixes.append((data.latitude, data.longitude))
gps = Runtime.start("mrlGps", "Gps")
gps.addListener("publishGPS", "python", "onRoverFix")
gps.connect("/dev/SEAR_GPS_01")
until("fixes", lambda: len(fixes) > 1)
latitude, longitude = sear.getGpsResult("fixes")[:2]
check("latitude", fixes[-1][0], latitude, 1e-5)
check("minutes of the longitude", fixes[-1][1] % 1, longitude % 1, 1e-5)
