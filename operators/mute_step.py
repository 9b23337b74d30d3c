# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Leave a step of a tree out, in the view and in renders, or do it again."""

from bpy.types import Operator

from .on_tree import OnStep


class OBJECT_OT_sweep_step_mute(OnStep, Operator):
    """Leave the step out, in renders too, or do it again"""

    bl_idname = "object.sweep_step_mute"
    bl_label = "Mute Step"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        modifier = found[1]
        modifier.show_viewport = modifier.show_render = not modifier.show_viewport
        return {"FINISHED"}
