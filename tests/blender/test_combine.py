# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Union, Difference and Intersection of a selection, and what is done with the steps that they leave."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import cube, parameters_of, places, select, shown, straight, sweep

import sweep_addon as sw
from sweep_addon.bridge import objects, operands, solvers, trees
from sweep_addon.core.csg import Operation
from sweep_addon.core.declared.parameters import spelled

OPERATORS = {
    "union": bpy.ops.object.sweep_union,
    "intersection": bpy.ops.object.sweep_intersection,
    "difference": bpy.ops.object.sweep_difference,
}
HALF = {"union": 8 + 0.5, "intersection": 0.5, "difference": 8 - 0.5}  # a cube of 2 m, one of 1 m half within


def drilled(*tools):
    """A cube of 2 m, the active tree, from which tools are taken: by default a sweep of 0.04 m2 through it."""
    body = cube(2.0, name="body")
    tools = tools or (tool(),)
    select(body, *tools)
    assert bpy.ops.object.sweep_difference() == {"FINISHED"}
    return body


def tool(name="tool", place=(0, 0, -1.5), side=0.2):
    """A square bar 3 m high, a live sweep."""
    ob = sw.to_object(sw.TranslationalSweep(sw.contours.Rectangle(side, side), height=3.0), name)
    ob.location = place
    return ob


def volume(ob):
    return shown(ob).volume()


def world(ob):
    bpy.context.view_layer.update()
    return np.array(ob.matrix_world)


@pytest.mark.parametrize("operation", OPERATORS)
def test_the_active_mesh_becomes_the_result_and_the_others_operands(scene, operation):
    body, tool = cube(2.0, name="body"), cube(1.0, (1, 0, 0), "tool")
    select(body, tool)
    assert OPERATORS[operation]() == {"FINISHED"}
    assert volume(body) == pytest.approx(HALF[operation], rel=1e-6)
    assert bpy.context.active_object == body and not tool.select_get()
    assert tool.parent == body and tool.display_type == "WIRE" and tool.hide_render
    assert [collection.name for collection in tool.users_collection] == ["body Operands"]
    assert not body.hide_render and body.display_type == "TEXTURED"


def test_there_is_an_operator_for_each_operation():
    assert set(OPERATORS) == {spelled(operation) for operation in Operation}


def test_an_operand_keeps_its_place_in_a_result_that_is_turned_and_scaled(scene):
    body, tool = cube(2.0, name="body"), cube(1.0, (1, 0.25, 0), "tool")
    body.rotation_euler, body.scale, body.location = (0.3, 0.5, 0.7), (2, 1, 1), (1, 2, 3)
    tool.rotation_euler = (1, 0, 0)
    before = world(tool)
    select(body, tool)
    bpy.ops.object.sweep_union()
    assert np.abs(world(tool) - before).max() < 1e-5
    body.location.x += 5
    assert np.abs(world(tool)[:3, 3] - before[:3, 3] - (5, 0, 0)).max() < 1e-5


def test_a_sweep_that_is_carried_by_its_path_stays_on_it(scene):
    path = straight()
    hole = sweep(trajectory=path)
    body = cube(2.0, name="body")
    select(body, hole)
    bpy.ops.object.sweep_difference()
    assert hole.parent == path and path.parent == body
    before = volume(body)
    path.location.x += 0.8
    assert volume(body) > before + 0.1


def test_the_tree_is_live_in_its_operands_and_its_own_parameters(scene):
    body, bar = drilled(), bpy.data.objects["tool"]
    assert volume(body) == pytest.approx(8 - 0.08, rel=1e-6)
    bar.data.sweep.translational_sweep.contour_rectangle_width = 0.4
    assert volume(body) == pytest.approx(8 - 0.16, rel=1e-6)
    bar.location.x = 5
    assert volume(body) == pytest.approx(8, rel=1e-6)


def test_a_sweep_that_becomes_a_result_keeps_its_parameters(scene):
    body, other = tool("body", side=2.0), cube(1.0, (0, 0, 0))
    select(body, other)
    bpy.ops.object.sweep_difference()
    body.data.sweep.translational_sweep.height = 4.0
    assert volume(body) == pytest.approx(16 - 1, rel=1e-6)
    assert sw.from_object(body).base.height == 4.0


