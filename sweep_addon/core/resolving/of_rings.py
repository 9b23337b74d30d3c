# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solid of rings: contours that stand one behind the other, wherever they came from."""

import numpy as np

from ..declared.parameters import require
from ..grids.grid import Grid
from ..meshes.mesh import Mesh
from ..meshes.polyhedron import Bare
from ..rings import caps
from ..vectors import norms
from .filling import flat
from .resolve import resolved

POINT = 1e-12  # of the size: a ring that is no larger is one point


class Ringed(Bare):
    """The chart of a mesh of which the grid is known and no more."""

    def __init__(self, grid):
        self.grid = grid
        self.rings = grid.rings


def solid_of_rings(points, closed=False, offsets=None, progress=None):
    """The boundary of all that contours visit between the rings at which they stand.

    Parameters
    ----------
    points : (n, m, 3) float array
        The points of each ring in metres, in a plane or nearly so, counter-clockwise as seen from where it moves to. A
        ring that is one point is a tip; other ends are closed by faces.
    closed : bool
        Whether the last ring leads to the first.
    offsets : (k + 1,) int array, optional
        Where each loop of a ring starts; by default it is one loop. Holes are clockwise.
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    Mesh
        Closed and manifold.

    Raises
    ------
    ShapeError
        For a shape that is none of these, one whose contour turns too much from ring to ring, or where manifold3d is
        missing.

    Examples
    --------
    A disc of radius 0.5 that turns about an axis 0.3 m from its centre: a spindle torus, not Pappus' volume, in which
    counts once what both sides visit.

    >>> from math import pi
    >>> turn, around = (np.arange(n) * 2 * pi / n for n in (64, 32))
    >>> radial = np.stack((np.cos(turn), np.sin(turn), 0 * turn), axis=1)[:, None]
    >>> rings = (0.3 + 0.5 * np.cos(around))[:, None] * radial - 0.5 * np.sin(around)[:, None] * (0, 0, 1)
    >>> round(solid_of_rings(rings, closed=True).volume(), 3)
    1.525
    """
    points = np.asarray(points, np.float64)
    require(points.ndim == 3 and points.shape[2] == 3, "must be (n, m, 3)", points.shape, "points")
    offsets = np.array([0, points.shape[1]] if offsets is None else offsets)
    aside = points - points.mean(axis=1, keepdims=True)
    tips = np.flatnonzero(norms(aside).max(axis=1) <= POINT * np.abs(points).max())
    ends = [None if closed or ring in tips else caps.faces(flat(aside[ring], offsets)) for ring in (0, len(points) - 1)]
    grid = Grid(
        rings=len(points),
        tips=tuple(tips.tolist()),
        closed=closed,
        creases=(),
        offsets=tuple(offsets.tolist()),
        sharp=(),
        caps=tuple(ends),
    )
    vertices = np.concatenate((points[grid.whole].swapaxes(0, 1).reshape(-1, 3), points[tips, 0]))
    return resolved(Mesh(vertices, grid.topology(), Ringed(grid)), progress)
