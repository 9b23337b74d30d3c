# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep follows the objects it is made from: edited, moved, scaled, exchanged, deleted."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from mathutils import Matrix
from scenes import add, curve, extent, parameters_of, places, select, square, straight, sweep, text

import sweep_addon as sw
from sweep_addon.bridge import curves, objects, placing
from sweep_addon.core.contours import reading
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep


def update():
    bpy.context.view_layer.update()


def kept(ob, before, sentence):
    """Whether an object still has the mesh it had, and says that."""
    return np.array_equal(places(ob.data), before) and sentence in ob.data.sweep.error


BENT = [(0, 0, 0), (0, 0, 2), (0, 2, 2)]


def test_corners_of_a_curve_of_straight_legs_are_the_sweeps(scene):
    """A curve does not say what becomes of its corners; whoever copies the shape takes them with it."""
    ob = sweep(trajectory=curve("POLY", BENT))
    group, mitred = parameters_of(ob), len(ob.data.vertices)
    group.trajectory_polyline_corner = "ROUND"
    group.trajectory_polyline_corner_round_radius = 0.5
    shape = sw.from_object(ob)
    assert shape.trajectory == sw.trajectories.Polyline(BENT, corner=sw.corners.Round(0.5))
    assert len(ob.data.vertices) == len(shape.mesh().vertices) > mitred
    before = places(ob.data)
    group.trajectory_polyline_corner_round_radius = 2.5
    assert kept(ob, before, "trajectory.corner.radius: must be at most 2 to fit into the leg from point 1 to point 2")
    group.trajectory_polyline_corner = "BEVEL"
    assert ob.data.sweep.error == "" and len(ob.data.vertices) == mitred * 4 // 3


def test_edited_curve_is_followed(scene):
    path = straight()
    ob = sweep(trajectory=path)
    path.data.splines[0].points[1].co.z = 5
    update()
    assert extent(ob) == pytest.approx((1, 1, 5))


def test_radius_and_tilt_of_a_curve_are_followed(scene):
    path = straight()
    ob = sweep(trajectory=path, contour=square())
    for point in path.data.splines[0].points:
        point.radius, point.tilt = 2, np.pi / 4
    update()
    assert extent(ob) == pytest.approx((2**1.5, 2**1.5, 2))
    select(path)
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.curve.select_all(action="SELECT")
    bpy.ops.curve.tilt_clear()
    update()
    assert extent(ob) == pytest.approx((2, 2, 2))


@pytest.mark.parametrize("how", ["hide_set", "hide_viewport", "other collection"])
def test_edited_curve_is_followed_where_it_is_hidden(scene, how):
    path, profile = straight(), square()
    ob = sweep(trajectory=path, contour=profile)
    for hidden in (path, profile):
        if how == "hide_set":
            hidden.hide_set(True)
        elif how == "hide_viewport":
            hidden.hide_viewport = True
        else:
            away = bpy.data.collections.new("away")
            scene.collection.children.link(away)
            away.objects.link(hidden)
            scene.collection.objects.unlink(hidden)
            bpy.context.view_layer.layer_collection.children[away.name].exclude = True
    update()
    path.data.splines[0].points[1].co.z = 5
    profile.scale.x = 3
    update()
    assert extent(ob) == pytest.approx((3, 1, 5)) and ob.data.sweep.error == ""


def test_edited_curve_is_followed_in_its_edit_mode(scene):
    path = straight()
    ob = sweep(trajectory=path)
    select(path)
    bpy.ops.object.mode_set(mode="EDIT")
    path.data.splines[0].points[1].co.z = 5
    update()
    assert extent(ob) == pytest.approx((1, 1, 5))
    bpy.ops.curve.select_all(action="SELECT")
    bpy.ops.curve.subdivide()
    bpy.ops.object.mode_set(mode="OBJECT")
    path.data.splines[0].points[2].co.z = 6
    update()
    assert extent(ob) == pytest.approx((1, 1, 6))


