# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-CSG trees as values: made by operators, printed, compared, kept in jobs, and their meshes."""

import pytest

import sweep_addon as sw
from sweep_addon.core.csg import tree as trees
from sweep_addon.core.declared.forms import python_source

pytest.importorskip("manifold3d", reason="meshes of trees are asked of manifold3d")

BLOCK, ROD = sw.solids.Block(1.0, 1.0, 1.0), sw.solids.Cylinder(0.2, 3.0)
TUBE = sw.GeneralizedCylinder(sw.contours.Rectangle(0.2, 0.2), sw.trajectories.Line(end=(0, 0, 2)))


def test_operators_make_steps_and_brackets_make_operands():
    assert (BLOCK | ROD) - TUBE == sw.Tree(BLOCK, [("union", ROD), ("difference", TUBE)])
    assert BLOCK | (ROD - TUBE) == sw.Tree(BLOCK, [("union", sw.Tree(ROD, [("difference", TUBE)]))])
    assert len({BLOCK - ROD, BLOCK - ROD, BLOCK | ROD}) == 2


@pytest.mark.parametrize(
    "tree, line",
    [
        (BLOCK | ROD | TUBE, "Block | Cylinder | GeneralizedCylinder"),
        ((BLOCK | ROD) - TUBE, "(Block | Cylinder) - GeneralizedCylinder"),
        ((BLOCK - ROD) & (TUBE | ROD), "(Block - Cylinder) & (GeneralizedCylinder | Cylinder)"),
        (sw.SweptSolid(BLOCK - ROD), "sweep(Block - Cylinder)"),
        (BLOCK - ROD.moved(x=1), "Block - Cylinder"),
        (BLOCK - (sw.SweptSolid(ROD) - TUBE), "Block - (sweep(Cylinder) - GeneralizedCylinder)"),
        (sw.Tree(BLOCK | ROD, [("difference", TUBE)]), "(Block | Cylinder) - GeneralizedCylinder"),
        (ROD | sw.SweptContour(sw.contours.Circle(0.1), sw.trajectories.Line()), "Cylinder | (Circle * Line)"),
    ],
)
def test_a_tree_prints_as_the_expression_that_makes_it(tree, line):
    assert str(tree) == line


@pytest.mark.parametrize("tree", [(BLOCK | ROD.moved(z=1)) - TUBE, BLOCK - sw.SweptSolid(ROD | TUBE), TUBE & BLOCK])
def test_a_tree_is_kept_by_a_job_and_by_a_line_of_python(tree):
    assert sw.load(sw.dump(tree)) == tree
    assert eval(python_source(tree), {"sw": sw}) == tree


def test_operands_of_a_job_may_lie_in_files(tmp_path):
    (tmp_path / "square.svg").write_text('<svg viewBox="0 0 2 2"><path d="M0 0 H2 V2 H0 Z"/></svg>')
    (tmp_path / "job.toml").write_text(
        'kind = "tree"\n[base]\nkind = "translational-sweep"\ncontour = {file = "square.svg"}\n'
        '[[steps]]\noperation = "difference"\noperand = {kind = "cylinder", radius = 0.5, height = 4.0}\n'
    )
    assert sw.load(tmp_path / "job.toml").base.contour.section().area == pytest.approx(4.0)


@pytest.mark.parametrize(
    "tree, volume",
    [
        (BLOCK | BLOCK.moved(x=0.5), 1.5),
        (BLOCK & BLOCK.moved(x=0.5), 0.5),
        (BLOCK - BLOCK.moved(x=0.5), 0.5),
        ((BLOCK | BLOCK.moved(x=1)) - TUBE.moved(z=-1), 2 - 0.04),
        (BLOCK | BLOCK.moved(x=1), 2.0),
    ],
)
def test_the_mesh_has_the_volume_of_the_set(tree, volume):
    mesh = tree.mesh()
    assert mesh.volume() == pytest.approx(volume, rel=1e-12)
    assert not len(mesh.non_manifold_edges())


def test_an_operand_that_a_tree_has_many_times_is_made_once():
    """Twice as often at each level: four thousand times in all."""
    tree = BLOCK
    for level in range(12):
        tree = sw.Tree(tree, [("union" if level % 2 else "intersection", tree)])
    assert tree.mesh().volume() == pytest.approx(1.0, rel=1e-12)


def test_a_mirrored_operand_is_outward():
    mirrored = sw.Placed(sw.solids.Bracket(), [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0]])
    assert mirrored.mesh().volume() == pytest.approx(sw.solids.Bracket().mesh().volume())


@pytest.mark.thorough
def test_an_operand_that_crosses_itself_is_resolved_first():
    """The closed form of a spindle torus's solid; its surface alone counts the lens twice."""
    from math import pi

    spindle = sw.GeneralizedCylinder(
        sw.contours.Circle(0.5, 48), sw.trajectories.Arc(0.3, 2 * pi), sw.sampling.Count(48)
    )
    assert (spindle | spindle.moved(x=5)).mesh().volume() == pytest.approx(2 * 1.53774, rel=2e-2)


