# Shapes for the palette's pictures of objects that have no shape of their own. PalettePictures draws them with the view.
from org.SEAR.POJOs import *

DARK, GREY, SILVER, WHITE, BRASS, TEAL, BLUE = '#5a626a', '#8d959c', '#c9ced3', '#f4f5f5', '#d3a03a', '#18808a', '#2f6fb0'
RED, GREEN, YELLOW, VIOLET = '#d9453d', '#3fa34d', '#f2b632', '#6b4fa0'
count = [0]

def put(shape, color, x=0, y=0, z=0, rx=0, ry=0, rz=0):
    shape.setColor(color)
    shape.move(x, y, z)
    shape.rotate(rx, ry, rz)
    return shape

def name():
    count[0] += 1
    return 'p%d' % count[0]

def box(color, length, width, height, *place):
    return put(Box(name(), length, width, height, 0), color, *place)

def rod(color, radius, height, *place):
    return put(Cylinder(name(), radius, height, 0), color, *place)

def ball(color, radius, *place):
    return put(Sphere(name(), radius, 0), color, *place)

def tip(color, radius, height, *place):
    return put(Cone(name(), radius, height, 0), color, *place)

def axes(length, thick):
    rod(RED, thick, length, length / 2, 0, 0, 0, 0, 90)
    tip(RED, 2.5 * thick, 5 * thick, length, 0, 0, 0, 0, -90)
    rod(GREEN, thick, length, 0, length / 2, 0)
    tip(GREEN, 2.5 * thick, 5 * thick, 0, length, 0)
    rod(BLUE, thick, length, 0, 0, length / 2, 90)
    tip(BLUE, 2.5 * thick, 5 * thick, 0, 0, length, 90)

def board(color, length, width):
    box(color, length, width, 0.06)
    for x in (-1, 1):
        for z in (-1, 1):
            rod(SILVER, 0.05, 0.07, x * (length / 2 - 0.09), 0, z * (width / 2 - 0.09))

def wheel(x=0):
    rod(DARK, 0.5, 0.3, x, 0, 0, 0, 0, 90)
    rod(SILVER, 0.3, 0.32, x, 0, 0, 0, 0, 90)
    rod(GREY, 0.1, 0.36, x, 0, 0, 0, 0, 90)

def draw_Box():
    Box('box', 1, 1, 1, 0)
def draw_Cylinder():
    Cylinder('cylinder', 0.4, 1, 0)
def draw_Cone():
    Cone('cone', 0.4, 0.9, 0)
def draw_Sphere():
    ball(RED, 0.5)
def draw_Floor():
    Floor('floor', 2, 2)
def draw_Terrain():
    sear.loadProject('examples/mountain.sear')
def draw_Model():
    sear.loadProject('examples/office.sear')

def draw_Maze():
    Maze('maze', ' _ _ _ _\n|  _  | |\n| |  _| |\n|_ _ _  |\n|_ _ _ _|').setHeight(0.25)
def draw_Wall():
    wall = Wall('wall', [(-0.8, -0.8), (0.8, -0.8), (0.8, 0.8), (0, 0.8)], 0.15, 0.7)
    wall.setColor('#c98a5a')
def draw_FloorPlan():
    box(WHITE, 1.5, 2, 0.02, 0, -0.02, 0)
    plan = Maze('plan', ' _ _ _ _ _ _\n|   |       |\n|   |_   _ _|\n|_      |   |\n|   |   |   |\n|_ _|_ _|_ _|', 0.3)
    plan.setHeight(0.12)
    plan.setThickness(0.05)
    plan.setColor(DARK)

def draw_Gravity():
    ball(BLUE, 0.5)
    rod(YELLOW, 0.07, 0.5, 0, 1.05, 0)
    tip(YELLOW, 0.2, 0.3, 0, 0.68, 0, 180)

def draw_Wheel():
    wheel()
def draw_Motor():
    rod(GREY, 0.35, 0.8, 0, 0, 0, 0, 0, 90)
    rod(BRASS, 0.36, 0.3, -0.45, 0, 0, 0, 0, 90)
    rod(SILVER, 0.07, 0.5, -0.85, 0, 0, 0, 0, 90)
    box(DARK, 0.12, 0.3, 0.4, 0.45, 0, 0)
def draw_Servo():
    box(BLUE, 1, 0.5, 0.8)
    box(BLUE, 1.4, 0.5, 0.1, 0, 0.2, 0)
    rod(BLUE, 0.24, 0.2, -0.25, 0.5, 0)
    rod(WHITE, 0.1, 0.2, -0.25, 0.65, 0)
    box(WHITE, 1.1, 0.18, 0.08, 0.05, 0.76, 0.1, 0, -20)
