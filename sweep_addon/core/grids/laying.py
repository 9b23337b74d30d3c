# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laying: the faces and edges of a grid as arrays, each column's made from the first one's by a sum."""

from dataclasses import replace
from functools import cached_property
from hashlib import blake2b

import numpy as np

from ..kept import kept
from ..meshes.mesh import Topology
from ..meshes.runs import backward, following

SIDE, CAP = 0, 1  # material slots
OWN, NEXT, STRIP = 0, 1, 2  # by which number of a strip something is counted: its column's, the next one's, its own
POLE, TO_POLE = (OWN, 1, 0), (NEXT, 1, 0)


class Layout:
    """Where the vertices and edges of a grid are in their arrays.

    Vertices lie line by line, then tips, then poles: that of line c at a station has the number c * stride + position.
    The edges along lines come first, line by line, then those round the rings, strip by strip, then those at the ends.
    """

    def __init__(self, grid):
        self.grid, self.rings = grid, len(grid.whole)
        self.pairs, self.below, self.above = grid.bands()
        self.bands, lines, tips = len(self.pairs), len(grid.lines), list(grid.tips)
        self.stride, self.position = np.full(grid.rings, self.rings, np.int32), np.zeros(grid.rings, np.int32)
        self.ring = np.full(grid.rings, -1)
        self.position[grid.whole] = self.ring[grid.whole] = np.arange(self.rings)
        self.stride[tips], self.position[tips] = 0, lines * self.rings + np.arange(len(tips))
        self.number = np.empty(grid.columns, np.int32)
        self.number[grid.lines] = np.arange(lines)
        self.number[list(grid.poles)] = lines * self.rings + len(tips) + np.arange(len(grid.poles))
        self.strip = np.full(grid.columns, -1)
        self.strip[np.concatenate(grid.strips)] = np.arange(sum(map(len, grid.strips)))
        self.around = lines * self.bands  # the first edge round a ring
        self.inner = self.around + self.rings * sum(map(len, grid.strips))  # the first edge at the ends

    @cached_property
    def strips(self):
        """The numbers of the strips of each kind by `OWN`, `NEXT` and `STRIP`: (3, k) int32 arrays."""
        return tuple(
            np.stack((self.number[start], self.number[self.grid.following[start]], self.strip[start])).astype(np.int32)
            for start in self.grid.strips
        )

    def vertices(self, columns, station):
        """The vertices of columns at a station."""
        pole = np.isin(columns, self.grid.poles)
        return np.where(
            pole, self.number[columns], self.number[columns] * self.stride[station] + self.position[station]
        )

    def edges(self):
        """Blocks of the ends of edges, along the lines and round the rings."""
        low, high, whole = *self.pairs.T, self.grid.whole
        lines = np.tile(np.arange(len(self.grid.lines), dtype=np.int32), (3, 1))
        own, ahead = ((by, self.stride[whole], self.position[whole]) for by in (OWN, NEXT))
        yield lines, self.bands, [(OWN, self.stride[end], self.position[end]) for end in (low, high)]
        ends = (own, ahead), (POLE, ahead), (own, TO_POLE)
        for strips, pair in zip(self.strips, ends, strict=True):
            yield strips, self.rings, pair

    def sides(self):
        """Blocks of the faces between rings: the vertices at their corners, and the edges that start there."""
        plain, from_pole, to_pole = self.strips
        everywhere = np.arange(self.bands)
        quads, cones, funnels = kinds(self.below, self.above)
        first, second, third, fourth = (OWN, 0, "low"), (NEXT, 0, "up"), (NEXT, 1, "high"), (OWN, 1, "down")
        yield self.faces(plain, quads, first, second, third, fourth)
        yield self.faces(plain, cones, first, second, fourth)
        yield self.faces(plain, funnels, (OWN, 0, "up"), third, fourth)
        yield self.faces(from_pole, everywhere, (POLE, "low"), second, third)
        yield self.faces(to_pole, everywhere, first, (TO_POLE, "high"), fourth)

    def faces(self, strips, bands, *corners):
        """A block of faces, of corners given as the column, the end of the band, and the edge that starts there.

        A corner at a pole is given as its term and the edge.
        """
        stations, round_rings = self.pairs[bands].T, self.around
        edges = {"up": (NEXT, self.bands, bands), "down": (OWN, self.bands, bands)}
        for end, station in zip(("low", "high"), stations, strict=True):
            edges[end] = (STRIP, self.rings, round_rings + self.ring[station])
        points, used = [], []
        for *place, edge in corners:
            if len(place) == 2:
                column, end = place
                points.append((column, self.stride[stations[end]], self.position[stations[end]]))
            else:
                points += place
            used.append(edges[edge])
        return (strips, len(bands), points), (strips, len(bands), used)

    def caps(self):
        """The faces at the ends, and the edges there that are not round a ring.

        Returns
        -------
        corners, used : (c,) int32 arrays
            The vertices at the corners of the faces, and the edges that start there.
        sizes : (f,) int array
        inner : (e, 2) int array
            The vertices of the edges inside the caps and, where both have one from pole to pole, between them.
        axis : (e,) bool array
            Which are of the latter kind.
        """
        corners, used, sizes, inside, ends, axis = [], [], [], [], [], []
        following = self.grid.following
        for cap, station, turn in zip(self.grid.caps, (0, self.grid.rings - 1), (-1, 1), strict=True):
            if cap is None:
                continue
            points, ahead, count = seen(cap, turn)
            forward = following[points] == ahead
            column = np.where(forward, points, ahead)
            rim = (forward | (following[ahead] == points)) & (self.strip[column] >= 0)
            here, there = self.vertices(points, station), self.vertices(ahead, station)
            corners.append(here)
            used.append(self.around + self.strip[column] * self.rings + self.ring[station])
            sizes.append(count)
            inside.append(~rim)
            ends.append(np.sort(np.stack((here, there), axis=1)[~rim], axis=1))
            axis.append((forward | (following[ahead] == points))[~rim])
        if not corners:
            return *(np.zeros(0, np.int32) for _ in range(3)), np.zeros((0, 2), np.int32), np.zeros(0, bool)
        inner, first, which = np.unique(np.concatenate(ends), axis=0, return_index=True, return_inverse=True)
        used = np.concatenate(used)
        used[np.concatenate(inside)] = self.inner + which.ravel()
        corners, sizes = np.concatenate(corners), np.concatenate(sizes)
        return corners.astype(np.int32), used.astype(np.int32), sizes, inner, np.concatenate(axis)[first]

    def sharp(self, axis):
        """Edges along the corners of the contour, round the mitres and round the caps, and on the axis between caps."""
        grid, first = self.grid, self.around
        sharp = np.zeros(self.inner + len(axis), bool)
        along = sharp[:first].reshape(len(grid.lines), self.bands)
        along[np.isin(grid.lines, grid.sharp)] = True
        for start, stop, columns in grid.smooth:
            along[np.isin(grid.lines, columns), start:stop] = False
        rims = [station for station, cap in zip((0, grid.rings - 1), grid.caps, strict=True) if cap is not None]
        around = sharp[first : self.inner].reshape(-1, self.rings)
        around[:, np.isin(grid.whole, [*grid.creases, *rims])] = True
        sharp[self.inner :] = axis
        return sharp


