"""A simulated robot with a camera, for OpenCV programs in Python 3. The programs can drive a real robot, too: replace
SimulatedRobot by your own class with period, look(), drive(speed, turn) and stop(), and give its Eye the address of the
real camera."""
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
    """A network camera. A thread reads each picture immediately, so that no picture waits in a buffer."""

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
        """Ends the thread."""
        self.closed = True
        self.thread.join(5)

    def forget(self):
        """Drops the current picture."""
        with self.changed:
            self.picture = None

    def newest(self, patience=60):
        """Returns the newest picture not returned before: blue, green, red, row by row. Waits for it up to patience
        seconds."""
        with self.changed:
            self.changed.wait_for(lambda: self.picture is not None or self.failure, patience)
            picture, self.picture = self.picture, None
        if picture is None:
            sys.exit(self.failure or "no picture for %d s from %s" % (patience, self.url))
        return picture


class SimulatedRobot:
    """Simulated time passes only in look(): a slow program or a busy computer never lets the robot drive on blindly."""

    def __init__(self, project, camera, track, rate=10, server=SERVER, fast=False):
        """
        project: a bundle, or None for the running simulation; camera: its name; track: distance of the left and right wheels,
        metres; rate: pictures per second; fast: as fast as possible instead of in real time
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
            sys.exit("See SEAR's tab for the reason why there is no camera " + camera)
        self.eye = Eye("http://localhost:%d/stream.mjpg" % port)
        self.eye.newest()                       # OpenCV reads some pictures before it returns the first one
        self.lock_step = self.sear.isLockStep()
        self.sear.setLockStep(True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Stops the robot and restores the previous time mode."""
        self.stop()
        self.sear.setLockStep(self.lock_step)
        self.eye.close()

    def look(self):
        """Lets the time of one picture pass and returns the newest picture, taken after that."""
        self.eye.forget()
        self.sear.simSleep(self.period)
        if not self.fast:
            time.sleep(max(0, self.next - time.monotonic()))
            self.next = time.monotonic() + self.period
        return self.eye.newest()

    def drive(self, speed, turn):
        """Drives until the next command: metres per second ahead, and radians per second to the left."""
        aside = turn * self.track / 2
        self.sear.setWheelSpeeds(float(speed - aside), float(speed + aside))

    def stop(self):
        """Stops the robot; returns when it is at rest."""
        self.drive(0, 0)
        self.sear.simSleep(1.0)
