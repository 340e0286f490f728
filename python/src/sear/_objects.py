# SPDX-License-Identifier: Apache-2.0
"""Java's objects in Python. The backends _jvm and _gateway implement the access to Java."""
import builtins
import collections.abc
import os
import threading

_PLAIN = frozenset((float, int, str, bool, type(None), bytes))
# Types that list() converts and Java receives as a list
_LISTS = list, tuple, range, collections.abc.KeysView, collections.abc.ValuesView
_classes = {}
SEAR = "org.myrobotlab.service.SEAR"
RUNTIME = "org.myrobotlab.service.Runtime"
FOLDER = "org.SEAR.grammar.ScriptFolder"
# Waiting calls that an interrupt of a terminal or notebook ends, with the smallest argument for which it does
_WAITS = {(SEAR, "simSleep"): 0.4, (SEAR, "step"): 24}
# Calls that take paths, or depend on the working folder
_FILED = frozenset((SEAR, name) for name in (
    "saveImage", "savePlan", "saveProject", "saveProjectAs", "loadProject", "importRobot", "importUrdf",
    "importEnvironment", "copyTemplate", "recordRun",
    "rerunRecord", "getRecords", "getRecordNames", "getRecordValues", "getRecordFrames", "getRecordPicture", "getRecordMotion", "saveRecordCsv",
    "saveRecordPlot", "savePlot", "exportPort"))
# Calls that create a service
_STARTS = frozenset((RUNTIME, name) for name in ("start", "create", "createAndStart", "loadAndStart"))
# Calls whose results are pictures, or have one
_SHOWN = frozenset(((SEAR, "getPlan"), (SEAR, "getImage"), (SEAR, "getLidarResult"), (SEAR, "getReading")))


class _Connection:
    """The backend: None until the first use, then one until the end."""
    backend = None
    start = None
    # Options of its start: a list, or the port of a gateway
    options = None


connection = _Connection()


def backend():
    """Starts Java in this process, unless a backend exists."""
    if connection.backend is None:
        connection.start()
    return connection.backend


def to_java(value):
    """Converts a value for Java: proxies to their objects, lists, tuples, ranges and dictionaries element by element,
    numpy's arrays to numbers."""
    if type(value) in _PLAIN:
        return value
    if isinstance(value, JavaObject):
        return value.__dict__["java"]
    if isinstance(value, _Statics):
        return backend().java_class(value.java_name)
    if hasattr(value, "tolist"):
        return to_java(value.tolist())
    if isinstance(value, _LISTS):
        return backend().java_list([to_java(one) for one in value])
    if isinstance(value, dict):
        return backend().java_map({key: to_java(one) for key, one in value.items()})
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    return value


def _refuse_names(class_name, name):
    """Raises TypeError: Java has no argument names at run time. Names in the documentation and stubs are for readers
    only."""
    from ._hints.python3 import named
    raise TypeError(named(class_name, name))


class _Call:
    """A callable method of an object or class."""

    __slots__ = ("method", "class_name", "name")

    def __init__(self, method, class_name, name):
        self.method = method
        self.class_name = class_name
        self.name = name

    def __call__(self, *arguments, **named):
        if named:
            _refuse_names(self.class_name, self.name)
        return connection.backend.call(self.method, [one if type(one) in _PLAIN else to_java(one) for one in arguments], self.class_name, self.name)

    def __repr__(self):
        return "<method %s of %s>" % (self.name, self.class_name.rpartition(".")[2])


class _Wait(_Call):
    """A method that waits for simulated time."""

    __slots__ = ("owner",)

    def __call__(self, *arguments, **named):
        if named or len(arguments) != 1 or not isinstance(arguments[0], (int, float)) \
                or not _WAITS[self.class_name, self.name] <= arguments[0] < 2 ** 31 or threading.current_thread() is not threading.main_thread():
            return super().__call__(*arguments, **named)
        return connection.backend.wait(self.owner.__dict__["java"], self.name, arguments[0])


class _Filed(_Call):
    """A method whose relative paths refer to this program's working folder."""

    __slots__ = ("owner",)

    def __call__(self, *arguments, **named):
        java_class(FOLDER).set(os.getcwd())
        return super().__call__(*arguments, **named)


