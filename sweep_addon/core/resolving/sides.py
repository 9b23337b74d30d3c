# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sides: the parts of a block on either side of the line about which its contours turn, where they also slide along it.

Both sides of a propeller that turns and rises go up, one forward and one back. The hull of the whole would hold what is
above the one and below the other, in proportion to the rise; the hull of each side holds what that visits.
"""

import numpy as np

from ..vectors import cross, norms, unit

SLIDING = 1e-3  # of the contour's width along the line, in a block: by less the whole hull is as good
TURNING = 1e-6  # radians in a block: by less they turn about no line


def across(points, normals):
    """How far points are from the line about which their contours turn, in the plane between these; None for no line.

    Parameters
    ----------
    points : (m, k, 3) float array
        Of the contours of a block, one behind the other.
    normals : (2, 3) float array
        Across the planes of the first and of the last.

    Returns
    -------
    (m, k) float array or None
        To one side positive. None where the contours do not slide along the line either.
    """
    line = cross(*normals)
    turn = float(norms(line))
    if turn < TURNING:
        return None
    line /= turn
    slid = np.abs((points[:, -1] - points[:, 0]) @ line).max()
    if slid <= SLIDING * np.ptp(points[:, 0] @ line):
        return None
    first, last = points[:, 0].mean(axis=0), points[:, -1].mean(axis=0)
    aside, middle = unit(cross(line, normals.sum(axis=0))), (first + last) / 2
    away = ((first - middle) @ normals[0]) / (aside @ normals[0])
    return (points - middle) @ aside - away


def halves(points, sides):
    """The points of a convex part on either side of the line, those on it in both; one set if all are on one side.

    Parameters
    ----------
    points : (m, k, 3) float array
        The corners of the part, in order round it, in each contour of a block.
    sides : (m, k) float array
        What `across` says of them.

    Returns
    -------
    list of (n, 3) float arrays
    """
    following, beyond = np.roll(points, -1, axis=0), np.roll(sides, -1, axis=0)
    crossed = sides * beyond < 0
    if not crossed.any():
        return [points.reshape(-1, 3)]
    share = sides[crossed] / (sides[crossed] - beyond[crossed])
    cut = points[crossed] + share[:, None] * (following - points)[crossed]
    return [np.concatenate((points[kept], cut)) for kept in (sides >= 0, sides <= 0)]
