# A docking station with an ArUco marker, a shelf with another marker, and a robot whose camera faces elsewhere.
from org.SEAR.POJOs import Box, Camera, Cylinder, Floor, Marker, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("floor", 7, 7)
for number, (length, width, x, z) in enumerate(((7, 0.1, 0, 3.5), (7, 0.1, 0, -3.5), (0.1, 7, 3.5, 0), (0.1, 7, -3.5, 0))):
    wall = Box("wall %d" % (number + 1), length, width, 0.6, 0)
    wall.setColor("silver")
    wall.move(x, 0.3, z)

dock = Box("dock", 0.2, 0.4, 0.4, 0)
dock.setColor("#303840")
dock.move(3.1, 0.2, -0.4)                                       # its front is at x = 3
Marker("dock marker", "DICT_4X4_50", 7, 0.2, 2.997, 0.24, -0.4, 0, 90, 0)     # 20 cm wide, 24 cm above the floor: at the camera's height

shelf = Box("shelf", 0.8, 0.2, 0.8, 0)
shelf.setColor("#a07848")
shelf.move(2.4, 0.4, 2.2)
Marker("shelf marker", "DICT_4X4_50", 23, 0.2, 2.2, 0.24, 2.097)
for name, color, x, z in (("barrel", "blue", 2.6, -2.2), ("bin", "green", 3.1, 1)):
    thing = Cylinder(name, 0.25, 0.7, 0)
    thing.setColor(color)
    thing.move(x, 0.35, z)

robot = Robots.create2("docker")
eye = Camera("eye", 0, 0.186, -0.1)                             # 24 cm above the floor, 27 cm behind the robot's front
eye.setModel("RaspberryPi-v2")                                  # 62.2 degrees
eye.setSize(480, 360)
eye.setRate(10)
robot.addComponent(eye)
robot.move(0.2, 0.054, 0.9)
robot.rotate(0, 10, 0)
