# The demo: builds a small world and a Roomba with LIDAR, sonar, GPS and compass, drives it over the Roomba protocol, scans
# over the SICK LMS200 protocol, and prints the readings. Run it with "./gradlew run" or "sear scripts/demo.py".
from java.lang import System
from org.SEAR.POJOs import Box, Compass, Cone, Cylinder, Distance, Floor, GPS, LIDAR, Robots

sear = Runtime.start("SEAR", "SEAR")
kept = sear.newProject()
if kept is not None:
    print "Your project is stored in " + kept

print "The demo drives for a quarter of a minute. A page that is open by then stays as long as you look at it."

# ---- the world: a room of 6 m by 6 m with a few objects ---------------------------------------------------------------------------------------
Floor("floor", 20, 20, False)
for (name, x, z, length, width) in (("northWall", 3, 0, 0.1, 6), ("southWall", -3, 0, 0.1, 6), ("eastWall", 0, 3, 6, 0.1), ("westWall", 0, -3, 6, 0.1)):
    wall = Box(name, length, width, 1, 0)
    wall.setImage("textures/brick.png")
    wall.move(x, 0.5, z)
crate = Box("crate", 0.4, 0.4, 0.4, 0)
crate.move(1.5, 0.2, 1.2)
crate.rotate(0, 30, 0)
bin = Cylinder("bin", 0.2, 0.6, 5)
bin.move(-1, 0.3, 1.8)
cone = Cone("cone", 0.2, 0.5, 1)
cone.move(1, 0.25, -1.5)

# ---- the robot ------------------------------------------------------------------------------------------------------------------------------
robot = Robots.create("demoRoomba", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
scanner = LIDAR("demoLidar")
scanner.setRange(8.191)
scanner.setSpread(180)
scanner.setResolution(1)
scanner.setPorts("/dev/my_Lidar01", "/dev/SEAR_LIDAR_01")
scanner.setBaud(38400)
scanner.move(0, 0.15, 0.1)
scanner.LMS(1)
robot.addComponent(scanner)
ping = Distance("demoPing", "PING)))")
ping.move(0, 0.1, 0.15)
robot.addComponent(ping)
robot.addComponent(Compass("demoCompass"))
receiver = GPS("demoGps", 33.61, 182.5, -80.865)
receiver.setPorts("/dev/my_GPS_01", "/dev/SEAR_GPS_01")
robot.addComponent(receiver)

# ---- the services, which work with real hardware, too ---------------------------------------------------------------------------------------
def connectRoomba(roomba, port):
    """MyRobotLab's Roomba service closes its port immediately and talks through the service named "serial": this
    connects that service."""
    roomba.connect(port)
    line = Runtime.getService("serial")
    if line is not None and not line.isConnected():
        line.connect(port, 57600, 8, 1, 0)

def onDemoScan(data):
    near = min(data)
    angle = data.index(near) - 90
    side = "ahead" if angle == 0 else ("%d degrees to the %s" % (abs(angle), "left" if angle > 0 else "right"))
    hits = len([value for value in data if value < 8183])
    print "   LIDAR: %d beams, %d of them hit something; nearest %.2f m, %s" % (len(data), hits, near / 1000.0, side)

position = []

def onDemoPosition(data):
    position[:] = data

sear.startSimulation()
sear.simSleep(1)
print "The simulation runs with the sensors " + ", ".join(sear.getSensorNames()) + "."

lidar = Runtime.start("demoLidarService", "LIDAR")
lidar.connect("/dev/SEAR_LIDAR_01", 38400)
lidar.addListener("publishLidarData", python.getName(), "onDemoScan")
gps = Runtime.start("demoGpsService", "GPS")
gps.connect("/dev/SEAR_GPS_01")
gps.addListener("publishGGAData", python.getName(), "onDemoPosition")
roomba = Runtime.start("demoRoombaService", "Roomba")
connectRoomba(roomba, "/dev/SEAR_Robot_01")
roomba.startup()
roomba.control()

def report(what):
    pose = sear.getPose("demoRoomba")
    print "%s" % what
    print "   at %.1f s: x %.2f m, z %.2f m, heading %.0f degrees, driven %.2f m, sonar %.2f m" % (sear.getTime(), pose[0], pose[2],
        sear.getCompassResult("demoCompass"), sear.getOdomResult(), sear.getDistanceResult("demoPing"))
    if position:
        print "   GPS: latitude %s, longitude %s, altitude %s m" % (position[2], position[4], position[9])
    lidar.singleScan()
    sear.simSleep(1)

report("Standing still")
for (what, command, seconds) in (("Forward", roomba.goForward, 3), ("Turning left", roomba.spinLeft, 1.2), ("Forward", roomba.goForward, 3),
                                 ("Turning right", roomba.spinRight, 1.2), ("Backward", roomba.goBackward, 2)):
    command()
    sear.simSleep(seconds)
    roomba.stop()
    sear.simSleep(0.5)
    report(what + " for " + str(seconds) + " s")

# With --keep the simulation continues until Ctrl+C. Otherwise it continues while a browser shows it, and at a terminal
# until Enter, so that the user can open a browser.
RELOAD_SECONDS = 5      # a page that returns within this time was reloaded
try:
    from org.myrobotlab.embedded.web import OpenPages
except ImportError:
    OpenPages = None    # a real MyRobotLab continues by itself
keep = System.getProperty("sear.keep") == "true"
terminal = System.getenv("SEAR_TERMINAL") is not None
page = Runtime.getService("webgui")
where = " at http://localhost:%d" % page.getPort() if page is not None else ""
if keep or terminal:
    print "The simulation goes on%s. %s ends it%s." % ("; see its tabs" + where if where else "", "Ctrl+C" if keep else "Enter",
        ", and so does closing the last of them" if where and not keep else "")
elif OpenPages is not None and OpenPages.count() > 0:
    print "The simulation goes on while a browser has its tabs open%s. Ctrl+C ends it, too." % where
if not keep:
    if OpenPages is not None:
        OpenPages.stay(terminal, RELOAD_SECONDS)
    sear.stopSimulation()
print "Next: with docs/first-robot.md you build your own robot in fifteen minutes; sear without a script opens a page with examples."
print "Done."
