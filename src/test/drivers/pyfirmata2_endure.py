"""Turns a robot in place and reads its sensor through an Arduino with StandardFirmata, with pyFirmata2, a library for real
ones.

usage: pyfirmata2_endure.py PORT SECONDS

Pins 9 and 10 are the motors' power, 7 and 8 their direction, A0 is a Sharp sensor. Each second it prints the number, minimum
and maximum of A0's values, in steps of the converter; after SECONDS "done"."""
import sys
import time

from pyfirmata2 import Arduino


def main():
    board = Arduino(sys.argv[1])
    board.samplingOn(19)
    values = []
    sharp = board.get_pin("a:0:u")
    sharp.register_callback(values.append)
    sharp.enable_reporting()
    for pin, level in ((7, 1), (8, 0)):
        board.get_pin("d:%d:o" % pin).write(level)
    motors = [board.get_pin("d:9:p"), board.get_pin("d:10:p")]
    for motor in motors:
        motor.write(0.5)
    for second in range(1, int(sys.argv[2]) + 1):
        time.sleep(1)
        heard = [round(value * 1023) for value in values]
        del values[:]
        print("%d s %d %d %d" % (second, len(heard), min(heard, default=0), max(heard, default=0)), flush=True)
    for motor in motors:
        motor.write(0)
    board.exit()
    print("done")


if __name__ == "__main__":
    main()
