# Common start of the tests of MyRobotLab's own services: a rover with an Arduino and a GPS receiver in front of a wall,
# in real time.
import time
from org.SEAR.POJOs import Arduino, Box, Bumper, Distance, Floor, GPS, Led, Robots
from org.SEAR.POJOs import Motor as SimulatedMotor, Servo as SimulatedServo

def until(what, condition, seconds=60):
    """Waits until a condition is true, also on a busy machine."""
    end = time.time() + seconds
    while not condition():
        if time.time() > end:
            raise AssertionError("in vain: " + what)
        time.sleep(0.01)

def check(what, value, expected, error):
    if not abs(value - expected) <= error:
        raise AssertionError("%s is %s, not %s +- %s" % (what, value, expected, error))

def pressBumper():
    """Drives against the wall."""
    for side in ("left", "right"): sear.setMotorPower(side + "Engine", 0.5)

def build():
    """Builds a rover with the Create's body, whose wheels an Uno drives with the program of MyRobotLab's Arduino
    service."""
    Floor("ground", 20, 20)
    Box("wall", 4, 0.2, 0.4, 0).move(0, 0.2, 0.9)    # its face is 0.8 m ahead of the robot's middle
    rover = Robots.create2("rover")
    uno = Arduino("uno", "uno")
    uno.setFirmware("MrlComm")
    uno.setPorts("/dev/my_UNO_01", "/dev/SEAR_UNO_01")
    eye = Distance("eye", "GP2Y0A21")
    eye.move(0, 0.05, 0.13)
    sonar = Distance("sonar", "HC-SR04")
    sonar.move(0, 0.06, 0.15)
    neck = SimulatedServo("neck")
    neck.move(0, 0.15, 0)
    lamp = Led("lamp")
    bumper = Bumper("bumper")
    for part in (eye, sonar, bumper, neck, lamp): rover.addComponent(part)
    uno.wire("A0", eye)
    uno.wire(2, bumper)
    uno.wire(3, neck)
    uno.wire(7, sonar, "trigger")
    uno.wire(8, sonar, "echo")
    uno.wire(11, lamp)
    for wheel in rover.getWheels():
        if wheel.isDriven():
            left = wheel.getName() == "left"
            engine = SimulatedMotor(wheel.getName() + "Engine", wheel, 0.5, 10)
            rover.addComponent(engine)
            uno.wire(9 if left else 10, engine, "pwm")
            uno.wire(4 if left else 5, engine, "direction")
    rover.addComponent(uno)
    gps = GPS("fixes", 33.61, 182.5, -80.865)
    gps.setPorts("/dev/my_GPS_01", "/dev/SEAR_GPS_01")
    rover.addComponent(gps)

sear = Runtime.start("sear", "SEAR")
kept = sear.newProject()
build()
sear.setLockStep(False)
sear.setSpeed(1)
sear.startSimulation()

def board(name="board"):
    """Returns the connected Arduino service, once it knows its board."""
    service = Runtime.start(name, "Arduino")
    service.connect("/dev/SEAR_UNO_01")
    until("the board says what it is", lambda: service.getBoardInfo() is not None and service.getBoardInfo().getVersion() == 68)
    return service
