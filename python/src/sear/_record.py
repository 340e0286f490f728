# SPDX-License-Identifier: Apache-2.0
"""Records of runs, as arrays and plots."""
import os
import tempfile

from ._objects import java_class

RUNTIME = "org.myrobotlab.service.Runtime"
# Suffixes of values that are not sensor readings
MOTION = (".x", ".y", ".z", ".heading", ".speed", ".turnRate", " wanted", " received", " sent")


class Record:
    """A record of a run (docs/records.md): record.names, record["rover.x"] as an array over record.times, and plots.

    path: the path given to recordRun().
    """

    def __init__(self, path):
        self._sear = java_class(RUNTIME).start("sear", "SEAR")
        given = os.path.abspath(path)
        self.path = given if given.endswith(".searlog") else given + ".searlog"
        self.names = list(self._sear.getRecordNames(self.path))

    def _values(self, name):
        return self._sear.getRecordValues(self.path, [name])

    def __getitem__(self, name):
        import numpy    # imported here, so that its absence is reported
        return numpy.array([numpy.nan if one is None else one for one in self._values(name)["values"][0]])

    @property
    def times(self):
        """Returns the time of each value, simulated seconds since the record began: 30 values per second, or fewer, so
        that there are at most 4000."""
        import numpy
        return numpy.array(self._values(self.names[0])["times"])

    def _chosen(self):
        """Returns the first robot's speed and the first sensor, preferably one with a single number."""
        speeds = [name for name in self.names if name.endswith(".speed")][:1]
        sensors = [name for name in self.names if not name.endswith(MOTION)]
        plain = [name for name in sensors if "." not in name]
        return speeds + (plain or sensors)[:1] or self.names[:1]

    def plot(self, *names):
        """Returns a plot of these values over time, with one box per unit. Default: a speed and a sensor."""
        from ._show import Svg
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "plot.svg")
            self.save(path, *names)
            with open(path, encoding="utf-8") as file:
                return Svg(file.read())

    def save(self, picture, *names):
        """Saves the plot as a file, whose name ends in .png or .svg. Returns its absolute path."""
        return self._sear.saveRecordPlot(self.path, list(names) or self._chosen(), os.path.abspath(os.fspath(picture)))

    def __repr__(self):
        return "<Record %s>" % self.path

    def _repr_mimebundle_(self, include=None, exclude=None):
        from ._show import safely
        return safely(self, self.plot)
