# A robot on two wheels balances: an IMU measures its tilt, a motor keeps the wheels below it. It takes pushes of 1 N s
# and drives over a step of 5 mm.
from math import radians
from org.SEAR.POJOs import Box, Dynamics, Floor, IMU, Motor, SEARrobot, Wheel

RADIUS = 0.05                      # m
STEP = 1.0 / 60                    # s, one step of the simulator
LEAN, RATE, SPEED, PLACE = 28.6, 3.93, 3.64, 2.26    # poles at -7.3 (twice) and -1.5 (twice) per second

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.newProject()                  # backs up the present project, if there is one

Floor("floor", 20, 20)
Box("step", 1, 1, 0.005, 0).move(0, 0.0025, 1.5)     # 5 mm high, from z = 1 to 2

robot = SEARrobot("balancer")
robot.addComponent(Dynamics("drive", 3))
body = Box("body", 0.16, 0.06, 0.3, 3)
body.move(0, 0.12, 0)
robot.addComponent(body)
robot.addComponent(IMU("imu", 0, 0.2, 0, 0, 0, 0))
left = Wheel("left", RADIUS, 0.03, 1, 0.1, 0, 0)
right = Wheel("right", RADIUS, 0.03, 1, -0.1, 0, 0)
robot.addWheel(left)
robot.addWheel(right)
engine = Motor("engine", left, 2, 30)
engine.addWheel(right)
robot.addComponent(engine)
robot.move(0, RADIUS, 0)
robot.rotate(1, 0, 0)              # starts 1 degree off its balance

sear.startSimulation()

def tilt():
    """Returns the robot's forward lean, radians."""
    return -radians(float(sear.getReading("imu").split(",")[1]))

state = {"lean": tilt(), "place": 0.0, "time": sear.getTime()}

def balance(seconds, target):
    """Balances, and drives to a target along z, metres."""
    goal = sear.getTime() + seconds
    while sear.getTime() < goal:
        sear.simSleep(STEP)
        passed = sear.getTime() - state["time"]
        lean = tilt()
        rate = (lean - state["lean"]) / passed
        speed = RADIUS * (sear.getMotorSpeed("engine") + rate)
        state["lean"] = lean
        state["time"] += passed
        state["place"] += speed * passed
        off = max(-0.5, min(0.5, state["place"] - target))
        push = LEAN * lean + RATE * rate + SPEED * speed + PLACE * off
        wanted = (speed + push * passed) / RADIUS - rate
        sear.setMotorSpeed("engine", max(-30, min(30, wanted)))

balance(2, 0)
for force in (10, -10):
    sear.push("balancer", [0, 0, force], 0.1)
    balance(4, 0)
balance(16, 2.5)
print("Balances at z = %.2f after %.0f s." % (sear.getPose("balancer")[2], sear.getTime()))
