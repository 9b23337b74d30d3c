# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership classification: whether points are in a set, on its boundary or out of it."""

from numbers import Real

import numpy as np

from ..declared.parameters import require
from ..shapes.operand import Operand
from ..vectors import norms
from .blocks import in_blocks
from .labels import decided
from .members import member

RELATIVE, LARGEST = 1e-9, 0.1  # of the size of the set: the tolerance where none is given, and the largest


def classify(shape, points, tolerance=None, progress=None):
    """Tell whether points are in a sweep or a sweep-CSG tree, on its boundary, or out of it.

    What has no inside, as a tube with an open end, is a surface, which points are on or out of.

    Parameters
    ----------
    shape : a shape, a solid of ``sw.solids``, or a tree of them
    points : (n, 3) float array
        In metres.
    tolerance : float, optional
        The distance from the boundary, in metres, within which a point is on it: at most a tenth of the size, by
        default a billionth of it.
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    (n,) int8 array
        +1 in, 0 on, -1 out.

    Raises
    ------
    ShapeError
        For a tree of what is no solid, and for points that are not numbers in rows of three.

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
    require(isinstance(shape, Operand), "must be a shape, a solid or a tree", shape, "shape")
    found = member(shape)
    size = float(norms(found.box[1] - found.box[0]))
    tolerance = within_limits(RELATIVE * size if tolerance is None else tolerance, size)
    return in_blocks(lambda some: decided(found.labels(some, tolerance), some, tolerance, found), points, progress)


def within_limits(tolerance, size):
    """A tolerance as a number, or a refusal."""
    number = isinstance(tolerance, Real) and not isinstance(tolerance, bool)
    require(number and tolerance > 0, "must be a number of metres, more than 0", tolerance, "tolerance")
    most = LARGEST * size
    require(tolerance <= most, f"must be at most {most:.6g}, a tenth of the size", tolerance, "tolerance")
    return float(tolerance)


def rows_of_three(points):
    """Points as a (n, 3) float array, or a refusal."""
    try:
        found = np.asarray(points, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        found = np.empty(0)
    fits = found.ndim == 2 and found.shape[1] == 3
    got = list(found.shape) if found.ndim > 1 else points
    require(fits, "must be rows of three numbers", got, "points")
    wrong = ~np.isfinite(found).all(axis=1)
    require(not wrong.any(), "must be finite", found[wrong][:1].tolist(), "points")
    return found
