# A hall from west to east with crates, and two robots, each with three infrared eyes and a compass.
from org.SEAR.POJOs import Box, Compass, Distance, Floor, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

floor = Floor("floor", 8, 8, False)
floor.move(0, 0, 3)
for name, length, width, x, z in (("north wall", 0.1, 7.2, 1.55, 3), ("south wall", 0.1, 7.2, -1.55, 3), ("east wall", 3, 0.1, 0, 6.55),
                                  ("west wall", 3, 0.1, 0, -0.55)):
    wall = Box(name, length, width, 0.4, 0, "textures/brick.png")
    wall.move(x, 0.2, z)
for number, (x, z) in enumerate(((0.6, 1.7), (-0.5, 2.6), (0.4, 3.6), (-0.8, 4.3))):
    crate = Box("crate %d" % (number + 1), 0.35, 0.35, 0.35, 0)
    crate.move(x, 0.175, z)
for name, x in (("red", 0.6), ("blue", -0.6)):
    robot = Robots.create(name)
    robot.move(x, 0, 0)
    for eye, left, ahead, turn in (("frontEye", 0, 0.16, 0), ("leftEye", 0.11, 0.11, 40), ("rightEye", -0.11, 0.11, -40)):
        robot.addComponent(Distance(eye, "GP2Y0A21", left, 0.03, ahead, 0, turn, 0))
    robot.addComponent(Compass("compass"))
