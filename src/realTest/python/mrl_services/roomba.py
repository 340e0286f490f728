# Roomba: drives by its protocol, through the service "serial" as in docs/embedded-and-real.md.
sear.stopSimulation()
sear.loadProject(ROOT + "/examples/office.sear")
sear.startSimulation()
roomba = Runtime.start("roomba", "Roomba")
roomba.connect("/dev/SEAR_Robot_01")
line = Runtime.getService("serial")
if not line.isConnected(): line.connect("/dev/SEAR_Robot_01", 57600, 8, 1, 0)
roomba.startup()
roomba.control()

def path():
    return sum((now - then) ** 2 for now, then in zip(sear.getPose("office Roomba")[:3], start)) ** 0.5

start = sear.getPose("office Roomba")[:3]
roomba.goForward()
until("it drives", lambda: path() > 0.1)
roomba.stop()
heading = sear.getPose("office Roomba")[4]
roomba.spinLeft()
until("it turns to the left", lambda: 20 < (sear.getPose("office Roomba")[4] - heading) % 360 < 180)
roomba.stop()
