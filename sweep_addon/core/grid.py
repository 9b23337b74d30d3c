# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The grid that a contour leaves behind: faces and edges of columns and rings, known without a search.

Columns follow the points of the section along the trajectory, rings go round at each station. Vertices lie column by
column, so that all of them come from one matrix product of the section with the axes of the stations. A ring that
has shrunk to nothing is one vertex, a tip, behind all the others.
"""

from dataclasses import replace
from functools import cached_property
from hashlib import blake2b

import numpy as np

from .frozen import frozen
from .kept import kept
from .mesh import Topology
from .runs import backward, following

SIDE, CAP = 0, 1  # material slots


@frozen
class Grid:
    """What decides the topology of a sweep; equal grids share their arrays.

    Parameters
    ----------
    rings : int
        Number of stations.
    tips : tuple of int
        The stations where the contour has shrunk to a point.
    closed : bool
        Whether the last ring leads to the first.
    creases : tuple of int
        The stations where the surface has an edge all round, as at a mitre.
    offsets : tuple of int
        Where each loop of the section starts, and their end.
    sharp : tuple of int
        The columns that are edges.
    caps : tuple of two ((tuple of int, tuple of int) or None)
        The faces that close the start and the end: point numbers of the section, and where each face starts.
    seam : tuple of int
        The column of the first ring that each column of the last one leads to; empty where each leads to itself.
    domes : tuple of two int
        How many of the rings close the start and the end as a cap does.
    """

    rings: int
    tips: tuple
    closed: bool
    creases: tuple
    offsets: tuple
    sharp: tuple
    caps: tuple
    seam: tuple = ()
    domes: tuple = (0, 0)

    @property
    def columns(self):
        return self.offsets[-1]

    @cached_property
    def whole(self):
        """The stations whose ring is a ring."""
        whole = np.full(self.rings, True)
        whole[list(self.tips)] = False
        return np.flatnonzero(whole)

    @cached_property
    def following(self):
        return following(np.array(self.offsets))

    def bands(self):
        """Pairs of neighbouring stations (b, 2), and which bands have a tip below and above."""
        start = np.arange(self.rings if self.closed else self.rings - 1)
        pairs = np.stack((start, (start + 1) % self.rings), axis=1)
        tip = np.full(self.rings, False)
        tip[list(self.tips)] = True
        pinched = tip[pairs]
        return pairs, pinched[:, 0], pinched[:, 1]

    def topology(self):
        """The faces and edges, made once for equal grids."""
        return build(self)


@kept
def build(grid):
    if grid.seam:
        return led_aside(build(replace(grid, seam=())), grid)
    columns, rings, pairs = grid.columns, len(grid.whole), grid.bands()[0]
    stride, position = places(grid)
    low, high, whole = *pairs.T, grid.whole
    along = (len(pairs), [(stride[end], 0, position[end]) for end in (low, high)])
    around = (rings, [(stride[whole], 0, position[whole]), (0, stride[whole], position[whole])])
    points, used = zip(*side_faces(grid, stride, position), strict=True)
    caps, inner = cap_faces(grid, stride, position)
    offsets = face_offsets(grid, points, [sizes for *_, sizes in caps])
    material = np.full(len(offsets) - 1, CAP, np.int32)
    material[: columns * len(pairs)] = side_material(grid)
    return Topology(
        corners=laid(grid, points, *(corners for corners, *_ in caps)),
        offsets=offsets,
        edges=laid(grid, (along, around), inner.ravel()).reshape(-1, 2),
        corner_edges=laid(grid, used, *(edges for _, edges, _ in caps)),
        sharp=sharp_edges(grid, len(pairs), len(inner)),
        material=material,
        name=short_text(grid),
    )


def short_text(value):
    """A few digits that differ where values differ."""
    return blake2b(repr(value).encode(), digest_size=8).hexdigest()


def places(grid):
    """Where the vertices of each station are: that of column c has the number c * stride + position; two (n,)."""
    rings, tips = len(grid.whole), list(grid.tips)
    stride, position = np.full(grid.rings, rings, np.int32), np.zeros(grid.rings, np.int32)
    position[grid.whole] = np.arange(rings)
    stride[tips], position[tips] = 0, grid.columns * rings + np.arange(len(tips))
    return stride, position


def laid(grid, blocks, *rest):
    """Blocks of numbers, each laid column by column, and the rest, in one int32 array.

    Parameters
    ----------
    grid : Grid
    blocks : sequence of (count, terms)
        Of each column there are count rows of one number for each term (own, ahead, fixed), int or (count,) int array:
        column * own + following * ahead + fixed.
    *rest : int arrays

    All rows are one array times the column, and only the last column of each loop is not followed by the next one.
    """
    column, following = np.arange(grid.columns, dtype=np.int32), grid.following.astype(np.int32)
    last = np.flatnonzero(following != column + 1)
    sizes = [grid.columns * count * len(terms) for count, terms in blocks]
    numbers = np.empty(sum(sizes) + sum(map(len, rest)), np.int32)
    *parts, end = np.split(numbers, np.cumsum(sizes))
    for part, (count, terms) in zip(parts, blocks, strict=True):
        part = part.reshape(grid.columns, count, len(terms))
        own, ahead, fixed = np.empty((3, count, len(terms)), np.int32)
        for i, term in enumerate(terms):
            own[:, i], ahead[:, i], fixed[:, i] = term
        lay(column, own + ahead, fixed + ahead, part)
        part[last] += (following - column - 1)[last, None, None] * ahead
    end[:] = np.concatenate((end[:0], *rest))
    return numbers


def lay(column, step, start, out):
    """column * step + start of one column after the other, in one pass over the memory where all steps are one."""
    first = step[:1, :1]
    if (step == first).all():
        np.add(column[:, None, None] * first, start, out=out)
    else:
        np.multiply(column[:, None, None], step, out=out)
        out += start


def face_offsets(grid, blocks, sizes):
    """Where each face starts: evenly in a block, whose faces are of one size, then by the sizes of the others."""
    parts, start = [], 0
    for count, terms in blocks:
        end = start + grid.columns * count * len(terms)
        parts.append(np.arange(start, end, len(terms), dtype=np.int32))
        start = end
    reached = np.cumsum(np.concatenate(([start], *sizes)), dtype=np.int32)
    return np.concatenate((*parts, reached))


def side_faces(grid, stride, position):
    """Blocks of the faces between rings: the vertices at their corners, and the edges that start there."""
    pairs, below, above = grid.bands()
    bands, rings = len(pairs), len(grid.whole)
    ring = np.full(grid.rings, -1)
    ring[grid.whole] = np.arange(rings)

    def blocks(chosen, *corners):
        """Corners given as (on its own column or the next, on which end of the band, the edge that starts there)."""
        ends = dict(zip(("low", "high"), pairs[chosen].T, strict=True))
        edges = {end: (rings, 0, grid.columns * bands + ring[station]) for end, station in ends.items()}
        edges |= {"up": (0, bands, chosen), "down": (bands, 0, chosen)}
        points, used = [], []
        for column, end, edge in corners:
            steps, place = stride[ends[end]], position[ends[end]]
            points.append((steps, 0, place) if column == "own" else (0, steps, place))
            used.append(edges[edge])
        return (len(chosen), points), (len(chosen), used)

    quads, cones, funnels = kinds(below, above)
    third, fourth = ("next", "high", "high"), ("own", "high", "down")
    yield blocks(quads, ("own", "low", "low"), ("next", "low", "up"), third, fourth)
    yield blocks(cones, ("own", "low", "low"), ("next", "low", "up"), fourth)
    yield blocks(funnels, ("own", "low", "up"), third, fourth)


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


def side_material(grid):
    """The material of the faces between rings: that of caps on a dome."""
    start, end = grid.domes
    if not start + end:
        return SIDE
    pairs, below, above = grid.bands()
    material = np.full(len(pairs), SIDE, np.int32)
    material[:start] = material[len(pairs) - end :] = CAP
    return np.concatenate([np.tile(material[bands], grid.columns) for bands in kinds(below, above)])


def cap_faces(grid, stride, position):
    """The faces at the ends, and the edges inside them."""
    faces, inner = [], [np.empty((0, 2), np.int32)]
    along, bands, rings = grid.following, len(grid.bands()[0]), len(grid.whole)
    first_inner = grid.columns * (bands + rings)
    for cap, station, turn in zip(grid.caps, (0, grid.rings - 1), (-1, 1), strict=True):
        if cap is None:
            continue
        points, offsets = (np.array(part) for part in cap)
        if turn < 0:  # the same faces seen from the other side
            points = points[backward(offsets)]
        ahead = points[following(offsets)]
        rim = grid.columns * bands + (0 if station == 0 else rings - 1)
        used = rim + rings * np.where(along[points] == ahead, points, ahead)
        crossing = (along[points] != ahead) & (along[ahead] != points)
        ends = np.sort(np.stack((points, ahead), axis=1)[crossing], axis=1)
        unique, which = np.unique(ends, axis=0, return_inverse=True)
        used[crossing] = first_inner + sum(map(len, inner)) + which.ravel()
        inner.append((unique * stride[station] + position[station]).astype(np.int32))
        corners = (points * stride[station] + position[station]).astype(np.int32)
        faces.append((corners, used.astype(np.int32), np.diff(offsets)))
    return faces, np.concatenate(inner)


def sharp_edges(grid, bands, inner):
    """Edges along the corners of the contour, round the mitres and round the caps."""
    columns, rings = grid.columns, len(grid.whole)
    sharp = np.zeros(columns * (bands + rings) + inner, bool)
    sharp[: columns * bands].reshape(columns, bands)[list(grid.sharp)] = True
    rims = [station for station, cap in zip((0, grid.rings - 1), grid.caps, strict=True) if cap is not None]
    around = sharp[columns * bands : columns * (bands + rings)].reshape(columns, rings)
    around[:, np.isin(grid.whole, [*grid.creases, *rims])] = True
    return sharp