def test_several_operands_are_steps_in_the_order_of_their_names(scene):
    body = drilled(tool("b", (0.5, 0, -1.5)), tool("a", (-0.5, 0, -1.5)), tool("c", (0, 0.5, -1.5)))
    assert [modifier.object.name for modifier in trees.booleans(body)] == ["a", "b", "c"]
    assert volume(body) == pytest.approx(8 - 3 * 0.08, rel=1e-6)


def test_closed_operands_get_the_faster_solver_where_blender_has_it(scene):
    body = drilled()
    assert {modifier.solver for modifier in trees.booleans(body)} == {"MANIFOLD" if solvers.has_fast() else "EXACT"}


@pytest.mark.parametrize("spoil", ["open", "mirrored"])
def test_what_the_faster_solver_cannot_do_gets_the_exact_one_and_a_reason(scene, spoil):
    bar = tool()
    if spoil == "open":
        bar.data.sweep.translational_sweep.start = "OPEN"
    else:
        bar.scale.x = -1
    body = cube(2.0, name="body")
    bpy.context.view_layer.update()
    (why,) = operands.combine(body, [bar], "difference")
    assert {modifier.solver for modifier in trees.booleans(body)} == {"EXACT"}
    if solvers.has_fast():
        assert "'tool'" in why and spoil.replace("open", "not closed") in why
    else:
        assert "no manifold solver" in why
    if spoil == "mirrored":
        assert volume(body) == pytest.approx(8 - 0.08, rel=1e-6)


def test_an_operand_that_meets_itself_is_made_a_solid_first(scene):
    coil = sw.to_object(sw.GeneralizedCylinder(sw.contours.Circle(0.4), sw.trajectories.Helix(1.0, 0.5, 2.0)), "coil")
    body = cube(5.0, name="body")
    body.location.x = 2.5
    select(body, coil)
    bpy.ops.object.sweep_difference()
    assert parameters_of(coil).make_solid
    tree = sw.from_object(body)
    assert volume(body) == pytest.approx(tree.mesh().volume(), rel=1e-4)


def test_a_cycle_is_refused_by_a_sentence_and_nothing_changes(scene):
    body, bar = drilled(), bpy.data.objects["tool"]
    select(bar, body)
    with pytest.raises(RuntimeError, match="'body' is made from 'tool'"):
        bpy.ops.object.sweep_union()
    assert not bar.modifiers and body.display_type == "TEXTURED" and bar.parent == body


def test_a_cycle_by_way_of_a_sweep_that_moves_the_result_is_refused(scene):
    body = drilled()
    mover = add_general(body)
    select(body, mover)
    with pytest.raises(RuntimeError, match="is made from 'body'"):
        bpy.ops.object.sweep_union()
    assert len(trees.booleans(body)) == 1


def add_general(generator):
    shape = sw.GeneralSweep(trajectory=sw.trajectories.Line(end=(3, 0, 0)), cells=12)
    mesh = objects.new_mesh(shape, "mover", generator=generator)
    ob = bpy.data.objects.new("mover", mesh)
    bpy.context.scene.collection.objects.link(ob)
    return ob


def test_one_mesh_alone_and_a_linked_one_are_refused(scene, tmp_path):
    body = cube(2.0, name="body")
    select(body)
    assert not bpy.ops.object.sweep_union.poll()
    bpy.data.libraries.write(str(tmp_path / "library.blend"), {cube(1.0, name="theirs")})
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    bpy.ops.wm.link(directory=f"{tmp_path}/library.blend/Object/", filename="theirs")
    select(cube(2.0), bpy.data.objects["theirs"])
    assert not bpy.ops.object.sweep_union.poll()


def test_steps_are_moved_muted_and_extracted(scene):
    body = drilled(tool("a"), cube(1.0, (1, 0, 0), "b"))
    trees.booleans(body)[1].operation = "UNION"
    assert bpy.ops.object.sweep_step_move(step="Difference", direction="DOWN") == {"FINISHED"}
    assert [modifier.object.name for modifier in trees.booleans(body)] == ["b", "a"]
    assert bpy.ops.object.sweep_step_move(step="Difference", direction="DOWN") == {"CANCELLED"}
    bpy.ops.object.sweep_step_mute(step="Difference")
    assert volume(body) == pytest.approx(8.5, rel=1e-6)
    assert str(sw.from_object(body)) == "Triangles | Triangles"
    bpy.ops.object.sweep_step_mute(step="Difference")
    bpy.ops.object.sweep_step_extract(step="Difference")
    free = bpy.data.objects["a"]
    assert free.parent is None and free.display_type == "TEXTURED" and not free.hide_render
    assert free.users_collection == body.users_collection
    assert np.abs(world(free)[:3, 3] - (0, 0, -1.5)).max() < 1e-6
    bpy.ops.object.sweep_step_extract(step="Difference.001")
    assert not body.modifiers and "body Operands" not in bpy.data.collections


