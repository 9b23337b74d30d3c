# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What people put on the mesh of a sweep, carried to a new topology: weights, colours and other attributes.

Attributes are arrays. Weights are not, and Python reads and writes them one by one: a bmesh makes each new vertex after
an old one, with all that this has.
"""

from collections import deque
from itertools import repeat

import bmesh
import bpy
import numpy as np

from ..core.grids.carrying import sources
from ..core.grids.chart import Chart

ORIGIN = (0.0, 0.0, 0.0)
SIDES, CAP = 4, 4  # corners of a face between rings; and what stands for those of a face at an end
ARRAYS = {  # of each type of attribute the property, how many numbers, of which kind
    "FLOAT": ("value", 1, np.float32),
    "INT": ("value", 1, np.int32),
    "INT8": ("value", 1, np.int32),
    "BOOLEAN": ("value", 1, bool),
    "FLOAT2": ("vector", 2, np.float32),
    "QUATERNION": ("value", 4, np.float32),
    "FLOAT_COLOR": ("color", 4, np.float32),
    "BYTE_COLOR": ("color_srgb", 4, np.float32),
    "FLOAT_VECTOR": ("vector", 3, np.float32),
}


class Carried:
    """What people put on a mesh, on its way to other vertices, corners and faces."""

    def __init__(self, mesh, own, found, topology):
        self.vertices, self.has_weights = found, has_weights(mesh)
        self.colours = {name: getattr(mesh.attributes, name) for name in ("active_color_name", "default_color_name")}
        there = {"POINT": found}
        if any(each.domain != "POINT" for each in own):
            there["CORNER"], there["FACE"] = corners_and_faces(mesh, found, topology)
        self.arrays = [(each.name, each.data_type, each.domain, read(each)[there[each.domain]]) for each in own]

    def lay_vertices(self, mesh):
        """Empty a mesh of all but new vertices, each with the weights of the old one that it comes from."""
        through = bmesh.new()
        through.from_mesh(mesh, face_normals=False, vertex_normals=False)
        old = through.verts[:]
        deque(map(through.verts.new, repeat(ORIGIN), [old[i] for i in self.vertices.tolist()]), maxlen=0)
        bmesh.ops.delete(through, geom=old, context="VERTS")
        through.to_mesh(mesh)
        through.free()
        for name in [each.name for each in mesh.attributes if not each.is_required]:
            mesh.attributes.remove(mesh.attributes[name])

    def lay_arrays(self, mesh):
        """Give the new vertices, corners and faces of a mesh their values."""
        for name, kind, domain, values in self.arrays:
            made = mesh.attributes.new(name, kind, domain)
            made.data.foreach_set(ARRAYS[kind][0], values.ravel())
        for name, colour in self.colours.items():
            setattr(mesh.attributes, name, colour)


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
    own = [each for each in mesh.attributes if is_own(each, known)]
    if not (own or has_weights(mesh)) or not isinstance(made.chart, Chart):
        return None
    lengths = [mesh.attributes.get(name) for name in ("arc_length", "v")]
    if any(each is None or (each.data_type, each.domain) != ("FLOAT", "POINT") for each in lengths):
        return None
    found = sources(*map(read, lengths), made.chart)
    return None if found is None else Carried(mesh, own, found, made.topology)


def is_own(attribute, known):
    """Whether somebody has made an attribute that can be carried: no UV map, whose seams no vertex knows."""
    if attribute.is_internal or attribute.is_required or attribute.name in known or attribute.domain == "EDGE":
        return False
    return attribute.data_type in ARRAYS and (attribute.data_type, attribute.domain) != ("FLOAT2", "CORNER")


def has_weights(mesh):
    """Whether a mesh may have weights: an object of it has groups for them."""
    return any(ob.data == mesh and ob.vertex_groups for ob in bpy.data.objects)


def read(attribute):
    """The values of an attribute: (n,) or (n, k) array."""
    name, width, dtype = ARRAYS[attribute.data_type]
    values = np.empty(width * len(attribute.data), dtype)
    attribute.data.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def corners_and_faces(mesh, found, topology):
    """The old corner that each new corner comes from, and the old face of each new one: (c,), (f,) int arrays.

    A corner comes from one of the old vertex, in a face that lies on the same side of it.
    """
    starts, cap = np.empty(len(mesh.polygons), np.int32), np.empty(len(mesh.polygons), np.int32)
    mesh.polygons.foreach_get("loop_start", starts)
    mesh.polygons.foreach_get("material_index", cap)
    corners = read(mesh.attributes[".corner_vert"])
    face, kind = kinds(np.append(starts, len(corners)), cap)
    table = np.full((len(mesh.vertices), CAP + 1), -1)
    table[corners, kind] = np.arange(len(corners))
    table = np.where(table < 0, table.max(axis=1, keepdims=True), table)
    _, kind = kinds(topology.offsets, topology.material)
    corner = table[found[topology.corners], kind]
    return corner, face[corner[topology.offsets[:-1]]]


def kinds(offsets, material):
    """The face of each corner, and which corner of it that is, or `CAP`."""
    face = np.repeat(np.arange(len(material)), np.diff(offsets))
    place = np.arange(len(face)) - offsets[face]
    return face, np.where(material[face] > 0, CAP, np.minimum(place, SIDES - 1))
