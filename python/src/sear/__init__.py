"""SEAR, the Simulation Environment for Autonomous Robots, from Python 3.

    from sear import *
    sear = Runtime.start("sear", "SEAR")
    sear.loadProject("examples/office.sear")
    sear.startSimulation()
    sear.simSleep(1)
    print(sear.getLidarResult("myLidar").min())

Without connect() the simulator runs in this process. Names and calls are those of Jython scripts (docs/scripting.md, docs/objects.md); readings and
pictures are numpy arrays; what SEAR refuses raises IllegalArgumentException or IllegalStateException with SEAR's own words.
"""
import atexit as _atexit

from . import _objects
from ._callbacks import PythonService as _PythonService
from ._errors import (IllegalArgumentException, IllegalStateException, IOException, JavaError, NullPointerException,
                      UnsupportedOperationException)
from ._names import OBJECTS as _OBJECTS
from ._objects import JavaObject, java_class
from ._record import Record

POJOS = "org.SEAR.POJOs."
SERVICES = "org.myrobotlab.service."
_AGAIN = ", in another way; a program or a notebook's kernel does it once: begin a new one"

Runtime = java_class(SERVICES + "Runtime")
python = _PythonService()
for _name in _OBJECTS:
    globals()[_name] = java_class(POJOS + _name)

__all__ = ["Runtime", "python", "start", "connect", "close", "sweep", "IllegalArgumentException", "IllegalStateException", "IOException",
           "JavaError", "NullPointerException", "UnsupportedOperationException", "JavaObject", "Record"] + list(_OBJECTS)


def start(*options, headless=None, speed=None, seed=None, threads=None):
    """Starts Java in this process. Happens by itself with the defaults when something is first asked for.

    options: of the Java machine, such as "-Xmx2g".
    headless: True opens no window. Default: a window where there is a display.
    speed: simulated seconds a second, or "max": as fast as possible, in lock-step with the program, the same every time. Default: 1.
    seed: where the random numbers of the sensors begin.
    threads: how many threads sensors and cameras measure on, 1 to 256.

    The same again does nothing. Raises RuntimeError if it runs already in another way.
    """
    given = {"sear.headless": None if headless is None else str(bool(headless)).lower(), "sear.speed": speed, "sear.seed": seed,
             "sear.threads": threads}
    asked = list(options) + ["-D%s=%s" % (key, value) for key, value in given.items() if value is not None]
    if _objects.connection.backend is not None:
        if asked == _objects.connection.options:    # a cell of a notebook was run again
            return
        raise RuntimeError("SEAR has been started or connected to already%s" % _AGAIN)
    from ._jvm import InProcess
    _objects.connection.backend = InProcess(asked)
    _objects.connection.options = asked


def connect(port=25333, token=None):
    """Uses the SEAR of a running MyRobotLab of this machine, the one that comes with SEAR or a real one, that was asked to startPython3().

    port: what startPython3 has answered.
    token: by default that of the file ~/.sear/gateway-PORT, which SEAR has written.

    Raises FileNotFoundError or ConnectionError with what to do.
    """
    if _objects.connection.backend is not None:
        if _objects.connection.options == port:
            return
        raise RuntimeError("SEAR has been started or connected to already%s" % _AGAIN)
    from ._gateway import OverGateway, token_of
    _objects.connection.backend = OverGateway(port, token or token_of(port))
    _objects.connection.options = port


def sweep(function, grid=None, seeds=1, **options):
    """Calls a function once for each seed and each combination of values, on many processes or computers: see sear.sweeps.sweep."""
    from .sweeps import sweep as all_of_them
    return all_of_them(function, grid, seeds, **options)


def close():
    """Stops what this program has started: callbacks, and in this process the simulations. Happens by itself at the end of the program."""
    backend = _objects.connection.backend
    if backend is None:
        return
    try:
        python.end()
        backend.close()
    except (ConnectionError, RuntimeError):
        pass    # Java has ended first


_objects.connection.start = start
_atexit.register(close)
