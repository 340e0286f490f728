# A room with crates, and a rover whose Arduino runs a compiled sketch: an HC-SR04 on a servo, two motors with drivers. The sketch itself drives.
from org.SEAR.POJOs import Arduino, Box, Cylinder, Distance, Dynamics, Floor, Led, Motor, SEARrobot, Servo, Wheel

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
body.setColor("teal")
body.move(0, 0.025, 0)
rover.addComponent(body)
for name, z in (("front ball", 0.08), ("rear ball", -0.08)):
    rover.addWheel(Wheel(name, 0.015, 0.015, 0, 0, -0.018, z))

uno = Arduino("uno", "uno")
uno.setSketch("sketches/avoider.hex")   # comes with SEAR; its source is sketches/avoider.ino
uno.setPorts("/dev/my_UNO_02", "/dev/SEAR_UNO_02")
for name, x, pwm, direction in (("left", 0.085, 5, 7), ("right", -0.085, 6, 8)):
    wheel = Wheel(name + " wheel", 0.033, 0.02, 1, x, 0, 0)
    rover.addWheel(wheel)
    motor = Motor(name + "Motor", wheel, 0.15, 12)
    rover.addComponent(motor)
    uno.wire(pwm, motor, "pwm")
    uno.wire(direction, motor, "direction")
neck = Servo("neck", 0, 0.06, 0.06)
rover.addComponent(neck)
uno.wire(9, neck)
sonar = Distance("sonar", "HC-SR04", 0, 0.07, 0.08, -20, 0, 0)
rover.addComponent(sonar)
neck.mount(sonar)
uno.wire(12, sonar, "trigger")
uno.wire(11, sonar, "echo")
lamp = Led("lamp", 0, 0.05, -0.06)
rover.addComponent(lamp)
uno.wire(13, lamp)
rover.addComponent(uno)
