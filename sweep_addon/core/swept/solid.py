# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep of a solid: the boundary of the set of all points that it visits, from its signed distance."""

from functools import cached_property

import numpy as np

from ..declared.parameters import ShapeError, require
from ..meshes.polyhedron import polyhedron
from ..meshes.runs import backward
from ..offsets.dual import TornError
from ..offsets.level_set import level_set
from ..trajectories.arc_length import arc_length
from ..variation.legs import legs, on_leg
from ..variation.motion import Poses
from ..vectors import norms
from .field import Field
from .visited import Visited

FEWEST, FEW, MOST = 33, 385, 8192  # poses, of few cells and of many
QUICK = 20  # cells of a sweep that is to be made at once
FLATTEST = 1e-9  # of the cube about it, or of the largest pose: less is no volume
ALONG = 9  # points along each side of the box around a solid that is deformed
CLOSE = 0.25  # of a cell: how far the solid moves at most from pose to pose
ASKED = 20  # points for each square of a cell across, as a rule
MARGIN = 1.05  # where there are more, the rest is said to be a part of what was done
FOLLOWED = 500  # vertices of the solid by which its extent is told


class Solid:
    """A closed mesh in general motion.

    Parameters
    ----------
    shape : GeneralSweep
    generator : Mesh
        Its surface, closed.
    """

    def __init__(self, shape, generator):
        self.shape, self.motion = shape, shape.motion
        wrong = len(generator.non_manifold_edges())
        require(not wrong, "must be closed and manifold, or a surface", f"{wrong} non-manifold edges", "generator")
        volume, size = generator.volume(), float(np.ptp(generator.vertices, axis=0).max())
        require(abs(volume) > FLATTEST * size**3, "must hold something", volume, "generator")
        self.generator = generator if volume > 0 else turned_over(generator)

    is_solid = True

    def mesh(self, dtype=np.float64, progress=None):
        poses, back, step = self.close
        corners = self.motion.posed(self.some, poses)
        room = step if self.motion.deforms else 0.0
        visited = Visited(Field.of(self.generator, step / 2), self.motion, poses, back)
        visited.told = progress and Told(progress, ASKED * self.shape.cells**2)
        try:
            found = level_set(visited, corners.min(axis=(0, 1)) - room, corners.max(axis=(0, 1)) + room, step)
        except TornError as torn:
            raise ShapeError("must be a body that neither crosses itself nor is pressed flat", "generator") from torn
        require(found is not None, "must be so many that a part of the sweep holds one", self.shape.cells, "cells")
        places = found.vertices.places.astype(dtype)
        return polyhedron(places, found.triangles, told=(*poses.told, said(found, visited, step)))

    def solid(self, progress=None):
        """The mesh, which tells what part of it is done."""
        return self.mesh(progress=progress)

    @cached_property
    def some(self):
        """Vertices of the solid by which its extent and its way are told: (k, 3) float array."""
        vertices = self.generator.vertices
        extreme = [vertices[:, axis].argsort()[[0, -1]] for axis in range(3)]
        spread = np.linspace(0, len(vertices) - 1, FOLLOWED).round().astype(int)
        found = vertices[np.unique(np.concatenate((*extreme, spread)))]
        if not self.motion.deforms:
            return found
        sides = np.linspace(vertices.min(axis=0), vertices.max(axis=0), ALONG).T  # what lies between bends too
        return np.concatenate((found, np.stack(np.meshgrid(*sides, indexing="ij"), axis=-1).reshape(-1, 3)))

    @cached_property
    def close(self):
        """Poses from which to the next the solid moves a part of a cell, whether it comes back, and the cell's side.

        At a corner where its frame turns it stands twice; then it does not come back on a way that leads there.
        """
        back = self.motion.comes_back(self.some)
        on_legs = legs(self.motion, back)
        back = back and not len(on_legs)
        poses = self.evenly(FEWEST, on_legs, back)
        for _ in range(2):  # of few poses the way is told roughly
            places = self.motion.posed(self.some, poses)
            step = float(np.ptp(places, axis=(0, 1)).max()) / self.shape.cells
            longest = norms(np.diff(places, axis=0))[np.diff(poses.s) != 0].max()
            most = MOST if self.shape.cells > QUICK else FEW
            count = int(np.clip(longest * (len(places) - 1) / (CLOSE * step), FEWEST, most)) + 1
            poses = self.evenly(count, on_legs, back)
        sizes = np.abs(np.linalg.det(poses.matrix))
        kept = sizes > FLATTEST * sizes.max()  # in a pose without a size it visits nothing more
        require(kept.any(), "must not be 0 everywhere", 0.0, "scale_x")
        return poses if kept.all() else poses.only(kept), back, step

    def evenly(self, count, on_legs, back):
        """Poses evenly spaced by arc length, two at each corner between legs; one that comes back stands there once."""
        total = arc_length(self.motion.trajectory).total
        if not len(on_legs):
            return self.motion.at(np.linspace(0.0, total, count, endpoint=not back))
        counts = np.ceil(count * np.ptp(on_legs, axis=1) / total).astype(int) + 1
        poses = [on_leg(self.motion, leg, np.linspace(*leg, some)) for leg, some in zip(on_legs, counts, strict=True)]
        together = (np.concatenate(part) for part in zip(*(some[:-1] for some in poses), strict=True))
        return Poses(*together, poses[0].told)

    def self_intersections(self):
        from ..self_intersection.places import Places

        return Places(())

    def outlines(self, poses):
        """The bottom and the top of the box around the solid in some poses: two (n, 4, 3) float arrays."""
        low, high = self.generator.vertices.min(axis=0), self.generator.vertices.max(axis=0)
        square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
        corners = [low + (high - low) * np.column_stack((square, np.full(4, side))) for side in (0, 1)]
        return tuple(self.motion.posed(loop, poses) for loop in corners)


def turned_over(mesh):
    """A mesh whose faces look the other way."""
    return polyhedron(mesh.vertices, mesh.corners[backward(mesh.offsets)], mesh.offsets)


def said(found, visited, step):
    """How near a surface is to the boundary of what is visited, for people."""
    off = visited.off(found.vertices).max()
    crossing = f"; {len(found.crossing)} pairs of faces cross" if len(found.crossing) else ""
    return f"Solid: cells of {step:.3g} m; vertices were found off by up to {off:.2g} m{crossing}."


class Told:
    """Tells which part is done of work whose points are known roughly: never more than all, nor less than before.

    Parameters
    ----------
    progress : callable
        Is told the part, from 0 to 1.
    expected : float
        How many points will be asked for.
    """

    def __init__(self, progress, expected):
        self.progress, self.expected, self.done, self.part = progress, expected, 0, 0.0

    def __call__(self, points):
        self.done += points
        self.part = max(self.part, self.done / max(self.expected, self.done * MARGIN))  # of equal ones rounding differs
        self.progress(self.part)
