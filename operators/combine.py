# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Combine the selected meshes by a set operation: one operator for each, all made from the operations' names."""

from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from .on_active import can_change

objects, operands, trees = later("bridge.objects"), later("bridge.operands"), later("bridge.trees")

DOES = {  # as core.csg names the operations, which enabling the extension need not import
    "union": "Add the other selected meshes to the active one",
    "intersection": "Keep of the active mesh what is in all other selected ones too",
    "difference": "Take the other selected meshes from the active one",
}


class Combine:
    """What the operators have in common; each names its operation"""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        chosen = others(context)
        if not can_change(cls, context):
            return False
        if context.active_object.type != "MESH" or not chosen:
            cls.poll_message_set("Select the tools, then the mesh that is to stay, which becomes active")
        elif not all(ob.is_editable for ob in chosen):
            cls.poll_message_set("A selected mesh is linked from another file: make it local to change it")
        else:
            return True
        return False

    def execute(self, context):
        result, chosen = context.active_object, others(context)
        try:
            told = operands.combine(result, chosen, self.operation)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        for ob in chosen:
            ob.select_set(False)
        result.select_set(True)
        count = len(trees.operands(result))
        said = told or (f"{count} operand{'s' if count > 1 else ''}, manifold solver",)
        self.report({"WARNING"} if told else {"INFO"}, " ".join(said))
        return {"FINISHED"}


def others(context):
    """The selected meshes but the active object, by their names: nobody knows which was selected first."""
    chosen = (ob for ob in context.selected_objects if ob.type == "MESH" and ob != context.active_object)
    return sorted(chosen, key=lambda ob: ob.name)


def combine_operator(name):
    """The operator of one set operation."""
    members = {
        "__doc__": f"{DOES[name]}, which stays what it is and live",
        "bl_idname": f"object.sweep_{name}",
        "bl_label": name.title(),
        "operation": name,
    }
    return type(f"OBJECT_OT_sweep_{name}", (Combine, Operator), members)


OPERATORS = tuple(map(combine_operator, DOES))
