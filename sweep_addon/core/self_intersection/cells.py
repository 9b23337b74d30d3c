# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells: which faces of a lattice cross each other, decided on their triangles.

Boxes of cells are joined two by two, in bands and in columns, up to stretches. Of pairs of stretches that may meet,
those parts are followed whose boxes do.
"""

from typing import NamedTuple

import numpy as np

from ..vectors import unit
from .lattice import BANDS, stretches

TOUCHING = 1e-9  # of the size: faces that come no farther through each other touch, and do not cross
MOST = 300_000  # pairs of boxes that are followed at once; many more are a broad overlap, of which some are enough
SPARSE = (256, 16, 1)  # every so many pairs of cells are looked at, until some cross
CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))  # of a cell: which column, its own or the next, and which ring
TRIANGLES = np.array(((0, 1, 2), (0, 2, 3)))  # their corners
NEXT = [1, 2, 0]  # corner of a triangle
BLOCK = 4096  # pairs that are looked at together, so that caches hold them


class Crossings(NamedTuple):
    """Points where edges of one cell go through another: the two cells' bands and columns, and where on the bands."""

    bands: np.ndarray  # (k, 2), the first no larger
    columns: np.ndarray  # (k, 2)
    points: np.ndarray  # (k, 3)


def any_cross(lattice, first, last):
    """Whether any of pairs of cells, (2, k) bands and columns twice, cross: where many do, a few show it."""
    return any(len(crossing(lattice, first[:, ::step], last[:, ::step]).bands) for step in SPARSE)


def crossing(lattice, first, last):
    """Those of pairs of cells, (2, k) bands and columns twice, that cross.

    Those of one band or of two neighbours are no matter of it: how they fold is told by the local test.
    """
    bands = last[0] - first[0]
    apart = (bands > 1) & ~(lattice.closed & (bands == lattice.bands - 1))
    first, last = first[:, apart], last[:, apart]
    quads, tolerance = corners(lattice, np.concatenate((first[0], last[0]))), TOUCHING * lattice.size
    some = (slice(start, start + BLOCK) for start in range(0, max(first.shape[1], 1), BLOCK))
    parts = [reaching(quads(first[:, part]), quads(last[:, part]), part.start, tolerance) for part in some]
    near, a, b = (np.concatenate(part, axis=-1) for part in zip(*parts, strict=True))
    which, points = triangles_cross(a, b, tolerance)
    return Crossings(*np.stack((first, last), axis=2)[:, near[which]], points.T)


def corners(lattice, bands):
    """A function from cells of some bands, (2, k) bands and columns, to their corners, (3, 4, k)."""
    used = np.unique(bands)
    row = np.zeros(lattice.bands, int)
    row[used] = np.arange(len(used))
    points = lattice.points(np.stack((used, used + 1), axis=1))  # column, band, ring, axis
    points = np.moveaxis(points, -1, 0).reshape(3, -1)

    def quads(cells):
        band, column = row[cells[0]], (cells[1], lattice.grid.following[cells[1]])
        numbers = [(column[beside] * len(used) + band) * 2 + up for beside, up in CORNERS]
        return points.take(np.stack(numbers), axis=1)

    return quads


def reaching(a, b, start, tolerance):
    """Those of pairs of cells, (3, 4, k) twice, that reach into the slabs of each other: their numbers, and both."""
    near = np.flatnonzero(reach_slabs(a, b, tolerance))
    a, b = a.take(near, axis=2), b.take(near, axis=2)
    nearer = np.flatnonzero(reach_slabs(b, a, tolerance))
    return start + near[nearer], a.take(nearer, axis=2), b.take(nearer, axis=2)


