# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Manifold dual marching cubes: a vertex for each time the surface passes a cell, a face for each edge it crosses.

Source: Nielson: Dual marching cubes, IEEE Visualization 2004; where two neighbours' vertices would be joined by two
edges, the face between them is passed the other way, as in Wenger: Isosurfaces, 2013.
"""

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import ShapeError
from .band import CORNERS
from .cycles import EDGES, tables

RING = [0, 1, 3, 2]  # the cells around an edge in order: their places b + 2 c in each of which it is another edge


class TornError(ShapeError):
    """The zero of a field has gaps: it changes more quickly than it may, or jumps."""


@individual
class Dual:
    """The faces of a dual surface, and where each vertex may be.

    Parameters
    ----------
    cell : (v,) int array
        The cell of the band that each vertex is in.
    starts : (v, 3) float array
        A place for each vertex: the mean of the middles of the edges that its faces stand across, in metres.
    quads : (q, 4) int array
        The vertices of each face, counter-clockwise from outside.
    vertex, edge : (p,) int arrays
        Each vertex, and each edge of its cell that its faces stand across, 0 to 11.
    """

    cell: np.ndarray
    starts: np.ndarray
    quads: np.ndarray
    vertex: np.ndarray
    edge: np.ndarray


def dual_surface(band):
    """The dual surface of a band: closed, and manifold at every edge and vertex.

    Parameters
    ----------
    band : Band

    Returns
    -------
    Dual
    """
    cycle, count, _ = tables()
    turned = turned_faces(band)
    cycles = cycle[turned, band.inside]
    first = np.cumsum(count[turned, band.inside]) - count[turned, band.inside]
    cell, edge = np.nonzero(cycles >= 0)
    vertex = first[cell] + cycles[cell, edge]
    middles = (CORNERS[EDGES[:, 0]] + CORNERS[EDGES[:, 1]]) / 2
    total = int(count[turned, band.inside].sum())
    sums = [np.bincount(vertex, middles[edge, axis], total) for axis in range(3)]
    owner = np.repeat(np.arange(len(cycles)), count[turned, band.inside])
    within = np.stack(sums, axis=1) / np.bincount(vertex, minlength=total)[:, None]
    starts = band.low + band.step * (band.cells[owner] + within)
    return Dual(owner, starts, quads(band, cell, edge, vertex), vertex, edge)


def quads(band, cell, edge, vertex):
    """The faces of vertices (p,) of cells and edges (p,): four of each edge of the lattice."""
    start = band.cells[cell] + CORNERS[EDGES[edge, 0]]
    shape = band.cells.max(axis=0) + 2
    key = (((edge // 4 * shape[0] + start[:, 0]) * shape[1] + start[:, 1]) * shape[2] + start[:, 2]) * 4 + edge % 4
    order = np.argsort(key)
    full = (
        len(key) % 4 == 0 and (key[order] == np.repeat(key[order[::4]], 4) + np.tile(np.arange(4), len(key) // 4)).all()
    )
    if not full:
        raise TornError("A field must change by no more than the way: its zero has gaps")
    around = order.reshape(-1, 4)[:, RING]
    inside = band.inside[cell[around[:, 0]]] >> EDGES[edge[around[:, 0]], 0] & 1 == 1
    around[~inside] = around[~inside, ::-1]
    return vertex[around]


def turned_faces(band):
    """Which faces of each cell the surface passes the other way, as bits: (n,) int array.

    These are the faces that one cycle passes twice on either side. A cycle falls into two when such a face is turned;
    so the faces are asked one after the other, no two of which are of one cell, and none that was asked needs it again.
    """
    _, _, twice = tables()
    turned = np.zeros(len(band.cells), dtype=np.int64)
    cell, face = np.nonzero(twice[0, band.inside][:, None] >> np.arange(6) & 1)
    axis, side = face // 2, face % 2
    place = np.column_stack((axis, band.cells[cell] + side[:, None] * np.eye(3, dtype=int)[axis]))
    order = np.lexsort((side, *place.T))
    pairs = np.flatnonzero((place[order][1:] == place[order][:-1]).all(axis=1))
    above, below = cell[order[pairs]], cell[order[pairs + 1]]  # side 0 is the lower face of the cell above
    axis, parity = axis[order[pairs]], place[order[pairs], 1:][np.arange(len(pairs)), axis[order[pairs]]] % 2
    for group in range(6):
        one, other = (part[axis * 2 + parity == group] for part in (above, below))
        a = group // 2
        both = twice[turned[one], band.inside[one]] >> 2 * a & twice[turned[other], band.inside[other]] >> 2 * a + 1 & 1
        turned[one[both == 1]] |= 1 << 2 * a
        turned[other[both == 1]] |= 2 << 2 * a
    return turned
