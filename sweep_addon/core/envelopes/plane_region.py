# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The plane region that a strip covers, each place once, however it folds and crosses itself.

Where all faces of a stretch look up, the line round it runs about each place as often as faces cover it. Faces that
look down are turned round one by one. So all these lines run about each place that is covered, and about no other.
"""

import numpy as np

from ..contours import Section
from ..contours.planar import cornered
from ..meshes.booleans import library
from ..meshes.runs import following
from ..vectors import unit

FEW = 16  # faces that fold: many overlap
SPECK = 1e-12  # of the square of the size: less is no area
STEPS = 4.0  # of single precision: so far corners that are in one place are drawn apart


def region(strips):
    """The section that strips cover together.

    Parameters
    ----------
    strips : sequence of (left, right)
        Points (n, 2) on either side, in metres; both are the same point at a tip.

    Returns
    -------
    Section

    Examples
    --------
    A strip that crosses itself at a right angle covers the square there once:

    >>> left = np.array([(0, 1), (4, 1), (4, 3), (2, 3), (2, -1.0)])
    >>> right = np.array([(0, 0), (5, 0), (5, 4), (1, 4), (1, -1.0)])
    >>> round(region([(left, right)]).area, 9)
    14.0
    """
    manifold3d = library()
    filled = manifold3d.FillRule.NonZero
    parts = [manifold3d.CrossSection(loops, filled) for left, right in strips for loops in lines(left, right)]
    while len(parts) > 1:  # neighbours first: what they have in common is done with
        pairs = zip(parts[::2], parts[1::2], strict=False)
        parts = [*(one + other for one, other in pairs), *parts[len(parts) // 2 * 2 :]]
    size = max(np.ptp(side, axis=0).max() for strip in strips for side in strip)
    found = [loop for loop in parts[0].to_polygons() if abs(shoelace(loop)) > SPECK * size**2]
    least = far_apart(np.concatenate(found))
    found = [loop[np.hypot(*(np.roll(loop, -1, axis=0) - loop).T) > least] for loop in found]
    offsets = np.cumsum([0, *map(len, found)])
    return cornered(Section(drawn_apart(np.concatenate(found), following(offsets)), offsets, None))


def drawn_apart(points, ahead):
    """Corners (n, 2) of loops, those that single precision does not tell apart moved towards their neighbours.

    A region that touches itself in a point has two corners there; each goes back into what it is the tip of. `ahead`
    has the number of the next corner of each.

    >>> butterfly = np.array([(0.0, 0.0), (1, -1), (1, 1), (0, 0), (-1, 1), (-1, -1)])
    >>> apart = drawn_apart(butterfly, np.array([1, 2, 3, 4, 5, 0])).astype(np.float32)
    >>> len(np.unique(butterfly, axis=0)), len(np.unique(apart, axis=0))
    (5, 6)
    """
    _, which, count = np.unique(points.astype(np.float32), axis=0, return_inverse=True, return_counts=True)
    tips = np.flatnonzero(count[which.reshape(-1)] > 1)
    behind = np.empty_like(ahead)
    behind[ahead] = np.arange(len(ahead))
    ways = unit(points[ahead[tips]] - points[tips]) + unit(points[behind[tips]] - points[tips])
    points = points.copy()
    points[tips] += far_apart(points) * unit(ways)
    return points


def far_apart(points):
    """How far apart single precision tells points (n, 2) in each direction."""
    return STEPS * float(np.spacing(np.float32(np.abs(points).max())))


def lines(left, right):
    """The line round each stretch of faces that look up, (k, 2), and those round the triangles of a few others."""
    triangles = np.stack(
        (np.stack((left[:-1], right[:-1], right[1:])), np.stack((left[:-1], right[1:], left[1:])))
    ).transpose(2, 0, 1, 3)  # face, half, corner, axis
    areas = shoelace(triangles)
    up = (areas >= 0).all(axis=1)
    change = np.flatnonzero(np.diff(up)) + 1
    for stretch in np.split(np.arange(len(up)), change):
        if up[stretch[0]]:
            first, last = stretch[0], stretch[-1] + 2
            yield [np.concatenate((right[first:last], left[first:last][::-1]))]
        else:
            for few in np.array_split(stretch, -(-len(stretch) // FEW)):
                some, area = triangles[few].reshape(-1, 3, 2), areas[few].ravel()
                some[area < 0] = some[area < 0, ::-1]
                yield list(some[area != 0])


def shoelace(points):
    """The signed areas of polygons: (..., n, 2) to (...)."""
    x, y = points[..., 0], points[..., 1]
    return (x * np.roll(y, -1, axis=-1) - y * np.roll(x, -1, axis=-1)).sum(axis=-1) / 2
