# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep what is selected: a curve or a mesh along another curve, or a ball over a mesh; the new object follows them."""

from bpy.props import BoolProperty, EnumProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from ..sweep_addon.properties.sweep import TABLE

kinds, objects, placing = later("core.shapes.kinds"), later("bridge.objects"), later("bridge.placing")
parameters, summary = later("core.declared.parameters", "parameters"), later("core.declared.wording", "summary")

PART = 20  # of the size of a mesh or a curve is the radius of its offset, to begin with
TYPES = {"MESH", "CURVE", "FONT"}  # which have offsets


class OBJECT_OT_sweep_selected(Operator):
    """Sweep the active curve, text or mesh along the other selected curve, or a circle along the only one"""

    bl_idname = "object.sweep_selected"
    bl_label = "Sweep Selected"
    bl_options = {"REGISTER", "UNDO"}

    shape: EnumProperty(
        name="Shape",
        description="What becomes of the selected objects",
        items=TABLE["along_curves"],
        default="GENERALIZED_CYLINDER",
    )
    swap: BoolProperty(name="Swap", description="Let the active curve be the trajectory and the other the contour")

    @classmethod
    def description(cls, context, properties):
        shape = objects.SHAPE[properties.shape]
        if "contour" not in {p.name for p in parameters(shape)}:
            return f"{objects.title(shape)} along the active curve. {summary(shape)}"
        if objects.carrier(shape) == "trajectory":
            return cls.__doc__
        return f"{objects.title(shape)} of the active curve or text. {summary(shape)}"

    @classmethod
    def poll(cls, context):
        chosen = inputs(context) if context.mode == "OBJECT" else []
        if len(chosen) == 1 and not meshes(chosen):
            return True
        if active_of_two(context, chosen) and any(ob.type == "CURVE" for ob in chosen):
            return True
        cls.poll_message_set("Select a curve to sweep along, or two: what moves active, the trajectory with it")
        return False

    def execute(self, context):
        shape = objects.SHAPE[self.shape]
        if meshes(inputs(context)):
            shape = kinds.GeneralSweep  # what moves a mesh
        carrier = objects.carrier(shape)
        moved = {"contour", "generator"}.intersection(p.name for p in parameters(shape) if p.accepts)
        given = roles(context, self.swap, *moved) if carrier == "trajectory" and moved else {carrier: active(context)}
        try:
            mesh = objects.new_mesh(objects.suited(shape, given), objects.title(shape), **given)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        placing.place_along(context, mesh, given[carrier])
        return {"FINISHED"}


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
            sides = (max(places) - min(places) for places in zip(*ob.bound_box, strict=True))
            size = max(sides)  # not scaled, as the offset is
            shape = kinds.OffsetSurface(radius=(size or 1.0) / PART)
            mesh = objects.new_mesh(shape, objects.title(kinds.OffsetSurface), body=ob)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        placing.place_along(context, mesh, ob)
        return {"FINISHED"}


def inputs(context):
    """The selected curves, texts and meshes."""
    return [ob for ob in context.selected_objects if ob.type in {"CURVE", "FONT", "MESH"}]


def meshes(chosen):
    return [ob for ob in chosen if ob.type == "MESH"]


def active_of_two(context, chosen):
    """Whether there are two, of which one is active."""
    return len(chosen) == 2 and context.view_layer.objects.active in chosen


def active(context):
    """The active one of the selected objects, or the only one."""
    chosen, active = inputs(context), context.view_layer.objects.active
    return active if active in chosen else chosen[0]


def roles(context, swap, moves):
    """Which selected object is the trajectory, and which, if any, is what moves along it, a parameter of that name."""
    chosen = sorted(inputs(context), key=lambda ob: ob == context.view_layer.objects.active)
    if len(chosen) == 1:
        return {"trajectory": chosen[0]}
    trajectory, moving = chosen
    if trajectory.type != "CURVE" or swap and moving.type == "CURVE":  # a text or a mesh has no length to move along
        trajectory, moving = moving, trajectory
    return {"trajectory": trajectory, moves: moving}
