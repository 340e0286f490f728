# A yard on Earth with a shed in the north, and a robot with a GPS receiver and a compass.
from org.SEAR.POJOs import Box, Compass, Floor, GPS, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

Floor("yard", 12, 12)
shed = Box("shed", 1, 2, 1, 0, "textures/brick.png")
shed.move(4.5, 0.5, -2)
robot = Robots.create("robot")
robot.addComponent(GPS("gps", 52.0, 80, 13.0))
robot.addComponent(Compass("compass", False))
