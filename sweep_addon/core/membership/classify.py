# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership classification: whether points are in a set, on its boundary or out of it."""

import numpy as np

from ..parameters import require
from ..vectors import norms
from .labels import decided
from .members import member

RELATIVE = 1e-9  # of the size of the set: the tolerance where none is given


def classify(shape, points, tolerance=None):
    """Tell whether points are in a sweep or a sweep-CSG tree, on its boundary, or out of it; no mesh is made.

    Parameters
    ----------
    shape : a shape, a solid of ``sw.solids``, or a tree of them
    points : (n, 3) float array
        In metres.
    tolerance : float, optional
        The distance from the boundary, in metres, within which a point is on it; by default a billionth of the size.

    Returns
    -------
    (n,) int8 array
        +1 in, 0 on, -1 out.

    Raises
    ------
    ShapeError
        For a shape that is no solid, as one with an open end, and for points that are not numbers in rows of three.

    Source
    ------
    The lecture's "PMC algorithm" by inverse sweeping, with what it leaves out put right: docs/membership.md.

    Examples
    --------
    >>> import numpy as np
    >>> import sweep_addon as sw
    >>> tube = sw.GeneralizedCylinder(sw.contours.Circle(0.5), sw.trajectories.Line(end=(0, 0, 2)))
    >>> classify(tube, np.array([(0.0, 0.0, 1.0), (0.5, 0.0, 1.0), (0.0, 0.0, 3.0)])).tolist()
    [1, 0, -1]
    """
    points = rows_of_three(points)
    found = member(shape)
    if tolerance is None:
        tolerance = RELATIVE * float(norms(found.box[1] - found.box[0]))
    require(tolerance > 0, "must be more than 0", tolerance, "tolerance")
    return decided(found.labels(points, tolerance), points, tolerance, found)


def rows_of_three(points):
    """Points as a (n, 3) float array, or a refusal."""
    try:
        points = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError):
        points = np.empty(0)
    require(points.ndim == 2 and points.shape[1] == 3, "must be rows of three numbers", list(points.shape), "points")
    require(np.isfinite(points).all(), "must be finite", "others", "points")
    return points
