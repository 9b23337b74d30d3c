# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tubes that Blender draws along curves become sweeps: what Blender drew is the truth.

Volumes agree to a thousandth and boxes to a thousandth of their size, with 256 points of the curve in a segment.
"""

from types import SimpleNamespace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

import bmesh
from mathutils import Matrix, Vector
from scenes import add, curve, parameters_of, places, select, square

from sweep_addon.bridge import curve_to_mesh

NEAR = 1e-3
BENT = np.reshape([[-3, -1, 0, -2, 0, 0, -1, 1, 0], [0, 1, 1, 1, 0, 1, 2, -1, 1], [2, 1, 3, 3, 2, 3, 4, 3, 3]], (3, 9))
THIRDS = [Matrix.Rotation(2 * np.pi * i / 3, 3, "Z") for i in range(3)]
LOOP = [[c for p in ((2, -1.3, -0.9), (2, 0, 0), (2, 1.3, 0.9)) for c in turn @ Vector(p)] for turn in THIRDS]


def drawn(ob):
    """The volume and the box, in the world, of what Blender shows of an object."""
    bpy.context.view_layer.update()
    evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    measured = bmesh.new()
    measured.from_mesh(mesh)
    measured.transform(ob.matrix_world)
    bmesh.ops.remove_doubles(measured, verts=measured.verts, dist=1e-6)  # Blender's caps stand by themselves
    bmesh.ops.recalc_face_normals(measured, faces=measured.faces)  # and look inwards where the outline does
    volume = abs(measured.calc_volume(signed=True))
    points = np.array([vertex.co for vertex in measured.verts], dtype=float)
    measured.free()
    evaluated.to_mesh_clear()
    return SimpleNamespace(volume=volume, box=np.array((points.min(axis=0), points.max(axis=0))))


def path(points=None, kind="BEZIER", cyclic=False, **options):
    """A curve whose bevel is 0.2 m thick and closed."""
    points = points or (LOOP if cyclic else BENT)
    ob = curve(kind, points, use_cyclic_u=cyclic, resolution_u=256, use_endpoint_u=not cyclic, use_bezier_u=False)
    for key, value in {"bevel_depth": 0.2, "use_fill_caps": True, "fill_mode": "FULL", **options}.items():
        setattr(ob.data, key, value)
    return ob


def hook():
    """An outline without any symmetry."""
    return curve("POLY", [(0, 0, 0), (0.5, 0, 0), (0.5, 0.1, 0), (0.1, 0.3, 0)], use_cyclic_u=True, name="hook")


def converted(ob):
    select(ob)
    assert bpy.ops.object.sweep_convert() == {"FINISHED"}
    sweep = bpy.context.active_object
    assert sweep.data.sweep.kind == "GENERALIZED_CYLINDER" and bpy.context.selected_objects == [sweep]
    return sweep


def depth(points, radius):
    """How far the edges of a regular polygon are within its corners' circle.

    A closed sweep turns less than Blender, no farther than the symmetry of its contour asks: a corner may be where
    Blender has an edge.
    """
    return radius * (1 - np.cos(np.pi / points))


def alike(ob, caps=True, depth=0.0):
    """Convert an object, and compare what is drawn before and after."""
    before = drawn(ob)
    sweep = converted(ob)
    parameters_of(sweep).samples_tolerance_chord = 1e-5
    after = drawn(sweep)
    if caps:
        assert after.volume == pytest.approx(before.volume, rel=NEAR)
    assert after.box == pytest.approx(before.box, abs=NEAR * np.ptp(before.box, axis=0).max() + depth)
    return sweep


@pytest.mark.parametrize("kind", ["BEZIER", "NURBS"])
@pytest.mark.parametrize("cyclic", [False, True])
@pytest.mark.parametrize("resolution", [0, 1, 3, 4])
def test_round_bevel(scene, kind, cyclic, resolution):
    points = None if kind == "BEZIER" else [(-2, 0, 0), (-1, 2, 0), (1, 2, 1), (2, 0, 2), (1, -1, 1)]
    ob = path(points, kind, cyclic, bevel_resolution=resolution)
    sweep = alike(ob, depth=cyclic * depth(4 + 2 * resolution, 0.2))
    assert parameters_of(sweep).contour_circle_points == 4 + 2 * resolution
    assert parameters_of(sweep).contour_circle_radius == pytest.approx(0.2)


def test_a_straight_polyline_needs_no_ring_between_its_ends(scene):
    """Where it bends no two tubes would be alike: Blender thins a bevel at corners, and a mitre does not."""
    sweep = alike(path([(0, 0, 0), (1, 2, 0), (2, 4, 0)], "POLY"))
    assert sweep.data.sweep.rings == 2


def test_the_curve_is_the_live_path_and_draws_nothing(scene):
    ob = path([(0, 0, 0), (0, 0, 2)], "POLY")
    sweep = alike(ob)
    assert parameters_of(sweep).trajectory_object == ob and sweep.parent == ob
    assert not ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh().polygons
    ob.data.splines[0].points[1].co.z = 5
    bpy.context.view_layer.update()
    assert np.ptp(places(sweep.data)[:, 2]) == pytest.approx(5)


def test_where_and_however_the_curve_stands(scene):
    bpy.ops.curve.primitive_bezier_curve_add(location=(1, 2, 3), rotation=(0.5, 0.4, 0.3))
    ob = bpy.context.active_object
    ob.scale, ob.data.bevel_depth, ob.data.resolution_u, ob.data.use_fill_caps = (1, 2, 0.5), 0.1, 64, True
    alike(ob)


@pytest.mark.parametrize("resolution", [0, 1, 4])
def test_extruded_bevel(scene, resolution):
    sweep = alike(path(bevel_depth=0.1, extrude=0.3, bevel_resolution=resolution))
    assert parameters_of(sweep).contour == "RECTANGLE"


@pytest.mark.parametrize("twist", ["MINIMUM", "Z_UP"])
@pytest.mark.parametrize("cyclic", [False, True])
def test_bevel_object(scene, twist, cyclic):
    outline = hook()
    outline.scale = (1.5, 0.5, 1)
    sweep = alike(path(cyclic=cyclic, bevel_mode="OBJECT", bevel_object=outline, twist_mode=twist))
    assert parameters_of(sweep).contour_object == outline
    before = drawn(sweep).volume
    outline.scale.x *= 1.1
    assert drawn(sweep).volume == pytest.approx(1.1 * before, rel=0.02)  # its centroid is beside the path


def test_flat_curve(scene):
    ob = path([(-1, -1, 0, 0, 0, 0, 1, 1, 0), (2, 1, 0, 3, 0, 0, 4, -1, 0)], bevel_mode="OBJECT", bevel_object=hook())
    ob.data.dimensions, ob.data.fill_mode = "2D", "NONE"
    alike(ob)


@pytest.mark.parametrize("caps", [False, True])
def test_ends_are_as_they_were(scene, caps):
    sweep = alike(path(use_fill_caps=caps), caps)
    assert parameters_of(sweep).start == parameters_of(sweep).end == ("FLAT" if caps else "OPEN")


def test_radius_and_tilt_of_the_points_stay_live(scene):
    ob = path(bevel_mode="OBJECT", bevel_object=hook())
    for point, radius, tilt in zip(ob.data.splines[0].bezier_points, (1, 0.5, 2), (0, 1, -0.5), strict=True):
        point.radius, point.tilt = radius, tilt
    sweep = alike(ob)
    before = drawn(sweep).volume
    for point in ob.data.splines[0].bezier_points:
        point.radius *= 0.5
    assert drawn(sweep).volume == pytest.approx(before / 4, rel=0.1)  # the contour's centroid is beside the path


@pytest.mark.parametrize("mode", ["OVERRIDE", "MULTIPLY"])
def test_taper_object(scene, mode):
    profile = curve("BEZIER", [(-1, 0.2, 0, 0, 0.5, 0, 1, 1.5, 0), (2, 1.5, 0, 3, 0.3, 0, 4, 0, 0)], resolution_u=256)
    ob = path(taper_object=profile, taper_radius_mode=mode)
    if mode == "MULTIPLY":
        for point in ob.data.splines[0].bezier_points:
            point.radius = 0.5
    alike(ob)


def test_several_splines_are_several_tubes(scene):
    alike(curve_of_two())


def curve_of_two():
    ob = curve("BEZIER", BENT, BENT + 5, resolution_u=256)
    ob.data.bevel_depth, ob.data.use_fill_caps, ob.data.fill_mode = 0.2, True, "FULL"
    ob.data.splines[1].bezier_points[0].radius = 2
    return ob


def test_material_is_on_side_and_ends(scene):
    ob, red, blue = path(), bpy.data.materials.new("red"), bpy.data.materials.new("blue")
    ob.data.materials.append(red)
    ob.data.materials.append(blue)
    ob.data.splines[0].material_index = 1
    assert [material for material in converted(ob).data.materials] == [blue, blue]


def test_another_object_of_the_same_curve_keeps_its_bevel(scene):
    ob = path()
    twin = add("twin", ob.data)
    before = drawn(twin).volume
    alike(ob)
    assert drawn(twin).volume == pytest.approx(before)


def test_all_selected_tubes_are_converted_at_once(scene):
    first, second, plain = path(), path(), square()
    select(first, second, plain)
    assert bpy.ops.object.sweep_convert() == {"FINISHED"}
    assert len(bpy.context.selected_objects) == 2
    assert parameters_of(bpy.context.active_object).trajectory_object == first
    assert all(ob.data.bevel_depth == 0 for ob in (first, second))


def interpolated(ob):
    ob.data.splines[0].radius_interpolation = "EASE"
    ob.data.splines[0].bezier_points[0].radius = 2


def keyed(ob):
    ob.data.keyframe_insert("bevel_depth", frame=1)


def driven(ob):
    ob.data.driver_add("extrude")


def two_materials(ob):
    ob.data.splines.new("POLY").points.add(1)
    ob.data.splines[1].points[1].co.x = 1
    ob.data.materials.append(None)
    ob.data.materials.append(None)
    ob.data.splines[1].material_index = 1


def subdivided(ob):
    ob.modifiers.new("Subdivision", "SUBSURF")


def setting(**options):
    return lambda ob: [setattr(ob.data, key, value() if callable(value) else value) for key, value in options.items()]


def open_profile():
    return curve("POLY", [(0, 0, 0), (1, 0, 0), (1, 1, 0)], name="open")


@pytest.mark.parametrize(
    ("spoil", "refusal"),
    [
        (setting(bevel_mode="PROFILE"), "the bevel must be round or an object, got 'a custom profile'"),
        (setting(fill_mode="HALF"), "the fill mode must be full, got 'half'"),
        (setting(bevel_depth=0, extrude=1), "the bevel depth must be more than 0, got 0"),
        (setting(bevel_factor_start=0.25), "the bevel must start at 0 and end at 1, got .0.25, 1"),
        (setting(offset=0.5), "the offset must be 0, got 0.5"),
        (setting(twist_mode="TANGENT"), "twist method must be minimum or z-up, got 'tangent'"),
        (setting(twist_smooth=2), "twist smoothing must be 0, got 2"),
        (setting(bevel_mode="OBJECT", bevel_object=open_profile), "the splines of the profile must be cyclic.*'open'"),
        (setting(taper_object=square), "the taper object must run along its x axis, got 'square'"),
        (interpolated, "radius and tilt must be interpolated linearly, got 'ease, linear'"),
        (keyed, "the bevel must not be animated, got 'bevel_depth'"),
        (driven, "the bevel must not be animated, got 'extrude'"),
        (two_materials, "all splines must have one material, got 2"),
        (subdivided, "modifiers must work on the curve's points; apply or remove, got 'Subdivision'"),
    ],
)
def test_what_no_sweep_is_is_refused_and_nothing_is_changed(scene, spoil, refusal):
    good, bad = path(), path()
    spoil(bad)
    select(good, bad)
    before, known = drawn(good).volume, {repr(data) for data in bpy.data.user_map()}
    with pytest.raises(RuntimeError, match=f"{bad.name}: {refusal}"):
        bpy.ops.object.sweep_convert()
    assert {repr(data) for data in bpy.data.user_map()} == known and drawn(good).volume == before


def test_it_says_what_to_make_active(scene):
    plain = square()
    for ob in (None, plain, add("cube", bpy.data.meshes.new("cube"))):
        select(ob)
        with pytest.raises(RuntimeError, match="Make a curve with a bevel"):
            bpy.ops.object.sweep_convert()


class Nodes:
    """An object's Curve to Mesh modifier: the curve, the profile and what else is connected."""

    def __init__(self, ob, profile, caps=True, path=None, space="RELATIVE"):
        self.tree = bpy.data.node_groups.new("tube", "GeometryNodeTree")
        for direction in ("INPUT", "OUTPUT"):
            self.tree.interface.new_socket("Geometry", in_out=direction, socket_type="NodeSocketGeometry")
        self.given, self.out = self.add("NodeGroupInput"), self.add("NodeGroupOutput")
        self.node = self.add("GeometryNodeCurveToMesh")
        self.node.inputs["Fill Caps"].default_value = caps
        self.link(self.info(path, space) if path else self.given, self.node.inputs["Curve"])
        self.link(profile(self), self.node.inputs["Profile Curve"])
        self.link(self.node, self.out.inputs[0])
        self.modifier = ob.modifiers.new("Tube", "NODES")
        self.modifier.node_group = self.tree

    def add(self, kind, **values):
        node = self.tree.nodes.new(kind)
        for name, value in values.items():
            node.inputs[name].default_value = value
        return node

    def link(self, node, socket):
        output = node.outputs["Geometry"] if node.bl_idname == "GeometryNodeObjectInfo" else node.outputs[0]
        self.tree.links.new(output, socket)

    def info(self, ob, space="RELATIVE"):
        node = self.add("GeometryNodeObjectInfo", Object=ob)
        node.transform_space = space
        return node

    def on_the_way(self, kind, socket, **values):
        """Put a node before a socket."""
        node, before = self.add(kind, **values), socket.links[0].from_socket
        self.tree.links.new(before, node.inputs[0])
        self.link(node, socket)
        return node


