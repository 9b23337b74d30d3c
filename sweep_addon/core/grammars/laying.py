# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laying: the faces and edges of tubes, each column's made from the first one's by a sum, and kept for equal tubes."""

import numpy as np

from ..digest import checksum
from ..kept import kept
from ..mesh import Topology


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
    lower = (np.arange(count) + np.cumsum(begins) - 1).astype(np.int32)
    first = np.flatnonzero(begins)
    final = np.append(first[1:], count) - 1 if tubes else first
    column = np.arange(sides, dtype=np.int32)
    ahead = np.roll(column, -1)

    quads, corner = 4 * sides * count, 4 * sides * count + 2 * sides * tubes
    corners, corner_edges = np.empty((2, corner), dtype=np.int32)
    faces, bars_of = (part[:quads].reshape(sides, count, 4) for part in (corners, corner_edges))
    faces[..., 0], faces[..., 1] = column[:, None] * rings + lower, ahead[:, None] * rings + lower
    np.add(faces[..., 1::-1], 1, out=faces[..., 2:])
    around = sides * rings  # the first edge along a segment
    bars = around + column[:, None] * count + np.arange(count, dtype=np.int32)
    bars_of[..., 0], bars_of[..., 1] = faces[..., 0], bars[ahead]
    bars_of[..., 2], bars_of[..., 3] = faces[..., 3], bars

    starts, ends = ((column * rings)[None] + lower[which][:, None] + up for which, up in ((first, 0), (final, 1)))
    caps = np.stack((starts[:, ::-1], ends))
    corners[quads:] = caps.ravel()
    corner_edges[quads:] = np.stack((np.roll(caps[0], -1, axis=1), ends)).ravel()
    edges = np.empty((around + sides * count, 2), dtype=np.int32)
    edges[:around, 0] = np.arange(around, dtype=np.int32)
    edges[:around, 1].reshape(sides, rings)[:] = ahead[:, None] * rings + np.arange(rings, dtype=np.int32)
    edges[around:].reshape(sides, count, 2)[:] = faces[..., ::3]
    sharp = np.zeros(len(edges), dtype=bool)
    sharp[caps.ravel()] = True
    sizes = np.repeat([4, sides], [count * sides, 2 * tubes])
    return Topology(
        corners=corners,
        offsets=np.concatenate(([0], np.cumsum(sizes))).astype(np.int32),
        edges=edges,
        corner_edges=corner_edges,
        sharp=sharp,
        material=np.concatenate((np.tile(slot, sides), slot[first], slot[final])),
        name=f"tubes.{sides}.{checksum(begins, slot)}.",
    )
