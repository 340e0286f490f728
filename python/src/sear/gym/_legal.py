# SPDX-License-Identifier: Apache-2.0
"""Checks of an environment's arguments: the ValueError names the argument, its value and what is legal."""
from collections.abc import Mapping
from math import isfinite
from numbers import Real
from operator import index

from numpy import float32


def whole(what, value, least, most):
    """Returns an integer; accepts numpy's, too."""
    try:
        number = None if isinstance(value, bool) else index(value)
    except TypeError:
        number = None
    if number is None or not least <= number <= most:
        raise ValueError("%s is %r, legal: a whole number from %d to %d" % (what, value, least, most))
    return number


def seconds(what, value):
    """Returns None, or a number above 0."""
    try:
        if value is None or value > 0:
            return value
    except TypeError:
        pass
    raise ValueError("%s is %r, legal: above 0, or None" % (what, value))


def names(what, value):
    """Returns a list of different names."""
    if isinstance(value, str) or not hasattr(value, "__iter__"):
        raise ValueError("%s is %r, legal: a list of names" % (what, value))
    listed = list(value)
    if len(set(listed)) < len(listed):
        raise ValueError("%s is %r, legal: each name once" % (what, listed))
    return listed


def function(what, value, otherwise):
    """Returns a function, or the default."""
    if value is not None and not callable(value):
        raise ValueError("%s is %r, legal: a function of the robot" % (what, value))
    return value or otherwise


def place(what, value):
    """Returns None, or x, z and heading as numbers."""
    try:
        x, z, heading = (None,) * 3 if value is None else (float(one) for one in value)
    except (TypeError, ValueError):
        raise ValueError("%s is %r, legal: x and z in metres and heading in degrees" % (what, value)) from None
    return None if value is None else (x, z, heading)


def places(value):
    """Returns an environment's start: None, a function, or a list of poses."""
    if value is None or callable(value):
        return value
    if not hasattr(value, "__len__") or not len(value):
        raise ValueError("start is %s, legal: None, a list of (x, z, heading), or a function that returns one"
                         % ("an empty list" if hasattr(value, "__len__") else repr(value)))
    return [place("start %d" % number, one) for number, one in enumerate(value)]


def wheels(what, pair, most):
    """Returns the speeds of both sides."""
    try:
        left, right = (float(one) for one in pair)
    except (TypeError, ValueError):
        raise ValueError("%s is %r, legal: the speeds of the left and the right wheels, m/s, for example (0.2, 0.2)" % (what, pair)) from None
    if not (abs(left) <= most and abs(right) <= most):
        raise ValueError("%s is %r, legal: -%g to %g m/s" % (what, pair, most, most))
    return left, right


def actions(given, fastest):
    """Returns names of controls, choices, and lowest and highest values. No names: left and right wheel speeds, m/s."""
    if isinstance(given, Mapping):
        limits = [span(name, given[name]) for name in given]
        if not limits:
            raise ValueError("actions is an empty dictionary, legal: a range for one or more controls")
        return list(given), None, tuple(zip(*limits))
    if hasattr(given, "__iter__"):
        choices = list(given)
        if not choices:
            raise ValueError("actions is an empty list, legal: one or more (left, right)")
        if isinstance(choices[0], Mapping):
            controls = list(choices[0])
            return controls, [chosen("action %d" % number, one, controls) for number, one in enumerate(choices)], None
        return None, [wheels("action %d" % number, pair, fastest) for number, pair in enumerate(choices)], None
    if isinstance(given, bool) or not isinstance(given, Real) or not 0 < given <= fastest:
        raise ValueError("actions is %r, legal: a list of (left, right), the highest speed of the wheels, above 0 to %g m/s, or a dictionary of the "
                         "controls' ranges" % (given, fastest))
    return None, None, ((-float(given),) * 2, (float(given),) * 2)


def span(name, value):
    """Returns the lowest and the highest value of a control."""
    try:
        low, high = (float(one) for one in value)
        if isinstance(name, str) and low < high and isfinite(high - low):
            return low, high
    except (TypeError, ValueError):
        pass
    raise ValueError("actions has %r: %r, legal: the name of a control, and its lowest and highest value" % (name, value))


def chosen(what, values, controls):
    """Returns the values of an action in the order of the controls."""
    try:
        if not controls or set(values) != set(controls):
            raise ValueError
        return tuple(float(values[name]) for name in controls)
    except (TypeError, ValueError):
        raise ValueError("%s is %r, legal: a number for each of %s" % (what, values, ", ".join(map(str, controls)) or "the controls")) from None


def values(action, controls, low, high):
    """Returns an action of a number for each control; float32 may exceed a limit by its rounding."""
    try:
        numbers = [float(one) for one in action]
        if len(numbers) == len(low) and all(float32(least) <= one <= float32(most) for one, least, most in zip(numbers, low, high)):
            return [min(max(one, least), most) for one, least, most in zip(numbers, low, high)]
    except (TypeError, ValueError):
        pass
    raise ValueError("action is %s, legal: %s" % (action, ", ".join("%s from %g to %g" % one for one in zip(controls, low, high))))


def speeds(action, most):
    """Returns an action of two speeds."""
    try:
        left, right = (float(one) for one in action)
        if abs(left) <= most and abs(right) <= most:
            return left, right
    except (TypeError, ValueError):
        pass
    raise ValueError("action is %s, legal: two speeds from -%g to %g m/s" % (action, most, most))


def size(value):
    """Returns the size of a picture."""
    try:
        width, height = (index(one) for one in value)
    except (TypeError, ValueError):
        raise ValueError("size is %r, legal: width and height in pixels, for example (480, 360)" % (value,)) from None
    return width, height


def reward(value):
    """Returns the result of a reward function as a number."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = float("nan")
    if not isfinite(number):
        raise ValueError("the reward function returned %r, legal: a number" % (value,))
    return number
