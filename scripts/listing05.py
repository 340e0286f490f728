# Listing 5 of the dissertation: starts a LIDAR service on the robot of Listing 4 and scans. The tree of Listing 1 is 3 m
# ahead. Lines are as printed; each deviation has a comment "# SEAR:". The callback keeps its name input, as in Listing 6:
# both listen to the same service, so each may follow the other in one session. Give your callback another name
# (docs/embedded-and-real.md).
from time import sleep
sear = Runtime.createAndStart("SEAR", "SEAR")
sear.startSimulation(); #start SEAR simulation
sleep (2); # Give some time for things to fall into their natural place.

def input(data):    # SEAR: added; the text mentions this callback, only Listing 6 has it
    print "received " + str(len(data)) + " readings, the nearest at " + str(min(data))    # SEAR: added

#These lines are initialization of the LIDAR
lidar = Runtime.createAndStart("myLidar", "LIDAR") # creates LIDAR service named "myLidar"
lidar.startService()
print "connect LIDAR service to /dev/SEAR_LIDAR_01"
lidar.connect("/dev/SEAR_LIDAR_01")
#have python listening to lidar
print "adding the LIDAR service listener"
lidar.addListener("publishLidarData", python.name, "input")
# set scan mode for 100 degree spread with a reading every 1 degree
print "setting scan mode"
lidar.setScanMode(100, 1)

print "Ready to receive LIDAR data... "
for scan in range(3):    # SEAR: printed "while 1: # infinite loop", which never ends
    lidar.singleScan() #get a single scan
    sleep(2) #wait two seconds and repeat
sear.stopSimulation()    # SEAR: added; the next script starts its own simulation
