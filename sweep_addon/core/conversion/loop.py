# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A closed loop of lines and arcs while it is taken apart: counter-clockwise, and without needless vertices."""

from math import atan, hypot, tan
from typing import NamedTuple

from .edges import apex, off_circle, sagitta, segment


class Loop(NamedTuple):
    """Corners (x, y) and the bulge of the edge after each."""

    corners: tuple
    bulges: tuple

    def edge(self, index):
        """An edge as `edges` has it; the index may run over the end."""
        n = len(self.corners)
        return (*self.corners[index % n], *self.corners[(index + 1) % n], self.bulges[index % n])

    def edges(self):
        """All edges in order."""
        following = self.corners[1:] + self.corners[:1]
        return [(*a, *b, bulge) for a, b, bulge in zip(self.corners, following, self.bulges, strict=True)]

    @property
    def area(self):
        """What is enclosed, positive counter-clockwise: the polygon of chords and a segment for each arc."""
        x, y = self.corners[0]  # about a corner little cancels
        whole = 0.0
        for ax, ay, bx, by, bulge in self.edges():
            whole += ((ax - x) * (by - y) - (ay - y) * (bx - x)) / 2 + segment((ax, ay, bx, by, bulge))
        return whole

    @property
    def complexity(self):
        """Vertices and arcs together, which every reduction lowers."""
        return len(self.corners) + sum(bulge != 0 for bulge in self.bulges)

    def reversed(self):
        """The same loop run through the other way."""
        corners = self.corners[::-1]
        return Loop(corners, tuple(0.0 - bulge for bulge in self.bulges[-2::-1] + self.bulges[-1:]))

    def replaced(self, start, count, corners, bulges):
        """The loop with other corners and edges in place of so many edges from one on.

        The first of ``corners`` stands for the corner where the first edge starts; the corner where the last one ends
        stays.
        """
        n = len(self.corners)
        kept = [(start + count + k) % n for k in range(n - count)]
        return Loop(
            (*corners, *(self.corners[k] for k in kept)),
            (*bulges, *(self.bulges[k] for k in kept)),
        )

    def cleaned(self, least):
        """The loop without edges that are nothing and vertices where a line or an arc only goes on.

        Parameters
        ----------
        least : float
            The distance within which a vertex is on the line or circle of its neighbours, and an arc is its chord.
        """
        flat = (0.0 if sagitta(edge) <= least else edge[4] for edge in self.edges())
        corners, bulges = list(self.corners), list(flat)
        i, unchanged = 0, 0
        while unchanged < len(corners) > 2:
            j, k = (i + 1) % len(corners), (i + 2) % len(corners)
            joined = went_on((*corners[i], *corners[j], bulges[i]), (*corners[j], *corners[k], bulges[j]), least)
            if joined is None:
                i, unchanged = j, unchanged + 1
            else:
                bulges[i] = joined
                del corners[j], bulges[j]
                i, unchanged = (i - 1 if i < j else i - 2) % len(corners), 0
        return Loop(tuple(corners), tuple(bulges))


def went_on(one, other, least):
    """The bulge of the single edge that two consecutive edges are, or nothing if they are two."""
    ax, ay, bx, by, first = one
    _, _, cx, cy, second = other
    if hypot(bx - ax, by - ay) <= least:
        return second
    if hypot(cx - bx, cy - by) <= least:
        return first
    across = hypot(cx - ax, cy - ay)
    if across <= least or first * second < 0 or (first == 0) != (second == 0):
        return None
    if first == 0:
        ahead = (bx - ax) * (cx - bx) + (by - ay) * (cy - by) > 0
        return 0.0 if ahead and abs(off_circle((ax, ay, cx, cy, 0.0), bx, by)) <= least else None
    bulge = tan(atan(first) + atan(second))
    whole = (ax, ay, cx, cy, bulge)
    if bulge * first <= 0 or abs(bulge) > 1000:
        return None
    apart = (abs(off_circle(whole, *point)) for point in ((bx, by), apex(one), apex(other)))
    return bulge if max(apart) <= least else None


def turn(p, q, r):
    """How far a corner stands out from the chord of its neighbours, positive where the path turns left."""
    return off_circle((*p, *r, 0.0), *q)
