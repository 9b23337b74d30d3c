# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a surface passes through a cell of a lattice whose corners are inside or outside: in which closed cycles.

Corner x + 2 y + 4 z; edge 4 a + b + 2 c runs along axis a from the corner at b along the next axis and c along the one
after; face 2 a + s is across axis a at s. Where the corners of a face alternate the surface may pass it in two ways: it
parts the two inner corners, or, where the face is *turned*, the two outer ones.
"""

from functools import lru_cache
from itertools import combinations

import numpy as np

AXES = np.arange(3)


def corner(*offsets):
    """The corner at offsets along axes, of pairs (axis, offset)."""
    return sum(offset << axis for axis, offset in offsets)


EDGES = np.array([
    [corner((a, end), ((a + 1) % 3, b), ((a + 2) % 3, c)) for end in (0, 1)]
    for a in range(3) for c in (0, 1) for b in (0, 1)
])  # fmt: skip
FACES = np.array([
    [corner((a, s), ((a + 1) % 3, b), ((a + 2) % 3, c)) for b, c in ((0, 0), (1, 0), (1, 1), (0, 1))]
    for a in range(3) for s in (0, 1)
])  # fmt: skip
ALONG = np.array([
    [next(e for e, ends in enumerate(EDGES) if {*ends} == {face[i], face[(i + 1) % 4]}) for i in range(4)]
    for face in FACES
])  # fmt: skip


@lru_cache(maxsize=1)
def tables():
    """What is asked of each of 64 x 256 cells, which faces are turned and which corners inside.

    Returns
    -------
    cycle : (64, 256, 12) int8 array
        The number of the cycle that each edge is on, -1 where the surface does not cross it.
    count : (64, 256) int8 array
        The number of cycles.
    twice : (64, 256) int array
        Bit i where one cycle passes face i twice.
    """
    bits = np.arange(256)[:, None] >> np.arange(8) & 1 == 1
    turned = np.arange(64)[:, None] >> np.arange(6) & 1 == 1
    crossed = bits[:, EDGES[:, 0]] != bits[:, EDGES[:, 1]]
    label = np.broadcast_to(np.where(crossed, np.arange(12), 12), (64, 256, 12)).copy()
    joins = [join for face in range(6) for join in joined(face, bits, crossed, turned)]
    for _ in range(6):  # a cycle has at most twelve edges, and labels run both ways round it
        for first, second, where in joins:
            low = np.minimum(label[..., first], label[..., second])
            label[..., first] = np.where(where, low, label[..., first])
            label[..., second] = np.where(where, low, label[..., second])
    leads = label == np.where(crossed, np.arange(12), -1)
    rank = np.cumsum(leads, axis=2) - 1
    cycle = np.where(crossed, np.take_along_axis(rank, np.minimum(label, 11), axis=2), -1).astype(np.int8)
    around = cycle[..., ALONG]
    twice = ((around == around[..., :1]) & (around >= 0)).all(axis=3) @ (1 << np.arange(6))
    return cycle, leads.sum(axis=2).astype(np.int8), twice


def joined(face, bits, crossed, turned):
    """Pairs of edges that the surface joins across a face, and in which cells (64, 256) it does."""
    edges, corners = ALONG[face], FACES[face]
    alternate = crossed[:, edges].all(axis=1)
    for i, j in combinations(range(4), 2):
        both = crossed[:, edges[i]] & crossed[:, edges[j]]
        if j - i == 2:
            yield edges[i], edges[j], np.broadcast_to(both & ~alternate, (64, 256))
        else:
            between = corners[j if j - i == 1 else 0]
            cut_off = bits[:, between] != turned[:, face, None]
            yield edges[i], edges[j], both & (~alternate | cut_off)
