# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A PD curve sweep in Blender: its direction from a second curve, from tilt, or from empties, as its planes are."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from mathutils import Euler
from scenes import add, curve, places, select

import sweep_addon as sw
from sweep_addon.bridge import objects, placing

HANDLES = [((0, 0, -1), (0, 0, 0), (0, 0, 1)), ((0, 0, 3), (0, 0, 4), (0, 0, 5))]
RAIL = [((1, 0, -1), (1, 0, 0), (1, 0, 1)), ((0, 1, 3), (0, 1, 4), (0, 1, 5))]
CONTOUR = sw.contours.Rectangle(0.4, 0.2)
STRAIGHT, BESIDE = ([sum(row, ()) for row in rows] for rows in (HANDLES, RAIL))


def update():
    bpy.context.view_layer.update()


def sweep(**inputs):
    """A PD curve sweep of a small rectangle, in the space of its trajectory."""
    shape = sw.PDCurveSweep(contour=CONTOUR, samples=sw.sampling.Count(9))
    update()
    return placing.place_along(bpy.context, objects.new_mesh(shape, "solid", **inputs), inputs["trajectory"])


def empty(place, turn=(0, 0, 0), parent=None):
    ob = add("arrow", None)
    ob.location, ob.rotation_euler, ob.parent = place, turn, parent
    update()
    return ob


def ends(ob):
    """The points of the first and the last ring, (m, 3) each."""
    columns = places(ob.data).reshape(-1, ob.data.sweep.rings, 3)
    return columns[:, 0], columns[:, -1]


def axis(ring):
    """The unit vector of the contour's x axis, by the corners of its rectangle."""
    x = CONTOUR.section().points[:, 0]
    return x @ ring / (x @ x)


def test_a_second_curve_is_the_guide(scene):
    guide = curve("BEZIER", BESIDE)
    ob = sweep(trajectory=curve("BEZIER", STRAIGHT), direction=guide)
    first, last = ends(ob)
    assert axis(first) == pytest.approx((1, 0, 0), abs=1e-6) and axis(last) == pytest.approx((0, 1, 0), abs=1e-6)
    guide.data.splines[0].bezier_points[1].co = (-1, 0, 4)
    guide.data.splines[0].bezier_points[1].handle_left = (-1, 0.1, 3)
    update()
    assert axis(ends(ob)[1]) == pytest.approx((-1, 0, 0), abs=1e-6)
    shape = sw.from_object(ob)
    assert isinstance(shape.direction, sw.directions.Guide) and sw.load(sw.dump(shape)) == shape


def test_a_guide_is_read_where_it_stands(scene):
    """In the trajectory's space: moved and turned with it, nothing changes."""
    path, guide = curve("BEZIER", STRAIGHT), curve("BEZIER", BESIDE)
    ob = sweep(trajectory=path, direction=guide)
    before = places(ob.data)
    for moved in (path, guide):
        moved.location, moved.rotation_euler = (3, 2, 1), Euler((0.3, 0.2, 0.1))
    update()
    assert places(ob.data) == pytest.approx(before, abs=1e-6)
    guide.rotation_euler.z += 1.0
    update()
    assert np.abs(places(ob.data) - before).max() > 0.05


def test_empties_along_the_trajectory_are_arrows(scene):
    """Of their z axes; those that are parented to the one that is chosen count too, and are followed."""
    root = empty((0.3, 0, 0), (0, np.pi / 2, 0))  # its z axis along x
    child = empty((0, 0, 0), parent=root)
    child.matrix_world = empty((0, 0.2, 4), (-np.pi / 2, 0, 0)).matrix_world.copy()  # its z axis along y
    update()
    ob = sweep(trajectory=curve("BEZIER", STRAIGHT), direction=root)
    assert axis(ends(ob)[0]) == pytest.approx((1, 0, 0), abs=1e-6)
    assert axis(ends(ob)[1]) == pytest.approx((0, 1, 0), abs=1e-6)
    child.matrix_world = empty((0, 0.2, 4), (np.pi / 2, 0, 0)).matrix_world.copy()
    update()
    assert axis(ends(ob)[1]) == pytest.approx((0, -1, 0), abs=1e-6)


def test_an_empty_that_is_the_direction_is_gone_to_and_has_nothing_to_edit(scene):
    arrow = empty((0.3, 0, 0), (0, np.pi / 2, 0))
    select(sweep(trajectory=curve("BEZIER", STRAIGHT), direction=arrow))
    assert bpy.ops.object.sweep_edit_as_curve(parameter="direction") == {"FINISHED"}
    assert bpy.context.active_object == arrow and bpy.context.selected_objects == [arrow]
    assert bpy.context.mode == "OBJECT"


def test_the_tilt_of_the_curve_is_the_direction_of_a_curve_that_is_swept_first(scene):
    path = curve("BEZIER", STRAIGHT)
    path.data.splines[0].bezier_points[1].tilt = np.pi / 2
    select(path)
    assert bpy.ops.object.sweep_selected(shape="PD_CURVE_SWEEP") == {"FINISHED"}
    ob = bpy.context.active_object
    assert isinstance(sw.from_object(ob).direction, sw.directions.Tilt)
    first, last = ends(ob)
    assert abs(axis(first) @ axis(last)) < 1e-6


