# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Caps: the faces that fill a section, one for each outline without holes and triangles for one that has them."""

from functools import lru_cache

import numpy as np

from ..meshes.triangulate import triangulate
from .ends import Flat

MOST_FLIPS = 100


@lru_cache(maxsize=16)
def faces(section, apart=()):
    """The faces of a section.

    Parameters
    ----------
    section : Section
    apart : tuple of int
        Points of which no two are joined by an edge within, where that can be: both ends of a sweep share them.

    Returns
    -------
    points, offsets : tuple of int
        The section's points at the corners of the faces, and where each face starts.
    """
    corners, sizes = [], []
    for outer, *holes in section.islands:
        loops = [np.arange(*section.offsets[loop : loop + 2]) for loop in (outer, *holes)]
        found = triangulate(section.points, loops) if holes else loops[0][None]
        found = kept_apart(found, section.points, set(apart)) if holes and apart else found
        corners.extend(found.ravel().tolist())
        sizes.extend([found.shape[1]] * len(found))
    return tuple(corners), (0, *np.cumsum(sizes).tolist())


def kept_apart(triangles, points, apart):
    """Triangles (k, 3) of points (m, 2), their diagonals between some of these flipped, and others that are in the way.

    A diagonal can be flipped where the two triangles beside it make a convex quadrilateral. Where they do not, the
    nearest other diagonal is flipped first that can be, which brings other points beside it.
    """
    triangles, tried = [tuple(each) for each in triangles.tolist()], set()
    for _ in range(MOST_FLIPS):
        beside = {(a, b): (n, c) for n, each in enumerate(triangles) for a, b, c in turns(each)}
        wrong = [(a, b) for a, b in beside if a in apart and b in apart and a < b and (b, a) in beside]
        for edge in outward(wrong, beside):
            if {*edge} not in tried and flipped(triangles, beside, edge, points, apart):
                tried.add(frozenset(edge))
                break
        else:
            break
    return np.array(triangles)


def outward(edges, beside):
    """Edges, then the other sides of the triangles beside them, then those of the triangles beside these, each once."""
    met = set()
    while edges:
        yield from edges
        met.update(map(frozenset, edges))
        both = [each for a, b in edges for each in ((a, b), (b, a)) if each in beside]
        sides = (side[:2] for each in both for side in turns((*each, beside[each][1]))[1:])
        edges = list({frozenset(side): side for side in sides if {*side} not in met}.values())


def turns(triangle):
    """A triangle from each of its corners on."""
    a, b, c = triangle
    return (a, b, c), (b, c, a), (c, a, b)


def flipped(triangles, beside, edge, points, apart):
    """Whether the diagonal between two triangles could be flipped, neither way between points that are kept apart."""
    a, b = edge
    if (b, a) not in beside:
        return False
    (first, c), (second, d) = beside[a, b], beside[b, a]
    if {c, d} <= apart or min(left(points, c, a, d), left(points, d, b, c)) <= 0:
        return False
    triangles[first], triangles[second] = (c, a, d), (d, b, c)
    return True


def left(points, a, b, c):
    """Twice the area of a triangle of three of the points, negative where it goes round clockwise."""
    (x, y), (u, v) = points[b] - points[a], points[c] - points[a]
    return x * v - y * u


def at_ends(sections, ends, points, apart=()):
    """The faces of two ends, or None where one is not flat or a point, as a grid takes them; an open line has none."""
    return tuple(
        faces(section, apart) if isinstance(end, Flat) and section.closed and not point else None
        for section, end, point in zip(sections, ends, points, strict=True)
    )
