# SPDX-License-Identifier: Apache-2.0
"""Draws curves on logarithmic axes as SVG."""
import math

WIDTH = 760
HEIGHT = 440
LEFT = 74
RIGHT = 150
TOP = 40
BOTTOM = 56
COLOURS = {"SEAR fan": "#c1272d", "SEAR single": "#e58a3c", "SEAR": "#c1272d", "jbullet": "#7a7a7a", "pybullet": "#2f6db5", "MuJoCo": "#2e8b57",
           "Embree": "#8a6d1d"}
OTHER = "#8e44ad"
LEAST_GAP = 14


def scale(low, high, start, end):
    """Returns a function from values to points on a logarithmic axis."""
    span = math.log(high / low)
    return lambda value: start + (end - start) * math.log(value / low) / span


def decades(low, high):
    exponent = math.ceil(math.log10(low) - 1e-9)
    while 10.0 ** exponent <= high * (1 + 1e-9):
        yield 10.0 ** exponent
        exponent += 1


def number(value):
    if value >= 1e6:
        return "%g million" % (value / 1e6)
    if value >= 1000:
        return "{:,.0f}".format(value).replace(",", " ")
    return "%g" % value


def draw(title, x_title, y_title, series):
    """Returns the SVG text. series: [(name, [(x, y), ...])], all values above 0."""
    xs = [x for _, points in series for x, _ in points]
    ys = [y for _, points in series for _, y in points]
    x_low, x_high = min(xs), max(max(xs), min(xs) * 2)
    y_low = 10.0 ** math.floor(math.log10(min(ys)))
    y_high = 10.0 ** math.ceil(math.log10(max(max(ys), y_low * 1.01)))
    x_at = scale(x_low, x_high, LEFT, WIDTH - RIGHT)
    y_at = scale(y_low, y_high, HEIGHT - BOTTOM, TOP)
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" font-family="sans-serif" font-size="12">' % (WIDTH, HEIGHT, WIDTH),
           '<rect width="%d" height="%d" fill="white"/>' % (WIDTH, HEIGHT),
           '<text x="%d" y="22" font-size="15">%s</text>' % (LEFT, title)]
    for tick in decades(y_low, y_high):
        out.append('<path d="M%d %.1fH%d" stroke="#ddd"/><text x="%d" y="%.1f" text-anchor="end">%s</text>'
                   % (LEFT, y_at(tick), WIDTH - RIGHT, LEFT - 6, y_at(tick) + 4, number(tick)))
    ticks = list(decades(x_low, x_high))
    for tick in ticks if len(ticks) > 1 else sorted(set(xs)):
        out.append('<path d="M%.1f %dV%d" stroke="#ddd"/><text x="%.1f" y="%d" text-anchor="middle">%s</text>'
                   % (x_at(tick), TOP, HEIGHT - BOTTOM, x_at(tick), HEIGHT - BOTTOM + 17, number(tick)))
    out.append('<text x="%d" y="%d" text-anchor="middle">%s</text>' % ((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 14, x_title))
    out.append('<text transform="translate(16 %d) rotate(-90)" text-anchor="middle">%s</text>' % ((TOP + HEIGHT - BOTTOM) / 2, y_title))
    below = -1000.0
    for name, points in sorted(series, key=lambda one: y_at(one[1][-1][1])):
        colour = COLOURS.get(name, OTHER)
        out.append('<path d="M%s" fill="none" stroke="%s" stroke-width="%s"/>'
                   % ("L".join("%.1f %.1f" % (x_at(x), y_at(y)) for x, y in points), colour, 2.5 if name.startswith("SEAR") else 1.5))
        out += ['<circle cx="%.1f" cy="%.1f" r="3" fill="%s"/>' % (x_at(x), y_at(y), colour) for x, y in points]
        below = max(below + LEAST_GAP, y_at(points[-1][1]) + 4)
        out.append('<text x="%d" y="%.1f" fill="%s">%s</text>' % (WIDTH - RIGHT + 10, below, colour, name))
    return "\n".join(out + ["</svg>", ""])
