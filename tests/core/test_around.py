# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the field around a mesh knows without a search, or with fewer, against distances that are searched for."""

import numpy as np
import pytest

from sweep_addon.core.distance import PseudoNormals, Tree, nearest
from sweep_addon.core.meshes.facets import facets
from sweep_addon.core.offsets.any_field import AnyField
from sweep_addon.core.offsets.around import Around
from sweep_addon.core.offsets.band import narrow_band
from sweep_addon.core.offsets.dual import dual_surface
from sweep_addon.core.offsets.on_edges import crossings
from sweep_addon.core.offsets.vertices import Vertices
from sweep_addon.core.solids import DrilledBlock

MESH = DrilledBlock().mesh()
VERTICES, TRIANGLES = MESH.vertices, facets(MESH)[0]
RADIUS, STEP = 0.05, 0.02
TREE, SIDES = Tree.of(VERTICES[TRIANGLES], largest=4 * STEP), PseudoNormals.of(VERTICES, TRIANGLES)


def signed(points):
    """The distance from the block, negative inside."""
    found = nearest(TREE, points)
    return np.where(SIDES.outside(points, found), 1, -1) * found.distances


@pytest.fixture(params=[True, False], ids=["outward", "inward"])
def around(request):
    return Around(VERTICES, TRIANGLES, RADIUS, request.param, STEP)


def band_of(field):
    return narrow_band(field, VERTICES.min(axis=0) - RADIUS, VERTICES.max(axis=0) + RADIUS, STEP)


@pytest.mark.parametrize("reach", [0.005, 0.03, 0.2])
@pytest.mark.parametrize("hinted", [False, True])
def test_values_within_reach_are_those_of_the_distance_and_others_are_beyond_it(around, reach, hinted):
    points = np.random.default_rng(0).uniform(-0.5, 0.5, (1000, 3))
    hints = VERTICES[np.random.default_rng(1).integers(len(VERTICES), size=len(points))] if hinted else None
    expected = around.side * signed(points) - RADIUS

    values, places = around.evaluate(points, hints, reach)

    near = np.abs(expected) <= reach
    assert near.any()
    np.testing.assert_allclose(values[near], expected[near], atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(points - places, axis=1)[near], np.abs(signed(points))[near], atol=1e-12)
    assert (np.abs(values[~near]) > reach).all()


def test_ways_out_leave_where_the_distance_is_the_radius(around):
    band = band_of(around)
    dual = dual_surface(band)
    some = dual.cell[dual.vertex[::5]], dual.edge[::5]
    places, feet, normals = crossings(around, band, *some)
    around.__class__ = type("Halving", (Around,), {"leaving": AnyField.leaving})
    halved, *_ = crossings(around, band, *some)

    assert np.abs(around.side * signed(places) - RADIUS).max() < 1e-3 * STEP
    np.testing.assert_allclose(places, halved, atol=STEP / 16)  # what four halvings leave
    assert np.abs(around.side * signed(feet) - RADIUS).max() < 1e-3 * STEP
    np.testing.assert_allclose(around.side * signed(feet - 0.5 * RADIUS * normals), 0.5 * RADIUS, atol=1e-3 * STEP)


def test_what_is_known_at_feet_is_what_a_search_finds(around):
    band = band_of(around)
    dual = dual_surface(band)
    start = Vertices(dual.starts, *around.normals(dual.starts, band.hints[dual.cell]))

    known, searched = around.at_feet(start, start.foot), start.at(around, start.foot)

    assert (start.values >= 0).mean() > 0.2
    np.testing.assert_allclose(known.values, searched.values, atol=1e-12)
    once = np.linalg.norm(known.hints - searched.hints, axis=1) < 1e-9  # but where two places are as near
    assert once.mean() > 0.99
    np.testing.assert_allclose(known.normals[once], searched.normals[once], atol=1e-9)
