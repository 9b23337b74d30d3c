# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cutting: where limiting planes meet the lines that the points of a contour draw, and as many points as that takes."""

from functools import lru_cache

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import ShapeError, require
from ..grids.drawn import affine
from ..self_intersection.folds import roots
from ..vectors import dot, norms
from .limits import Plane

FARTHEST = 100.0  # lengths and reaches beyond the end, to which a solid may go on
ONCE = "must cut the line of every point of the contour once"
NEARBY = 16  # heights, among which a cut is looked for at first: it is near an end of the axis
HALVINGS = 12  # of an edge at most: what is missed falls to a quarter with each
FLAT = 1e-9  # the sine of the angle between a plane and the axis beyond its end: it is never cut there
NAMES, OUTWARD = ("start", "end"), np.array([[-1.0], [1.0]])


def followed(limits, whole, section, tolerance):
    """A section whose edges are halved until straight ones follow the cuts, and where the lines of its points end.

    Parameters
    ----------
    limits : tuple of two (Flat, Open or Plane)
    whole : Spans
    section : Section
    tolerance : float
        How far from a cut the middle of an edge may be, in metres.

    Returns
    -------
    section : Section
    ends : (2, m) float array
        Heights along the axis in metres; below 0 and above the total where the solid goes on straight.

    Raises
    ------
    ShapeError
        Where a plane does not cut the line of every point once.
    """
    planes = along_axis(limits, whole)
    for halvings in range(HALVINGS, -1, -1):
        ahead = section.following.copy()
        ahead[section.gaps] = section.gaps
        points = np.concatenate((section.points, (section.points + section.points[ahead]) / 2))
        heights, places = planes.crossings(points)
        corners, middles = places[:, : len(ahead)], places[:, len(ahead) :]
        missed = norms(middles - (corners + corners[:, ahead]) / 2).max(axis=0)
        if missed.max() <= tolerance or not halvings:
            break
        section = section.divided(missed > tolerance)
    ends = np.empty((2, len(ahead)))
    ends[0], ends[1] = 0.0, whole.bending.total
    ends[planes.sides] = heights[:, : len(ahead)]
    return section, ends


@individual
class Planes:
    """Limiting planes as they are seen from a curved axis.

    How far a point is above a plane has three parts: those of the axis, of e2 and of e3, by the point's weights.

    Parameters
    ----------
    whole : Spans
    sides : (p,) int array
        0 for a plane at the start, 1 for one at the end.
    across : (p, 3) float array
        Unit normals.
    level : (p,) float array
        How far the origin is above each.
    z : (p, g) float array
        Heights of the axis, each from its own end on.
    above : (p, g, 3) float array
        The parts there.
    outward : (p,) float array
        How much the axis rises above each, for a metre that it goes on straight.
    coefficients : (p, k, 3, ORDER) float array
        The parts in each span.
    """

    whole: object
    sides: np.ndarray
    across: np.ndarray
    level: np.ndarray
    z: np.ndarray
    above: np.ndarray
    outward: np.ndarray
    coefficients: np.ndarray

    def crossings(self, points):
        """Where lines of points (m, 2) cross the planes: heights (p, m) and places (p, m, 3)."""
        count, weights = len(self.sides), affine(points)
        low, high, at_low, at_high = self.intervals(weights)
        which, middles = np.repeat(np.arange(count), len(points)), (low + high) / 2
        line, span = self.whole.line(np.tile(points, (count, 1)), middles), np.searchsorted(self.whole.ends, middles)
        if self.whole.exact[span].all():
            parts = self.coefficients[which, span]
            height = self.whole.summed(span, (np.tile(weights, (count, 1))[:, None] @ parts)[:, 0])
        else:
            across, level = self.across[which], self.level[which]

            def height(z):
                return dot(line(z), across) + level

        found = roots(height, low, high, at_low, at_high)
        return found.reshape(count, -1), line(found).reshape(count, -1, 3)

    def intervals(self, weights):
        """Where lines of points first change their side of each plane, coming from its end of the axis: (4, p m).

        Between two heights, of which each line is so far above the plane: two rows, and two.
        """
        looked, most = NEARBY, self.z.shape[1]
        while True:
            z, above = self.looked_at(weights, looked)
            higher = above >= 0
            change = higher[..., 1:] != higher[..., :-1]
            missed = ~change.any(axis=2)
            if looked >= most or not missed.any():
                break
            looked *= 4
        first = change.argmax(axis=2)
        early = np.arange(change.shape[2]) <= first.max(axis=1)[:, None, None]
        again = np.count_nonzero(change & early, axis=2) > 1
        again |= higher[..., 0] != higher[:, :1, 0]
        for wrong, how in ((missed, "not cut"), (again, "cut again before all others are")):
            if wrong.any():
                plane, point = np.argwhere(wrong)[0]
                raise ShapeError(f"{ONCE}, got that of point {point + 1} {how}", NAMES[self.sides[plane]])
        above, first, every = above.reshape(first.size, -1), first.ravel(), np.arange(first.size)
        plane = every // len(weights)
        return np.stack((z[plane, first], z[plane, first + 1], above[every, first], above[every, first + 1]))

    def looked_at(self, weights, most):
        """Heights from beyond an end of the axis on, (p, k), and how far each line is above the plane, (p, m, k).

        The first height is beyond all cuts that there are beyond the end; not more than so many others follow.
        """
        above = weights @ self.above[:, :most].swapaxes(1, 2)
        total, slanted = self.whole.bending.total, np.abs(self.outward) > FLAT
        rise = np.where(slanted, self.outward, np.inf)
        beyond = (above[..., 0] / -rise[:, None]).max(axis=1)
        farthest = FARTHEST * (total + float(np.abs(weights[:, 1:]).max()))
        for side, place in zip(self.sides, beyond, strict=True):
            require(place <= farthest, f"must cut within {farthest:.6g} m of the trajectory's end", place, NAMES[side])
        far = np.where(slanted, np.maximum(beyond, 0.0) + total, 0.0)[:, None]
        z = np.concatenate((self.z[:, :1] + far * OUTWARD[self.sides], self.z[:, :most]), axis=1)
        return z, np.concatenate((above[..., :1] + (far * self.outward[:, None])[..., None], above), axis=2)


@lru_cache(maxsize=16)
def along_axis(limits, whole):
    """The planes among two limits, made once for equal ones along the same axis: `Planes`."""
    sides = np.array([side for side, limit in enumerate(limits) if isinstance(limit, Plane)])
    across = np.array([limits[side].across for side in sides])
    level = np.array([limits[side].heights(0.0) for side in sides])
    z, axes = (np.stack([part[:: -1 if side else 1] for side in sides]) for part in whole.looked_at)
    above = (axes @ across[:, None, :, None])[..., 0]
    coefficients = np.einsum("pc,swcj->pswj", across, whole.coefficients[:, :, :3])
    above[..., 0] += level[:, None]
    coefficients[..., 0, 0] += level[:, None]
    return Planes(whole, sides, across, level, z, above, dot(whole.outward[sides], across), coefficients)