def test_moved_and_turned_trajectory_takes_the_sweep_along(scene):
    path = straight()
    ob = sweep(trajectory=path)
    path.location, path.rotation_euler = (5, 0, 1), (0, np.pi / 2, 0)
    update()
    world = np.c_[places(ob.data), np.ones(len(ob.data.vertices))] @ np.array(ob.matrix_world).T
    assert world[:, :3].min(axis=0) == pytest.approx((5, -0.5, 0.5), abs=1e-5)
    assert world[:, :3].max(axis=0) == pytest.approx((7, 0.5, 1.5), abs=1e-5)


def test_scaled_contour_object_scales_the_contour(scene):
    profile = square()
    ob = sweep(contour=profile)
    profile.scale = (3, 2, 7)
    profile.location, profile.rotation_euler = (9, 9, 9), (1, 1, 1)  # a contour lies in its own plane
    update()
    assert extent(ob) == pytest.approx((3, 2, 2))


def test_each_spline_is_one_tube(scene):
    legs = ([(x, 0, 0), (x, 0, 2)] for x in (0, 5, 10))
    ob = sweep(trajectory=curve("POLY", *legs))
    assert extent(ob) == pytest.approx((11, 1, 2))
    assert len(ob.data.vertices) == 3 * 64 * 2 and len(ob.data.polygons) == 3 * (64 + 2)


def test_a_spline_without_length_is_passed_over(scene):
    ob = sweep(trajectory=curve("POLY", [(0, 0, 0), (0, 0, 2)], [(5, 0, 0), (5, 0, 0)]))
    assert extent(ob) == pytest.approx((1, 1, 2)) and ob.data.sweep.error == ""


def test_text_is_a_contour_and_is_followed(scene):
    letters = text("I")
    ob = sweep(contour=letters)
    width = extent(ob)[0]
    assert width == pytest.approx(letters.dimensions.x, rel=1e-2)
    letters.data.body = "III"
    update()
    assert extent(ob)[0] == pytest.approx(letters.dimensions.x, rel=1e-2)
    assert extent(ob)[0] > 2.5 * width


@pytest.mark.parametrize("kind", ["curve", "text"])
def test_a_contour_that_stays_is_flattened_once(scene, monkeypatch, kind):
    """A drawing of many curves takes ten times as long as all else that a slider asks for."""
    bpy.ops.curve.primitive_bezier_circle_add(radius=0.7)
    ob = sweep(contour=text("S!") if kind == "text" else bpy.context.active_object)
    asked = []
    for module, name in ((curves, "place"), (reading, "flatten_cubics")):
        function = getattr(module, name)
        monkeypatch.setattr(module, name, lambda *given, function=function: asked.append(given) or function(*given))
    for turn in (1.0, 2.0):
        parameters_of(ob).twist_constant_value = turn
    assert not asked and ob.data.sweep.error == ""


def test_contour_that_is_not_cyclic_is_closed(scene):
    ob = sweep(contour=curve("POLY", [(0, 0, 0), (1, 0, 0), (1, 1, 0)]))
    assert len(ob.data.vertices) == 6 and extent(ob) == pytest.approx((1, 1, 2))


def turned(contour, **given):
    """A rotational sweep of a contour object."""
    shape = sw.RotationalSweep(**given)
    ob = add("turned", objects.new_mesh(shape, contour=contour))
    placing.attach(ob, contour)
    update()
    return ob


def test_profile_of_a_turn_is_followed_in_its_own_space(scene):
    """A curve that is not cyclic stays open; what moves and scales it moves and scales the sweep, once."""
    profile = curve("POLY", [(0, 0, 0), (1, 0, 0), (1, 2, 0)])
    ob = turned(profile)
    assert ob.parent == profile and extent(ob)[1] == 2 and ob.data.sweep.error == ""
    rings, poles = ob.data.sweep.rings, 1
    assert len(ob.data.vertices) == 2 * rings + poles
    profile.scale, profile.location = (3, 3, 3), (7, 0, 0)
    update()
    assert extent(ob)[1] == 2 and ob.dimensions[1] == pytest.approx(6) and ob.matrix_world.translation.x == 7
    profile.data.splines[0].points[2].co.y = 4
    update()
    assert extent(ob)[1] == 4


