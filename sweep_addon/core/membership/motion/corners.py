# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Corners of a way: both legs go on straight to the plane that bisects the turn, and are cut off there."""

import numpy as np

from ...vectors import unit
from .panels import ORDER, Panels
from .planes import MIDDLE, NORMAL, SPACE, X, Y

ROOM = 1.05  # of what a leg needs beyond its corner
WAYS = slice(SPACE.start, MIDDLE.stop)


def with_corners(pieces, way, reach):
    """Panels with those beyond the corners of a way.

    Parameters
    ----------
    pieces : Panels
    way : Way
    reach : float
        How far the contour gets from the trajectory.

    Returns
    -------
    panels : Panels
    cuts : (k, 2, 4) float array
        Of each panel the planes that cut it off at its leg's start and end: normals away from it, and how far they are
        from the origin along them; 0 where there is none.
    legs : (k,) int array
        The number of the leg that each panel is of.
    """
    count = len(pieces.start)
    cuts, legs = np.zeros((count, 2, 4)), np.zeros(count, dtype=int)
    starts, ends, series, more_cuts, more_legs = [], [], [], [], []
    for number, corner in enumerate(way.corners, 1):
        legs[pieces.start >= corner.parameter] = number
    whole = way.breaks[-1] - way.breaks[0]
    for corner in way.corners:
        bisector = unit(corner.arrive + corner.leave)
        zone = reach * np.linalg.norm(corner.leave - corner.arrive) / np.linalg.norm(corner.leave + corner.arrive)
        plane = np.append(bisector, bisector @ corner.point)
        first = int(np.argmin(np.abs(pieces.start - corner.parameter)))
        last = first - 1  # of a closed way the last of all
        before = corner.parameter - pieces.end if first else pieces.end[-1] - pieces.end
        after = pieces.start - corner.parameter
        cuts[(before > -1e-9 * whole) & (before <= zone), 1] = plane
        cuts[(after > -1e-9 * whole) & (after <= zone), 0] = -plane
        for panel, side, along in ((last, 1.0, corner.arrive), (first, -1.0, -corner.leave)):
            starts.append(corner.parameter)
            ends.append(corner.parameter)
            series.append(straight_on(pieces.series[panel], side, along * zone * ROOM))
            more_cuts.append(cuts[panel])
            more_legs.append(legs[panel])
    for far, panel, side, parameter in zip(way.beyond, (0, count - 1), (-1.0, 1.0), way.breaks[[0, -1]], strict=True):
        if far:
            starts.append(parameter)
            ends.append(parameter)
            end = pieces.series[panel] @ side ** np.arange(ORDER)
            series.append(straight_on(pieces.series[panel], side, side * far * end[:3]))
            more_cuts.append(cuts[panel])
            more_legs.append(legs[panel])
    if not starts:
        return pieces, cuts, legs
    merged = Panels(
        np.append(pieces.start, starts), np.append(pieces.end, ends), np.concatenate((pieces.series, np.stack(series)))
    )
    return merged, np.concatenate((cuts, np.stack(more_cuts))), np.append(legs, more_legs)


def straight_on(series, side, way):
    """The series of a plane that goes on as it stands at an end of a panel, along a vector: (channels, ORDER)."""
    made = np.zeros_like(series)
    made[:, 0] = series @ (side ** np.arange(ORDER))
    for axis in (NORMAL, X, Y):
        step = made[axis, 0][:3] @ way / 2
        made[axis.stop - 1, :2] += step, step
    made[WAYS, 0] += np.tile(way / 2, 5)
    made[WAYS, 1] = np.tile(way / 2, 5)
    return made
