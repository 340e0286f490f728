"""The Java half: org.SEAR.learning.Episode, in this process."""
import os
import shutil
import tempfile
import threading
from multiprocessing import util

import numpy

import sear
from .. import _home, _objects

EPISODE = "org.SEAR.learning.Episode"
FORKED = ("this process was forked from one in which Java runs, and Java does not survive that: start it anew, as by "
          "gymnasium.make_vec(..., vectorization_mode=\"async\", vector_kwargs={\"context\": \"spawn\"})")


class _Process:
    """Of this process: the projects that were opened, the folders in which bundles were unpacked, and whether Java was left behind by a fork."""
    projects = {}
    folders = []
    forked = False
    lock = threading.Lock()


def _in_child():
    _Process.forked = _objects.connection.backend is not None
    _Process.folders = []    # they belong to the parent


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_in_child)


def _clean():
    for folder in _Process.folders:
        shutil.rmtree(folder, ignore_errors=True)


util.Finalize(None, _clean, exitpriority=0)    # also runs at the end of a process that multiprocessing has started


def backend():
    """Java in this process; it is started without a window if it does not run.

    Raises RuntimeError if it can't be.
    """
    if _Process.forked:
        raise RuntimeError(FORKED)
    if _objects.connection.backend is None:
        sear.start(headless=True)
    if not hasattr(_objects.connection.backend, "run"):
        raise RuntimeError("sear.gym runs worlds in its own process, but this program is connected to another one: don't call sear.connect()")
    return _objects.connection.backend


def _found(path):
    """Examples are found in each working folder."""
    given = os.fspath(path)
    if not os.path.exists(given) and given.replace(os.sep, "/").startswith("examples/"):
        given = os.path.join(_home.find(), *given.replace(os.sep, "/").split("/"))
    if not os.path.exists(given):
        raise FileNotFoundError("project %s is not there; legal: a .sear file, or a folder SEARproject" % path)
    return os.path.realpath(given)


def project(path):
    """The project of a bundle or folder; all worlds of it in this process share what does not change."""
    java = backend()
    place = _found(path)
    with _Process.lock:
        key = (place, os.stat(place).st_mtime_ns) if os.path.isfile(place) else None
        if key in _Process.projects:
            return _Process.projects[key]
        paths = java.raw_class("java.nio.file.Paths")
        if key is None:
            inside = os.path.join(place, "SEARproject")
            return java.run(java.raw_class("org.SEAR.project.Project").read, paths.get(inside if os.path.isdir(inside) else place))
        folder = tempfile.mkdtemp(prefix="sear-gym")
        _Process.folders.append(folder)
        bundle = java.raw_class("org.SEAR.project.bundle.Bundle")
        _Process.projects[key] = java.run(bundle.load, paths.get(place), paths.get(folder, "SEARproject"))
        return _Process.projects[key]


class Episode:
    """A world that is started again and again: its numbers stand in numpy arrays, which change with each step."""

    def __init__(self, path, robot, sensors, things, fastest, seed):
        self._java = backend()
        read = project(path)
        self._episode = self._java.run(self._java.raw_class(EPISODE), read, robot or "",
                                       None if sensors is None else self._java.java_list(sensors), self._java.java_list(things), float(fastest), seed)
        memory, buffer = self._java.shared(self._episode.getBytes())
        self._episode.setMemory(buffer)
        self.state = numpy.frombuffer(memory, numpy.float64, self._episode.getStateBytes() // 8)
        self.numbers = numpy.frombuffer(memory, numpy.float32, offset=self._episode.getStateBytes())
        self.robot = str(self._episode.getRobot())
        sizes = [int(size) for size in self._episode.getSizes()]
        self.low = numpy.repeat(numpy.array(self._episode.getLows(), numpy.float32), sizes)
        self.high = numpy.repeat(numpy.array(self._episode.getHighs(), numpy.float32), sizes)
        self.slices = {}
        at = 0
        for name, size in zip(self._episode.getNames(), sizes):
            self.slices[str(name)] = slice(at, at + size)
            at += size
        self._step = self._episode.step

    def _open(self):
        if self._episode is None:
            raise RuntimeError("the environment is closed: make another one")
        return self._episode

    def reset(self, seed, start):
        """Starts anew; start is None for the project's own place, else x, z and heading."""
        self._java.run(self._open().reset, seed, *(start or ()))

    def step(self, left, right, steps):
        """An action for so many steps."""
        try:
            self._step(left, right, steps)
        except Exception as error:
            raise self._java.translated(error) from None

    def draw(self, width, height):
        """From above, as an array of height, width and colour."""
        pixels = self._java.run(self._open().draw, width, height)
        return numpy.frombuffer(bytes(pixels), numpy.uint8).reshape(height, width, 3).copy()

    def close(self):
        """Lets go of the world."""
        if self._episode is not None:
            self._episode.close()
            self._episode = self._step = None
