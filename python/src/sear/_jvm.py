# SPDX-License-Identifier: Apache-2.0
"""Java in this process, through JPype."""
import os

import numpy

from . import _errors, _home, _signals
from ._objects import wrap
from ._waiter import Waiter

# Options of bin/sear, with the same log level
OPTIONS = ("-Xlog:cds=off", "-XX:+IgnoreUnrecognizedVMOptions", "--sun-misc-unsafe-memory-access=allow", "--enable-native-access=ALL-UNNAMED",
           "-XX:+UseSerialGC", "-Xms64m", "-XX:+UnlockDiagnosticVMOptions", "-XX:ArchiveRelocationMode=0", "-XX:Tier4InvocationThreshold=50000",
           "-XX:Tier4CompileThreshold=150000", "-XX:Tier4BackEdgeThreshold=400000", "-XX:Tier3DelayOn=0", "-Dsear.inPython=true",
           "-Dorg.slf4j.simpleLogger.defaultLogLevel=warn", "-Dorg.slf4j.simpleLogger.log.org.SEAR.progress=info",
           "-Dorg.slf4j.simpleLogger.showThreadName=false", "-Dorg.slf4j.simpleLogger.showLogName=false",
           "-Dorg.slf4j.simpleLogger.levelInBrackets=true")
MEMBERS = "org.myrobotlab.service.sear.python3.Members"
WAITS = "org.myrobotlab.service.sear.python3.BlockingCalls"
SEAR = "org.myrobotlab.service.SEAR"
_PLAIN = frozenset((float, int, str, bool, type(None), bytes))
_NUMBERS = frozenset(("float[]", "double[]", "int[]", "long[]", "short[]", "boolean[]"))


