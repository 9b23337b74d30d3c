# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Live curves of an L-system's axes: a modifier, of nodes, that makes a curve of each poly-line of the mesh.

The mesh's attribute *radius* becomes the radius of the curves. Faces of polygons, and points of organs, stay.
"""

from .node_groups import group, has_group

NAME = "Curves of Axes"
KINDS = (
    "GeometryNodeInputMeshEdgeNeighbors",
    "FunctionNodeCompare",
    "GeometryNodeFieldOnDomain",
    "GeometryNodeSeparateGeometry",
    "GeometryNodeMeshToCurve",
    "GeometryNodeJoinGeometry",
)


def show(ob):
    """Let an object's poly-lines be curves, before all its other modifiers."""
    if is_shown(ob):
        return
    modifier = ob.modifiers.new(NAME, "NODES")
    modifier.node_group, modifier.show_expanded = group(NAME, KINDS, linked), False
    ob.modifiers.move(len(ob.modifiers) - 1, 0)


def is_shown(ob):
    """Whether an object has that modifier."""
    return any(has_group(modifier, NAME) for modifier in ob.modifiers)


def linked(start, faces, none, on_edges, parts, curves, whole, end):
    """Edges of no face become curves, and all else is joined to these as it is.

    Edges are counted on edges, of a point all its own: an organ has none, and stays.
    """
    none.data_type, none.operation = "INT", "EQUAL"
    on_edges.data_type, on_edges.domain = "BOOLEAN", "EDGE"
    of_numbers = {socket.name: socket for socket in none.inputs if socket.type == "INT"}
    of_numbers["B"].default_value = 0
    yield start.outputs["Geometry"], parts.inputs["Geometry"]
    yield faces.outputs["Face Count"], of_numbers["A"]
    yield none.outputs["Result"], on_edges.inputs["Value"]
    yield on_edges.outputs["Value"], parts.inputs["Selection"]
    yield parts.outputs["Selection"], curves.inputs["Mesh"]
    yield parts.outputs["Inverted"], whole.inputs["Geometry"]
    yield curves.outputs["Curve"], whole.inputs["Geometry"]
    yield whole.outputs["Geometry"], end.inputs["Geometry"]
