# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done with a whole tree: choose its solver, duplicate it, make it one mesh, its operands or one shape."""

from bpy.types import Operator

from ..sweep_addon.core.declared.parameters import ShapeError
from ..sweep_addon.core.later import later
from .on_tree import OnTree

conversion, copies = later("bridge.conversion"), later("bridge.copies")
operands, solvers, trees = later("bridge.operands"), later("bridge.solvers"), later("bridge.trees")


class OBJECT_OT_sweep_tree_choose_solver(OnTree, Operator):
    """Use the manifold solver where all operands are closed, else the exact one; make solid what meets itself"""

    bl_idname = "object.sweep_tree_choose_solver"
    bl_label = "Choose Solver"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        united = list(map(solvers.unite, trees.operands(context.active_object)))
        parts = solvers.parts(context.active_object)
        ask = (solvers.make_solid, solvers.choose, solvers.lost_faces)
        told = [of_part(part) for of_part in ask for part in parts]
        for sentence in dict.fromkeys(filter(None, united + told)):
            self.report({"WARNING"}, sentence)
        return {"FINISHED"}


class OBJECT_OT_sweep_tree_duplicate(OnTree, Operator):
    """Copy the tree with its operands; a copy of the result alone would share them"""

    bl_idname = "object.sweep_tree_duplicate"
    bl_label = "Duplicate Tree"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        made = copies.duplicate(context.active_object)
        for ob in context.selected_objects:
            ob.select_set(False)
        made.select_set(True)
        context.view_layer.objects.active = made
        return {"FINISHED"}


class OBJECT_OT_sweep_tree_collapse(OnTree, Operator):
    """Keep the mesh as it is shown, and remove the operands that nothing else is made from"""

    bl_idname = "object.sweep_tree_collapse"
    bl_label = "Collapse"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        operands.collapse(context.active_object)
        return {"FINISHED"}


class OBJECT_OT_sweep_tree_take_apart(OnTree, Operator):
    """Make the tree its operands again, each where it stands, and their operands too"""

    bl_idname = "object.sweep_tree_take_apart"
    bl_label = "Take Apart"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        operands.take_apart(context.active_object)
        return {"FINISHED"}


class OBJECT_OT_sweep_tree_evaluate(OnTree, Operator):
    """Make the active tree of extrusions one extruded outline of lines and arcs"""

    bl_idname = "object.sweep_tree_evaluate"
    bl_label = "Evaluate"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        try:
            conversion.to_sweep(context.active_object)
        except ShapeError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


OPERATORS = (
    OBJECT_OT_sweep_tree_choose_solver,
    OBJECT_OT_sweep_tree_duplicate,
    OBJECT_OT_sweep_tree_collapse,
    OBJECT_OT_sweep_tree_take_apart,
    OBJECT_OT_sweep_tree_evaluate,
)
