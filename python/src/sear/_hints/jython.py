# SPDX-License-Identifier: Apache-2.0
"""Hints in Jython, in the embedded MyRobotLab and a real one. Java calls these functions after an error."""
import __builtin__
import re
import types

from java.lang import Object
from org.myrobotlab.service.sear.python3 import Members

from . import Failure, callback, explain, line_of, lines_of, names
from ._names import OBJECTS


class _Java(object):
    """Java by its reflection: see the package."""

    objects = OBJECTS

    def type_of(self, value):
        """Returns the full name of a value's Java class."""
        of_java = issubclass(value, Object) if isinstance(value, type) else isinstance(value, Object)
        name = Members.typeName(value) if of_java else None
        return None if name is None or name.startswith("org.python.") else name

    def exists(self, name):
        """Returns whether Java has a class."""
        return Members.find(name) is not None

    def calls(self, kind, name):
        """Returns signatures."""
        return list(Members.constructors(Members.find(kind)) if name is None else Members.methods(Members.find(kind), name))

    def names(self, kind):
        """Returns the names of members."""
        return list(Members.names(Members.find(kind)))

    def own(self, kind):
        """Returns the names of declared members."""
        return list(Members.ownNames(Members.find(kind)))

    def missing(self, kind):
        """Returns why a service type is missing."""
        try:
            from org.myrobotlab.embedded.python import ServiceTypes
        except ImportError:
            return ""    # a real MyRobotLab
        return ServiceTypes.hint(kind)


def failed(kind, message, traceback, function, source):
    """Returns a hint for an exception.

    kind: its class. message: its text. traceback: None if it has none.
    function: the function that was called back; None if none was.
    source: gives the text of a file, empty if unknown.
    """
    innermost = traceback
    while innermost is not None and innermost.tb_next is not None:
        innermost = innermost.tb_next
    called = callback(message, function) if function is not None and (traceback is None or innermost is traceback) else ""
    if innermost is None:
        text, line, scope = "", "", {}
    else:
        frame = innermost.tb_frame
        text = source(frame.f_code.co_filename)
        line = line_of(lines_of(text), innermost.tb_lineno).strip()
        scope = {}
        for part in (frame.f_builtins, frame.f_globals, frame.f_locals):
            scope.update(part)
    failure = Failure([one.__name__ for one in kind.__mro__], message, line, scope, text)
    return "\n".join(([called] if called else []) + explain(failure, _Java()))


def printed(text, scope):
    """Returns a hint for an exception that a real MyRobotLab has published, whose frames are gone.

    text: Python's traceback, perhaps with Java's. scope: the interpreter's global names.
    """
    found = re.search(r"(?m)^(\w+): (.*)$", text[max(0, text.rfind('\n  File "')):])
    if not found:
        return ""
    kind, message = found.groups()
    kinds = [one.__name__ for one in getattr(getattr(__builtin__, kind, None), "__mro__", ())]
    if "SyntaxError" in kinds:
        import ast
        from . import syntax
        reason = re.match(r"\((?P<text>'.*'|\".*\"), \(.*?, \d+, -?\d+, (?P<line>.*)\)\)", message)
        line = ast.literal_eval(reason.group("line")) if reason else ""
        return syntax.hint(syntax.Scan(u"%s" % line.rstrip("\n")), 1, reason.group("text")) if line else ""
    known = dict(vars(__builtin__))
    known.update(scope)
    return "\n".join(explain(Failure(kinds, message, "", known), _Java()))


def invalid(value, source):
    """Returns the text of a syntax error with a hint."""
    from . import syntax
    scan = syntax.Scan(source)
    line = value.lineno
    found = scan.foreign
    if found and found[0] <= line:
        return foreign(value.filename, source)
    column = value.offset - 1 if isinstance(value.offset, int) else None
    hint = syntax.hint(scan, line, value.msg)
    return syntax.shown(value.filename, line, scan.line(line), column, "%s: %s" % (type(value).__name__, value.msg)) + (hint and "\n" + hint)


def foreign(file, source):
    """Returns the text of the error about a script's first character that Python doesn't know; empty without one."""
    from . import syntax
    scan = syntax.Scan(source)
    if not scan.foreign:
        return ""
    number, column, character = scan.foreign
    line = scan.line(number)
    return syntax.shown(file, number, line, column, u"SyntaxError: " + syntax.foreign(character, line, column))


def in_module(message):
    """Returns the text for a module's error that Jython can't represent, from Java's message; empty for others."""
    from . import syntax
    found = re.search(r"(?s)Cannot create PyString with non-byte value.*?\\u([0-9a-fA-F]{4})", message)
    return u"SyntaxError: in the code that this line loads, " + syntax.foreign(unichr(int(found.group(1), 16))) if found else ""


def function(wanted, scope):
    """Returns `; did you mean onScan?` for a missing function of the script; empty without a similar one."""
    meant = names.nearest(wanted, [name for name, value in scope.items() if isinstance(value, types.FunctionType)])
    return meant and "; " + meant


def mistakes(source, file):
    """Returns mistakes that Python accepts silently."""
    from . import silent
    return silent.mistakes(source, file)
