# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turn tubes that Blender draws along curves into sweeps."""

import bpy
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later

bevel, curve_to_mesh = later("bridge.bevel"), later("bridge.curve_to_mesh")
objects, placing = later("bridge.objects"), later("bridge.placing")


class OBJECT_OT_sweep_convert(Operator):
    """Make a live sweep of the bevel of each selected curve, or of its Curve to Mesh nodes; the curve stays its path"""

    bl_idname = "object.sweep_convert"
    bl_label = "Convert to Sweep"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        if context.mode == "OBJECT" and is_tube(context.active_object):
            return True
        cls.poll_message_set("Make a curve with a bevel, or an object with a Curve to Mesh node, the active object")
        return False

    def execute(self, context):
        sources = [context.active_object, *(ob for ob in context.selected_objects if ob != context.active_object)]
        made = []
        try:
            for source in filter(is_tube, sources):
                tube = (curve_to_mesh if curve_to_mesh.modifier_of(source) else bevel).tube(source)
                made.append((tube, objects.new_mesh(tube.shape, f"{source.name} Sweep", **tube.objects)))
        except ShapeError as error:
            bpy.data.batch_remove([mesh for _, mesh in made])
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        sweeps = [placed(context, tube, mesh) for tube, mesh in made]
        for ob in (*context.selected_objects, *sweeps):
            ob.select_set(ob in sweeps)
        context.view_layer.objects.active = sweeps[0]
        return {"FINISHED"}


def is_tube(ob):
    """Whether Blender draws an object as a tube along a curve."""
    editable = ob is not None and ob.is_editable and (ob.data is None or ob.data.is_editable)
    return editable and (bevel.is_bevelled(ob) or curve_to_mesh.modifier_of(ob) is not None)


def placed(context, tube, mesh):
    """The object of a mesh where the tube was, which is drawn no more."""
    for slot in range(len(mesh.materials)):
        mesh.materials[slot] = tube.material
    ob = placing.link(context, mesh)
    tube.quiet()
    if tube.place.type == "CURVE":
        placing.attach(ob, tube.place)
    else:
        ob.parent = tube.place
    return ob
