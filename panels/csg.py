# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-CSG in the sidebar: what can be combined, and the active tree, of which more is loaded when there is one."""

from bpy.types import Panel

from ..operators.combine import OPERATORS
from ..sweep_addon.core.later import later

recognizing = later("bridge.recognizing")

LOOKED_AT = 100  # selected objects, for a second mesh among them: a draw takes no longer however many there are
ICONS = {"UNION": "SELECT_EXTEND", "INTERSECT": "SELECT_INTERSECT", "DIFFERENCE": "SELECT_SUBTRACT"}


class VIEW3D_PT_sweep_csg(Panel):
    """The active tree of set operations"""

    bl_label = "Sweep-CSG"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Sweep"

    @classmethod
    def poll(cls, context):
        ob = context.active_object
        return context.mode == "OBJECT" and (recognizing.is_tree(ob) or can_combine(context) or bool(result_of(ob)))

    def draw(self, context):
        layout, ob = self.layout, context.active_object
        if can_combine(context):
            row = layout.row(align=True)
            for operator in OPERATORS:
                row.operator(operator.bl_idname)
            layout.operator("object.sweep_find_removal_path")
        if recognizing.is_tree(ob):
            from .csg_tree import draw_tree  # most scenes have none

            draw_tree(layout, context, ob)
        elif result_of(ob):
            from .sentences import sentences

            row = layout.row()
            sentences(context)(row, f"Operand of {result_of(ob).name}", ICONS[step_of(ob).operation])
            row.operator("object.select_hierarchy", text="", icon="FILE_PARENT").direction = "PARENT"


def can_combine(context):
    """Whether the active object is a mesh, and another selected one is."""
    active = context.active_object
    if active is None or active.type != "MESH":
        return False
    return any(ob.type == "MESH" and ob != active for ob in context.selected_objects[:LOOKED_AT])


def result_of(ob):
    """The tree that an object moves with and is an operand of, or None."""
    parent = ob.parent if ob else None
    return parent if parent and ob in recognizing.operands(parent) else None


def step_of(ob):
    """The modifier of such an operand."""
    return next(modifier for modifier in recognizing.booleans(ob.parent) if recognizing.operand_of(modifier) == ob)
