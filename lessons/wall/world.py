# A room with a cupboard in a corner, and a robot with one eye ahead and one to the right.
from org.SEAR.POJOs import Box, Distance, Floor, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

Floor("floor", 6, 7, False)
for name, length, width, x, z in (("north wall", 0.1, 5.2, 2.05, 0), ("south wall", 0.1, 5.2, -2.05, 0), ("east wall", 4, 0.1, 0, 2.55),
                                  ("west wall", 4, 0.1, 0, -2.55), ("cupboard", 1.5, 1.5, 1.25, 1.75)):
    wall = Box(name, length, width, 0.4, 0, "textures/brick.png")
    wall.move(x, 0.2, z)
robot = Robots.create("robot")
robot.move(-1.5, 0, -1)
robot.addComponent(Distance("frontEye", "GP2Y0A21", 0, 0.03, 0.16, 0, 0, 0))
robot.addComponent(Distance("rightEye", "GP2Y0A21", -0.16, 0.03, 0, 0, -90, 0))
