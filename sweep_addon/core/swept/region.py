# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep of a region: the surface of a formula over plane and way, put where the region stands.

Where the way leads back to its start, it is bent to a ring on which the formula has neither a start nor an end.
"""

from functools import cached_property

import numpy as np

from ..declared.parameters import require
from ..meshes.booleans import union
from ..meshes.joining import joined
from ..meshes.polyhedron import polyhedron
from ..offsets.any_field import AnyField
from ..offsets.level_set import level_set
from ..trajectories.arc_length import arc_length
from ..variation.legs import legs, notched, on_leg
from ..vectors import norms, unit
from .planar import raised

SQUARE = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
QUICK = 160  # cells of what is made in a tenth of a second or two
SLOPED = 33  # places along each side where it is looked at how steep the formula is
ROOM = 1.25  # for what is steeper between them
DIFFERENCE = 1e-6  # of the size: over which slopes are taken
SAME = 1e-9  # of the largest value: by less the formula may differ at both ends of what is a ring
FLAT = 1e-3  # of the steepest slope: where it is less, the way to the surface is not told by it


class Changing:
    """A region in general motion, in a space of its x and y and of the way along the trajectory.

    Parameters
    ----------
    shape : GeneralSweep
    """

    def __init__(self, shape):
        self.shape, self.motion, self.region = shape, shape.motion, shape.generator
        self.total = arc_length(shape.trajectory).total

    @cached_property
    def comes_back(self):
        """Whether a closed trajectory brings the region back to where it began, as it was."""
        if not self.motion.comes_back(raised(self.region.size / 2 * SQUARE)):
            return False
        side = np.linspace(-self.region.size / 2, self.region.size / 2, SLOPED)
        first, last = (self.region.evaluate(*np.meshgrid(side, side), t) for t in (0.0, 1.0))
        return bool(np.abs(last - first).max() <= SAME * np.abs(first).max())

    def mesh(self, dtype=np.float64):
        made = self.legs(dtype)
        return made[0] if len(made) == 1 else notched(joined(made))

    def legs(self, dtype=np.float64):
        """The mesh of each leg."""
        found = legs(self.motion, self.comes_back)
        made = [self.leg(leg, dtype) for leg in (found if len(found) else [None])]
        made = [mesh for mesh in made if mesh is not None]
        require(made, "must be so many that a part of the region holds one", self.shape.cells, "cells")
        return made

    def leg(self, leg, dtype):
        """The mesh of what it leaves on a leg, or on the whole way; None where nothing is large enough."""
        round_ = self.comes_back and leg is None
        field = RoundTheWay(self.region, self.total) if round_ else OverTheWay(self.region, self.total, leg)
        found = level_set(field, *field.box, max(self.region.size, self.total) / self.shape.cells)
        if found is None:
            return None
        places = self.placed(field.over_the_way(found.vertices.places), leg).astype(dtype)
        made = polyhedron(places, found.triangles)
        return made if made.volume() > 0 else polyhedron(places, found.triangles[:, ::-1])  # it ran backward

    def placed(self, points, leg):
        """Points of x, y and the way (n, 3) where the motion takes them: (n, 3)."""
        low, high = (0.0, self.total) if leg is None else leg
        s, which = np.unique(np.append(low, points[:, 2].clip(low, high)), return_inverse=True)
        poses = self.motion.at(s) if leg is None else on_leg(self.motion, leg, s)
        return self.motion.each(raised(points[:, :2]), poses.only(which.ravel()[1:]))

    @property
    def is_solid(self):
        """Whether it takes long."""
        return self.shape.cells > QUICK

    def solid(self, progress=None):
        """The mesh, that of several legs united."""
        made = self.legs()
        return made[0] if len(made) == 1 else notched(union(made))

    def self_intersections(self):
        from ..self_intersection.places import Places

        return Places(())

    def outlines(self, poses):
        """The square that is looked at, in some poses: a (n, 4, 3) float array."""
        return (self.motion.posed(raised(self.region.size / 2 * SQUARE), poses),)


class OverTheWay(AnyField):
    """The field of a region over x, y and the way, flat at both ends: a formula, over the slope that it has at most.

    Parameters
    ----------
    region : Region
    total : float
        The length of the way in metres.
    leg : (2,) float array, optional
        From where to where on it; what comes back may go on beyond its end.
    """

    stretch = 1.0  # how much farther the way leads at most where this is bent

    def __init__(self, region, total, leg=None):
        self.region, self.total = region, total
        self.low, self.high = (0.0, total) if leg is None else leg
        self.step = DIFFERENCE * max(region.size, total)
        side, way = np.linspace(-region.size / 2, region.size / 2, SLOPED), np.linspace(0.0, total, SLOPED)
        values = region.evaluate(*np.meshgrid(side, side, way / total, indexing="ij"))
        slopes = np.gradient(values, side, side, way / self.stretch)
        self.steepest = ROOM * np.sqrt(sum(slope**2 for slope in slopes)).max()

    @property
    def box(self):
        half = self.region.size / 2
        return (-half, -half, self.low), (half, half, self.high)

    def over_the_way(self, points):
        """The x, y and way of points of this space, (n, 3)."""
        return points

    def formula(self, points):
        """The formula and how far points are beyond the ends: two (n,)."""
        x, y, s = points.T
        t = np.clip(s, self.low, self.high) / self.total
        return self.region.evaluate(x, y, np.where(t > 1, t - 1, t)), np.maximum(self.low - s, s - self.high)

    def evaluate(self, points, hints=None, reach=np.inf):
        inside, beyond = self.formula(points)
        return np.maximum(inside / self.steepest, beyond), np.empty((len(points), 0))

    def inside(self, points, hints=None):
        return np.maximum(*self.formula(points)) < 0

    def normals(self, points, hints=None):
        """Roughly the distances, by the slope there, and the normals of the formula or of the end."""
        inside, beyond = self.formula(points)
        sides = self.step * np.eye(3)
        slopes = np.stack([self.formula(points + d)[0] - self.formula(points - d)[0] for d in sides], axis=1)
        slopes /= 2 * self.step
        size = norms(slopes)
        inside = inside / np.maximum(size, self.steepest * FLAT)
        at_end = beyond >= inside
        ends = np.zeros_like(points)
        ends[:, 2] = np.where(points[:, 2] > (self.low + self.high) / 2, 1.0, -1.0)
        return (
            np.where(at_end, beyond, inside),
            np.where(at_end[:, None], ends, unit(slopes)),
            np.empty((len(points), 0)),
        )


class RoundTheWay(OverTheWay):
    """The field of a region over x, y and the angle round a ring, which is as long as the way at least.

    x leads away from the ring's axis, and y against it; the middle of the square is at the ring's radius.
    """

    def __init__(self, region, total):
        self.radius = max(total / (2 * np.pi), region.size)  # the whole square stays off the axis
        self.stretch = total / (2 * np.pi * (self.radius - region.size / 2))
        super().__init__(region, total)

    @property
    def box(self):
        half = self.region.size / 2
        high = np.array((self.radius + half, self.radius + half, half))
        return -high, high

    def over_the_way(self, points):
        part = np.arctan2(points[:, 1], points[:, 0]) / (2 * np.pi) % 1.0
        return np.stack((np.hypot(*points[:, :2].T) - self.radius, -points[:, 2], part * self.total), axis=1)

    def formula(self, points):
        """The formula, in the square that is looked at; no point is beyond an end."""
        x, y, s = self.over_the_way(points).T
        half = self.region.size / 2
        beyond = np.maximum(np.abs(x), np.abs(y)) - half
        value = self.region.evaluate(x.clip(-half, half), y.clip(-half, half), s / self.total)
        return np.where(beyond > 0, np.maximum(value, beyond * self.steepest), value), np.full(len(x), -np.inf)
