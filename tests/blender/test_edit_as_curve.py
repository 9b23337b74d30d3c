# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edit as Curve: a path or contour of numbers becomes a curve; nothing moves, and the sweep follows it."""

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from mathutils.bvhtree import BVHTree
from scenes import add, cube, curve, extent, parameters_of, select, straight, sweep

import sweep_addon as sw
from sweep_addon.bridge import objects

WASHER = sw.contours.Outline(loops=[[(-1, -1), (1, -1), (1, 1), (-1, 1)], [(-0.5, -0.5), (0.5, -0.5), (0, 0.5)]])
TRAJECTORIES = {
    "line": sw.trajectories.Line(end=(0, 0, 2)),
    "arc": sw.trajectories.Arc(),
    "ring": sw.trajectories.Arc(angle=6.283185307179586),
    "helix": sw.trajectories.Helix(),
    "knot": sw.trajectories.TorusKnot(),
    "polyline": sw.trajectories.Polyline([(0, 0, 0), (3, 0, 0), (3, 3, 0), (0, 3, 1)], closed=True),
    "round corners": sw.trajectories.Polyline([(0, 0, 0), (3, 0, 0), (3, 3, 0)], corner=sw.corners.Round(1.0)),
    "bezier": sw.trajectories.Bezier(),
    "nurbs": sw.trajectories.Nurbs(),
    "sampled": sw.trajectories.Sampled(closed=True),
    "measured radii": sw.trajectories.Sampled([(0, 0, z) for z in range(4)], radii=[1, 0.4, 0.9, 1]),
    "formula": sw.trajectories.Formula(),
}
CONTOURS = {
    "circle": sw.contours.Circle(0.2),
    "hexagon": sw.contours.Circle(0.2, points=6),
    "rounded": sw.contours.Rectangle(width=0.5, height=0.25, rounding=0.1),
    "washer": WASHER,
}


@pytest.fixture
def place(scene):
    """A function that puts an object where nothing is simple: turned, scaled, and parented to an object that is too."""

    def put(ob):
        parent = add("parent", None)
        parent.location, parent.rotation_euler = (1, 2, 3), (0.3, 0.2, 0.1)
        bpy.context.view_layer.update()
        ob.parent, ob.matrix_parent_inverse = parent, parent.matrix_world.inverted()
        parent.location.x = 4
        ob.location, ob.rotation_euler, ob.scale = (-2, 0, 1), (1, 0.5, 0.25), (2, 2, 2)
        bpy.context.view_layer.update()
        select(ob)
        return ob

    return put


def surface(ob):
    """The surface of an object in the world, and its vertices there."""
    bpy.context.view_layer.update()
    depsgraph = bpy.context.evaluated_depsgraph_get()
    mesh = ob.evaluated_get(depsgraph).data
    vertices = [ob.matrix_world @ vertex.co for vertex in mesh.vertices]
    return BVHTree.FromPolygons(vertices, [list(polygon.vertices) for polygon in mesh.polygons]), vertices


def apart(one, other):
    """How far the vertices of each of two surfaces are from the other surface at most."""
    (tree, vertices), (other_tree, other_vertices) = one, other
    across = [other_tree.find_nearest(v)[3] for v in vertices]
    return max(across + [tree.find_nearest(v)[3] for v in other_vertices])


@pytest.mark.parametrize("path", TRAJECTORIES)
def test_path_as_curve_keeps_the_surface_in_its_place(place, path):
    ob = place(sweep(contour=CONTOURS["rounded"], trajectory=TRAJECTORIES[path]))
    before, parent = surface(ob), ob.parent
    assert bpy.ops.object.sweep_edit_as_curve(parameter="trajectory") == {"FINISHED"}
    curve = parameters_of(ob).trajectory_object
    assert ob.parent == curve and curve.parent == parent and ob.data.sweep.error == ""
    assert apart(before, surface(ob)) < 0.005 * max(ob.dimensions)


@pytest.mark.parametrize("contour", CONTOURS)
def test_contour_as_curve_keeps_the_surface_in_its_place(place, contour):
    ob = place(sweep(contour=CONTOURS[contour]))
    before = surface(ob)
    assert bpy.ops.object.sweep_edit_as_curve(parameter="contour") == {"FINISHED"}
    assert parameters_of(ob).contour == "OBJECT" and ob.data.sweep.error == ""
    assert apart(before, surface(ob)) < 1e-5 * max(ob.dimensions)


