# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Make a tree of extrusions the one extrusion that it is."""

from bpy.types import Operator

from ..sweep_addon.core.later import later
from ..sweep_addon.core.parameters import ShapeError
from .on_tree import OnTree

conversion = later("bridge.conversion")


class OBJECT_OT_sweep_tree_evaluate(OnTree, Operator):
    """Make the active tree of extrusions one extruded outline of lines and arcs"""

    bl_idname = "object.sweep_tree_evaluate"
    bl_label = "Evaluate"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            conversion.to_sweep(context.active_object)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}
