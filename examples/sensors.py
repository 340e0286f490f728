# A yard with obstacles of every kind, including twenty boxes, and a Roomba with every sensor.
from org.SEAR.POJOs import Accelerometer, BeamCone, Box, Bumper, ColorSensor, Compass, Cone, Cylinder, Distance, Floor, GPS, Gyroscope, IMU, LIDAR, \
    LineSensor, Model, Noise, Odometer, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("yard", 20, 20, False, "textures/grass.png")  # hidden from beams: wide beams would hit it in front of the robot

def fixed(name, length, width, height, x, y, z, image):
    box = Box(name, length, width, height, 0, "textures/" + image)
    box.move(x, y, z)
    return box

fixed("container", 6, 2.4, 2.6, 6, 1.3, -4, "container.png").rotate(0, 20, 0)
fixed("second container", 6, 2.4, 2.6, 1, 1.3, 7.5, "container.png")
fixed("loading ramp", 1.2, 1.6, 0.08, 1, 0.1, 5.45, "tiles.png").rotate(-10, 0, 0)

fixed("shed, back wall", 0.15, 3, 2, -7, 1, 2.5, "brick.png")
fixed("shed, left wall", 2, 0.15, 2, -6, 1, 1, "brick.png")
fixed("shed, right wall", 2, 0.15, 2, -6, 1, 4, "brick.png")
fixed("shed, roof", 2.4, 3.4, 0.1, -6, 2.05, 2.5, "container.png")

for number in range(4):
    fixed("garden wall %d" % (number + 1), 2.9, 0.2, 0.6, -6 + 3 * number, 0.3, -8, "brick.png")

fixed("bench, seat", 1.6, 0.4, 0.05, -1.5, 0.425, -4.2, "container.png")
for leg, x in (("left", -2.2), ("right", -0.8)):
    fixed("bench, %s leg" % leg, 0.06, 0.4, 0.4, x, 0.2, -4.2, "brick.png")

for number in range(6):
    box = Box("crate %d" % (number + 1), 0.5, 0.5, 0.5, 2)
    box.move(2.5, 0.25 + 0.5 * (number // 3), -1.2 + 0.7 * (number % 3))

for number in range(5):
    cone = Cone("cone %d" % (number + 1), 0.18, 0.6, 1.5)
    cone.move(-3 + 1.2 * number, 0.3, 3)

bin = Cylinder("recycling bin", 0.3, 1, 8)
bin.move(-2, 0.5, -2.5)

tree = Model("Tree1_name", "models/Tree/Tree.mesh.xml")
tree.move(5, 0, 4)
old = Model("old tree", "models/Tree/Tree.mesh.xml")
old.scale(1.4)
old.move(-5, 0, -5)

robot = Robots.create("myRoomba", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
robot.rotate(0, 90, 0)

lidar = LIDAR("myLidar", 8.191, 180, 0.5, 0, 0.15, 0.1)
lidar.setPorts("/dev/my_Lidar01", "/dev/SEAR_LIDAR_01")
robot.addComponent(lidar)

gps = GPS("gpsUnit1", 33.61, 182.5, -80.865)
gps.setPorts("/dev/my_GPS_01", "/dev/SEAR_GPS_01")
robot.addComponent(gps)

robot.addComponent(Compass("compass", True))
robot.addComponent(Accelerometer("accel", 30))
robot.addComponent(Gyroscope("gyro", 30))
robot.addComponent(Odometer("odometer"))
robot.addComponent(IMU("imu"))
robot.addComponent(LineSensor("line", 0, 0, 0.1))
robot.addComponent(ColorSensor("color", 0, 0, 0.05))
robot.addComponent(Bumper("bumper"))

robot.addComponent(Distance("frontPing", "PING)))", 0, 0.06, 0.16, 0, 0, 0))
robot.addComponent(Distance("leftEZ1", "LV-EZ1", 0.12, 0.06, 0.1, 0, 60, 0))
robot.addComponent(Distance("rightEZ0", "LV-EZ0", -0.12, 0.06, 0.1, 0, -60, 0))
robot.addComponent(Distance("backInfrared", "GP2Y0A02", 0, 0.06, -0.16, 0, 180, 0))
robot.addComponent(Distance("laser", "laser", 0, 0.1, 0.16, 0, 0, 0))
noisy = Distance("noisyPing", [BeamCone(15, 2, "#00ffff", 24), [5, 3, "#0080ff"], [8, 0.6, "#8000ff", 12, 40, 0]], 0, 0.08, 0.16, 0, 0, 0)
noisy.setNoise(Noise().setWhite(0.01).setDropout(0.05))
robot.addComponent(noisy)
