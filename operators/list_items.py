# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of the active shape, as the contours of its morph: add one more, take one out."""

from bpy.props import IntProperty, StringProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from .on_active import OnSweep

objects, rna = later("bridge.objects"), later("bridge.rna")
parameters, shown = later("core.declared.parameters", "parameters"), later("core.declared.wording", "shown")


class OBJECT_OT_sweep_item_add(OnSweep, Operator):
    """Add one more to a list of the active sweep"""

    bl_idname = "object.sweep_item_add"
    bl_label = "Add to a Sweep's List"
    bl_options = {"REGISTER", "UNDO", "INTERNAL"}

    parameter: StringProperty(name="Parameter", description="The list that is added to")

    def execute(self, context):
        sweep = context.active_object.data.sweep
        shape, group = objects.group_of(sweep.id_data)
        lists = {p.name: p for p in parameters(shape) if p.item}
        if self.parameter not in lists:
            self.report({"ERROR"}, f"The {objects.title(shape).lower()} has no list {shown(self.parameter)}")
            return {"CANCELLED"}
        p = lists[self.parameter]
        try:
            more = p.item.after(objects.shapes(sweep.id_data)[0])
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        with rna.at_once(sweep):
            rna.write(getattr(group, p.name).add(), parameters(p.item), more)
        return {"FINISHED"}


class OBJECT_OT_sweep_item_remove(OnSweep, Operator):
    """Take this out of the list"""

    bl_idname = "object.sweep_item_remove"
    bl_label = "Remove from a Sweep's List"
    bl_options = {"REGISTER", "UNDO", "INTERNAL"}

    parameter: StringProperty(name="Parameter", description="The list that something is taken out of")
    number: IntProperty(name="Number", description="Which of it, from 1", default=1, min=1)

    def execute(self, context):
        sweep = context.active_object.data.sweep
        shape, group = objects.group_of(sweep.id_data)
        known = self.parameter in [p.name for p in parameters(shape) if p.item]
        held = getattr(group, self.parameter) if known else ()
        if self.number > len(held):
            self.report({"ERROR"}, f"The {objects.title(shape).lower()} has no {self.parameter} {self.number}")
            return {"CANCELLED"}
        with rna.at_once(sweep):
            held.remove(self.number - 1)
        return {"FINISHED"}
