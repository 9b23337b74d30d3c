# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pieces: what a sweep is taken apart into, each as a body that manifold3d unites."""

import numpy as np

from ..declared.frozen import individual
from ..meshes.booleans import body, hull_body
from .blocks import blocks, measured
from .legs import divided, of_leg
from .sides import across, halves


@individual
class Cut:
    """A face across a tube that is no face of the sweep.

    Parameters
    ----------
    number : int
        Of the face.
    ring : int
        Where it is.
    """

    number: int
    ring: int


class Pieces:
    """The bodies of the parts of `Rings` in a `Plan`, and the cuts between these and what is untouched.

    Parameters
    ----------
    rings : Rings
    plan : Plan
    fillings : Fillings
    """

    def __init__(self, rings, plan, fillings):
        self.rings, self.plan, self.fillings = rings, plan, fillings
        self.cuts, self.next_cut = [], len(rings.mesh.offsets) - 1

    def __len__(self):
        return len(self.plan.tubes) + sum(len(list(self.parts(*fold))) for fold in self.plan.folds)

    def __iter__(self):
        for tube in self.plan.tubes:
            yield [self.tube(*tube)]
        for fold in self.plan.folds:
            for made, *part in self.parts(*fold):
                yield made(*part)

    def parts(self, first, last):
        """What a stretch that folds is united from: of each a function that makes bodies, and what it takes."""
        legs = list(divided(self.rings, first, last))
        if legs:
            return [(of_leg, self.rings, *leg) for leg in legs]
        return [(self.hulls, *block) for block in self.blocks(first, last)]

    def tube(self, first, last):
        """The body of all between two rings."""
        rings, following = self.rings, self.rings.grid.following
        numbers = rings.vertices(np.arange(first, last + 1))
        local = np.arange(numbers.size).reshape(numbers.shape)
        pinched = (numbers[0] == numbers[-1]) if len(numbers) > 1 else np.full(last - first + 1, False)
        local[:, pinched] = local[0, pinched]
        low, high = local[:, :-1], local[:, 1:]
        quads = low, low[following], high[following], high
        triangles = np.stack([quads[i] for i in (0, 1, 2, 0, 2, 3)], axis=-1).reshape(-1, 3)
        faces = np.repeat(rings.faces_between(np.arange(first, last)).ravel(), 2)
        if pinched.any():
            whole = (triangles != triangles[:, [1, 2, 0]]).all(axis=1)
            triangles, faces = triangles[whole], faces[whole]
        parts = [(triangles, faces)]
        for ring, side in ((first, 0), (last, -1)):
            if not pinched[side]:
                across, numbered = self.across(ring, side)
                parts.append((local[across, side], numbered))
        triangles, faces = (np.concatenate(part) for part in zip(*parts, strict=True))
        return body(rings.mesh.vertices[numbers.ravel()], triangles, faces)

    def across(self, ring, side):
        """The triangles across a tube that ends at a ring, as columns, and the number of the face of each."""
        triangles, face = self.fillings.at(ring).faces
        triangles = triangles if side else triangles[:, ::-1]
        if not self.rings.closed and ring == (self.rings.segments if side else 0):
            return triangles, face + self.rings.sides + (self.rings.first_cap if side else 0)
        number = self.next_cut
        self.next_cut += 1
        segment = ring if side else ring - 1
        if self.plan.untouched[segment % self.rings.segments]:
            self.cuts.append(Cut(number, ring))
        return triangles, np.full(len(triangles), number)

    def blocks(self, first, last):
        """The blocks of a stretch that folds, a segment longer at both ends."""
        first, last = self.rings.longer(first, last)
        segments, _ = self.rings.placed(np.arange(first, last))
        turned = np.concatenate(([0.0], np.cumsum(measured(self.rings, segments))))
        return [(first + a, first + b) for a, b in blocks(turned, 0, last - first)]

    def hulls(self, first, last):
        """The bodies of a block: one for each convex part of the contour, or two where that slides on a line."""
        points = self.rings.mesh.vertices[self.rings.vertices(np.arange(first, last + 1))]
        parts = self.fillings.at((first + last) // 2).parts
        rings, _ = self.rings.placed(np.array([first, last]))
        sides = across(points, self.rings.normals[rings])
        if sides is None:
            return [hull_body(points[part].reshape(-1, 3)) for part in parts]
        return [hull_body(half) for part in parts for half in halves(points[part], sides[part])]
