# Experiment of the dissertation, section 5.6.2.1: a Roomba with a left-facing PING))) drives along a row of obstacles.
# beam_experiment.csv logs odometer and range, beam_experiment.svg plots them. Run it with
# "sear scripts/beam_experiment.py --headless --speed max".
import os
from org.SEAR.POJOs import Box, Cylinder, Distance, Dynamics, Floor, SEARrobot, Wheel

SPEED = 0.2          # m/s
LENGTH = 5.0         # metres to drive
INTERVAL = 0.05      # seconds between two readings
SIDE = 0.16          # distance of the sensor to the left of the robot's centre, metres

# name, kind, metres along the path, metres to the left of the path, size (a box: along, across; a cylinder: radius)
ROW = (("crate", "box", 1.0, 0.9, (0.4, 0.4)), ("pole", "cylinder", 1.9, 0.7, 0.04445), ("bin", "cylinder", 2.6, 1.1, 0.2),
       ("shelf", "box", 3.5, 1.4, (0.6, 0.3)), ("post", "cylinder", 4.3, 0.6, 0.04445))

sear = Runtime.start("SEAR", "SEAR")
if os.path.exists("SEARproject") and not os.path.exists("SEARproject/robot/experimentRoomba.xml"):
    print "Your project is stored in " + sear.newProject()

Floor("floor", 20, 20, False)    # hidden from beams: an ultrasonic beam glances off a smooth floor
for (name, kind, along, across, size) in ROW:
    if kind == "box":
        thing = Box(name, size[1], 0.6, size[0], 0)
    else:
        thing = Cylinder(name, size, 0.6, 0)
    thing.move(across, 0.3, along)

robot = SEARrobot("experimentRoomba")
robot.addComponent(Dynamics("experimentDrive", 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0))
robot.addComponent(Cylinder("experimentBody", 0.1666875, 0.0762, 4))
for (name, x, z, driven) in (("front", 0, 0.16, 0), ("right", -0.16, 0, 1), ("left", 0.16, 0, 1), ("back", 0, -0.16, 0)):
    wheel = Wheel(name, 0.0381, 0.03, driven)
    wheel.move(x, 0, z)
    robot.addWheel(wheel)
ping = Distance("experimentPing", "PING)))")
ping.move(SIDE, 0.1, 0)
ping.rotate(0, 90, 0)
robot.addComponent(ping)

# ---- the drive ------------------------------------------------------------------------------------------------------------------------------
sear.setLockStep(True)
sear.startSimulation()
sear.simSleep(1)
start = sear.getOdomResult()
sear.drive(SPEED, float("inf"))
odometer = 0.0
log = []
while odometer < LENGTH:
    sear.simSleep(INTERVAL)
    odometer = sear.getOdomResult() - start
    log.append((odometer, sear.getDistanceResult("experimentPing")))
sear.drive(0, float("inf"))
sear.stopSimulation()

table = open("beam_experiment.csv", "w")
table.write("odometer_m,range_m\n")
for (way, distance) in log:
    table.write("%.3f,%.4f\n" % (way, distance))
table.close()

# ---- the plot: 120 points per metre; the path goes right, the range upwards ------------------------------------------------------------------
SCALE = 120.0
TOP = 3.2

def x(metres):
    return 50 + metres * SCALE

def y(metres):
    return 20 + (TOP - metres) * SCALE

svg = open("beam_experiment.svg", "w")
svg.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 700 450" width="700" font-family="sans-serif" font-size="11">\n')
svg.write('<rect width="700" height="450" fill="white"/>\n')
for i in range(11):
    svg.write('<path d="M%.0f %.0fV%.0f" stroke="#ddd"/><text x="%.0f" y="%.0f" text-anchor="middle">%.1f</text>\n'
              % (x(i * 0.5), y(0), y(TOP), x(i * 0.5), y(0) + 15, i * 0.5))
for i in range(7):
    svg.write('<path d="M%.0f %.0fH%.0f" stroke="#ddd"/><text x="%.0f" y="%.0f" text-anchor="end">%.1f</text>\n'
              % (x(0), y(i * 0.5), x(LENGTH), x(0) - 5, y(i * 0.5) + 4, i * 0.5))
for (name, kind, along, across, size) in ROW:
    range_of = across - SIDE
    if kind == "box":
        svg.write('<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f" fill="#d9b38c"/>\n'
                  % (x(along - size[0] / 2), y(range_of + size[1] / 2), size[0] * SCALE, size[1] * SCALE))
    else:
        svg.write('<circle cx="%.1f" cy="%.1f" r="%.1f" fill="#93c47d"/>\n' % (x(along), y(range_of), size * SCALE))
    svg.write('<text x="%.1f" y="%.1f" text-anchor="middle">%s</text>\n' % (x(along), y(range_of + 0.33), name))
svg.write('<path d="M%s" fill="none" stroke="#cc0000" stroke-width="1.5"/>\n' % "L".join(["%.1f %.1f" % (x(a), y(b)) for (a, b) in log]))
svg.write('<text x="%.0f" y="%.0f" text-anchor="middle">odometer, m</text>\n' % (x(LENGTH / 2), y(0) + 32))
svg.write('<text x="%.0f" y="14" text-anchor="middle">range of the PING))), m (red), and the obstacles beside the path</text>\n' % x(LENGTH / 2))
svg.write('</svg>\n')
svg.close()
print "%d readings over %.2f m in beam_experiment.csv, plotted in beam_experiment.svg" % (len(log), odometer)
