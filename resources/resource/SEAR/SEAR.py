# A robot drives towards a wall, and its distance sensor says how far that is.
# Change anything and run it again; docs/objects.md lists everything that a world can hold.
from org.SEAR.POJOs import Box, Cylinder, Distance, Dynamics, Floor, SEARrobot, Wheel

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # the present project, if there is one, is kept as a backup

Floor("floor", 10, 10, False)
wall = Box("wall", 4, 0.1, 1, 0)
wall.setColor("tan")    # or "#rrggbb"; wall.setImage takes a picture
wall.move(0, 0.5, 3)

robot = SEARrobot("robot")
drive = Dynamics("drive", 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0)
drive.setPorts("/dev/my_Robot01", "/dev/SEAR_Robot_01")
robot.addComponent(drive)
robot.addComponent(Cylinder("body", 0.17, 0.08, 4, "textures/roomba.jpg"))
for (name, x, z, driven) in (("front", 0, 0.16, 0), ("right", -0.16, 0, 1), ("left", 0.16, 0, 1), ("back", 0, -0.16, 0)):
    wheel = Wheel(name, 0.0381, 0.03, driven)
    wheel.move(x, 0, z)
    robot.addWheel(wheel)
ping = Distance("ping", "PING)))")
ping.move(0, 0.2, 0.15)
robot.addComponent(ping)

sear.startSimulation()
sear.simSleep(1)
sear.drive(0.3, float("inf"))    # 0.3 m/s, straight on
for second in range(5):
    sear.simSleep(1)
    print "%.2f m to the wall" % sear.getDistanceResult("ping")
sear.drive(0, 0)
sear.stopSimulation()
