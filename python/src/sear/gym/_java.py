# SPDX-License-Identifier: Apache-2.0
"""The Java part: org.SEAR.learning.Episode, in this process."""
import os
import shutil
import tempfile
import threading
from multiprocessing import util

import numpy

import sear
from .. import _home, _objects

EPISODE = "org.SEAR.learning.Episode"
FORKED = ("Java can't run in a process forked from one with Java: use the start method \"spawn\", for example "
          "gymnasium.make_vec(..., vectorization_mode=\"async\", vector_kwargs={\"context\": \"spawn\"})")


class _Process:
    """State of this process: opened projects, folders of unpacked bundles, and whether a fork has lost Java."""
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


util.Finalize(None, _clean, exitpriority=0)    # also runs at the end of a process started by multiprocessing


def backend():
    """Returns Java in this process; starts it without a window if necessary.

    Raises RuntimeError if that is impossible.
    """
    if _Process.forked:
        raise RuntimeError(FORKED)
    if _objects.connection.backend is None:
        sear.start(headless=True)
    if not hasattr(_objects.connection.backend, "run"):
        raise RuntimeError("sear.gym runs worlds in its own process, but this program is connected to another one: don't call sear.connect()")
    return _objects.connection.backend


def _found(path):
    """Returns the real path of a project. Examples are found from any working folder."""
    given = os.fspath(path)
    if not os.path.exists(given) and given.replace(os.sep, "/").startswith("examples/"):
        given = os.path.join(_home.find(), *given.replace(os.sep, "/").split("/"))
    if not os.path.exists(given):
        raise FileNotFoundError("project %s does not exist; legal: a .sear file, or a folder SEARproject" % path)
    return os.path.realpath(given)


def project(path):
    """Returns the project of a bundle or folder. All its worlds in this process share the constant parts."""
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
    """A restartable world whose numbers and pictures are in numpy arrays, which each step updates."""

    def __init__(self, path, robot, sensors, things, fastest, seed):
        self._java = backend()
        read = project(path)
        self._episode = self._java.run(self._java.raw_class(EPISODE), read, robot or "",
                                       None if sensors is None else self._java.java_list(sensors), self._java.java_list(things), float(fastest), seed)
        memory, buffer = self._java.shared(self._episode.getBytes())
        self._episode.setMemory(buffer)
        self.state = numpy.frombuffer(memory, numpy.float64, self._episode.getStateBytes() // 8)
        self.numbers = numpy.frombuffer(memory, numpy.float32, self._episode.getCount(), self._episode.getStateBytes())
        self.robot = str(self._episode.getRobot())
        sizes = [int(size) for size in self._episode.getSizes()]
        self.low = numpy.repeat(numpy.array(self._episode.getLows(), numpy.float32), sizes)
        self.high = numpy.repeat(numpy.array(self._episode.getHighs(), numpy.float32), sizes)
        self.slices = {}
        at = 0
        for name, size in zip(self._episode.getNames(), sizes):
            self.slices[str(name)] = slice(at, at + size)
            at += size
        self.pictures = {}
        at = self._episode.getStateBytes() + self.numbers.nbytes
        shapes = numpy.array(self._episode.getPictureSizes(), int).reshape(-1, 2)
        for name, (width, height) in zip(self._episode.getPictureNames(), shapes.tolist()):
            size = width * height * 3
            self.pictures[str(name)] = numpy.frombuffer(memory, numpy.uint8, size, at).reshape(height, width, 3)
            at += size
        self._step = self._episode.step

    def _open(self):
        if self._episode is None:
            raise RuntimeError("the environment is closed: make another one")
        return self._episode

    def reset(self, seed, start):
        """Restarts the world; start is None for the project's own pose, else x, z and heading."""
        self._java.run(self._open().reset, seed, *(start or ()))

    def step(self, left, right, steps):
        """Performs an action for a number of steps."""
        try:
            self._step(left, right, steps)
        except Exception as error:
            raise self._java.translated(error) from None

    def set_controls(self, names, actions):
        """Chooses what act sets; raises ValueError if the robot can't do one of the actions."""
        self._java.run(self._open().setControls, self._java.java_list(names))
        for values in actions:
            self._java.run(self._episode.check, values)

    def act(self, values, steps):
        """Sets the controls for a number of steps."""
        self._java.run(self._open().act, values, steps)

    def draw(self, width, height):
        """Returns a picture from above, as an array of height, width and colour."""
        pixels = self._java.run(self._open().draw, width, height)
        return numpy.frombuffer(bytes(pixels), numpy.uint8).reshape(height, width, 3).copy()

    def close(self):
        """Releases the world."""
        if self._episode is not None:
            self._episode.close()
            self._episode = self._step = None
