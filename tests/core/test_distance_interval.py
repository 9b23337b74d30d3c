# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bounds of the distance on triangles of whose corners the nearest points are known, against points all over them."""

import numpy as np

from sweep_addon.core.offsets.interval import distance_interval, enclosing, least

TRIANGLE = np.array([(0, 1, 2)])


def test_no_place_is_nearer_or_farther_than_the_bounds_whatever_it_is_far_from():
    """Of random points, from one alone to thirty, near and far."""
    random = np.random.default_rng(0)
    weights = random.dirichlet((0.5, 0.5, 0.5), 300)
    for _ in range(200):
        points = random.normal(size=(random.integers(1, 31), 3)) * random.uniform(0.2, 2)
        corners = random.normal(size=(3, 3)) * random.uniform(0.05, 1) + random.normal(size=3)
        distances = np.linalg.norm(corners[:, None] - points, axis=2)
        found = distance_interval(corners, TRIANGLE, distances.min(axis=1), points[distances.argmin(axis=1)])
        places = weights @ corners
        true = np.linalg.norm(places[:, None] - points, axis=2).min(axis=1)
        assert (true >= found[0] - 1e-12).all() and (true <= found[1] + 1e-12).all()


def test_the_lower_bound_is_the_distance_itself_from_one_point():
    """Of a triangle in the plane z = 1 over the point: 1 where it is over the triangle, and beside it the way aside."""
    over = np.array([(1.0, 0.0, 1.0), (-1.0, 1.0, 1.0), (-1.0, -1.0, 1.0)])
    for way, expected in ((0.0, 1.0), (2.0, np.sqrt(2))):
        corners = over + (way, 0, 0)
        lower, _ = distance_interval(corners, TRIANGLE, np.linalg.norm(corners, axis=1), np.zeros((3, 3)))
        np.testing.assert_allclose(lower, expected, rtol=1e-12)


def test_of_needles_too_the_bound_is_less_than_any_place_and_more_than_the_smallest_circle_tells():
    """Triangles of all heights from a billionth of their length."""
    random = np.random.default_rng(1)
    corners = random.normal(size=(2000, 3, 3))
    heights = 10 ** random.uniform(-9, 0, (2000, 1)) * random.normal(size=(2000, 3))
    corners[:, 2] = corners[:, 0] + (corners[:, 1] - corners[:, 0]) * random.uniform(-1, 2, (2000, 1)) + heights
    squares = random.uniform(0, 3, (2000, 3))
    weights = random.dirichlet((0.5, 0.5, 0.5), 300)
    linear = np.einsum("wi,tic->wtc", weights, corners)
    rises = ((linear**2).sum(axis=2) - weights @ (corners**2).sum(axis=2).T) + weights @ squares.T
    found = least(corners, squares)
    assert (found <= rises.min(axis=0) + 1e-9).all()
    assert (found >= squares.min(axis=1) - enclosing(corners) ** 2).all()