@pytest.mark.parametrize(
    "make, sentence",
    [
        (lambda: sw.Tree(base="bal"), "base: must be a shape, a solid or a tree, got 'bal'"),
        (lambda: sw.Tree(BLOCK, [("minus", ROD)]), "steps.1.operation: must be one of union, intersection, difference"),
        (lambda: sw.Placed(BLOCK, [[1, 0, 0, 0]]), "matrix: must have three rows of four numbers, got 1"),
        (lambda: sw.Placed(BLOCK, [[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]]), "matrix: must leave a volume, got 0"),
        (
            lambda: (BLOCK - sw.GeneralizedCylinder(start="open")).mesh(),
            "steps.1.operand: ",
        ),
    ],
)
def test_what_is_no_tree_is_refused(make, sentence):
    with pytest.raises(sw.ShapeError) as refused:
        make()
    assert str(refused.value).startswith(sentence)


@pytest.mark.parametrize(
    "by, shape",
    [
        (sw.Translation(2.0, (1, 0, 2)), sw.TranslationalSweep(sw.contours.Circle(0.3), 2.0, direction=(1, 0, 2))),
        (sw.Rotation(3.0, axis_point=(-1, 0)), sw.RotationalSweep(sw.contours.Circle(0.3), 3.0, axis_point=(-1, 0))),
        (sw.trajectories.Helix(), sw.GeneralizedCylinder(sw.contours.Circle(0.3), sw.trajectories.Helix())),
        (sw.RigidMotion(turn_z="t"), sw.GeneralSweep(sw.contours.Circle(0.3), turn_z="t")),
    ],
)
def test_a_contour_and_a_transformation_make_a_sweep(by, shape):
    primitive = sw.SweptContour(sw.contours.Circle(0.3), by)
    assert primitive.sweep() == shape
    assert sw.load(sw.dump(primitive - BLOCK)) == primitive - BLOCK
    points = [(0.1, 0.1, 0.1), (1.0, 0.0, 0.0), (9.0, 9.0, 9.0)]
    assert (sw.classify(primitive, points) == sw.classify(shape, points)).all()


def test_an_operand_may_be_named():
    assert sw.Tree("ball", [("difference", "block")]) == sw.solids.Ball() - sw.solids.Block()


def test_a_tree_that_is_too_deep_is_refused():
    tree = BLOCK
    with pytest.raises(sw.ShapeError, match="must be at most 100 trees deep"):
        for _ in range(200):
            tree = sw.Tree(ROD, [("union", tree)])


def test_how_deep_a_tree_is_asks_a_shared_operand_once(monkeypatch):
    """Twelve trees that each take the next one twice are 12 trees of a block, and a rod; by all ways 2^12."""
    tree = ROD
    for _ in range(12):
        tree = sw.Tree(BLOCK, [("union", tree), ("difference", tree)])
    asked, inside = [], trees.inside
    monkeypatch.setattr(trees, "inside", lambda node: asked.append(node) or inside(node))
    assert trees.depth(tree) == 12 and len(asked) <= 3 * 13


def doubled(times):
    """A union that names one solid two to the power of so many times, from a new beginning."""
    tree = sw.solids.Block() | sw.solids.Ball()
    for _ in range(times):
        tree = sw.Tree(tree, [("union", tree)])
    return tree


def test_operands_that_are_shared_are_walked_once():
    """Named a million million times they would else take longer than anybody waits."""
    tree, twin = doubled(40), doubled(40)
    assert tree == twin and hash(tree) == hash(twin)
    assert tree != doubled(39) and hash(tree) != hash(doubled(39))
    assert " operands)" in str(tree) and len(str(tree)) < 10_000 and len(repr(tree)) < 10_000
    with pytest.raises(sw.ShapeError, match=f"must name at most 100,000 operands to be written, got {2**41}"):
        sw.dump(tree)


def test_equal_trees_are_equal_however_they_share():
    block, ball = sw.solids.Block(), sw.solids.Ball()
    apart = sw.Tree(block | ball, [("difference", sw.solids.Block() | sw.solids.Ball())])
    one = block | ball
    together = sw.Tree(one, [("difference", one)])
    assert apart == together and hash(apart) == hash(together)
    assert together != sw.Tree(one, [("union", one)])
    assert sw.load(sw.dump(together)) == together
    assert together != "tree"


def test_a_tree_of_which_nothing_is_left_says_so():
    pytest.importorskip("manifold3d", reason="meshes of trees are asked of manifold3d")
    mesh = (sw.solids.Block() - sw.solids.Block(9.0, 9.0, 9.0)).mesh()
    assert len(mesh.vertices) == 0 and mesh.volume() == 0
    assert mesh.told == ("Tree: nothing is left: the steps take all of it away.",)
