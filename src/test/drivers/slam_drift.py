"""Follows a robot by KISS-ICP, from scans that slam_drive.py has written.

usage: slam_drift.py run.txt

Prints the largest distance of a rolling scan's points from the surfaces that they hit, metres, if each is placed by the
true pose at its time. Then, per kind of scan and with and without undoing the motion within scans, the error at the
end, metres and degrees."""
import math
import sys

import numpy
from kiss_icp.config import KISSConfig
from kiss_icp.kiss_icp import KissICP

BEAMS = 360
RANGE = 12
TURN = 0.1                          # seconds
ANGLES = numpy.radians(numpy.arange(BEAMS) - 180.0)


def read(path):
    boxes, poses, scans = [], [], {"instant": [], "rolling": []}
    with open(path) as lines:
        for line in lines:
            kind, *numbers = line.split()
            numbers = numpy.array(numbers, float)
            {"box": boxes, "pose": poses}.get(kind, scans.get(kind)).append(numbers)
    return boxes, numpy.array(poses), scans


def pose(poses, time):
    """Returns ROS' x, y and yaw."""
    yaw = numpy.unwrap(numpy.radians(poses[:, 3]))
    return tuple(numpy.interp(time, poses[:, 0], values) for values in (poses[:, 2], poses[:, 1], yaw))


def distance(boxes, x, y):
    """Returns the distance of points from the nearest box's surface."""
    least = numpy.full(x.shape, math.inf)
    for length, width, north, east, turn in boxes:
        turn = math.radians(turn)
        along = numpy.abs((y - north) * math.cos(turn) - (x - east) * math.sin(turn)) - length / 2
        across = numpy.abs((y - north) * math.sin(turn) + (x - east) * math.cos(turn)) - width / 2
        outside = numpy.hypot(numpy.maximum(along, 0), numpy.maximum(across, 0))
        least = numpy.minimum(least, numpy.abs(outside + numpy.minimum(numpy.maximum(along, across), 0)))
    return least


def farthest(boxes, poses, scans):
    worst = 0
    for scan in scans:
        hits = scan[1:] < RANGE
        x, y, yaw = pose(poses, scan[0] - numpy.arange(BEAMS - 1, -1, -1) * TURN / BEAMS)
        x = x + scan[1:] * numpy.cos(yaw + ANGLES)
        y = y + scan[1:] * numpy.sin(yaw + ANGLES)
        worst = max(worst, distance(boxes, x[hits], y[hits]).max())
    return worst


def drift(poses, scans, undo):
    config = KISSConfig()
    config.data.max_range = RANGE - 0.1
    config.data.deskew = undo
    config.mapping.voxel_size = 0.1
    config.registration.max_num_threads = 1
    config.adaptive_threshold.initial_threshold = 0.5
    config.adaptive_threshold.min_motion_th = 0.01
    slam = KissICP(config)
    x, y, yaw = pose(poses, poses[0, 0])
    start = numpy.eye(4)
    start[:2, :2] = [[math.cos(yaw), -math.sin(yaw)], [math.sin(yaw), math.cos(yaw)]]
    start[:2, 3] = x, y
    for scan in scans:
        points = numpy.stack([scan[1:] * numpy.cos(ANGLES), scan[1:] * numpy.sin(ANGLES), 0 * ANGLES], 1)
        slam.register_frame(points, numpy.arange(BEAMS) / (BEAMS - 1.0))
    found = start @ slam.last_pose
    x, y, yaw = pose(poses, scans[-1][0])
    turned = math.remainder(math.atan2(found[1, 0], found[0, 0]) - yaw, 2 * math.pi)
    return math.hypot(found[0, 3] - x, found[1, 3] - y), abs(math.degrees(turned))


def main():
    boxes, poses, scans = read(sys.argv[1])
    print("%.5f" % farthest(boxes, poses, scans["rolling"]))
    for kind in ("rolling", "instant"):
        for undo in (True, False):
            print("%.4f %.3f" % drift(poses, scans[kind], undo))


if __name__ == "__main__":
    main()
