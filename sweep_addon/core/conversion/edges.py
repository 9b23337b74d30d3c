# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One line or arc at a time, in plain floats: an outline that is converted has tens of edges, not thousands.

An edge is ``(ax, ay, bx, by, bulge)``: from a to b, and the tangent of a quarter of its arc's angle, positive when it
turns left. The circle through a and b is known by its power, a polynomial of the bulge, and never by its centre, which
is infinitely far away for a line.
"""

from math import atan, hypot, sin


def circle(edge):
    """The power of a point, as ``p * (x**2 + y**2) + q * x + r * y + s``, negative inside the circle of a left turn.

    It is twice the bulge times the squared distance from the centre less the squared radius. By the inscribed angle
    theorem it is ``2 * bulge * (P - a) . (P - b) - (1 - bulge**2) * (b - a) x (P - a)``.

    Examples
    --------
    >>> circle((1.0, 0.0, -1.0, 0.0, 1.0))
    (2.0, 0.0, 0.0, -2.0)
    """
    ax, ay, bx, by, bulge = edge
    twice, rest = 2 * bulge, 1 - bulge * bulge
    dx, dy = bx - ax, by - ay
    q = rest * dy - twice * (ax + bx)
    r = -rest * dx - twice * (ay + by)
    return twice, q, r, twice * (ax * bx + ay * by) + rest * (dx * ay - dy * ax)


def power(edge, x, y):
    """The power of the point, computed from the ends of the edge: near them there is nothing to cancel."""
    ax, ay, bx, by, bulge = edge
    ux, uy = x - ax, y - ay
    across = (bx - ax) * uy - (by - ay) * ux
    return 2 * bulge * (ux * (x - bx) + uy * (y - by)) - (1 - bulge * bulge) * across


def off_circle(edge, x, y):
    """How far a point is from the circle, negative inside that of a left turn; from a line how far to its right."""
    ax, ay, bx, by, bulge = edge
    dx, dy = bx - ax, by - ay
    twice, rest = 2 * bulge, (1 - bulge * bulge) / 2
    to_centre = hypot(twice * (x - (ax + bx) / 2) + rest * dy, twice * (y - (ay + by) / 2) - rest * dx)
    return power(edge, x, y) / (to_centre + hypot(dx, dy) * (1 + bulge * bulge) / 2)


def beside(edge, x, y):
    """Whether a point of the circle belongs to the arc: an arc is all of its circle on one side of the chord."""
    ax, ay, bx, by, bulge = edge
    return ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) * bulge <= 0


def apex(edge):
    """The middle of the line or arc."""
    ax, ay, bx, by, bulge = edge
    return (ax + bx) / 2 + bulge / 2 * (by - ay), (ay + by) / 2 - bulge / 2 * (bx - ax)


def sagitta(edge):
    """How far the middle of the arc is from its chord."""
    ax, ay, bx, by, bulge = edge
    return hypot(bx - ax, by - ay) * abs(bulge) / 2


def segment(edge):
    """The area between the arc and its chord, to the right of the chord positive.

    Examples
    --------
    >>> round(segment((1.0, 0.0, -1.0, 0.0, 1.0)), 6)
    1.570796
    """
    ax, ay, bx, by, bulge = edge
    if bulge == 0:
        return 0.0
    squared = (bx - ax) ** 2 + (by - ay) ** 2
    if abs(bulge) < 0.02:  # where the difference would cancel: its series, exact to rounding
        b2 = bulge * bulge
        return squared * bulge / 3 * (1 + b2 / 5 * (1 - b2 / 7 * (1 - b2 / 3)))
    angle = 4 * atan(bulge)
    ratio = (1 + bulge * bulge) / (4 * bulge)
    return squared * ratio * ratio / 2 * (angle - sin(angle))


def half_tangent(bulge):
    """tan(x / 2) for tan(x), both within a quarter turn.

    Examples
    --------
    >>> round(half_tangent(1.0), 6)
    0.414214
    """
    return bulge / (1 + hypot(1, bulge))


def about(edge, x, y):
    """The edge as seen from a point."""
    ax, ay, bx, by, bulge = edge
    return ax - x, ay - y, bx - x, by - y, bulge
