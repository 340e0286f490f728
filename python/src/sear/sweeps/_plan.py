# SPDX-License-Identifier: Apache-2.0
"""The plan of a sweep: seeds, values of parameters, and the order of rows."""
import hashlib
import itertools
import math
import numbers
import re

from .. import _home

NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*\Z")
TAKEN = ("row", "seed", "status", "message", "version", "digest")
CONTROLS = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
LEGAL_NAME = "letters, digits and _, not a digit first, and none of " + ", ".join(TAKEN)
SEED_LIMIT = 2 ** 63
MOST_ROWS = 10_000_000
DIGITS = "%.12g"    # so that 0.1:0.5:5 contains 0.3 and not 0.30000000000000004


def whole(thing, value, low, high):
    """Returns an integer, also from text.

    Raises ValueError with the thing, its value and what is legal.
    """
    try:
        number = int(value)
        if isinstance(value, bool) or number != float(value) or not low <= number <= high:
            raise ValueError
        return number
    except (TypeError, ValueError, OverflowError):
        raise ValueError("%s is %s, legal: a whole number from %d to %d" % (thing, shown(value), low, high)) from None


def positive(thing, value):
    """Returns a number above 0, also from text.

    Raises ValueError with the thing, its value and what is legal.
    """
    try:
        number = float(value)
        if isinstance(value, bool) or not 0 < number < math.inf:
            raise ValueError
        return number
    except (TypeError, ValueError):
        raise ValueError("%s is %s, legal: a number above 0" % (thing, shown(value))) from None


def shown(value):
    """Formats a value for a message."""
    return '"%s"' % value if isinstance(value, str) else repr(value)


def printable(given):
    """Returns text safe for a terminal: control characters, except tabs and line breaks, become question marks."""
    return CONTROLS.sub("?", given)


def seeds_of(thing, given):
    """Returns the seeds as a list: from a count (1, 2, ...), from "A:B" (A to B), or from a list."""
    legal = "legal: a count from 1 to %d, or A:B for A to B%s" % (MOST_ROWS, "" if isinstance(given, str) else ", or a list of whole numbers")
    if isinstance(given, str) and ":" in given:
        first, _, last = given.partition(":")
        try:
            made = range(int(first), int(last) + 1)
        except ValueError:
            made = ()
        if not made or len(made) > MOST_ROWS:
            raise ValueError("%s is %s, %s" % (thing, shown(given), legal))
        return [whole(thing, one, -SEED_LIMIT, SEED_LIMIT - 1) for one in (made[0], made[-1])] and list(made)
    if isinstance(given, (list, tuple, range)) or hasattr(given, "tolist"):
        made = [whole(thing, plain(one), -SEED_LIMIT, SEED_LIMIT - 1) for one in given]
        if not made or len(set(made)) < len(made):
            raise ValueError("%s is %s, legal: at least one seed, and none twice" % (thing, shown(given)))
        return made
    try:
        return list(range(1, whole(thing, given, 1, MOST_ROWS) + 1))
    except ValueError:
        raise ValueError("%s is %s, %s" % (thing, shown(given), legal)) from None


def plain(value):
    """Converts numpy's numbers to Python's."""
    return value.item() if hasattr(value, "item") else value


def read(text):
    """Parses a value of the command line: an integer, a number, true, false or a text."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return {"true": True, "false": False}.get(text.lower(), text)


def values_of(text):
    """Parses --set: name and values."""
    name, equals, said = text.partition("=")
    legal = "legal: NAME=A:B:N, N values from A to B, or NAME=A,B,C; names: " + LEGAL_NAME
    if not equals or not said or not legal_name(name):
        raise ValueError("--set is %s, %s" % (shown(text), legal))
    if said.count(":") == 2:
        first, last, count = said.split(":")
        try:
            low, high = float(first), float(last)
            if not (math.isfinite(low) and math.isfinite(high)):
                raise ValueError
        except ValueError:
            raise ValueError("--set is %s, %s" % (shown(text), legal)) from None
        number = whole("--set %s: number of values" % name, count, 2, MOST_ROWS)
        made = [float(DIGITS % (low + (high - low) * at / (number - 1))) for at in range(number)]
        isWhole = isinstance(read(first), int) and isinstance(read(last), int) and all(one.is_integer() for one in made)
        return name, [int(one) for one in made] if isWhole else made
    return name, [read(one) for one in said.split(",")]


def legal_name(name):
    """Whether a parameter or a result may have that name."""
    return isinstance(name, str) and bool(NAME.match(name)) and name not in TAKEN


def checked_grid(grid):
    """Returns a list of names and values, which are Python's own numbers, texts, True and False.

    Raises ValueError with the parameter, its value and what is legal.
    """
    made = []
    for name, values in (grid or {}).items():
        if not legal_name(name):
            raise ValueError("parameter name is %s, legal: %s" % (shown(name), LEGAL_NAME))
        if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__"):
            raise ValueError("parameter %s is %s, legal: a list of numbers, texts, True or False" % (name, shown(values)))
        listed = [plain(one) for one in values]
        wrong = [one for one in listed if not isinstance(one, (numbers.Real, str))]
        if wrong or not listed:
            raise ValueError("parameter %s is %s, legal: a list of numbers, texts, True or False" % (name, shown(wrong[0] if wrong else listed)))
        keys = [(type(one), one) for one in listed]
        twice = [one for at, one in enumerate(keys) if one in keys[:at]]
        if twice:
            raise ValueError("parameter %s has %s twice, legal: each value once" % (name, shown(twice[0][1])))
        made.append([name, listed])
    return made


class Rows:
    """The rows of seeds and values: the first parameter changes slowest, the seed fastest."""

    def __init__(self, seeds, grid):
        self.seeds = seeds
        self.names = [name for name, _ in grid]
        self._combinations = list(itertools.product(*(values for _, values in grid)))
        if len(self) > MOST_ROWS:
            raise ValueError("the sweep has %d rows, legal: up to %d" % (len(self), MOST_ROWS))

    def __len__(self):
        return len(self._combinations) * len(self.seeds)

    def __getitem__(self, row):
        """Returns seed and parameters of a row."""
        combination, seed = divmod(row, len(self.seeds))
        return self.seeds[seed], dict(zip(self.names, self._combinations[combination]))


def version():
    """Returns SEAR's version with the first digits of its jar's SHA-256, since two builds of one version can differ."""
    home = _home.find()
    with open(_home.jar(home), "rb") as jar:
        return "%s+%s" % (_home.version(home), hashlib.sha256(jar.read()).hexdigest()[:8])
