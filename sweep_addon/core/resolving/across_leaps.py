# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solid of a sweep whose frame leaps: of the parts between leaps, united where one ends and the next begins."""

import numpy as np

from ..meshes.booleans import body_of, united
from ..meshes.polyhedron import polyhedron
from ..stations import sampling
from ..stations.continuing import evenly
from ..stations.frames import axes
from ..stations.leaps import leaps
from ..vectors import dot
from .of_rings import solid_of_rings
from .resolve import closed
from .rings import Rings
from .tidying import tidied_arrays

FAR = np.cos(np.radians(45))  # a contour that turns less at once has faces that do not cross each other


def leaping(shape, mesh):
    """The rings of a mesh right before the frame of its sweep leaps farther than `FAR`: (k,) rising int array."""
    frame = getattr(shape, "frame", None)
    found = leaps(frame, shape.trajectory)
    if not len(found):
        return np.zeros(0, dtype=int)
    before = np.abs(mesh.chart.s - found[:, :1]).argmin(axis=1)
    ends = evenly(shape.trajectory)[1].s[[0, -1]]  # a corner that comes last would be taken for one
    stations = sampling.stations(shape.trajectory, np.unique(np.append(ends, found)))
    e2, e3, _ = axes(frame, stations, np.zeros(len(stations.s)))
    here, there = np.searchsorted(stations.s, found.T)
    return np.unique(before[(dot(e2[here], e2[there]) + dot(e3[here], e3[there])) < 2 * FAR])


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
    return polyhedron(*tidied_arrays(united(map(body_of, parts))))


def beside(rings, ring, other):
    """The points of a ring, (m, 3), moved straight to the plane of another beside it."""
    here, there = (rings.mesh.vertices[rings.vertices([which])[:, 0]] for which in (ring, other))
    normal = rings.normals[ring % rings.grid.rings]
    return here + dot(there.mean(axis=0) - here.mean(axis=0), normal) * normal
