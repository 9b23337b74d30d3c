# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Groups of geometry nodes that modifiers of the program have: each is made once for a file, and known by its name."""

import bpy


def group(name, kinds, linked):
    """The group of that name in the file, or a new one.

    Parameters
    ----------
    name : str
    kinds : sequence of str
        Of the nodes between those where the geometry comes in and goes out.
    linked : callable
        Is given all nodes, sets what they have to be told, and yields pairs of sockets that are to be linked.
    """
    made = next((g for g in bpy.data.node_groups if g.name.startswith(name) and not g.library), None)
    if made:
        return made
    made = bpy.data.node_groups.new(name, "GeometryNodeTree")
    made.is_modifier = True
    for direction in ("INPUT", "OUTPUT"):
        made.interface.new_socket("Geometry", in_out=direction, socket_type="NodeSocketGeometry")
    nodes = [made.nodes.new(kind) for kind in ("NodeGroupInput", *kinds, "NodeGroupOutput")]
    for here, there in linked(*nodes):
        made.links.new(here, there)
    for number, node in enumerate(nodes):
        node.location.x = 200 * number
    return made


def has_group(modifier, name):
    """Whether a modifier has the group of that name."""
    return modifier.type == "NODES" and modifier.node_group is not None and modifier.node_group.name.startswith(name)
