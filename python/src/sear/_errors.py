"""What SEAR raises: the words are Java's, the types also those of Python, so that `except ValueError` works."""
import os
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))


class JavaError(Exception):
    """Something went wrong in SEAR or MyRobotLab. Its text is the message, without the name of Java's exception."""


class IllegalArgumentException(JavaError, ValueError):
    """A value is not legal; the message names thing, value and legal range."""


class IllegalStateException(JavaError, RuntimeError):
    """It can't be done now; the message says what to do first."""


class IOException(JavaError, OSError):
    """A file or port can't be used."""


class UnsupportedOperationException(JavaError, NotImplementedError):
    """This thing can't do that."""


class NullPointerException(JavaError, TypeError):
    """None was given where a thing is needed."""


_TYPES = {kind.__name__: kind for kind in (IllegalArgumentException, IllegalStateException, IOException, UnsupportedOperationException,
                                           NullPointerException)}
for _kind in (JavaError, *_TYPES.values()):
    _kind.__module__ = "sear"


def of(names, message):
    """The exception for one of Java.

    names: its class and those above it, the nearest first, without packages.
    message: its text; None if it has none.
    """
    kind = next((_TYPES[name] for name in names if name in _TYPES), JavaError)
    return kind(message if message else names[0])


def misfit(name, arguments, legal):
    """What is said of a call that there is not."""
    given = ", ".join(type(one).__name__ for one in arguments)
    return "%s can't be called with (%s)%s" % (name, given, "; legal: " + ", or ".join(legal) if legal else "")


def too_large(name, arguments, bits):
    """The exception for a whole number that no call of Java's takes."""
    return OverflowError("%s is called with (%s), legal: whole numbers from %d to %d"
                         % (name, ", ".join(map(repr, arguments)), -2 ** bits, 2 ** bits - 1))


def refuse_large(name, arguments):
    """Raises it if a whole number is too large even for a long one."""
    if any(type(one) is int and not -2 ** 63 <= one < 2 ** 63 for one in arguments):
        raise too_large(name, arguments, 63)


def told(error):
    """An error with its traceback as Python prints it, without the lines of this package."""
    whole = traceback.TracebackException.from_exception(error)
    part = whole
    while part is not None:
        part.stack = traceback.StackSummary.from_list([frame for frame in part.stack if os.path.dirname(frame.filename) != HERE])
        part = part.__cause__ or part.__context__
    return "".join(whole.format())
