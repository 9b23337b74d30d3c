# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Duplicate a tree with all that it is made from."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnTree

copies = later("bridge.copies")


class OBJECT_OT_sweep_tree_duplicate(OnTree, Operator):
    """Copy the tree with its operands; a copy of the result alone would share them"""

    bl_idname = "object.sweep_tree_duplicate"
    bl_label = "Duplicate Tree"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        made = copies.duplicate(context.active_object)
        for ob in context.selected_objects:
            ob.select_set(False)
        made.select_set(True)
        context.view_layer.objects.active = made
        return {"FINISHED"}