@pytest.mark.parametrize(
    "shape",
    [
        sw.TranslationalSweep(WASHER, taper=0.1),
        sw.TranslationalSweep(sw.contours.Outline([[(0, 0), (1, 0), (1, 1)]], closed=False)),
        sw.RotationalSweep(),
    ],
    ids=["frustum", "sheet", "pulley"],
)
def test_contour_of_a_shape_without_a_path_becomes_the_curve_that_carries_it(place, shape):
    ob = place(sw.to_object(shape))
    before, parent = surface(ob), ob.parent
    assert bpy.ops.object.sweep_edit_as_curve(parameter="contour") == {"FINISHED"}
    _, group = objects.group_of(ob.data)
    assert ob.parent == group.contour_object and ob.parent.parent == parent and ob.data.sweep.error == ""
    assert apart(before, surface(ob)) < 1e-5 * max(ob.dimensions)
    select(ob)
    with pytest.raises(RuntimeError, match="sweep has no trajectory"):
        bpy.ops.object.sweep_edit_as_curve(parameter="trajectory")


def test_curves_are_followed_once_they_are_edited(scene):
    ob = sweep()
    select(ob)
    bpy.ops.object.sweep_edit_as_curve(parameter="trajectory")
    select(ob)
    bpy.ops.object.sweep_edit_as_curve(parameter="contour")
    group = parameters_of(ob)
    group.contour_object.scale = (3, 1, 1)
    for point in group.trajectory_object.data.splines[0].bezier_points:
        point.co.z, point.handle_left.z, point.handle_right.z = (
            2 * part.z for part in (point.co, point.handle_left, point.handle_right)
        )
    bpy.context.view_layer.update()
    assert extent(ob) == pytest.approx((3, 1, 4), rel=1e-5)


def test_contour_stands_beside_the_sweep(place):
    ob = place(sweep())
    bpy.ops.object.sweep_edit_as_curve(parameter="contour")
    bpy.context.view_layer.update()
    contour = parameters_of(ob).contour_object
    _, vertices = surface(ob)
    right = max(vertex.x for vertex in vertices)
    assert contour.matrix_world.translation.x - contour.dimensions.x / 2 > right


def test_keyframes_of_other_parameters_stay(scene):
    ob = sweep()
    ob.data.keyframe_insert("sweep.generalized_cylinder.twist_constant_value", frame=1)
    select(ob)
    bpy.ops.object.sweep_edit_as_curve(parameter="trajectory")
    assert ob.data.animation_data.action


def test_what_is_a_curve_already_is_edited_and_not_made_one_again(scene):
    """Another would leave one of its splines, and the first curve without its sweep."""
    path = curve("POLY", [(0, 0, 0), (0, 0, 2)], [(5, 0, 0), (5, 0, 2)])
    ob = sweep(trajectory=path)
    select(ob)
    before = set(bpy.data.objects)
    assert bpy.ops.object.sweep_edit_as_curve(parameter="trajectory") == {"FINISHED"}
    assert bpy.context.active_object == path and path.mode == "EDIT" and bpy.context.selected_objects == [path]
    bpy.ops.object.mode_set(mode="OBJECT")
    assert set(bpy.data.objects) == before and parameters_of(ob).trajectory_object == path
    assert extent(ob) == pytest.approx((6, 1, 2))


@pytest.mark.parametrize("live", [True, False])
def test_of_a_body_the_mesh_is_edited_and_of_a_sweep_the_parameters(scene, live):
    """Edits of a mesh that is made of parameters are lost when one of these changes."""
    body = sweep() if live else cube()
    ob = add("offset", objects.new_mesh(sw.OffsetSurface(radius=0.1), body=body))
    select(ob)
    assert bpy.ops.object.sweep_edit_as_curve(parameter="body") == {"FINISHED"}
    assert bpy.context.active_object == body and bpy.context.selected_objects == [body]
    assert body.mode == ("OBJECT" if live else "EDIT")
    bpy.ops.object.mode_set(mode="OBJECT")


def test_a_curve_that_is_hidden_is_not_edited(scene):
    path = straight()
    ob = sweep(trajectory=path)
    path.hide_set(True)
    select(ob)
    with pytest.raises(RuntimeError, match="The trajectory is the object 'path', which is not visible: show it"):
        bpy.ops.object.sweep_edit_as_curve(parameter="trajectory")
    assert bpy.context.active_object == ob and bpy.context.mode == "OBJECT"


def test_twins_that_share_the_mesh_stay_in_their_places(scene):
    ob = sweep()
    twin = add("twin", ob.data)
    twin.location.x = 5
    select(ob)
    before = surface(twin)
    bpy.ops.object.sweep_edit_as_curve(parameter="trajectory")
    assert apart(before, surface(twin)) < 1e-5 and twin.parent is None


def test_refused_shape_makes_no_curve(scene):
    ob = sweep(trajectory=straight())
    bpy.data.objects.remove(parameters_of(ob).trajectory_object)
    select(ob)
    before = set(bpy.data.objects)
    with pytest.raises(RuntimeError, match="trajectory: must be an object"):
        bpy.ops.object.sweep_edit_as_curve(parameter="contour")
    assert set(bpy.data.objects) == before and len(bpy.data.curves) == 1