def test_a_step_that_is_picked_is_what_buttons_act_on_in_a_nested_tree_too(scene):
    inner = drilled(tool("a"), tool("b", (0.5, 0, -1.5)))
    outer = cube(1.0, (1, 0, 0), "outer")
    select(outer, inner)
    bpy.ops.object.sweep_union()
    bpy.ops.object.sweep_step_pick(owner="body", step="Difference")
    owner, modifier = trees.picked(outer)
    assert owner == inner and modifier.object.name == "a"
    bpy.ops.object.sweep_step_extract()
    assert [m.object.name for m in trees.booleans(inner)] == ["b"]
    bpy.ops.object.sweep_step_pick(step="Union")
    assert trees.picked(outer) == (outer, outer.modifiers[0])
    bpy.ops.object.sweep_step_select()
    assert bpy.context.active_object == inner and inner.select_get() and not outer.select_get()


def test_collapse_leaves_a_plain_mesh_as_it_was_shown(scene):
    body = drilled()
    before = volume(body)
    bpy.ops.object.sweep_tree_collapse()
    assert not body.modifiers and volume(body) == pytest.approx(before, rel=1e-6)
    assert not objects.is_sweep(body) and [ob.name for ob in bpy.data.objects] == ["body"]
    assert [mesh.name for mesh in bpy.data.meshes] == ["body"]
    assert not bpy.data.collections


def test_collapse_of_a_sweep_forgets_its_parameters_and_keeps_shared_operands(scene):
    body, other, bar = tool("body", side=2.0), cube(2.0, (9, 0, 0), "other"), tool("bar")
    for result in (body, other):
        select(result, bar)
        bpy.ops.object.sweep_difference()
    select(body)
    bpy.ops.object.sweep_tree_collapse()
    assert body.data.sweep.kind == "NONE" and "bar" in bpy.data.objects
    assert trees.operands(other) == [bar]


def test_take_apart_gives_all_operands_back(scene):
    inner = drilled()
    outer = cube(1.0, (1, 0, 0), "outer")
    select(outer, inner)
    bpy.ops.object.sweep_union()
    bpy.ops.object.sweep_tree_take_apart()
    assert {ob.name for ob in bpy.data.objects} == {"body", "outer", "tool"}
    for ob in bpy.data.objects:
        assert not ob.modifiers and not ob.parent and not ob.hide_render and ob.display_type == "TEXTURED"
        assert ob.users_collection == (bpy.context.scene.collection,)


def test_duplicate_tree_copies_all_that_it_is_made_from(scene):
    path = straight()
    hole = sweep(trajectory=path)
    body = cube(2.0, name="body")
    select(body, hole)
    bpy.ops.object.sweep_difference()
    before = volume(body)
    bpy.ops.object.sweep_tree_duplicate()
    twin = bpy.context.active_object
    assert twin != body and volume(twin) == pytest.approx(before, rel=1e-6)
    made, theirs = trees.made_from(twin), trees.made_from(body)
    assert len(made) == len(theirs) == 2 and not made & theirs
    (copy,) = trees.operands(twin)
    assert copy.data != hole.data and copy.parent.parent == twin and copy.users_collection != hole.users_collection
    parameters_of(copy).contour_circle_radius = 0.1
    copy.parent.data.splines[0].points[1].co.z = 5
    assert volume(twin) > before + 0.1 and volume(body) == pytest.approx(before, rel=1e-6)


def test_an_operand_used_twice_stays_with_the_first_result(scene):
    body, bar = drilled(), bpy.data.objects["tool"]
    other = cube(2.0, (0.5, 0, 0), "other")
    select(other, bar)
    bpy.ops.object.sweep_difference()
    assert bar.parent == body and volume(other) == pytest.approx(8 - 0.08, rel=1e-6)
    bpy.ops.object.sweep_step_extract(step="Difference")
    assert bar.display_type == "WIRE" and trees.operands(body) == [bar]


def test_a_deleted_operand_leaves_a_step_that_does_nothing(scene):
    body = drilled()
    bpy.data.objects.remove(bpy.data.objects["tool"])
    assert volume(body) == pytest.approx(8, rel=1e-6)
    assert sw.from_object(body).steps == ()
    bpy.ops.object.sweep_step_extract(step="Difference")
    assert not body.modifiers


