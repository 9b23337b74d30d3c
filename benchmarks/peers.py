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


def places(mesh):
    """The vertices (n, 3) of a Blender mesh."""
    found = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", found)
    return found.reshape(-1, 3).astype(float)


class CurveToMesh:
    """Blender's node Curve to Mesh, with filled caps; in true lengths of texture, or to a point, where asked for."""

    def __init__(self, path, points=64, radius=0.1, contour=None, texture=False, shrinking=False):
        self.tree = tree = bpy.data.node_groups.new("Curve to Mesh", "GeometryNodeTree")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
        sweep, output = (tree.nodes.new(kind) for kind in ("GeometryNodeCurveToMesh", "NodeGroupOutput"))
        sweep.inputs["Fill Caps"].default_value = True
        self.circle = None if contour else self.curve_circle(points, radius)
        along, u = self.measured(self.object_info(path), texture)
        around, v = self.measured(self.object_info(contour) if contour else self.circle.outputs["Curve"], texture)
        tree.links.new(along, sweep.inputs["Curve"])
        tree.links.new(around, sweep.inputs["Profile Curve"])
        if shrinking:
            tree.links.new(self.rest_of_the_way(), sweep.inputs["Scale"])
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

    def rest_of_the_way(self):
        """From 1 at the start of a curve to 0 at its end."""
        spline, rest = map(self.tree.nodes.new, ("GeometryNodeSplineParameter", "ShaderNodeMath"))
        rest.operation, rest.inputs[0].default_value = "SUBTRACT", 1.0
        self.tree.links.new(spline.outputs["Factor"], rest.inputs[1])
        return rest.outputs["Value"]

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


class Resampled:
    """Blender's nodes Resample Curve, by a count, and Curve to Mesh, on a closed curve as fine as it is given."""

    def __init__(self, places):
        tree = bpy.data.node_groups.new("Resample", "GeometryNodeTree")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
        kinds = ("GeometryNodeObjectInfo", "GeometryNodeResampleCurve", "GeometryNodeCurveToMesh", "NodeGroupOutput")
        info, resample, wire, output = map(tree.nodes.new, kinds)
        info.inputs["Object"].default_value = curve(places, closed=True)
        tree.links.new(info.outputs["Geometry"], resample.inputs["Curve"])
        tree.links.new(resample.outputs["Curve"], wire.inputs["Curve"])
        tree.links.new(wire.outputs["Mesh"], output.inputs["Geometry"])
        self.count = resample.inputs["Count"]
        self.object = linked("Resampled", bpy.data.meshes.new("Resampled"))
        self.object.modifiers.new("Resample", "NODES").node_group = tree

    def points(self, count):
        self.count.default_value = count
        return places(evaluated(self.object))


class BezierCircle:
    """Blender's Bezier circle of four knots, stretched along the axes."""

    HANDLE = 4 / 3 * np.tan(np.pi / 8)

    def __init__(self, size):
        along = np.array([(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], float)
        tangents = np.roll(along, -1, axis=0) * self.HANDLE
        self.knots, self.before, self.after = (part * size for part in (along, along - tangents, along + tangents))
        self.object = linked("Bezier", bpy.data.curves.new("Bezier", "CURVE"))
        self.object.data.dimensions = "3D"
        spline = self.object.data.splines.new("BEZIER")
        spline.bezier_points.add(3)
        spline.use_cyclic_u = True
        for point, knot, before, after in zip(spline.bezier_points, self.knots, self.before, self.after, strict=True):
            point.co, point.handle_left, point.handle_right = knot, before, after

    def points(self, count):
        """As many points as there are in whole steps of the four pieces."""
        self.object.data.resolution_u = count // 4
        return places(self.object.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh())

    def exact(self, count):
        """The curve itself (count, 3), by Bernstein's polynomials."""
        t = np.arange(count // 4)[:, None] * 4 / count
        following, arriving = (np.roll(part, -1, axis=0) for part in (self.knots, self.before))
        pieces = zip(self.knots, self.after, arriving, following, strict=True)
        return np.concatenate(
            [(1 - t) ** 3 * a + 3 * t * (1 - t) ** 2 * b + 3 * t**2 * (1 - t) * c + t**3 * d for a, b, c, d in pieces]
        )


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


def trimesh_resampled(places):
    """A function of a count: so many points along a closed curve by trimesh; None where it is not installed."""
    try:
        from trimesh.path.traversal import resample_path
    except ImportError:
        return None
    loop = np.concatenate((places, places[:1]))
    return lambda count: resample_path(loop, count=count + 1)[:-1]