def draw_Dynamics():
    rod(BRASS, 0.45, 0.6, 0, 1.05, 0)
    rod(BRASS, 0.18, 0.2, 0, 1.45, 0)
    for i in range(6):
        rod(GREY, 0.36 if i % 2 else 0.22, 0.07, 0, 0.12 * i, 0)
    box(DARK, 1.1, 1.1, 0.08, 0, -0.08, 0)

def draw_Distance():
    box(BLUE, 1.2, 0.08, 0.6)
    for x in (-0.33, 0.33):
        rod(SILVER, 0.25, 0.35, x, 0.02, 0.2, 90)
        rod(DARK, 0.19, 0.36, x, 0.02, 0.21, 90)
def draw_LIDAR():
    for i in range(7):
        angle = 30 * i
        wall = Box('hidden%d' % i, 1.2, 0.05, 0.5, 0)
        from math import cos, radians, sin
        wall.move(1.1 * cos(radians(angle)), 0.35, 1.1 * sin(radians(angle)))
        wall.rotate(0, 90 - angle, 0)
    robot = SEARrobot('robot')
    robot.addComponent(Dynamics('drive', 1, 400, 0.5, 0.5, 1000, 0.02, 0, 0, 0, 0, 0, 0))
    for part, color, y in ((Box('base', 0.6, 0.5, 0.4, 0), DARK, 0), (Cylinder('head', 0.25, 0.3, 0), YELLOW, 0.35)):
        robot.addComponent(part)
        part.setColor(color)
        part.move(0, y, 0)
    robot.addComponent(LIDAR('scanner', 8, 180, 3, 0, 0.36, 0))
def draw_GPS():
    board(GREEN, 1, 1)
    box(WHITE, 0.62, 0.62, 0.2, 0, 0.12, 0)
    box(SILVER, 0.4, 0.4, 0.02, 0, 0.23, 0)
    rod(DARK, 0.05, 0.06, 0.04, 0.24, 0.04)
def draw_Compass():
    rod(BRASS, 0.6, 0.2)
    rod(WHITE, 0.52, 0.21, 0, 0.01, 0)
    tip(RED, 0.12, 0.45, 0.225, 0.17, 0, 0, 0, -90)
    tip(DARK, 0.12, 0.45, -0.225, 0.17, 0, 0, 0, 90)
def draw_Accelerometer():
    axes(0.8, 0.05)
    box(DARK, 0.4, 0.4, 0.2)
def draw_Gyroscope():
    rod(BRASS, 0.5, 0.12, 0, 0, 0, 0, 0, 20)
    rod(SILVER, 0.52, 0.05, 0, 0, 0, 0, 0, 20)
    rod(GREY, 0.05, 1.3, 0, 0, 0, 0, 0, 20)
    ball(RED, 0.12, -0.22, 0.61, 0)
    tip(GREY, 0.12, 0.2, 0.25, -0.68, 0, 0, 0, 200)
def draw_Odometer():
    wheel(-0.15)
    for i in range(6):
        box(WHITE if i % 2 else RED, 0.25, 0.25, 0.04, 0.4, -0.5, 0.6 - 0.25 * i)
def draw_IMU():
    board(VIOLET, 1, 0.8)
    box(DARK, 0.4, 0.4, 0.12, 0, 0.08, 0)
    axes(0.5, 0.04)
def draw_LineSensor():
    box(WHITE, 1.6, 1.2, 0.04, 0, -0.5, 0)
    box(DARK, 1.6, 0.3, 0.05, 0, -0.5, 0)
    box(BLUE, 0.3, 1, 0.06)
    for z in (-0.35, 0, 0.35):
        rod(RED, 0.09, 0.2, 0, -0.12, z)
def draw_ColorSensor():
    for x, z, color in ((0, 0.45, RED), (-0.4, -0.25, GREEN), (0.4, -0.25, BLUE)):
        rod(color, 0.36, 0.05, x, -0.5, z)
    rod(DARK, 0.25, 0.4)
    rod(WHITE, 0.2, 0.1, 0, -0.2, 0)
    rod(SILVER, 0.26, 0.06, 0, 0.2, 0)
def draw_Bumper():
    rod(GREY, 0.5, 0.25)
    from math import cos, radians, sin
    for i in range(9):
        angle = -10 + 25 * i
        box(GREEN, 0.28, 0.1, 0.2, 0.6 * cos(radians(angle)), 0, 0.6 * sin(radians(angle)), 0, 90 - angle)
