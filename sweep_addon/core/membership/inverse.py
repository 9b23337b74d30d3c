# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inverse sweeping: the planes of a contour that pass through points, and what points they go back to in them."""

from dataclasses import replace

import numpy as np

from ..declared.frozen import individual
from ..declared.names import titled
from ..declared.parameters import require
from ..shapes.operand import Operand
from ..shapes.translational_sweep import TranslationalSweep
from .classifying import RELATIVE, rows_of_three
from .members import member
from .motion.hash import portions
from .sets.deformed import CHUNK as PAIRS
from .sets.deformed import DeformedBody
from .sets.faces import SAME
from .sets.moving_plane import MovingPlane

CHUNK = 1 << 20  # pairs of points and panels at a time
ALIKE = 1e-6  # of the figure, and of the way: images of one point that are nearer are one


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
        Translational, rotational or PD curve sweep, generalized cylinder, or general sweep of a contour; its ends and
        its contour may be open.
    points : (n, 3) float array
        In metres.

    Returns
    -------
    Images
        Wherever the plane passes through a point; of a contour that is deformed, those in the box around it. There the
        deformed plane is meant, which may come by more than once at a time, and images nearer to each other than a
        millionth of the contour and of the way count once.

    Raises
    ------
    ShapeError
        For a shape that no contour sweeps out of its plane.

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
    plane = member(undrafted(shape) if isinstance(shape, TranslationalSweep) else shape)
    plane = getattr(plane, "plane", plane)
    if isinstance(plane, DeformedBody):
        return of_deformed(plane, points)
    of_plane = isinstance(plane, MovingPlane)
    require(of_plane, "must be the sweep of a contour, out of its plane", titled(type(shape)), "shape")
    return of_planes(plane, points)


def undrafted(shape):
    """What a translational sweep is without a draft whose edges vanish or part: its planes pass as they did."""
    return replace(shape, taper=0.0, hole_taper=0.0, tapers=()) if shape.is_parted else shape


def of_planes(plane, points):
    """The images of points (n, 3) in a `MovingPlane`."""
    whole = plane.panels.end.max() - plane.panels.start.min()
    smooth = np.flatnonzero(plane.panels.end > plane.panels.start)  # what goes on beyond a corner is no motion
    found, size = [], max(CHUNK // len(smooth), 1)
    for start in range(0, max(len(points), 1), size):
        some = points[start : start + size]
        point, panel = np.repeat(np.arange(len(some)), len(smooth)), np.tile(smooth, len(some))
        point, panel, x = plane.planes.passing(some, point, panel)
        images, _ = plane.taken_back.images(some[point], plane.taken_back.at(panel, x))
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


def of_deformed(body, points):
    """The images of points (n, 3) in the box around the figure of a `DeformedBody`: roots of its map, each once."""
    way = body.way.around
    boxes, tolerance = way.boxes(0.0), RELATIVE * way.size
    found = [(np.zeros(0, dtype=int), np.zeros((0, 3)), np.zeros(0))]
    for some in portions(boxes.counts(boxes.cells(points)), PAIRS):
        point, _, q, missed = way.back(points[some], boxes, tolerance)
        found.append((point + some.start, q, missed))
    point, q, missed = (np.concatenate(part) for part in zip(*found, strict=True))
    if not body.ends:  # where a closed way ends it begins again
        q[q[:, 2] >= way.total * (1 - SAME), 2] = 0.0
    kept = distinct(point, q / np.append(np.ptp(way.region.box, axis=0), way.total), missed)
    point, q = point[kept], q[kept]
    order = np.lexsort((*q.T, point))
    point, q = point[order], q[order]
    return Images(point, way.measure.parameter(q[:, 2]), q[:, :2])


def distinct(point, places, missed):
    """Which places of each point, (n, 3), are not those of another that has missed it by less: (k,) int."""
    order = np.lexsort((missed, point))
    point, places = point[order], places[order]
    first = np.searchsorted(point, point)
    before = np.arange(len(point)) - first  # how many there are
    later = np.repeat(np.arange(len(point)), before)
    earlier = np.arange(len(later)) - np.repeat(np.cumsum(before) - before - first, before)
    again = np.zeros(len(point), dtype=bool)
    again[later[(np.abs(places[later] - places[earlier]) <= ALIKE).all(axis=1)]] = True
    return order[~again]
