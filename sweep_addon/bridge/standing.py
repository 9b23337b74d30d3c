# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plain meshes that were sweeps stand by themselves: what carried one may be deleted, and nothing jumps."""

import bpy

from . import objects


def let_stand(meshes):
    """Let the objects of some sweeps go from the inputs that carry them, and stay where they are.

    They are children of what carried the input instead. One that moves by itself keeps them.
    """
    for ob in bpy.data.objects:
        if ob.data in meshes:
            let_go(ob, set(objects.inputs(ob.data).values()))


def let_go(ob, inputs):
    """Take an object out of the space of whichever of some objects carries it."""
    place, carrier = ob.matrix_world.copy(), ob.parent
    constraints = [each for each in ob.constraints if each.type == "CHILD_OF" and is_still(each.target, inputs)]
    for constraint in constraints:
        ob.constraints.remove(constraint)
    still = is_still(carrier, inputs)
    if still:
        ob.parent, ob.parent_type, ob.parent_bone = carrier.parent, carrier.parent_type, carrier.parent_bone
    if still or constraints:
        ob.matrix_world = place


def is_still(carrier, inputs):
    """Whether it is one of some objects, and neither keyframes, drivers nor constraints move it."""
    return carrier in inputs and not (carrier.animation_data or carrier.constraints)
