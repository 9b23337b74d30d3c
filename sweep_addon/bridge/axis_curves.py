# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Live curves of an L-system's axes: a modifier, of nodes, that makes a curve of each poly-line of the mesh.

The mesh's attribute *radius* becomes the radius of the curves. Faces of polygons, and points of organs, stay.
"""

import bpy

NAME = "Curves of Axes"


def show(ob):
    """Let an object's poly-lines be curves, before all its other modifiers."""
    if is_shown(ob):
        return
    modifier = ob.modifiers.new(NAME, "NODES")
    modifier.node_group, modifier.show_expanded = group(), False
    ob.modifiers.move(len(ob.modifiers) - 1, 0)


def is_shown(ob):
    """Whether an object has that modifier."""
    groups = (modifier.node_group for modifier in ob.modifiers if modifier.type == "NODES")
    return any(group is not None and group.name.startswith(NAME) for group in groups)


def group():
    """The nodes: edges of no face become curves, and all else is joined to these as it is."""
    made = next((g for g in bpy.data.node_groups if g.name.startswith(NAME) and not g.library), None)
    if made:
        return made
    made = bpy.data.node_groups.new(NAME, "GeometryNodeTree")
    made.is_modifier = True
    for direction in ("INPUT", "OUTPUT"):
        made.interface.new_socket("Geometry", in_out=direction, socket_type="NodeSocketGeometry")
    kinds = ("NodeGroupInput", "GeometryNodeInputMeshEdgeNeighbors", "FunctionNodeCompare", "GeometryNodeFieldOnDomain",
             "GeometryNodeSeparateGeometry", "GeometryNodeMeshToCurve", "GeometryNodeJoinGeometry")  # fmt: skip
    nodes = [made.nodes.new(kind) for kind in (*kinds, "NodeGroupOutput")]
    start, faces, none, on_edges, parts, curves, whole, end = nodes
    none.data_type, none.operation = "INT", "EQUAL"
    on_edges.data_type, on_edges.domain = (
        "BOOLEAN",
        "EDGE",
    )  # of a point that counts all its edges, and an organ has none
    of_numbers = {socket.name: socket for socket in none.inputs if socket.type == "INT"}
    of_numbers["B"].default_value = 0
    for here, there in (
        (start.outputs["Geometry"], parts.inputs["Geometry"]),
        (faces.outputs["Face Count"], of_numbers["A"]),
        (none.outputs["Result"], on_edges.inputs["Value"]),
        (on_edges.outputs["Value"], parts.inputs["Selection"]),
        (parts.outputs["Selection"], curves.inputs["Mesh"]),
        (parts.outputs["Inverted"], whole.inputs["Geometry"]),
        (curves.outputs["Curve"], whole.inputs["Geometry"]),
        (whole.outputs["Geometry"], end.inputs["Geometry"]),
    ):
        made.links.new(here, there)
    for number, node in enumerate(nodes):
        node.location.x = 200 * number
    return made
