# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Corners of a way: both legs go on straight to the plane that bisects the turn, and are cut off there."""

import numpy as np

from ...vectors import unit
from .panels import ORDER, Panels
from .planes import MIDDLE, NORMAL, SPACE, X, Y

SAME = 1e-9  # of the way: places nearer than this are one
WAYS = slice(SPACE.start, MIDDLE.stop)


def with_corners(pieces, way):
    """Panels with those beyond the corners of a way.

    Parameters
    ----------
    pieces : Panels
    way : Way

    Returns
    -------
    panels : Panels
    cuts : (k, 2, 4) float array
        Of each panel the planes that cut it off at its leg's start and end: normals away from it, and how far they are
        from the origin along them; 0 where there is none.
    legs : (k,) int array
        The number of the leg that each panel is of.
    """
    count, cuts = len(pieces.start), np.zeros((len(pieces.start), 2, 4))
    legs = np.searchsorted([corner.parameter for corner in way.corners], pieces.start, side="right")
    for number, corner in enumerate(way.corners, 1):
        bisector = unit(corner.arrive + corner.leave)
        plane = np.append(bisector, bisector @ corner.point)
        before, after = legs == number - 1, legs == number
        if way.closed:  # the last leg goes on to the first corner
            before, after = (legs % len(way.corners) == which % len(way.corners) for which in (number - 1, number))
        cuts[before & near(pieces.start, corner.parameter, corner, way), 1] = plane
        cuts[after & near(corner.parameter, pieces.end, corner, way), 0] = -plane
    starts, ends, series, more_cuts, more_legs = [], [], [], [], []
    for corner in way.corners:
        first = int(np.argmin(np.abs(pieces.start - corner.parameter)))
        last = first - 1  # of a closed way the last of all
        for panel, side, onward in ((last, 1.0, corner.arrive), (first, -1.0, -corner.leave)):
            starts.append(corner.parameter)
            ends.append(corner.parameter)
            series.append(straight_on(pieces.series[panel], side, onward * corner.zone))
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


def near(start, end, corner, way):
    """Whether it is no farther from parameters on to others than a corner's zone, round a closed way if need be."""
    whole = way.breaks[-1] - way.breaks[0]
    far = (end - start) % whole if way.closed else end - start
    return far <= corner.zone + SAME * whole


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
