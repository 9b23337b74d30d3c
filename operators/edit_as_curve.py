# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turn a contour, body, trajectory or direction that is numbers into a curve object that can be edited; go to one."""

import bpy
from bpy.props import EnumProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.names import spelled
from ..sweep_addon.core.declared.refusals import ShapeError, require
from ..sweep_addon.core.later import later
from .on_active import OnSweep

beside, drawn_curves = later("bridge.beside"), later("bridge.drawn_curves")
objects, placing = later("bridge.objects"), later("bridge.placing")
parameters = later("core.declared.parameters", "parameters")

EDITABLE = {
    "trajectory": "The path along which the contour moves",
    "contour": "The outline that moves",
    "body": "The outline along which a disc moves; a solid is no curve",
    "direction": "A guide beside the path, to which the contour's x axis points; the path becomes a curve first",
}


class OBJECT_OT_sweep_edit_as_curve(OnSweep, Operator):
    """Make a curve of the contour, trajectory, direction or body, which the sweep then follows; edit what is a curve"""

    bl_idname = "object.sweep_edit_as_curve"
    bl_label = "Edit as Curve"
    bl_options = {"REGISTER", "UNDO"}

    parameter: EnumProperty(
        name="Parameter",
        description="What becomes a curve",
        items=[(name, name.title(), doc) for name, doc in EDITABLE.items()],
    )

    def execute(self, context):
        ob = context.active_object
        shape, _ = objects.group_of(ob.data)
        if self.parameter not in [p.name for p in parameters(shape)]:
            self.report({"ERROR"}, f"The {objects.title(shape).lower()} has no {self.parameter}")
            return {"CANCELLED"}
        curve = objects.inputs(ob.data).get(self.parameter)
        if curve:
            return self.go_to(context, curve)
        made = [self.parameter]
        if self.parameter == "direction" and "trajectory" not in objects.inputs(ob.data):
            made.insert(0, "trajectory")
        if objects.carrier(shape) in made and ob.animation_data:
            self.report({"ERROR"}, f"The object {ob.name!r} is animated: clear its animation first, the curve moves it")
            return {"CANCELLED"}
        try:
            value = objects.shapes(ob.data)[0]
            drawn = [MAKERS[name](value, f"{ob.name} {name.title()}") for name in made]
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for name, curve in zip(made, drawn, strict=True):
            objects.use(ob, name, placing.link(context, curve))
        return {"FINISHED"}

    def go_to(self, context, ob):
        """Edit an object that is the parameter already, and which is hard to click where the sweep lies round it.

        An empty has nothing to edit: it is to be moved. A sweep is edited by its parameters: what is done to its mesh
        is lost when they change.
        """
        sentence = f"The {self.parameter} is the object {ob.name!r}"
        if ob.library or ob.data and ob.data.library:
            self.report({"ERROR"}, f"{sentence}, which is linked from another file: make it local to edit it")
            return {"CANCELLED"}
        if not ob.visible_get():
            self.report({"ERROR"}, f"{sentence}, which is not visible: show it to edit it")
            return {"CANCELLED"}
        bpy.ops.object.mode_set(mode="OBJECT")
        for other in context.selected_objects:
            other.select_set(False)
        ob.select_set(True)
        context.view_layer.objects.active = ob
        if ob.data and not objects.is_sweep(ob):
            bpy.ops.object.mode_set(mode="EDIT")
        return {"FINISHED"}


def contour_of(shape):
    """The contour whose offset a shape is."""
    require(shape.is_plane, "must be a contour to become a curve", spelled(type(shape.body)), "body")
    return shape.body


MAKERS = {
    "trajectory": lambda shape, name: drawn_curves.from_trajectory(shape.trajectory, name),
    "contour": lambda shape, name: drawn_curves.from_contour(shape.contour, name),
    "body": lambda shape, name: drawn_curves.from_contour(contour_of(shape), name),
    "direction": lambda shape, name: drawn_curves.from_trajectory(beside.guide(shape), name),
}