class InProcess:
    """The backend for Java in this process. Any thread."""

    def __init__(self, options=()):
        import jpype
        import jpype.nio
        home = _home.find()
        self._jpype = jpype
        if not jpype.isJVMStarted():
            signals = _signals.Handlers()
            try:
                archive = _home.class_archive(home, jpype.getDefaultJVMPath())
                jpype.startJVM(*OPTIONS, *archive, "-Dsear.home=" + home, *os.environ.get("JAVA_OPTS", "").split(),
                               *options, classpath=_home.jars(home), convertStrings=True, interrupt=False)
            except jpype.JVMNotFoundException as error:
                raise FileNotFoundError("SEAR needs Java 11 or newer: install it, for example 'sudo apt-get install default-jre', or set JAVA_HOME "
                                        "(%s)" % error) from None
            signals.restore()
        self._members = jpype.JClass(MEMBERS)
        self._list = jpype.JClass("java.util.ArrayList")
        self._map = jpype.JClass("java.util.LinkedHashMap")
        self._java_list = jpype.JClass("java.util.List")
        self._java_map = jpype.JClass("java.util.Map")
        self._waiter = Waiter(jpype.JClass("java.lang.Thread"))
        self._interrupter = _signals.Interrupter(jpype.JClass("java.lang.Thread"))

    def java_class(self, name):
        """Returns the java.lang.Class."""
        return self._jpype.JClass(name).class_

    def java_list(self, values):
        """Returns the values as a java.util.List."""
        made = self._list(len(values))
        for one in values:
            made.add(one)
        return made

    def java_map(self, values):
        """Returns the values as a java.util.Map in the same order."""
        made = self._map()
        for key, one in values.items():
            made.put(key, one)
        return made

    def new(self, name, arguments):
        """Creates an object of that class."""
        return self._run(self._jpype.JClass(name), arguments, name, None)

    def call(self, method, arguments, class_name, name):
        """Calls a method and converts its result."""
        answer = self._run(method, arguments, class_name, name)
        return answer if type(answer) in _PLAIN else self.to_python(answer)

    def _run(self, method, arguments, class_name, name):
        try:
            return self._interrupter.call(method, arguments)
        except self._jpype.JException as error:
            raise self._translated(error) from None
        except OverflowError as error:
            from ._hints.python3 import misfit
            raise (OverflowError(misfit(class_name, name, arguments, 31)) if "Java int" in str(error)
                   else _errors.too_large(name or class_name.rpartition(".")[2], arguments)) from None
        except TypeError as error:
            if "No matching overloads" not in str(error):
                raise
            from ._hints.python3 import misfit
            raise TypeError(misfit(class_name, name, arguments)) from None

    def wait(self, java, name, argument):
        """Makes a waiting call that an interrupt ends. Main thread."""
        _errors.refuse_large(name, [argument])
        self._waiter.run(lambda: self.run(self._jpype.JClass(WAITS).call, java, name, self.java_list([argument])))

    def _translated(self, error):
        message = error.getMessage()
        return _errors.of([kind.__name__.rpartition(".")[2] for kind in type(error).__mro__], None if message is None else str(message))

    def raw_class(self, name):
        """Returns JPype's own class, for frequent calls to Java."""
        return self._jpype.JClass(name)

    def run(self, method, *arguments):
        """Calls a method of such a class; returns JPype's result and translates Java's exceptions."""
        try:
            return self._interrupter.call(method, arguments)
        except self._jpype.JException as error:
            raise self._translated(error) from None

    def translated(self, error):
        """Translates a Java exception; returns other exceptions unchanged."""
        return self._translated(error) if isinstance(error, self._jpype.JException) else error

    def shared(self, size):
        """Returns memory shared by Python and Java: a bytearray, and the java.nio.ByteBuffer over it."""
        memory = bytearray(size)
        return memory, self._jpype.nio.convertToDirectBuffer(memory)

    def member(self, java, name):
        """Returns a method, or the value of a field or property: ("method", callable), ("value", its value) or (None,
        None)."""
        kind = str(self._members.kind(java, name))
        if kind == "method":
            return "method", getattr(java, name)
        return ("value", self._members.value(java, name)) if kind == "value" else (None, None)

    def static(self, class_name, name):
        """Returns the same for a class."""
        found = getattr(self._jpype.JClass(class_name), name, None)
        if found is None:
            return None, None
        return "method" if callable(found) and not isinstance(found, self._jpype.JObject) else "value", found

    def assign(self, java, name, value):
        """Changes a field or property."""
        try:
            self._members.assign(java, name, value)
        except self._jpype.JException as error:
            raise self._translated(error) from None

    def exists(self, class_name):
        """Whether Java has a class of that full name."""
        return self._members.find(class_name) is not None

    def ask(self, question, class_name, *more):
        """Returns names or signatures: the answer of the Java class Members."""
        return [str(one) for one in getattr(self._members, question)(self.java_class(class_name), *more)]

    def names(self, class_name):
        """Returns the names of its members."""
        return [str(one) for one in self._members.names(self.java_class(class_name))]

    def text(self, java):
        """Returns the result of toString."""
        return str(java.toString())

    def same(self, one, other):
        """Whether two objects are equal."""
        return bool(one.equals(other))

    def hash(self, java):
        """Returns the object's hash code."""
        return int(java.hashCode())

    def to_python(self, value):
        """Converts numbers, texts, lists and maps to Python's, arrays of numbers to numpy's; all else becomes a
        proxy."""
        if type(value) in _PLAIN:
            return value
        if isinstance(value, self._jpype.JArray):
            return self._array(value)
        if type(value).__name__ == "java.lang.Boolean":
            return bool(value)
        for plain in (float, int, str):
            if isinstance(value, plain):
                return plain(value)
        if isinstance(value, self._java_list):
            return [self.to_python(one) for one in value]
        if isinstance(value, self._java_map):
            return {self.to_python(entry.getKey()): self.to_python(entry.getValue()) for entry in value.entrySet()}
        return wrap(value, str(self._members.className(value)))

    def _array(self, value):
        name = type(value).__name__
        if name == "byte[]":
            return bytes(value)
        return numpy.array(value) if name in _NUMBERS else [self.to_python(one) for one in value]

    def close(self):
        """Stops simulations, so that their records and ports are complete. The Java machine ends with the process."""
        for service in self._jpype.JClass("org.myrobotlab.service.Runtime").getServices():
            if str(self._members.className(service)) == SEAR and service.isSimulating():
                service.stopSimulation()
