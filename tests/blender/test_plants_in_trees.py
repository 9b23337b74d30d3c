# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants as operands of set operations in Blender: their tubes overlap, and their leaves are open."""

from functools import reduce
from types import SimpleNamespace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from layouts import Layout
from scenes import cube, places, shown
from test_panels import context_of

import sweep_addon as sw
from sweep_addon.bridge import operands, solvers, trees

UNITES = solvers.booleans.is_there()

THICK, THIN = 0.1, 0.05  # radii of octagonal tubes
BAR = "axiom: [!(0.2) F(2)] f(0.7) !(0.1) F(3)"  # the thin one begins within the thick one
LEAF = " [f(0.3) +(120) { f(0.3) +(120) f(0.3) +(120) f(0.3) }]"


def area(radius):
    """Of a regular octagon with corners on a circle."""
    return 2 * np.sqrt(2) * radius**2


WITHIN = 1.5 * area(THICK) + 0.5 * area(THIN)  # of the bar in the cube of 8 cubic metres
BEYOND = 0.5 * area(THICK) + 1.2 * area(THIN)


def plant(text, name="plant"):
    ob = sw.to_object(sw.Plant(text, upright=True), name)
    ob.location.z = -0.5
    return ob


def body():
    return cube(2.0, (0.013, 0.017, 1.0), "body")


def sidebar(ob):
    layout = Layout()
    bpy.types.VIEW3D_PT_sweep_csg.draw(SimpleNamespace(layout=layout), context_of(ob))
    return " ".join(layout.drawn)


@pytest.mark.parametrize(
    ("operation", "volume"), [("union", 8 + BEYOND), ("intersection", WITHIN), ("difference", 8 - WITHIN)]
)
@pytest.mark.parametrize("first", ["body", "plant"])
def test_tubes_that_overlap_count_once(scene, operation, volume, first):
    parts = {"body": body(), "plant": plant(BAR)}
    result = parts.pop(first)
    operands.combine(result, list(parts.values()), operation)
    if (operation, first) == ("difference", "plant"):
        volume = BEYOND
    assert shown(result).volume() == pytest.approx(volume, rel=1e-5)
    (step,) = trees.booleans(result)
    quick = solvers.has_fast() and UNITES and first == "body"  # the first of a tree keeps its leaves and attributes
    assert step.solver == ("MANIFOLD" if quick else "EXACT")
    assert step.use_self == (first == "plant" or not UNITES)


def test_the_first_plant_of_the_menu_is_cut_out_once(scene):
    bpy.ops.mesh.plant_add()
    tree, block = bpy.context.object, cube(1.0, (0, 0, 1), "body")
    tree.location = (0.01, 0.02, 0.03)
    tree.data.sweep.plant.generations = 4
    operands.combine(block, [tree], "difference")
    left = shown(block).volume()
    trees.booleans(block)[0].operation = "INTERSECT"
    assert 0.99 < left < 0.999 and left + shown(block).volume() == pytest.approx(1, rel=1e-5)


def test_a_mesh_that_only_stands_by_itself_is_not_united_with_itself(scene):
    block, other = body(), cube(1.0, (1, 0, 1), "other")
    operands.combine(block, [other], "difference")
    assert not trees.booleans(block)[0].use_self


def test_an_operand_is_united_without_its_leaves(scene):
    pytest.importorskip("manifold3d")
    block, oak = body(), plant(BAR + LEAF, "oak")
    told = operands.combine(block, [oak], "difference")
    assert "'oak' is united now, as Output says in the sidebar, without its leaves." in told
    assert shown(block).volume() == pytest.approx(8 - WITHIN, rel=1e-5)
    assert len(oak.data.loops) == 2 * len(oak.data.edges) and "leaves" not in sidebar(block)
    assert solvers.unite(oak) == ""


def test_choosing_the_solver_unites_the_operands_of_a_tree_made_by_hand(scene):
    pytest.importorskip("manifold3d")
    block, oak = body(), plant(BAR + LEAF, "oak")
    operands.add_step(block, "difference", oak)
    bpy.context.view_layer.objects.active = block
    bpy.ops.object.sweep_tree_choose_solver()
    assert shown(block).volume() == pytest.approx(8 - WITHIN, rel=1e-5)


