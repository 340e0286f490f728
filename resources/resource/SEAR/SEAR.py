# A robot drives towards a wall and measures its distance. Change anything and run the script again. docs/objects.md
# lists all objects of a world.
from org.SEAR.POJOs import Box, Distance, Floor, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("floor", 10, 10, False)
wall = Box("wall", 4, 0.1, 1, 0)
wall.setColor("tan")    # or "#rrggbb"; wall.setImage sets a picture
wall.move(0, 0.5, 3)

robot = Robots.create("robot", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
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
