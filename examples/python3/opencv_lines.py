"""Follows a line of dark tape by a camera, with OpenCV: what is dark is cut out, its pixels are looked up on the floor, and the robot steers to where
the line is a little ahead.

    sear                                # in one terminal
    python3 opencv_lines.py             # in another, in this folder; --show shows what it sees
"""
import argparse
from math import cos, radians, sin, tan

from simulated import SERVER, SimulatedRobot
import cv2
import numpy

# the camera: degrees from left to right and down, metres above the floor and ahead of the axle
FIELD_OF_VIEW, DOWN, HEIGHT, AHEAD = 60, 40, 0.085, 0.04
TRACK = 0.12                # metres between the wheels
SPEED = 0.15                # metres a second
LOOK_AHEAD = 0.13           # metres from the axle to where it steers
BAND = 0.02                 # metres before and behind that
DARK = 0.5                  # of what is bright in the picture
SMALLEST = 150              # pixels of what may be a line
PATIENCE = 2                # seconds for which it looks for a lost line


def floor_of(shape):
    """Where on the floor each pixel is: metres ahead of the axle and to the left, row by row; infinite from the horizon on."""
    height, width = shape[:2]
    focal = width / 2 / tan(radians(FIELD_OF_VIEW / 2))
    rows, columns = numpy.mgrid[:height, :width]
    y = (rows - (height - 1) / 2) / focal
    x = (columns - (width - 1) / 2) / focal
    down = sin(radians(DOWN)) + y * cos(radians(DOWN))
    far = numpy.where(down > 0.01, HEIGHT / numpy.maximum(down, 0.01), numpy.inf)
    return AHEAD + far * (cos(radians(DOWN)) - y * sin(radians(DOWN))), -far * x


def line_of(picture):
    """The contour of the largest dark thing in a picture; None if there is none."""
    grey = cv2.GaussianBlur(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), (5, 5), 0)
    _, dark = cv2.threshold(grey, DARK * numpy.percentile(grey, 90), 255, cv2.THRESH_BINARY_INV)
    contours, _ = cv2.findContours(dark, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    largest = max(contours, key=cv2.contourArea, default=None)
    return None if largest is None or cv2.contourArea(largest) < SMALLEST else largest


def aim(contour, floor, shape):
    """Where the line is a little ahead: metres ahead and to the left; None if it is not there."""
    mask = numpy.zeros(shape[:2], numpy.uint8)
    cv2.drawContours(mask, [contour], -1, 255, cv2.FILLED)
    ahead, left = floor
    there = (mask > 0) & (abs(numpy.hypot(ahead, left) - LOOK_AHEAD) < BAND)
    return (ahead[there].mean(), left[there].mean()) if there.any() else None


def main():
    parser = argparse.ArgumentParser(description="follows a line by a camera")
    parser.add_argument("--server", default=SERVER, help="address of SEAR's pages")
    parser.add_argument("--running", action="store_true", help="in the simulation that runs, not in examples/line.sear")
    parser.add_argument("--metres", type=float, default=5.4, help="how far it follows the line")
    parser.add_argument("--fast", action="store_true", help="as fast as the computer can")
    parser.add_argument("--show", action="store_true", help="shows what it sees")
    parser.add_argument("--save", metavar="FILE", help="saves the last picture, with what was found in it")
    asked = parser.parse_args()

    project = None if asked.running else "examples/line.sear"
    with SimulatedRobot(project, "eye", TRACK, server=asked.server, fast=asked.fast) as robot:
        floor = floor_of(robot.look().shape)
        side = 1                # where the line was seen last: 1 to the left, -1 to the right
        way = lost = pictures = unseen = 0
        while way < asked.metres:
            picture = robot.look()
            pictures += 1
            contour = line_of(picture)
            goal = None if contour is None else aim(contour, floor, picture.shape)
            if goal:
                ahead, left = goal
                side = 1 if left > 0 else -1
                unseen = 0
                robot.drive(SPEED, SPEED * 2 * left / (ahead ** 2 + left ** 2))     # on a circle through the goal
                way += SPEED * robot.period
                cv2.drawContours(picture, [contour], -1, (0, 255, 0), 2)
            else:
                lost += 1
                unseen += robot.period
                robot.drive(0, side)
                if unseen > PATIENCE:
                    raise SystemExit("The line is lost after %.2f m." % way)
            if asked.show:
                cv2.imshow("opencv_lines.py", picture)
                cv2.waitKey(1)
        if asked.save:
            cv2.imwrite(asked.save, picture)
        print("Followed the line for %.2f m: it was lost in %d of %d pictures." % (way, lost, pictures))


if __name__ == "__main__":
    main()
