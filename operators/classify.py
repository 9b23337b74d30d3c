# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tell which vertices of a mesh are in a sweep or a tree, or where the cursor is."""

from bpy.props import FloatProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from .combine import others

membership, objects = later("bridge.membership"), later("bridge.objects")

PLACES = {1: "in", 0: "on", -1: "out of"}


class OBJECT_OT_sweep_classify(Operator):
    """Tell which vertices of the other selected meshes are in the active sweep or tree, or whether the cursor is"""

    bl_idname = "object.sweep_classify"
    bl_label = "Classify"
    bl_options = {"REGISTER", "UNDO"}

    tolerance: FloatProperty(
        name="Tolerance",
        description="The distance from the boundary within which a point is on it; 0 is a millionth of the size",
        unit="LENGTH",
        min=0.0,
        precision=6,
    )

    @classmethod
    def poll(cls, context):
        if context.mode != "OBJECT":
            cls.poll_message_set("Go back to Object Mode first")
        elif not objects.is_made(context.active_object):
            cls.poll_message_set("Make a sweep or a tree the active object")
        elif not all(ob.data.is_editable for ob in others(context)):
            cls.poll_message_set("A selected mesh is linked from another file: make it local to write on it")
        else:
            return True
        return False

    def execute(self, context):
        ob, chosen = context.active_object, others(context)
        context.view_layer.update()
        try:
            if chosen:
                found = [membership.of_mesh(ob, other, self.tolerance) for other in chosen]
            else:
                found = membership.of_points(ob, [context.scene.cursor.location], self.tolerance)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        if not chosen:
            self.report({"INFO"}, f"The cursor is {PLACES[int(found[0])]} {ob.name!r}")
            return {"FINISHED"}
        counts = {word: sum(int((part == value).sum()) for part in found) for value, word in PLACES.items()}
        told = ", ".join(f"{count:,} {word}" for word, count in counts.items())
        self.report({"INFO"}, f"Of {sum(counts.values()):,} vertices {told} {ob.name!r}")
        if context.space_data and context.space_data.type == "VIEW_3D":
            context.space_data.shading.color_type = "VERTEX"
        return {"FINISHED"}
