# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Take a step out of a tree: its operand is an object like others again."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnStep

operands = later("bridge.operands")


class OBJECT_OT_sweep_step_extract(OnStep, Operator):
    """Take the step out of the tree; its operand stays where it is, shown and rendered again"""

    bl_idname = "object.sweep_step_extract"
    bl_label = "Extract"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        operands.extract(*found)
        return {"FINISHED"}
