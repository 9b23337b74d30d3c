# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Move a ball over the active mesh, or a disc along the active curve: a new object, its offset, which follows it."""

from bpy.types import Operator

from ..sweep_addon.core.declared.parameters import ShapeError
from ..sweep_addon.core.later import later
from ..sweep_addon.core.shapes.offset_surface import OffsetSurface

objects = later("bridge.objects")

PART = 20  # of the size of a mesh or a curve is the radius, to begin with
TYPES = {"MESH", "CURVE", "FONT"}


class OBJECT_OT_sweep_offset_selected(Operator):
    """Make an offset surface of the active mesh, or of the area in the active curve or text, which it then follows"""

    bl_idname = "object.sweep_offset_selected"
    bl_label = "Offset Surface"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        ob = context.active_object
        if context.mode == "OBJECT" and ob and ob.type in TYPES and ob.select_get():
            return True
        cls.poll_message_set("Select a closed mesh, a curve or a text")
        return False

    def execute(self, context):
        ob = context.active_object
        try:
            size = max(
                max(places) - min(places) for places in zip(*ob.bound_box, strict=True)
            )  # not scaled, as the offset is
            shape = OffsetSurface(radius=(size or 1.0) / PART)
            mesh = objects.new_mesh(shape, objects.title(OffsetSurface), body=ob)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        objects.place_along(context, mesh, ob)
        return {"FINISHED"}
