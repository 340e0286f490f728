"""Finds markers in a picture and computes their poses, like programs with OpenCV.

usage: opencv_markers.py PICTURE FOCAL_LENGTH CX CY SIZE DICTIONARY...

Prints one line per marker: dictionary, number, the nine numbers of its rotation matrix row by row, and its position in
metres. The pose maps the marker's frame (x right, y up, z out of its front) to the camera's (x right, y down, z ahead)."""
import sys

import cv2
import numpy

def find(picture, name):
    how = cv2.aruco.DetectorParameters()
    how.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    how.relativeCornerRefinmentWinSize = 1
    how.cornerRefinementMaxIterations = 100
    how.cornerRefinementMinAccuracy = 0.001
    dictionary = name if name.startswith("DICT_") else "DICT_" + name
    known = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, dictionary))
    corners, numbers, _ = cv2.aruco.ArucoDetector(known, how).detectMarkers(picture)
    return zip(corners, [] if numbers is None else numbers.ravel())


def main():
    picture = cv2.imread(sys.argv[1], cv2.IMREAD_GRAYSCALE)
    focal, cx, cy, size = [float(word) for word in sys.argv[2:6]]
    matrix = numpy.array([[focal, 0, cx], [0, focal, cy], [0, 0, 1]])
    half = size / 2
    square = numpy.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]])
    for name in sys.argv[6:]:
        for corners, number in find(picture, name):
            _, turned, place = cv2.solvePnP(square, corners[0], matrix, None, flags=cv2.SOLVEPNP_IPPE_SQUARE)
            print(name, number, *cv2.Rodrigues(turned)[0].ravel(), *place.ravel())


if __name__ == "__main__":
    main()
