# Listing 3 of the dissertation: drives the robot of Listings 1 and 2 forward for a second, then backward.
# Changed: today's Roomba service of MyRobotLab lets go of its port at once, so connectRoomba() makes up for that; sear.simSleep() instead of
# roomba.sleep(), so that the script runs at any speed; it stops after a second backward, prints how far it went, and ends the simulation.

def connectRoomba(roomba, port):
    """MyRobotLab's Roomba service lets go of its port at once and talks through the service named "serial": this connects that."""
    roomba.connect(port)
    line = Runtime.getService("serial")
    if line is not None and not line.isConnected():
        line.connect(port, 57600, 8, 1, 0)

sear = Runtime.start("SEAR", "SEAR")
sear.startSimulation()           # start SEAR simulation
sear.simSleep(1)                 # things fall into their natural place

roomba = Runtime.start("robot_Dynamics1", "Roomba")
connectRoomba(roomba, "/dev/SEAR_Robot_01")
roomba.startup()
roomba.control()
start = sear.getOdomResult()
roomba.goForward()
sear.simSleep(1)
print "after a second forward: %.2f m" % (sear.getOdomResult() - start)
roomba.goBackward()
sear.simSleep(1)
roomba.stop()
sear.simSleep(1)
print "after a second backward: %.2f m" % (sear.getOdomResult() - start)
sear.stopSimulation()
