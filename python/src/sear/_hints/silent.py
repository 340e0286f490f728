# SPDX-License-Identifier: Apache-2.0
"""Mistakes that Python accepts silently: integer division, a decimal comma, a call without brackets, radians for
degrees, centimetres for metres."""
from __future__ import division

import ast
import re

from .names import PYTHON3

# Calls that take degrees
_ANGLES = "spin", "rotate", "setSteering", "setServo"
# Shortest literal wait that is reported, s
_LONG = 1000
# Beyond the range of SEAR's distance sensors, m
_FAR = 10
# Degrees
_HALF_ROUND = 90


def mistakes(source, file):
    """Returns a script's mistakes, each with its line; none for code with syntax errors, which are reported
    elsewhere."""
    try:
        tree = ast.parse(source, file)
    except (SyntaxError, ValueError):
        return []
    looking = _Look(re.split("\r\n|\r|\n", source if isinstance(source, type(u"")) else source.decode("utf-8", "replace")))
    looking.visit(tree)
    return ["line %d of %s: %s" % (line, file, text) for line, text in looking.found]


class _Look(ast.NodeVisitor):
    def __init__(self, lines):
        self.lines = lines
        self.found = []
        self.divides = PYTHON3

    def _report(self, node, text):
        self.found.append((node.lineno, text))

    def visit_ImportFrom(self, node):
        """Notes true division."""
        self.divides |= node.module == "__future__" and any(one.name == "division" for one in node.names)
        self.generic_visit(node)

    def visit_BinOp(self, node):
        """Reports a division of whole numbers that loses its remainder."""
        left, right = _number(node.left), _number(node.right)
        if isinstance(node.op, ast.Div) and not self.divides and isinstance(left, int) and isinstance(right, int) and right and left % right:
            self._report(node, "%d / %d is %d in Python 2.7 (integer division): write %d.0 / %d" % (left, right, left // right, left, right))
        self.generic_visit(node)

    def visit_Assign(self, node):
        """Reports a decimal comma."""
        comma = re.match(r"[^=]*=\s*(-?\d+),(\d+)\s*;?\s*(?:#.*)?$", self.lines[node.lineno - 1])
        if comma and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name) and isinstance(node.value, ast.Tuple):
            self._report(node, "{0},{1} is two numbers, {0} and {1}: write decimals with a point, {0}.{1}".format(*comma.groups()))
        self.generic_visit(node)

    def visit_Call(self, node):
        """Reports radians, milliseconds and a LIDAR's values in another order."""
        call = getattr(node.func, "attr", "")
        numbers = [_number(one) for one in node.args]
        if call in _ANGLES and any(_is_of_radians(one) for one in node.args):
            self._report(node, call + " takes degrees, but this value is in radians: 90 is a quarter turn")
        if call == "simSleep" and len(numbers) == 1 and (numbers[0] or 0) >= _LONG:
            self._report(node, "simSleep({0:.15g}) waits {0:.15g} s; if these are milliseconds, write simSleep({1:.15g})".format(
                numbers[0], numbers[0] / 1000))
        if getattr(node.func, "id", "") == "LIDAR" and len(numbers) > 2 and (numbers[1] or 0) >= _HALF_ROUND > (numbers[2] or _HALF_ROUND):
            self._report(node, "this LIDAR has a range of %.15g m and a spread of %.15g degrees: the range comes before the spread,"
                         " LIDAR(name, range, spread, resolution)" % tuple(numbers[1:3]))
        self.generic_visit(node)

    def visit_Compare(self, node):
        """Reports a distance in centimetres."""
        limit = _number(node.comparators[0])
        of_distance = isinstance(node.left, ast.Call) and getattr(node.left.func, "attr", "") == "getDistanceResult"
        if of_distance and len(node.comparators) == 1 and (limit or 0) >= _FAR:
            self._report(node, "getDistanceResult returns metres, and {0:.15g} m is beyond the range of such sensors; if these are"
                         " centimetres, write {1:.15g}".format(limit, limit / 100))
        self.generic_visit(node)

    def visit_Expr(self, node):
        """Reports a method that is not called."""
        if isinstance(node.value, ast.Attribute):
            name = getattr(node.value.value, "id", "") and node.value.value.id + "."
            self._report(node, "{0} is named but not called: write {0}(...)".format(name + node.value.attr))
        self.generic_visit(node)


def _number(node):
    """Returns the number of a literal; None for anything else."""
    value = getattr(node, "n" if not PYTHON3 else "value", None)
    return value if isinstance(value, (int, float)) and not isinstance(value, bool) else None


def _is_of_radians(node):
    if isinstance(node, ast.BinOp):
        return _is_of_radians(node.left) or _is_of_radians(node.right)
    named = node.func if isinstance(node, ast.Call) else node
    name = getattr(named, "attr", getattr(named, "id", ""))
    return name == ("radians" if isinstance(node, ast.Call) else "pi")
