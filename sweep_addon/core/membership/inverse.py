# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inverse sweeping: the planes of a contour that pass through points, and what points they go back to in them."""

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import require
from ..declared.wording import titled
from ..shapes.operand import Operand
from .classify import rows_of_three
from .members import member
from .moving_plane import SAME, MovingPlane

CHUNK = 1 << 20  # pairs of points and panels at a time


@individual
class Images:
    """Points taken back to the contour's own plane, once for each time that it passes through them.

    Parameters
    ----------
    point : (k,) int array
        The number of the point that each image is of, rising.
    u : (k,) float array
        The parameter at which the plane passes through it, rising for each point: that of the trajectory; of a
        translational sweep the height in metres, of a rotational sweep the angle in radians.
    images : (k, 2) float array
        Where the point is then in the contour's own plane, in metres.

    Examples
    --------
    >>> found = Images(np.array([0, 0, 1]), np.array([0.0, 1.0, 0.5]), np.zeros((3, 2)))
    >>> found.of(0).tolist()
    [0.0, 1.0]
    """

    point: np.ndarray
    u: np.ndarray
    images: np.ndarray

    def of(self, number):
        """The parameters of one point."""
        return self.u[self.point == number]


def inverse_sweep(shape, points):
    """Take points back to the plane of a contour by all motions that lead through them.

    Parameters
    ----------
    shape : a planar shape
        Translational, rotational or PD curve sweep, generalized cylinder, or general sweep of a contour that is not
        deformed; its ends and its contour may be open.
    points : (n, 3) float array
        In metres.

    Returns
    -------
    Images

    Raises
    ------
    ShapeError
        For a shape that no plane sweeps.

    Source
    ------
    The lecture, "PMC algorithm", steps 1 and 2.

    Examples
    --------
    Two planes of a torus pass through every point off its axis; in one it is 2 m out, in the other as far beyond:

    >>> import sweep_addon as sw
    >>> torus = sw.GeneralizedCylinder(sw.contours.Circle(0.5), sw.trajectories.Arc(2.0, 2 * np.pi))
    >>> found = inverse_sweep(torus, [(0.0, 2.25, 0.0)])
    >>> found.u.round(6).tolist(), np.abs(found.images).sum(axis=1).round(6).tolist()
    ([1.570796, 4.712389], [0.25, 4.25])
    """
    points = rows_of_three(points)
    require(isinstance(shape, Operand), "must be a planar shape", shape, "shape")
    plane = member(shape)
    plane = getattr(plane, "plane", plane)
    of_plane = isinstance(plane, MovingPlane)
    require(
        of_plane, "must be the sweep of a contour that is not deformed, out of its plane", titled(type(shape)), "shape"
    )
    whole = plane.panels.end.max() - plane.panels.start.min()
    smooth = np.flatnonzero(plane.panels.end > plane.panels.start)  # what goes on beyond a corner is no motion
    found, size = [], max(CHUNK // len(smooth), 1)
    for start in range(0, max(len(points), 1), size):
        some = points[start : start + size]
        point, panel = np.repeat(np.arange(len(some)), len(smooth)), np.tile(smooth, len(some))
        point, panel, x = plane.planes.passing(some, point, panel)
        images, _ = plane.images(some[point], plane.at(panel, x))
        found.append((point + start, plane.panels.parameter(panel, x), images))
    point, parameter, images = (np.concatenate(part) for part in zip(*found, strict=True))
    if plane.way.closed:
        low, high = plane.way.breaks[[0, -1]]
        parameter = np.where(parameter >= high - SAME * whole, low, parameter)
    order = np.lexsort((parameter, point))
    point, parameter, images = point[order], parameter[order], images[order]
    other = np.append(True, (np.diff(point) > 0) | (np.diff(parameter) > SAME * whole))[: len(point)]
    u = plane.way.parameter(parameter[other]) if plane.way.parameter else parameter[other]
    return Images(point[other], u, images[other])
