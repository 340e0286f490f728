# Listing 3 of the dissertation: drives the robot of Listings 1 and 2 forward for a second, then backward.
# Lines are as printed; each deviation has a comment "# SEAR:".
from time import sleep
from org.myrobotlab.service import Roomba

sear = Runtime.createAndStart("SEAR", "SEAR")
sear.startSimulation();           #start SEAR simulation

roomba = Runtime.create("robot_Dynamics1", "Roomba")
roomba.connect( "/dev/SEAR_Robot_01" )
roomba.startService()
line = Runtime.getService("serial")    # SEAR: added; MyRobotLab Nixie's Roomba closes its port and talks through the service named "serial"
if line is not None and not line.isConnected():    # SEAR: added, see above
    line.connect("/dev/SEAR_Robot_01", 57600, 8, 1, 0)    # SEAR: added, see above
roomba.startup()
roomba.control()
roomba.goForward()
roomba.sleep( 1000 )
print "after a second forward: %.2f m" % sear.getOdomResult()    # SEAR: added, to show that it drives
roomba.goBackward()
roomba.sleep(1000)    # SEAR: added; as printed the robot would never stop
roomba.stop()    # SEAR: added, see above
sleep(1)    # SEAR: added; the robot needs a moment to stop
print "after a second backward: %.2f m" % sear.getOdomResult()    # SEAR: added, to show that it drives
sear.stopSimulation()    # SEAR: added; the next script starts its own simulation
