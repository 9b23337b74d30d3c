# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make a tree an ordinary mesh."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnTree

operands = later("bridge.operands")


class OBJECT_OT_sweep_tree_collapse(OnTree, Operator):
    """Keep the mesh as it is shown, and remove the operands that nothing else is made from"""

    bl_idname = "object.sweep_tree_collapse"
    bl_label = "Collapse"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        operands.collapse(context.active_object)
        return {"FINISHED"}
