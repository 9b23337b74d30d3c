# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep what is selected: one curve along another, or a circle along the only one."""

from bpy.props import BoolProperty
from bpy.types import Operator

from ..sweep_addon.bridge import objects
from ..sweep_addon.core.generalized_cylinder import GeneralizedCylinder
from ..sweep_addon.core.parameters import ShapeError


class OBJECT_OT_sweep_selected(Operator):
    """Sweep the active curve or text along the other selected curve, or a circle along the only one"""

    bl_idname = "object.sweep_selected"
    bl_label = "Sweep Selected"
    bl_options = {"REGISTER", "UNDO"}

    swap: BoolProperty(name="Swap", description="Let the active curve be the trajectory and the other the contour")

    @classmethod
    def poll(cls, context):
        chosen = inputs(context) if context.mode == "OBJECT" else []
        if any(ob.type == "CURVE" for ob in chosen) and (len(chosen) == 1 or active_of_two(context, chosen)):
            return True
        cls.poll_message_set("Select a curve to sweep along, or two: the contour active, the trajectory with it")
        return False

    def execute(self, context):
        given = roles(context, self.swap)
        try:
            mesh = objects.new_mesh(GeneralizedCylinder(), "Sweep", **given)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        objects.place_along(context, mesh, given["trajectory"])
        return {"FINISHED"}


def inputs(context):
    """The selected curves and texts."""
    return [ob for ob in context.selected_objects if ob.type in {"CURVE", "FONT"}]


def active_of_two(context, chosen):
    """Whether there are two, of which one is active."""
    return len(chosen) == 2 and context.view_layer.objects.active in chosen


def roles(context, swap):
    """Which selected object is the trajectory, and which, if any, the contour."""
    chosen = sorted(inputs(context), key=lambda ob: ob == context.view_layer.objects.active)
    if len(chosen) == 1:
        return {"trajectory": chosen[0]}
    trajectory, contour = chosen
    if trajectory.type == "FONT" or swap and contour.type != "FONT":  # a text has no length to move along
        trajectory, contour = contour, trajectory
    return {"trajectory": trajectory, "contour": contour}
