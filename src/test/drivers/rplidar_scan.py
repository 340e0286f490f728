"""Reads an RPLIDAR with the driver rplidar-roboticia: type and health, then turns, each as a line of "angle:distance"."""
import sys

import rplidar

port, kind, turns = sys.argv[1], sys.argv[2], int(sys.argv[3])
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
