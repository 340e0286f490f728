"""Docks by a camera and a marker of ArUco, with OpenCV: looks round for the marker, finds out by its corners where it is, drives to the line that
stands upright on it, along this line to the dock, and stops a few centimetres before it.

    sear                                # in one terminal
    python3 docking.py                  # in another, in this folder; --show shows what it sees
"""
import argparse
from math import atan2, cos, degrees, hypot, pi, radians, sin, tan

from simulated import SERVER, SimulatedRobot
import cv2
import numpy

DICTIONARY, NUMBER, SIZE = cv2.aruco.DICT_4X4_50, 7, 0.2         # the dock's marker; metres that its black square is wide
FIELD_OF_VIEW = 62.2        # degrees of the camera from left to right
TRACK = 0.235               # metres between the wheels
FRONT, AXLE = 0.27, 0.1     # metres from the camera ahead to the robot's front and to its axle
GAP = 0.04                  # metres between the robot and the dock in the end
FASTEST, SLOWEST = 0.3, 0.03     # metres a second
TURN = 0.8                  # radians a second at most
SURE = 120                  # pixels; where the marker is as wide as that, one picture is enough to believe how it is turned
PATIENCE = 1                # seconds for which it stands without the marker, and then goes back, before it looks round
LIMIT = 120                 # seconds after which it gives up


class MarkerFinder:
    """Where the marker is, seen by a camera without distortion."""

    def __init__(self, shape):
        height, width = shape[:2]
        focal = width / 2 / tan(radians(FIELD_OF_VIEW / 2))      # of a real camera: what calibrateCamera says, and its distortion below
        self.matrix = numpy.array([[focal, 0, (width - 1) / 2], [0, focal, (height - 1) / 2], [0, 0, 1]])
        self.distortion = numpy.zeros(5)
        how = cv2.aruco.DetectorParameters()
        how.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
        how.minDistanceToBorder = 0                              # near the dock the marker's paper is as large as the picture
        self.detector = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(DICTIONARY), how)
        half = SIZE / 2
        self.square = numpy.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]])
        self.side = None

    def find(self, picture):
        """
        Where the camera is: metres before the marker, metres to the right of its middle for one who looks at it, and radians by which it looks to the
        left of straight at the dock; None if the marker is not seen. Draws what it finds.
        """
        corners, numbers, _ = self.detector.detectMarkers(picture)
        if numbers is None or NUMBER not in numbers:
            return None
        cv2.aruco.drawDetectedMarkers(picture, corners, numbers)
        own = corners[list(numbers.ravel()).index(NUMBER)]
        turn, place = self.choose(self.ways(own), cv2.arcLength(own, True) / 4)
        x, _, z = place.ravel()                                  # to the right and ahead of the camera
        cv2.drawFrameAxes(picture, self.matrix, self.distortion, turn, place, SIZE / 2)
        far = hypot(x, z)
        return far * cos(self.side), far * sin(self.side), atan2(x, z) + self.side

    def ways(self, corners):
        """
        The two ways in which a small square may be turned and placed to look like that, each with its error in pixels. The method for squares is
        wrong by a degree where the camera looks straight at the marker, so each is made better step by step.
        """
        _, turns, places, _ = cv2.solvePnPGeneric(self.square, corners, self.matrix, self.distortion, flags=cv2.SOLVEPNP_IPPE_SQUARE)
        ways = []
        for turn, place in zip(turns, places):
            turn, place = cv2.solvePnPRefineLM(self.square, corners, self.matrix, self.distortion, turn, place)
            seen, _ = cv2.projectPoints(self.square, turn, place, self.matrix, self.distortion)
            ways.append((turn, place, numpy.sqrt(((seen.reshape(-1, 2) - corners.reshape(-1, 2)) ** 2).mean())))
        return ways

    def choose(self, ways, width):
        """
        Of the two ways the one that fits to the pictures before, unless the other one fits much better to the corners. How far away and in which
        direction a marker is, is well known from afar; on which side of it the camera is, is not: there the mean of many pictures is taken, near by
        that of few.
        """
        sides = []
        for turn, place, _ in ways:
            right, _, before = (-cv2.Rodrigues(turn)[0].T @ place).ravel()       # in the marker's frame, z out of its front
            sides.append(atan2(right, before))
        seen = [i for i, side in enumerate(sides) if abs(side) < pi / 2] or [0]  # from its front
        best = min(seen, key=lambda i: ways[i][2])
        if self.side is None:
            self.side = sides[best]
        if all(ways[i][2] < 4 * ways[best][2] for i in seen):
            best = min(seen, key=lambda i: abs(sides[i] - self.side))
        self.side += min(1, (width / SURE) ** 2) * (sides[best] - self.side)
        return ways[best][:2]


