# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Take a tree apart into its operands."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnTree

operands = later("bridge.operands")


class OBJECT_OT_sweep_tree_take_apart(OnTree, Operator):
    """Make the tree its operands again, each where it stands, and their operands too"""

    bl_idname = "object.sweep_tree_take_apart"
    bl_label = "Take Apart"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        operands.take_apart(context.active_object)
        return {"FINISHED"}
