# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-CSG in the sidebar: what is drawn of a tree in each state, in few calls of the layout."""

import timeit
from types import SimpleNamespace

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from layouts import Layout, context_of
from scenes import cube, doubled, select, straight

import sweep_addon as sw
from sweep_addon.bridge import operands, solvers, trees

PRISM = sw.TranslationalSweep(sw.contours.Rectangle(0.2, 0.2), height=3.0)
MOST_CALLS = 150  # as of a sweep: under 1 ms in a window
OPERATORS = {"object.sweep_union", "object.sweep_intersection", "object.sweep_difference"}


def drawn(ob, *others):
    """All that the panel asks of its layout with this object active; nothing where it is not shown."""
    context, panel, layout = context_of(ob, others=others), bpy.types.VIEW3D_PT_sweep_csg, Layout()
    if not panel.poll(context):
        return []
    panel.draw(SimpleNamespace(layout=layout), context)
    return layout.drawn


def result(count=1):
    """A cube from which prisms are taken."""
    body = cube(2.0, name="body")
    tools = []
    for number in range(count):
        tools.append(sw.to_object(PRISM, f"tool {number}"))
        tools[-1].location = (0.3 * number - 0.5, 0, -1.5)
    operands.combine(body, tools, "difference")
    return body


def test_it_is_shown_for_two_meshes_and_for_a_tree(scene):
    body, other = cube(), cube()
    assert drawn(body) == [] and drawn(None) == [] and drawn(straight(), body) == []
    assert OPERATORS <= set(drawn(body, other))
    assert not OPERATORS & set(drawn(result()))


def test_a_tree_says_what_it_is_and_shows_a_row_for_each_step(scene):
    body = result(3)
    calls = drawn(body)
    solver = trees.booleans(body)[0].solver.lower()
    assert f"3 operands, {solver} solver" in calls
    assert calls.count("operation") == calls.count("object.sweep_step_mute") == 3
    assert {"tool 0", "tool 1", "tool 2"} <= set(calls)


def test_the_operand_that_is_picked_shows_its_parameters(scene):
    body = result(2)
    assert trees.picked(body) == (body, trees.booleans(body)[1]), "the newest step"
    trees.pick(body, body, trees.booleans(body)[0])
    assert "contour_rectangle_width" in drawn(body) and "tool 0: Translational Sweep" in drawn(body)
    body.modifiers.active = None
    assert "contour_rectangle_width" not in drawn(body)


def test_names_are_said_whole_in_lines_that_a_sidebar_holds(scene):
    body = result()
    (tool,) = trees.operands(body)
    body.name, tool.name = "Walls of the northern wing.001", "Translational Sweep.001"
    for active, said in ((body, f"{tool.name}: Translational Sweep"), (tool, f"Operand of {body.name}")):
        calls = drawn(active)
        lines = [call for call in calls if call and call != tool.name and call in said]
        assert " ".join(lines) == said and max(map(len, lines)) <= (300 - 60) / 7


def test_steps_of_an_operand_stand_below_it_further_in(scene):
    inner, outer = result(2), cube(name="outer")
    operands.combine(outer, [inner], "union")
    calls = drawn(outer)
    assert calls.count("operation") == 3 and calls.count("separator") == 2
    assert "1 operand, " in " ".join(calls)


def test_an_operand_that_is_shared_is_entered_once(scene):
    """Twelve times two steps are 24 rows, eight of them drawn; by every way that leads to them they are 2^13 - 2."""
    top = doubled(12)[0]
    top.modifiers.active = None
    calls = drawn(top)
    assert "16 more below" in calls and calls.count("operation") == 8


def test_an_operand_says_whose_it_is(scene):
    body = result()
    assert "Operand of body" in drawn(trees.operands(body)[0])


def test_a_deleted_operand_says_so_and_can_be_taken_out(scene):
    body = result()
    bpy.data.objects.remove(trees.operands(body)[0])
    calls = drawn(body)
    assert "An operand was deleted" in " ".join(calls) and "object.sweep_step_extract" in calls and "Deleted" in calls


