# SPDX-License-Identifier: Apache-2.0
"""SEAR's exceptions: messages from Java, types that are also Python's, so that `except ValueError` works."""
import os
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))


class JavaError(Exception):
    """An error in SEAR or MyRobotLab. Its text is the message, without the name of the Java exception."""


class IllegalArgumentException(JavaError, ValueError):
    """A value is not legal; the message names the object, the value and the legal range."""


class IllegalStateException(JavaError, RuntimeError):
    """The call is not possible now; the message says what to do first."""


class IOException(JavaError, OSError):
    """A file or port can't be used."""


class UnsupportedOperationException(JavaError, NotImplementedError):
    """The object does not support this call."""


class NullPointerException(JavaError, TypeError):
    """An argument is None where an object is required."""


_TYPES = {kind.__name__: kind for kind in (IllegalArgumentException, IllegalStateException, IOException, UnsupportedOperationException,
                                           NullPointerException)}
for _kind in (JavaError, *_TYPES.values()):
    _kind.__module__ = "sear"


def of(names, message):
    """Returns the Python exception for a Java one.

    names: its class and superclasses, the nearest first, without packages.
    message: its text; None if it has none.
    """
    kind = next((_TYPES[name] for name in names if name in _TYPES), JavaError)
    return kind(message if message else names[0])


def misfit(name, arguments, legal):
    """Returns the message for a call that no Java method accepts."""
    given = ", ".join(type(one).__name__ for one in arguments)
    return "%s can't be called with (%s)%s" % (name, given, "; legal: " + ", or ".join(legal) if legal else "")


def too_large(name, arguments, bits):
    """Returns the exception for an integer that no Java method accepts."""
    return OverflowError("%s is called with (%s), legal: whole numbers from %d to %d"
                         % (name, ", ".join(map(repr, arguments)), -2 ** bits, 2 ** bits - 1))


def refuse_large(name, arguments):
    """Raises that exception if an integer does not fit into a Java long."""
    if any(type(one) is int and not -2 ** 63 <= one < 2 ** 63 for one in arguments):
        raise too_large(name, arguments, 63)


def told(error):
    """Returns an error with its traceback as Python prints it, without this package's own lines."""
    whole = traceback.TracebackException.from_exception(error)
    part = whole
    while part is not None:
        part.stack = traceback.StackSummary.from_list([frame for frame in part.stack if os.path.dirname(frame.filename) != HERE])
        part = part.__cause__ or part.__context__
    return "".join(whole.format())
