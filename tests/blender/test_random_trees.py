# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random trees: what the Boolean modifiers of their objects leave holds the points that the trees hold."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from conftest import BRIEF, FULL
from scenes import shown

import sweep_addon as sw

TREES, POINTS, DEEPEST = 200 if FULL else 4 if BRIEF else 25, 400, 5
BAND = 2e-3  # metres: the chord error of a circle of 0.6 m and 64 points is 7e-4


def leaf(random):
    """A prism, a bar or a bend, somewhere and turned somehow."""
    shapes = [
        sw.TranslationalSweep(sw.contours.Rectangle(*random.uniform(0.5, 1.5, 2)), height=random.uniform(0.5, 1.5)),
        sw.TranslationalSweep(sw.contours.Star(5, random.uniform(0.5, 1), 0.4), height=random.uniform(0.5, 1.5)),
        sw.GeneralizedCylinder(sw.contours.Circle(random.uniform(0.2, 0.6)), sw.trajectories.Line(end=(0.2, 0, 1.5))),
    ]
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    return sw.Placed(shapes[random.integers(3)], np.column_stack((turn, random.uniform(-0.6, 0.6, 3))))


def tree(random, deep):
    """A tree of that many levels at most."""
    if deep == 0 or random.random() < 0.15:
        return leaf(random)
    operations = random.choice(["union", "difference", "intersection"], 2, p=[0.5, 0.35, 0.15])
    steps = [(str(operation), tree(random, deep - 1)) for operation in operations[: random.integers(1, 3)]]
    return sw.Tree(leaf(random), steps)


def winding(mesh, points):
    """How many times a closed mesh of triangles goes round each point: the sum of its solid angles (van Oosterom)."""
    corners = mesh.vertices[mesh.corners.reshape(-1, 3)]
    a, b, c = (corners[None, :, i] - points[:, None] for i in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=-1) for v in (a, b, c))
    volume = np.einsum("ijk,ijk->ij", a, np.cross(b, c))
    dots = [np.einsum("ijk,ijk->ij", *pair) for pair in ((a, b), (b, c), (c, a))]
    below = la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb
    return np.arctan2(volume, below).sum(axis=1) / (2 * np.pi)


@pytest.mark.parametrize("seed", range(TREES))
def test_modifiers_leave_what_the_tree_holds(scene, seed):
    random = np.random.default_rng(seed)
    value = sw.Tree(leaf(random), [("union", tree(random, DEEPEST - 1)), ("difference", tree(random, DEEPEST - 2))])
    ob = sw.to_object(value)
    bpy.context.view_layer.update()
    points = random.uniform(-1.2, 1.2, (POINTS, 3))
    labels = sw.classify(value, points, BAND)
    sure = labels != 0
    matrix = np.array(ob.matrix_world)
    local = np.linalg.solve(matrix[:3, :3], (points[sure] - matrix[:3, 3]).T).T
    round_ = winding(shown(ob), local) > 0.5
    assert (round_ == (labels[sure] > 0)).all()
