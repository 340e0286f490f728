"""Reads an RPLIDAR with the driver rplidar-roboticia: its type and health, then some turns, one a line of "angle:distance"."""
import sys

import rplidar
import serial

port, kind, turns = sys.argv[1], sys.argv[2], int(sys.argv[3])
# The driver switches the motor by DTR, which a pseudo-terminal doesn't have: through RFC 2217 it is taken. So pyserial opens an address here.
rplidar.serial.Serial = serial.serial_for_url
lidar = rplidar.RPLidar(port)
print(lidar.get_info())
print(lidar.get_health())
for number, scan in enumerate(lidar.iter_scans(scan_type=kind, max_buf_meas=False)):
    print(" ".join("%s:%s" % (angle, distance) for quality, angle, distance in scan))
    if number + 1 == turns:
        break
lidar.stop()
lidar.stop_motor()
lidar.disconnect()
