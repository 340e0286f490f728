# A maze of 6 by 6 cells, each 0.8 m wide, with one path from the start to the cone, and a Roomba with three infrared
# sensors.
from org.SEAR.POJOs import Box, Cone, Distance, Floor, Odometer, Robots

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

# Walls: "-" on a cell's upper edge, "|" on its left edge. North is up.
PLAN = ["+-+-+-+-+-+-+",
        "|   |       |",
        "+ + + +-+-+ +",
        "| | |   |   |",
        "+ + +-+ + +-+",
        "| |   | |   |",
        "+ +-+ + +-+ +",
        "|   | |   | |",
        "+-+ + +-+ + +",
        "|   |   | | |",
        "+ +-+-+ + + +",
        "|     |     |",
        "+-+-+-+-+-+-+"]
CELL = 0.8
THICK = 0.06

Floor("floor", 6 * CELL + 1, 6 * CELL + 1)

def place(row, column):
    """Returns the middle of a cell or wall: x is north, z is east, the origin is the maze's middle."""
    return (6 - row) * CELL / 2, (column - 6) * CELL / 2

def walls():
    """Builds adjacent walls as one box, without seams."""
    number = 0
    for row in range(0, 13, 2):
        column = 1
        while column < 13:
            start = column
            while column < 13 and PLAN[row][column] == "-":
                column += 2
            if column > start:
                number += 1
                wall(number, THICK, (column - start) / 2.0 * CELL + THICK, row, (start + column - 2) / 2.0)
            column += 2
    for column in range(0, 13, 2):
        row = 1
        while row < 13:
            start = row
            while row < 13 and PLAN[row][column] == "|":
                row += 2
            if row > start:
                number += 1
                wall(number, (row - start) / 2.0 * CELL + THICK, THICK, (start + row - 2) / 2.0, column)
            row += 2

def wall(number, length, width, row, column):
    x, z = place(row, column)
    box = Box("wall %02d" % number, length, width, 0.3, 0, "textures/brick.png")
    box.move(x, 0.15, z)

walls()

x, z = place(11, 11)
goal = Cone("goal", 0.1, 0.3, 0.5)
goal.move(x, 0.15, z)

x, z = place(11, 1)
robot = Robots.create("maze Roomba", "/dev/my_Robot01", "/dev/SEAR_Robot_01")    # with the dimensions of a real robot
robot.move(x, 0, z)
for name, wx, wz, turn in (("frontEye", 0, 0.16, 0), ("leftEye", 0.16, 0, 90), ("rightEye", -0.16, 0, -90)):
    robot.addComponent(Distance(name, "GP2Y0A21", wx, 0.03, wz, 0, turn, 0))
robot.addComponent(Odometer("odometer"))
