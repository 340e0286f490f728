# SPDX-License-Identifier: Apache-2.0
"""Hints in the Python 3 package: in the messages of its own errors, and after the traceback of others."""
import builtins
import linecache
import os
import sys

from . import Failure, calls, callback, explain, names
from .. import _objects
from .._names import OBJECTS

_PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# Services of SEAR, for errors before Java runs
_OF_SEAR = frozenset(names.SERVICES + one for one in ("SEAR", "LIDAR", "GPS"))


class _Java:
    """Java by the connection: see the package. Doesn't start Java."""

    objects = OBJECTS

    @staticmethod
    def type_of(value):
        """Returns the full name of a value's Java class."""
        kind = value if isinstance(value, type) else type(value)
        return kind.java_name if issubclass(kind, _objects.JavaObject) else None

    @staticmethod
    def _ask(question, kind, *more):
        backend = _objects.connection.backend
        return [] if backend is None else backend.ask(question, kind, *more)

    def exists(self, name):
        """Returns whether Java has a class."""
        backend = _objects.connection.backend
        return name in _OF_SEAR or backend is not None and backend.exists(name)

    def calls(self, kind, name):
        """Returns signatures."""
        return self._ask("constructors", kind) if name is None else self._ask("methods", kind, name)

    def names(self, kind):
        """Returns the names of members."""
        return self._ask("names", kind)

    def own(self, kind):
        """Returns the names of declared members."""
        return self._ask("ownNames", kind)

    def missing(self, kind):
        """Returns why a service type is missing."""
        types = "org.myrobotlab.embedded.python.ServiceTypes"
        return _objects.java_class(types).hint(kind) if self.exists(types) else ""


def _failure(kinds=(), message=""):
    """Describes an error at the line that calls this package."""
    frame = sys._getframe()
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_PACKAGE):
        frame = frame.f_back
    return Failure(kinds, message, linecache.getline(frame.f_code.co_filename, frame.f_lineno, frame.f_globals).strip(),
                   {**frame.f_globals, **frame.f_locals})


def _fits(kind, value, bits):
    if kind == "int":
        return not isinstance(value, bool) and hasattr(value, "__index__") and -2 ** bits <= int(value) < 2 ** bits
    if kind == "float":
        return not isinstance(value, bool) and hasattr(value, "__float__")
    if kind in ("str", "bool"):
        return isinstance(value, str if kind == "str" else bool)
    return hasattr(value, "__iter__") and not isinstance(value, str) if kind == "list" else value is None or _Java.type_of(value) is not None


def _signatures(kind, name):
    """Returns pairs of written name and signature."""
    failure = _failure()
    if name is None:
        return [(names.simple(kind), one) for one in _Java().calls(kind, None) if not one.endswith("()")], failure
    owners = [one for one in sorted(failure.scope) if _Java.type_of(failure.scope[one]) == kind and one + "." + name in failure.line]
    written = "%s.%s" % (owners[0], name) if owners else name
    return [(written, one) for one in _Java().calls(kind, name)], failure


def misfit(kind, name, arguments, bits=63):
    """Returns the message for a call that no Java method accepts.

    kind: the Java class. name: of the method; None for a constructor.
    bits: of legal whole numbers, without the sign.
    """
    simple = name or names.simple(kind)
    signatures, failure = _signatures(kind, name)
    wrong = {}
    for _, signature in signatures:
        types = [one for _, one in calls.parameters(signature)]
        first = next((i for i, one in enumerate(types) if len(types) == len(arguments) and not _fits(one, arguments[i], bits)), None)
        if first is not None:
            wrong.setdefault(first, set()).add(types[first])
    number = max(wrong) if wrong else None
    hint = calls.misfit(simple, signatures, failure, _Java(), *((number + 1, ", ".join(sorted(wrong[number]))) if wrong else ()))
    return "%s can't be called with (%s)%s" % (simple, ", ".join(type(one).__name__ for one in arguments), hint and "\n" + hint)


def named(kind, name):
    """Returns the message for a call with argument names."""
    return "%s: %s\n%s" % (name or names.simple(kind), calls.NO_NAMES, calls.legal(_signatures(kind, name)[0]))


def unknown(kind, name):
    """Returns the message for a member that a Java class doesn't have."""
    hint = names.suggested(name, kind, _failure().scope, _Java())
    return "'%s' object has no attribute '%s'%s" % (names.simple(kind), name, hint and "\n" + hint)


def after(error, function=None):
    """Returns lines to print after the traceback of an error, each with its line break; empty without a hint.

    function: the function that was called back; None if none was.
    """
    last = error.__traceback__
    if last is None:
        return ""
    called = callback(str(error), function) if last.tb_next is None else ""
    while last.tb_next is not None and not last.tb_next.tb_frame.f_code.co_filename.startswith(_PACKAGE):
        last = last.tb_next
    frame = last.tb_frame
    line = linecache.getline(frame.f_code.co_filename, last.tb_lineno, frame.f_globals).strip()
    failure = Failure([one.__name__ for one in type(error).__mro__], str(error), line,
                      {**vars(builtins), **frame.f_globals, **frame.f_locals}, "".join(linecache.getlines(frame.f_code.co_filename)))
    lines = ([called] if called else []) + (_invalid(error) if isinstance(error, SyntaxError) else explain(failure, _Java()))
    return "".join(one + "\n" for one in lines)


def _invalid(error):
    from . import syntax
    source = "".join(linecache.getlines(error.filename or ""))
    hint = syntax.hint(syntax.Scan(source), error.lineno, error.msg) if source and error.lineno else ""
    return [hint] if hint else []
