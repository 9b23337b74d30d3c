# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees as objects and Boolean modifiers: to Blender and back, and by hand in the modifiers' own panel."""

from types import SimpleNamespace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import cube, doubled, select, shown

import sweep_addon as sw
from sweep_addon.bridge import operands, trees

BLOCK = sw.TranslationalSweep(sw.contours.Rectangle(2.0, 2.0), height=1.0)
BAR = sw.TranslationalSweep(sw.contours.Rectangle(1.0, 1.0), height=3.0)
RING = sw.GeneralizedCylinder(sw.contours.Circle(0.2, points=16), sw.trajectories.Arc(radius=1.0, angle=3.0))


def same(tree, other):
    """Whether two trees are equal but for the single precision of Blender's matrices."""
    if isinstance(tree, sw.Placed):
        return (
            isinstance(other, sw.Placed)
            and np.abs(tree.matrix.values - other.matrix.values).max() < 1e-6
            and same(tree.solid, other.solid)
        )
    if isinstance(tree, sw.Tree):
        steps = zip(tree.steps, other.steps, strict=True)
        alike = (a.operation == b.operation and same(a.operand, b.operand) for a, b in steps)
        return same(tree.base, other.base) and all(alike)
    return tree == other


TREES = {
    "union": BLOCK | BAR.moved(x=1.0),
    "three steps": ((BLOCK | BAR.moved(x=1.0)) - RING.moved(z=0.5)) & BLOCK.moved(x=0.25),
    "nested": BLOCK - (BAR - RING.moved(z=1.0)).moved(x=0.5, z=-0.875),
    "mirrored": BLOCK - sw.Placed(BAR, [(-1, 0, 0, 0.5), (0, 1, 0, 0), (0, 0, 2, -1)]),
    "sheared": BLOCK - sw.Placed(BAR, [(1, 0, 0.5, 0.5), (0, 1, 0, 0), (0, 0, 1, -1)]),
    "twice": (BLOCK - BAR.moved(x=1.0, z=-1.0)) - BAR.moved(x=-1.0, z=-1.0),
}


@pytest.mark.parametrize("tree", TREES.values(), ids=TREES)
def test_a_tree_comes_back_and_shows_the_volume_that_manifold3d_finds(scene, tree):
    ob = sw.to_object(tree, "result")
    assert same(tree, sw.from_object(ob))
    assert shown(ob).volume() == pytest.approx(tree.mesh().volume(), rel=1e-5)
    assert not len(shown(ob).boundary_edges())


def test_where_a_tree_is_placed_it_stands_in_the_scene(scene):
    """A base that is placed is read in its own space: the tree is the same one elsewhere."""
    tree = sw.Placed(BLOCK.moved(y=2.0) - BAR.moved(y=2.0, z=-1.0), [(0, -1, 0, 5), (1, 0, 0, 0), (0, 0, 1, 0)])
    ob = sw.to_object(tree, "result")
    assert np.allclose(np.array(ob.matrix_world)[:3, 3], (3, 0, 0), atol=1e-6)
    assert same(BLOCK - BAR.moved(z=-1.0), sw.from_object(ob))


def test_solids_become_sweeps_with_their_parameters(scene):
    ob = sw.to_object(sw.solids.Block(1.0, 1.0, 1.0) - sw.solids.Cylinder(0.2, 2.0), "result")
    (drill,) = trees.operands(ob)
    assert shown(ob).volume() == pytest.approx(1 - 32 * 0.04 * np.sin(2 * np.pi / 64), rel=1e-5)
    drill.data.sweep.translational_sweep.contour_circle_radius = 0.4
    assert shown(ob).volume() == pytest.approx(1 - 32 * 0.16 * np.sin(2 * np.pi / 64), rel=1e-5)


def test_a_swept_solid_is_a_general_sweep_of_the_object_that_moves(scene):
    solid = BLOCK - BAR.moved(z=-1.0)
    node = sw.SweptSolid(solid, sw.RigidMotion(sw.trajectories.Line(end=(3, 0, 0)), turn_z="0.5*t"), cells=12)
    ob = sw.to_object(BLOCK | node.moved(z=2.0), "result")
    (mover,) = trees.operands(ob)
    assert mover.data.sweep.general_sweep.generator == "OBJECT"
    assert same(BLOCK | node.moved(z=2.0), sw.from_object(ob))


