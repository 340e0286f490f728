"""Errors name the argument, its value and what is legal; no process starts before the checks."""
import sear
from sear.sweeps.__main__ import main


def function(seed, speed):
    """Accepts the arguments of a sweep."""


def refused(words, call):
    """Checks that a call raises ValueError with these words."""
    try:
        call()
    except ValueError as error:
        assert words in str(error), (words, str(error))
        return
    raise AssertionError("not refused: " + words)


good = {"speed": [1]}
refused("function is 7, legal: a function of seed and parameters", lambda: sear.sweep(7))
refused("can't be called with seed, fast: ", lambda: sear.sweep(function, {"fast": [1]}))
refused("parameter name is \"seed\", legal: letters, digits and _", lambda: sear.sweep(function, {"seed": [1]}))
refused("parameter speed is 0.3, legal: a list of numbers, texts, True or False", lambda: sear.sweep(function, {"speed": 0.3}))
refused("parameter speed is None, legal: a list of numbers", lambda: sear.sweep(function, {"speed": [None]}))
refused("parameter speed has 1 twice, legal: each value once", lambda: sear.sweep(function, {"speed": [1, 2, 1]}))
refused("seeds is 0, legal: a count from 1 to 10000000, or A:B", lambda: sear.sweep(function, good, 0))
refused("seeds is [1, 1], legal: at least one seed, and none twice", lambda: sear.sweep(function, good, [1, 1]))
refused("limit is 0, legal: a number above 0", lambda: sear.sweep(function, good, limit=0))
refused("memory is \"much\", legal: a number above 0", lambda: sear.sweep(function, good, memory="much"))
refused("workers is 0, legal: a whole number from 1 to 1024", lambda: sear.sweep(function, good, workers=0))
refused("scheduler_file is nowhere.json, legal: a file that a Dask scheduler has written",
        lambda: sear.sweep(function, good, scheduler_file="nowhere.json"))
refused("row 3 can't be run again: no folder is given", lambda: sear.sweep(function, good, again=3))
for arguments in (["none.py"], ["script.py", "--seeds=5:1"], ["script.py", "--set=speed"], ["script.py", "--set=speed=0:1:1"], ["script.py", "--limit=-1"],
                  ["script.py", "--set=a=1", "--set=a=2"], ["script.py", "--again=0"]):
    assert main(arguments) == 2, arguments
print("all refused")
