# A course of ramps: up, level, down, a side slope and steps, and a Roomba with an accelerometer and a gyroscope.
from org.SEAR.POJOs import Accelerometer, Box, Compass, Floor, Gyroscope, Odometer, Robots
from math import cos, radians, sin

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("lawn", 16, 10, "textures/grass.png")

WIDTH = 1.2
THICK = 0.1

def ramp(name, length, x, y, z, degrees, image):
    """Builds a ramp from (x, y, z) to the north. Arguments: length along the slope, inclination in degrees. Returns its
    end."""
    part = Box(name, length, WIDTH, THICK, 0, image)
    rise = radians(degrees)
    part.move(x + length / 2 * cos(rise) + THICK / 2 * sin(rise), y + length / 2 * sin(rise) - THICK / 2 * cos(rise), z)
    part.rotate(0, 0, degrees)
    return x + length * cos(rise), y + length * sin(rise)

x, y = ramp("gentle ramp up", 2, -4, 0, 0, 6, "textures/tiles.png")
x, y = ramp("plateau", 1.5, x, y, 0, 0, "textures/container.png")
x, y = ramp("gentle ramp down", 2, x, y, 0, -6, "textures/tiles.png")

x, y = ramp("steep ramp up", 1.5, -4, 0, 2.5, 12, "textures/container.png")
x, y = ramp("high plateau", 2, x, y, 2.5, 0, "textures/container.png")
x, y = ramp("steep ramp down", 1.5, x, y, 2.5, -12, "textures/container.png")

side = Box("side slope", 4, WIDTH, THICK, 0, "textures/tiles.png")
side.move(-1, 0.02, -2.5)
side.rotate(5, 0, 0)

for step in range(3):
    part = Box("step %d" % (step + 1), 1.5 - 0.5 * step, WIDTH, 0.015, 0, "textures/brick.png")
    part.move(3.5 + 0.25 * step, 0.0075 + 0.015 * step, -2.5)

robot = Robots.create("climber", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
robot.move(-5, 0, 0)
robot.rotate(0, 90, 0)
accelerometer = Accelerometer("accel", 20)
accelerometer.setGravity(True)
robot.addComponent(accelerometer)
robot.addComponent(Gyroscope("gyro", 20))
robot.addComponent(Compass("compass"))
robot.addComponent(Odometer("odometer"))