SHEAR = [(1, 0, 0.5, 0), (0, 1, 0, 0), (0, 0, 1, 0)]
BY_MESH = {
    "moved generator": sw.SweptSolid(sw.solids.Block().moved(x=1.0), sw.RigidMotion()),
    "sheared base": sw.Placed(BLOCK, SHEAR) - BAR,
    "sheared tree as base": sw.Tree(sw.Placed(BLOCK - BAR, SHEAR), [("union", RING)]),
    "sheared tree": sw.Placed(BLOCK - BAR, SHEAR),
}


@pytest.mark.parametrize("operand", BY_MESH.values(), ids=BY_MESH)
def test_a_part_that_becomes_a_mesh_leaves_no_other_object(scene, operand):
    ob = sw.to_object(operand, "result")
    assert {ob, *trees.made_from(ob)} == set(bpy.data.objects)
    assert all(each.parent == ob and each.hide_render for each in bpy.data.objects if each != ob)
    assert all(mesh.users for mesh in bpy.data.meshes)


def test_an_operand_that_is_shared_is_read_once(scene, monkeypatch):
    """Twelve objects that each take the next one twice, and the last, are 13 to be read; by all ways 2^13 - 1."""
    read, leaf = [], trees.leaf
    monkeypatch.setattr(trees, "leaf", lambda ob, *more: read.append(ob) or leaf(ob, *more))
    chain = doubled(12)
    tree = sw.from_object(chain[0])
    assert read == chain and tree.steps[0].operand is tree.steps[1].operand


def test_the_way_to_a_step_asks_each_object_once(scene, monkeypatch):
    chain, other = doubled(12), cube(name="other")
    trees.pick(chain[0], chain[11], chain[11].modifiers[0])
    assert trees.picked(chain[0]) == (chain[11], chain[11].modifiers[0])
    assert [above for above, _ in trees.path(chain[0], chain[11])] == chain[:11]
    asked, booleans = [], trees.booleans
    monkeypatch.setattr(trees, "booleans", lambda ob: asked.append(ob) or booleans(ob))
    assert trees.path(chain[0], other) == () and asked == chain


def test_what_cannot_be_made_leaves_nothing_behind(scene):
    before = len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.collections)
    bad = sw.GeneralizedCylinder(trajectory=sw.trajectories.Line(), scale_x="1/t")
    with pytest.raises(sw.ShapeError, match=r"steps\.1\.operand"):
        sw.to_object(BLOCK - bad)
    assert (len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.collections)) == before


def test_a_tree_is_copied_as_a_job_and_as_python(scene):
    ob = sw.to_object(TREES["nested"], "result")
    select(ob)
    for form in ("JOB", "PYTHON"):
        clipboard = SimpleNamespace()
        operator = SimpleNamespace(form=form, report=lambda *_: None)
        context = SimpleNamespace(active_object=ob, window_manager=clipboard)
        assert bpy.ops.object.sweep_copy.poll()
        assert bpy.types.OBJECT_OT_sweep_copy.execute(operator, context) == {"FINISHED"}
        if form == "JOB":
            assert sw.load(clipboard.clipboard) == sw.from_object(ob)
        else:
            before = set(scene.collection.objects)
            exec(clipboard.clipboard, {})
            (made,) = set(scene.collection.objects) - before
            assert sw.from_object(made) == sw.from_object(ob)


def test_presets_of_trees_are_added_where_the_cursor_is(scene):
    scene.cursor.location = (1, 2, 3)
    assert bpy.ops.mesh.sweep_preset_add(preset="SWEEP_CSG_TWO_TRIANGLES") == {"FINISHED"}
    ob = bpy.context.active_object
    assert ob.select_get() and trees.is_tree(ob) and tuple(ob.location) == (1, 2, 3)
    assert shown(ob).volume() == pytest.approx(sw.presets.shape("sweep_csg_two_triangles").mesh().volume(), rel=1e-5)


def test_the_same_step_once_more_is_refused(scene):
    """What was taken away is not there to be taken again; after a step of another kind it may be."""
    body, tool, other = cube(2.0), cube(1.0, name="tool"), cube(1.0, name="other")
    tool.location, other.location = (1, 0, 0), (0, 1, 0)
    for each in (tool, other):
        operands.combine(body, [each], "difference")
    with pytest.raises(sw.ShapeError, match="'tool' is the operand of the step 'Difference' of"):
        operands.combine(body, [tool], "difference")
    assert len(trees.booleans(body)) == 2
    operands.combine(body, [tool], "union")
    operands.combine(body, [tool], "difference")
    assert len(trees.booleans(body)) == 4
    trees.booleans(body)[-1].show_viewport = False
    with pytest.raises(sw.ShapeError, match="already, which is muted"):
        operands.combine(body, [tool], "difference")
