# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Select the operand of a step, so that it can be moved."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnStep

trees = later("bridge.trees")


class OBJECT_OT_sweep_step_select(OnStep, Operator):
    """Select the operand alone, to move it"""

    bl_idname = "object.sweep_step_select"
    bl_label = "Select Operand"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        operand = trees.operand_of(found[1])
        if operand is None or operand.name not in context.view_layer.objects:
            self.report({"ERROR"}, "The operand was deleted, or its collection is not in this view layer")
            return {"CANCELLED"}
        for ob in context.selected_objects:
            ob.select_set(False)
        operand.hide_set(False)
        operand.select_set(True)
        context.view_layer.objects.active = operand
        return {"FINISHED"}
