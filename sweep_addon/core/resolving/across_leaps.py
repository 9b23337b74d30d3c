# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solid of a sweep whose frame leaps: of the parts between leaps, united where one ends and the next begins."""

import numpy as np

from ..meshes.booleans import union
from ..stations.frames import Frenet
from ..stations.leaps import leaps
from ..vectors import dot
from .of_rings import solid_of_rings
from .resolve import closed
from .rings import Rings


def leaping(shape, mesh):
    """The rings of a sweep's mesh right before its frame leaps to the next: (k,) rising int array."""
    frame = getattr(shape, "frame", None)
    if not isinstance(frame, Frenet):
        return np.zeros(0, dtype=int)
    before = leaps(frame, shape.trajectory)[:, 0]
    return np.unique(np.abs(mesh.chart.s - before[:, None]).argmin(axis=1))


def across_leaps(mesh, before, progress=None):
    """The boundary of all that contours visit, of which those after some rings (k,) stand turned at once.

    Each part goes on a little beyond its end, to where the next begins, and begins as much before.
    """
    rings = Rings(closed(mesh))
    count = rings.grid.rings
    first = before + 1
    last = np.append(before[1:], before[0] + count) if rings.closed else np.append(before, count - 1)
    first = first if rings.closed else np.insert(first, 0, 0)
    parts = []
    for number, (start, end) in enumerate(zip(first, last, strict=True)):
        places = mesh.vertices[rings.vertices(np.arange(start, end + 1))].swapaxes(0, 1)
        if rings.closed or start > 0:
            places = np.insert(places, 0, beside(rings, start, start - 1), axis=0)
        if rings.closed or end < count - 1:
            places = np.append(places, beside(rings, end, end + 1)[None], axis=0)
        parts.append(solid_of_rings(places, offsets=rings.grid.offsets))
        if progress:
            progress((number + 1) / (len(first) + 1))
    return union(parts)


def beside(rings, ring, other):
    """The points of a ring, (m, 3), moved straight to the plane of another beside it."""
    here, there = (rings.mesh.vertices[rings.vertices([which])[:, 0]] for which in (ring, other))
    normal = rings.normals[ring % rings.grid.rings]
    return here + dot(there.mean(axis=0) - here.mean(axis=0), normal) * normal
