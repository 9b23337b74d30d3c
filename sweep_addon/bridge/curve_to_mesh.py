# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A Curve to Mesh node as a tube: its inputs, followed back through a modifier's node tree.

Only what a sweep has is followed: the object's own curve or an Object Info, a circle, a rectangle or an Object Info for
the profile, numbers of the modifier. Any other node is refused by its name.
"""

from math import pi

import bpy
import numpy as np
from mathutils import Matrix

from ..core.contours import Circle, Rectangle
from ..core.declared.parameters import ShapeError, at, require
from ..core.stations.frames import FixedUp
from . import bevel, curves
from .rna import decimal
from .tube import Tube, enabled, first_twist, frame, require_cyclic, require_on_splines, shape

NODE, OBJECT = "GeometryNodeCurveToMesh", "GeometryNodeObjectInfo"
MOST_NODES = 200  # a larger tree does more than draw a tube, and is not searched on every redraw
SAME = 1e-5  # of a matrix in single precision


def modifier_of(ob):
    """The last modifier of an object that has a Curve to Mesh node; None where there is none."""
    trees = (m for m in reversed(enabled(ob) if ob else []) if m.type == "NODES" and m.node_group)
    small = (m for m in trees if len(m.node_group.nodes) <= MOST_NODES)
    return next((m for m in small if any(node.bl_idname == NODE for node in m.node_group.nodes)), None)


def tube(ob):
    """The tube that an object's Curve to Mesh node draws.

    Raises
    ------
    ShapeError
        Where the tree does what no sweep does, under the object's name.
    """
    modifier = modifier_of(ob)
    with at(ob.name):
        before = enabled(ob)
        require(before.pop() == modifier, "the modifier with Curve to Mesh must be the last", modifier.name)
        require_on_splines(before)
        node, material = surface(modifier)
        path, place = trajectory(ob, modifier, node)
        contour = profile(ob, modifier, node)
        size = scale(modifier, node, path)
        carried_by, twist = carried(ob, path, place, contour)
        objects, own = {"trajectory": path}, contour
        if isinstance(contour, bpy.types.Object):
            objects["contour"], own, contour = contour, None, curves.outline(contour)
        reach = size * float(np.linalg.norm(contour.section().points, axis=1).max())
        capped = held(modifier, node.inputs["Fill Caps"])
        made = shape(own, carried_by, capped, reach, scale_x=size, scale_y=size, twist=twist)
        return Tube(made, objects, place, material, lambda: quiet(ob, modifier, path))


def carried(ob, path, place, contour):
    """The frame in the trajectory's space that is Blender's in the object's, and its constant twist."""
    turn = np.eye(3)
    if place != ob:
        relative = (ob.matrix_world.inverted() @ path.matrix_world).to_3x3()
        turn = np.array(relative)
        rigid = np.allclose(turn @ turn.T, np.eye(3), atol=SAME)
        require(rigid, "the curve of Object Info must be scaled as the object is", path.name)
    found = frame(path.data)
    if isinstance(found, FixedUp):
        return FixedUp((turn.T @ found.up).round(7)), pi  # Blender's normal is -e2
    return found, first_twist(curves.trajectories(path), contour, lambda path: path.domain[0], turn)


def surface(modifier):
    """The Curve to Mesh node that a tree puts out, and the material that it sets on the way."""
    outputs = (node for node in modifier.node_group.nodes if node.bl_idname == "NodeGroupOutput")
    socket, material = next(node for node in outputs if node.is_active_output).inputs[0], None
    while True:
        node = source(socket)
        if node is None:
            raise ShapeError("Curve to Mesh must be connected to the output")
        if node.bl_idname == NODE:
            return node, material
        if node.bl_idname == "GeometryNodeSetMaterial":
            material = material or held(modifier, node.inputs["Material"])
        elif node.bl_idname != "GeometryNodeSetShadeSmooth":
            refuse(node)
        socket = node.inputs[0]


