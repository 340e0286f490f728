"""Docks with a camera and an ArUco marker, using OpenCV. It turns until it sees the marker and computes its pose from the
corners. Then it drives to the marker's axis, follows the axis to the dock, and stops a few centimetres in front of it.

    sear                                # in one terminal
    python3 docking.py                  # in another, in this folder; --show shows the picture
"""
import argparse
from math import atan2, cos, degrees, hypot, pi, radians, sin, tan

from simulated import SERVER, SimulatedRobot
import cv2
import numpy

DICTIONARY, NUMBER, SIZE = cv2.aruco.DICT_4X4_50, 7, 0.2         # the dock's marker; width of its black square, metres
FIELD_OF_VIEW = 62.2        # horizontal field of view of the camera, degrees
TRACK = 0.235               # metres between the wheels
FRONT, AXLE = 0.27, 0.1     # distance of the camera to the robot's front (ahead) and to its axle, metres
GAP = 0.04                  # final gap between robot and dock, metres
FASTEST, SLOWEST = 0.3, 0.03     # metres per second
TURN = 0.8                  # maximum turn rate, radians per second
SURE = 120                  # pixels: a marker at least this wide gives a reliable orientation in one picture
PATIENCE = 1                # seconds without the marker: first it waits, then it backs up, then it searches
LIMIT = 120                 # seconds after which it gives up


class MarkerFinder:
    """Finds the marker's pose with a camera without distortion."""

    def __init__(self, shape):
        height, width = shape[:2]
        focal = width / 2 / tan(radians(FIELD_OF_VIEW / 2))      # real camera: use calibrateCamera's result, and its distortion below
        self.matrix = numpy.array([[focal, 0, (width - 1) / 2], [0, focal, (height - 1) / 2], [0, 0, 1]])
        self.distortion = numpy.zeros(5)
        how = cv2.aruco.DetectorParameters()
        how.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
        how.minDistanceToBorder = 0                              # near the dock the marker fills the picture
        self.detector = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(DICTIONARY), how)
        half = SIZE / 2
        self.square = numpy.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]])
        self.side = None

    def find(self, picture):
        """
        Returns the camera's pose: metres in front of the marker, metres to the right of its middle as seen facing it, and
        radians by which the camera looks to the left of the dock; None without the marker. Draws the result.
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
        Returns the two possible poses of a small square, each with its error in pixels. The method for squares has an error
        of a degree if the camera faces the marker, so each pose is refined iteratively.
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
        Chooses the pose that fits the earlier pictures, unless the other one fits the corners much better. Distance and
        direction of a marker are precise from afar, the side from which the camera sees it is not. The side is therefore a
        mean over many pictures from afar, and over few nearby.
        """
        sides = []
        for turn, place, _ in ways:
            right, _, before = (-cv2.Rodrigues(turn)[0].T @ place).ravel()       # in the marker's frame, z pointing out of its front
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
    """Returns speed and turn rate towards a point on the marker's axis, halfway to the dock; slower near the dock."""
    to_go = before - FRONT - GAP
    ahead = max(0.4, to_go / 2)                                  # metres from the axle to that point, along the marker's axis
    off = atan2(right - AXLE * sin(left), ahead) - left          # radians to the left of the robot's heading
    speed = min(FASTEST, max(SLOWEST, 0.6 * to_go)) * max(0, 1 - abs(off) / radians(40))
    return speed, max(-TURN, min(TURN, 1.5 * off))


def main():
    parser = argparse.ArgumentParser(description="docks with a camera and a marker")
    parser.add_argument("--server", default=SERVER, help="address of SEAR's pages")
    parser.add_argument("--running", action="store_true", help="use the running simulation instead of examples/dock.sear")
    parser.add_argument("--fast", action="store_true", help="run as fast as possible")
    parser.add_argument("--show", action="store_true", help="show the picture")
    parser.add_argument("--save", metavar="FILE", help="save the first picture with the marker, and the detected pose")
    asked = parser.parse_args()

    project = None if asked.running else "examples/dock.sear"
    with SimulatedRobot(project, "eye", TRACK, server=asked.server, fast=asked.fast) as robot:
        finder = MarkerFinder(robot.look().shape)
        before = None               # distance to the marker when last seen, metres
        side = 1                    # side where it was last seen: 1 left, -1 right
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
                    raise SystemExit("Marker %d is not in sight." % NUMBER)
        robot.stop()
        robot.look()                # may be from before the stop
        found = finder.find(robot.look())
        if not found:
            raise SystemExit("The marker is out of sight.")
        print("Docked: %.3f m before the dock, %.3f m beside its middle, turned by %.1f degrees." % (found[0] - FRONT, abs(found[1]),
            abs(degrees(found[2]))))


if __name__ == "__main__":
    main()
