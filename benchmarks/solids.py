# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be said of a mesh in Blender as a solid: its volume, its open edges."""

import bmesh
import numpy as np

from bl_ext.user_default import sweep_addon as sw


def live(**parameters):
    """The mesh of a generalized cylinder as it lies in Blender."""
    return sw.to_object(sw.GeneralizedCylinder(**parameters)).data


def volumes(*meshes):
    """The volumes of Blender meshes, each first welded and turned outward: the best that can be said of it."""
    return [abs(examined(mesh, welded)[0]) for mesh in meshes]


def examined(mesh, repair=None):
    """The volume of a Blender mesh, and its edges of one face."""
    solid = bmesh.new()
    solid.from_mesh(mesh)
    if repair:
        repair(solid)
    found = sum(map(cone, solid.faces)), sum(edge.is_boundary for edge in solid.edges)
    solid.free()
    return found


def cone(face):
    """The volume between a face and the origin, bent quads halfway between the two ways to split them."""
    places = np.array([vertex.co for vertex in face.verts], float)
    middle = places.mean(axis=0)
    sides = places - middle
    return middle @ np.cross(sides, np.roll(sides, -1, axis=0)).sum(axis=0) / 6


def welded(solid):
    bmesh.ops.remove_doubles(solid, verts=solid.verts, dist=1e-6)
    bmesh.ops.recalc_face_normals(solid, faces=solid.faces)
