# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plain meshes that were sweeps stand by themselves: what carried one may be deleted, and nothing jumps."""

import bpy
from mathutils import Matrix

from . import objects


def let_stand(meshes):
    """Let the objects of some sweeps go from the inputs that carry them, and stay where they are.

    They are children of what carried the input instead. One that moves by itself keeps them, and keeps those that do.
    """
    for ob in bpy.data.objects:
        if ob.data in meshes and not ob.animation_data:
            let_go(ob, set(objects.inputs(ob.data).values()) - {None})  # as one is that was deleted


def let_go(ob, inputs):
    """Take an object out of the space of whichever of some objects carries it."""
    constraints = [each for each in ob.constraints if each.type == "CHILD_OF" and is_still(each.target, inputs)]
    place = where(ob) if constraints else None
    for constraint in constraints:
        ob.constraints.remove(constraint)
    if is_still(ob.parent, inputs):
        hand_on(ob, ob.parent)
    if constraints and ob.visible_get():
        ob.matrix_world = place
    elif constraints:
        ob.matrix_basis = space_of(ob).inverted_safe() @ place


def where(ob):
    """Where an object is in the world.

    Of what is hidden, or in another scene, Blender does not know it: its own numbers, its parents' and those of what
    carries it by a whole *Child Of* do. Other constraints, and parents that are bones or vertices, do not count there.
    """
    if ob.visible_get():
        return ob.matrix_world.copy()
    place = space_of(ob) @ ob.matrix_basis
    for each in ob.constraints:
        if each.type == "CHILD_OF" and each.target and not each.mute:
            place = where(each.target) @ each.inverse_matrix @ place
    return place


def space_of(ob):
    """The space in the world in which an object's own numbers are."""
    return where(ob.parent) @ ob.matrix_parent_inverse if ob.parent else Matrix()


def hand_on(ob, carrier):
    """Make a child of an object one of its parent, where it is.

    Where that is their own numbers say: of what is hidden, or in another scene, Blender does not know it.
    """
    place = carrier.matrix_basis @ ob.matrix_parent_inverse @ ob.matrix_basis
    if carrier.parent:
        place = carrier.matrix_parent_inverse @ place
    ob.parent, ob.parent_type, ob.parent_bone = carrier.parent, carrier.parent_type, carrier.parent_bone
    ob.matrix_parent_inverse.identity()
    ob.matrix_basis = place


def is_still(carrier, inputs):
    """Whether it is one of some objects, and neither keyframes, drivers nor constraints move it."""
    return carrier in inputs and not (carrier.animation_data or carrier.constraints)
