# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of arrays written into Blender's, through attributes in the types that Blender stores.

Measured at 640,000 vertices: places alone 1 ms, where `vertices.foreach_set` takes 160; a new topology 70 ms, where
`from_pydata` takes 1,200.
"""

from threading import local

import bmesh
import bpy
import numpy as np

from ..core.later import later
from .face_offsets import write_face_offsets
from .own_arrays import Room, seen_array

carried = later("bridge.carried", "carried")

TEXTURE = "UVMap"
NAMES = (  # of what each key of a chart stands for
    (TEXTURE,),
    ("u", "arc_length", "radius"),
    ("v", "colour", "birth", "axis", "order", "organ", "size", "rotation", "depth", "line", "deviation"),
)
KNOWN = {TEXTURE, "sharp_edge", "sharp_face", "material_index", *NAMES[1], *NAMES[2]}  # no person's own
SAMPLE, SPARSE = 100_000, 128  # vertices looked at, all of them or so many
SAME = 1e-6  # of the size: hosts differ in the last bit


class Scratch(local):
    """Memory for one array that is soon forgotten; memory that is new takes longer to come by than to fill."""

    memory = np.empty(0, np.uint8)

    def array(self, size, dtype):
        """An array of any content that is good until the next is asked for in this thread."""
        needed = size * np.dtype(dtype).itemsize
        if not needed <= len(self.memory) <= 4 * needed:
            self.memory = np.empty(needed, np.uint8)
        return self.memory[:needed].view(dtype)


SCRATCH = Scratch()


def room_for_places(mesh):
    """Where the vertices of a mesh may be drawn that is written next: `Room` in it, or beside it."""
    return Room(mesh.attributes["position"].data, "vector", 3) if takes_arrays(mesh) and len(mesh.vertices) else None


def takes_arrays(mesh):
    """Whether `foreach_set` writes into a mesh: one of another file, or its override, it leaves without a word."""
    return mesh.is_editable and not mesh.override_library


def write(mesh, made, topology="", texture="", room=None):
    """Write a mesh of arrays into a Blender mesh, as little of it as differs.

    Parameters
    ----------
    mesh : bpy.types.Mesh
        Keeps its name, materials, animation and users.
    made : Mesh
    topology, texture : str
        What this function returned when the mesh was written before; what has not changed is not written again.
    room : Room, optional
        Where its vertices may have been drawn.

    Returns
    -------
    topology, texture : str
    mark : int
        What `mark` says of the mesh.
    """
    if not takes_arrays(mesh):
        return write_through(mesh, made)
    own = None
    values = np.ascontiguousarray(made.vertices, dtype=np.float32).ravel()
    count = len(mesh.vertices) == len(made.vertices) and len(mesh.loops) == len(made.corners)
    if not count or made.topology.sizes != topology.partition(".")[0]:
        values = values.copy() if room and room.holds(values) else values  # the mesh's own array will be another
        own = write_topology(mesh, made)
        room = None
        texture = ""
    elif made.topology.key != topology:
        for _ in range(2 if len(mesh.polygons) else 0):
            mesh.polygons[0].flip()  # there and back: Blender 4.5 forgets which faces it had found round each vertex
        write_joins(mesh, made.topology)
    if room and room.holds(values):
        mesh.vertices[0].co = values[:3]  # so that Blender knows that vertices have moved, and measures them again
    else:
        mesh.attributes["position"].data.foreach_set("vector", values)
    write_texture(mesh, made.chart, texture.split("|") if texture.count("|") == 2 else ("", "", ""))
    if own:
        own.lay_arrays(mesh)
    mesh.update()
    sample = values.reshape(-1, 3)[sampled(len(made.vertices))]
    return made.topology.key, "|".join(made.chart.keys), total(sample, len(made.vertices), len(made.corners))


def write_through(mesh, made):
    """Write into a mesh that takes no arrays: it takes a bmesh."""
    own = bpy.data.meshes.new(mesh.name)
    written = write(own, made)
    through = bmesh.new()
    through.from_mesh(own)
    through.to_mesh(mesh)
    through.free()
    bpy.data.meshes.remove(own)
    return written


def mark(mesh):
    """A number that changes when vertices are moved, by a tool or a script, and when faces come or go."""
    if not mesh.vertices:
        return 0  # a new mesh has no attributes yet
    places = mesh.attributes["position"].data
    held = seen_array(places, "vector", np.float32, 3)
    if held is None:
        held = np.empty(3 * len(places), np.float32)
        places.foreach_get("vector", held)
    return total(held.reshape(-1, 3)[sampled(len(places))], len(places), len(mesh.loops))


def sampled(count):
    """The vertices that are looked at, as a slice: all of them, or so many of a large mesh, evenly spread."""
    return slice(0, count, 1 if count <= SAMPLE else count // SPARSE)


def total(sample, vertices, corners):
    """The sum of the bits of coordinates; the remainder of an odd number, or the bits of signs would drop out."""
    return int(sample.ravel().view(np.uint32).sum(dtype=np.uint64) + vertices + corners) % (2**31 - 1)


def equal(mesh, made):
    """Whether a Blender mesh still has the places and corners of a mesh of arrays, whichever host made it."""
    if (len(mesh.vertices), len(mesh.loops)) != (len(made.vertices), len(made.corners)):
        return False
    places = np.empty(made.vertices.size, np.float32)
    corners = np.empty(len(made.corners), np.int32)
    mesh.attributes["position"].data.foreach_get("vector", places)
    mesh.attributes[".corner_vert"].data.foreach_get("value", corners)
    apart = np.abs(places - made.vertices.ravel()).max(initial=0.0)
    return bool(apart <= SAME * np.abs(made.vertices).max(initial=0.0) and (corners == made.corners).all())


def write_topology(mesh, made):
    """Replace all faces and edges; a mesh that a person has shaded flat stays so.

    Returns
    -------
    Carried or None
        What else people put on it, to be laid on it last.
    """
    topology, flat, own = made.topology, is_flat(mesh), carried(mesh, made, KNOWN)
    if own and own.has_weights:
        own.lay_vertices(mesh)
    else:
        empty = bmesh.new()  # clear_geometry() would delete the keyframes and drivers of the mesh
        empty.to_mesh(mesh)
        empty.free()
        mesh.vertices.add(len(made.vertices))
    mesh.edges.add(len(topology.edges))
    mesh.loops.add(len(topology.corners))
    mesh.polygons.add(len(topology.offsets) - 1)
    write_face_offsets(mesh, topology.offsets[:-1])
    write_joins(mesh, topology)
    attribute(mesh, "sharp_edge", "BOOLEAN", "EDGE").data.foreach_set("value", topology.sharp)
    attribute(mesh, "material_index", "INT", "FACE").data.foreach_set("value", topology.material)
    if flat:
        attribute(mesh, "sharp_face", "BOOLEAN", "FACE").data.foreach_set("value", np.ones(len(mesh.polygons), bool))
    return own


def is_flat(mesh):
    """Whether a mesh is shaded flat, all of it: Blender knows that of each face alone, and of none that is new."""
    sharp = mesh.attributes.get("sharp_face")
    if not is_of(sharp, "BOOLEAN", "FACE") or not len(sharp.data):
        return False
    values = np.empty(len(sharp.data), bool)
    sharp.data.foreach_get("value", values)
    return bool(values.all())


def write_joins(mesh, topology):
    """Replace the vertices that faces and edges join, as where a closed sweep's last ring leads to other points."""
    mesh.attributes[".edge_verts"].data.foreach_set("value", topology.edges.ravel())
    mesh.attributes[".corner_vert"].data.foreach_set("value", topology.corners)
    mesh.attributes[".corner_edge"].data.foreach_set("value", topology.corner_edges)


