# SPDX-License-Identifier: Apache-2.0
"""Suggestions for unknown names, members and modules."""
import re
import sys

PYTHON3 = sys.version_info[0] > 2

SERVICES = "org.myrobotlab.service."
POJOS = "org.SEAR.POJOs."
IMPORT = "from org.SEAR.POJOs import "
# Lowest similarity of a suggestion, and the weight of a match without the known name's first word
_NEAR = 0.65
_WITHOUT_VERB = 0.9
_MOST = 4
# Popular packages that need CPython
_OF_CPYTHON = frozenset(("numpy", "scipy", "pandas", "matplotlib", "cv2", "serial", "pylab", "tkinter", "requests"))
_MODULES = frozenset(("math", "time", "random", "os", "json", "threading", "datetime", "csv", "re"))
_OF_MATH = frozenset(("sqrt", "sin", "cos", "tan", "atan", "atan2", "asin", "acos", "pi", "radians", "degrees", "hypot", "floor", "ceil",
                      "exp", "log", "fabs"))
_NOTHING = frozenset(("null", "nil", "undefined", "NULL", "none"))
# Common words for objects of SEAR
_WORDS = dict((word, meant) for meant, words in (
    ("Distance", "sonar ultrasonic ultrasonicsensor infrared ping distancesensor rangesensor radar sensor"),
    ("Box", "wall cube block crate obstacle"), ("Sphere", "ball"), ("Floor", "ground plane"), ("SEARrobot", "robot"),
    ("Robots", "rover create"), ("Gyroscope", "gyro"), ("Accelerometer", "accel"), ("Led", "light"), ("LIDAR", "scanner laser"))
    for word in words.split())


def nearest(wanted, known):
    """Returns `did you mean startSimulation?`; empty if no known name is similar."""
    known = sorted(set(known))
    same = [one for one in known if one.lower() == wanted.lower()]
    verbs = [one for one in known if len(wanted) > 2 and re.match(re.escape(wanted) + "[A-Z]", one)]
    if same or verbs:
        return _question(same[:1] or verbs[:_MOST])
    near = [(_nearness(wanted.lower(), one), _likelihood(one), one) for one in known if len(wanted) > 1]
    best = max(near, key=lambda one: one[:2]) if near else (0, 0, "")    # of equals the first
    return _question([best[2]]) if best[0] >= _NEAR else ""


def _question(meant):
    return "did you mean %s?" % " or ".join(meant)


def _nearness(wanted, known):
    rest = re.sub("^[a-z]+(?=[A-Z])", "", known)
    whole = _similarity(wanted, known.lower())
    return whole if rest == known else max(whole, _WITHOUT_VERB * _similarity(wanted, rest.lower()))


def _similarity(one, other):
    import difflib    # here, because Jython takes 0.1 s of processor time for it
    matcher = difflib.SequenceMatcher(None, one, other)
    return 0 if matcher.real_quick_ratio() < _NEAR or matcher.quick_ratio() < _NEAR else matcher.ratio()


def _likelihood(name):
    return 0 if re.match("(is|has|get)[A-Z]", name) else 2 if name.startswith("start") else 1


def undefined(failure, java):
    """Returns a hint for an undefined name; else empty."""
    found = re.search(r"name '(\w+)' is not defined", failure.message)
    if not found:
        return ""
    wanted = found.group(1)
    if wanted in ("exit", "quit"):
        return "a script ends after its last line; sys.exit() ends it earlier"
    return (_of_python(wanted) or _service_of(wanted, failure.scope, java) or _unimported(wanted, java)
            or _method_of(wanted, failure.scope, java) or nearest(wanted, failure.scope))


def _of_python(wanted):
    if wanted in _MODULES:
        return "it is a Python module: write import %s in an earlier line" % wanted
    if wanted in _OF_MATH:
        return "it is in a Python module: from math import " + wanted
    return "did you mean None?" if wanted in _NOTHING else ""


def _service_of(wanted, scope, java):
    """Suggests the script's variable for a service that is written by its type, as robot for sear."""
    found = ""
    for name in sorted(scope):
        kind = None if isinstance(scope[name], type) else java.type_of(scope[name])
        if kind and kind.lower() == SERVICES + wanted.lower() and (not found or scope[name].getName() != name):
            found = name
    if not found or wanted == wanted.upper():
        return ""
    return "did you mean %s, this script's name for its service %s?" % (found, simple(java.type_of(scope[found])))


def _unimported(wanted, java):
    is_service = java.exists(SERVICES + wanted)
    if wanted in java.objects:
        return "import it first: " + IMPORT + wanted + ("; or, for the service, " + start(wanted) if is_service else "")
    if is_service:
        return "start a service like this: " + start(wanted)
    return _meant(wanted, java) if wanted[0].isupper() and wanted.lower() in _WORDS else ""


