# A ramp with a wall at its upper end, and a rover facing the wall.
from math import cos, radians, sin
from org.SEAR.POJOs import Box, Distance, Floor, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # an existing project becomes a backup

SLOPE = 12                  # degrees
Floor("floor", 8, 8)

def place(along, above):
    """Returns y and z, metres, of a point given by its distances along the ramp from its foot, and above the ramp."""
    a = radians(SLOPE)
    return along * sin(a) + above * cos(a), along * cos(a) - above * sin(a)

y, z = place(1.75, -0.05)
ramp = Box("ramp", 1, 3.5, 0.1, 0)
ramp.setColor("silver")
ramp.move(0, y, z)
ramp.rotate(-SLOPE, 0, 0)
y, z = place(3.2, 0.2)
wall = Box("wall", 1, 0.1, 0.4, 0, "textures/brick.png")
wall.move(0, y, z)
wall.rotate(-SLOPE, 0, 0)
robot = Robots.rover("robot")
for name in ("leftMotor", "rightMotor"):
    robot.getPart(name).setNoLoadSpeed(200)    # rad/s: such a fast motor hardly brakes, so the controller needs D
robot.addComponent(Distance("eye", "laser", 0, 0.03, 0.07, 0, 0, 0))
y, z = place(1.4, 0)
robot.move(0, y, z)
robot.rotate(-SLOPE, 0, 0)