def circle(nodes):
    return nodes.add("GeometryNodeCurvePrimitiveCircle", Radius=0.25, Resolution=12)


def rectangle(nodes):
    return nodes.add("GeometryNodeCurvePrimitiveQuadrilateral", Width=0.5, Height=0.2)


def bare(**options):
    """A curve without a bevel."""
    return path(bevel_depth=0, **options)


@pytest.mark.parametrize("profile", [circle, rectangle])
@pytest.mark.parametrize("twist", ["MINIMUM", "Z_UP"])
@pytest.mark.parametrize("cyclic", [False, True])
def test_nodes_with_a_primitive_profile(scene, profile, twist, cyclic):
    ob = bare(twist_mode=twist, cyclic=cyclic)
    nodes = Nodes(ob, profile)
    sweep = alike(ob, depth=cyclic * depth(12, 0.25))
    assert parameters_of(sweep).trajectory_object == ob and not nodes.modifier.show_viewport


@pytest.mark.parametrize("twist", ["MINIMUM", "Z_UP"])
@pytest.mark.parametrize("caps", [False, True])
def test_nodes_with_a_profile_object(scene, twist, caps):
    outline, ob = hook(), bare(twist_mode=twist)
    Nodes(ob, lambda nodes: nodes.info(outline, "ORIGINAL"), caps)
    sweep = alike(ob, caps)
    assert parameters_of(sweep).contour_object == outline


