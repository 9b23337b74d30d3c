# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Take an extruded sweep apart into the primitives that it is made of."""

from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from .on_active import can_change

conversion, kinds, objects = later("bridge.conversion"), later("core.shapes.kinds"), later("bridge.objects")


class OBJECT_OT_sweep_convert_to_csg(Operator):
    """Make the active extruded sweep a live tree of blocks, wedges, cylinders, fillets and the like"""

    bl_idname = "object.sweep_convert_to_csg"
    bl_label = "Convert to CSG"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if not can_change(cls, context):
            return False
        ob = context.active_object
        if objects.is_editable_sweep(ob) and objects.group_of(ob.data)[0] is kinds.TranslationalSweep:
            return True
        cls.poll_message_set("Make a translational sweep the active object")
        return False

    def execute(self, context):
        ob = context.active_object
        try:
            conversion.to_tree(ob)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        count = conversion.primitives(ob)
        self.report({"INFO"}, f"{count} primitive{'' if count == 1 else 's'}")
        return {"FINISHED"}
