# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep of a surface: it stands at the start and at the end, and its boundary leaves the sides."""

from functools import cached_property

import numpy as np

from ..declared.parameters import ShapeError, require
from ..grids.grid import Grid
from ..meshes.booleans import union
from ..meshes.joining import joined
from ..meshes.polyhedron import polyhedron
from ..meshes.runs import backward
from ..rings.ends import Flat
from ..variation.legs import ends_of, notched


class Surface:
    """A surface with a boundary, in general motion.

    Parameters
    ----------
    shape : GeneralSweep
    generator : Mesh
        Its faces.
    """

    def __init__(self, shape, generator):
        self.shape, self.motion, self.generator = shape, shape.motion, generator
        wrong = len(generator.non_manifold_edges())
        require(not wrong, "must be a surface, of whose edges each has one face or two", wrong, "generator")

    @cached_property
    def stood(self):
        """Of each leg the poses in which it stands, and whether it comes back to the first."""
        points = self.generator.vertices
        return self.motion.standing(points, self.shape.samples, len(self.boundary[0]), 2 * len(points))

    @cached_property
    def boundary(self):
        """The vertices of its boundary, loop by loop as its faces run, and where each loop starts."""
        topology = self.generator.topology
        alone = np.bincount(topology.corner_edges, minlength=len(topology.edges))[topology.corner_edges] == 1
        start, end = topology.corners[alone], topology.corners[topology.following[alone]]
        if len(np.unique(start)) < len(start):
            raise ShapeError("must be a surface whose boundary touches itself nowhere", "generator")
        ahead = dict(zip(start.tolist(), end.tolist(), strict=True))
        loops = []
        while ahead:
            loop = [next(iter(ahead))]
            while (vertex := ahead.pop(loop[-1])) != loop[0]:
                loop.append(vertex)
            loops.append(loop)
        return np.concatenate(loops), np.cumsum([0, *map(len, loops)])

    def mesh(self, dtype=np.float64):
        made = self.legs(dtype)
        return made[0] if len(made) == 1 else notched(joined(made))

    def legs(self, dtype=np.float64):
        """The mesh of each leg."""
        ends = ends_of(self.shape, self.stood)
        return [self.leg(*stood, closing, dtype) for stood, closing in zip(self.stood, ends, strict=True)]

    def leg(self, poses, back, ends, dtype):
        """The mesh of what it leaves by some poses."""
        made = self.drawn(poses, back, ends, *self.boundary, self.generator.corners, dtype)
        if not len(made.boundary_edges()) and made.volume() < 0:
            return self.drawn(poses, back, ends, *self.turned_over, dtype)
        return made

    @property
    def turned_over(self):
        """Boundary, loops and corners of the faces as seen from behind."""
        (vertices, loops), offsets = self.boundary, self.generator.offsets
        return vertices[backward(loops)], loops, self.generator.corners[backward(offsets)]

    def drawn(self, poses, back, ends, vertices, loops, corners, dtype):
        """The mesh of a surface with that boundary and those corners of its faces."""
        columns = len(vertices)
        grid = Grid(len(poses.s), (), back, (), tuple(loops.tolist()), (), (None, None)).topology()
        sides = self.motion.posed(self.generator.vertices[vertices], poses).swapaxes(0, 1).reshape(-1, 3)
        parts, faces, sizes = [sides], [grid.corners], [np.diff(grid.offsets)]
        for station, end, run in ((0, ends[0], backward(self.generator.offsets)), (-1, ends[1], None)):
            if back or not isinstance(end, Flat):
                continue
            number = np.full(len(self.generator.vertices), -1)
            number[vertices] = np.arange(columns) * len(poses.s) + station % len(poses.s)
            inner = np.flatnonzero(number < 0)
            number[inner] = sum(map(len, parts)) + np.arange(len(inner))
            parts.append(self.motion.posed(self.generator.vertices, poses.only([station]))[0, inner])
            faces.append(number[corners if run is None else corners[run]])
            sizes.append(np.diff(self.generator.offsets))
        material = np.repeat((0, 1), (len(sizes[0]), sum(map(len, sizes[1:]))))
        offsets = np.concatenate(([0], np.cumsum(np.concatenate(sizes))))
        return polyhedron(np.concatenate(parts).astype(dtype), np.concatenate(faces), offsets, material, poses.told)

    def solid(self, progress=None):
        """The mesh, that of several legs united."""
        made = self.legs()
        if len(made) == 1 or len(made[0].boundary_edges()):
            return self.mesh()
        return notched(union(made))

    def self_intersections(self):
        from ..self_intersection.places import Places

        return Places(())

    def outlines(self, poses):
        """The loops of the boundary in some poses: a tuple of (n, k, 3) float arrays."""
        vertices, loops = self.boundary
        return tuple(np.split(self.motion.posed(self.generator.vertices[vertices], poses), loops[1:-1], axis=1))
