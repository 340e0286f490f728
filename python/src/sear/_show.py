# SPDX-License-Identifier: Apache-2.0
"""Notebook display of objects and readings. Display never fails and never waits long: a problem appears as text."""
import html
import math
import os
import threading

import numpy

from ._files import whole
from ._objects import SEAR, java_class

LIDAR = "org.myrobotlab.service.LIDAR"
OBJECTS = "org.SEAR.POJOs."
DESCRIBED = "org.myrobotlab.service.sear.python3.ObjectTables"
PATIENCE = 5    # seconds
SVG = "image/svg+xml"
WIDTH, MARGIN, FOOT = 480, 28, 30
INK, BEAM, GRID = "#222222", "#d55e00", "#cccccc"
_angles = {}


class Svg(str):
    """A picture: the text of an SVG file, displayed by notebooks."""

    def save(self, path):
        """Writes the file. Returns its absolute path."""
        with whole(path) as aside, open(aside, "w", encoding="utf-8") as file:
            file.write(self)
        return os.path.abspath(path)

    def _repr_svg_(self):
        return str(self)

    def __repr__(self):
        return "<SVG picture of %d characters>" % len(self)


class Png(bytes):
    """A picture: the bytes of a PNG file, displayed by notebooks."""

    def save(self, path):
        """Writes the file. Returns its absolute path."""
        with whole(path) as aside, open(aside, "wb") as file:
            file.write(self)
        return os.path.abspath(path)

    def _repr_png_(self):
        return bytes(self)

    def __repr__(self):
        return "<PNG picture of %d bytes>" % len(self)


class Scan(numpy.ndarray):
    """The ranges of a LIDAR in metres, from right to left: an array that notebooks display from above. Results computed
    from it are plain arrays."""

    name = ""
    angles = None

    def __array_wrap__(self, array, context=None, return_scalar=False):
        plain = numpy.asarray(array)
        return plain[()] if plain.ndim == 0 else plain

    def __array_finalize__(self, other):
        self.name, self.angles = "", None

    def __getitem__(self, key):
        return numpy.asarray(self)[key]

    def __reduce__(self):
        return numpy.asarray(self).__reduce__()

    def __repr__(self):
        return repr(numpy.asarray(self))

    def plot(self):
        """Returns a plot from above; ahead is up."""
        if self.angles is None or len(self.angles) != len(self):
            raise ValueError("the beam angles are unknown: only a complete reading can be drawn")
        return polar(self.name, numpy.asarray(self), self.angles)

    def _repr_mimebundle_(self, include=None, exclude=None):
        return safely(self, self.plot) if self.angles is not None else {"text/plain": repr(self)}


def _scan(owner, name, ranges):
    """Adds angles to ranges. Requests the angles once per scanner and number of beams."""
    key = owner, name, len(ranges)
    if key not in _angles:
        try:
            _angles[key] = owner.getLidarAngles(name)
        except (ValueError, RuntimeError):    # not a LIDAR
            _angles[key] = None
    if _angles[key] is None:
        return ranges
    scan = ranges.view(Scan)
    scan.name, scan.angles = name, _angles[key]
    return scan


def answer(owner, call, arguments, value):
    """Converts a result of a SEAR call to a type with a display."""
    if isinstance(value, bytes):
        return Png(value)
    if isinstance(value, str):
        return Svg(value) if call == "getPlan" else value
    if isinstance(value, numpy.ndarray) and value.dtype == numpy.float32 and arguments:
        return _scan(owner, str(arguments[0]), value)
    return value


def _nice(farthest):
    """Returns the distance of rings: at most four."""
    step = 10.0 ** math.floor(math.log10(farthest))
    return next(part * step for part in (0.25, 0.5, 1, 2, 2.5) if farthest / (part * step) <= 4)


