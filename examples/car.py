# A meadow with five gates of traffic cones, and a car: rear engine, front wheels steered by a servo, GPS receiver, compass.
from math import cos, radians, sin
from org.SEAR.POJOs import Box, Compass, Cone, Dynamics, Floor, GPS, Motor, SEARrobot, Servo, Wheel

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("meadow", 40, 40, "textures/grass.png")

# Metres north and east of the start, and the direction of passage, degrees from north to east.
GATES = ((6, 0, 0), (10, 5, 80), (4, 9, 190), (-3, 5, 250), (-1, -4, 330))
for number, (x, z, course) in enumerate(GATES):
    for side, way in (("left", -1), ("right", 1)):
        cone = Cone("gate %d, %s" % (number + 1, side), 0.15, 0.5, 1)
        cone.move(x - 1.2 * way * sin(radians(course)), 0.25, z + 1.2 * way * cos(radians(course)))

car = SEARrobot("car")
car.addComponent(Dynamics("drive", 4, 400, 0.5, 0.5, 1000, 0.02, 0, 0.1, 0, 0, 90, 0))    # 4 kg on stiff springs, looking north
for name, length, width, height, y, z, color in (("chassis", 0.2, 0.42, 0.06, 0.05, 0, "red"), ("cabin", 0.18, 0.2, 0.06, 0.11, -0.04, "white")):
    part = Box(name, length, width, height, 2)
    part.setColor(color)
    part.move(0, y, z)
    car.addComponent(part)

steering = Servo("steering", 0, 0.05, 0.15)
steering.setRange(-30, 30)
steering.setSpeed(200)
car.addComponent(steering)
for name, x in (("frontLeft", 0.12), ("frontRight", -0.12)):
    wheel = Wheel(name, 0.05, 0.03, 2, x, 0, 0.15)
    car.addWheel(wheel)
    wheel.setSteering(steering)       # Ackermann geometry: the inner wheel turns further

left = Wheel("rearLeft", 0.05, 0.03, 1, 0.12, 0, -0.15)
right = Wheel("rearRight", 0.05, 0.03, 1, -0.12, 0, -0.15)
car.addWheel(left)
car.addWheel(right)
engine = Motor("engine", left, 0.6, 40)
engine.addWheel(right)
car.addComponent(engine)

gps = GPS("gps", 33.61, 182.5, -80.865)
gps.setPorts("/dev/my_GPS_01", "/dev/SEAR_GPS_01")
gps.move(0, 0.15, 0)
car.addComponent(gps)
car.addComponent(Compass("compass"))
