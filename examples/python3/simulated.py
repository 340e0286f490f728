"""A simulated robot with a camera, for programs with OpenCV in Python 3. It is what they need of a robot, so a real one is driven by the same
programs: give them a class of your own in the place of SimulatedRobot, with a period, look(), drive(speed, turn) and stop(), whose Eye has the address
of the real camera."""
import json
import sys
import threading
import time
import urllib.error

try:
    import cv2
except ImportError:
    sys.exit("OpenCV is missing. Install it: python3 -m pip install opencv-python")

from robotlab import Service

SERVER = "http://localhost:8888"


class Eye:
    """A network camera. A thread takes each picture as soon as it comes, so that none waits in a buffer and grows old."""

    def __init__(self, url):
        self.url = url
        self.picture = None
        self.failure = ""
        self.closed = False
        self.changed = threading.Condition()
        self.thread = threading.Thread(target=self._read, daemon=True)
        self.thread.start()

    def _read(self):
        capture = cv2.VideoCapture(self.url)
        good, picture = capture.read()
        while good and not self.closed:
            with self.changed:
                self.picture = picture
                self.changed.notify()
            good, picture = capture.read()
        with self.changed:
            self.failure = "no picture" + (" any more" if capture.isOpened() else "") + " from " + self.url
            self.changed.notify()

    def close(self):
        """Ends the thread, which waits for a picture."""
        self.closed = True
        self.thread.join(5)

    def forget(self):
        """What was seen until now is not answered any more."""
        with self.changed:
            self.picture = None

    def newest(self, patience=60):
        """The newest picture, which has not been answered before: blue, green, red, row by row. Waits for it, at most so many seconds."""
        with self.changed:
            self.changed.wait_for(lambda: self.picture is not None or self.failure, patience)
            picture, self.picture = self.picture, None
        if picture is None:
            sys.exit(self.failure or "no picture for %d s from %s" % (patience, self.url))
        return picture


class SimulatedRobot:
    """Time passes only while it looks: however long the program thinks, and however busy the computer is, the robot does not drive on blindly."""

    def __init__(self, project, camera, track, rate=10, server=SERVER, fast=False):
        """
        project: a bundle, or None for the simulation that runs; camera: its name; track: metres between the left and the right wheels;
        rate: pictures a second; fast: as fast as the computer can, instead of as fast as a real robot
        """
        self.period = 1 / rate
        self.track = track
        self.fast = fast
        self.next = time.monotonic()
        self.sear = Service("sear", server)
        try:
            Service("runtime", server).start("sear", "SEAR")
            if project:
                if self.sear.isSimulating():
                    self.sear.stopSimulation()
                self.sear.loadProject(project)
                self.sear.startSimulation()
            port = self.sear.exportCamera(camera, 0)
        except urllib.error.HTTPError as error:
            sys.exit("SEAR: %s" % json.loads(error.read() or b"null"))
        except urllib.error.URLError as error:
            sys.exit("There is no SEAR at %s (%s). Start it with its tabs: sear" % (server, error.reason))
        if not port:
            sys.exit("SEAR's tab says why there is no camera " + camera)
        self.eye = Eye("http://localhost:%d/stream.mjpg" % port)
        self.eye.newest()                       # OpenCV looks at some pictures before it answers the first one
        self.lock_step = self.sear.isLockStep()
        self.sear.setLockStep(True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """The robot stands, and time passes again as it did before."""
        self.stop()
        self.sear.setLockStep(self.lock_step)
        self.eye.close()

    def look(self):
        """Lets the time of a picture pass, and answers the newest one, not one from before that came meanwhile."""
        self.eye.forget()
        self.sear.simSleep(self.period)
        if not self.fast:
            time.sleep(max(0, self.next - time.monotonic()))
            self.next = time.monotonic() + self.period
        return self.eye.newest()

    def drive(self, speed, turn):
        """Until the next order: metres a second ahead, and radians a second to the left."""
        aside = turn * self.track / 2
        self.sear.setWheelSpeeds(float(speed - aside), float(speed + aside))

    def stop(self):
        """Stands still when it returns."""
        self.drive(0, 0)
        self.sear.simSleep(1.0)
