# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What fills a ring of a sweep: triangles, for a face across it, and convex parts, for hulls."""

from functools import cached_property

import numpy as np

from ..contours.section import Section
from ..declared.frozen import individual
from ..meshes.runs import following
from ..meshes.triangulate import triangulate
from ..rings import caps
from ..vectors import cross, norms, unit
from .convex_parts import convex_parts

ALIKE = 1e-6  # of a ring's radius: what two rings may differ by and be filled alike


def flat(aside, offsets):
    """A ring about its middle, (m, 3), as a section in its own plane."""
    normal = unit(cross(aside, aside[following(offsets)]).sum(axis=0))
    x = aside[norms(aside).argmax()]
    x = unit(x - (x @ normal) * normal)
    return Section(aside @ np.stack((x, cross(normal, x)), axis=1), offsets, np.zeros(len(aside), bool))


@individual
class Filling:
    """The triangles and convex parts of a section, as numbers of its points."""

    section: Section

    @cached_property
    def faces(self):
        """The triangles (t, 3), and the face of the section, as `caps` counts them, that each is a part of, (t,)."""
        points, offsets = map(np.array, caps.faces(self.section))
        found, face = [], []
        for number, (start, end) in enumerate(zip(offsets[:-1], offsets[1:], strict=True)):
            corners = points[start:end]
            some = corners[None] if len(corners) == 3 else triangulate(self.section.points, [corners])
            found.append(some)
            face.append(np.full(len(some), number))
        return np.concatenate(found), np.concatenate(face)

    @cached_property
    def parts(self):
        """List of int arrays: the points of each convex part."""
        if len(self.section.areas) == 1 and (self.section.turns >= 0).all():
            return [np.arange(len(self.section.points))]
        return convex_parts(self.section.points, self.faces[0])


class Fillings:
    """The filling of each ring of `Rings`: the same for all that are affine images of the widest."""

    def __init__(self, rings):
        self.rings = rings
        self.widest = int(rings.radii.argmax())
        self.usual = Filling(self.flat(self.widest))
        weights = np.column_stack((np.ones(rings.grid.columns), self.usual.section.points))
        self.weights, self.inverse = weights, np.linalg.pinv(weights)
        self.others = {}

    def flat(self, ring):
        """A ring of the grid as a section in its own plane."""
        return flat(self.rings.points[:, ring] - self.rings.centres[ring], np.array(self.rings.grid.offsets))

    def at(self, ring):
        """The filling of a ring, counted as the rings are."""
        (ring,), _ = self.rings.placed([ring])
        points = self.rings.points[:, ring]
        apart = norms(points - self.weights @ (self.inverse @ points)).max()
        if apart <= ALIKE * self.rings.radii[ring]:
            return self.usual
        if ring not in self.others:
            self.others[ring] = Filling(self.flat(ring))
        return self.others[ring]
