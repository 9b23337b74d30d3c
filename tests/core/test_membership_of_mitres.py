# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of mitred corners whose legs have their contours beside the path, or each in a frame of its own: formulas."""

import numpy as np
import pytest

import sweep_addon as sw

CORNER = np.array([1.0, 0.0, 0.0])


def test_a_tube_beside_its_path_is_the_one_along_the_parallel_path():
    """Two cylinders 0.1 outside the legs, cut off in the plane through the path's corner."""
    path = sw.trajectories.Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)])
    tube = sw.GeneralizedCylinder(sw.contours.Circle(0.05), path, offset_x=0.1)
    p = np.random.default_rng(0).uniform((-0.1, -0.2, -0.06), (1.2, 1.1, 0.06), (40_000, 3))
    x, y, z = p.T
    first = (np.hypot(y + 0.1, z) < 0.05) & (x > 0) & (x - 1 + y < 0)
    second = (np.hypot(x - 1.1, z) < 0.05) & (y < 1) & (x - 1 + y > 0)
    assert (sw.classify(tube, p) == np.where(first | second, 1, -1)).all()
    assert (np.abs(x - 1.1) < 0.05)[first].sum() > 50  # beyond the corner


def test_what_one_leg_has_and_the_other_has_not_is_a_face():
    """Level legs of a bar, one of which climbs: in the plane between them their sections differ."""
    bar = sw.GeneralizedCylinder(
        sw.contours.Rectangle(0.3, 0.1), sw.trajectories.Polyline([(0, 0, 0), CORNER, (1, 1, 1)]), frame="fixed-up"
    )
    before, after = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 1.0]) / np.sqrt(2)
    plane = np.linalg.svd((before + after)[None])[2][1:]
    beside = np.random.default_rng(0).uniform(-0.25, 0.25, (4000, 2)) @ plane
    first = (np.abs(beside[:, 1]) < 0.15) & (np.abs(beside[:, 2]) < 0.05)
    rising = beside @ np.cross(after, (1, 0, 0))
    second = (np.abs(beside[:, 0]) < 0.15) & (np.abs(rising) < 0.05)
    expected = np.where(first & second, 1, np.where(first | second, 0, -1))
    assert (sw.classify(bar, CORNER + beside) == expected).all()
    assert min((expected == label).sum() for label in (-1, 0, 1)) > 200


@pytest.mark.parametrize("degrees", [90, 150, 170, 178])
def test_the_point_of_a_mitre_is_on_however_sharp_it_is(degrees):
    """It is half a breadth over the cosine of half the turn from the corner; few directions lead inside."""
    turn, half = np.radians(degrees), 0.05
    path = sw.trajectories.Polyline([(-9, 0, 0), (0, 0, 0), 9 * np.array([np.cos(turn), np.sin(turn), 0])])
    bar = sw.GeneralizedCylinder(sw.contours.Rectangle(2 * half, 0.1), path)
    outward = np.array([np.sin(turn / 2), -np.cos(turn / 2), 0])
    tip = half / np.cos(turn / 2) * outward
    points = [tip + (0, 0, 0.05), tip, 0.999 * tip, 1.001 * tip]
    assert sw.classify(bar, points).tolist() == [0, 0, 1, -1]
