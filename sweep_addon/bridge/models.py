# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mesh objects of a Blender scene as triangles."""

import bpy
import numpy as np

from ..core.declared.parameters import ShapeError, require
from ..core.solids import Triangles


def triangles(ob, depsgraph=None, scaled=True):
    """The faces of a mesh object as they are shown, its modifiers applied, in its own space.

    Parameters
    ----------
    ob : bpy.types.Object
    depsgraph : bpy.types.Depsgraph, optional
    scaled : bool
        Whether they are scaled as the object is.

    Returns
    -------
    Triangles

    Raises
    ------
    ShapeError
        Where there is no face.
    """
    if is_as_shown(ob):
        vertices, faces = arrays(ob.data, ob)
    else:
        shown = ob.evaluated_get(depsgraph or bpy.context.evaluated_depsgraph_get())
        try:
            vertices, faces = arrays(shown.to_mesh(), ob)
        finally:
            shown.to_mesh_clear()
    scale = np.array(ob.scale, dtype=float) if scaled else np.ones(3)
    faces = faces.reshape(-1, 3)[:, :: 1 if scale.prod() > 0 else -1]
    used, faces = np.unique(faces, return_inverse=True)  # loose vertices are no part of a surface
    return Triangles(vertices.reshape(-1, 3)[used] * scale, faces.reshape(-1, 3))


def is_as_shown(ob):
    """Whether a mesh is shown as its data are: nothing deforms it, nothing moves its keys, and nobody edits it."""
    moved = ob.modifiers or ob.data.shape_keys or ob.data.animation_data or ob.parent_type not in ("OBJECT", "BONE")
    return not moved and not ob.data.is_editmode


def arrays(mesh, ob):
    """The vertices (3 n,) float32 and the triangles (3 t,) int32 of the mesh of an object."""
    mesh.calc_loop_triangles()
    require(len(mesh.loop_triangles), "must be a mesh with faces", ob.name)
    vertices, faces = np.empty(3 * len(mesh.vertices), np.float32), np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.attributes["position"].data.foreach_get("vector", vertices)
    mesh.loop_triangles.foreach_get("vertices", faces)
    return vertices, faces


def require_apart(mesh, ob):
    """Refuse an input object that is made from the mesh itself, by way of others too."""
    from .objects import inputs, is_sweep  # which read models
    from .trees import operands

    todo, seen = [ob], set()
    while todo:
        other = todo.pop()
        if other.type != "MESH" or other in seen:
            continue
        if other.data.original == mesh.original:
            raise ShapeError(f"must not be made from this sweep, as {ob.name!r} is")
        seen.add(other)
        todo += operands(other)
        todo += filter(None, inputs(other.data).values()) if is_sweep(other) else ()  # but what was deleted
