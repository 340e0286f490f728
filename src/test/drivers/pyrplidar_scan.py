"""Reads an RPLIDAR with the driver pyrplidar: type and health, then turns, each as a line of "angle:distance"."""
import sys

from pyrplidar import PyRPlidar

port, turns = sys.argv[1], int(sys.argv[2])
lidar = PyRPlidar()
lidar.connect(port=port, baudrate=115200, timeout=3)
lidar.set_motor_pwm(500)
print(lidar.get_info())
print(lidar.get_health())
line = []
for sample in lidar.start_scan()():
    if sample.start_flag and line:
        print(" ".join(line))
        line = []
        turns -= 1
        if turns == 0:
            break
    if sample.distance > 0:
        line.append("%s:%s" % (sample.angle, sample.distance))
lidar.stop()
lidar.set_motor_pwm(0)
lidar.disconnect()
