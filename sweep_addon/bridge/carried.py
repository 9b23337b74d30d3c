# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What people put on the mesh of a sweep, carried to a new topology: weights, colours, UV maps and other attributes.

Attributes are arrays. Weights are not, and Python reads and writes them one by one: a bmesh makes each new vertex of
the old ones that it lies between, with all that these have.
"""

from collections import deque
from itertools import repeat

import bmesh
import bpy
import numpy as np
from bmesh.types import BMVert

from ..core.grids.between import sources
from ..core.grids.chart import Chart

ORIGIN = (0.0, 0.0, 0.0)
SIDES, CAP = 4, 4  # corners of a face between rings; and what stands for those of a face at an end
SIDE_OF = np.array([(0, 1), (3, 2)])  # which corner is at the ring before and behind, at the own column and the next
BLENDED = {"FLOAT", "FLOAT2", "FLOAT_VECTOR", "FLOAT_COLOR", "BYTE_COLOR"}  # whole numbers and turns are not
ARRAYS = {  # of each type of attribute the property, how many numbers, of which kind
    "FLOAT": ("value", 1, np.float32),
    "INT": ("value", 1, np.int32),
    "INT8": ("value", 1, np.int32),
    "BOOLEAN": ("value", 1, bool),
    "INT16_2D": ("value", 2, np.int32),
    "INT32_2D": ("value", 2, np.int32),
    "FLOAT2": ("vector", 2, np.float32),
    "QUATERNION": ("value", 4, np.float32),
    "FLOAT_COLOR": ("color", 4, np.float32),
    "BYTE_COLOR": ("color_srgb", 4, np.float32),
    "FLOAT_VECTOR": ("vector", 3, np.float32),
}


class Carried:
    """What people put on a mesh, on its way to other vertices, corners and faces."""

    def __init__(self, mesh, own, found, made, along, weights):
        self.vertices, self.has_weights = found, weights
        self.colours = {name: getattr(mesh.attributes, name) for name in ("active_color_name", "default_color_name")}
        self.shown = {layer.name: (layer.active, layer.active_render) for layer in mesh.uv_layers}
        there = {"POINT": found}
        if any(each.domain != "POINT" for each in own):
            there["CORNER"], there["FACE"] = corners_and_faces(mesh, found, made, along)
        self.arrays = [(each.name, each.data_type, each.domain, taken(each, there[each.domain])) for each in own]

    def lay_vertices(self, mesh):
        """Empty a mesh of all but new vertices, each with the weights of the old ones that it lies between."""
        through = bmesh.new()
        through.from_mesh(mesh, face_normals=False, vertex_normals=False)
        old = through.verts[:]
        before, behind = self.vertices.around
        made = weighed(through, old, *before, self.vertices.across)
        if self.vertices.along.any():
            beyond = weighed(through, old, *behind, self.vertices.across)
            blend(made, made, beyond, self.vertices.along)
            old += beyond
        bmesh.ops.delete(through, geom=old, context="VERTS")
        through.to_mesh(mesh)
        through.free()
        for name in [each.name for each in mesh.attributes if not each.is_required]:
            mesh.attributes.remove(mesh.attributes[name])

    def lay_arrays(self, mesh):
        """Give the new vertices, corners and faces of a mesh their values, and show of them what was shown."""
        for name, kind, domain, values in self.arrays:
            made = mesh.attributes.new(name, kind, domain)
            made.data.foreach_set(ARRAYS[kind][0], values.ravel())
        for name, colour in self.colours.items():
            if colour in mesh.attributes:
                setattr(mesh.attributes, name, colour)
        for layer in mesh.uv_layers:
            active, render = self.shown.get(layer.name, (False, False))
            layer.active, layer.active_render = layer.active or active, layer.active_render or render


def weighed(through, old, low, high, part):
    """New vertices of a bmesh, each between two of the old ones: a list."""
    first, second = ([old[i] for i in which.tolist()] for which in (low, high))
    made = list(map(through.verts.new, repeat(ORIGIN), first))
    blend(made, first, second, part)
    return made


def blend(made, first, second, part):
    """Give vertices of a bmesh what lies between two others, but for those that are at the first."""
    some = np.flatnonzero(part).tolist()
    pairs = ((first[i], second[i]) for i in some)
    deque(map(BMVert.copy_from_vert_interp, [made[i] for i in some], pairs, part[some].tolist()), maxlen=0)


def taken(attribute, found):
    """The values of an attribute where they are found for other vertices, corners or faces."""
    values = read(attribute)
    if attribute.data_type == "BOOLEAN":
        return found.blended(values.astype(np.float32)) > 0.5
    return found.blended(values) if attribute.data_type in BLENDED else values[found.nearest]


def carried(mesh, made, known):
    """What people put on a mesh of a sweep that is to have other faces; None where there is nothing, or no way.

    Parameters
    ----------
    mesh : bpy.types.Mesh
    made : Mesh
        Which it is to be.
    known : set of str
        The attributes that the sweep itself has.
    """
    if not (isinstance(made.chart, Chart) and len(mesh.polygons)):
        return None
    own = [each for each in mesh.attributes if is_own(each, known)]
    weights = has_weights(mesh)
    if not (own or weights):
        return None
    lengths = [mesh.attributes.get(name) for name in ("arc_length", "v")]
    if any(each is None or (each.data_type, each.domain) != ("FLOAT", "POINT") for each in lengths):
        return None
    along, across = map(read, lengths)
    places, edges = read(mesh.attributes["position"]), read(mesh.attributes[".edge_verts"])
    found = sources(along, across, places, edges, made.chart)
    if not even(along, across, made.chart.grid):
        own = [each for each in own if each.domain == "POINT"]
    return Carried(mesh, own, found, made, along, weights) if found and (own or weights) else None


def even(along, across, grid):
    """Whether each face between rings has four corners, before and after: no tips, no poles."""
    return len(np.unique(along)) * len(np.unique(across)) == len(along) and not (grid.tips or grid.poles)


def is_own(attribute, known):
    """Whether somebody has made an attribute that can be carried."""
    if attribute.is_internal or attribute.is_required or attribute.name in known or attribute.domain == "EDGE":
        return False
    return attribute.data_type in ARRAYS


def has_weights(mesh):
    """Whether a mesh may have weights: an object of it has groups for them."""
    return any(ob.data == mesh and ob.vertex_groups for ob in bpy.data.objects)


def read(attribute):
    """The values of an attribute: (n,) or (n, k) array."""
    name, width, dtype = ARRAYS[attribute.data_type]
    values = np.empty(width * len(attribute.data), dtype)
    attribute.data.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def corners_and_faces(mesh, found, made, along):
    """Between which old corners each new corner lies, and between which old faces each new one: two `Between`.

    A corner has it from its vertex. Where that lies between old ones, the old corners are those of the face between
    them, so nothing is mixed across a seam; where it is at one, the corner in a face on the same side of it. A face
    has it from its first corner, and one of an end whose faces are others now from any there. There must be no tips and
    no poles.
    """
    topology, starts = made.topology, np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("loop_start", starts)
    corners = read(mesh.attributes[".corner_vert"])
    face, kind = kinds(np.append(starts, len(corners)), along[corners])
    ends = np.flatnonzero(kind == CAP)
    table = np.full((len(mesh.vertices), CAP + 1), -1)
    table[corners, kind] = np.arange(len(corners))
    for some in (slice(CAP), slice(None)):  # of a face on another side; a cap's only where there is no other
        table[:, some] = np.where(table[:, some] < 0, table[:, some].max(axis=1, keepdims=True), table[:, some])
    after = made.chart.spread(made.chart.s, (), (), float)
    _, kind = kinds(topology.offsets, after[topology.corners])
    found = found.of(topology.corners)
    corner, anew = found._replace(around=table[found.around, facing(kind, found)]), np.flatnonzero(kind == CAP)
    if np.array_equal(corners[ends], found.around[0, 0, anew]):  # the same ends, where faces may share vertices
        corner.around[..., anew] = ends
    first = corner.of(topology.offsets[:-1])
    return corner, first._replace(around=face[first.around])


def facing(kind, found):
    """Which corner of the old face it is at each of the old vertices that new corners lie between: (2, 2, c) ints."""
    own, ends = kind == SIDE_OF[:, :, None], np.arange(2)
    behind = np.where(found.along > 0, ends[:, None, None], own[1].any(axis=0).astype(int))
    beside = np.where(found.across > 0, ends[None, :, None], own[:, 1].any(axis=0).astype(int))
    return np.where(kind == CAP, CAP, SIDE_OF[behind, beside])


def kinds(offsets, along):
    """The face of each corner, and which corner of it that is, or `CAP`: all of a cap have one arc length."""
    face = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
    place = np.arange(len(face)) - offsets[face]
    cap = np.minimum.reduceat(along, offsets[:-1]) == np.maximum.reduceat(along, offsets[:-1])
    return face, np.where(cap[face], CAP, np.minimum(place, SIDES - 1))