class _Start(_Call):
    """A method that creates a service. MyRobotLab answers nothing if it can't, with the reason in its last error."""

    __slots__ = ()

    def __call__(self, *arguments, **named):
        service = super().__call__(*arguments, **named)
        if service is None:
            from ._errors import IllegalArgumentException
            error = java_class(RUNTIME).getInstance().getLastError()
            reason = "" if error is None else str(error.key)
            name = " as ".join(str(one) for one in arguments)
            raise IllegalArgumentException(reason if reason.startswith("can't start ") else "MyRobotLab can't start %s: its log has the reason" % name)
        return service


class _Shown(_Call):
    """A method whose result a notebook displays."""

    __slots__ = ("owner",)

    def __call__(self, *arguments, **named):
        from ._show import answer
        return answer(self.owner, self.name, arguments, super().__call__(*arguments, **named))


def _method(owner, method, class_name, name):
    key = class_name, name
    kind = _Wait if key in _WAITS else _Shown if key in _SHOWN else _Filed if key in _FILED else _Call
    call = kind(method, class_name, name)
    if kind is not _Call:
        call.owner = owner
    return call


def _unknown(class_name, name):
    from ._hints.python3 import unknown
    error = AttributeError(unknown(class_name, name))
    error.obj = class_name    # so that Python adds no suggestion of its own
    return error


class _Statics(type):
    """Static methods and constants of a class."""

    def __getattr__(cls, name):
        if name.startswith("_") or cls.java_name is None:
            raise AttributeError(name)
        kind, value = backend().static(cls.java_name, name)
        if kind == "method":
            call = (_Start if (cls.java_name, name) in _STARTS else _Call)(value, cls.java_name, name)
            setattr(cls, name, call)
            return call
        if kind is None:
            raise _unknown(cls.java_name, name)
        return backend().to_python(value)


class JavaObject(metaclass=_Statics):
    """An object of SEAR or MyRobotLab. docs/scripting.md and docs/objects.md list its methods, fields and
    properties."""

    java_name = None

    def __init__(self, *arguments, **named):
        if named:
            backend()
            _refuse_names(self.java_name, None)
        self.__dict__["java"] = backend().new(self.java_name, [to_java(one) for one in arguments])

    def __getattr__(self, name):
        if name.startswith("_"):    # names that notebooks look up for display
            raise AttributeError(name)
        kind, value = backend().member(self.__dict__["java"], name)
        if kind == "method":
            call = _method(self, value, self.java_name, name)
            self.__dict__[name] = call
            return call
        if kind is None:
            raise _unknown(self.java_name, name)
        return backend().to_python(value)

    def __setattr__(self, name, value):
        backend().assign(self.__dict__["java"], name, to_java(value))

    def __dir__(self):
        return sorted(set(super().__dir__()) | set(backend().names(self.java_name)))

    def __str__(self):
        return backend().text(self.__dict__["java"])

    def __repr__(self):
        try:
            return "<%s %s>" % (type(self).__name__, self)
        except Exception as error:    # Java has ended; display must not fail
            return "<%s: %s>" % (type(self).__name__, error)

    def _repr_mimebundle_(self, include=None, exclude=None):
        from ._show import bundle
        return bundle(self)

    def __eq__(self, other):
        return isinstance(other, JavaObject) and backend().same(self.__dict__["java"], other.__dict__["java"])

    def __hash__(self):
        return backend().hash(self.__dict__["java"])


def java_class(java_name, text=None):
    """Returns the Python class of a Java class, always the same one."""
    if java_name not in _classes:
        short = java_name.rpartition(".")[2].rpartition("$")[2]
        _classes[java_name] = _Statics(short, (JavaObject,), {"java_name": java_name, "__doc__": text, "__module__": "sear"})
    return _classes[java_name]


def wrap(java, java_name):
    """Returns a proxy for an object made by Java."""
    proxy = builtins.object.__new__(java_class(java_name))
    proxy.__dict__["java"] = java
    return proxy
