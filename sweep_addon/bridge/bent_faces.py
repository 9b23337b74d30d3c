# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bent faces of Blender meshes, cut before others cut them along diagonals that are all outside or all inside."""

import bmesh
import numpy as np

from ..core.meshes import facets


def cut_about_the_middle(mesh):
    """Cut the bent faces of four corners of a Blender mesh in four each, where there are any.

    Texture coordinates, attributes, materials and sharp edges go on as they are; what is new is between what was there.
    """
    vertices, corners = np.empty((len(mesh.vertices), 3), np.float32), np.empty(len(mesh.loops), np.int32)
    offsets = np.full(len(mesh.polygons) + 1, len(mesh.loops), np.int32)
    mesh.vertices.foreach_get("co", vertices.ravel())
    mesh.loops.foreach_get("vertex_index", corners)
    mesh.polygons.foreach_get("loop_start", offsets[:-1])
    bent, *_ = facets.bent_faces(vertices.astype(np.float64), corners, offsets)
    if not len(bent):
        return
    through = bmesh.new()
    through.from_mesh(mesh)
    through.faces.ensure_lookup_table()
    bmesh.ops.poke(through, faces=[through.faces[number] for number in bent.tolist()], center_mode="MEAN")
    through.to_mesh(mesh)
    through.free()
