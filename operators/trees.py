# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done with a tree of set operations, and with one step of it."""

from bpy.props import EnumProperty
from bpy.types import Operator

from ..sweep_addon.core.declared.refusals import ShapeError
from ..sweep_addon.core.later import later
from .on_active import OnStep, OnTree

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


class OBJECT_OT_sweep_step_pick(OnStep, Operator):
    """Show the operand's parameters below"""

    bl_idname = "object.sweep_step_pick"
    bl_label = "Pick Step"
    bl_options = {"INTERNAL"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        trees.pick(context.active_object, *found)
        return {"FINISHED"}


class OBJECT_OT_sweep_step_move(OnStep, Operator):
    """Do the step earlier or later"""

    bl_idname = "object.sweep_step_move"
    bl_label = "Move Step"
    bl_options = {"REGISTER", "UNDO"}

    direction: EnumProperty(
        name="Direction",
        description="Where the step goes",
        items=[("UP", "Up", "Before the step above it"), ("DOWN", "Down", "After the step below it")],
    )

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        owner, modifier = found
        steps = trees.booleans(owner)
        place = steps.index(modifier) + (-1 if self.direction == "UP" else 1)
        if not 0 <= place < len(steps):
            return {"CANCELLED"}
        stack = list(owner.modifiers)
        owner.modifiers.move(stack.index(modifier), stack.index(steps[place]))
        return {"FINISHED"}


class OBJECT_OT_sweep_step_mute(OnStep, Operator):
    """Leave the step out, in renders too, or do it again"""

    bl_idname = "object.sweep_step_mute"
    bl_label = "Mute Step"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        modifier = found[1]
        modifier.show_viewport = modifier.show_render = not modifier.show_viewport
        return {"FINISHED"}


class OBJECT_OT_sweep_step_select(OnStep, Operator):
    """Select the operand alone, to move it"""

    bl_idname = "object.sweep_step_select"
    bl_label = "Select Operand"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        operand = trees.operand_of(found[1])
        if operand is None or operand.name not in context.view_layer.objects:
            self.report({"ERROR"}, "The operand was deleted, or its collection is not in this view layer")
            return {"CANCELLED"}
        for ob in context.selected_objects:
            ob.select_set(False)
        operand.hide_set(False)
        operand.select_set(True)
        context.view_layer.objects.active = operand
        return {"FINISHED"}


class OBJECT_OT_sweep_step_extract(OnStep, Operator):
    """Take the step out of the tree; its operand stays where it is, shown and rendered again"""

    bl_idname = "object.sweep_step_extract"
    bl_label = "Extract"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        found = self.found(context)
        if not found:
            return {"CANCELLED"}
        operands.extract(*found)
        return {"FINISHED"}


OPERATORS = (
    OBJECT_OT_sweep_tree_choose_solver,
    OBJECT_OT_sweep_tree_duplicate,
    OBJECT_OT_sweep_tree_collapse,
    OBJECT_OT_sweep_tree_take_apart,
    OBJECT_OT_sweep_tree_evaluate,
    OBJECT_OT_sweep_step_pick,
    OBJECT_OT_sweep_step_move,
    OBJECT_OT_sweep_step_mute,
    OBJECT_OT_sweep_step_select,
    OBJECT_OT_sweep_step_extract,
)
