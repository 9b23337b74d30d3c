# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sharp edges where set operations cut: a last modifier, of nodes, since Blender draws its Booleans' cuts smooth."""

from math import radians

import bpy

NAME = "Sharp Edges of Sweep-CSG"
WIDEST = radians(30)  # of a turn that is drawn smooth, as Blender's own Shade Auto Smooth has it


def draw(ob):
    """Let an object's cuts be drawn as edges, after all its other modifiers."""
    if any(is_drawer(modifier) for modifier in ob.modifiers):
        return
    active = ob.modifiers.active  # which says what step is picked
    modifier = ob.modifiers.new(NAME, "NODES")
    modifier.node_group, modifier.use_pin_to_last, modifier.show_expanded = nodes(), True, False
    ob.modifiers.active = active


def undraw(ob):
    """Take that off an object without Boolean modifiers."""
    for modifier in [m for m in ob.modifiers if is_drawer(m)]:
        ob.modifiers.remove(modifier)


def is_drawer(modifier):
    """Whether a modifier is this one."""
    return modifier.type == "NODES" and modifier.node_group is not None and modifier.node_group.name.startswith(NAME)


def nodes():
    """The nodes: edges with a larger turn between their faces are not shaded smooth."""
    made = next((g for g in bpy.data.node_groups if g.name.startswith(NAME) and not g.library), None)
    if made:
        return made
    made = bpy.data.node_groups.new(NAME, "GeometryNodeTree")
    made.is_modifier = True
    for direction in ("INPUT", "OUTPUT"):
        made.interface.new_socket("Geometry", in_out=direction, socket_type="NodeSocketGeometry")
    kinds = ("NodeGroupInput", "GeometryNodeInputMeshEdgeAngle", "FunctionNodeCompare", "GeometryNodeSetShadeSmooth")
    start, turn, compare, shade, end = (made.nodes.new(kind) for kind in (*kinds, "NodeGroupOutput"))
    compare.data_type, compare.operation, shade.domain = "FLOAT", "GREATER_THAN", "EDGE"
    compare.inputs["B"].default_value, shade.inputs["Shade Smooth"].default_value = WIDEST, False
    made.links.new(turn.outputs["Unsigned Angle"], compare.inputs["A"])
    made.links.new(compare.outputs["Result"], shade.inputs["Selection"])
    for node, other in ((start, shade), (shade, end)):
        made.links.new(node.outputs["Geometry"], other.inputs["Geometry"])
    for number, node in enumerate((start, turn, compare, shade, end)):
        node.location.x = 200 * number
    return made
