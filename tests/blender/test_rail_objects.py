# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rails may be curve objects, read in the trajectory's space and followed."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import curve, places

import sweep_addon as sw
from sweep_addon.core.contours import Rectangle
from sweep_addon.core.trajectories import Line

UP = [(0, 0, 0), (0, 0, 2)]


def guided(*rails, **named):
    """A square along a straight curve, with curve objects for rails."""
    path = curve("POLY", UP, name="path")
    beside = [Line((side, 0, 0), (side, 0, 2)) for side in (9, -9)][: len(rails)]
    ob = sw.to_object(sw.GeneralizedCylinder(Rectangle(1, 1), rails=beside, **named))
    group = ob.data.sweep.generalized_cylinder
    group.trajectory_object, group.trajectory = path, "OBJECT"
    for item, rail in zip(group.rails, rails, strict=True):
        item.path_object, item.path = rail, "OBJECT"
    bpy.context.view_layer.update()
    return ob, path


def test_two_curve_objects_set_the_width_where_they_stand(scene):
    rails = [curve("POLY", UP, name="right"), curve("POLY", UP, name="left")]
    rails[0].location.x, rails[1].location.x = 3, -1
    ob, _ = guided(*rails)
    assert ob.data.sweep.error == ""
    assert np.ptp(places(ob.data), axis=0) == pytest.approx([4, 4, 2], abs=1e-6)
    assert places(ob.data)[:, 0].max() == pytest.approx(3, abs=1e-6)


def test_a_rail_that_is_moved_or_edited_is_followed(scene):
    rails = [curve("POLY", UP, name="right"), curve("POLY", UP, name="left")]
    rails[0].location.x, rails[1].location.x = 1, -1
    ob, _ = guided(*rails)
    rails[0].location.x = 5
    bpy.context.view_layer.update()
    assert places(ob.data)[:, 0].max() == pytest.approx(5, abs=1e-6)
    rails[1].data.splines[0].points[1].co.x = -4
    rails[1].data.update_tag()
    bpy.context.view_layer.update()
    assert places(ob.data)[:, 0].min() == pytest.approx(-5, abs=1e-6)


def test_a_rail_is_read_in_the_space_of_the_trajectory(scene):
    rail = curve("POLY", UP, name="rail")
    rail.location.y = 2
    ob, path = guided(rail)
    path.location.x = 2
    bpy.context.view_layer.update()
    frames = sw.from_object(ob).frames()
    assert frames.e2[0] == pytest.approx(np.array([-1, 1, 0]) / np.sqrt(2), abs=1e-6)


def test_a_rail_object_beside_a_trajectory_that_is_none_is_refused(scene):
    ob = sw.to_object(sw.GeneralizedCylinder(trajectory=Line(), rails=[Line((1, 0, 0), (1, 0, 1))]))
    item = ob.data.sweep.generalized_cylinder.rails[0]
    item.path_object, item.path = curve("POLY", UP), "OBJECT"
    assert ob.data.sweep.error.startswith("rails.1.path: must not be an object where the trajectory is none")


def test_a_button_adds_a_rail_to_either_side(scene):
    ob = sw.to_object(sw.GeneralizedCylinder(trajectory=Line()))
    bpy.context.view_layer.objects.active = ob
    for _ in range(2):
        assert bpy.ops.object.sweep_item_add(parameter="rails") == {"FINISHED"}
    assert ob.data.sweep.error == ""
    assert np.ptp(places(ob.data), axis=0)[:2] == pytest.approx([0.6, 0.6], abs=1e-6)
    bpy.ops.object.sweep_item_add(parameter="rails")
    assert ob.data.sweep.error == "rails: must have at most 2 items, got 3"
