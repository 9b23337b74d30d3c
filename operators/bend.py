# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bend meshes along the active sweep, as its curved axis transforms a straight model."""

from bpy.props import BoolProperty, EnumProperty, FloatProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later

bent, objects, placing = later("bridge.bent"), later("bridge.objects"), later("bridge.placing")


class OBJECT_OT_sweep_bend(Operator):
    """Bend a copy of each selected mesh along the active PD curve sweep, by the same frames"""

    bl_idname = "object.sweep_bend"
    bl_label = "Bend Selected Along"
    bl_options = {"REGISTER", "UNDO"}

    axis: EnumProperty(
        name="Along",
        description="The mesh's own axis that becomes the curved one",
        items=[("X", "X", "Its x axis"), ("Y", "Y", "Its y axis"), ("Z", "Z", "Its z axis")],
        default="Z",
    )
    fit: BoolProperty(
        name="Fit", description="Stretch the mesh along its axis from the start to the end of the trajectory"
    )
    start: FloatProperty(
        name="Start", description="How far along the trajectory the mesh's own origin stands", unit="LENGTH"
    )

    @classmethod
    def poll(cls, context):
        if models(context) and can_bend(context.active_object):
            return True
        cls.poll_message_set("Select meshes, and make a PD curve sweep the active object")
        return False

    def execute(self, context):
        sweep, depsgraph = context.active_object, context.evaluated_depsgraph_get()
        made = []
        try:
            shape = objects.shapes(sweep.data)[0]
            for model in models(context):
                made.append(bent.mesh(model, shape, "XYZ".index(self.axis), self.start, self.fit, depsgraph))
        except ShapeError as error:
            bent.remove(made)
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for mesh in made:
            ob = placing.link(context, mesh)
            ob.parent, ob.matrix_world = sweep.parent, sweep.matrix_world
        return {"FINISHED"}


def models(context):
    """The selected meshes that are not the sweep itself."""
    return [ob for ob in context.selected_objects if ob.type == "MESH" and ob != context.active_object]


def can_bend(ob):
    """Whether an object is a sweep that bends what is straight."""
    return objects.is_sweep(ob) and hasattr(objects.group_of(ob.data)[0], "bend")
