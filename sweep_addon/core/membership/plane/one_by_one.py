# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The distance of places of the plane from few lines and arcs, one edge after the other, as they are or mapped."""

import numpy as np

from .maps import narrowest

LEAST = 1e-300


def nearest_of(loops, x, y, maps=None, kept=None):
    """How far places x (n,) and y (n,) are from loops, negative inside: (n,).

    Inside is where a ray along x crosses an odd number of chords, and again what is between an arc and its chord.

    Parameters
    ----------
    loops : Loops
    x, y : (n,) float array
    maps : (n, 2, 2) float array, optional
        Maps of the plane, lower left 0: what they make of all is where distances count. Those from arcs are told to
        first order or less, from their ends exactly.
    kept : (m,) bool array, optional
        The edges from which the distance is, where not from all; the side is that of all.
    """
    least, inside = np.full(len(x), np.inf), np.zeros(len(x), dtype=bool)
    kept = np.ones(len(loops.start), dtype=bool) if kept is None else kept
    narrow = narrowest(maps) if maps is not None and loops.arcs.any() else None
    for number, ((a, b), (c, d)) in enumerate(zip(loops.start.tolist(), loops.end.tolist(), strict=True)):
        along, up, right, above = c - a, d - b, x - a, y - b
        if up == 0:
            left_of = (above >= 0) == (along > 0)
        else:
            left_of = along * above - up * right > 0
            inside ^= ((above >= 0) != (y >= d)) & (left_of == (up > 0))
        if loops.arcs[number]:
            far, between = from_arc(loops, number, x, y, left_of, maps, narrow)
            inside ^= between
        if not kept[number]:
            continue
        if loops.arcs[number]:
            np.minimum(least, far, out=least)
            for end in ((right, above), (x - c, y - d)):
                np.minimum(least, squares(*end, maps), out=least)
        else:
            np.minimum(least, from_line(along, up, right, above, maps), out=least)
    return np.where(inside, -1.0, 1.0) * np.sqrt(least)


def nearest_of_each(corners, ahead, points, maps=None):
    """The same of a polygon for each of points (n, 2), with corners (n, m, 2), each followed by that ahead: (n,)."""
    (x, y), (places_x, places_y) = points.T, np.ascontiguousarray(corners.T)
    least, inside = np.full(len(points), np.inf), np.zeros(len(points), dtype=bool)
    for a, b, c, d in zip(places_x, places_y, places_x[ahead], places_y[ahead], strict=True):
        along, up, right, above = c - a, d - b, x - a, y - b
        inside ^= ((above >= 0) != (y >= d)) & ((along * above - up * right > 0) == (up > 0))
        far = from_line(along, up, right, above, maps)
        far[(along == 0) & (up == 0)] = np.inf  # no edge
        np.minimum(least, far, out=least)
    return np.where(inside, -1.0, 1.0) * np.sqrt(least)


def squares(x, y, maps):
    """The squares of vectors as they are mapped: (n,)."""
    if maps is not None:
        x, y = maps[:, 0, 0] * x + maps[:, 0, 1] * y, maps[:, 1, 1] * y
    return x * x + y * y


def from_line(along, up, right, above, maps):
    """The squares of the distances from a line that leads along and up, of places right and above of its start."""
    if maps is not None:
        along, up = maps[:, 0, 0] * along + maps[:, 0, 1] * up, maps[:, 1, 1] * up
        right, above = maps[:, 0, 0] * right + maps[:, 0, 1] * above, maps[:, 1, 1] * above
    share = (right * along + above * up) / np.maximum(along * along + up * up, LEAST)
    share = np.minimum(np.maximum(share, 0.0, out=share), 1.0, out=share)
    right, above = right - share * along, above - share * up
    return right * right + above * above


def from_arc(loops, number, x, y, left_of, maps, narrow):
    """The squares of the distances from an arc but not from its ends, and which places are between it and its chord.

    Mapped it is a part of an ellipse. Which of its places is nearest may change: beyond its ends it is at least as far
    as the ellipse, and as the nearer end was before it was mapped, stretched the least.
    """
    centre, radius, bulge = loops.centres[number], loops.radii[number], loops.bulges[number]
    sign = np.sign(bulge)
    x, y = x - centre[0], y - centre[1]
    (a, b), (c, d) = loops.start[number] - centre, loops.end[number] - centre
    after, ahead = (a * y - b * x) * sign >= 0, (x * d - y * c) * sign >= 0
    beside = after & ahead if abs(bulge) <= 1 else after | ahead
    from_centre = np.sqrt(x * x + y * y)
    between = (from_centre < radius) & (left_of != (bulge > 0))
    if maps is None:
        return np.where(beside, (from_centre - radius) ** 2, np.inf), between
    far = from_ellipse(x, y, from_centre, radius, maps, narrow) ** 2
    ends = np.minimum((x - a) ** 2 + (y - b) ** 2, (x - c) ** 2 + (y - d) ** 2)
    return np.where(beside, far, np.maximum(far, narrow**2 * ends)), between


def from_ellipse(x, y, from_centre, radius, maps, narrow):
    """How far places about a circle's centre are from the ellipse that maps make of it, or less: (n,).

    Outside it is the distance to first order, that from a tangent. Inside the square of the scaled radius grows as
    steeply as here, and by its greatest bend faster.
    """
    first = x / maps[:, 0, 0]
    second = (y - maps[:, 0, 1] * first) / maps[:, 1, 1]
    steep = np.sqrt(first * first + second * second)
    outside = (from_centre - radius) * from_centre / np.maximum(steep, LEAST)
    return np.where(from_centre > radius, outside, reached(radius**2 - from_centre**2, 2 * steep, 2 / narrow**2))


def reached(missing, steep, bend):
    """How far it is at least to where a function has grown by what is missing, of a slope that grows so much."""
    missing = np.maximum(missing, 0.0)
    return 2 * missing / np.maximum(steep + np.sqrt(steep**2 + 2 * bend * missing), LEAST)