def draw_ContactForce():
    rod(DARK, 0.6, 0.2, 0, -0.3, 0)
    rod(SILVER, 0.55, 0.12, 0, -0.1, 0)
    rod(RED, 0.07, 0.5, 0, 0.55, 0)
    tip(RED, 0.2, 0.3, 0, 0.15, 0, 180)
def draw_Arduino():
    box(TEAL, 1.4, 1, 0.06)
    box(SILVER, 0.35, 0.3, 0.25, 0.6, 0.14, 0.25)
    box(DARK, 0.3, 0.22, 0.22, 0.6, 0.12, -0.28)
    box(DARK, 1, 0.1, 0.2, -0.12, 0.12, 0.43)
    box(DARK, 0.8, 0.1, 0.2, -0.2, 0.12, -0.43)
    box(DARK, 0.7, 0.2, 0.1, -0.2, 0.08, -0.1)
def draw_Led():
    ball(RED, 0.35, 0, 0.5, 0)
    rod(RED, 0.35, 0.5, 0, 0.25, 0)
    rod(RED, 0.42, 0.1)
    rod(SILVER, 0.04, 0.8, 0.15, -0.4, 0)
    rod(SILVER, 0.04, 0.65, -0.15, -0.35, 0)

def draw(kind, edit):
    sear.newProject()
    if edit:                                    # a thing of the palette, as its script makes it
        from json import loads
        sear.edit(loads(edit))
    elif 'draw_' + kind in globals():
        globals()['draw_' + kind]()
    else:
        sear.edit({'do': 'robot', 'template': kind})
def draw_Camera():
    box(DARK, 1.2, 0.45, 0.75)
    box(GREY, 0.5, 0.4, 0.2, 0, 0.45, 0)
    rod(SILVER, 0.34, 0.4, 0, -0.02, 0.35, 90)
    rod(BLUE, 0.25, 0.42, 0, -0.02, 0.36, 90)
    rod(RED, 0.07, 0.03, 0.45, 0.22, 0.23, 90)
def draw_Marker():
    Marker('marker', 'DICT_4X4_50', 7, 1).rotate(0, 180, 0)
def draw_Chessboard():
    Chessboard('board', 6, 5, 0.2).rotate(0, 180, 0)
def draw_Picture():
    Picture('picture', 1.6, 0.8).rotate(0, 180, 0)
def draw_Hinge():
    rod(SILVER, 0.09, 1.3)
    for color, side, heights in ((BRASS, 1, (0.4, -0.4)), (GREY, -1, (0,))):
        box(color, 0.75, 0.06, 1.2, 0.47 * side, 0, 0)
        for height in heights:
            rod(color, 0.15, 0.38, 0, height, 0)
def draw_Slider():
    for z in (-0.3, 0.3):
        rod(SILVER, 0.07, 2, 0, 0, z, 0, 0, 90)
    for x in (-0.95, 0.95):
        box(DARK, 0.15, 0.9, 0.4, x, -0.05, 0)
    box(BLUE, 0.6, 0.9, 0.3, 0.2, 0.05, 0)
def draw_BallJoint():
    ball(SILVER, 0.35)
    rod(SILVER, 0.12, 0.9, 0.4, 0.4, 0, 0, 0, -45)
    rod(GREY, 0.42, 0.35, 0, -0.2, 0)
    rod(GREY, 0.16, 0.7, 0, -0.6, 0)
def draw_FixedJoint():
    box(GREY, 1, 0.5, 0.3, -0.4, 0, 0)
    box(GREY, 0.3, 0.5, 1, 0.25, 0.35, 0)
    for i in range(6):
        ball(YELLOW, 0.09, 0.07, 0.17, -0.25 + 0.1 * i)
def draw_Rope():
    box(DARK, 1, 0.4, 0.12, 0, 1, 0)
    for i in range(7):
        rod(BRASS, 0.07, 0.16, 0.02 * (-1) ** i, 0.86 - 0.13 * i, 0, 0, 0, 20 * (-1) ** i)
    rod(BLUE, 0.3, 0.5, 0, -0.25, 0)
def draw_ForceTorque():
    rod(DARK, 0.55, 0.3)
    rod(SILVER, 0.5, 0.35)
    for angle in (0, 60, 120):
        box(GREY, 0.9, 0.12, 0.06, 0, 0.18, 0, 0, angle)
    rod(RED, 0.06, 0.7, 0, 0.5, 0)
    tip(RED, 0.16, 0.3, 0, 0.9, 0)