def _meant(wanted, java):
    """Suggests the object for a name in other letters, or a common word for it."""
    same = [one for one in java.objects if one.lower() == wanted.lower()]
    meant = same[0] if same else _WORDS.get(wanted.lower())
    return "SEAR has no %s; did you mean %s%s?" % (wanted, IMPORT, meant) if meant else ""


def _method_of(wanted, scope, java):
    """Suggests the object of a method that was called without one: sear.simSleep(1) for simSleep(1)."""
    for owner in sorted(scope):
        kind = None if isinstance(scope[owner], type) else java.type_of(scope[owner])
        if kind and kind.startswith(("org.SEAR.", "org.myrobotlab.")):
            for name in java.names(kind):
                if name.lower() == wanted.lower():
                    return "did you mean %s.%s?" % (owner, name)
    return ""


def member(failure, java):
    """Returns a hint for a member that a Java object or class doesn't have; else empty."""
    found = re.search(r"'([\w.$]+)'(?: object)? has no attribute '(\w+)'", failure.message)
    if not found:
        return ""
    owner, wanted = found.groups()
    if owner == "sear" and failure.message.startswith("module"):
        return _service("SEAR")
    return suggested(wanted, owner, failure.scope, java) if java.exists(owner) else ""


def suggested(wanted, owner, scope, java):
    """Returns a hint for a member that a Java class doesn't have; else empty."""
    called = _call_of(wanted, owner, scope, java) if owner.startswith(POJOS) else ""
    return called or nearest(wanted, java.own(owner)) or nearest(wanted, java.names(owner))


def _call_of(wanted, owner, scope, java):
    """Suggests the service's call for a call of an object: sear.drive("rover", ...) for rover.drive(...), or a reading
    for ping.getDistance()."""
    kind = simple(owner)
    call = "get%sResult" % kind if wanted in ("get" + kind, "read", "getValue") else wanted
    if call not in java.own(SERVICES + "SEAR"):
        return ""
    services = [name for name in sorted(scope) if not isinstance(scope[name], type) and java.type_of(scope[name]) == SERVICES + "SEAR"]
    if not services:
        return "%s is a method of the service SEAR, but the object before the dot is a %s" % (call, kind)
    return "%s is a method of the service and takes the name: did you mean %s.%s(...)?" % (
        call, "sear" if "sear" in services else services[-1], call)


def imported(failure, java):
    """Returns a hint for a failed import; else empty."""
    nothing = re.search(r"cannot import name '?(\w+)", failure.message)
    if nothing:
        return (SERVICES[:-1] in failure.line and java.missing(nothing.group(1))) or _meant(nothing.group(1), java)
    module = re.search(r"No module named '?(\w+)", failure.message)
    if not module:
        return ""
    wanted = module.group(1)
    if wanted in _OF_CPYTHON and not PYTHON3:
        late = "; #!/usr/bin/env python3 must be the first line" if re.search("(?m)^#!.*python3", failure.source) else ""
        return ("scripts are Python 2.7 (Jython), which can't use packages with C code: there is no %s. sear.savePlot(...) draws plots, and"
                " Python 3 programs can call SEAR (docs/python3.md)%s" % (wanted, late))
    if "org." in failure.line:
        return "did you mean " + IMPORT + "*?"
    service = next((one for one in (wanted, wanted.upper(), wanted.capitalize()) if java.exists(SERVICES + one)), None)
    objects = re.search("from .*import [A-Z]", failure.line)
    if service and not objects:
        return _service(service)
    same = wanted.lower() in [one.lower() for one in java.objects]
    return "import objects like this: " + IMPORT + "*" if service or same else _meant(wanted, java)


def _service(service):
    return "%s is a service of MyRobotLab, not a module: write %s instead of the import" % (service, start(service))


def made(message, java):
    """Returns a hint for a service's class called like a constructor; else empty."""
    found = re.match(r"org\.myrobotlab\.service\.(\w+)\(\): ", message)
    if not found:
        return ""
    name = found.group(1)
    if name not in java.objects:
        return "start a service like this: " + start(name)
    return ("%s is the service's class here, because a service of that type was started. After that line write %s%s to use the object"
            % (name, IMPORT, name))


def start(service):
    """Returns the line that starts a service."""
    return '%s = Runtime.start("%s", "%s")' % (service.lower(), service.lower(), service)


def simple(java_name):
    """Returns a class name without its package."""
    return re.split("[.$]", java_name)[-1]
