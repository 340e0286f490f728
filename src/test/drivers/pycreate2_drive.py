"""Drives the robot on a serial port with pycreate2, an independent driver for the real Create 2.

usage: pycreate2_drive.py PORT SECONDS

Prints one line per reading. Exit status 1 at the first answer that the driver can't read or that contradicts a command."""
import sys
import time

from pycreate2 import Create2


def main():
    port, seconds = sys.argv[1], float(sys.argv[2])
    robot = Create2(port, 115200)
    robot.start()
    robot.safe()
    robot.SCI.ser.reset_input_buffer()
    end, readings, travelled = time.time() + seconds, 0, 0
    while time.time() < end:
        forward = readings % 40 < 20
        robot.drive_direct(100 if forward else -100, 100 if forward else -100)
        sensors = robot.get_sensors()
        if sensors.open_interface_mode not in (2, 1):
            sys.exit("OI mode is %s after safe()" % sensors.open_interface_mode)
        if not (10000 < sensors.voltage < 20000 and 0 < sensors.battery_charge <= sensors.battery_capacity):
            sys.exit("battery reads %s mV, %s of %s mAh" % (sensors.voltage, sensors.battery_charge, sensors.battery_capacity))
        if sensors.velocity_right != (100 if forward else -100):
            sys.exit("the robot's requested velocity is not the one that was sent: %s" % (sensors,))
        travelled += abs(sensors.distance)
        readings += 1
        print("%d mode %d distance %d angle %d" % (readings, sensors.open_interface_mode, sensors.distance, sensors.angle))
    if readings < seconds * 5:
        sys.exit("only %d readings in %s s" % (readings, seconds))
    if travelled < seconds * 50:
        sys.exit("only %d mm travelled in %s s at 100 mm/s" % (travelled, seconds))
    robot.drive_stop()
    print("%d readings, %d mm" % (readings, travelled))


if __name__ == "__main__":
    main()
