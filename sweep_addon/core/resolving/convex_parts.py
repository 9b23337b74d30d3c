# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Convex parts of a contour: triangles that fill it, joined as long as what they make is convex."""

import numpy as np

FLAT = 1e-9  # of the sides' product: a corner that turns right by less is straight


def convex_parts(points, triangles):
    """Join triangles to convex polygons.

    Parameters
    ----------
    points : (m, 2) float array
    triangles : (t, 3) int array
        Counter-clockwise, each edge that is not of the outline of two of them.

    Returns
    -------
    list of int arrays
        The points of each polygon, counter-clockwise: at most four times as many polygons as are needed.

    Source
    ------
    Hertel, Mehlhorn: Fast triangulation of simple polygons, 1983: leave out diagonals without which both their ends
    still turn left.

    Examples
    --------
    >>> square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    >>> [part.tolist() for part in convex_parts(square, [(0, 1, 2), (0, 2, 3)])]
    [[2, 3, 0, 1]]
    """
    parts = {number: list(corners) for number, corners in enumerate(np.asarray(triangles).tolist())}
    beside = {(a, b): number for number, part in parts.items() for a, b in zip(part, part[1:] + part[:1], strict=True)}
    xy = points.tolist()
    for a, b in [edge for edge in beside if edge[0] < edge[1] and edge[::-1] in beside]:
        one, other = beside[a, b], beside[b, a]
        if one == other:
            continue
        joined = from_corner(parts[one], b) + from_corner(parts[other], a)[1:-1]
        where = len(parts[one]) - 1  # a, with what is before and after it; b is the first
        if left(xy, joined, 0) and left(xy, joined, where):
            parts[one] = joined
            for here, there in zip(joined, joined[1:] + joined[:1], strict=True):
                beside[here, there] = one
            del parts[other]
    return [np.array(part) for part in parts.values()]


def from_corner(part, corner):
    """A polygon from one of its corners on."""
    at = part.index(corner)
    return part[at:] + part[:at]


def left(xy, polygon, at):
    """Whether a polygon turns left at a corner, or goes straight on."""
    before, here, after = (xy[polygon[(at + step) % len(polygon)]] for step in (-1, 0, 1))
    x, y, u, v = here[0] - before[0], here[1] - before[1], after[0] - here[0], after[1] - here[1]
    return x * v - y * u >= -FLAT * (x * x + y * y + u * u + v * v)
