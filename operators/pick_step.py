# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pick a step of a tree, whose operand's parameters the sidebar then shows."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnStep

trees = later("bridge.trees")


class OBJECT_OT_sweep_step_pick(OnStep, Operator):
    """Show the operand's parameters below"""

    bl_idname = "object.sweep_step_pick"
    bl_label = "Pick Step"
    bl_options = {"INTERNAL"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        trees.pick(context.active_object, *found)
        return {"FINISHED"}
