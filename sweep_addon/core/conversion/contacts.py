# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether two edges meet elsewhere than where they share an end: lines and arcs by formula, never by chords."""

from math import hypot, sqrt

from .edges import about, beside, circle, off_circle, power, sagitta


def meet(new, old, shared, near):
    """Whether two edges come within a distance of each other, away from the ends they share.

    Parameters
    ----------
    new, old : edges, see `edges`
    shared : tuple of (x, y)
        The points where an end of the one is an end of the other: none, one or two, and exactly so.
    near : float
        The distance that counts as touching. Edges that leave a shared end in one direction, as an arc and its
        tangent, may cross again beside it by rounding of their ends: they may where what lies between them is thinner.
    """
    if apart(new, old, near):
        return False
    for edge, other in ((new, old), (old, new)):
        for x, y in (other[:2], other[2:4]):
            if (x, y) not in shared and lies_on(edge, x, y, near):
                return True
    return cross(new, old, shared, near)


def cross(new, old, shared, near):
    """Whether two edges cross or graze each other within both, the ends aside; see `meet`."""
    if new[4] == 0 and old[4] == 0:
        return not shared and lines_cross(new, old)
    if new[4] == 0:
        return line_and_arc(new, old, shared, near)
    if old[4] == 0:
        return line_and_arc(old, new, shared, near)
    return arcs(new, old, shared, near)


def apart(one, other, near):
    """Whether boxes round two edges are apart; an arc is no farther from its chord's box than its sagitta."""
    margin = near + sagitta(one) + sagitta(other)
    ax, ay, bx, by, _ = one
    cx, cy, dx, dy, _ = other
    return (
        max(ax, bx) + margin < min(cx, dx)
        or max(cx, dx) + margin < min(ax, bx)
        or max(ay, by) + margin < min(cy, dy)
        or max(cy, dy) + margin < min(ay, by)
    )


def lies_on(edge, x, y, near):
    """Whether a point is within a distance of an edge."""
    ax, ay, bx, by, bulge = edge
    if bulge != 0:
        if abs(off_circle(edge, x, y)) <= near and beside(edge, x, y):
            return True
        return min(hypot(x - ax, y - ay), hypot(x - bx, y - by)) <= near
    dx, dy = bx - ax, by - ay
    t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)
    t = min(max(t, 0.0), 1.0)
    return hypot(x - ax - t * dx, y - ay - t * dy) <= near


def lines_cross(one, other):
    """Whether two lines cross within both of them."""
    a, b = other[:2], other[2:4]
    c, d = one[:2], one[2:4]
    return power(one, *a) * power(one, *b) < 0 and power(other, *c) * power(other, *d) < 0


def line_and_arc(line, arc, shared, near):
    """Whether a line crosses an arc or grazes it, away from shared ends."""
    sx, sy, ex, ey, _ = line
    if len(shared) == 2:
        return False  # the chord of the arc
    if shared and shared[0] == (ex, ey):
        sx, sy, ex, ey = ex, ey, sx, sy
    ax, ay, bx, by, bulge = arc
    dx, dy = ex - sx, ey - sy
    length = hypot(dx, dy)
    twice = 2 * bulge
    squared = twice * length * length
    linear = twice * ((2 * sx - ax - bx) * dx + (2 * sy - ay - by) * dy)
    linear -= (1 - bulge * bulge) * ((bx - ax) * dy - (by - ay) * dx)
    if shared:
        t = -linear / squared
        if not 0 < t < 1 or t * length <= near or not beside(arc, sx + t * dx, sy + t * dy):
            return False
        return (t * length) ** 2 / 8 * curvature(arc) > near
    constant = power(arc, sx, sy)
    within = linear * linear - 4 * squared * constant
    if within <= 0:
        t = -linear / (2 * squared)
        return 0 < t < 1 and lies_on(arc, sx + t * dx, sy + t * dy, near)
    root = -(linear + (sqrt(within) if linear > 0 else -sqrt(within))) / 2
    for t in (root / squared, constant / root):
        if 0 < t < 1 and beside(arc, sx + t * dx, sy + t * dy):
            return True
    return False


def arcs(one, other, shared, near):
    """Whether two arcs cross or graze each other, away from shared ends: where their radical line meets the first."""
    ox, oy = shared[0] if shared else one[:2]  # about which little cancels
    one, other = about(one, ox, oy), about(other, ox, oy)
    p, q, r, s = circle(one)
    p2, q2, r2, s2 = circle(other)
    nx, ny, rest = p2 * q - p * q2, p2 * r - p * r2, p2 * s - p * s2
    squared = nx * nx + ny * ny
    scale = abs(p2) * hypot(q, r) + abs(p) * hypot(q2, r2)
    if len(shared) == 2 or squared <= (1e-12 * scale) ** 2:
        return False  # they meet at both ends, or are on circles about one centre, which meet nowhere or everywhere
    if shared:
        t = (ny * q - nx * r) / (p * squared)
        x, y = -ny * t, nx * t
        gap = hypot(x, y)
        if gap <= near or not (beside(one, x, y) and beside(other, x, y)):
            return False
        return gap**2 / 8 * (curvature(one) + curvature(other)) > near
    fx, fy = -nx * rest / squared, -ny * rest / squared  # the foot of the origin on the radical line
    linear = -ny * (2 * p * fx + q) + nx * (2 * p * fy + r)
    constant = p * (fx * fx + fy * fy) + q * fx + r * fy + s
    within = linear * linear - 4 * p * squared * constant
    if within <= 0:
        return graze(one, other, near)
    root = -(linear + (sqrt(within) if linear > 0 else -sqrt(within))) / 2
    for t in (root / (p * squared), constant / root):
        x, y = fx - ny * t, fy + nx * t
        if beside(one, x, y) and beside(other, x, y):
            return True
    return False


def graze(one, other, near):
    """Whether arcs on circles that do not cross come near each other, on the line through both centres."""
    p, q, r, _ = circle(one)
    p2, q2, r2, _ = circle(other)
    cx, cy = -q / (2 * p), -r / (2 * p)
    dx, dy = -q2 / (2 * p2) - cx, -r2 / (2 * p2) - cy
    step = 1 / (curvature(one) * hypot(dx, dy))
    for x, y in ((cx + step * dx, cy + step * dy), (cx - step * dx, cy - step * dy)):
        if beside(one, x, y) and lies_on(other, x, y, near):
            return True
    return False


def curvature(arc):
    ax, ay, bx, by, bulge = arc
    return 4 * abs(bulge) / ((1 + bulge * bulge) * hypot(bx - ax, by - ay))