def polar(name, ranges, angles):
    """Returns a plot of a scan from above: ahead is up; degrees, + to the left."""
    finite = ranges[numpy.isfinite(ranges)]
    farthest = max(float(finite.max()) if len(finite) else 1.0, 0.01)
    radians = numpy.radians(numpy.asarray(angles, float))
    lengths = numpy.where(numpy.isfinite(ranges), ranges, farthest)
    scale = (WIDTH / 2 - MARGIN) / farthest
    across, up = -lengths * numpy.sin(radians) * scale, lengths * numpy.cos(radians) * scale
    top = farthest * scale + MARGIN
    below = (farthest * scale if radians.min() < -math.pi / 2 - 0.01 else 0) + MARGIN
    height = math.ceil(top + below + FOOT)
    points = " ".join("%.1f,%.1f" % (WIDTH / 2 + x, top - y) for x, y in zip(across, up))
    ring = _nice(farthest)
    out = ['<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" viewBox="0 0 %d %d" font-family="DejaVu Sans, Verdana, Arial, sans-serif" '
           'font-size="12">' % (WIDTH, height, WIDTH, height), '<rect width="%d" height="%d" fill="#ffffff"/>' % (WIDTH, height)]
    for number in range(1, int(farthest / ring + 1e-9) + 1):
        out.append('<circle cx="%d" cy="%.1f" r="%.1f" fill="none" stroke="%s"/>' % (WIDTH / 2, top, number * ring * scale, GRID))
        out.append('<text x="%.1f" y="%.1f" fill="#777777">%g m</text>' % (WIDTH / 2 + 3, top - number * ring * scale - 3, number * ring))
    out.append('<rect y="%.1f" width="%d" height="%d" fill="#ffffff"/>' % (height - FOOT, WIDTH, FOOT))
    out.append('<polygon points="%d,%.1f %s" fill="%s" fill-opacity="0.15" stroke="%s"/>' % (WIDTH / 2, top, points, BEAM, BEAM))
    out.append('<polygon points="%d,%.1f %d,%.1f %d,%.1f" fill="%s"/>' % (WIDTH / 2, top - 12, WIDTH / 2 - 6, top + 5, WIDTH / 2 + 6, top + 5, INK))
    out.append('<text x="%d" y="%d" text-anchor="middle" fill="%s">%s</text>' % (WIDTH / 2, height - 10, INK, html.escape(_said(name, ranges, angles))))
    return Svg("\n".join(out + ["</svg>\n"]))


def _said(name, ranges, angles):
    finite = numpy.isfinite(ranges)
    text = "%s%d beams" % (name + ": " if name else "", len(ranges))
    if not finite.any():
        return text + ", no hits"
    nearest = int(numpy.argmin(numpy.where(finite, ranges, numpy.inf)))
    angle = float(angles[nearest])
    side = "straight ahead" if round(angle) == 0 else "%.0f degrees to the %s" % (abs(angle), "left" if angle > 0 else "right")
    return text + ", the nearest %.2f m, %s" % (ranges[nearest], side)


def _within(seconds, work):
    """Returns the result of a function run on its own thread. Raises TimeoutError if it takes longer."""
    found = []

    def run():
        try:
            found.append((work(), None))
        except BaseException as error:
            found.append((None, error))
    thread = threading.Thread(target=run, name="sear picture", daemon=True)
    thread.start()
    thread.join(seconds)
    if not found:
        raise TimeoutError("no picture after %d s: the simulation is busy" % seconds)
    value, error = found[0]
    if error is not None:
        raise error
    return value


def safely(thing, draw, kind=SVG):
    """Returns an object's text and picture; the reason instead of a missing picture."""
    try:
        return {"text/plain": repr(thing), kind: str(_within(PATIENCE, draw))}
    except Exception as error:
        return {"text/plain": "%s\n(no picture: %s)" % (repr(thing), error)}


def bundle(thing):
    """Returns the notebook display of a Java object: SEAR's plan, a scanner service's last scan, or an object's
    parameters."""
    if thing.java_name == SEAR:
        return safely(thing, lambda: thing.getPlan())
    if thing.java_name == LIDAR:
        return safely(thing, lambda: _last_scan(thing))
    if thing.java_name.startswith(OBJECTS):
        return safely(thing, lambda: _table(thing), "text/html")
    return {"text/plain": repr(thing)}


def _last_scan(lidar):
    scan = lidar.getLastScan()
    if scan is None:
        raise RuntimeError("no scan yet: call connect() and singleScan() first")
    metres = numpy.array([numpy.nan if one is None else one for one in scan.metres], float)
    return polar(lidar.getName(), metres, numpy.asarray(scan.angles, float) - 90)


def _table(thing):
    rows = java_class(DESCRIBED).rows(thing)
    if not rows:
        raise RuntimeError("no description available")
    lines = "".join("<tr><th style='text-align:left'>%s</th><td style='text-align:left'>%s</td><td style='text-align:left'>%s</td></tr>"
                    % tuple(html.escape(str(cell)) for cell in row) for row in rows)
    return "<table><caption style='text-align:left'>%s</caption>%s</table>" % (html.escape(str(thing)), lines)
