# A yard with a few objects, and a robot with a turret: a PING))) turned by a servo.
from org.SEAR.POJOs import Box, Cone, Cylinder, Distance, Floor, Robots, Servo

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("yard", 8, 8, False, "textures/grass.png")  # hidden from beams: wide beams would hit it in front of the robot

Cylinder("bin", 0.2, 0.6, 5).move(1.0, 0.3, -0.7)
Cone("cone", 0.18, 0.6, 1.5).move(1.1, 0.3, 1.4)
Box("container", 1.2, 2.5, 1, 0, "textures/container.png").move(2.8, 0.5, 0.6)
Box("crate", 0.5, 0.5, 0.5, 2).move(0.2, 0.25, -2)

robot = Robots.create("scout", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
robot.rotate(0, 90, 0)                              # faces north
turret = Servo("turret", 0, 0.08, 0)                # turns mounted parts about the vertical axis at this point
housing = Box("housing", 0.06, 0.04, 0.05, 0.1)
housing.setColor("orange")
housing.move(0, 0.1, 0)
ping = Distance("ping", "PING)))", 0, 0.1, 0.03, 0, 0, 0)
for part in (housing, ping):
    turret.mount(part)
    robot.addComponent(part)
robot.addComponent(turret)