def steer(before, right, left):
    """Speed and turn to a point on the marker's axis, half the way to it, and more slowly the nearer the dock is."""
    to_go = before - FRONT - GAP
    ahead = max(0.4, to_go / 2)                                  # metres from the axle to that point, along the marker's axis
    off = atan2(right - AXLE * sin(left), ahead) - left          # radians to the left of where it looks
    speed = min(FASTEST, max(SLOWEST, 0.6 * to_go)) * max(0, 1 - abs(off) / radians(40))
    return speed, max(-TURN, min(TURN, 1.5 * off))


def main():
    parser = argparse.ArgumentParser(description="docks by a camera and a marker")
    parser.add_argument("--server", default=SERVER, help="address of SEAR's pages")
    parser.add_argument("--running", action="store_true", help="in the simulation that runs, not in examples/dock.sear")
    parser.add_argument("--fast", action="store_true", help="as fast as the computer can")
    parser.add_argument("--show", action="store_true", help="shows what it sees")
    parser.add_argument("--save", metavar="FILE", help="saves the picture in which it has found the marker first, with what was found in it")
    asked = parser.parse_args()

    project = None if asked.running else "examples/dock.sear"
    with SimulatedRobot(project, "eye", TRACK, server=asked.server, fast=asked.fast) as robot:
        finder = MarkerFinder(robot.look().shape)
        before = None               # metres to the dock's marker, when it was seen last
        side = 1                    # where it was seen last: 1 to the left, -1 to the right
        unseen = 2 * PATIENCE       # seconds
        searched = 0                # radians
        time = 0                    # seconds
        while before is None or before > FRONT + GAP:
            picture = robot.look()
            time += robot.period
            if time > LIMIT:
                raise SystemExit("Not docked in %d s." % LIMIT)
            found = finder.find(picture)
            if asked.show:
                cv2.imshow("docking.py", picture)
                cv2.waitKey(1)
            if found:
                if before is None:
                    print("The marker is %.2f m away." % hypot(*found[:2]))
                    if asked.save:
                        cv2.imwrite(asked.save, picture)
                before, right, left = found
                side = 1 if atan2(right, before) > left else -1
                unseen = searched = 0
                robot.drive(*steer(before, right, left))
                continue
            unseen += robot.period
            if unseen < PATIENCE:
                robot.drive(0, 0)
            elif unseen < 2 * PATIENCE:
                robot.drive(-0.1, 0)
            else:
                robot.drive(0, side * TURN)
                searched += TURN * robot.period
                if searched > 3 * pi:
                    raise SystemExit("There is no marker %d to be seen." % NUMBER)
        robot.stop()
        robot.look()                # may be one that was on its way when it came to stand
        found = finder.find(robot.look())
        if not found:
            raise SystemExit("The marker is not to be seen any more.")
        print("Docked: %.3f m before the dock, %.3f m beside its middle, turned by %.1f degrees." % (found[0] - FRONT, abs(found[1]),
            abs(degrees(found[2]))))


if __name__ == "__main__":
    main()
