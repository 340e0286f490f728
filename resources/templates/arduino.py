# arduino.py: a robot with two distance sensors, two motor drivers and an Arduino finds its way between boxes. The
# Arduino runs StandardFirmata. This script is the program at the other end of the cable, and works with a real Arduino,
# too. Adapt robot, pins and numbers to yours.
from org.SEAR.POJOs import Arduino, Box, Distance, Floor, Motor, Robots

sear = Runtime.start("sear", "SEAR")

PORT = "/dev/SEAR_UNO_01"           # of a real Arduino: COM3, /dev/ttyACM0
BAUD = 57600
SECONDS = 30
POWER = {"left": 9, "right": 10}    # PWM pins of the motor drivers
DIRECTION = {"left": 7, "right": 8}
LEFT_EYE, RIGHT_EYE = 0, 1          # analog channels
NEAR = 1.0                          # volts: reading of a GP2Y0A21 at 0.27 m

# ---- world and robot: omit this for a real robot -----------------------------------------------------------------------------------------

def build():
    Floor("ground", 20, 20)
    for (name, x, z, length, width) in (("north", 0, 2, 4, 0.2), ("south", 0, -2, 4, 0.2), ("west", 2, 0, 0.2, 4), ("east", -2, 0, 0.2, 4),
                                        ("crate", 0.3, 1, 0.4, 0.4), ("box", -1, -0.5, 0.4, 0.4)):
        Box(name, length, width, 0.4, 0).move(x, 0.2, z)
    rover = Robots.create2("rover")
    uno = Arduino("uno", "uno")
    uno.setFirmware("StandardFirmata")
    uno.setPorts("/dev/my_UNO_01", PORT)
    for (name, channel, side) in (("leftEye", LEFT_EYE, 1), ("rightEye", RIGHT_EYE, -1)):
        eye = Distance(name, "GP2Y0A21")
        eye.move(0.08 * side, 0.05, 0.13)
        eye.rotate(0, 25 * side, 0)
        rover.addComponent(eye)
        uno.wire("A%d" % channel, eye)
    for wheel in rover.getWheels():
        if wheel.isDriven():
            motor = Motor(wheel.getName() + "Motor", wheel, 0.5, 10)
            rover.addComponent(motor)
            uno.wire(POWER[wheel.getName()], motor, "pwm")
            uno.wire(DIRECTION[wheel.getName()], motor, "direction")
    rover.addComponent(uno)

# ---- Firmata ------------------------------------------------------------------------------------------------------------------------------

class Firmata:
    OUTPUT, PWM = 1, 3

    def __init__(self, port):
        self.serial = Runtime.start("unoSerial", "Serial")
        self.serial.connect(port, BAUD)             # resets the board
        self.values = {}
        self.message = []
        sear.simSleep(4)                            # boot loader, and blinking of its LED
        while self.serial.available(): self.serial.read()    # version and name, and remains of a previous run

    def write(self, *values):
        for value in values: self.serial.write(value)

    def mode(self, pin, mode):
        self.write(0xF4, pin, mode)

    def digital(self, pin, level):
        self.write(0xF5, pin, level)

    def pwm(self, pin, duty):
        """Sets the duty cycle of a pin, 0 to 1."""
        value = int(255 * duty)
        self.write(0xE0 | pin, value & 127, value >> 7)

    def report(self, channel):
        self.write(0xC0 | channel, 1)

    def volts(self, channel):
        """Returns the latest value, sent every 19 ms; 0 if none has arrived."""
        while self.serial.available():
            value = self.serial.read() & 0xFF
            self.message = [value] if value >= 0x80 else self.message + [value]
            if len(self.message) == 3 and 0xE0 <= self.message[0] < 0xF0:
                self.values[self.message[0] & 15] = self.message[1] + 128 * self.message[2]
        return self.values.get(channel, 0) * 5.0 / 1024

# ---- the program ----------------------------------------------------------------------------------------------------------------------------

def drive(board, left, right):
    """Drives the wheels. Arguments: fractions of the full power, negative backward."""
    for (side, power) in (("left", left), ("right", right)):
        board.digital(DIRECTION[side], 1 if power >= 0 else 0)
        board.pwm(POWER[side], abs(power))

build()
sear.startSimulation()
board = Firmata(PORT)
for pin in POWER.values(): board.mode(pin, Firmata.PWM)
for pin in DIRECTION.values(): board.mode(pin, Firmata.OUTPUT)
board.report(LEFT_EYE)
board.report(RIGHT_EYE)
turns = 0
turning = 0
end = sear.getTime() + SECONDS
while sear.getTime() < end:
    left, right = board.volts(LEFT_EYE), board.volts(RIGHT_EYE)
    if max(left, right) < NEAR:
        turning = 0
        drive(board, 0.6, 0.6)
    else:
        if turning == 0:
            turns += 1
            turning = -1 if left > right else 1     # away from the nearer side; keeping the direction avoids oscillating in a corner
        drive(board, -0.4 * turning, 0.4 * turning)
    sear.simSleep(0.1)
drive(board, 0, 0)
print "%d turns in %d s" % (turns, SECONDS)
