# SPDX-License-Identifier: Apache-2.0
"""Lists the legal calls after a call with wrong arguments, and explains the wrong one."""
import functools
import re

from . import names

NO_NAMES = "arguments have no names: write only their values, in this order"
_MOST = 12
_UNKNOWN = object()
_NUMBER = "a number, without quotation marks"
_WORDS = {"double": _NUMBER, "float": _NUMBER, "int": "a whole number from %d to %d, without quotation marks" % (-2 ** 31, 2 ** 31 - 1),
          "long": "a whole number, without quotation marks", "str": "a string in quotation marks", "String": "a string in quotation marks",
          "bool": "True or False", "boolean": "True or False"}
_KINDS = {"str": "text", "bool": "truth", "float": "number", "int": "number"}


def refused(failure, java):
    """Returns a hint for Jython's error about arguments that don't fit; else empty."""
    found = re.match(r"([\w.$]+)\(\): (?:expected .* args?; got \d+|(\d+)\w\w arg can't be coerced to (.+))$", failure.message)
    if not found:
        return ""
    name = found.group(1)
    signatures = _constructors(name, java) if "." in name else _methods(name, failure, java)
    return misfit(names.simple(name), signatures, failure, java, found.group(2), found.group(3))


def _constructors(kind, java):
    return [(names.simple(kind), one) for one in java.calls(kind, None) if not one.endswith("()")]


def _methods(name, failure, java):
    """Returns pairs of written name and signature: of the objects that the line names, else of all objects."""
    named = [one for one in re.findall(r"(\w+)\.%s\(" % re.escape(name), failure.line) if one in failure.scope]
    objects = [one for one in failure.scope if failure.line or not isinstance(failure.scope[one], type)]
    for owners in (named or objects, failure.scope):
        kinds = [(owner, java.type_of(failure.scope[owner])) for owner in sorted(owners)]
        found = [(owner + "." + name, one) for owner, kind in kinds if kind for one in java.calls(kind, name)]
        if found:
            return found
    return []


def misfit(name, signatures, failure, java, number=None, types=None):
    """Returns a hint and the legal calls.

    signatures: pairs of written name and signature.
    number: of the wrong argument, from 1; None if unknown. types: its legal types.
    """
    hint = _reason(name, signatures, failure, java, number, types) if signatures else ""
    return (hint and hint + "\n") + legal(signatures)


def legal(signatures):
    """Returns the lines with the legal calls; empty without one."""
    written = sorted(set(before + "(%s)" % ", ".join(name for name, _ in parameters(signature)) for before, signature in signatures),
                     key=lambda one: (len(one), one))
    return "legal: " + "\n       ".join(written[:_MOST]) if written else ""


def parameters(signature):
    """Returns pairs of name and type."""
    inside = signature[signature.index("(") + 1:-1]
    return [tuple(one.split(": ")) if ": " in one else (one, "") for one in inside.split(", ") if one]


def _reason(name, signatures, failure, java, number, types):
    given = arguments(name, failure.line)
    ordered = sorted(set(one for one in (_in_order(given, failure.scope, *one) for one in signatures) if one))
    if ordered:
        return "the arguments are in the wrong order: did you mean %s?" % " or ".join(ordered)
    if given and re.search(r"[(,\s]-?\d+,\d+\s*[),]", failure.line):
        return "write decimals with a point, as 0.5: a comma starts the next argument"
    if number:
        written = given[int(number) - 1] if int(number) <= len(given) else ""
        words = dict.fromkeys(_WORDS.get(one, "a " + names.simple(one)) for one in types.split(", "))
        return _wrong(written, failure.scope, types, java) or "argument %s must be %s" % (number, ", or ".join(sorted(words)))
    if any(re.match(r"\w+\s*=[^=]", one) for one in given):
        return NO_NAMES
    return ""


def arguments(name, line):
    """Returns the arguments of the line's first call of that name as written; none if the call doesn't end there."""
    found = re.search(r"\b%s\s*\(" % re.escape(name), line)
    import tokenize    # here, because Jython takes 0.2 s of processor time for it
    given = []
    depth, begin = 1, 0
    rest = line[found.end():] if found else ""
    try:
        for _, text, (_, column), _, _ in tokenize.generate_tokens(functools.partial(next, iter([rest + "\n"]), "")):
            depth += (text in ("(", "[", "{")) - (text in (")", "]", "}"))
            if depth == 0 or depth == 1 and text == ",":
                given.append(rest[begin:column].strip())
                begin = column + 1
            if depth == 0:
                return [] if "" in given else given
    except (tokenize.TokenError, SyntaxError):
        pass
    return []


def _in_order(given, scope, written, signature):
    """Returns the call with its arguments in the order that fits; None if no other order does."""
    left, ordered = list(given), []
    for _, kind in parameters(signature):
        fit = next((one for one in left if _KINDS.get(kind) == _kind(one, scope)), None)
        if fit is None:
            return None
        left.remove(fit)
        ordered.append(fit)
    return None if left or ordered == given else "%s(%s)" % (written, ", ".join(ordered))


def _value(written, scope):
    if re.match(r"[A-Za-z_]\w*$", written):
        return {"True": True, "False": False}.get(written, scope.get(written, _UNKNOWN))
    if re.match(r"[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$", written, re.I):
        return 0
    return "" if re.match("u?(\"[^\"]*\"|'[^']*')$", written, re.I) else _UNKNOWN


def _kind(written, scope):
    value = _value(written, scope)
    if isinstance(value, bool):
        return "truth"
    return "text" if isinstance(value, (str, type(u""))) else "number" if isinstance(value, (int, float)) or type(value).__name__ == "long" else None


def _wrong(written, scope, types, java):
    """Explains why a variable has the wrong type; empty without an explanation."""
    value = scope.get(written, _UNKNOWN)
    if value is _UNKNOWN:
        return ""
    if ("String" in types or "str" in types) and not isinstance(value, type) and (java.type_of(value) or "").startswith(names.POJOS):
        return '%s is the object itself; give its name, "%s"' % (written, value.getName())
    if isinstance(value, tuple):
        numbers = ".".join(str(one) for one in value)
        return "%s is %s, %s" % (written, value, "two numbers: write decimals with a point, " + numbers if len(value) == 2 else "several numbers")
    return "%s is a string, %r" % (written, value) if isinstance(value, (str, type(u""))) else ""
