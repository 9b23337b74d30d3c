# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep of a planar figure: a grid of its points by the places where it stands."""

from dataclasses import replace
from functools import cached_property

import numpy as np

from ..contours import Fit
from ..contours.section import section_of
from ..grids.chart import Chart, lengths_around
from ..grids.drawn import affine, drawn
from ..grids.grid import Grid
from ..meshes.joining import joined
from ..meshes.mesh import Mesh
from ..rings import caps
from ..trajectories.arc_length import arc_length
from ..variation.legs import NOTCHED, ends_of
from ..vectors import dot, norms, unit

MOST = 257  # places in which it is looked at which way a contour that is deformed runs
FLAT = 1e-9  # of the cube of its size
ROUNDING = 1e-9  # of the longest way in a step


class Planar:
    """A contour in general motion.

    Parameters
    ----------
    shape : GeneralSweep
    """

    def __init__(self, shape):
        self.shape, self.motion, self.section = shape, shape.motion, section_of(shape.generator, Fit.INSCRIBED)

    @cached_property
    def stood(self):
        """Of each leg the poses in which it stands, and whether it comes back to the first."""
        points = raised(self.section.points)
        return self.motion.standing(points, self.shape.samples, len(points))

    @cached_property
    def whole(self):
        """The poses in which it stands, once at each corner, and whether it comes back to the first."""
        points = raised(self.section.points)
        return self.motion.stands(points, self.shape.samples, len(points))

    def mesh(self, dtype=np.float64):
        return joined([replace(mesh, told=mesh.told + self.told) for mesh in self.legs(dtype)])

    def legs(self, dtype=np.float64):
        """The mesh of each leg."""
        for (poses, back), ends in zip(self.stood, ends_of(self.shape, self.stood), strict=True):
            yield self.leg(poses, back, ends, dtype)

    def leg(self, poses, back, ends, dtype=np.float64):
        """The mesh of the grid of its points by some poses."""
        section, across = self.section, (1, 1)
        if section.closed and self.runs_backward():
            section, across = section.mirrored, (-1, 1)  # the same points, the other way round
        grid = Grid(
            rings=len(poses.s),
            tips=(),
            closed=back,
            creases=(),
            offsets=tuple(section.offsets.tolist()),
            sharp=tuple(np.flatnonzero(section.sharp).tolist()),
            caps=caps.at_ends((section, section), ends, (back, back)),
            gaps=tuple(section.gaps.tolist()),
        )
        around, flat = lengths_around(section, np.ones(2)), (section.points, section.points)
        total = arc_length(self.motion.trajectory).total
        chart = Chart(grid, poses.u, poses.s, total, around, flat, self.shape.texture, self.shape.attributes)
        if self.motion.deforms:
            points = self.motion.posed(raised(section.points * across), poses)
            vertices = points.swapaxes(0, 1).reshape(-1, 3).astype(dtype)
        else:
            rings = np.stack((poses.origin, *poses.matrix[..., :2].transpose(2, 0, 1)))
            vertices = drawn(grid, affine(section.points * across), rings, dtype)
        return Mesh(vertices, grid.topology(), chart, poses.told)

    @property
    def told(self):
        """A sentence where its area passes no space, or nothing at corners."""
        if len(self.stood) > 1:
            return (NOTCHED,)
        flat = self.section.closed and np.abs(self.passed).sum() <= FLAT * self.section.size**3
        said = "Generator: it moves within its own plane, and sweeps no volume: turn it, or choose a frame."
        return (said,) if flat else ()

    def runs_backward(self):
        """Whether its area passes more space with its back ahead than with its front."""
        return bool(self.passed.sum() < 0)

    @cached_property
    def passed(self):
        """Roughly the space that its area passes in each step, negative where its back is ahead: (n - 1,)."""
        poses, _ = self.whole
        some = poses.thinned(MOST) if self.motion.deforms else poses
        if self.motion.deforms:
            points = self.motion.posed(raised(self.section.points), some)
            areas, middles = np.cross(points, points[:, self.section.following]).sum(axis=1) / 2, points.mean(axis=1)
        else:
            areas = np.cross(some.matrix[..., 0], some.matrix[..., 1])
            middles = some.origin + some.matrix[..., :2] @ self.section.centroid
            areas *= abs(self.section.area)
        return dot(areas[1:] + areas[:-1], np.diff(middles, axis=0)) / 2

    def folds(self):
        """The steps in which a part of the contour moves back against the rest, or all of it against its way before.

        Returns
        -------
        list of (int, int)
            The first and the last place of each stretch of such steps.
        """
        poses, back = self.whole
        if back:  # the last step leads to the first pose
            poses = poses.only(np.append(np.arange(len(poses.s)), 0))
        points = self.motion.posed(raised(self.section.points), poses)
        normals = unit(np.cross(poses.matrix[..., 0], poses.matrix[..., 1]))
        ways = np.diff(points, axis=0)
        rates = np.einsum("nmi,ni->nm", ways, normals[1:] + normals[:-1])
        rates *= -1 if self.runs_backward() else 1
        wrong = (rates < -ROUNDING * norms(ways).max(initial=0.0)).any(axis=1)
        wrong |= dot(normals[1:], normals[:-1]) < 0  # it was turned inside out
        edges = np.flatnonzero(np.diff(np.concatenate(([False], wrong, [False]))))
        return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))

    def self_intersections(self):
        from ..self_intersection.detect import meetings
        from ..self_intersection.folds import between
        from ..self_intersection.lattice import Lattice
        from ..self_intersection.places import Place, Places

        poses, _ = self.whole
        mesh = self.leg(*self.whole, (self.shape.start, self.shape.end))
        domain = self.motion.trajectory.domain
        places, folded, ends = [], [], np.append(poses.u, domain[1])
        for first, last in self.folds():
            a, b = (float(ends[which]) for which in (first, last))
            folded.append((a, b))
            said = f"from {between(a, b, domain)} a part of the contour moves back."
            places.append(Place("local", ((a, b),), tuple(poses.origin[(first + last) // 2].tolist()), said))
        normals = unit(np.cross(poses.matrix[..., 0], poses.matrix[..., 1]))
        normals *= -1 if self.runs_backward() else 1
        leaning = np.full(len(poses.s), True)
        lattice = Lattice.of_vertices(
            mesh.chart.grid, mesh.vertices, poses.origin, normals, poses.u, domain[1], leaning
        )
        return Places([*places, *meetings(lattice, folded)])

    def solid(self, progress=None):
        """The boundary of all that the area visits: a `Mesh`."""
        from ..resolving.legs import together
        from ..resolving.resolve import resolved

        if len(self.stood) > 1:
            return together(self.legs(), progress)
        return resolved(self.mesh(), progress, lambda: bool(self.self_intersections()))

    def outlines(self, poses):
        """The loops of the contour in some poses: a tuple of (n, k, 3) float arrays."""
        return tuple(
            np.split(self.motion.posed(raised(self.section.points), poses), self.section.offsets[1:-1], axis=1)
        )


def raised(points):
    """Points of the plane (m, 2) as points of the generator's space (m, 3)."""
    return np.column_stack((points, np.zeros(len(points))))