def test_an_operand_deleted_as_people_do_leaves_such_a_step(scene):
    body = drilled()
    select(bpy.data.objects["tool"])
    bpy.ops.object.delete()
    assert volume(body) == pytest.approx(8, rel=1e-6) and trees.operands(body) == []


def test_blenders_own_duplicate_of_result_and_operands_copies_the_tree(scene):
    body, bar = drilled(), bpy.data.objects["tool"]
    select(body, bar)
    bpy.ops.object.duplicate()
    (twin,) = set(filter(trees.is_tree, bpy.data.objects)) - {body}
    (copy,) = trees.operands(twin)
    assert copy not in (body, bar) and copy.parent == twin
    copy.data.sweep.translational_sweep.contour_rectangle_width = 0.4
    assert (volume(twin), volume(body)) == (pytest.approx(8 - 0.16, rel=1e-6), pytest.approx(8 - 0.08, rel=1e-6))


def test_a_generator_whose_tree_holds_the_sweep_itself_is_refused(scene):
    mover = add_general(cube(1.0, name="first"))
    body = cube(2.0, name="body")
    body.modifiers.new("by hand", "BOOLEAN").object = mover
    mover.data.sweep.general_sweep.generator_object = body
    assert "must not be made from this sweep" in mover.data.sweep.error


def test_a_tree_survives_save_and_append(scene, tmp_path):
    body = drilled()
    before, tree = volume(body), sw.from_object(body)
    path = str(tmp_path / "tree.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    body = bpy.data.objects["body"]
    assert volume(body) == pytest.approx(before, rel=1e-6) and sw.from_object(body) == tree
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
    bpy.ops.wm.append(directory=f"{path}/Object/", filename="body")
    body = bpy.data.objects["body"]
    assert volume(body) == pytest.approx(before, rel=1e-6) and sw.from_object(body) == tree
    bpy.data.objects["tool"].data.sweep.translational_sweep.contour_rectangle_width = 0.4
    assert volume(body) == pytest.approx(8 - 0.16, rel=1e-6)


def test_a_tree_made_by_hand_is_the_tree(scene):
    body, bar = cube(2.0), tool()
    modifier = body.modifiers.new("by hand", "BOOLEAN")
    modifier.object, modifier.operation = bar, "INTERSECT"
    tree = sw.from_object(body)
    assert str(tree) == "Triangles & TranslationalSweep"
    assert tree.mesh().volume() == pytest.approx(0.08, rel=1e-6)


def test_a_cycle_made_by_hand_is_refused(scene):
    body, other = cube(2.0, name="body"), cube(1.0, name="other")
    body.modifiers.new("a", "BOOLEAN").object = other
    other.modifiers.new("b", "BOOLEAN").object = body
    with pytest.raises(sw.ShapeError, match="made from itself, as 'body' is"):
        sw.from_object(body)


def test_a_tree_that_moves_is_read_as_a_swept_solid_and_follows_its_operands(scene):
    body, bar = drilled(), bpy.data.objects["tool"]
    mover = add_general(body)
    read = sw.from_object(mover)
    assert isinstance(read, sw.SweptSolid) and read.solid == sw.from_object(body)
    assert np.ptp(places(mover.data), axis=0)[0] == pytest.approx(5, rel=0.02)
    before = places(mover.data)
    bar.location.x = 1.0  # at the side: a slot along the top and the bottom of the sweep
    bpy.context.view_layer.update()
    after = places(mover.data)
    assert after.shape != before.shape or np.abs(after - before).max() > 0.01


def test_cuts_are_drawn_as_edges_after_all_other_modifiers(scene):
    """A bar of 4 sides through a cube: 12 edges of the cube, 4 corners of the hole, and 8 where it goes in and out."""
    body = drilled()
    body.modifiers.new("Later", "BEVEL").show_viewport = False
    shown_mesh = body.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    sharp = np.zeros(len(shown_mesh.edges), bool)
    shown_mesh.attributes["sharp_edge"].data.foreach_get("value", sharp)
    assert body.modifiers[-1].type == "NODES" and sharp.sum() == 12 + 4 + 8
    bpy.ops.object.sweep_step_extract(step="Difference")
    assert [modifier.type for modifier in body.modifiers] == ["BEVEL"]
