# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where objects of sweeps stand: in the collection a person works in, and in the space of what they follow."""

import bpy


def link(context, data):
    """A new object of some data in the collection a person works in, at the scene's origin."""
    ob = bpy.data.objects.new(data.name, data)
    context.collection.objects.link(ob)
    return ob


def place_along(context, mesh, followed):
    """A new active object of a mesh, in the space of the trajectory or contour that it follows."""
    ob = link(context, mesh)
    attach(ob, followed)
    for other in context.selected_objects:
        other.select_set(False)
    ob.select_set(True)
    context.view_layer.objects.active = ob
    return ob


def attach(ob, followed):
    """Put an object into the space of a curve, text or mesh, where its mesh is.

    Blender puts a child of a curve with *Path Animation*, which every curve of its Add menu has, at the path's start.
    A path that nothing follows is switched off; where something may, the object is constrained and not parented.
    """
    curve = followed.data
    if not hasattr(curve, "use_path"):
        ob.parent = followed
        return
    if curve.use_path and (curve.animation_data or is_followed(followed)):
        constraint = ob.constraints.new("CHILD_OF")
        constraint.target = followed
        constraint.inverse_matrix.identity()
        return
    curve.use_path = False
    ob.parent = followed


def is_followed(curve):
    """Whether another object is a child of a curve, or follows it as a path."""
    users = bpy.data.user_map(subset={curve}, value_types={"OBJECT"})[curve]
    return any(ob != curve for ob in users)
