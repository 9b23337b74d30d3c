# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells: which faces of a lattice cross each other, decided on their triangles.

Boxes of cells are joined two by two, in bands and in columns, up to stretches. Of pairs of stretches that may meet,
those parts are followed whose boxes do.
"""

from typing import NamedTuple

import numpy as np

from ..vectors import unit
from .stretches import BANDS, stretches

TOUCHING = 1e-9  # of the size: faces that come no farther through each other touch, and do not cross
MOST = 300_000  # pairs of boxes that are followed at once; many more are a broad overlap, of which some are enough
SPARSE = (256, 16, 1)  # every so many pairs of cells are looked at, until some cross
CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))  # of a cell: which column, its own or the next, and which ring
TRIANGLES = np.array(((0, 1, 2), (0, 2, 3)))  # their corners
ALONE = np.array([0, 0, 1, 2, 2, 1, 0, 0])  # which corner is on a side by itself, by the sum of 1, 2, 4 of those below
TURNED = np.concatenate(TRIANGLES[:, (ALONE + np.arange(3)[:, None]) % 3], axis=1)  # its corners from that one on
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
    apart = np.flatnonzero((bands > 1) & ~(lattice.closed & (bands == lattice.bands - 1)))
    first, last = first.take(apart, axis=1), last.take(apart, axis=1)
    quads, tolerance = corners(lattice, np.concatenate((first[0], last[0]))), TOUCHING * lattice.size

    def near(some):
        """Those of some pairs, by their numbers, that reach into the slabs of each other."""
        a, b = quads(first[:, some]), quads(last[:, some])
        return some[reach_slabs(a, b, tolerance) & reach_slabs(b, a, tolerance)]

    def crossed(some):
        which, points = triangles_cross(quads(first[:, some]), quads(last[:, some]), tolerance)
        return some[which], points

    reaching = np.concatenate([near(some) for some in blocks(np.arange(len(first[0])))])
    which, points = (np.concatenate(part, axis=-1) for part in zip(*map(crossed, blocks(reaching)), strict=True))
    first, last = first[:, which], last[:, which]
    return Crossings(*(np.stack(pair, axis=1) for pair in zip(first, last, strict=True)), points.T)


def blocks(pairs):
    """Pairs (k,), some at a time."""
    return np.split(pairs, range(BLOCK, len(pairs), BLOCK))


def corners(lattice, bands):
    """A function from cells of some bands, (2, k) bands and columns, to their corners, (3, 4, k)."""
    used = np.full(len(lattice.u), False)
    used[bands] = used[bands + 1] = True
    row, count = np.cumsum(used) - 1, np.count_nonzero(used)
    points = np.moveaxis(lattice.points(np.flatnonzero(used)), -1, 0).reshape(3, -1)

    def quads(cells):
        rows, column = (row[cells[0]], row[cells[0] + 1]), (cells[1], lattice.grid.following[cells[1]])
        return points.take(np.stack([column[beside] * count + rows[up] for beside, up in CORNERS]), axis=1)

    return quads


def candidates(lattice, pairs):
    """The cells of pairs of stretches whose boxes meet: their bands and columns, (2, k) twice."""
    used, which = np.unique(pairs, return_inverse=True)
    levels = pyramid(lattice, used)
    first, last = which.reshape(-1, 2).T
    start = stretches(lattice.bands, BANDS)[0][used]
    first, last = parts_meet(*levels[-1], first[None], last[None])
    for above, below in zip(levels[::-1], levels[-2::-1], strict=False):
        shape = below[0].shape[2:]
        first, last = (parts(box, above[0].shape[2:], shape) for box in (first, last))
        first, last = apart(*parts_meet(*below, first, last), start, shape)
        step = max(-(-len(first) // MOST), 1)
        first, last = first[::step], last[::step]
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
    kept = np.flatnonzero(band.take(last) - band.take(first) > 2 - size)
    return (first, last) if len(kept) == len(first) else (first.take(kept), last.take(kept))


def pyramid(lattice, used):
    """Boxes of cells, then of two by two of them, and so on to one a stretch: lows and highs (3, k, rows, columns).

    They are so much smaller that cells which meet in no more than a face of their boxes, as in one plane, do not.
    """
    start, end = (part[used] for part in stretches(lattice.bands, BANDS))
    rings = np.minimum(start[:, None] + np.arange(BANDS + 1), end[:, None])
    points = lattice.points(rings)
    beside = points[lattice.grid.following]
    low, high = (around(join(points, beside), join) for join in (np.minimum, np.maximum))
    none = np.arange(BANDS) >= (end - start)[:, None]
    if none.any():
        low[:, none], high[:, none] = np.inf, -np.inf
    gaps = [*lattice.grid.gaps, *range(lattice.grid.columns, low.shape[3])]
    low[..., gaps], high[..., gaps] = np.inf, -np.inf
    low += TOUCHING * lattice.size
    levels = [(low, high)]
    while low.shape[2] * low.shape[3] > 1:
        for axis in (2, 3):
            if low.shape[axis] > 1:
                even, odd = ((slice(None),) * axis + (slice(side, None, 2),) for side in (0, 1))
                low, high = np.minimum(low[even], low[odd]), np.maximum(high[even], high[odd])
        levels.append((low, high))
    return levels


def around(rings, join):
    """What is joined of rings (m, k, n, 3) and the next ones, axis by axis: (3, k, n - 1, 2 ** c), so many columns."""
    columns, count, bands, _ = rings.shape
    found = np.empty((3, count, bands - 1, 1 << int(np.ceil(np.log2(max(columns, 2))))))
    found[..., :columns] = join(rings[:, :, :-1], rings[:, :, 1:]).transpose(3, 1, 2, 0)
    return found


def parts(boxes, above, below):
    """The parts of boxes, by their numbers among so many rows and columns in each stretch: (c, k) int array."""
    rows, columns = below[0] // above[0], below[1] // above[1]
    part = (below[1] * np.arange(rows)[:, None] + np.arange(columns)).ravel()
    return part[:, None] + (boxes // above[1] * (rows * below[1]) + boxes % above[1] * columns)


def parts_meet(low, high, first, last):
    """Those pairs of boxes, of pairs (c, k) by their numbers all of the first c with all of the last, that meet."""
    count, pairs = first.shape
    meet = np.full((count, count, pairs), True)
    for least, most in zip(low.reshape(3, -1), high.reshape(3, -1), strict=True):
        meet &= least.take(first)[:, None] <= most.take(last)
        meet &= least.take(last) <= most.take(first)[:, None]
    meet = np.flatnonzero(meet.transpose(2, 0, 1))  # parts of one pair together: what is near is looked at together
    pair, part = np.divmod(meet, count * count)
    one, other = np.divmod(part, count)
    return first.take(one * pairs + pair), last.take(other * pairs + pair)


def reach_slabs(cells, others, tolerance):
    """Whether cells (3, 4, k) reach farther than that into the slabs between two planes that hold others: (k,) bool."""
    normal = cross(others[:, 2] - others[:, 0], others[:, 3] - others[:, 1])
    own = inner(others[:, 1] - others[:, 0], normal)  # the diagonals lie in the two planes: those of 0 and 2, 1 and 3
    least = tolerance * np.sqrt(inner(normal, normal))
    over = inner(cells - others[:, :1], normal[:, None])
    return (over.min(axis=0) <= np.maximum(own, 0.0) - least) & (over.max(axis=0) >= np.minimum(own, 0.0) + least)


def triangles_cross(a, b, tolerance):
    """Where edges of the triangles of cells go through those of others, (3, 4, k) twice: (h,) int and (3, h) points.

    Both cross the line in which their planes meet, each between two of its edges. An edge goes through the other
    triangle where it does so between those of the other.

    Source
    ------
    Moeller: A fast triangle-triangle intersection test, Journal of Graphics Tools 2(2), 1997.
    """
    over_a, over_b = heights(a, b), heights(b, a)
    one, other, which = np.nonzero(reach_through(over_a, tolerance) & reach_through(over_b, tolerance).swapaxes(0, 1))
    points_a, through_a = through_planes(a, over_a, one, other, which, tolerance)
    points_b, through_b = through_planes(b, over_b, other, one, which, tolerance)
    axis = sum(np.abs(points[:, 1] - points[:, 0]) for points in (points_a, points_b)).argmax(axis=0)
    along = axis * 2 * len(which) + np.arange(2 * len(which)).reshape(2, -1)
    at_a, at_b = points_a.take(along), points_b.take(along)
    edge, pair = np.nonzero(np.concatenate((through_a & within(at_a, at_b), through_b & within(at_b, at_a))))
    return which[pair], np.concatenate((points_a, points_b), axis=1)[:, edge, pair]


def within(places, ends):
    """Whether places on lines (2, h) are between two others (2, h)."""
    return (places >= np.minimum(*ends)) & (places <= np.maximum(*ends))


def through_planes(cells, over, side, plane, which, tolerance):
    """Where triangles go through planes: two points of each, (3, 2, h), and whether its edges there do, (2, h).

    Parameters
    ----------
    cells : (3, 4, k) float array
    over : (2, 4, k) float array
        How far their corners are over two planes each.
    side, plane, which : (h,) int arrays
        The triangle of its cell, the plane and the cell of each.
    tolerance : float
        An edge that ends no farther from a plane does not go through it.
    """
    below = (over < 0)[:, TRIANGLES].astype(np.int8)
    kind = below[:, :, 0] + 2 * below[:, :, 1] + 4 * below[:, :, 2]
    corners, count = TURNED.take(8 * side + kind[plane, side, which], axis=1), cells.shape[2]
    start, ends = np.split(cells.reshape(3, -1).take(corners * count + which, axis=1), (1,), axis=1)
    over_start, over_ends = np.split(over.take((plane * 4 + corners) * count + which), (1,))
    share = over_start / (over_start - over_ends)
    return start + share * (ends - start), np.abs(over_ends) > tolerance


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