def seen(cap, turn):
    """The points at the corners of a cap's faces, the next ones, and the faces' sizes; from below turned round."""
    points, offsets = (np.array(part) for part in cap)
    points = points[backward(offsets)] if turn < 0 else points
    return points, points[following(offsets)], np.diff(offsets)


@kept
def build(grid):
    """The faces and edges of a grid, made once for equal ones."""
    if grid.seam:
        return led_aside(build(replace(grid, seam=())), grid)
    layout = Layout(grid)
    points, used = zip(*layout.sides(), strict=True)
    corners, edges, sizes, inner, axis = layout.caps()
    offsets, sides = face_offsets(points, sizes)
    material = np.full(len(offsets) - 1, CAP, np.int32)
    material[:sides] = side_material(layout)
    return Topology(
        corners=laid(points, corners),
        offsets=offsets,
        edges=laid(layout.edges(), inner.ravel()).reshape(-1, 2),
        corner_edges=laid(used, edges),
        sharp=layout.sharp(axis),
        material=material,
        name=short_text(grid),
    )


def short_text(value):
    """A few digits that differ where values differ."""
    return blake2b(repr(value).encode(), digest_size=8).hexdigest()


def laid(blocks, rest):
    """Blocks of numbers, each laid strip by strip, and the rest, in one int32 array.

    Parameters
    ----------
    blocks : sequence of (strips, count, terms)
        The numbers of the strips, (3, k), and for each there are count rows of one number for each term (by, step,
        fixed), int or (count,) int array: the number by which it is counted * step + fixed.
    rest : int array

    """
    blocks = list(blocks)
    sizes = [strips.shape[1] * count * len(terms) for strips, count, terms in blocks]
    numbers = np.empty(sum(sizes) + len(rest), np.int32)
    *parts, end = np.split(numbers, np.cumsum(sizes))
    for part, (strips, count, terms) in zip(parts, blocks, strict=True):
        if part.size:
            fill(part.reshape(-1, count, len(terms)), strips, terms)
    end[:] = rest
    return numbers


