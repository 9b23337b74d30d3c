# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sharp edges where set operations cut: a last modifier, of nodes, since Blender draws its Booleans' cuts smooth."""

from math import radians

from .node_groups import group, has_group

NAME = "Sharp Edges of Sweep-CSG"
KINDS = ("GeometryNodeInputMeshEdgeAngle", "FunctionNodeCompare", "GeometryNodeSetShadeSmooth")
WIDEST = radians(30)  # of a turn that is drawn smooth, as Blender's own Shade Auto Smooth has it


def draw(ob):
    """Let an object's cuts be drawn as edges, after all its other modifiers."""
    if any(is_drawer(modifier) for modifier in ob.modifiers):
        return
    active = ob.modifiers.active  # which says what step is picked
    modifier = ob.modifiers.new(NAME, "NODES")
    modifier.node_group, modifier.use_pin_to_last = group(NAME, KINDS, linked), True
    modifier.show_expanded = False
    ob.modifiers.active = active


def undraw(ob):
    """Take that off an object without Boolean modifiers."""
    for modifier in [m for m in ob.modifiers if is_drawer(m)]:
        ob.modifiers.remove(modifier)


def is_drawer(modifier):
    """Whether a modifier is this one."""
    return has_group(modifier, NAME)


def linked(start, turn, compare, shade, end):
    """Edges with a larger turn between their faces are not shaded smooth."""
    compare.data_type, compare.operation, shade.domain = "FLOAT", "GREATER_THAN", "EDGE"
    compare.inputs["B"].default_value, shade.inputs["Shade Smooth"].default_value = WIDEST, False
    yield turn.outputs["Unsigned Angle"], compare.inputs["A"]
    yield compare.outputs["Result"], shade.inputs["Selection"]
    yield start.outputs["Geometry"], shade.inputs["Geometry"]
    yield shade.outputs["Geometry"], end.inputs["Geometry"]
