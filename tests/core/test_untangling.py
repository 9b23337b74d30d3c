# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertices of a dual surface that were moved to one place are put back apart."""

import numpy as np

from sweep_addon.core.offsets.band import narrow_band
from sweep_addon.core.offsets.dual import dual_surface
from sweep_addon.core.offsets.implicit import Implicit
from sweep_addon.core.offsets.level_set import cut
from sweep_addon.core.offsets.untangling import doubled, untangled
from sweep_addon.core.offsets.vertices import Vertices

BALLS = np.array([(0.0, 0.0, 0.0), (1.0, 1.0, 1.0)])  # about two corners of one cell of side 1


def two_balls():
    """The vertices of the dual surface of two balls, their triangles, and the cells of both."""
    field = Implicit(lambda points: np.linalg.norm(points[:, None] - BALLS, axis=2).min(axis=1) - 0.3)
    band = narrow_band(field, (-1.5, -1.5, -1.5), (2.5, 2.5, 2.5), 1.0)
    dual = dual_surface(band)
    vertices = Vertices(dual.starts, *field.normals(dual.starts, band.hints[dual.cell]))
    return vertices, cut(dual.quads, vertices), np.tile(dual.cell[dual.quads], (2, 1)), dual.cell


def test_two_vertices_of_a_cell_that_went_to_one_corner_of_it_are_put_back():
    start, triangles, corner_cells, cell = two_balls()
    (crowded,) = np.flatnonzero(np.bincount(cell) == 2)
    both = np.flatnonzero(cell == crowded)
    corner = start.places[both].mean(axis=0) + (0.5, -0.5, 0.5)
    moved = start.replaced(both, Vertices(np.tile(corner, (2, 1)), start.values[both], *(
        part[both] for part in (start.normals, start.hints))))  # fmt: skip
    assert doubled(moved.places).tolist() == both.tolist()

    vertices, crossing = untangled((start, moved), triangles, corner_cells, cell)

    assert len(np.unique(vertices.places.astype(np.float32), axis=0)) == len(vertices.places)
    assert (vertices.places == start.places).all() and not len(crossing)


def test_doubled_places_are_those_that_comparing_all_in_single_precision_finds():
    random = np.random.default_rng(0)
    places = random.integers(-2, 3, (300, 3)) * np.where(random.random((300, 1)) < 0.5, 0.1, 1e9)
    places[::7] = -0.0
    places += random.choice((0.0, 1e-12, 1e-3), (300, 1))
    single = places.astype(np.float32)
    alike = (single[:, None] == single).all(axis=2)
    expected = np.flatnonzero(alike.sum(axis=1) > 1)
    assert 0 < len(expected) < 300 and doubled(places).tolist() == expected.tolist()
