# SPDX-License-Identifier: Apache-2.0
"""SEAR's exceptions: messages from Java, types that are also Python's, so that `except ValueError` works."""
import os
import sys
import threading
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


def too_large(name, arguments):
    """Returns the exception for an integer that no Java method accepts."""
    return OverflowError("%s is called with (%s), legal: whole numbers from %d to %d"
                         % (name, ", ".join(map(repr, arguments)), -2 ** 63, 2 ** 63 - 1))


def refuse_large(name, arguments):
    """Raises that exception if an integer does not fit into a Java long."""
    if any(type(one) is int and not -2 ** 63 <= one < 2 ** 63 for one in arguments):
        raise too_large(name, arguments)


def told(error, function=None):
    """Returns an error with its traceback as Python prints it, without this package's own lines, and with hints.

    function: the function that was called back; None if none was.
    """
    whole = traceback.TracebackException.from_exception(error)
    part = whole
    while part is not None:
        part.stack = traceback.StackSummary.from_list([frame for frame in part.stack if os.path.dirname(frame.filename) != HERE])
        part = part.__cause__ or part.__context__
    return "".join(whole.format()) + hint(error, function)


def hint(error, function=None):
    """Returns lines that explain an error; empty without a hint, which never hides the error itself."""
    try:
        from ._hints.python3 import after
        return after(error, function) if isinstance(error, Exception) else ""
    except Exception:    # a name of the script that breaks its own look-up
        return ""


def install():
    """Adds hints to the tracebacks of errors that end the program or a thread, and that a notebook shows."""
    whole, of_thread = sys.excepthook, threading.excepthook

    def end(kind, error, trace):
        whole(kind, error, trace)
        print(hint(error), end="", file=sys.stderr)

    def end_thread(failed):
        of_thread(failed)
        print(hint(failed.exc_value), end="", file=sys.stderr)

    sys.excepthook, threading.excepthook = end, end_thread
    notebook = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    if notebook is not None:
        def shown(shell, kind, error, trace, tb_offset=None):
            shell.showtraceback((kind, error, trace), tb_offset=tb_offset)
            print(hint(error), end="", file=sys.stderr)
        notebook.set_custom_exc((NameError, AttributeError, TypeError, ValueError, ImportError), shown)
