# A floor with a crate in the middle of the square and a cone beside each corner.
from org.SEAR.POJOs import Box, Cone, Floor, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

Floor("floor", 4, 4).move(0.5, -0.05, 0.5)
crate = Box("crate", 0.3, 0.3, 0.3, 0)
crate.move(0.5, 0.15, 0.5)
for number, (x, z) in enumerate(((-0.35, -0.35), (-0.35, 1.35), (1.35, 1.35), (1.35, -0.35))):
    cone = Cone("cone %d" % (number + 1), 0.08, 0.25, 0.3)
    cone.move(x, 0.125, z)
robot = Robots.create("robot")
