# Listing 6 of the dissertation: reads the raw LIDAR data and prints them as Cartesian coordinates: x to the right, y ahead,
# the LIDAR at (0, 0). Lines are as printed; each deviation has a comment "# SEAR:". The indentation is corrected, too: the
# print has the conversion outside its loop. The callback keeps its name input, as in Listing 5: both listen to the same
# service, so each may follow the other in one session. Give your callback another name (docs/embedded-and-real.md).
from time import sleep
import java.lang.String    # SEAR: printed "Java"; the package is java
import math
# This script only uses the LIDAR sensor on the simulated robot, the user is expected to drive the robot using the i,j,k,l,and ; keys

def input(data):    # SEAR: printed "input()"; MyRobotLab passes the value as argument
    startingAngle = 0
    code = data    # SEAR: printed "msg_myLidar_publishLidarData.data[0]", a variable that MyRobotLab does not set
    length = len(code)
    print "received " + str(length) + "readings:"
    if length==101 or length==201 or length==401:
        startingAngle = 40
    else:
        startingAngle = 0

    for i in range(0, length):
        # print hex(code[i])          #print result in hexadecimal
        # print (code[i])            #print results (without units)
        # print (code[i]/float(100))  #Print results in centimeters (if LIDAR was in CM mode)

        # print ((code[i]/100)/2.54)  #Print results in inches (if LIDAR was in CM mode)

        # print str(i)+"\t"+str((code[i])) #print polar Coordinates (without units)
        if code[i] >= 8183:    # SEAR: added; such a reading is a code for "nothing hit"
            continue    # SEAR: added, see above
        #convert polar to Cartesian
        x = (code[i])*math.cos(((i*100.0/(length-1))+startingAngle)*(3.14159 / 180))    # SEAR: printed "i*100/length", which drops the fractions
        y =(code[i])*math.sin(((i*100.0/(length-1))+startingAngle)*(3.14159 / 180))    # SEAR: the same
        print str(x) +"\t"+str(y)

# create and start the SEAR simulator instance
sear = Runtime.createAndStart("SEAR","SEAR")
sear.startSimulation(); #start SEAR simulation
sleep (2); # Give some time for things to fall into their natural place.

print "Attempting to create the LIDAR service..."

#These lines are initialization of the LIDAR
lidar = Runtime.createAndStart("myLidar", "LIDAR")
lidar.startService()
print "connect LIDAR service to /dev/SEAR_LIDAR_01"
lidar.connect("/dev/SEAR_LIDAR_01")

#have python listening to lidar
print "adding the LIDAR service listener"
lidar.addListener("publishLidarData", python.name, "input")

# sets scan mode for 100 degree spread with a reading every 1 degree
print "setting scan mode"
lidar.setScanMode(100, 1)

print "Ready to receive LIDAR data... "
for scan in range(2):    # SEAR: printed "while 1: # infinite loop", which never ends
    lidar.singleScan() #get a single scan
    sleep(2)         #wait two seconds and repeat
sear.stopSimulation()    # SEAR: added; the next script starts its own simulation
