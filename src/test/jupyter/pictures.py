"""The display methods that notebooks call: pictures, and text without a picture."""
import pathlib
import pickle

import numpy

import sear

sear.start(headless=True, speed="max")
sear.start(headless=True, speed="max")    # like a cell that is run again
try:
    sear.start()
    raise AssertionError("another start was not refused")
except RuntimeError as error:
    assert "restart the program" in str(error), error

from sear import Box, Camera, Distance, Floor, LIDAR, Record, Robots, Runtime    # noqa: E402

SVG = "image/svg+xml"
robots = Runtime.start("robots", "SEAR")


def shown(thing):
    """Returns what Jupyter displays."""
    return thing._repr_mimebundle_()


none = shown(robots)
assert list(none) == ["text/plain"] and "there is no project folder" in none["text/plain"], none
Floor("ground", 8, 8)
wall = Box("wall & co", 0.2, 4, 0.5)
wall.move(2, 0.25, 0)
rover = Robots.rover("rover")
rover.rotate(0, 90, 0)
rover.addComponent(Distance("ping", "PING)))", 0, 0.1, 0.15, -10, 0, 0))
rover.addComponent(LIDAR("scanner", 6, 180, 1, 0, 0.3, 0))
rover.addComponent(Camera("eye", 0, 0.25, 0.15))
assert "wall &amp; co</text>" in shown(robots)[SVG], "before the start it shows the project"
table = shown(wall)["text/html"]
assert "wall &amp; co" in table and "0.25 m" in table and "scaleX" not in table, table
assert "ping, scanner, eye" in shown(rover)["text/html"]
for name in ("_repr_html_", "_ipython_display_", "_ipython_canary_method_should_not_exist_"):
    assert not hasattr(robots, name), name

robots.recordRun("run")
robots.startSimulation()
robots.driveStraight(0.2)
robots.simSleep(3)
plan = robots.getPlan()
assert plan._repr_svg_() == plan == shown(robots)[SVG] and "rover 0\N{DEGREE SIGN}</text>" in plan and ">after 3.00 s</text>" in plan, plan
plan.save("plan.svg")
assert open("plan.svg", encoding="utf-8").read() == plan
robots.savePlan("plan.png")
assert open("plan.png", "rb").read(4) == b"\x89PNG"
assert len(robots.getPlan(False)) < len(plan)
picture = robots.getImage("eye")
assert isinstance(picture, bytes) and picture._repr_png_()[:4] == b"\x89PNG" and "PNG picture" in repr(picture)

scan = robots.getLidarResult("scanner")
assert type(scan.min()) is numpy.float32 and type(scan[90]) is numpy.float32
for plain in (scan * 2, scan[10:20], scan + scan, numpy.sqrt(scan), numpy.concatenate([scan, scan]), numpy.minimum(scan, 3)):
    assert type(plain) is numpy.ndarray, type(plain)
assert type(pickle.loads(pickle.dumps(scan))) is numpy.ndarray
assert repr(scan).startswith("array([") and numpy.array_equal(robots.getReading("scanner"), scan)
drawn = shown(scan)
assert drawn["text/plain"] == repr(scan), drawn
assert "scanner: 181 beams, the nearest %.2f m, straight ahead" % scan[90] in drawn[SVG], drawn[SVG]
assert list(shown(numpy.sort(scan))) == ["text/plain"], "what is no whole scan any more is numbers"
angles = robots.getLidarAngles("scanner")
assert angles.shape == (181,) and angles[0] == -90 and angles[90] == 0 and angles[180] == 90, angles
assert type(robots.getReading("ping")) is float and type(robots.getPose("rover")) is numpy.ndarray
robots.stopSimulation()
assert SVG in shown(scan), "a scan is still there when the world has ended"

record = Record("run")
assert "rover.speed" in shown(record)[SVG] and "ping" in shown(record)[SVG]
assert len(record.times) == len(record["rover.x"]) == 91 and abs(record["rover.x"][-1] - 0.6) < 0.02, record["rover.x"][-1]
assert "rover.z" in record.plot("rover.z")._repr_svg_()
record.save("run.png", "rover.x")
assert open("run.png", "rb").read(4) == b"\x89PNG"

files = list(pathlib.Path("SEARproject/environment").glob("wall*.xml"))
assert len(files) == 1, files
files[0].write_text("<Box")
broken = shown(robots)
assert list(broken) == ["text/plain"] and "no picture: " in broken["text/plain"], broken
sear.close()
print("all shown")
