# SPDX-License-Identifier: Apache-2.0
"""SEAR, the Simulation Environment for Autonomous Robots, from Python 3.

    from sear import *
    sear = Runtime.start("sear", "SEAR")
    sear.loadProject("examples/office.sear")
    sear.startSimulation()
    sear.simSleep(1)
    print(sear.getLidarResult("myLidar").min())

Without connect() the simulator runs in this process. Names and calls are those of Jython scripts (docs/scripting.md,
docs/objects.md). Readings and pictures are numpy arrays. Errors of SEAR are raised as IllegalArgumentException or
IllegalStateException with SEAR's message.
"""
import atexit as _atexit
import os as _os

from . import _objects
from ._callbacks import PythonService as _PythonService
from ._errors import (IllegalArgumentException, IllegalStateException, IOException, JavaError, NullPointerException,
                      UnsupportedOperationException)
from ._errors import install as _install_hints
from ._names import OBJECTS as _OBJECTS
from ._objects import JavaObject, java_class
from ._record import Record

POJOS = "org.SEAR.POJOs."
SERVICES = "org.myrobotlab.service."
_AGAIN = " with other options: restart the program or the notebook's kernel"

Runtime = java_class(SERVICES + "Runtime")
python = _PythonService()
for _name in _OBJECTS:
    globals()[_name] = java_class(POJOS + _name)

__all__ = ["Runtime", "python", "start", "connect", "close", "sweep", "IllegalArgumentException", "IllegalStateException", "IOException",
           "JavaError", "NullPointerException", "UnsupportedOperationException", "JavaObject", "Record"] + list(_OBJECTS)


def start(*options, headless=None, speed=None, seed=None, threads=None, project=None):
    """Starts Java in this process. The first use of SEAR does this with the defaults.

    options: of the Java machine, for example "-Xmx2g".
    headless: True opens no window. Default: a window if there is a display.
    speed: simulated seconds per second, or "max": as fast as possible, in lock-step with the program, the same every
        time. Default: 1.
    seed: seed of the sensors' random numbers.
    threads: number of threads for sensors and cameras, 1 to 256.
    project: the project's folder. Default: SEARproject in the current folder. Only one program at a time can use it.

    A second call with the same arguments does nothing. Raises RuntimeError if SEAR already runs with other options.
    """
    given = {"sear.headless": None if headless is None else str(bool(headless)).lower(), "sear.speed": speed, "sear.seed": seed,
             "sear.threads": threads, "sear.project": None if project is None else _os.path.abspath(project)}
    asked = list(options) + ["-D%s=%s" % (key, value) for key, value in given.items() if value is not None]
    if _objects.connection.backend is not None:
        if asked == _objects.connection.options:    # a notebook cell ran again
            return
        raise RuntimeError("SEAR has already been started or connected%s" % _AGAIN)
    from ._jvm import InProcess
    _objects.connection.backend = InProcess(asked)
    _objects.connection.options = asked


def connect(port=25333, token=None):
    """Connects to the SEAR of a running MyRobotLab on this machine, SEAR's own or a real one, after its startPython3().

    port: the result of startPython3.
    token: by default that of the file ~/.sear/gateway-PORT, which SEAR writes.

    Raises FileNotFoundError or ConnectionError with a remedy.
    """
    if _objects.connection.backend is not None:
        if _objects.connection.options == port:
            return
        raise RuntimeError("SEAR has already been started or connected%s" % _AGAIN)
    from ._gateway import OverGateway, token_of
    _objects.connection.backend = OverGateway(port, token or token_of(port))
    _objects.connection.options = port


def sweep(function, grid=None, seeds=1, **options):
    """Calls a function once for each seed and each combination of values, on many processes or computers: see
    sear.sweeps.sweep."""
    from .sweeps import sweep as all_of_them
    return all_of_them(function, grid, seeds, **options)


def close():
    """Stops what this program has started: callbacks, and simulations in this process. Runs automatically at the end of
    the program."""
    backend = _objects.connection.backend
    if backend is None:
        return
    try:
        python.end()
        backend.close()
    except (ConnectionError, RuntimeError):
        pass    # Java ended first


_objects.connection.start = start
_install_hints()
_atexit.register(close)
