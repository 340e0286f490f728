# Listing 5 of the dissertation: starts a LIDAR service on the robot of Listing 4 and scans.
# Changed: the callback that the listing names but does not show is there, and takes the data as its argument; three scans instead of an endless
# loop; sear.simSleep() instead of sleep(), so that the script runs at any speed. The callback keeps its name input, which Listing 6 shares: both
# listen to the same service, so each may run after the other in one session. Call yours otherwise (docs/embedded-and-real.md).
sear = Runtime.start("SEAR", "SEAR")
sear.startSimulation()    # start SEAR simulation
sear.simSleep(2)          # give some time for things to fall into their natural place

def input(data):
    print "received " + str(len(data)) + " readings, the nearest at " + str(min(data))

# these lines are initialization of the LIDAR
lidar = Runtime.start("myLidar", "LIDAR")    # creates LIDAR service named "myLidar"
print "connect LIDAR service to /dev/SEAR_LIDAR_01"
lidar.connect("/dev/SEAR_LIDAR_01")
# have python listening to lidar
print "adding the LIDAR service listener"
lidar.addListener("publishLidarData", python.getName(), "input")
# set scan mode for 100 degree spread with a reading every 1 degree
print "setting scan mode"
lidar.setScanMode(100, 1)

print "Ready to receive LIDAR data..."
for scan in range(3):
    lidar.singleScan()    # get a single scan
    sear.simSleep(2)      # wait two seconds and repeat
sear.stopSimulation()
