# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which of the patterns in an outline is taken first: one that does not depend on how the outline lies."""

from itertools import groupby
from math import hypot

from .acceptance import examine, holds
from .kinds import KINDS
from .patterns import curved, straight

STEP = 0.7390851332151607e-9  # of what is compared: no ratio that a draughtsman would choose is between two steps


def best(loop, tolerance):
    """The pattern to reduce an outline by, as what was `Found`; nothing where none holds.

    Arcs come first, since a chord may complete a convex run, of which one primitive takes many vertices. Then counts
    what a pattern removes; of equals the holes come first, the simpler kind and the larger region.
    """
    for search in (curved, straight):
        ordered = sorted(search(loop, tolerance), key=lambda pattern: -pattern.gain)
        for _, group in groupby(ordered, key=lambda pattern: pattern.gain):
            for found in ranked(loop, group, tolerance):
                if holds(loop, found, tolerance.near):
                    return found
    return None


def ranked(loop, group, tolerance):
    """What patterns of one gain take off, those that are no primitives left out, in an order of their own."""
    known = filter(None, (examine(loop, pattern, tolerance.near) for pattern in group))
    area, middle = loop.area, centre(loop)
    return sorted(known, key=lambda found: rank(found, area, middle, tolerance.size))


def rank(found, area, middle, size):
    """What orders patterns of one gain, in steps that are too coarse for rounding to tell congruent ones apart."""
    x, y = centre(found.region)
    length = sum(hypot(cx - ax, cy - ay) for ax, ay, cx, cy, _ in found.region.edges())
    away = hypot(x - middle[0], y - middle[1])
    return (
        found.operation == "union",
        KINDS.index(found.kind),
        -round(found.region.area / area / STEP),
        round(length / size / STEP),
        round(away / size / STEP),
    )


def centre(loop):
    """The mean of the corners."""
    return tuple(sum(x) / len(x) for x in zip(*loop.corners, strict=True))
