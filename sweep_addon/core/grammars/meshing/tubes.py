# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of figures: edges alone, or a closed tube along each axis, mitred where it turns; polygons and organs too."""

from dataclasses import replace

import numpy as np

from ...declared.digest import checksum
from ...declared.options import Texture
from ...meshes.joining import joined
from ...meshes.mesh import Mesh, Topology, require_few
from ...vectors import cross, dot, product
from ..drawing.filling import ORGAN, START
from .beside import Numbered, organs, polygons, slots
from .chart import Chart, Skin
from .laying import laid

ALMOST = 1e-9  # of the largest coordinate: nearer than that an axis ends where it began
SHARPEST = -0.5  # cosine of a turn beyond which a mitre would be more than twice as wide as the tube


def mesh(figure, sides, texture=Texture.NONE, attributes=True, dtype=np.float64, apart=False):
    """The mesh of a figure; `Figure.mesh` says of what."""
    if sides:
        made = tubes(figure, sides, texture, attributes, dtype)
    else:
        made = (poly_lines if apart else wires)(figure, attributes, dtype)
    named = figure.walk.named
    with_organs = ORGAN in named and figure.organs
    if with_organs:
        made = replace(made, chart=Numbered(made.chart, len(made.vertices)))
    with_polygons = START in named and len(figure.filled.place)
    parts = [made, *([polygons(figure, made.chart, dtype)] if with_polygons else [])]
    return joined(parts + ([organs(figure, made.chart, dtype)] if with_organs else []))


def wires(figure, attributes, dtype):
    """Segments as edges, which share vertices where one goes on from the other."""
    count = len(figure)
    require_few(2 * count, "")
    own = ~figure.follows
    start = np.where(own, count + np.cumsum(own) - 1, figure.parent)
    edges = np.column_stack((start, np.arange(count))).astype(np.int32)
    skin = Skin(figure, ends=np.concatenate((np.arange(count), np.flatnonzero(own))), starts=int(own.sum()))
    vertices = np.concatenate((figure.end, figure.start[own])).astype(dtype)
    return Mesh(vertices, bare(edges), Chart(skin, 1, Texture.NONE, attributes))


def poly_lines(figure, attributes, dtype):
    """The points of each axis one behind the other, and edges between them: no two axes have one in common."""
    require_few(2 * len(figure), "")
    skin = Skin(figure)
    skin.shared = np.arange(skin.rings)
    edges = np.column_stack((skin.lower, skin.lower + 1)).astype(np.int32)
    return Mesh(skin.points.astype(dtype), bare(edges), Chart(skin, 1, Texture.NONE, attributes))


def bare(edges):
    """The topology of edges without faces."""
    none = np.zeros(0, dtype=np.int32)
    name = f"wires.{checksum(edges)}."
    return Topology(none, np.zeros(1, np.int32), edges, none, np.zeros(len(edges), dtype=bool), none, name)


def tubes(figure, sides, texture, attributes, dtype):
    """A tube along each axis: a ring of vertices at each of its points, quads between, and a cap at each end.

    The vertices of a column lie together, ring after ring, tube after tube: so that all vertices are one product of
    the contour with the axes of the rings.
    """
    skin = Skin(figure)
    require_few(skin.rings * sides, "sides")
    axes = np.empty((3, skin.rings, 3), dtype)
    for made, axis in zip(axes, mitred(figure, skin, dtype), strict=False):
        np.multiply(axis, skin.radius.astype(dtype)[:, None], out=made)
    axes[2] = skin.points
    angle = 2 * np.pi * np.arange(sides) / sides
    contour = np.column_stack((np.cos(angle), np.sin(angle), np.ones(sides))).astype(dtype)
    vertices = np.empty((sides, 3 * skin.rings), dtype)
    product(contour, axes.reshape(3, -1), out=vertices)
    material = slots(figure.colour)[skin.order]
    topology = laid(skin.begins.tobytes(), material.tobytes() if material.any() else b"", sides)
    return Mesh(vertices.reshape(-1, 3), topology, Chart(skin, sides, texture, attributes))


def mitred(figure, skin, dtype):
    """Two (r, 3) float arrays: the axes of each ring, in the plane halfway between two segments where these meet."""
    along, across = (part.astype(dtype) for part in carried(figure, skin))
    together = along[:-1] + along[1:]
    cosine = dot(along[:-1], along[1:])
    share = np.where((cosine > SHARPEST) & ~skin.begins[1:], 1 / np.maximum(1 + cosine, 0.1), 0)
    first, last = closed(skin, along)
    around = along[last] + along[first]
    around *= 2 / dot(around, around)[:, None]
    for axis in (across, cross(along, across)):
        ring = np.empty((skin.rings, 3), dtype)
        ring[skin.first] = axis.take(skin.starts, axis=0)
        ring[skin.lower[first]] -= dot(axis[first], around)[:, None] * along[first]
        axis[last] -= dot(axis[last], around)[:, None] * along[last]
        axis[:-1] -= (dot(axis[:-1], together) * share)[:, None] * along[:-1]
        ring[skin.lower + 1] = axis
        yield ring


def closed(skin, along):
    """Two (a,) int arrays: which sorted segments begin, and which end, the axes that end where they began."""
    points = skin.points
    apart = points.take(skin.final, axis=0) - points.take(skin.first, axis=0)
    nearest = ALMOST * max(points.max(initial=0), -points.min(initial=0))
    axis = np.flatnonzero(dot(apart, apart) <= nearest**2)
    first = skin.starts[axis]
    last = first + skin.final[axis] - skin.first[axis] - 1
    meets = (last > first) & (dot(along[last], along[first]) > SHARPEST)
    return first[meets], last[meets]


def carried(figure, skin):
    """Headings of segments, and normals that turn along each axis no more than they must.

    The left of the turtle is a normal that rolls. Its rolls against one that is carried without are angles about the
    heading, so they add up, and are taken off again (Bishop 1975).
    """
    walk = figure.walk
    if not len(figure) or not (walk.spatial or walk.cylinders):  # in its plane it turns about its up alone
        return figure.headings.take(skin.order, axis=0), np.tile(walk.up, (len(figure), 1))
    axes, heading = figure.axes.take(skin.order, axis=0), figure.headings.take(skin.order, axis=0)
    left, up = axes[:, 1], axes[:, 2]
    middle = heading[:-1] + heading[1:]
    size = dot(middle, middle)
    part = dot(left[:-1], middle) / np.where(size > 1e-12, size, 1)
    turned = left[:-1] - 2 * part[:, None] * middle
    roll = np.arctan2(dot(turned, up[1:]), dot(turned, left[1:]))
    roll = np.concatenate(([0.0], np.where(skin.begins[1:], 0.0, roll)))
    total = np.cumsum(roll)
    total -= total.take(skin.starts).take(skin.axis)
    return heading, np.cos(total)[:, None] * left + np.sin(total)[:, None] * up
