# SPDX-License-Identifier: Apache-2.0
"""Explains errors of scripts in the words of SEAR. Runs on Python 2.7 (Jython in both MyRobotLabs) and Python 3.

jython and python3 connect it to errors and to Java. Java's side is an object with these members:

    objects: the names of the objects' classes
    type_of(value): the full name of a value's Java class, or of the Java class that it is; None for Python's values
    exists(name): whether Java has a class of that full name
    calls(type, name): the signatures of a method, as "drive(speed: float, radius: float)"; of the constructors if name
        is None
    names(type), own(type): the names of all public members, and of those that the class itself declares
    missing(type): why this MyRobotLab lacks a service type; empty if only the real one could have it
"""
import re

from . import calls, names

_PLACE = "x", "y", "z"
_TURN = "rx", "ry", "rz"
# Words of an error and of its line, with the hint
_READINGS = (
    ("index", ".getBlobs(", "getBlobs returns an empty list if the picture shows no region of that colour: test len(...) first"),
    ("truth value of an array", "", "it has many numbers, of which a comparison compares each: write list.min() < 1, or list[0] < 1"))
_ANSWERS = ((".getPose(", "; getPose returns six: x, y, z, rx, ry, rz"),
            (".getGpsResult(", "; getGpsResult returns three: latitude, longitude, altitude"))


class Failure(object):
    """An error of a script.

    kinds: the names of its class and superclasses.
    message: its text.
    line: the innermost line of the script, stripped; empty if unknown.
    scope: the names that this line can use, with their values.
    source: the text of the script; empty if unknown.
    """

    def __init__(self, kinds, message, line, scope, source=""):
        self.kinds = frozenset(kinds)
        self.message = message
        self.line = line
        self.source = source
        self.scope = dict((name, value) for name, value in scope.items() if not name.startswith("_"))


def explain(failure, java):
    """Returns lines to print after an error; none without a hint."""
    hint = _hint(failure, java)
    return hint.split("\n") if hint else []


def _hint(failure, java):
    message = failure.message
    fixed = re.search(r"read-only attr: (\w+)|^(\w+) of \w+ can't be assigned", message)
    if fixed:
        name = fixed.group(1) or fixed.group(2)
        return "legal: move(x, y, z)" if name in _PLACE else "legal: rotate(rx, ry, rz)" if name in _TURN else ""
    for words, call, hint in _READINGS:
        if words in message and call in failure.line:
            return hint
    if re.search(r"unsubscriptable|invalid index to scalar|'int' object is not subscriptable", message) and "][" in failure.line:
        return ("it is one list, without rows: the pixel in column x and row y of a picture is list[y * width + x]"
                if "getPixels(" in failure.source else "this list has one index")
    if "ImportError" in failure.kinds:
        return names.imported(failure, java)
    if "TypeError" in failure.kinds:
        return names.made(message, java) or _plain(message) or calls.refused(failure, java)
    if "ValueError" in failure.kinds and "to unpack" in message:
        answers = _answers(failure.line)
        return answers and "the = needs one name on its left for each value" + answers
    local = re.search(r"local variable '(\w+)'", message)
    if "UnboundLocalError" in failure.kinds and local:
        return "%s is assigned in this function, which makes it local: start the function with global %s" % (local.group(1), local.group(1))
    if "NameError" in failure.kinds:
        return names.undefined(failure, java)
    return _attribute(failure, java) if "AttributeError" in failure.kinds else ""


def _plain(message):
    if message.startswith(("cannot concatenate 'str'", "can only concatenate str")):
        return 'print("a", b) prints both; str(b) converts a number to a string, and "%.2f m" % b formats it'
    return "a reading is an object; its number is reading.value" if "SensorReading" in message else ""


def _attribute(failure, java):
    if "'NoneType' object has no attribute" in failure.message:
        return "the object before the dot is None: the call that returned it has failed, or returns nothing"
    if failure.message.startswith(("'array.array'", "'numpy.ndarray'")):
        return "it is a list of numbers: get one by its index, as list[0]" + _answers(failure.line)
    return names.member(failure, java)


def _answers(line):
    return next((answer for call, answer in _ANSWERS if call in line), "")


def lines_of(source):
    """Returns the lines of a script."""
    return re.sub(u"^\ufeff", "", source).replace("\r\n", "\n").replace("\r", "\n").split("\n")


def line_of(lines, number):
    """Returns a line, counted from 1; empty if there is none."""
    return lines[number - 1] if 0 < number <= len(lines) else ""


def callback(message, function):
    """Returns the expected signature and the place of a function that takes no or several arguments; else empty."""
    code = getattr(function, "__code__", None)
    if code is None or not re.search(r"\(\) (takes .* argument|missing )", message):
        return ""
    return "a callback gets one argument: def %s(value): (line %d of %s)" % (function.__name__, code.co_firstlineno, code.co_filename)
