# Reads one scan of a SICK LMS200. The port is a real one, or the one that a simulated LIDAR was given with setPorts.
# With a simulation, start that first: sear = Runtime.start("sear", "SEAR"), sear.startSimulation().
def onScan(data):
    print "%d readings, the nearest at %d" % (len(data), min(data))

lidar = Runtime.start("lidar", "LIDAR")
lidar.addListener("publishLidarData", python.getName(), "onScan")
lidar.connect("/dev/SEAR_LIDAR_01", 38400)
lidar.setScanMode(180, 1)    # degrees of the fan, degrees between two beams
lidar.singleScan()