def test_nodes_with_a_number_of_the_modifier_and_a_material(scene):
    ob, red = bare(), bpy.data.materials.new("red")
    nodes = Nodes(ob, circle)
    nodes.tree.interface.new_socket("Size", in_out="INPUT", socket_type="NodeSocketFloat").default_value = 0.125
    ring = nodes.node.inputs["Profile Curve"].links[0].from_node
    nodes.tree.links.new(nodes.given.outputs["Size"], ring.inputs["Radius"])
    nodes.on_the_way("GeometryNodeSetShadeSmooth", nodes.out.inputs[0])
    nodes.on_the_way("GeometryNodeSetMaterial", nodes.out.inputs[0], Material=red)
    ob.modifiers.remove(nodes.modifier)
    ob.modifiers.new("Tube", "NODES").node_group = nodes.tree  # which takes the default of the new input
    sweep = alike(ob)
    assert parameters_of(sweep).contour_circle_radius == 0.125
    assert [material for material in sweep.data.materials] == [red, red]


def test_nodes_scaled_by_the_radius_of_the_points(scene):
    ob = bare()
    ob.data.splines[0].bezier_points[1].radius = 2
    nodes = Nodes(ob, circle)
    nodes.link(nodes.add("GeometryNodeInputRadius"), nodes.node.inputs["Scale"])
    alike(ob)


