#!/usr/bin/env python3
"""Calls of the Python 3 package, with Java in the process or in another one. Prints results that must be the same both ways."""
import numpy

import sear as package
from java.lang import IllegalArgumentException, IllegalStateException
from org.SEAR.POJOs import Box, Distance, Floor, LIDAR, Robots


def refused(kinds, words, call, *arguments, **named):
    """Checks that a call raises an error with these words."""
    try:
        call(*arguments, **named)
    except kinds[0] as error:
        assert all(isinstance(error, kind) for kind in kinds), type(error).__mro__
        assert words in str(error), str(error)
        assert "java." not in str(error), str(error)
        return
    raise AssertionError("%s was not refused" % words)


robots = Runtime.start("robots", "SEAR")
assert Runtime.getService("robots") == robots and hash(Runtime.getService("robots")) == hash(robots)
refused((IllegalStateException, RuntimeError), "no simulation runs: startSimulation() first", robots.getTime)

robots.setLockStep(True)
robots.newProject()
Floor("ground", 20, 20)
wall = Box("wall", 0.2, numpy.float64(6), 1.5)
wall.move(3, 0.75, 0)
assert wall.name == "wall" and wall.getWidth() == 6.0 and type(wall.getWidth()) is float
wall.setColor("red")
assert wall.color == "#ff0000", wall.color
rover = Robots.rover("rover")
rover.rotate(0, 90, 0)
rover.addComponent(Distance("ping", "PING)))", 0, 0.1, 0.15, 0, 0, 0))
rover.addComponent(LIDAR("scanner", 8, 180, 1, 0, 0.3, 0))
refused((TypeError,), "Box can't be called with (str, int)\nlegal: Box(name, length, width, height)\n", Box, "crate", 1)
refused((IllegalArgumentException, ValueError), "mass is -1, legal: ", Box, "crate", 1, 1, 1, -1)
refused((TypeError,), "Box: arguments have no names: write only their values, in this order\nlegal: Box(name, ", Box, "crate", length=1)
refused((TypeError,), "in this order\nlegal: getPose(name)", robots.getPose, name="rover")
refused((TypeError,), "in this order\nlegal: simSleep(seconds)", robots.simSleep, seconds=2)
robots.setGroundVisible(False)
robots.startSimulation()
robots.simSleep(1)

scan = robots.getLidarResult("scanner")
assert scan.dtype == numpy.float32 and scan.shape == (181,), (scan.dtype, scan.shape)
pose = robots.getPose("rover")
assert pose.dtype == numpy.float64 and pose.shape == (6,)
mass = robots.getMassProperties("rover")
assert mass["mass"] == 2 and len(mass["centre"]) == 3 and numpy.array(mass["tensor"]).shape == (3, 3), mass
refused((IllegalArgumentException, ValueError), "wall is fixed (mass 0), legal: an object with a mass, or a robot", robots.getMassProperties, "wall")
distance = robots.getDistanceResult("ping")
assert type(distance) is float and abs(distance - 2.75) < 0.02, distance
assert abs(scan[90] - 2.9) < 0.02, scan[90]
assert robots.getSensorNames() == ["ping", "scanner"]
assert robots.isSimulating() is True
assert robots.checkProject()["problems"] == [], robots.checkProject()
refused((IllegalArgumentException, ValueError), 'no sensor is called "pong", legal: ping, scanner', robots.getReading, "pong")
refused((AttributeError,), "'SEAR' object has no attribute 'getPoze'\ndid you mean getPose?", getattr, robots, "getPoze")
refused(((OverflowError, IllegalArgumentException),), "-2147483648 to 2147483647", robots.step, 2 ** 40)
refused((OverflowError,), "step is called with (1180591620717411303424), legal: whole numbers from -9223372036854775808 to", robots.step, 2 ** 70)
refused((OverflowError,), "setResult is called with ('v', 1180591620717411303424), legal: whole numbers from -92", robots.setResult, "v", 2 ** 70)
refused((TypeError,), "driveStraight can't be called with (str, str, str)\nlegal: driveStraight(speed)\n       driveStraight(robot, speed)",
        robots.driveStraight, "a", "b", "c")
robots.push("rover", numpy.array([0, 0, 0.5]), 0.1)
robots.setWheelSpeeds(numpy.float32(0.25), 0.25)
robots.savePlot("lists.svg", "time (s)", range(3), {"way (m)": {"a": 1, "b": 2, "c": 3}.values()})

heard = []


def onDistance(reading):
    """A callback that itself lets time pass."""
    heard.append((reading.name, round(reading.time, 4), reading.value))
    if len(heard) == 3:
        robots.simSleep(0.25)


robots.addListener("publishReading", python.getName(), "onDistance")
robots.startPublishing("ping", 10)
robots.simSleep(2)
robots.stopPublishing("ping")
assert 18 <= len(heard) <= 21, heard
assert all(name == "ping" and type(value) is float for name, _, value in heard)
times = [time for _, time, _ in heard]
assert times == sorted(times) and times[-1] - times[0] > 1.7, times
assert heard[-1][2] < heard[0][2] - 0.3, heard

print("%.6f %.6f %.6f" % (robots.getTime(), robots.getDistanceResult("ping"), robots.getPose("rover")[0]))
print(" ".join("%.4f" % one for one in scan[::20]))
print(package.python.failed)
robots.stopSimulation()
