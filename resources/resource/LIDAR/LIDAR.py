# Reads one scan of a SICK LMS200. The port is a real one, or that of a simulated LIDAR, set with setPorts. For a
# simulated LIDAR, start the simulation first: choose the example "sensors" in SEAR's tab and press Start, or
#     sear = Runtime.start("sear", "SEAR"); sear.loadProject("resource/SEAR/sensors.sear"); sear.startSimulation()
def onLidarScan(data):
    print "%d readings, the nearest at %d %s" % (len(data), min(data), lidar.getUnit())

lidar = Runtime.start("lidar", "LIDAR")
lidar.addListener("publishLidarData", python.getName(), "onLidarScan")
lidar.connect("/dev/SEAR_LIDAR_01")    # at 9600 baud, the scanner's rate after power-on
lidar.setScanMode(180, 1)              # degrees of the scan, degrees between two beams
lidar.singleScan()                     # onLidarScan is called about a second later, when the scan has arrived