def test_profile_across_the_axis_keeps_the_mesh_and_says_so(scene):
    profile = square()
    profile.data.transform(Matrix.Translation((2, 0, 0)))
    ob = turned(profile)
    before = len(ob.data.vertices)
    profile.data.transform(Matrix.Translation((-2, 0, 0)))
    update()
    assert ob.data.sweep.error.startswith("contour: must be on one side of the axis")
    assert len(ob.data.vertices) == before
    ob.data.sweep.rotational_sweep.crossing = "SPLIT"
    rings = ob.data.sweep.rings  # of both bodies
    assert ob.data.sweep.error == "" and len(ob.data.vertices) == 2 * rings + 2 * 2


def test_removed_curve_keeps_the_mesh_and_says_so(scene):
    path = straight()
    ob = sweep(trajectory=path)
    before = places(ob.data)
    bpy.data.objects.remove(path)
    update()
    assert kept(ob, before, "trajectory: must be an object of the scene; none is chosen, or it was deleted")


@pytest.mark.parametrize("parameter", ["trajectory", "contour"])
def test_curve_deleted_by_a_person_keeps_the_mesh_and_says_so(scene, parameter):
    """The mesh still uses the object, so it lives on, in no scene."""
    made = {"trajectory": straight, "contour": square}[parameter]()
    ob = sweep(**{parameter: made})
    before, name = places(ob.data), made.name
    select(made)
    bpy.ops.object.delete()
    update()
    assert kept(ob, before, f"{parameter}: must be an object of the scene; '{name}' was deleted, or is in no scene yet")
    parameters_of(ob).contour_circle_radius = 2
    parameters_of(ob).trajectory_line_end = (0, 0, 7)
    assert kept(ob, before, f"'{name}' was deleted")


def test_curve_unlinked_from_the_scene_and_linked_again_is_followed_again(scene):
    path = straight()
    ob = sweep(trajectory=path)
    before = places(ob.data)
    scene.collection.objects.unlink(path)
    parameters_of(ob).contour_circle_radius = 1
    assert kept(ob, before, "was deleted")
    scene.collection.objects.link(path)
    path.data.splines[0].points[1].co.z = 5
    update()
    assert ob.data.sweep.error == "" and extent(ob) == pytest.approx((2, 2, 5))


def test_another_curve_chosen_or_given_other_data_is_followed(scene):
    path, other = straight(2), straight(5)
    ob = sweep(trajectory=path)
    parameters_of(ob).trajectory_object = other
    assert extent(ob)[2] == 5
    path.data.splines[0].points[1].co.z = 9  # no longer its trajectory
    update()
    assert extent(ob)[2] == 5
    other.data = path.data
    update()
    assert extent(ob)[2] == 9


def test_an_error_of_the_curve_is_said_and_mended(scene):
    path = straight()
    ob = sweep(trajectory=path)
    before = places(ob.data)
    path.data.splines[0].points[1].co.z = 0
    update()
    assert kept(ob, before, "trajectory: must be a curve with a length, got 'path'")
    path.data.splines[0].points[1].co.z = 2
    update()
    assert ob.data.sweep.error == ""


def test_self_crossing_contour_keeps_the_mesh_and_says_so(scene):
    profile = square()
    ob = sweep(contour=profile)
    before = places(ob.data)
    points = profile.data.splines[0].points
    points[0].co.x, points[1].co.x = points[1].co.x, points[0].co.x  # an hourglass
    update()
    assert kept(ob, before, "contour")


