# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is left of a block, as a closed surface: its top at the places of a lattice, its sides and its bottom.

Where the block is cut through there is no surface. At the edge of such a hole top and bottom meet in the same vertices;
two parts that touch in nothing but an edge or a corner there have vertices of their own, so that each is a solid; where
they hang together at both ends of such an edge, its middle is two vertices.
"""

from dataclasses import dataclass

import numpy as np

from ..declared.parameters import ShapeError
from ..meshes.polyhedron import polyhedron

THIN = 1e-9  # of the height of the block: what is no thicker is nothing
CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))  # of a cell, counter-clockwise from above


@dataclass
class Remains:
    """The vertices and faces of what is left, and the place of the lattice that each vertex is at."""

    vertices: np.ndarray
    corners: np.ndarray
    offsets: np.ndarray
    place: np.ndarray
    on_top: np.ndarray

    def mesh(self, told=()):
        return polyhedron(self.vertices, self.corners, self.offsets, told=told)


def remains(lattice, heights, bottom, top):
    """The solid below heights and above the bottom of a block.

    Parameters
    ----------
    lattice : Lattice
    heights : (n, m) float array
        In metres; what is below the bottom counts as there, what is above the top too.
    bottom, top : float

    Returns
    -------
    Remains

    Raises
    ------
    ShapeError
        Where nothing is left.

    Examples
    --------
    >>> from sweep_addon.core.machining.lattice import Lattice
    >>> lattice = Lattice.across((0.0, 0.0), (2.0, 2.0), 1.0)
    >>> mesh = remains(lattice, np.full(lattice.size, 3.0), 0.0, 3.0).mesh()
    >>> round(mesh.volume(), 12), mesh.euler_characteristic(), len(mesh.boundary_edges())
    (12.0, 2, 0)
    """
    heights = np.clip(heights, bottom, top)
    solid = heights > bottom + THIN * (top - bottom)
    around = [solid[i : solid.shape[0] - 1 + i, j : solid.shape[1] - 1 + j] for i, j in CORNERS]
    kept = around[0] | around[1] | around[2] | around[3]
    if not kept.any():
        raise ShapeError("must leave something of the stock, all of which is cut away", "program")
    names = Names(solid, kept)
    upper, lower = names.of_cells()
    faces = list(walls(names, kept, upper, lower))
    if solid.all():
        ring = edge_ring(solid.shape)
        faces += [(4, upper), (len(ring), names.lower[ring][None, ::-1])]
    else:
        faces += split(upper, names.middles) + [(n, some[:, ::-1]) for n, some in split(lower, names.middles)]
    return assembled(lattice, heights, bottom, names, faces)


def split(corners, middles):
    """Faces of four corners, and with the middles of some of their edges, by their number of corners."""
    more = (middles >= 0).any(axis=1)
    found = [(4, corners[~more])]
    rings = np.stack((corners[more], middles[more]), axis=2).reshape(-1, 8)
    sizes = (rings >= 0).sum(axis=1)
    return found + [(int(n), rings[sizes == n][rings[sizes == n] >= 0].reshape(-1, n)) for n in np.unique(sizes)]


class Names:
    """The number of the vertex of each corner of each cell, above and below; one where the solid has no height."""

    def __init__(self, solid, kept):
        self.solid, self.shape = solid.ravel(), solid.shape
        self.cells = np.flatnonzero(kept.ravel())
        self.upper = np.where(self.solid, np.cumsum(self.solid) - 1, -1)
        count = int(self.solid.sum())
        below = self.solid if not self.solid.all() else np.zeros(0, dtype=bool)
        if not len(below):  # the bottom is one face, of the places on the edge
            below = np.zeros(len(self.solid), dtype=bool)
            below[edge_ring(self.shape)] = True
        self.lower = np.where(below, count + np.cumsum(below) - 1, -1)
        self.above, self.below = np.flatnonzero(self.solid), np.flatnonzero(below)
        self.sides = sides_of(solid, kept)
        self.halved = np.zeros((0, 2), dtype=np.int64)  # edges that have middles

    def of_cells(self):
        """The vertices of the corners of each kept cell, above and below, (c, 4) each."""
        x, y = np.divmod(self.cells, self.shape[1] - 1)
        places = np.stack([(x + i) * self.shape[1] + y + j for i, j in CORNERS], axis=1)
        keys = np.stack([places[:, k] * 4 + self.sides[k].ravel()[places[:, k]] for k in range(4)], axis=1)
        closed = ~self.solid[places]
        found, which = np.unique(keys[closed], return_inverse=True)
        self.pinched = found // 4
        number = len(self.above) + len(self.below) + which.ravel()
        upper, lower = self.upper[places], self.lower[places]
        upper[closed] = lower[closed] = number
        self.middles = np.full(upper.shape, -1)
        if len(found):
            self.part_edges(places, closed, upper)
        return upper, lower

    def part_edges(self, places, closed, upper):
        """Give two cells that meet in an edge without height, and hang together at both its ends, a middle each."""
        ends = np.stack((upper, np.roll(upper, -1, axis=1)), axis=2)
        cell, side = np.nonzero(closed & np.roll(closed, -1, axis=1))
        pairs = np.sort(ends[cell, side], axis=1)
        _, which, counts = np.unique(pairs[:, 0] * ends.max() + pairs[:, 1], return_inverse=True, return_counts=True)
        shared = counts[which.ravel()] > 1
        cell, side = cell[shared], side[shared]
        self.middles[cell, side] = len(self.above) + len(self.below) + len(self.pinched) + np.arange(len(cell))
        self.halved = np.stack((places[cell, side], places[cell, (side + 1) % 4]), axis=1)


def sides_of(solid, kept):
    """Of the four cells around each place, by the corner that they have there, which hang together: four arrays.

    Two neighbours do where the edge between them has a height. Cells at a place without height that hang together in
    no way there touch in an edge or corner alone.
    """
    padded = np.zeros((solid.shape[0] + 1, solid.shape[1] + 1), dtype=bool)
    padded[1:-1, 1:-1] = kept
    around = [padded[1 - i : padded.shape[0] - i, 1 - j : padded.shape[1] - j] for i, j in CORNERS]
    wide = np.zeros((solid.shape[0] + 2, solid.shape[1] + 2), dtype=bool)
    wide[1:-1, 1:-1] = solid
    north, west, south, east = wide[1:-1, 2:], wide[:-2, 1:-1], wide[1:-1, :-2], wide[2:, 1:-1]
    label = [np.zeros(solid.shape, dtype=np.int64)]
    for k, between in enumerate((north, west, south), 1):
        joined = between & around[k - 1] & around[k]
        label.append(np.where(joined, label[-1], k))
    round_again = east & around[3] & around[0]
    return [np.where(round_again & (each == label[3]), 0, each) for each in label]


def edge_ring(shape):
    """The places on the edge of a lattice, counter-clockwise from above."""
    number = np.arange(shape[0] * shape[1]).reshape(shape)
    return np.concatenate((number[:-1, 0], number[-1, :-1], number[:0:-1, -1], number[0, :0:-1]))


def walls(names, kept, upper, lower):
    """The faces of the sides: of four corners, or three where one end has no height."""
    cell = np.full(kept.size, -1)
    cell[names.cells] = np.arange(len(names.cells))
    cell = cell.reshape(kept.shape)
    sides = ((cell[:, 0], 0, 1), (cell[-1, :], 1, 2), (cell[:, -1], 2, 3), (cell[0, :], 3, 0))
    found = []
    for cells, a, b in sides:
        cells = cells[cells >= 0]
        found.append(np.stack((lower[cells, a], lower[cells, b], upper[cells, b], upper[cells, a]), axis=1))
    found = np.concatenate(found)
    begins, ends = found[:, 0] != found[:, 3], found[:, 1] != found[:, 2]
    yield 4, found[begins & ends]
    yield 3, found[begins & ~ends][:, [0, 1, 3]]
    yield 3, found[~begins & ends][:, [0, 1, 2]]


def assembled(lattice, heights, bottom, names, faces):
    place = np.concatenate((names.above, names.below, names.pinched, names.halved[:, 0]))
    x, y = np.divmod(place, lattice.size[1])
    on_top = np.arange(len(place)) < len(names.above)
    z = np.where(on_top, heights.ravel()[place], bottom)
    vertices = np.stack((lattice.along(0)[x], lattice.along(1)[y], z), axis=1)
    if len(names.halved):
        x, y = np.divmod(names.halved, lattice.size[1])
        vertices[-len(x) :, :2] = np.stack((lattice.along(0)[x].mean(axis=1), lattice.along(1)[y].mean(axis=1)), axis=1)
    sizes = np.concatenate([np.full(len(some), size) for size, some in faces])
    corners = np.concatenate([some.ravel() for _, some in faces])
    return Remains(vertices, corners, np.concatenate(([0], np.cumsum(sizes))), place, on_top)
