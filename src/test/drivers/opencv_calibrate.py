"""Calibrates a camera from pictures of a chessboard, like programs with OpenCV.

usage: opencv_calibrate.py CORNERS_IN_A_ROW CORNERS_IN_A_COLUMN PICTURE...

Prints the number of pictures with a chessboard, and on the next line fx, fy, cx, cy, k1, k2 and the RMS residual, pixels."""
import sys

import cv2
import numpy


def main():
    columns, rows = int(sys.argv[1]), int(sys.argv[2])
    board = numpy.zeros((columns * rows, 3), numpy.float32)
    board[:, :2] = numpy.mgrid[0:columns, 0:rows].T.reshape(-1, 2)
    found = []
    for path in sys.argv[3:]:
        picture = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
        good, corners = cv2.findChessboardCornersSB(picture, (columns, rows), flags=cv2.CALIB_CB_EXHAUSTIVE | cv2.CALIB_CB_ACCURACY)
        if good:
            found.append(corners)
    print(len(found))
    flags = cv2.CALIB_FIX_K3 | cv2.CALIB_ZERO_TANGENT_DIST
    left, matrix, lens, _, _ = cv2.calibrateCamera([board] * len(found), found, picture.shape[::-1], None, None, flags=flags)
    lens = lens.ravel()
    print(matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], lens[0], lens[1], left)


if __name__ == "__main__":
    main()
