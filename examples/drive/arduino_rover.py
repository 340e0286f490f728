# Drives 10 m through a room without touching a crate. The program talks StandardFirmata at the other end of the Arduino's cable.
from math import hypot

PATH = 10           # metres
NEAR = 0.95         # volts: reading of a GP2Y0A21 at 0.28 m
POWER = {"left": 9, "right": 10}        # PWM pins of the motor drivers
DIRECTION = {"left": 7, "right": 8}
LEFT_EYE, RIGHT_EYE = 0, 1              # analog channels
OUTPUT, PWM = 1, 3                      # modes of pins

sear = Runtime.start("sear", "SEAR")
if sear.isSimulating():
    sear.stopSimulation()
sear.loadProject("examples/rover.sear")    # backs up the present project
sear.startSimulation()

serial = Runtime.start("roverSerial", "Serial")
serial.connect("/dev/SEAR_UNO_01", 57600)       # resets the board
sear.simSleep(4)                                # boot loader, and blinking of its LED
told = {LEFT_EYE: 0, RIGHT_EYE: 0}              # volts by channel
message = []

def write(*values):
    for value in values:
        serial.write(value)

def listen():
    """Reads the board's messages. Report of an analog channel: E0 plus channel, lower seven bits, upper seven bits."""
    global message
    while serial.available():
        value = serial.read() & 0xFF
        message = [value] if value >= 0x80 else message + [value]
        if len(message) == 3 and 0xE0 <= message[0] < 0xF0:
            told[message[0] & 15] = (message[1] + 128 * message[2]) * 5.0 / 1024

def drive(left, right):
    """Drives the wheels. Arguments: fractions of the full power, negative backward."""
    for side, power in (("left", left), ("right", right)):
        duty = int(255 * abs(power))
        write(0xF5, DIRECTION[side], 1 if power >= 0 else 0)
        write(0xE0 | POWER[side], duty & 127, duty >> 7)

for side in ("left", "right"):
    write(0xF4, POWER[side], PWM, 0xF4, DIRECTION[side], OUTPUT)
write(0xF0, 0x7A, 50, 0, 0xF7)                  # report every 50 ms
write(0xC0 | LEFT_EYE, 1, 0xC0 | RIGHT_EYE, 1)  # both eyes
sear.simSleep(0.2)

path = 0
turns = 0
turning = 0         # 1 to the left, -1 to the right
last = sear.getPose("rover")
while path < PATH:
    listen()
    if max(told.values()) < NEAR:
        turning = 0
        drive(0.7, 0.7)
    else:
        if turning == 0:
            turns += 1
            turning = -1 if told[LEFT_EYE] > told[RIGHT_EYE] else 1     # away from the nearer side; keeping the direction avoids oscillating in a corner
        drive(-0.4 * turning, 0.4 * turning)
    sear.simSleep(0.05)
    pose = sear.getPose("rover")
    path += hypot(pose[0] - last[0], pose[2] - last[2])
    last = pose
    if sear.getTime() > 300:
        raise RuntimeError("only %.1f m in 300 s: at x %.2f, z %.2f" % (path, pose[0], pose[2]))
drive(0, 0)
sear.simSleep(0.5)
serial.disconnect()
print("%.1f m in %.0f s, with %d turns." % (path, sear.getTime(), turns))
