# Roomba: drives by its protocol, as docs/embedded-and-real.md says.
roomba = Runtime.start("roomba", "Roomba")
line = Runtime.start("serial", "Serial")
roomba.connect("/dev/SEAR_Robot_01")
if not line.isConnected(): line.connect("/dev/SEAR_Robot_01", 115200, 8, 1, 0)
roomba.startup()
roomba.control()
start = sear.getPose("rover")[2]
roomba.goForward()
until("it drives", lambda: sear.getPose("rover")[2] > start + 0.1)
roomba.stop()
