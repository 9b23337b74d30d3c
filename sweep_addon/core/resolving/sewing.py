# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sewing: the faces of a mesh that stay, and others, as one topology without a search of all edges."""

import numpy as np

from ..meshes.mesh import Topology


def sewn(before, kept, number, others):
    """The topology of some faces as they were and, after them, of others.

    Parameters
    ----------
    before : Topology
    kept : (f,) int array
        Which faces of it.
    number : (n,) int array
        What number each vertex of theirs has among the others'.
    others : Topology
        Where it has an edge of a kept face, at which both are sewn together, the edge stays as sharp as it was.

    Returns
    -------
    Topology
    """
    if not len(kept):
        return others
    corners, number = corners_of(before.offsets, kept), number.astype(np.int32)
    kept_edges = before.corner_edges[corners]
    used = np.full(len(before.edges), False)
    used[kept_edges] = True
    old = number[np.compress(used, before.edges, axis=0)]
    rim = np.full(int(max(old.max(initial=0), others.edges.max(initial=0))) + 1, False)
    rim[others.edges] = True
    shared = np.flatnonzero(rim[old[:, 0]] & rim[old[:, 1]])
    same = equal_pairs(others.edges, old[shared], len(rim))
    new = same < 0
    edge = np.where(new, len(old) + np.cumsum(new) - 1, shared[same])
    renumbered = np.cumsum(used, dtype=np.int32) - np.int32(1)
    sizes = np.concatenate((np.diff(before.offsets)[kept], np.diff(others.offsets)))
    return Topology(
        corners=np.concatenate((number[before.corners[corners]], others.corners)),
        offsets=np.concatenate(([0], np.cumsum(sizes))).astype(np.int32),
        edges=np.concatenate((old, others.edges[new])),
        corner_edges=np.concatenate((renumbered[kept_edges], edge[others.corner_edges].astype(np.int32))),
        sharp=np.concatenate((before.sharp[used], others.sharp[new])),
        material=np.concatenate((before.material[kept], others.material)),
    )


def equal_pairs(pairs, others, count):
    """The number of the other pair, either way round, that each is, -1 for none: (k,) int array."""
    if not len(others):
        return np.full(len(pairs), -1)
    keys, wanted = (np.sort(part.astype(np.int64), axis=1) @ (count, 1) for part in (others, pairs))
    order = np.argsort(keys)
    found = order[np.searchsorted(keys[order], wanted).clip(0, len(keys) - 1)]
    return np.where(keys[found] == wanted, found, -1)


def corners_of(offsets, faces):
    """The corners of faces, one face after the other: (c,) int array."""
    sizes = np.diff(offsets)[faces]
    return np.repeat(offsets[faces] - np.cumsum(sizes) + sizes, sizes) + np.arange(sizes.sum())
