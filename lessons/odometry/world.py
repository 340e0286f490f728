# A floor and a rover with two driven wheels. The left one is worn: the data sheet gives 50 mm for both.
from org.SEAR.POJOs import Floor, Motor, Robots, Wheel

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

Floor("floor", 12, 12)
robot = Robots.chassis("robot")
for name, radius, x in (("left", 0.048, 0.1), ("right", 0.05, -0.1)):
    wheel = Wheel(name, radius, 0.025, 1, x, 0, 0)
    robot.addWheel(wheel)
    robot.addComponent(Motor(name + "Motor", wheel, 0.5, 20, 1, 1000))
caster = Wheel("caster", 0.02, 0.015, 0, 0, -0.03, -0.13)
robot.addWheel(caster)
caster.setTrail(0.02)
