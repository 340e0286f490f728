# SPDX-License-Identifier: Apache-2.0
"""Runs a script like `sear SCRIPT.py`: python3 -m sear SCRIPT.py [ARGUMENT ...].

The script can use Runtime, python and sleep without an import, and import Java's packages, as in MyRobotLab.
"""
import importlib.util
import os
import sys
import time
import types

NEEDED = {"numpy": "numpy", "py4j": "py4j", "jpype": "JPype1"}


def _missing(remote):
    wanted = ("numpy", "py4j") if remote else ("numpy", "jpype")
    return [NEEDED[name] for name in wanted if importlib.util.find_spec(name) is None]


def main(arguments):
    """Returns the exit status."""
    if not arguments:
        print("usage: python3 -m sear SCRIPT.py [ARGUMENT ...]", file=sys.stderr)
        return 2
    remote = os.environ.get("SEAR_GATEWAY")
    missing = _missing(remote)
    if missing:
        print("sear: this Python (%s) lacks %s: %s -m pip install %s" % (sys.executable, " and ".join(missing), sys.executable, " ".join(missing)),
              file=sys.stderr)
        return 1
    import sear
    from sear import _errors
    from sear import _modules
    from sear._hints import silent
    if remote:
        sear.connect(int(remote))
    _modules.install()
    script = arguments[0]
    try:
        with open(script, "rb") as file:
            source = file.read()
    except OSError as error:
        print("sear: %s can't be read: %s" % (script, error.strerror), file=sys.stderr)
        return 2
    for text in silent.mistakes(source, script):
        print("[WARN] " + text, file=sys.stderr)
    module = types.ModuleType("__main__")
    module.__dict__.update(__file__=os.path.abspath(script), Runtime=sear.Runtime, python=sear.python, sleep=time.sleep)
    sys.modules["__main__"] = module
    sys.argv = list(arguments)
    sys.path[0] = os.path.dirname(os.path.abspath(script))
    try:
        exec(compile(source, script, "exec"), module.__dict__)
    except Exception as error:
        print(_errors.told(error), end="", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    finally:
        sear.close()
    return 1 if sear.python.failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
