"""Reads a depth camera's picture over the network with OpenCV.

usage: opencv_depth.py URL

Prints the type and the size of the picture, and the depth in the middle, millimetres."""
import sys
import urllib.request

import cv2
import numpy


def main():
    with urllib.request.urlopen(sys.argv[1]) as answer:
        depths = cv2.imdecode(numpy.frombuffer(answer.read(), numpy.uint8), cv2.IMREAD_UNCHANGED)
    print("%s %d x %d" % (depths.dtype, depths.shape[1], depths.shape[0]))
    print(depths[depths.shape[0] // 2, depths.shape[1] // 2])


if __name__ == "__main__":
    main()
