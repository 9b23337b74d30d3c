# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Move a step of a tree up or down: steps are done in their order."""

from bpy.props import EnumProperty
from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnStep

trees = later("bridge.trees")


class OBJECT_OT_sweep_step_move(OnStep, Operator):
    """Do the step earlier or later"""

    bl_idname = "object.sweep_step_move"
    bl_label = "Move Step"
    bl_options = {"REGISTER", "UNDO"}

    direction: EnumProperty(
        name="Direction",
        description="Where the step goes",
        items=[("UP", "Up", "Before the step above it"), ("DOWN", "Down", "After the step below it")],
    )

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        owner, modifier = found
        steps = trees.booleans(owner)
        place = steps.index(modifier) + (-1 if self.direction == "UP" else 1)
        if not 0 <= place < len(steps):
            return {"CANCELLED"}
        stack = list(owner.modifiers)
        owner.modifiers.move(stack.index(modifier), stack.index(steps[place]))
        return {"FINISHED"}
