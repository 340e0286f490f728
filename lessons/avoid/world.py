# A room with crates, and a robot with three infrared eyes.
from org.SEAR.POJOs import Box, Distance, Floor, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

Floor("floor", 5, 5, False)
for name, length, width, x, z in (("north wall", 0.1, 4.2, 2.05, 0), ("south wall", 0.1, 4.2, -2.05, 0), ("east wall", 4, 0.1, 0, 2.05),
                                  ("west wall", 4, 0.1, 0, -2.05)):
    wall = Box(name, length, width, 0.4, 0, "textures/brick.png")
    wall.move(x, 0.2, z)
for number, (x, z) in enumerate(((0.9, 0.9), (-1, 1.1), (0.7, -1.0), (-0.9, -0.8))):
    crate = Box("crate %d" % (number + 1), 0.35, 0.35, 0.35, 0)
    crate.move(x, 0.175, z)
robot = Robots.create("robot")
for name, x, z, turn in (("frontEye", 0, 0.16, 0), ("leftEye", 0.11, 0.11, 40), ("rightEye", -0.11, 0.11, -40)):
    robot.addComponent(Distance(name, "GP2Y0A21", x, 0.03, z, 0, turn, 0))
