# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is done with one step of a tree: pick, move and mute it, select its operand, or take it out."""

from bpy.props import EnumProperty
from bpy.types import Operator

from ..sweep_addon.core.later import later
from .on_tree import OnStep

operands, trees = later("bridge.operands"), later("bridge.trees")


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
    OBJECT_OT_sweep_step_pick,
    OBJECT_OT_sweep_step_move,
    OBJECT_OT_sweep_step_mute,
    OBJECT_OT_sweep_step_select,
    OBJECT_OT_sweep_step_extract,
)
