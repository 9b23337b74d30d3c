# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Other ways to the same tube, each as its users would make it."""

import bpy
import numpy as np


def linked(name, data):
    """A new object of the scene."""
    ob = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def evaluated(ob):
    """The mesh that Blender shows of an object, brought up to date."""
    return ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data


def curve(*lines, closed=False):
    """A curve object: a poly spline through each of some lines of points (n, 3)."""
    data = bpy.data.curves.new("Path", "CURVE")
    data.dimensions = "3D"
    for points in lines:
        spline = data.splines.new("POLY")
        spline.points.add(len(points) - 1)
        spline.points.foreach_set("co", np.column_stack((points, np.ones(len(points)))).ravel())
        spline.use_cyclic_u = closed
    return linked("Path", data)


def ring(radius, count):
    """The corners (n, 3) of a circle's polygon, in the xy plane."""
    angles = 2 * np.pi * np.arange(count) / count
    return radius * np.stack((np.cos(angles), np.sin(angles), np.zeros(count)), axis=1)


class CurveToMesh:
    """Blender's node Curve to Mesh, with filled caps; with texture coordinates in true lengths where asked for."""

    def __init__(self, path, points=64, radius=0.1, contour=None, texture=False):
        self.tree = tree = bpy.data.node_groups.new("Curve to Mesh", "GeometryNodeTree")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
        sweep, output = (tree.nodes.new(kind) for kind in ("GeometryNodeCurveToMesh", "NodeGroupOutput"))
        sweep.inputs["Fill Caps"].default_value = True
        self.circle = None if contour else self.curve_circle(points, radius)
        along, u = self.measured(self.object_info(path), texture)
        around, v = self.measured(self.object_info(contour) if contour else self.circle.outputs["Curve"], texture)
        tree.links.new(along, sweep.inputs["Curve"])
        tree.links.new(around, sweep.inputs["Profile Curve"])
        mesh = self.textured(sweep.outputs["Mesh"], u, v) if texture else sweep.outputs["Mesh"]
        tree.links.new(mesh, output.inputs["Geometry"])
        self.object = linked("Node", bpy.data.meshes.new("Node"))
        self.object.modifiers.new("Node", "NODES").node_group = tree

    def object_info(self, ob):
        node = self.tree.nodes.new("GeometryNodeObjectInfo")
        node.inputs["Object"].default_value = ob
        return node.outputs["Geometry"]

    def curve_circle(self, points, radius):
        node = self.tree.nodes.new("GeometryNodeCurvePrimitiveCircle")
        node.inputs["Resolution"].default_value, node.inputs["Radius"].default_value = points, radius
        return node

    def measured(self, geometry, texture):
        """A curve, and the length along it at each of its points."""
        if not texture:
            return geometry, None
        capture, length = map(self.tree.nodes.new, ("GeometryNodeCaptureAttribute", "GeometryNodeSplineParameter"))
        capture.capture_items.new("FLOAT", "Length")
        self.tree.links.new(geometry, capture.inputs["Geometry"])
        self.tree.links.new(length.outputs["Length"], capture.inputs["Length"])
        return capture.outputs["Geometry"], capture.outputs["Length"]

    def textured(self, geometry, u, v):
        vector, store = map(self.tree.nodes.new, ("ShaderNodeCombineXYZ", "GeometryNodeStoreNamedAttribute"))
        store.data_type, store.domain, store.inputs["Name"].default_value = "FLOAT2", "CORNER", "UVMap"
        for source, target in ((u, vector.inputs["X"]), (v, vector.inputs["Y"]), (geometry, store.inputs["Geometry"])):
            self.tree.links.new(source, target)
        self.tree.links.new(vector.outputs["Vector"], store.inputs["Value"])
        return store.outputs["Geometry"]

    def set_radius(self, radius):
        self.circle.inputs["Radius"].default_value = radius
        return self.mesh()

    def mesh(self):
        return evaluated(self.object)


class Bevel:
    """A curve object with a round bevel and filled caps."""

    def __init__(self, points, count=64, radius=0.1, closed=False):
        self.object = curve(points, closed=closed)
        data = self.object.data
        data.bevel_depth, data.bevel_resolution, data.use_fill_caps = radius, count // 2 - 2, True

    def set_radius(self, radius):
        self.object.data.bevel_depth = radius
        return self.mesh()

    def mesh(self):
        return self.object.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()


class FromPydata:
    """The places and faces of a tube, known beforehand, written by Blender's own Python function."""

    def __init__(self, made):
        self.places = made.vertices
        sizes = np.diff(made.offsets)
        corners = made.corners.tolist()
        self.faces = [corners[a : a + n] for a, n in zip(made.offsets[:-1].tolist(), sizes.tolist(), strict=True)]
        self.object = linked("From pydata", bpy.data.meshes.new("From pydata"))

    def write(self, number):
        mesh = self.object.data
        mesh.clear_geometry()
        mesh.from_pydata(self.places, [], self.faces)
        mesh.update()
        return evaluated(self.object)


def trimesh_sweep():
    """The function trimesh.creation.sweep_polygon and shapely's Polygon, or None where they are not installed."""
    try:
        from shapely import Polygon
        from trimesh.creation import sweep_polygon
    except ImportError:
        return None

    def swept(corners, path, *holes):
        polygon = Polygon(corners[:, :2], [hole[:, :2] for hole in holes])
        return sweep_polygon(polygon, path, engine="earcut")

    return swept
