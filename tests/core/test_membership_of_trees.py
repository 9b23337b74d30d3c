# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership of random trees beside their meshes: leaves of all kinds, placed anyhow, up to five levels deep.

A point may be told otherwise only where it is so near to the surface of some leaf that a chord passes it on the other
side; the volumes are those that Monte Carlo finds.
"""

from functools import cache

import numpy as np
import pytest
from conftest import FULL
from membership_shapes import CHORD, SHAPES, body, closed

import sweep_addon as sw
from sweep_addon.core.membership.sets.bodies import MeshBody

pytest.importorskip("manifold3d", reason="meshes of trees are asked of manifold3d")
pytestmark = pytest.mark.thorough

SLOW = ("spindle", "moved block", "offset outside")  # to make meshes of
LEAVES = [name for name in SHAPES if name not in SLOW]
POINTS, DEEPEST = 4_000 if FULL else 1_500, 5


@cache
def operand(name):
    """The closed mesh of a leaf as an operand of its own: it is made once for all trees."""
    return sw.solids.Triangles.of(closed(name))


def motion(rng):
    """Three rows of a random rigid motion by up to 0.2 m."""
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    turn[:, 0] *= np.sign(np.linalg.det(turn))
    return np.column_stack((turn, rng.uniform(-0.2, 0.2, 3)))


def grown(rng, depth):
    """A random tree, the same of meshes, and its leaves with how these are placed."""
    if depth == 0 or rng.random() < 0.25 * (DEEPEST - depth) / DEEPEST:
        name = str(rng.choice(LEAVES))
        low, high = closed(name).vertices.min(axis=0), closed(name).vertices.max(axis=0)
        rows = motion(rng)
        rows[:, 3] -= rows[:, :3] @ (low + high) / 2
        return sw.Placed(SHAPES[name], rows), sw.Placed(operand(name), rows), [(name, rows)]
    (a, mesh_a, of_a), (b, mesh_b, of_b) = grown(rng, depth - 1), grown(rng, depth - 1)
    operation = rng.choice(["union", "difference", "intersection"], p=[0.5, 0.35, 0.15])
    tree, meshes = (sw.Tree(one, [(str(operation), other)]) for one, other in ((a, b), (mesh_a, mesh_b)))
    if depth < DEEPEST and rng.random() < 0.3:
        rows = motion(rng)
        placed = [(name, np.column_stack((rows[:, :3] @ old[:, :3], rows[:, :3] @ old[:, 3] + rows[:, 3])))
                  for name, old in (*of_a, *of_b)]  # fmt: skip
        return sw.Placed(tree, rows), sw.Placed(meshes, rows), placed
    return tree, meshes, of_a + of_b


def near_a_leaf(leaves, points):
    """How far points are from the nearest surface of a leaf's mesh: (n,)."""
    found = np.full(len(points), np.inf)
    for name, rows in leaves:
        found = np.minimum(found, np.abs(body(name).distance((points - rows[:, 3]) @ rows[:, :3])))
    return found


@pytest.mark.parametrize("seed", [*range(8), *(pytest.param(n, marks=pytest.mark.large) for n in range(8, 200))])
def test_a_tree_is_where_its_mesh_is(seed):
    rng = np.random.default_rng(seed)
    tree, meshes, leaves = grown(rng, DEEPEST if seed % 4 == 0 else 1 + seed % 4)
    made = meshes.mesh()
    corners = np.concatenate([closed(name).vertices @ rows[:, :3].T + rows[:, 3] for name, rows in leaves])
    low, high = corners.min(axis=0), corners.max(axis=0)
    points = rng.uniform(low, high, (POINTS, 3))
    labels = sw.classify(tree, points)
    inside, volume = np.zeros(POINTS, dtype=bool), 0.0
    if len(made.vertices):  # some leave nothing
        inside, volume = MeshBody(made).distance(points) < 0, made.volume()
    other = points[labels != np.where(inside, 1, -1)]
    assert near_a_leaf(leaves, other).max(initial=0.0) < CHORD
    part = np.array([np.mean(labels == 1), volume / (high - low).prod()])
    deviation = np.sqrt(part[1] * (1 - part[1]) / POINTS)
    assert abs(part[0] - part[1]) < 5 * deviation + 0.002


def test_a_tree_doubled_many_times_is_told_at_once():
    """A union of a tree and itself is that tree; asked of both each time it would be two to the power of forty."""
    tree = one = sw.solids.Block(1.0, 1.0, 1.0) | sw.solids.Ball(0.6)
    for _ in range(40):
        tree = sw.Tree(tree, [("union", tree)])
    points = np.random.default_rng(0).uniform(-1, 1, (1000, 3))
    assert (sw.classify(tree, points) == sw.classify(one, points)).all()