def test_an_object_of_another_kind_is_refused_in_a_sentence(scene):
    ob = sweep(trajectory=straight())
    before = places(ob.data)
    parameters_of(ob).trajectory_object = add("plain", bpy.data.meshes.new("plain"))
    assert kept(ob, before, "trajectory: must be a curve object, got 'mesh'")
    parameters_of(ob).trajectory_object = text("I")
    assert kept(ob, before, "trajectory: must be a curve object, got")
    parameters_of(ob).contour_object = bpy.data.objects["plain"]
    parameters_of(ob).contour, parameters_of(ob).trajectory = "OBJECT", "LINE"
    assert kept(ob, before, "contour: must be a curve or text object, got 'mesh'")


def test_a_curve_converted_to_a_mesh_is_refused_in_a_sentence(scene):
    path = curve("POLY", [(0, 0, 0), (0, 0, 1), (0, 1, 2)])
    ob = sweep(trajectory=path)
    before = places(ob.data)
    select(path)
    bpy.ops.object.convert(target="MESH")
    parameters_of(ob).contour_circle_radius = 1
    assert path.type == "MESH" and kept(ob, before, "trajectory: must be a curve object, got 'mesh'")


def test_no_object_chosen_yet_is_said(scene):
    ob = sweep()
    before = places(ob.data)
    parameters_of(ob).trajectory = "OBJECT"
    assert kept(ob, before, "trajectory: must be an object of the scene; none is chosen")


def test_curve_with_an_open_spline_beside_a_cyclic_one_is_swept_with_its_dangling_edge(scene):
    contour = curve("POLY", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(1, 0, 0), (2, 0, 0)])
    contour.data.splines[0].use_cyclic_u = True
    ob = add("sweep", objects.new_mesh(TranslationalSweep(), "sweep", contour=contour))
    update()
    assert ob.data.sweep.told == "Parts: 1 solid (3D), 1 surface (2D); 1 non-manifold edge."
    contour.data.splines[1].use_cyclic_u = True  # of two points: it stays a line
    contour.data.splines[0].points[2].co = (2, 2, 0, 1)
    update()
    assert extent(ob) == pytest.approx((2, 2, 1))
    ob.data.sweep.translational_sweep.regularize = True
    assert ob.data.sweep.told == "" and extent(ob) == pytest.approx((2, 2, 1))
    ob.data.sweep.translational_sweep.contour = "MIXED"
    ob.data.sweep.translational_sweep.direction = (1, 0, 0)
    assert "regularize: must be off where no part is solid, got '1 surface (2D)" in ob.data.sweep.error
    ob.data.sweep.translational_sweep.regularize = False
    assert ob.data.sweep.told == "Parts: 1 surface (2D), 1 curve (1D); 1 dangling edge." and not ob.data.sweep.error


def test_a_script_gives_objects_of_the_scene_by_the_names_of_parameters(scene):
    path, outline = straight(), square()
    path.location.x = 3
    ob = sw.to_object(sw.GeneralizedCylinder(), "rail", trajectory=path, contour=outline)
    assert ob.parent == path and ob.name == "rail"
    path.data.splines[0].points[1].co.z = 5
    update()
    assert extent(ob) == pytest.approx((1, 1, 5)) and ob.matrix_world.translation.x == 3


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"trajectry": None}, "object: must be one of contour, trajectory, got 'trajectry'"),
        ({"trajectory": 7}, "trajectory: must be an object of the scene, got 7"),
        ({"trajectory": "mesh"}, "trajectory: must be a curve object, got 'mesh'"),
    ],
)
def test_objects_that_cannot_stand_for_parameters_are_refused(scene, given, sentence):
    given = {key: sweep() if value == "mesh" else value for key, value in given.items()}
    before = len(bpy.data.meshes), len(bpy.data.objects)
    with pytest.raises(sw.ShapeError) as refusal:
        sw.to_object(sw.GeneralizedCylinder(), **given)
    assert str(refusal.value) == sentence
    assert (len(bpy.data.meshes), len(bpy.data.objects)) == before


def test_a_shape_that_is_given_an_object_says_where_it_belongs(scene):
    with pytest.raises(sw.ShapeError, match=r"sw\.to_object\(shape, trajectory=ob\)"):
        sw.GeneralizedCylinder(trajectory=straight())
