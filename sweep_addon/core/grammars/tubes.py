# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of figures: edges alone, or a closed tube along each axis, mitred where it turns."""

from functools import cached_property

import numpy as np

from ..digest import checksum
from ..mesh import Mesh, Topology, require_few
from ..parameters import require
from .faces import with_polygons

SHARPEST = -0.5  # cosine of a turn beyond which a mitre would be more than twice as wide as the tube
SIDE, CAP = 0, 1  # material slots


class Chart:
    """What vertices of a figure's mesh know of the segments they belong to; it has no texture coordinates."""

    def __init__(self, values, rings):
        self.values, self.rings = values, rings

    @cached_property
    def keys(self):
        return "", checksum(*self.values.values()), ""

    def uv(self, dtype=np.float64, empty=np.empty):
        return None

    def along(self, dtype=np.float64):
        return {name: value.astype(dtype, copy=False) for name, value in self.values.items()}

    def across(self, dtype=np.float64):
        return {}


def mesh(figure, sides):
    """The mesh of a figure; `Figure.mesh` says of what."""
    require(sides == 0 or 3 <= sides <= 256, "must be 0 or from 3 to 256", sides, "sides")
    return with_polygons(tubes(figure, sides) if sides else wires(figure), figure)


def wires(figure):
    """Segments as edges, which share vertices where one goes on from the other."""
    count = len(figure)
    require_few(2 * count, "sides")
    own = ~figure.follows
    start = np.where(own, count + np.cumsum(own) - 1, figure.parent)
    edges = np.column_stack((start, np.arange(count))).astype(np.int32)
    none = np.zeros(0, dtype=np.int32)
    topology = Topology(none, np.zeros(1, np.int32), edges, none, np.zeros(count, dtype=bool), none)
    of = np.concatenate((np.arange(count), np.flatnonzero(own)))
    return Mesh(np.concatenate((figure.end, figure.start[own])), topology, Chart(attributes(figure, of), count))


def attributes(figure, segment):
    """Values at each vertex, of the segment that it belongs to."""
    values = {"radius": figure.width / 2, "colour": figure.colour, "birth": figure.birth}
    values |= {"axis": figure.axis, "order": figure.order}
    return {name: value[segment].astype(np.float64) for name, value in values.items()}


def tubes(figure, sides):
    """A tube along each axis: a ring of vertices at each of its points, quads between, and a cap at each end."""
    order = np.argsort(figure.axis, kind="stable")
    begins = ~figure.joined[order]
    axes = int(begins.sum())
    rings = len(order) + axes
    require_few(rings * sides, "sides")
    lower = (
        np.arange(len(order)) + np.cumsum(begins) - 1
    )  # the ring where each segment begins; the next is where it ends
    ends = np.append(np.flatnonzero(begins)[1:], len(order)) - 1 if axes else np.zeros(0, dtype=np.intp)

    points = np.empty((rings, 3))
    points[lower + 1], points[lower[begins]] = figure.end[order], figure.start[order][begins]
    segment = np.empty(rings, dtype=np.intp)  # whose width a ring has: that of the segment that begins there
    segment[lower + 1], segment[lower] = order, order
    along, across = frames(figure, order, begins)
    offsets = mitred(along, across, begins, ends, lower, rings, sides)
    radius = figure.width[segment] / 2
    radius[lower[ends] + 1] = figure.tip[order[ends]] / 2
    offsets *= radius[:, None, None]
    vertices = (points[:, None] + offsets).reshape(-1, 3)
    topology = laid(lower.astype(np.int32), lower[begins], lower[ends] + 1, rings, sides)
    values = attributes(figure, np.repeat(segment, sides)) | {"radius": np.repeat(radius, sides)}
    return Mesh(vertices, topology, Chart(values, len(order)))


