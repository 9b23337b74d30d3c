# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turn a contour or trajectory that is numbers into a curve object that can be edited."""

from bpy.props import EnumProperty
from bpy.types import Operator

from ..sweep_addon.bridge import curves, objects
from ..sweep_addon.core.parameters import ShapeError, parameters

EDITABLE = {"trajectory": "The path along which the contour moves", "contour": "The outline that moves"}


class OBJECT_OT_sweep_edit_as_curve(Operator):
    """Make a curve object of the contour or trajectory, which the sweep then follows"""

    bl_idname = "object.sweep_edit_as_curve"
    bl_label = "Edit as Curve"
    bl_options = {"REGISTER", "UNDO"}

    parameter: EnumProperty(
        name="Parameter",
        description="What becomes a curve",
        items=[(name, name.title(), doc) for name, doc in EDITABLE.items()],
    )

    @classmethod
    def poll(cls, context):
        if objects.is_editable_sweep(context.active_object):
            return True
        cls.poll_message_set("Make a sweep the active object whose mesh is not linked from another file")
        return False

    def execute(self, context):
        ob = context.active_object
        shape, _ = objects.group_of(ob.data)
        if self.parameter not in [p.name for p in parameters(shape)]:
            self.report({"ERROR"}, f"The {objects.title(shape).lower()} has no {self.parameter}")
            return {"CANCELLED"}
        curve = objects.inputs(ob.data).get(self.parameter)
        if curve:
            self.report({"ERROR"}, f"The {self.parameter} is the object {curve.name!r} already: edit that")
            return {"CANCELLED"}
        if self.parameter == objects.carrier(shape) and ob.animation_data:
            self.report({"ERROR"}, f"The object {ob.name!r} is animated: clear its animation first, the curve moves it")
            return {"CANCELLED"}
        try:
            value = getattr(objects.from_object(ob), self.parameter)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        make = curves.from_trajectory if self.parameter == "trajectory" else curves.from_contour
        curve = objects.link(context, make(value, f"{ob.name} {self.parameter.title()}"))
        objects.use(ob, self.parameter, curve)
        return {"FINISHED"}
