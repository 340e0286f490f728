# A red ball among objects of other colours, and a rover with a colour camera, a depth camera and a thermal camera.
from org.SEAR.POJOs import Box, Camera, Cylinder, Floor, Robots, Sphere

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("floor", 10, 10)
for number, (length, width, x, z) in enumerate(((10, 0.1, 0, 5), (10, 0.1, 0, -5), (0.1, 10, 5, 0), (0.1, 10, -5, 0))):
    wall = Box("wall %d" % (number + 1), length, width, 0.8, 0)
    wall.setColor("silver")
    wall.move(x, 0.4, z)
for name, color, x, z in (("barrel", "blue", 2.5, 3), ("bin", "green", -2.5, 3.5), ("post", "#303030", 3, -2)):
    thing = Cylinder(name, 0.3, 0.9, 0)
    thing.setColor(color)
    thing.move(x, 0.45, z)
stove = Box("stove", 0.6, 0.4, 0.5, 0)
stove.setColor("teal")
stove.setTemperature(80)
stove.move(-1.3, 0.25, 3)

ball = Sphere("ball", 0.12, 0.3)
ball.setColor("red")
ball.setRollingFriction(0.02)
ball.move(0.3, 0.12, 1.5)

rover = Robots.create("hunter")
eye = Camera("eye", 0, 0.25, 0.1, 10, 0, 0)    # 320 x 240 pixels, 60 degrees, 10 pictures per second; pitched 10 degrees down
rover.addComponent(eye)
kinect = Camera("kinect", 0, 0.3, 0.1)
kinect.setModel("Kinect")
kinect.setSize(160, 120)
rover.addComponent(kinect)
thermal = Camera("thermal", 0, 0.2, 0.1)
thermal.setModel("MLX90640")
rover.addComponent(thermal)
