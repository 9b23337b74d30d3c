# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep of a region: the surface of a formula over plane and way, put where the region stands."""

import numpy as np

from ..offsets.any_field import AnyField
from ..offsets.level_set import level_set
from ..parameters import require
from ..polyhedron import polyhedron
from ..trajectories.arc_length import arc_length
from ..vectors import norms, unit
from .planar import raised

QUICK = 160  # cells of what is made in a tenth of a second or two
SLOPED = 33  # places along each side where it is looked at how steep the formula is
ROOM = 1.25  # for what is steeper between them
DIFFERENCE = 1e-6  # of the size: over which slopes are taken
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

    def mesh(self, dtype=np.float64):
        half, total = self.region.size / 2, self.total
        step = max(self.region.size, total) / self.shape.cells
        found = level_set(OverTheWay(self.region, total), (-half, -half, 0.0), (half, half, total), step)
        require(found is not None, "must be so many that a part of the region holds one", self.shape.cells, "cells")
        made = polyhedron(self.placed(found.vertices.places).astype(dtype), found.triangles)
        return made if made.volume() > 0 else polyhedron(made.vertices, found.triangles[:, ::-1])  # it ran backward

    def placed(self, points):
        """Points of x, y and the way (n, 3) where the motion takes them: (n, 3)."""
        s, which = np.unique(np.append(0.0, points[:, 2].clip(0.0, self.total)), return_inverse=True)
        poses = self.motion.at(s).only(which.ravel()[1:])
        return self.motion.each(raised(points[:, :2]), poses)

    @property
    def is_solid(self):
        """Whether it takes long."""
        return self.shape.cells > QUICK

    def solid(self, progress=None):
        """The mesh."""
        return self.mesh()

    def self_intersections(self):
        from ..self_intersection.places import Places

        return Places(())

    def outlines(self, poses):
        """The square that is looked at, in some poses: a (n, 4, 3) float array."""
        half = self.region.size / 2
        return (self.motion.posed(raised(half * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])), poses),)


class OverTheWay(AnyField):
    """The field of a region over x, y and the way, flat at both ends: a formula, over the slope that it has at most.

    Parameters
    ----------
    region : Region
    total : float
        The length of the way in metres.
    """

    def __init__(self, region, total):
        self.region, self.total = region, total
        self.step = DIFFERENCE * max(region.size, total)
        side, way = np.linspace(-region.size / 2, region.size / 2, SLOPED), np.linspace(0.0, total, SLOPED)
        values = region.evaluate(*np.meshgrid(side, side, way / total, indexing="ij"))
        self.steepest = ROOM * np.sqrt(sum(slope**2 for slope in np.gradient(values, side, side, way))).max()

    def formula(self, points):
        """The formula and how far points are beyond the ends: two (n,)."""
        x, y, s = points.T
        return self.region.evaluate(x, y, np.clip(s / self.total, 0.0, 1.0)), np.maximum(-s, s - self.total)

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
        ends[:, 2] = np.where(points[:, 2] > self.total / 2, 1.0, -1.0)
        return (
            np.where(at_end, beyond, inside),
            np.where(at_end[:, None], ends, unit(slopes)),
            np.empty((len(points), 0)),
        )
