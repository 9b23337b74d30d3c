# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether what a pattern cuts off is wholly inside or wholly outside the outline, and the rest stays simple."""

from typing import NamedTuple

from .contacts import meet
from .edges import apex, beside, power
from .kinds import kind_of
from .loop import Loop
from .patterns import Pattern


class Found(NamedTuple):
    """A pattern that holds: the region, counter-clockwise, its kind, and how the outline has it."""

    operation: str
    kind: str
    region: Loop
    pattern: Pattern


def examine(loop, pattern, near):
    """The region of a pattern and its kind, not yet compared with the other edges; nothing if it is no primitive."""
    region = pattern.region(loop)
    area = region.area
    if area < 0:
        region = region.reversed()
    kind = kind_of(region, near)
    return kind and Found("union" if area > 0 else "difference", kind, region, pattern)


def holds(loop, found, near):
    """Whether no other edge of the loop meets the edges that are new, or is in the region.

    Then all others, one connected path, are outside the region, and the region is on one side of the outline.
    """
    pattern = found.pattern
    n = len(loop.corners)
    start, count = pattern.start, pattern.count
    added = pattern.edges(loop)
    first, last = loop.corners[start], loop.corners[(start + count) % n]
    for k in range(count, n):
        edge = loop.edge(start + k)
        ends = edge[:2], edge[2:4]
        for at, new in enumerate(added):
            if goes_on(pattern, at, len(added), k, n):
                continue
            shared = tuple(p for p in (first, last) if p in ends and p in (new[:2], new[2:4]))
            if meet(new, edge, shared, near):
                return False
    if pattern.bare and loop.bulges[start] != 0:  # a fillet, which may miss its tangents
        arc = loop.edge(start)
        if meet(added[0], arc, (first,), near) or meet(added[1], arc, (last,), near):
            return False
    return not contains(found.region, *beyond(loop, start, count))


def goes_on(pattern, at, new, k, n):
    """Whether an edge that is new goes on in an edge that stays, on the same line or circle: they cannot cross."""
    along = pattern.bare or pattern.bulges != (0.0,)
    return along and ((at == 0 and k == n - 1) or (at == new - 1 and k == pattern.count))


def beyond(loop, start, count):
    """A point of the edges that stay, away from those that do not."""
    n = len(loop.corners)
    return loop.corners[(start + count + 1) % n] if n - count > 1 else apex(loop.edge(start + count))


def contains(loop, x, y):
    """Whether a point is inside a loop: in an odd number of the polygon of chords and the segments of arcs."""
    odd = False
    for edge in loop.edges():
        _, ay, _, by, bulge = edge
        left = power((*edge[:4], 0.0), x, y) < 0
        if (ay <= y) != (by <= y) and left == (by > ay):
            odd = not odd
        if bulge != 0 and beside(edge, x, y) and power(edge, x, y) * bulge < 0:
            odd = not odd
    return odd
