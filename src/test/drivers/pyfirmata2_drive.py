"""Drives a robot and reads its sensor through an Arduino with StandardFirmata, with pyFirmata2, a library for real ones.

usage: pyfirmata2_drive.py PORT

Pins 9 and 10 are the motors' power, 7 and 8 their direction, A0 is a Sharp sensor, 4 is open. Prints the firmware, the
sensor's volts at the start, whether pin 4 is high with its pull-up, and the volts after driving."""
import sys
import time

from pyfirmata2 import Arduino

VOLTS = 5.0
PATIENCE = 10


def first(pin):
    """Returns the first value received, or None."""
    end = time.time() + PATIENCE
    pin.register_callback(lambda value: None)
    pin.enable_reporting()
    while pin.value is None and time.time() < end:
        time.sleep(0.05)
    return pin.value


def main():
    board = Arduino(sys.argv[1])
    print("%s %d.%d" % ((board.firmware,) + board.get_firmata_version()))
    board.samplingOn(19)
    sharp = board.get_pin("a:0:u")
    print("%.3f" % (first(sharp) * VOLTS))
    print(first(board.get_pin("d:4:u")))
    for direction in (7, 8):
        board.get_pin("d:%d:o" % direction).write(1)
    motors = [board.get_pin("d:9:p"), board.get_pin("d:10:p")]
    for motor in motors:
        motor.write(0.5)
    time.sleep(1.5)
    for motor in motors:
        motor.write(0)
    time.sleep(1)
    print("%.3f" % (sharp.value * VOLTS))
    board.exit()


if __name__ == "__main__":
    main()
