# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Level sets: manifold for any signs on a lattice, and near what closed formulas say."""

import numpy as np
import pytest

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.meshes.polyhedron import polyhedron
from sweep_addon.core.offsets.band import CORNERS, Band
from sweep_addon.core.offsets.cycles import tables
from sweep_addon.core.offsets.dual import dual_surface
from sweep_addon.core.offsets.implicit import Implicit
from sweep_addon.core.offsets.level_set import level_set


def random_band(random, size, share):
    """A band whose corners are inside by chance, at the border outside: every way to pass a cell, side by side."""
    inside = np.zeros((size + 1,) * 3, dtype=bool)
    inside[1:-1, 1:-1, 1:-1] = random.random((size - 1,) * 3) < share
    cells = np.stack(np.meshgrid(*[np.arange(size)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    x, y, z = (cells[:, None] + CORNERS).transpose(2, 0, 1)
    bits = inside[x, y, z] @ (1 << np.arange(8))
    crossed = (bits > 0) & (bits < 255)
    return Band(np.zeros(3), 1.0, cells[crossed], bits[crossed], np.zeros((crossed.sum(), 0)))


def fans(triangles):
    """In how many pieces the triangles around each vertex hang together, (n,) int array."""
    corner = np.arange(triangles.size).reshape(-1, 3)
    after = dict(
        zip(
            zip(triangles.ravel().tolist(), np.roll(triangles, -1, axis=1).ravel().tolist(), strict=True),
            corner.ravel().tolist(),
            strict=True,
        )
    )
    seen, pieces = set(), np.zeros(triangles.max() + 1, dtype=int)
    for start in corner.ravel().tolist():
        if start in seen:
            continue
        pieces[triangles.ravel()[start]] += 1
        here = start
        while here not in seen:
            seen.add(here)
            face, which = divmod(here, 3)
            here = after[triangles[face, which], triangles[face, which - 1]]
    return pieces


@pytest.mark.parametrize("share", [0.1, 0.3, 0.5, 0.7, 0.9])
def test_any_signs_give_a_closed_manifold_surface(share):
    random = np.random.default_rng(int(10 * share))
    for _ in range(4):
        dual = dual_surface(random_band(random, 12, share))
        triangles = np.concatenate((dual.quads[:, [0, 1, 2]], dual.quads[:, [0, 2, 3]]))
        mesh = polyhedron(dual.starts, triangles)
        assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
        assert (fans(triangles) == 1).all()


def test_the_volume_of_any_signs_is_about_that_of_the_corners_inside():
    random = np.random.default_rng(1)
    band = random_band(random, 30, 0.9)
    dual = dual_surface(band)
    mesh = polyhedron(dual.starts, dual.quads)
    assert 0.75 * 29**3 < mesh.volume() < 29**3


def test_each_crossed_edge_is_on_one_cycle_of_three_edges_or_more():
    cycle, count, _ = tables()
    crossed = cycle >= 0
    assert (crossed.sum(axis=2) >= 3 * count).all() and (cycle.max(axis=2) == count - 1).all()
    assert (count[0] == count[63, ::-1]).all()  # to turn all faces is to change inside and outside


def test_the_surface_of_a_ball_has_its_volume_to_second_order():
    ball = Implicit(lambda points: np.linalg.norm(points - 0.1, axis=1) - 1)
    errors = []
    for step in (0.2, 0.1, 0.05):
        surface = level_set(ball, (-0.9,) * 3, (1.1,) * 3, step)
        mesh = polyhedron(surface.vertices.places, surface.triangles)
        assert mesh.euler_characteristic() == 2 and not len(surface.crossing)
        errors.append(1 - mesh.volume() / (4 / 3 * np.pi))
    assert 0 < errors[2] < 2e-3 and errors[0] / errors[1] > 3 and errors[1] / errors[2] > 3


def lens(points):
    """Where two balls are together; its rim, of a right angle, is the unit circle."""
    return np.maximum(*(np.linalg.norm(points - (0, 0, z), axis=1) - np.sqrt(2) for z in (-1, 1)))


def hollow(points):
    """A block without the lens: the rim is a valley seen from outside the block."""
    return np.maximum(np.abs(points).max(axis=1) - 1.5, -lens(points))


@pytest.mark.thorough
@pytest.mark.parametrize("field", [lens, hollow])
def test_a_crease_has_vertices_all_along(field):
    """No lattice sees the rim itself where it is thinner than a cell: there a vertex stays up to half a cell off."""
    step = 0.05
    surface = level_set(Implicit(field), (-1.5,) * 3, (1.5,) * 3, step)
    assert not len(surface.crossing)
    angle = 2 * np.pi * np.arange(300) / 300
    rim = np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1)
    away = np.linalg.norm(rim[:, None] - surface.vertices.places, axis=2).min(axis=1)
    assert np.median(away) < 0.4 * step and away.max() < 0.75 * step


def test_a_function_that_changes_faster_than_it_says_is_refused():
    """The zero is missed in some cells and found in their neighbours."""
    steep = Implicit(lambda points: 3 * (np.linalg.norm(points, axis=1) - 1))
    with pytest.raises(ShapeError, match="its zero has gaps"):
        level_set(steep, (-1,) * 3, (1,) * 3, 0.02)


def test_nothing_inside_is_nothing():
    assert level_set(Implicit(lambda points: np.linalg.norm(points, axis=1) + 1), (-1,) * 3, (1,) * 3, 0.1) is None
