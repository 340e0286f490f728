# Listing 6 of the dissertation: reads the raw LIDAR data and prints them as Cartesian coordinates, the LIDAR being at (0, 0).
# Changed: the callback takes the data as its argument (msg_myLidar_publishLidarData is gone from MyRobotLab); the angle of each reading comes from
# the fan's true resolution (i * 100 / length bent the fan); 8183 and above, which is "nothing hit", is left out; two scans instead of an endless
# loop; the robot turns around first, since nobody steers it by keys; sear.simSleep() instead of sleep(). The callback keeps its name input, which
# Listing 5 shares: both listen to the same service, so each may run after the other in one session. Call yours otherwise (docs/embedded-and-real.md).
import math

def input(data):
    length = len(data)
    print "received " + str(length) + " readings:"
    if length == 101 or length == 201 or length == 401:
        startingAngle = 40
        spread = 100.0
    else:
        startingAngle = 0
        spread = 180.0

    for i in range(0, length):
        # print hex(data[i])                      # print result in hexadecimal
        # print data[i]                           # print results (without units)
        # print data[i] / 100.0                   # print results in metres (if LIDAR was in CM mode)
        # print str(i) + "\t" + str(data[i])      # print polar coordinates (without units)
        if data[i] < 8183:
            angle = math.radians(startingAngle + i * spread / (length - 1))    # convert polar to Cartesian
            x = data[i] * math.cos(angle)
            y = data[i] * math.sin(angle)
            print "%.0f\t%.0f" % (x, y)

# create and start the SEAR simulator instance
sear = Runtime.start("SEAR", "SEAR")
sear.startSimulation()    # start SEAR simulation
sear.simSleep(2)          # give some time for things to fall into their natural place
sear.drive(-0.2, 0)       # turn to the right, to where the objects of Listing 1 are
sear.simSleep(1.9)
sear.drive(0, 0)

print "Attempting to create the LIDAR service..."
# these lines are initialization of the LIDAR
lidar = Runtime.start("myLidar", "LIDAR")
print "connect LIDAR service to /dev/SEAR_LIDAR_01"
lidar.connect("/dev/SEAR_LIDAR_01")

# have python listening to lidar
print "adding the LIDAR service listener"
lidar.addListener("publishLidarData", python.getName(), "input")

# sets scan mode for 100 degree spread with a reading every 1 degree
print "setting scan mode"
lidar.setScanMode(100, 1)

print "Ready to receive LIDAR data..."
for scan in range(2):
    lidar.singleScan()    # get a single scan
    sear.simSleep(2)      # wait two seconds and repeat
sear.stopSimulation()
