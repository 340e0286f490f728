# Two kilometres of the mountains above Jacksboro, Tennessee, with real elevation, and a rover below the summit.
from org.SEAR.POJOs import Box, Compass, Cylinder, Dynamics, GPS, Model, SEARrobot, Terrain, Wheel

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

SUMMIT = (36.485, -84.23083)
ground = Terrain("jacksboro", "terrain/jacksboro.tif")     # included in SEAR: SRTM, US Geological Survey, public domain
ground.setArea(36.485, -84.2308, 2000, 2000)               # centre, metres north-south and east-west

pole = Cylinder("summit", 0.05, 3, 0)
pole.setColor("red")
pole.place(*SUMMIT)

for number, (north, east) in enumerate(((-30, 12), (-55, -22), (-80, 30), (-120, -14), (-140, 25), (-170, -35), (-185, 8), (20, 18), (35, -20))):
    tree = Model("tree %d" % (number + 1), "models/Tree/Tree.mesh.xml")
    tree.placeAt(north, east)

hut = Box("hut", 4, 3, 3, 0, "textures/brick.png")
hut.rotate(0, 20, 0)
hut.place(36.48325, -84.23055)

rover = SEARrobot("rover")
rover.addComponent(Dynamics("drive", 30, 60, 0.3, 0.4, 10000, 0.1))
body = Box("rover body", 0.5, 0.9, 0.2, 30)
body.setColor("orange")
body.move(0, 0.12, 0)
rover.addComponent(body)
for name, x, z in (("front left", 0.35, 0.35), ("front right", -0.35, 0.35), ("back left", 0.35, -0.35), ("back right", -0.35, -0.35)):
    rover.addWheel(Wheel(name + " wheel", 0.18, 0.1, 1, x, 0, z))

gps = GPS("gps", "/dev/my_GPS_01", "/dev/SEAR_GPS_01")     # gets its place on Earth from the terrain
gps.move(0, 0.25, 0)
rover.addComponent(gps)
rover.addComponent(Compass("compass", True))               # magnetic, like a real compass
rover.place(36.48325, -84.2309, 45)                        # below the summit, facing north-east