def frames(figure, order, begins):
    """Headings of segments, and normals that turn along each axis no more than they must.

    The left of the turtle is a normal that rolls. Its rolls against one that is carried without are angles about the
    heading, so they add up, and are taken off again (Bishop 1975).
    """
    heading, left, up = (figure.axes[order][:, k] for k in range(3))
    if not len(order):
        return heading, left
    middle = heading[:-1] + heading[1:]
    size = np.einsum("ij,ij->i", middle, middle)
    part = np.einsum("ij,ij->i", left[:-1], middle) / np.where(size > 1e-12, size, 1)
    carried = left[:-1] - 2 * part[:, None] * middle
    roll = np.arctan2(np.einsum("ij,ij->i", carried, up[1:]), np.einsum("ij,ij->i", carried, left[1:]))
    roll = np.concatenate(([0.0], np.where(begins[1:], 0.0, roll)))
    total = np.cumsum(roll)
    total -= total[np.flatnonzero(begins)[np.cumsum(begins) - 1]]
    return heading, np.cos(total)[:, None] * left + np.sin(total)[:, None] * up


def mitred(along, across, begins, ends, lower, rings, sides):
    """(rings, sides, 3) float array: unit contours, in the plane halfway between two segments where these meet."""
    angle = 2 * np.pi * np.arange(sides) / sides
    aside = np.cross(along, across)
    contour = np.cos(angle)[:, None] * across[:, None] + np.sin(angle)[:, None] * aside[:, None]
    offsets = np.empty((rings, sides, 3))
    offsets[lower[begins]] = contour[begins]
    offsets[lower + 1] = contour
    inner = np.ones(len(along), dtype=bool)
    inner[ends] = False
    inner = np.flatnonzero(inner)
    one, other = along[inner], along[inner + 1]
    cosine = np.einsum("ij,ij->i", one, other)
    bent = inner[cosine > SHARPEST]
    one, other, cosine = along[bent], along[bent + 1], cosine[cosine > SHARPEST]
    height = np.einsum("ijk,ik->ij", contour[bent], one + other) / (1 + cosine)[:, None]
    offsets[lower[bent] + 1] -= height[:, :, None] * one[:, None]
    return offsets


def laid(lower, first, last, rings, sides):
    """The faces and edges of tubes: round the rings, then along the segments."""
    side, ahead = np.arange(sides, dtype=np.int32), np.roll(np.arange(sides, dtype=np.int32), -1)
    base, count, tubes = (lower * sides)[:, None], len(lower), len(first)
    around = rings * sides  # the first edge along a segment
    strip = around + (np.arange(count, dtype=np.int32) * sides)[:, None]
    quads = np.stack((base + side, base + ahead, base + sides + ahead, base + sides + side), axis=2)
    quad_edges = np.stack((base + side, strip + ahead, base + sides + side, strip + side), axis=2)
    starts, stops = (np.asarray(ring * sides, dtype=np.int32)[:, None] for ring in (first, last))
    corners = np.concatenate([part.ravel() for part in (quads, starts + side[::-1], stops + side)])
    edges_at = np.concatenate([part.ravel() for part in (quad_edges, starts + np.roll(side[::-1], -1), stops + side)])
    sizes = np.repeat([4, sides], [count * sides, 2 * tubes])
    ring = (np.arange(rings, dtype=np.int32) * sides)[:, None]
    edges = np.concatenate(
        (
            np.stack(np.broadcast_arrays(ring + side, ring + ahead), axis=2).reshape(-1, 2),
            np.stack((base + side, base + sides + side), axis=2).reshape(-1, 2),
        )
    )
    sharp = np.zeros(len(edges), dtype=bool)
    for caps in (starts, stops):
        sharp[(caps + side).ravel()] = True
    material = np.repeat(np.array([SIDE, CAP], dtype=np.int32), [count * sides, 2 * tubes])
    offsets = np.concatenate(([0], np.cumsum(sizes))).astype(np.int32)
    return Topology(corners, offsets, edges, edges_at, sharp, material)
