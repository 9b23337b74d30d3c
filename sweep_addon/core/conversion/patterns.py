# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Patterns in an outline: edges that would be a simpler outline, was a simple solid joined to it or cut out of it."""

from math import copysign, hypot, inf
from typing import NamedTuple

from .edges import about, circle
from .loop import Loop, turn, went_on


class Pattern(NamedTuple):
    """So many edges from one on, and the lines or the arc that would replace them."""

    gain: int  # vertices and arcs fewer
    start: int
    count: int
    corners: tuple  # where the edges that replace them start
    bulges: tuple
    bare: bool = False  # whether the edges before and after go on into them, so that the corners there vanish

    def region(self, loop):
        """What lies between the edges and what replaces them; counter-clockwise where it is inside the outline."""
        n = len(loop.corners)
        run = [(self.start + k) % n for k in range(self.count)]
        end = loop.corners[(self.start + self.count) % n]
        back = (end, *self.corners[:0:-1])
        return Loop(
            (*(loop.corners[k] for k in run), *back),
            (*(loop.bulges[k] for k in run), *(0.0 - b for b in self.bulges[::-1])),
        )

    def edges(self, loop):
        """The edges that replace those of the outline."""
        end = loop.corners[(self.start + self.count) % len(loop.corners)]
        following = (*self.corners[1:], end)
        return [(*a, *b, bulge) for a, b, bulge in zip(self.corners, following, self.bulges, strict=True)]


def curved(loop, tolerance):
    """Patterns that take an arc or give one, unchecked against the other edges."""
    for i, bulge in enumerate(loop.bulges):
        yield from rounding(loop, i, tolerance.least)
        if bulge != 0:
            yield chord(loop, i, 1, 1, tolerance.least)
            yield from corner(loop, i, 1, tolerance.size)


def straight(loop, tolerance):
    """Patterns of lines alone, unchecked against the other edges."""
    for i, bulge in enumerate(loop.bulges):
        if bulge == 0:
            yield from corner(loop, i, 1, tolerance.size)
            yield from runs(loop, i, tolerance)


def chord(loop, i, count, gain, least):
    """The line that closes a run; it may go on where the lines beside it end."""
    edge = (*loop.corners[i], *loop.corners[(i + count) % len(loop.corners)], 0.0)
    before, after = loop.edge(i - 1), loop.edge(i + count)
    gain += before[4] == 0 and went_on(before, edge, least) is not None
    gain += after[4] == 0 and went_on(edge, after, least) is not None
    return Pattern(gain, i, count, (loop.corners[i],), (0.0,))


def runs(loop, i, tolerance):
    """Runs of lines from one on that a chord, or the neighbours prolonged to a corner, close to a convex region.

    Each turns one way at all its corners and at both ends of the chord; longer ones turn by more, until none does.
    """
    n, near = len(loop.corners), tolerance.near
    a, b, *_ = points = [loop.corners[(i + k) % n] for k in range(n)]
    way = 0.0
    for count in range(2, n if any(loop.bulges) else n - 1):
        if loop.bulges[(i + count - 1) % n] != 0:
            return
        p, q, r = points[count - 2 : count + 1]
        way = way or copysign(1.0, turn(p, q, r))
        closing = min(way * turn(q, r, a), way * turn(r, a, b))
        if way * turn(p, q, r) <= near or closing < -near:
            return
        if closing > near:
            yield chord(loop, i, count, count - 1, tolerance.least)
            yield from corner(loop, i, count, tolerance.size)


def corner(loop, i, count, reach):
    """The corner of the lines before and after a run: an arc there is a fillet, a line a chamfer."""
    n = len(loop.corners)
    before, after = loop.edge(i - 1), loop.edge(i + count)
    if before[4] != 0 or after[4] != 0 or count > n - 3:
        return
    px, py = before[2:4]
    qx, qy = after[:2]
    ux, uy = px - before[0], py - before[1]
    vx, vy = qx - after[2], qy - after[3]
    across = cross(ux, uy, vx, vy)
    if abs(across) <= 1e-9 * hypot(ux, uy) * hypot(vx, vy):
        return
    s = cross(qx - px, qy - py, vx, vy) / across
    t = cross(qx - px, qy - py, ux, uy) / across
    if s <= 0 or t <= 0 or s * hypot(ux, uy) > reach or t * hypot(vx, vy) > reach:
        return
    vertex = (qx if vx == 0 else px + s * ux, qy if vy == 0 else py + s * uy)  # on an upright line to the bit
    gain = count + (loop.bulges[i] != 0)
    yield Pattern(gain, i, count, ((px, py), vertex), (0.0, 0.0), bare=True)


def rounding(loop, i, least):
    """The arc that goes on from the one before an edge to the one after it, if both are of one circle."""
    n = len(loop.corners)
    before, edge, after = loop.edge(i - 1), loop.edge(i), loop.edge(i + 1)
    if n < 4 or before[4] * after[4] <= 0:
        return
    bulge = bulge_along(before, edge)
    joined = went_on(before, (*edge[:4], bulge), least) if abs(bulge) <= 1000 else None
    if joined is not None and went_on((*before[:2], *edge[2:4], joined), after, least) is not None:
        yield Pattern(3 + (edge[4] != 0), i, 1, (edge[:2],), (bulge,))


def bulge_along(arc, edge):
    """The bulge of the arc of a circle that turns as another of its arcs, from one point of it to another."""
    ax, ay, bx, by, _ = edge
    _, q, r, _ = circle(about(arc, ax, ay))
    tx, ty = -r, q  # along the circle, across the gradient of the power
    cx, cy = bx - ax, by - ay
    sine, cosine = cross(tx, ty, cx, cy), tx * cx + ty * cy
    if cosine >= 0:  # half the angle's tangent, without a difference that cancels
        return sine / (hypot(sine, cosine) + cosine)
    return (hypot(sine, cosine) - cosine) / sine if sine else inf


def cross(ax, ay, bx, by):
    return ax * by - ay * bx
