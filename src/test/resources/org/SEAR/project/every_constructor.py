# Every constructor and every method of the object grammar, called from Jython with the types that Python gives.
from org.SEAR.POJOs import Accelerometer, BeamCone, Box, Compass, Cone, Cylinder, Distance, Dynamics, Floor, GPS, Gyroscope, LIDAR, Model, Noise, \
    Odometer, SEARrobot, Sphere, Terrain, Wheel

pose = (1, 2.5, -3, 10, 20, 30)
TREE = "models/Tree/Tree.mesh.xml"
count = [0]

def name():
    count[0] += 1
    return "o%d" % count[0]

for kind, sizes in ((Box, (1, 2, 3.5)), (Cylinder, (1, 2)), (Cone, (0.5, 2))):
    kind(name(), *sizes)
    kind(name(), *(sizes + (4,)))
    kind(name(), *(sizes + (4, "textures/brick.png")))
    kind(name(), *(sizes + (4,) + pose[:3]))
    kind(name(), *(sizes + (4,) + pose))
    kind(name(), *(sizes + (4, "textures/brick.png") + pose))

Floor(name(), 5, 6)
Floor(name(), 5, 6, False)
Floor(name(), 5, 6, "textures/grass.png")
Floor(name(), 5, 6, False, "textures/grass.png")
floor = Floor(name(), 5, 6, False, "textures/grass.png", *pose)
floor.setImageSize(1.5)
floor.setColor("Teal")

Model(name(), TREE)
Model(name(), TREE, 5)
Model(name(), TREE, 5, "textures/brick.png")
Model(name(), TREE, 5, *pose[:3])
Model(name(), TREE, 5, *pose)
shape = Model(name(), TREE, 5, "textures/brick.png", *pose)
shape.setMass(0)
shape.setTerrain(True)
shape.setTerrain(False)
shape.setImage("textures/tiles.png")
shape.setImage(None)
shape.setColor("#c0ffee")
shape.setVisibleToSensors(False)
shape.setFriction(0.5)
shape.setRestitution(0.25)
shape.setRollingFriction(0.01)
shape.scale(2)
shape.scale(1, 2, 3.5)
shape.move(0, 0, 1)
shape.rotate(0, 90, 0)

robot = SEARrobot("robot")
robot.move(1, 0, 1)
robot.addWheel(Wheel(name(), 0.1, 0.05))
robot.addWheel(Wheel(name(), 0.1, 0.05, 0))
robot.addWheel(Wheel(name(), 0.1, 0.05, 1, 0.1, 0, 0))
robot.addWheel(Wheel(name(), 0.1, 0.05, 1, "textures/tyre.png", 0.1, 0, 0))

Dynamics(name(), 4)
Dynamics(name(), 4, *pose)
Dynamics(name(), 400, 60, 0.3, 0.4, 10000, 0.1)
dynamics = Dynamics(name(), 400, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 180)
dynamics.setPorts("/dev/a", "/dev/b")
dynamics.setBaud(19200)
dynamics.setModel("create2")
dynamics.setStreamHeaderSummed(False)
robot.addComponent(dynamics)

def add(sensor):
    robot.addComponent(sensor)
    return sensor

add(Distance(name()))
add(Distance("LV-EZ1"))
add(Distance(name(), "laser"))
add(Distance(name(), "PING)))", *pose))
add(Distance(name(), 10, 2.5))
add(Distance(name(), [BeamCone(10, 2), BeamCone(10, 2, "#00ff00"), BeamCone(10, 2, "#00ff00", 8), BeamCone(10, 2, "#00ff00", 8, 5, -5)]))
distance = add(Distance(name(), [[10, 2], (20.5, 1, "#0000ff"), [5, 3, "#0000ff", 12], [5, 3, "#0000ff", 12, 40, 0]], *pose))
distance.setLines(20)
distance.setSeesOwnRobot(True)
distance.setBeam("RADAR")
distance.setCones([[10, 2]])
distance.setNoise(Noise(0.1, 0, 0.01, 0.001, 0.5))

add(LIDAR(name()))
add(LIDAR(name(), 8, 90, 0.5))
add(LIDAR(name(), 8, 90, 0.5, *pose[:3]))
lidar = add(LIDAR(name(), 8, 90, 0.5, *pose))
lidar.setRange(80)
lidar.setSpread(100)
lidar.setResolution(0.25)
lidar.setPorts("/dev/c", "/dev/d")
lidar.setBaud(38400)
lidar.LMS(1)
lidar.setLenient(True)
lidar.setSeesOwnRobot(True)
lidar.setNoise(Noise().setWhite(0.1).setBias(-1).setDrift(0.1).setQuantisation(0.01).setDropout(0.1))

add(GPS(name(), 33.61, 182.5, -80.865))
add(GPS(name(), 33.61, 182.5, -80.865, "/dev/e", "/dev/f"))
gps = add(GPS(name(), 33.61, 182.5, -80.865, 0, 0.2, 0))
gps.setPorts("/dev/g", "/dev/h")
gps.setBaud(4800)
gps.setModel("MT3301")
gps.setRate(5)
gps.setTimeToFix(30)
gps.setNoise(Noise(2))

add(Compass(name()))
add(Compass(name(), True))
compass = add(Compass(name(), False, *pose))
compass.setDeclination(True)
compass.setNorth(0, 0, 1000)
compass.setNoise(None)

for kind in (Accelerometer, Gyroscope):
    add(kind(name()))
    add(kind(name(), 20))
    add(kind(name(), 20, *pose)).setBandwidth(30)
add(Accelerometer(name())).setGravity(True)
add(Odometer(name()))

Sphere(name(), 0.5)
Sphere(name(), 0.5, 4)
Sphere(name(), 0.5, 4, "textures/brick.png")
Sphere(name(), 0.5, 4, *pose[:3])
Sphere(name(), 0.5, 4, *pose)
Sphere(name(), 0.5, 4, "textures/brick.png", *pose)

area = Terrain("ground", "textures/grass.png")
area.setArea(36.485, -84.2308, 2000, 3000.5)
ground = Terrain("ground", "textures/grass.png")
ground.addTile("textures/brick.png")
ground.setSize(2000, 3000.5, -10, 400)
if len(ground.getPaths()) != 2 or ground.hasArea() or not ground.hasSize() or not area.hasArea():
    raise AssertionError("terrain")
Box(name(), 1, 2, 3).placeAt(4, 5.5)
Sphere(name(), 0.5, 4).place(36.4861, -84.2301)
moved = Sphere(name(), 0.5, 4)
moved.place(36.4861, -84.2301)
moved.placeAt(4, 5.5)
moved.move(1, 2, 3)
SEARrobot("placed").place(36.4861, -84.2301, 90)
SEARrobot("placedToo").placeAt(4, 5.5, -45)