def source(socket):
    """The node that feeds a socket, None where nothing does."""
    while socket.is_linked:
        node = socket.links[0].from_node
        if node.mute:
            refuse(node)
        if node.bl_idname != "NodeReroute":
            return node
        socket = node.inputs[0]
    return None


def refuse(node):
    raise ShapeError(f"the node {node.label or node.name!r} cannot be converted")


def held(modifier, socket):
    """The value of a socket: its own, or the one that the modifier gives it."""
    node = source(socket)
    if node is None:
        value = socket.default_value
    elif node.bl_idname == "NodeGroupInput":
        value = given(modifier, socket.links[0].from_socket.identifier)
    else:
        refuse(node)
    return decimal(value) if isinstance(value, float) else value


def given(modifier, identifier):
    """What a modifier gives an input of its tree; newer Blenders keep it in properties of their own."""
    inputs = getattr(getattr(modifier, "properties", None), "inputs", None)
    return modifier[identifier] if inputs is None else getattr(inputs, identifier).value


def trajectory(ob, modifier, node):
    """The curve object along which a node sweeps, and the object in whose space."""
    fed = source(node.inputs["Curve"])
    require(fed is not None, "Curve to Mesh must have a curve", "nothing")
    if fed.bl_idname == "NodeGroupInput":
        require(ob.type == "CURVE", "the object must be a curve", ob.type.lower())
        return ob, ob
    if fed.bl_idname != OBJECT:
        refuse(fed)
    path = held(modifier, fed.inputs["Object"])
    require(path and path.type == "CURVE", "the object of Object Info must be a curve", path and path.name)
    return path, ob if fed.transform_space == "ORIGINAL" else path


def profile(ob, modifier, node):
    """The contour that a node sweeps, or the object that is one."""
    fed = source(node.inputs["Profile Curve"])
    require(fed is not None, "Curve to Mesh must have a profile", "nothing")
    kind, mode = fed.bl_idname, getattr(fed, "mode", "")
    if (kind, mode) == ("GeometryNodeCurvePrimitiveCircle", "RADIUS"):
        return Circle(*(held(modifier, fed.inputs[name]) for name in ("Radius", "Resolution")))
    if (kind, mode) == ("GeometryNodeCurvePrimitiveQuadrilateral", "RECTANGLE"):
        return Rectangle(*(held(modifier, fed.inputs[name]) for name in ("Width", "Height")))
    if kind != OBJECT:
        refuse(fed)
    contour = held(modifier, fed.inputs["Object"])
    require(contour is not None, "the object of the profile must be a curve", "none")
    require_cyclic(contour)
    relative = fed.transform_space == "RELATIVE"
    used = ob.matrix_world.inverted() @ contour.matrix_world if relative else Matrix()
    wanted = Matrix.Diagonal((*contour.scale, 1))  # a sweep scales a contour as its object is, and no more
    same = np.allclose(np.array(used)[:, :2], np.array(wanted)[:, :2], atol=SAME)
    same &= np.allclose(used.translation, 0, atol=SAME)
    place = "stand where the swept object is" if relative else "have a scale of 1"
    require(same, f"the profile must {place}", contour.name)
    return contour


def scale(modifier, node, path):
    """The scale of a node: a number, or 1 where it is the radius of the points, which a sweep takes anyway."""
    fed = source(node.inputs["Scale"])
    if fed is not None and fed.bl_idname == "GeometryNodeInputRadius":
        return 1.0
    radii = any(len(found.radii) for found in curves.trajectories(path))
    require(not radii, "the radius of all points must be 1, or Radius be the scale of Curve to Mesh", path.name)
    return held(modifier, node.inputs["Scale"])


def quiet(ob, modifier, path):
    """Switch the modifier off, and the object's own bevel, if it has one."""
    modifier.show_viewport = modifier.show_render = False
    if path != ob:  # its own geometry would appear
        ob.hide_viewport = ob.hide_render = True
    elif bevel.is_bevelled(ob):
        bevel.quiet(ob)
