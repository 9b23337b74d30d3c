# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges that cut creases off are flipped or split, and the surface stays closed and manifold."""

import numpy as np
import pytest

from sweep_addon.core.meshes.polyhedron import polyhedron
from sweep_addon.core.offsets import level_set
from sweep_addon.core.offsets.crossings import crossing_pairs
from sweep_addon.core.offsets.edge_changes import about
from sweep_addon.core.offsets.implicit import Implicit


def turned_cube(seed):
    """The surface of a cube of side 2, turned by chance."""
    axes = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    cube = Implicit(lambda points: np.abs(points @ axes).max(axis=1) - 1)
    surface = level_set.level_set(cube, (-1.8,) * 3, (1.8,) * 3, 0.2)
    return surface, polyhedron(surface.vertices.places, surface.triangles)


@pytest.mark.parametrize("seed", range(4))
def test_a_mended_cube_is_nearer_to_its_volume_and_sound(seed, monkeypatch):
    surface, mesh = turned_cube(seed)
    monkeypatch.setattr(level_set, "mended", lambda field, vertices, triangles, *_: (vertices, triangles))
    _, before = turned_cube(seed)
    assert abs(8 - mesh.volume()) < abs(8 - before.volume())
    assert mesh.euler_characteristic() == 2
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    near, cells = about(surface.vertices.places[surface.triangles], np.ones(len(surface.triangles), dtype=bool))
    assert not len(crossing_pairs(surface.vertices.places, surface.triangles[near], cells))
