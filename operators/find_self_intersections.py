# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Find where a sweep meets itself, and select the faces that are there."""

import bpy
from bpy.types import Operator

from ..sweep_addon.core.declared.parameters import ShapeError
from ..sweep_addon.core.later import later

crossings, objects = later("bridge.crossings"), later("bridge.objects")
finding = later("properties.finding")


class OBJECT_OT_sweep_find_self_intersections(Operator):
    """Find where the active sweep meets itself, and up to which size it does not"""

    bl_idname = "object.sweep_find_self_intersections"
    bl_label = "Find Self-Intersections"
    bl_options = {"REGISTER"}

    @classmethod
    def poll(cls, context):
        return is_ready(cls, context)

    def execute(self, context):
        told = finding.find(context.active_object.data)
        for sentence in told:
            self.report({"WARNING"}, sentence)
        if not told:
            self.report({"INFO"}, "No self-intersection")
        return {"FINISHED"}


class OBJECT_OT_sweep_select_self_intersections(Operator):
    """Go to Edit Mode with the faces selected at which the active sweep meets itself"""

    bl_idname = "object.sweep_select_self_intersections"
    bl_label = "Select Faces"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not is_ready(cls, context):
            return False
        if context.active_object.data.sweep.edited:
            cls.poll_message_set("The mesh was changed by hand: its faces are others")
            return False
        return True

    def execute(self, context):
        try:
            count = crossings.select(context.active_object.data)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if not count:
            self.report({"INFO"}, "No self-intersection")
            return {"CANCELLED"}
        context.tool_settings.mesh_select_mode = (False, False, True)
        bpy.ops.object.mode_set(mode="EDIT")
        return {"FINISHED"}


def is_ready(operator, context):
    """Whether the active object is a sweep in Object Mode, made as its parameters say; if not, the operator says so."""
    ob = context.active_object
    if not objects.is_editable_sweep(ob):
        operator.poll_message_set("Select a sweep whose mesh is not linked from another file")
    elif not objects.is_swept(ob):
        operator.poll_message_set("The tubes of an L-system begin within each other: nobody asks where they meet")
    elif context.mode != "OBJECT":
        operator.poll_message_set("Go back to Object Mode first")
    elif ob.data.sweep.error:
        operator.poll_message_set("The shape cannot be made: see the sidebar")
    else:
        return True
    return False
