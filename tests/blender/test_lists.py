# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A morph in Blender is a list of contours, each of which may be an object; it is as live as all else."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import curve, places, text

import sweep_addon as sw
from sweep_addon.core.contours import Circle, Rectangle
from sweep_addon.core.trajectories import Line, TorusKnot

UP = Line(end=(0, 0, 3))


def sweep(**named):
    ob = sw.to_object(sw.GeneralizedCylinder(Rectangle(2, 2), UP, **named), "sweep")
    bpy.context.view_layer.objects.active = ob
    return ob, ob.data.sweep.generalized_cylinder


def widest(ob):
    return np.abs(places(ob.data)[:, :2]).max()


def outline(half):
    return curve("POLY", [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)], use_cyclic_u=True)


def test_items_hold_what_python_says_and_give_it_back(scene):
    shape = sw.GeneralizedCylinder(morph=[(0.25, Circle(0.5)), (1, Rectangle(0.5, 0.25))], blend="smooth")
    ob = sw.to_object(shape)
    group = ob.data.sweep.generalized_cylinder
    assert [(item.t, item.contour) for item in group.morph] == [(0.25, "CIRCLE"), (1.0, "RECTANGLE")]
    assert sw.from_object(ob) == shape


def test_a_property_of_an_item_rebuilds_the_mesh(scene):
    ob, group = sweep(morph=[(1, Rectangle(4, 4))], match="by-corner")
    assert len(ob.data.vertices) == 8 and widest(ob) == pytest.approx(2)
    group.morph[0].contour_rectangle_width = 10
    assert widest(ob) == pytest.approx(5)
    group.morph[0].t = 0.5
    assert len(ob.data.vertices) == 12


def test_buttons_add_and_take_out_and_rebuild(scene):
    ob, group = sweep()
    assert bpy.ops.object.sweep_item_add(parameter="morph") == {"FINISHED"}
    assert bpy.ops.object.sweep_item_add(parameter="morph") == {"FINISHED"}
    assert [item.t for item in group.morph] == [1.0, 0.5] and ob.data.sweep.error == ""
    assert widest(ob) == pytest.approx(1) and len(ob.data.vertices) > 8
    bpy.ops.object.sweep_item_remove(parameter="morph", number=1)
    assert [item.t for item in group.morph] == [0.5]
    bpy.ops.object.sweep_item_remove(parameter="morph", number=1)
    assert len(ob.data.vertices) == 8


def test_one_more_on_a_ring_stands_amid_the_widest_gap(scene):
    ob = sw.to_object(sw.GeneralizedCylinder(Circle(0.1), TorusKnot()))
    bpy.context.view_layer.objects.active = ob
    bpy.ops.object.sweep_item_add(parameter="morph")
    bpy.ops.object.sweep_item_add(parameter="morph")
    assert [item.t for item in ob.data.sweep.generalized_cylinder.morph] == [0.5, 0.25]
    assert ob.data.sweep.error == ""


@pytest.mark.parametrize("call", [("sweep_item_add", {"parameter": "contour"}), ("sweep_item_remove", {"number": 3})])
def test_what_is_no_list_or_not_in_it_is_refused(scene, call):
    sweep(morph=[(1, Rectangle(4, 4))])
    name, given = call
    with pytest.raises(RuntimeError, match="has no"):
        getattr(bpy.ops.object, name)(**{"parameter": "morph", **given})


def test_a_curve_object_is_a_contour_of_the_morph_and_followed(scene):
    square = outline(2.0)
    ob, group = sweep(morph=[(1, Rectangle(1, 1))])
    group.morph[0].contour_object = square
    group.morph[0].contour = "OBJECT"
    assert widest(ob) == pytest.approx(2)
    square.data.splines[0].points[0].co.x = -7
    square.data.update_tag()
    bpy.context.view_layer.update()
    assert widest(ob) == pytest.approx(7, rel=1e-6)


def test_letters_become_others(scene):
    mesh = sw.GeneralizedCylinder(Rectangle(2, 2), UP, morph=[(1, Rectangle(1, 1))])
    ob = sw.to_object(mesh)
    group = ob.data.sweep.generalized_cylinder
    group.contour_object, group.morph[0].contour_object = text("L"), text("I")
    group.contour = group.morph[0].contour = "OBJECT"
    assert ob.data.sweep.error == "" and sw.from_object(ob).mesh().volume() > 0


def test_a_morph_that_is_refused_names_the_item_and_keeps_the_mesh(scene):
    ob, group = sweep(morph=[(0.5, Rectangle(4, 4)), (1, Rectangle(1, 1))])
    before = places(ob.data)
    group.morph[1].t = 0.5
    assert ob.data.sweep.error.startswith("morph.2.t: must be another t")
    assert (places(ob.data) == before).all()
    group.morph[1].contour = "OBJECT"
    assert ob.data.sweep.error.startswith("morph.2.contour: must be an object of the scene")


def test_a_keyframe_moves_a_contour_along(scene):
    ob, group = sweep(morph=[(0.5, Rectangle(4, 4))])
    item = group.morph[0]
    for frame, t in ((1, 0.25), (11, 0.75)):
        item.t = t
        item.keyframe_insert("t", frame=frame)
    bpy.context.scene.frame_set(1)
    low = np.unique(places(ob.data)[:, 2].round(4))
    bpy.context.scene.frame_set(11)
    high = np.unique(places(ob.data)[:, 2].round(4))
    assert low.tolist() == [0, 0.75, 3] and high.tolist() == [0, 2.25, 3]


def test_a_copy_has_a_list_of_its_own(scene):
    ob, group = sweep(morph=[(1, Rectangle(4, 4))])
    copy = ob.data.copy()
    copy.sweep.generalized_cylinder.morph[0].contour_rectangle_width = 6
    assert group.morph[0].contour_rectangle_width == 4


def test_lists_are_not_in_the_panel_of_the_last_operation(scene):
    assert bpy.ops.mesh.generalized_cylinder_add() == {"FINISHED"}
    assert "morph" not in bpy.ops.mesh.generalized_cylinder_add.get_rna_type().properties
