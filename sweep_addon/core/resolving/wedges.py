# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Wedges: sectors of a tube as bodies that manifold3d unites, and whether what closes them came back whole.

A wedge is closed by walls from the middle of the contours to both rims of its strips, and by fans where the next
segment's strips are others. What is left out of the union does not come near anything. So a union of wedges that leaves
all walls and fans as they were has cut the surfaces just as one of the whole tubes would: what enters a tube beyond a
wedge has to pass through a wall.
"""

import numpy as np

from ..meshes.booleans import body


class Wedges:
    """The bodies of the sectors of the tubes of a plan.

    Parameters
    ----------
    rings : Rings
    plan : Plan
        Without folds.
    strips : (m, segments) bool array
        What `sectors` found.
    """

    def __init__(self, rings, plan, strips):
        self.rings, self.plan, self.strips = rings, plan, strips
        self.first_wall = len(rings.mesh.offsets) - 1
        self.first_fan = self.first_wall + 2 * strips.size
        self.closers = np.union1d(*(numbers for _, numbers in self.closing(0, rings.segments)))

    def __len__(self):
        return len(self.plan.tubes)

    def __iter__(self):
        for first, last in self.plan.tubes:
            yield [self.wedge(first, last)]

    def wedge(self, first, last):
        """The body of the sectors between two rings."""
        rings = self.rings
        numbers = rings.vertices(np.arange(first, last + 1))
        vertices = np.concatenate((rings.mesh.vertices, rings.centres))
        column, segment = np.nonzero(self.on(np.arange(first, last)))
        ahead = rings.grid.following[column]
        low, after = numbers[column, segment], numbers[ahead, segment]
        high, across = numbers[column, segment + 1], numbers[ahead, segment + 1]
        sides = np.stack((low, after, across, low, across, high), axis=1).reshape(-1, 3)
        faces = np.repeat(rings.faces_between(np.arange(first, last))[column, segment], 2)
        parts = [(sides, faces), *self.closing(first, last)]
        triangles, faces = (np.concatenate(part) for part in zip(*parts, strict=True))
        used = np.full(len(vertices), False)
        used[triangles] = True
        return body(vertices[used], (np.cumsum(used) - 1)[triangles], faces)

    def on(self, segments):
        """The strips of some segments, in the columns that these have there: (m, k) bool array."""
        places, around = self.rings.placed(segments)
        return self.strips[self.rings.columns(around), places]

    def closing(self, first, last):
        """The walls and the fans of the sectors between two rings: of both the triangles, and the number of each.

        The middles of rings are counted after the vertices of the mesh. A whole closed sweep ends nowhere.
        """
        rings, ahead = self.rings, self.rings.grid.following
        numbers, on = rings.vertices(np.arange(first, last + 1)), self.on(np.arange(first, last))
        place, around = rings.placed(np.arange(first, last + 1))
        own, middle = rings.columns(around), len(rings.mesh.vertices) + place

        behind = np.empty_like(on)
        behind[ahead] = on
        column, segment = np.nonzero(on != behind)
        low, high, begins = numbers[column, segment], numbers[column, segment + 1], on[column, segment]
        low, high = np.where(begins, low, high), np.where(begins, high, low)
        near, far = segment + ~begins, segment + begins
        walls = np.stack((low, high, middle[far], low, middle[far], middle[near]), axis=1).reshape(-1, 3)
        wall = self.first_wall + 2 * (own[column, segment] * rings.segments + place[segment])

        whole = rings.closed and last - first == rings.segments
        on = self.on(np.arange(first - 1, last + 1)) if whole else np.pad(on, ((0, 0), (1, 1)))
        column, ring = np.nonzero(on[:, 1:] != on[:, :-1])
        start, end, ends = numbers[column, ring], numbers[ahead[column], ring], on[column, ring]
        fans = np.stack((np.where(ends, start, end), np.where(ends, end, start), middle[ring]), axis=1)
        fan = self.first_fan + own[column, ring] * rings.grid.rings + place[ring]
        return (walls, np.stack((wall, wall + 1), axis=1).ravel()), (fans, fan)
