# SPDX-License-Identifier: Apache-2.0
"""Java in another process of this machine, through Py4J: a running SEAR after startPython3()."""
import os

import numpy
from py4j.clientserver import ClientServer, JavaParameters, PythonParameters
from py4j.java_collections import JavaArray, JavaList, JavaMap
from py4j.java_gateway import JavaObject as Remote
from py4j.protocol import Py4JAuthenticationError, Py4JJavaError, Py4JNetworkError

from . import _errors
from ._objects import wrap
from ._waiter import Waiter

PORT = 25333
MEMBERS = "org.myrobotlab.service.sear.python3.Members"
WAITS = "org.myrobotlab.service.sear.python3.BlockingCalls"
CALLS = "org.myrobotlab.service.sear.python3.GatewayCalls"
# Prefix of bytes that encode an array; three letters with numpy's name of the type follow
NUMBERS = b"\0numpy"


def path_of(port):
    """Returns the file in which SEAR writes the token for that port."""
    return os.path.join(os.path.expanduser("~"), ".sear", "gateway-%d" % port)


def token_of(port):
    """Returns the token that SEAR wrote for that port.

    Raises FileNotFoundError with a remedy.
    """
    path = path_of(port)
    try:
        with open(path) as file:
            return file.read().strip()
    except FileNotFoundError:
        raise FileNotFoundError("no SEAR of this user accepts Python 3 at port %d (no file %s): call sear.startPython3(%s) in MyRobotLab first"
                                % (port, path, "" if port == PORT else port)) from None


def _array(packed):
    start = len(NUMBERS)
    return numpy.frombuffer(packed, dtype=packed[start:start + 3].decode("ascii"), offset=start + 3).copy()


class OverGateway:
    """The backend for Java in another process. Any thread."""

    def __init__(self, port, token):
        self._port = port
        self._server = ClientServer(java_parameters=JavaParameters(port=port, auth_token=token, auto_convert=True),
                                    python_parameters=PythonParameters(port=0, eager_load=False))
        self._names = {}
        try:
            self._members = self._class(MEMBERS)
            self._calls = self._class(CALLS)
            self._members.numberType("")
        except Py4JAuthenticationError:
            raise ConnectionError("the SEAR at port %d refuses this token; legal: the one in the file %s" % (port, path_of(port))) from None
        except Py4JNetworkError as error:
            raise ConnectionError("no SEAR accepts Python 3 at port %d: call sear.startPython3(%s) in MyRobotLab first (%s)"
                                  % (port, "" if port == PORT else port, error)) from None
        self._waiter = Waiter(self._server.jvm.java.lang.Thread)

    def _class(self, name):
        found = self._server.jvm
        for part in name.split("."):
            found = getattr(found, part)
        return found

    def java_class(self, name):
        """Returns the java.lang.Class."""
        return self._server.jvm.java.lang.Class.forName(name)

    def java_list(self, values):
        """Returns a list, which Py4J converts to a java.util.List."""
        return list(values)

    def java_map(self, values):
        """Returns a dictionary, which Py4J converts to a java.util.Map."""
        return dict(values)

    def new(self, name, arguments):
        """Creates an object of that class."""
        return self._run(self._calls.create, (name,), arguments, name, None)

    def call(self, method, arguments, class_name, name):
        """Calls a method and converts its result."""
        call, of = method
        return self.to_python(self._run(call, (of, name), arguments, class_name, name))

    def _run(self, call, how, arguments, class_name, name):
        _errors.refuse_large(name or class_name.rpartition(".")[2], arguments)
        try:
            return call(*how, arguments)
        except Py4JJavaError as error:
            if error.java_exception.getClass().getSimpleName() != "NoSuchMethodException":
                raise self._translated(error) from None
        except Py4JNetworkError as error:
            raise ConnectionError("the SEAR at port %d has ended (%s)" % (self._port, error)) from None
        except KeyboardInterrupt:
            self._hang_up()
            raise
        from ._hints.python3 import misfit
        raise TypeError(misfit(class_name, name, arguments))

    def _hang_up(self):
        """Closes this thread's connection: answers that still arrive belong to the interrupted call."""
        line = self._server._gateway_client.get_thread_connection()
        if line is not None:
            line.close()

    def wait(self, java, name, argument):
        """Makes a waiting call that an interrupt ends in Java, so that its answer still arrives. Main thread."""
        kind = self._members.className(java)
        self._waiter.run(lambda: self._run(self._class(WAITS).call, (java, name), [argument], kind, name))

    def _translated(self, error):
        cause = error.java_exception
        return _errors.of(list(self._members.lineage(cause)), cause.getMessage())

    def member(self, java, name):
        """Returns a method, or the value of a field or property: ("method", callable), ("value", its value) or (None,
        None)."""
        kind = self._members.kind(java, name)
        if kind == "method":
            return "method", (self._calls.call, java)
        return ("value", self._members.value(java, name)) if kind == "value" else (None, None)

    def static(self, class_name, name):
        """Returns the same for a class."""
        if name not in self.names(class_name):
            return None, None
        if self._members.methods(self.java_class(class_name), name):
            return "method", (self._calls.callStatic, class_name)
        return "value", self.java_class(class_name).getField(name).get(None)

    def assign(self, java, name, value):
        """Changes a field or property."""
        try:
            self._members.assign(java, name, value)
        except Py4JJavaError as error:
            raise self._translated(error) from None

    def exists(self, class_name):
        """Whether Java has a class of that full name."""
        return self._members.find(class_name) is not None

    def ask(self, question, class_name, *more):
        """Returns names or signatures: the answer of the Java class Members."""
        return list(getattr(self._members, question)(self.java_class(class_name), *more))

    def names(self, class_name):
        """Returns the names of its members."""
        if class_name not in self._names:
            self._names[class_name] = list(self._members.names(self.java_class(class_name)))
        return self._names[class_name]

    def text(self, java):
        """Returns the result of toString."""
        return java.toString()

    def same(self, one, other):
        """Whether two objects are equal."""
        return one.equals(other)

    def hash(self, java):
        """Returns the object's hash code."""
        return java.hashCode()

    def to_python(self, value):
        """Converts numbers, texts, lists and maps to Python's, arrays of numbers to numpy's; all else becomes a
        proxy."""
        if isinstance(value, JavaArray):
            kind = self._members.numberType(value)
            if kind is None:
                return [self.to_python(one) for one in value]
            return numpy.frombuffer(self._members.bytes(value), dtype=kind).copy()
        if isinstance(value, (bytes, bytearray)):
            return _array(value) if value.startswith(NUMBERS) else bytes(value)
        if isinstance(value, JavaList):
            return [self.to_python(one) for one in value]
        if isinstance(value, JavaMap):
            return {self.to_python(key): self.to_python(value[key]) for key in value}
        if isinstance(value, Remote):
            return wrap(value, self._members.className(value))
        return value

    def close(self):
        """Closes the connections."""
        self._server.close()
