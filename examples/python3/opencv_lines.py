"""Follows a line of dark tape with a camera, using OpenCV. It segments dark pixels, projects them onto the floor, and steers
towards the line a little ahead.

    sear                                # in one terminal
    python3 opencv_lines.py             # in another, in this folder; --show shows the picture
"""
import argparse
from math import cos, radians, sin, tan

from simulated import SERVER, SimulatedRobot
import cv2
import numpy

# the camera: horizontal field of view and pitch in degrees, height above the floor and distance ahead of the axle in
# metres
FIELD_OF_VIEW, DOWN, HEIGHT, AHEAD = 60, 40, 0.085, 0.04
TRACK = 0.12                # metres between the wheels
SPEED = 0.15                # metres per second
LOOK_AHEAD = 0.13           # distance from the axle to the steering point, metres
BAND = 0.02                 # half depth of the band around that distance, metres
DARK = 0.5                  # threshold relative to the bright parts of the picture
SMALLEST = 150              # minimum area of a line, pixels
PATIENCE = 2                # search time for a lost line, seconds


def floor_of(shape):
    """Returns the floor position of each pixel: metres ahead of the axle and to the left, row by row; infinite above
    the horizon."""
    height, width = shape[:2]
    focal = width / 2 / tan(radians(FIELD_OF_VIEW / 2))
    rows, columns = numpy.mgrid[:height, :width]
    y = (rows - (height - 1) / 2) / focal
    x = (columns - (width - 1) / 2) / focal
    down = sin(radians(DOWN)) + y * cos(radians(DOWN))
    far = numpy.where(down > 0.01, HEIGHT / numpy.maximum(down, 0.01), numpy.inf)
    return AHEAD + far * (cos(radians(DOWN)) - y * sin(radians(DOWN))), -far * x


def line_of(picture):
    """Returns the contour of the largest dark area in a picture; None if there is none."""
    grey = cv2.GaussianBlur(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), (5, 5), 0)
    _, dark = cv2.threshold(grey, DARK * numpy.percentile(grey, 90), 255, cv2.THRESH_BINARY_INV)
    contours, _ = cv2.findContours(dark, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    largest = max(contours, key=cv2.contourArea, default=None)
    return None if largest is None or cv2.contourArea(largest) < SMALLEST else largest


def aim(contour, floor, shape):
    """Returns the line's position a little ahead: metres ahead and to the left; None without a line there."""
    mask = numpy.zeros(shape[:2], numpy.uint8)
    cv2.drawContours(mask, [contour], -1, 255, cv2.FILLED)
    ahead, left = floor
    there = (mask > 0) & (abs(numpy.hypot(ahead, left) - LOOK_AHEAD) < BAND)
    return (ahead[there].mean(), left[there].mean()) if there.any() else None


def main():
    parser = argparse.ArgumentParser(description="follows a line with a camera")
    parser.add_argument("--server", default=SERVER, help="address of SEAR's pages")
    parser.add_argument("--running", action="store_true", help="use the running simulation instead of examples/line.sear")
    parser.add_argument("--metres", type=float, default=5.4, help="distance to follow the line")
    parser.add_argument("--fast", action="store_true", help="run as fast as possible")
    parser.add_argument("--show", action="store_true", help="show the picture")
    parser.add_argument("--save", metavar="FILE", help="save the last picture with the detected line")
    asked = parser.parse_args()

    project = None if asked.running else "examples/line.sear"
    with SimulatedRobot(project, "eye", TRACK, server=asked.server, fast=asked.fast) as robot:
        floor = floor_of(robot.look().shape)
        side = 1                # side where the line was last seen: 1 left, -1 right
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