def test_an_operand_that_is_open_or_mirrored_says_so(scene):
    body = result()
    (tool,) = trees.operands(body)
    tool.data.sweep.translational_sweep.start = "OPEN"
    assert "'tool 0' is not closed" in " ".join(drawn(body))
    tool.data.sweep.translational_sweep.start = "FLAT"
    tool.scale.x = -1
    bpy.context.view_layer.update()
    assert "'tool 0' is mirrored" in " ".join(drawn(body))


def test_an_operand_that_meets_itself_says_so_once_it_is_found(scene):
    body = result()
    coil = sw.to_object(sw.GeneralizedCylinder(sw.contours.Circle(0.1), sw.trajectories.Helix(1.0, 0.5, 2.0)), "coil")
    operands.combine(body, [coil], "union")
    coil.data.sweep.generalized_cylinder.contour_circle_radius = 0.4
    select(coil)
    bpy.ops.object.sweep_find_self_intersections()
    calls = drawn(body)
    assert "'coil' meets itself" in " ".join(calls) and "object.sweep_tree_choose_solver" in calls
    select(body)
    bpy.ops.object.sweep_tree_choose_solver()
    assert coil.data.sweep.generalized_cylinder.make_solid and "meets itself" not in " ".join(drawn(body))


def test_a_copy_of_the_result_alone_says_whose_operands_it_uses(scene):
    body = result()
    twin = body.copy()
    scene.collection.objects.link(twin)
    bpy.context.view_layer.update()
    assert "'tool 0' is an operand of 'body' too" in " ".join(drawn(twin))
    assert "too: Duplicate" not in " ".join(drawn(body))


def test_a_tree_can_be_classified_against_and_made_one_sweep(scene):
    assert {"object.sweep_classify", "object.sweep_tree_evaluate"} <= set(drawn(result()))


def test_other_modifiers_are_said_to_be_no_part_of_it(scene):
    body = result()
    assert "no part of the tree" not in " ".join(drawn(body))
    body.modifiers.new("Bevel", "BEVEL")
    assert "no part of the tree" in " ".join(drawn(body))


def test_a_step_that_takes_a_collection_is_named_by_it_and_is_no_part_of_the_tree(scene):
    body, collection = result(), bpy.data.collections.new("several")
    modifier = trees.booleans(body)[0]
    modifier.operand_type, modifier.collection = "COLLECTION", collection
    calls = drawn(body)
    assert "several" in calls and "Deleted" not in calls and "no part of the tree" in " ".join(calls)
    with pytest.raises(sw.ShapeError, match="must take an object, got a collection"):
        sw.from_object(body)


def test_a_file_whose_solver_this_blender_lacks_says_so(scene, tmp_path):
    body = result()
    for modifier in trees.booleans(body):
        modifier.solver = "MANIFOLD"
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "tree.blend"))
    solvers.has_fast.cache_clear()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "tree.blend"))
    assert solvers.has_fast.cache_info().currsize == 1 and "Solver" not in bpy.data.scenes
    calls = drawn(bpy.data.objects["body"])
    assert ("no manifold solver" in " ".join(calls)) != solvers.has_fast()
    assert ("object.sweep_tree_choose_solver" in calls) != solvers.has_fast()


def test_a_draw_of_fifty_operands_is_few_calls_about_the_one_that_is_picked(scene):
    body = result(50)
    steps = trees.booleans(body)
    for number, more in ((0, {"42 more below"}), (25, {"21 more above", "21 more below"}), (49, {"42 more above"})):
        trees.pick(body, body, steps[number])
        calls = drawn(body)
        assert {call for call in calls if " more " in call} == more and steps[number].object.name in calls
        assert calls.count("operation") == 8 and len(calls) < MOST_CALLS
    seconds = min(timeit.repeat(lambda: drawn(body), number=5, repeat=3)) / 5
    print(f"\ndraw of a tree of 50 operands: {len(calls)} calls of the layout, {seconds * 1000:.2f} ms in Python")


def test_a_tree_of_which_nothing_is_left_says_so(scene):
    body = result()
    assert "Nothing is left" not in " ".join(drawn(body))
    whole = cube(9.0, name="whole")
    operands.combine(body, [whole], "difference")
    bpy.context.view_layer.update()
    assert "Nothing is left" in " ".join(drawn(body))