def test_leaves_are_said_to_cut_nothing_where_nothing_unites(scene, monkeypatch):
    monkeypatch.setattr(solvers.booleans, "is_there", lambda: False)
    block, oak = body(), plant(BAR + LEAF, "oak")
    assert len(oak.data.loops) < 2 * len(oak.data.edges)
    told = operands.combine(block, [oak], "difference")
    assert "'oak' has open faces: leaves cut nothing, and where its tubes overlap the result is undefined." in told
    assert "leaves cut nothing" in sidebar(block)
    assert not trees.booleans(block)[0].use_self  # which unites closed meshes alone, and takes long to leave others


def test_a_plant_without_leaves_and_other_meshes_lose_nothing(scene):
    block, other = body(), plant(BAR)
    told = operands.combine(block, [other], "difference")
    assert not any("cut" in sentence for sentence in told) and "cut nothing" not in sidebar(block)
    other.data.sweep.plant.output = "EDGES"
    assert trees.booleans(block)[0].solver == "EXACT"  # which bears edges alone
    assert shown(block).volume() == pytest.approx(8, rel=1e-5)
    assert len(places(other.data)) and solvers.lost_faces(other) == "'plant' is edges alone: it cuts nothing."


@pytest.mark.parametrize("leaf", ["", LEAF])
def test_what_is_read_of_a_tree_has_the_plant_and_makes_the_same_mesh_again(scene, leaf):
    pytest.importorskip("manifold3d")
    block = body()
    operands.combine(block, [plant(BAR + leaf)], "difference")
    tree = sw.from_object(block)
    assert tree.steps[0].operand.solid == sw.Plant(BAR + leaf, upright=True, output={"kind": "tubes", "united": True})
    assert tree.mesh().volume() == pytest.approx(8 - WITHIN, rel=1e-5)
    again = sw.to_object(sw.load(sw.dump(tree)), "again")
    assert shown(again).volume() == pytest.approx(8 - WITHIN, rel=1e-5)
    read, first = sw.from_object(again), tree.steps[0].operand
    assert read.steps[0].operand.solid == first.solid
    assert np.allclose(read.steps[0].operand.matrix, first.matrix, atol=1e-6)


@pytest.mark.parametrize("node", ["base", "moved", "swept"])
def test_a_plant_anywhere_in_a_tree_is_read_again_as_it_was_made(scene, node):
    pytest.importorskip("manifold3d")
    united = sw.Plant(BAR + LEAF, upright=True, output={"kind": "tubes", "united": True})
    block = sw.solids.Block(1.0, 1.0, 1.0)
    made = {
        "base": united - block,
        "moved": block - united.moved(z=0.25),
        "swept": sw.SweptSolid(united, sw.trajectories.Line(end=(2, 0, 0)), cells=16),
    }[node]
    ob = sw.to_object(made)
    read = sw.from_object(ob)
    path = {"base": "base", "moved": "steps.0.operand.solid", "swept": "solid"}[node].split(".")
    plant = reduce(lambda held, part: held[int(part)] if part.isdigit() else getattr(held, part), path, read)
    assert plant == united
    if node == "base":
        assert shown(ob).volume() == pytest.approx(1.5 * area(THICK) + 1.7 * area(THIN), rel=1e-5)


@pytest.mark.parametrize("form", ["PYTHON", "JOB"])
def test_a_tree_with_a_plant_is_copied_as_text_that_builds_it(scene, form):
    pytest.importorskip("manifold3d")
    block = body()
    operands.combine(block, [plant(BAR + LEAF)], "difference")
    window = SimpleNamespace()  # the clipboard is that of a window
    copy = SimpleNamespace(form=form, report=lambda kind, sentence: None)
    bpy.types.OBJECT_OT_sweep_copy.execute(copy, SimpleNamespace(active_object=block, window_manager=window))
    before = set(bpy.data.objects)
    if form == "JOB":
        sw.to_object(sw.load(window.clipboard))
    else:
        exec(window.clipboard.split("\n", 1)[1], {"sw": sw})
    (made,) = [ob for ob in set(bpy.data.objects) - before if trees.is_tree(ob)]
    assert shown(made).volume() == pytest.approx(8 - WITHIN, rel=1e-5)


def test_vertices_are_classified_against_a_plant(scene):
    pytest.importorskip("manifold3d")
    from sweep_addon.bridge import membership

    tree, probe = plant(BAR), cube(0.02, name="probe")
    bpy.context.view_layer.update()
    assert set(membership.of_mesh(tree, probe)) == {1}
    probe.location.x = 1
    bpy.context.view_layer.update()
    assert set(membership.of_mesh(tree, probe)) == {-1}
