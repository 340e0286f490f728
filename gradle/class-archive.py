# Loads the classes that scripts use, for class-archive.gradle to archive. Arguments: a project, the port of the tabs, the
# file for the folder and the Java of the archive.
import json, math, os, random, re, sys, threading, time
from java.lang import System
from java.net import URL
from org.SEAR.POJOs import *

project, port, use = sys.argv[1:]


class Counter(object):
    """Jython has separate classes for each kind of statement and expression."""
    count = 0

    def add(self, *values, **named):
        for index, value in enumerate(values):
            if value is None or not value > 0 and index != 1:
                continue
            elif isinstance(value, float):
                self.count += int(round(value)) % 7
            else:
                self.count = self.count * 2 - ~index // 3 if index else -self.count
        return self.count, [named.get(key, 0.5) ** 2 for key in sorted(named) if key in ("a", "b")]

    @property
    def text(self):
        return "%s %.2f %5d %s" % ("count", self.count / 3.0, self.count, u"\xb0") + "{} {:.1f}".format(self.count, 2.5) + repr((1, 2L, "x"))


def numbers(end):
    number = 0
    while True:
        number += 1
        if number > end:
            break
        yield number


def attempt(work):
    try:
        return work()
    except (KeyError, ZeroDivisionError) as error:
        return str(error)
    else:
        pass
    finally:
        pass


counter = Counter()
counter.add(1, 2.0, 3, None, a=1, b=2)
print counter.text, attempt(lambda: {"a": 1}["b"]), max(numbers(3)), sum(x * x for x in xrange(4)), [1, 2, 3][-2:], {1, 2} | set([3])
print json.dumps({"a": [1.5, True, None]}), math.hypot(3, 4), random.Random(1).gauss(0, 1), time.time() > 0, os.path.basename("a/b"), re.sub("a", "b", "aa")
exec "counter.count = 5" in globals()
assert counter.count == 5, "never"
del counter.count

heard = threading.Event()


def onScan(value):
    global last
    last = value
    heard.set()


sear = Runtime.start("sear", "SEAR")
sear.newProject()
Floor("floor", 10, 10)
box = Box("box", 1, 1, 1, 2)
box.move(2, 0.5, 0)
robot = Robots.create("first", "/dev/user", "/dev/uart")
robot.addComponent(LIDAR("scanner", 8, 180, 0.5, 0, 0.15, 0.1))
sear.startSimulation()
sear.simSleep(0.1)
sear.stopSimulation()

sear.loadProject(project)
sear.startSimulation()
sear.driveStraight(0.2)
sear.simSleep(0.5)
print list(sear.getLidarResult("myLidar"))[:3], sear.getPose("myRoomba"), sear.getTime(), "%.2f" % sear.getDistanceResult("frontPing")
thread = threading.Thread(target=lambda: sear.simSleep(0.1))
thread.start()
thread.join()
lidar = Runtime.start("lidar", "LIDAR")
lidar.connect("/dev/SEAR_LIDAR_01")
lidar.addListener("publishLidarData", python.getName(), "onScan")
lidar.singleScan()
gps = Runtime.start("gps", "GPS")
gps.connect("/dev/SEAR_GPS_01")
sear.simSleep(0.5)
for path in ("", "api/service/sear/getTime", "api/service"):
    try:
        URL("http://localhost:%s/%s" % (port, path)).openStream().close()
    except IOError:
        pass    # some answers are errors, whose classes are needed, too
sear.stopSimulation()
with open(use, "w") as file:
    file.write(System.getProperty("sear.home") + " " + System.getProperty("java.home"))