def test_an_empty_is_a_limiting_plane(scene):
    plane = empty((0, 0, 3), (0, np.pi / 4, 0))
    ob = sweep(trajectory=curve("BEZIER", STRAIGHT), direction=curve("BEZIER", BESIDE), end=plane)
    normal = np.array((1, 0, 1)) / np.sqrt(2)
    assert np.abs((ends(ob)[1] - (0, 0, 3)) @ normal).max() < 1e-6
    plane.location.z = 2
    update()
    assert np.abs((ends(ob)[1] - (0, 0, 2)) @ normal).max() < 1e-6
    before = places(ob.data)
    plane.rotation_euler.y = np.pi / 2
    update()
    assert ob.data.sweep.error.startswith("end: must cut ")  # it cuts nowhere, or, but for rounding, far off
    assert np.array_equal(places(ob.data), before)


def test_objects_beside_no_trajectory_object_are_refused(scene):
    guide = curve("BEZIER", BESIDE)
    with pytest.raises(sw.ShapeError, match="^direction: must not be an object where the trajectory is none: press"):
        objects.new_mesh(sw.PDCurveSweep(), direction=guide)


LEVEL = sw.directions.Cubic([(0, 0, 1)] * 4)
TURNING = {
    "pd curve": (sw.PDCurveSweep(), 1e-6),
    "arrows": (sw.PDCurveSweep(direction=sw.directions.Arrows([(0, 1, 0, 0), (1, 1, 0, 1)])), 1e-4),
    "tilt": (sw.PDCurveSweep(trajectory=sw.trajectories.Helix(turns=1), direction="tilt"), 1e-3),
    "closed": (sw.PDCurveSweep(trajectory=sw.trajectories.TorusKnot(), direction=LEVEL), 4e-3),
}


@pytest.mark.parametrize("name", TURNING)
def test_a_direction_becomes_a_guide_and_the_axes_stay(scene, name):
    """Of a PD curve to single precision; else the guide is of the fourth order, and so is the path's own curve."""
    shape, tolerance = TURNING[name]
    ob = sw.to_object(shape, "solid")
    select(ob)
    assert bpy.ops.object.sweep_edit_as_curve(parameter="direction") == {"FINISHED"}
    update()
    assert ob.data.sweep.error == "" and set(objects.inputs(ob.data)) == {"trajectory", "direction"}
    model = np.random.default_rng(3).uniform((-0.2, -0.2, 0), (0.2, 0.2, 0.99 * shape.trajectory.length()), (200, 3))
    assert np.abs(sw.from_object(ob).bend(model) - shape.bend(model)).max() < tolerance
    guide = objects.inputs(ob.data)["direction"]
    assert guide.parent == objects.inputs(ob.data)["trajectory"]
    bpy.ops.object.sweep_edit_as_curve(parameter="direction")
    assert bpy.context.active_object == guide and guide.mode == "EDIT"


def test_meshes_are_bent_along_the_active_sweep(scene):
    """A straight cube of many slices becomes a piece of a ring: every vertex keeps its distance from the axis."""
    shape = sw.PDCurveSweep(
        sw.contours.Circle(0.1), sw.trajectories.Arc(2.0, np.pi), sw.directions.Arrows([(0, 0, 0, 1)])
    )
    sweep = sw.to_object(shape, "bender")
    sweep.location = (1, 2, 3)
    model = sw.to_object(sw.TranslationalSweep(sw.contours.Rectangle(0.4, 0.2), 3.0, steps=30), "rod")
    select(model)
    sweep.select_set(True)
    bpy.context.view_layer.objects.active = sweep
    update()
    before = set(bpy.data.objects)
    assert bpy.ops.object.sweep_bend() == {"FINISHED"}
    (made,) = set(bpy.data.objects) - before
    assert made.data.sweep.kind == "NONE" and made.matrix_world == sweep.matrix_world
    assert places(made.data) == pytest.approx(shape.bend(places(model.data)), abs=1e-6)
    x, y, z = places(made.data).T
    assert np.abs(np.hypot(x, y) - 2).max() == pytest.approx(0.1, abs=1e-6) and np.abs(z).max() == pytest.approx(0.2)
    bpy.ops.object.sweep_bend(fit=True)
    (fitted,) = set(bpy.data.objects) - before - {made}
    assert np.arctan2(places(fitted.data)[:, 1], places(fitted.data)[:, 0]).max() == pytest.approx(np.pi, abs=1e-3)


def test_bending_is_refused_in_a_sentence_and_leaves_nothing(scene):
    sweep = sw.to_object(sw.PDCurveSweep(), "bender")
    flat = add("flat", bpy.data.meshes.new("flat"))
    flat.data.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    select(flat)
    sweep.select_set(True)
    bpy.context.view_layer.objects.active = sweep
    update()
    meshes = len(bpy.data.meshes)
    with pytest.raises(RuntimeError, match="flat: must be long along its axis to be fitted, got 0"):
        bpy.ops.object.sweep_bend(fit=True)
    assert len(bpy.data.meshes) == meshes
    sweep.select_set(False)
    select(flat)
    bpy.context.view_layer.objects.active = flat
    assert not bpy.ops.object.sweep_bend.poll()
