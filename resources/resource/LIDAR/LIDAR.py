# Reads one scan of a SICK LMS200. The port is a real one, or the one that a simulated LIDAR was given with setPorts.
# With a simulation, start that first: choose the example "sensors" in SEAR's tab and press Start, or
#     sear = Runtime.start("sear", "SEAR"); sear.loadProject("resource/SEAR/sensors.sear"); sear.startSimulation()
def onLidarScan(data):
    print "%d readings, the nearest at %d %s" % (len(data), min(data), lidar.getUnit())

lidar = Runtime.start("lidar", "LIDAR")
lidar.addListener("publishLidarData", python.getName(), "onLidarScan")
lidar.connect("/dev/SEAR_LIDAR_01")    # at 9600 baud, as the scanner talks after power-on
lidar.setScanMode(180, 1)              # degrees of the fan, degrees between two beams
lidar.singleScan()                     # onLidarScan is called when the scan has arrived, about a second later
