"""Reads a network camera like programs with OpenCV.

usage: opencv_stream.py URL PICTURES

Prints OpenCV's version, the size of the pictures, and the mean blue, green and red of each, rounded."""
import sys

import cv2


def main():
    print(cv2.__version__)
    capture = cv2.VideoCapture(sys.argv[1])
    if not capture.isOpened():
        sys.exit("OpenCV does not open " + sys.argv[1])
    print("%d x %d" % (capture.get(cv2.CAP_PROP_FRAME_WIDTH), capture.get(cv2.CAP_PROP_FRAME_HEIGHT)))
    for _ in range(int(sys.argv[2])):
        good, picture = capture.read()
        if not good:
            sys.exit("the stream has ended")
        print("%d %d %d" % tuple(round(value) for value in cv2.mean(picture)[:3]))
    capture.release()


if __name__ == "__main__":
    main()
