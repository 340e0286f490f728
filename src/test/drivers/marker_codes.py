"""Writes OpenCV's codes of markers in the form that SEAR reads.

usage: marker_codes.py FOLDER

One file for each family that is not part of another: one line per marker, hexadecimal, one bit per cell, row by row from the
top left, 1 is white."""
import os
import sys

import cv2

FAMILIES = {"DICT_4X4": cv2.aruco.DICT_4X4_1000, "DICT_5X5": cv2.aruco.DICT_5X5_1000, "DICT_6X6": cv2.aruco.DICT_6X6_1000,
            "DICT_7X7": cv2.aruco.DICT_7X7_1000, "APRILTAG_36h11": cv2.aruco.DICT_APRILTAG_36h11}


def main():
    for name, number in FAMILIES.items():
        family = cv2.aruco.getPredefinedDictionary(number)
        cells = family.markerSize
        with open(os.path.join(sys.argv[1], name + ".txt"), "w") as out:
            for one in range(len(family.bytesList)):
                picture = cv2.aruco.generateImageMarker(family, one, cells + 2)[1:-1, 1:-1]
                bits = "".join("1" if value else "0" for value in picture.flatten())
                out.write("%0*x\n" % ((len(bits) + 3) // 4, int(bits, 2)))


if __name__ == "__main__":
    main()