def fill(part, strips, terms):
    """Lay one block, (k, count, terms).

    The numbers of most strips differ by the same from each other: all rows are one array times the first of them, and
    only what is counted otherwise, as where a loop's last column is followed by its first, is put right. At a pole
    nothing is alike, and there are few.
    """
    if any(term is POLE or term is TO_POLE for term in terms):
        for i, (by, step, fixed) in enumerate(terms):
            part[:, :, i] = strips[by, :, None] * step + fixed
        return
    first = strips[terms[0][0]]
    aside = strips - first
    step, start = np.empty((2, *part.shape[1:]), np.int32)
    for i, (by, each, fixed) in enumerate(terms):
        step[:, i], start[:, i] = each, fixed + aside[by, 0] * each
    lay(first, step, start, part)
    for i, (by, *_) in enumerate(terms):
        others = np.flatnonzero(aside[by] != aside[by, 0])
        part[others, :, i] += (aside[by, others] - aside[by, 0])[:, None] * step[:, i]


def lay(numbers, step, start, out):
    """numbers * step + start, one after the other, in one pass over the memory where all steps are one."""
    first = step[:1, :1]
    if (step == first).all():
        np.add(numbers[:, None, None] * first, start, out=out)
    else:
        np.multiply(numbers[:, None, None], step, out=out)
        out += start


def face_offsets(blocks, sizes):
    """Where each face starts, evenly in a block, whose faces are of one size, and how many faces blocks have."""
    counts = [strips.shape[1] * count for strips, count, _ in blocks]
    corners = [len(terms) for *_, terms in blocks]
    ends = np.cumsum([0, *(count * size for count, size in zip(counts, corners, strict=True))]).tolist()
    parts = [np.arange(*span, size, dtype=np.int32) for *span, size in zip(ends[:-1], ends[1:], corners, strict=True)]
    reached = np.cumsum(np.concatenate(([ends[-1]], sizes)), dtype=np.int32)
    return np.concatenate((*parts, reached)), sum(counts)


def led_aside(topology, grid):
    """The topology with the last ring led to the columns of the first that the seam says, unless either is a tip."""
    pairs, below, above = grid.bands()
    if below[-1] or above[-1]:
        return topology
    columns, bands, rings = grid.columns, len(pairs), len(grid.whole)
    seam = np.array(grid.seam, np.int32)
    corners, edges, corner_edges = (part.copy() for part in (topology.corners, topology.edges, topology.corner_edges))
    quads = np.count_nonzero(~below & ~above)
    first, used = (part[: 4 * columns * quads].reshape(columns, quads, 4)[:, -1] for part in (corners, corner_edges))
    first[:, 2], first[:, 3] = seam[grid.following] * rings, seam * rings
    used[:, 2] = columns * bands + seam * rings
    edges[: columns * bands].reshape(columns, bands, 2)[:, -1, 1] = seam * rings
    joins = {"corners": corners, "edges": edges, "corner_edges": corner_edges}
    return replace(topology, **joins, seam=short_text(grid.seam))


def kinds(below, above):
    """The bands without a tip, those with one above, and those with one below, in the order of their faces."""
    return tuple(np.flatnonzero(chosen) for chosen in (~below & ~above, above & ~below, below & ~above))


def side_material(layout):
    """The material of the faces between rings: that of caps on a dome."""
    start, end = layout.grid.domes
    if not start + end:
        return SIDE
    material = np.full(layout.bands, SIDE, np.int32)
    material[:start] = material[layout.bands - end :] = CAP
    strips = len(layout.grid.strips[0])
    return np.concatenate([np.tile(material[bands], strips) for bands in kinds(layout.below, layout.above)])
