# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laying: the faces and edges of tubes, each column's made from the first one's by a sum, and kept for equal tubes."""

import numpy as np

from ...declared.digest import checksum
from ...kept import kept
from ...meshes.mesh import Topology


@kept
def laid(begins, material, sides):
    """The topology of tubes.

    Parameters
    ----------
    begins : bytes
        Of an (n,) bool array: which segments begin a tube.
    material : bytes
        Of an (n,) int32 array: the slot of each; empty where all have the first.
    sides : int
        Vertex c * r + k is the one of column c in ring k, of r.
    """
    begins = np.frombuffer(begins, dtype=bool)
    count, tubes = len(begins), int(begins.sum())
    slot = np.frombuffer(material, dtype=np.int32) if material else np.zeros(count, dtype=np.int32)
    rings = count + tubes
    lower = np.arange(-1, count - 1, dtype=np.int32)
    lower += np.cumsum(begins, dtype=np.int32)
    bars = np.arange(rings, rings + count, dtype=np.int32)  # the edges of the first column along the segments
    own = rings + count  # edges of each column: first those from its rings to the next column's, then its bars
    quads = 4 * sides * count
    corners, corner_edges = np.empty((2, quads + 2 * sides * tubes), dtype=np.int32)
    faces = columns(corners[:quads], (lower, lower + rings, lower + rings + 1, lower + 1), sides, rings, (1, 2))
    columns(corner_edges[:quads], (lower, bars + own, lower + 1, bars), sides, own, (1,))
    edges = np.empty((sides, own, 2), dtype=np.int32)
    edges[0, :rings, 0] = np.arange(rings)
    edges[0, :rings, 1] = edges[0, :rings, 0] + rings
    edges[0, rings:] = faces[0][:, ::3]
    shifted(edges.reshape(sides, -1), rings)
    edges[-1, :rings, 1] -= sides * rings

    first = np.flatnonzero(begins)
    final = np.append(first[1:], count) - 1 if tubes else first
    column = np.arange(sides, dtype=np.int32)
    around = np.stack((column[::-1], column))[:, None], np.stack((np.roll(column[::-1], -1), column))[:, None]
    ends = np.stack((lower[first], lower[final] + 1))[:, :, None]
    corners[quads:] = (around[0] * rings + ends).ravel()
    corner_edges[quads:] = (around[1] * own + ends).ravel()
    sharp = np.zeros(sides * own, dtype=bool)
    sharp[corner_edges[quads:]] = True
    of_quads = np.arange(0, quads, 4, dtype=np.int32)
    offsets = np.concatenate((of_quads, np.arange(quads, len(corners) + 1, sides, dtype=np.int32)))
    return Topology(
        corners=corners,
        offsets=offsets,
        edges=edges.reshape(-1, 2),
        corner_edges=corner_edges,
        sharp=sharp,
        material=np.concatenate((*[slot] * sides, slot[first], slot[final])),
        name=f"tubes.{sides}.{checksum(begins, slot)}.",
    )


def columns(flat, corners, sides, step, ahead):
    """Lay the quads of all columns: of the first one as they are told, of each further one so much higher.

    The corners that are ahead lie on the next column, for the last one on the first.
    """
    quads = flat.reshape(sides, -1, 4)
    for place, corner in enumerate(corners):
        quads[0, :, place] = corner
    shifted(flat.reshape(sides, -1), step)
    for place in ahead:
        quads[-1, :, place] -= sides * step
    return quads


def shifted(rows, step):
    """Fill further rows with the first one, each so much higher than the one before."""
    for number, row in enumerate(rows[1:], 1):
        np.add(rows[0], number * step, out=row)