def write_texture(mesh, chart, known):
    """Replace texture coordinates and named attributes where they differ from the known ones.

    Parameters
    ----------
    mesh : bpy.types.Mesh
    chart : Chart
    known : sequence of str
        The keys of the chart that was written before, empty where there was none.
    """
    texture, along, across = (key if key != before else "" for key, before in zip(chart.keys, known, strict=True))
    if texture:
        layer = attribute(mesh, TEXTURE, "FLOAT2", "CORNER")
        room = Room(layer.data, "vector", 2, SCRATCH.array)
        room.fill(chart.uv(np.float32, room).ravel())
    held = kept(mesh, along, known[1]) if along else ()
    there = {name: mesh.attributes.get(name) for name in NAMES[1] if along and name not in held}
    rooms = {name: Room(own.data, "value", 1) for name, own in there.items() if is_of(own, "FLOAT", "POINT")}
    values = chart.along(np.float32, held, rooms) if along else {}
    values = {name: array for name, array in values.items() if name not in rooms or not rooms[name].holds(array)}
    values |= chart.across(np.float32) if across else {}
    for name, array in values.items():
        kind = "FLOAT" if array.ndim == 1 else "QUATERNION"
        attribute(mesh, name, kind, "POINT").data.foreach_set("value", array.ravel())
    for names, key, before in zip(NAMES, chart.keys, known, strict=True):
        for name in filter(mesh.attributes.get, names if before and not key else ()):
            mesh.attributes.remove(mesh.attributes[name])


def kept(mesh, key, before):
    """The attributes along that a mesh has already, where the key has a part for each that says so: their names."""
    parts = zip(NAMES[1], key.split(","), before.split(","), strict=False)
    same = (name for name, now, then in parts if now == then) if "," in key and "," in before else ()
    return tuple(name for name in same if is_of(mesh.attributes.get(name), "FLOAT", "POINT"))


def attribute(mesh, name, type, domain):
    """The attribute of that name and type, made anew where a person's own is in its way."""
    found = mesh.attributes.get(name)
    if found and not is_of(found, type, domain):
        mesh.attributes.remove(found)
        found = None
    return found or mesh.attributes.new(name, type, domain)


def is_of(attribute, type, domain):
    """Whether there is an attribute, and of that type and domain."""
    return attribute is not None and (attribute.data_type, attribute.domain) == (type, domain)
