# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cusps of outlines, where an arc turns back along its tangent: points beyond the tip are on the right side."""

import numpy as np
import pytest
from line_arc_outlines import inside_by_rays, turn

import sweep_addon as sw

FILLET = [(0, 8), (0, 7), (1, 8)], [0, -np.tan(np.pi / 8), 0]  # the region ends in two tips
DISC_ON_A_PLATE = [(-2, -1), (2, -1), (2, 0), (0, 0), (-1, 1)], [0, 0, 0, np.tan(3 * np.pi / 8), 0]  # a gap ends in one


@pytest.mark.parametrize("miss", [-1e-6, -1e-10, 0, 1e-10, 1e-8])
@pytest.mark.parametrize("angle", [0.0, 0.6, 2.5])
@pytest.mark.parametrize("corners, bulges", [FILLET, DISC_ON_A_PLATE])
def test_no_point_beyond_a_tip_is_wrong(corners, bulges, angle, miss):
    """Also where the arc misses its tangent a little on the one side or on the other."""
    corners, bulges = np.array(corners) @ turn(angle), np.where(bulges, np.array(bulges) + miss, 0.0)
    low, high = corners.min(axis=0), corners.max(axis=0)
    places = np.random.default_rng(1).uniform(2 * low - high, 2 * high - low, (20_000, 2))
    points = np.column_stack([places, np.full(len(places), 0.5)])
    found = sw.classify(sw.TranslationalSweep(sw.contours.Outline([corners], [bulges]), 1.0), points)
    inside = inside_by_rays(np.column_stack([corners, bulges]), places)
    np.testing.assert_array_equal(found, np.where(inside, 1, -1))