def candidates(lattice, pairs):
    """The cells of pairs of stretches whose boxes meet: their bands and columns, (2, k) twice."""
    used, which = np.unique(pairs, return_inverse=True)
    levels = pyramid(lattice, used)
    first, last = which.reshape(-1, 2).T
    start = stretches(lattice.bands, BANDS)[0][used]
    first, last = overlapping(*levels[-1], first, last)
    for above, below in zip(levels[::-1], levels[-2::-1], strict=False):
        first, last = split(first, last, above[0].shape[2:], below[0].shape[2:])
        first, last = apart(first, last, start, below[0].shape[2:])
        first, last = overlapping(*below, first, last)
    rows, columns = levels[0][0].shape[2:]
    first, last = (
        np.stack((start[box // (rows * columns)] + box // columns % rows, box % columns)) for box in (first, last)
    )
    return first, last


def apart(first, last, start, shape):
    """Those pairs of boxes, of so many rows and columns in each stretch, in which some bands are not next to others.

    A stretch also stands beside itself and its neighbours: most of its cells that are near each other fall out here.
    """
    size = BANDS // shape[0]
    band = np.repeat((start[:, None] + size * np.arange(shape[0])).ravel(), shape[1])
    kept = np.flatnonzero(band[last] - band[first] > 2 - size)
    return (first, last) if len(kept) == len(first) else (first[kept], last[kept])


def pyramid(lattice, used):
    """Boxes of cells, then of two by two of them, and so on to one a stretch: lows and highs (3, k, rows, columns)."""
    start, end = (part[used] for part in stretches(lattice.bands, BANDS))
    rings = np.minimum(start[:, None] + np.arange(BANDS + 1), end[:, None])
    points = lattice.points(rings).transpose(3, 1, 2, 0)  # axis, stretch, ring, column
    beside = points[..., lattice.grid.following]
    columns = points.shape[3]
    shape = (3, len(used), BANDS, 1 << int(np.ceil(np.log2(max(columns, 2)))))
    low, high = np.full(shape, np.inf), np.full(shape, -np.inf)
    for box, join in ((low, np.minimum), (high, np.maximum)):
        ring = join(points, beside)
        box[..., :columns] = join(ring[:, :, :-1], ring[:, :, 1:])
    none = np.arange(BANDS) >= (end - start)[:, None]
    low[:, none], high[:, none] = np.inf, -np.inf
    gaps = list(lattice.grid.gaps)
    low[..., gaps], high[..., gaps] = np.inf, -np.inf
    levels = [(low, high)]
    while low.shape[2] * low.shape[3] > 1:
        for axis in (2, 3):
            if low.shape[axis] > 1:
                even, odd = ((slice(None),) * axis + (slice(side, None, 2),) for side in (0, 1))
                low, high = np.minimum(low[even], low[odd]), np.maximum(high[even], high[odd])
        levels.append((low, high))
    return levels


def overlapping(low, high, first, last):
    """Those pairs of boxes, by their numbers, that meet: a few of very many."""
    low, high = low.reshape(3, -1), high.reshape(3, -1)
    for axis in range(3):
        meet = low[axis].take(first) <= high[axis].take(last)
        meet &= low[axis].take(last) <= high[axis].take(first)
        meet = np.flatnonzero(meet)
        first, last = first.take(meet), last.take(meet)
    step = -(-len(first) // MOST)
    return (first, last) if step < 2 else (first[::step], last[::step])


def split(first, last, above, below):
    """All pairs of the parts of pairs of boxes, by their numbers among so many rows and columns in each stretch."""
    rows, columns = below[0] // above[0], below[1] // above[1]
    part = (below[1] * np.arange(rows)[:, None] + np.arange(columns)).ravel()
    first, last = (box // above[1] * (rows * below[1]) + box % above[1] * columns for box in (first, last))
    count = len(part)
    return (first[:, None] + np.repeat(part, count)).ravel(), (last[:, None] + np.tile(part, count)).ravel()


def reach_slabs(cells, others, tolerance):
    """Whether cells (3, 4, k) reach farther than that into the slabs between two planes that hold others: (k,) bool."""
    normal = cross(others[:, 2] - others[:, 0], others[:, 3] - others[:, 1])
    own = inner(others[:, 1] - others[:, 0], normal)  # the diagonals lie in the two planes: those of 0 and 2, 1 and 3
    least = tolerance * np.sqrt(inner(normal, normal))
    over = inner(cells - others[:, :1], normal[:, None])
    return (over.min(axis=0) <= np.maximum(own, 0.0) - least) & (over.max(axis=0) >= np.minimum(own, 0.0) + least)


def triangles_cross(a, b, tolerance):
    """Where edges of the triangles of cells go through those of others, (3, 4, k) twice: (h,) int and (3, h) points.

    All are taken at once: where few are near each other, what each call of NumPy costs is most of it.
    """
    over_a, over_b = heights(a, b), heights(b, a)
    one, other, which = np.nonzero(reach_through(over_a, tolerance) & reach_through(over_b, tolerance).swapaxes(0, 1))
    a_side, b_side = (TRIANGLES[side].T for side in (one, other))
    a, b = (part.reshape(3, -1).take(side * part.shape[2] + which, axis=1) for part, side in ((a, a_side), (b, b_side)))
    found = (
        pierced(a, over_a[other, a_side, which], b, tolerance),
        pierced(b, over_b[one, b_side, which], a, tolerance),
    )
    through, points = (np.concatenate(part, axis=-1) for part in zip(*found, strict=True))
    return which[through], points


def heights(points, cells):
    """How far points (3, 4, k) are over the planes of both triangles of cells: (2, 4, k); 0 over one without area."""
    aside = cells[:, 1:] - cells[:, :1]
    normal = cross(aside[:, :2], aside[:, 1:])
    size = np.sqrt(inner(normal, normal))
    normal = np.divide(normal, size, out=np.zeros_like(normal), where=size > 0)
    return inner((points - cells[:, :1])[:, None], normal[:, :, None])


def reach_through(over, tolerance):
    """Whether triangles have corners on both sides of planes that their cells are so far over: (own, plane, k) bool."""
    over = over[:, TRIANGLES]
    return ((over.min(axis=2) < -tolerance) & (over.max(axis=2) > tolerance)).swapaxes(0, 1)


def pierced(edges, over, triangles, tolerance):
    """Which triangles the edges of others go through, both (3, 3, k), and where: (h,) int and (3, h).

    The corners of the others are so far over their planes, (3, k).
    """
    over_end = over[NEXT]
    through = (np.minimum(over, over_end) < -tolerance) & (np.maximum(over, over_end) > tolerance)
    edge, which = np.nonzero(through)
    count = edges.shape[2]
    edges, begin, end = edges.reshape(3, -1), edge * count + which, (edge + 1) % 3 * count + which
    start = edges.take(begin, axis=1)
    way = edges.take(end, axis=1) - start
    inside = np.concatenate([between_sides(*some) for some in blocks(start, way, triangles, which)])
    edge, which, start, way = edge[inside], which[inside], start[:, inside], way[:, inside]
    share = over[edge, which] / (over[edge, which] - over_end[edge, which])
    return which, start + share * way


def blocks(start, way, triangles, which):
    """Edges (3, m) and the triangles (3, 3, m) that they may go through, some at a time."""
    corners = triangles.shape[2] * np.arange(3)[:, None]
    for first in range(0, max(len(which), 1), BLOCK):
        some = slice(first, first + BLOCK)
        yield start[:, some], way[:, some], triangles.reshape(3, -1).take(corners + which[some], axis=1)


def between_sides(start, way, triangles):
    """Whether edges (3, m), which end beyond the planes of triangles (3, 3, m), pass all sides alike: (m,) bool."""
    towards = triangles - start[:, None]
    sides = [inner(cross(way, towards[:, corner]), towards[:, after]) for corner, after in enumerate(NEXT)]
    low, high = np.minimum.reduce(sides), np.maximum.reduce(sides)
    return ((low >= 0) & (high > 0)) | ((high <= 0) & (low < 0))


def inner(a, b):
    """The products of vectors with one another, (3, ...) twice to (...)."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    """The vectors across others, (3, ...) twice: many times faster than `numpy.cross` on few."""
    return np.stack([a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))])


def through_face(lattice, ring, bands):
    """Which of some bands go through the flat face at a ring: their numbers and columns, (k,), and where, (k, 3).

    An edge of a face, along the sweep or round a contour, goes through where its ends are on both sides of the plane,
    and the point between them is inside the outline. Where the rim goes through a band, triangles have told.
    """
    corners, normal = lattice.points(np.array(ring)), lattice.normals[ring]
    x = unit(corners[:1] - lattice.path[ring])[0]
    plane = np.stack((x, np.cross(normal, x)), axis=1)
    start, along = lattice.points(bands), lattice.points(bands + 1)
    ends = np.stack((along, start[lattice.grid.following]))
    over, over_end = ((part - corners[0]) @ normal for part in (start, ends))
    tolerance = TOUCHING * lattice.size
    through = (np.minimum(over, over_end) < -tolerance) & (np.maximum(over, over_end) > tolerance)
    through[1, list(lattice.grid.gaps)] = False
    kind, column, band = np.nonzero(through)
    share = over[column, band] / (over[column, band] - over_end[kind, column, band])
    point = start[column, band] + share[:, None] * (ends[kind, column, band] - start[column, band])
    within = inside((point - corners[0]) @ plane, (corners - corners[0]) @ plane, lattice.grid.following)
    return bands[band[within]], column[within], point[within]


def inside(points, outline, following):
    """Whether points (k, 2) are inside an outline (m, 2) by the even-odd rule: (k,) bool."""
    (x, y), (x0, y0), (x1, y1) = points.T[..., None], outline.T, outline[following].T
    spans = (y0 > y) != (y1 > y)
    rise = np.where(y1 == y0, 1.0, y1 - y0)
    return (spans & (x < x0 + (y - y0) / rise * (x1 - x0))).sum(axis=1) % 2 == 1
