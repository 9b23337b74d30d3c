# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees as objects and Boolean modifiers: to Blender and back, and by hand in the modifiers' own panel."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import shown

import sweep_addon as sw

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