@pytest.mark.parametrize("space", ["RELATIVE", "ORIGINAL"])
@pytest.mark.parametrize("twist", ["MINIMUM", "Z_UP"])
def test_nodes_along_the_curve_of_another_object(scene, space, twist):
    ob, along = add("host", bpy.data.meshes.new("host")), bare()
    along.matrix_world = Matrix.Translation((3, 2, 1)) @ Matrix.Rotation(1, 4, "X")
    along.data.twist_mode = twist
    ob.matrix_world = Matrix.Translation((-5, 0, 0)) @ Matrix.Rotation(2, 4, "Z")
    Nodes(ob, rectangle, path=along, space=space)
    sweep = alike(ob)
    assert parameters_of(sweep).trajectory_object == along and ob.hide_viewport and ob.hide_render


def resampled(nodes, ob):
    nodes.on_the_way("GeometryNodeResampleCurve", nodes.node.inputs["Curve"])


def scaled_profile(nodes, ob):
    outline = hook()
    outline.scale.x = 2
    nodes.link(nodes.info(outline, "ORIGINAL"), nodes.node.inputs["Profile Curve"])


def moved_profile(nodes, ob):
    outline = hook()
    outline.location.x = 2
    nodes.link(nodes.info(outline), nodes.node.inputs["Profile Curve"])


