# A room with crates, and a minimal robot: two infrared distance sensors, two motors with drivers, an Arduino.
from org.SEAR.POJOs import Arduino, Box, Cylinder, Distance, Dynamics, Floor, Motor, SEARrobot, Wheel

sear = Runtime.start("sear", "SEAR")
sear.newProject()    # backs up the present project, if there is one

Floor("floor", 5, 4)

def plank(name, length, width, x, z):
    """Adds a loose wall: the robot can push every object in this room."""
    Box(name, length, width, 0.2, 10 * max(length, width), "textures/brick.png").move(x, 0.1, z)

plank("north wall", 0.1, 3, 2, 0)
plank("south wall", 0.1, 3, -2, 0)
plank("east wall", 3.8, 0.1, 0, 1.6)
plank("west wall", 3.8, 0.1, 0, -1.6)
for number, (x, z, turn) in enumerate(((0.9, 0.7, 20), (0.6, -0.9, -35), (-0.9, 0.8, 0), (-1.1, -0.5, 50))):
    crate = Box("crate %d" % (number + 1), 0.35, 0.35, 0.3, 2)
    crate.move(x, 0.15, z)
    crate.rotate(0, turn, 0)

rover = SEARrobot("rover")
rover.addComponent(Dynamics("drive", 1, 400, 0.5, 0.5, 1000, 0.02, 0, 0.05, 0, 0, 0, 0))    # 1 kg on stiff springs
body = Cylinder("chassis", 0.1, 0.04, 1)
body.setColor("orange")
body.move(0, 0.025, 0)
rover.addComponent(body)
for name, z in (("front ball", 0.08), ("rear ball", -0.08)):
    rover.addWheel(Wheel(name, 0.015, 0.015, 0, 0, -0.018, z))

uno = Arduino("uno", "uno")
uno.setFirmware("StandardFirmata")
uno.setPorts("/dev/my_UNO_01", "/dev/SEAR_UNO_01")
for name, x, pwm, direction in (("left", 0.085, 9, 7), ("right", -0.085, 10, 8)):
    wheel = Wheel(name + " wheel", 0.033, 0.02, 1, x, 0, 0)
    rover.addWheel(wheel)
    motor = Motor(name + "Motor", wheel, 0.15, 12)
    rover.addComponent(motor)
    uno.wire(pwm, motor, "pwm")
    uno.wire(direction, motor, "direction")
for name, x, turn, pin in (("leftEye", 0.05, 20, "A0"), ("rightEye", -0.05, -20, "A1")):
    eye = Distance(name, "GP2Y0A21", x, 0.03, 0.06, 0, turn, 0)
    rover.addComponent(eye)
    uno.wire(pin, eye)
rover.addComponent(uno)
