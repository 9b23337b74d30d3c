# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The kinds of primitives, known by vertices and bulges."""

from math import hypot

from .loop import turn

SYSTEM = ("block", "wedge", "cylinder")
EXTENDED = ("triangular prism", "fillet", "convex prism")
TWO_VERTICES = ("double cylinder", "lens", "crescent", "minor chorded cylinder", "major chorded cylinder")
KINDS = SYSTEM + EXTENDED + TWO_VERTICES

ALIKE = 1e-6  # radians, and parts of a radius: what a name overlooks, a hundredth of what rounded drawings miss


def kind_of(loop, near=0.0):
    """The kind of a counter-clockwise loop that does not cross itself, or nothing if it is none.

    Source
    ------
    The names are Vossler's: Sweep-to-CSG Conversion Using Pattern Recognition Techniques, IEEE Computer Graphics and
    Applications 5(8), 1985.
    """
    corners, bulges = loop
    if len(corners) == 2:
        return of_two_vertices(corners, *bulges)
    if not any(bulges):
        return of_lines(corners) if convex(corners, near) else None
    if len(corners) == 3 and sorted(b == 0 for b in bulges) == [False, True, True] and min(bulges) < 0:
        return "fillet"
    return None


def of_two_vertices(corners, first, second):
    if first == 0 or second == 0:
        return "major chorded cylinder" if first + second > 1 + ALIKE else "minor chorded cylinder"
    if first * second < 0:
        return "crescent"
    if abs(first * second - 1) <= ALIKE * (1 + first * first) * (1 + second * second) / 4:
        return "cylinder"
    return "lens" if first * second < 1 else "double cylinder"


def of_lines(corners):
    cosines = [abs(cosine) for cosine in turns(corners)]
    right = sum(cosine <= ALIKE for cosine in cosines)
    if len(corners) == 3:
        return "wedge" if right else "triangular prism"
    return "block" if len(corners) == 4 and right == 4 else "convex prism"


def turns(corners):
    """The cosine of the turn at each corner."""
    for (ax, ay), (bx, by), (cx, cy) in threes(corners):
        ux, uy, vx, vy = bx - ax, by - ay, cx - bx, cy - by
        yield (ux * vx + uy * vy) / (hypot(ux, uy) * hypot(vx, vy))


def convex(corners, near):
    """Whether a polygon that does not cross itself turns left at every corner, which stands out by more than `near`."""
    return all(turn(p, q, r) > near for p, q, r in threes(corners))


def threes(corners):
    """Each corner between its neighbours."""
    return zip(corners[-1:] + corners[:-1], corners, corners[1:] + corners[:1], strict=True)
