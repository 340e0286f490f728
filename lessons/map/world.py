# A room with three crates, and a robot with a laser scanner.
from org.SEAR.POJOs import Box, Floor, LIDAR, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

Floor("floor", 5, 5, False)
for name, length, width, x, z in (("north wall", 0.1, 4.2, 2.05, 0), ("south wall", 0.1, 4.2, -2.05, 0), ("east wall", 4, 0.1, 0, 2.05),
                                  ("west wall", 4, 0.1, 0, -2.05)):
    wall = Box(name, length, width, 0.4, 0, "textures/brick.png")
    wall.move(x, 0.2, z)
for name, length, width, x, z in (("crate 1", 0.4, 0.8, 1, 1), ("crate 2", 0.6, 0.4, -1.1, -1), ("crate 3", 0.4, 0.4, 0, 1.2)):
    crate = Box(name, length, width, 0.4, 0)
    crate.move(x, 0.2, z)
robot = Robots.create("robot")
lidar = LIDAR("lidar")
lidar.move(0, 0.08, 0)
robot.addComponent(lidar)
robot.move(0.9, 0, -0.9)
