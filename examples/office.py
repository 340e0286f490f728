# An office of 8 by 6 metres with furniture, and a Roomba with a LIDAR and two PING))) sensors.
from org.SEAR.POJOs import Box, Cone, Cylinder, Distance, Floor, LIDAR, Model, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("floor", 8, 6, False)  # hidden from the PING))) sensors, whose beams would hit it in front of the robot

def wall(name, length, width, x, z):
    part = Box(name, length, width, 1.2, 0)
    part.setColor("beige")
    part.move(x, 0.6, z)
    return part

wall("north wall", 0.1, 6.2, 4.05, 0)
wall("south wall", 0.1, 6.2, -4.05, 0)
wall("east wall", 8, 0.1, 0, 3.05)
wall("west wall, north", 4.5, 0.1, 1.75, -3.05)
wall("west wall, south", 2.5, 0.1, -2.75, -3.05)
wall("partition", 0.06, 2.2, -0.6, 1.9).setColor("teal")

def desk(name, x, z, turn):
    top = Box(name + " top", 0.8, 1.6, 0.04, 0)
    top.setColor("#b98d5a")
    top.move(x, 0.72, z)
    top.rotate(0, turn, 0)
    side = 0.7 if turn == 0 else 0.0
    along = 0.0 if turn == 0 else 0.7
    for leg, sign in (("left", -1), ("right", 1)):
        part = Box(name + " " + leg + " leg", 0.6 if turn == 0 else 0.05, 0.05 if turn == 0 else 0.6, 0.7, 0)
        part.setColor("silver")
        part.move(x + sign * along, 0.35, z + sign * side)

desk("desk 1", 3.4, -1.5, 0)
desk("desk 2", 3.4, 1.5, 0)
desk("desk 3", -1.6, 2.5, 90)

def chair(name, x, z, turn):
    seat = Box(name + " seat", 0.42, 0.42, 0.06, 0, "textures/tyre.png")
    seat.move(x, 0.45, z)
    seat.rotate(0, turn, 0)
    foot = Cylinder(name + " foot", 0.05, 0.42, 0, "textures/tyre.png")
    foot.move(x, 0.21, z)

chair("chair 1", 2.7, -1.4, 10)
chair("chair 2", 2.6, 1.7, -25)
chair("chair 3", -1.5, 1.7, 45)

shelf = Box("shelf", 1.8, 0.35, 1.1, 0)
shelf.setColor("#8b6b4a")
shelf.move(-2.9, 0.55, -2.8)

bin = Cylinder("trash Can", 0.17, 0.5, 3)
bin.move(3.6, 0.25, -0.2)

for number, x, z, turn in ((1, -3.3, 0.4, 12), (2, -3.4, 0.9, -20), (3, 1.2, -2.6, 33)):
    box = Box("parcel %d" % number, 0.35, 0.3, 0.25, 1)
    box.move(x, 0.125, z)
    box.rotate(0, turn, 0)
top = Box("parcel on top", 0.25, 0.2, 0.15, 0.5)
top.move(-3.3, 0.325, 0.4)

cone = Cone("wet floor", 0.15, 0.45, 1)
cone.move(0.6, 0.225, 0.9)

plant = Model("plant", "models/Tree/Tree.mesh.xml")
plant.scale(0.3)
plant.move(3.6, 0, 2.6)

robot = Robots.create("office Roomba", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
robot.move(-2, 0, -1)
robot.rotate(0, 90, 0)

lidar = LIDAR("myLidar", 8.191, 180, 1, 0, 0.15, 0.1)
lidar.setPorts("/dev/my_Lidar01", "/dev/SEAR_LIDAR_01")
robot.addComponent(lidar)
robot.addComponent(Distance("leftFrontPing", "PING)))", 0.1, 0.06, 0.13, 0, 30, 0))
robot.addComponent(Distance("rightFrontPing", "PING)))", -0.1, 0.06, 0.13, 0, -30, 0))