def thick(nodes, ob):
    ob.data.splines[0].bezier_points[1].radius = 2


def beveled(nodes, ob):
    ob.modifiers.new("Bevel", "BEVEL")


@pytest.mark.parametrize(
    ("spoil", "refusal"),
    [
        (resampled, "the node 'Resample Curve' cannot be converted"),
        (scaled_profile, "the profile must have a scale of 1, got 'hook'"),
        (moved_profile, "the profile must stand where the swept object is, got 'hook'"),
        (thick, "the radius of all points must be 1, or Radius be the scale of Curve to Mesh"),
        (beveled, "the modifier with Curve to Mesh must be the last, got 'Tube'"),
    ],
)
def test_nodes_that_no_sweep_is_are_refused(scene, spoil, refusal):
    ob = bare()
    nodes = Nodes(ob, circle)
    spoil(nodes, ob)
    select(ob)
    with pytest.raises(RuntimeError, match=f"{ob.name}: {refusal}"):
        bpy.ops.object.sweep_convert()
    assert nodes.modifier.show_viewport


def test_a_tree_of_very_many_nodes_is_not_searched(scene):
    """The sidebar asks on every redraw."""
    ob = bare()
    nodes = Nodes(ob, circle)
    assert curve_to_mesh.modifier_of(ob) == nodes.modifier
    for _ in range(curve_to_mesh.MOST_NODES):
        nodes.add("NodeReroute")
    assert curve_to_mesh.modifier_of(ob) is None
