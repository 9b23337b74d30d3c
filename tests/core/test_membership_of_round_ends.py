# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of round ends and of tips, against formulas: whatever the contour has become there, and wherever it leads."""

from math import pi, sqrt

import numpy as np
import pytest

import sweep_addon as sw

UP = sw.trajectories.Line()
TRIANGLE = sw.contours.Outline([[(0, 0), (1, 0), (0, 1)]])


def points(low, high, count=20_000):
    return np.random.default_rng(0).uniform(low, high, (count, 3))


def test_round_ends_of_a_morph_are_those_of_the_contours_that_stand_there():
    """Squares of half breadths 0.1 and 0.2, and domes as high."""
    big = [{"t": 1.0, "contour": sw.contours.Rectangle(0.4, 0.4)}]
    rod = sw.GeneralizedCylinder(sw.contours.Rectangle(0.2, 0.2), UP, morph=big, start="round", end="round")
    p = points((-0.25, -0.25, -0.15), (0.25, 0.25, 1.25))
    across, z = np.abs(p[:, :2]).max(axis=1), p[:, 2]
    inside = np.where(z < 0, np.hypot(across, z) < 0.1, np.where(z > 1, np.hypot(across, z - 1) < 0.2, 0))
    inside = np.where((z >= 0) & (z <= 1), across < 0.1 + 0.1 * z, inside)
    assert (sw.classify(rod, p) == np.where(inside, 1, -1)).all()
    assert sw.classify(rod, [(0, 0, 1.2), (0, 0, -0.1)]).tolist() == [0, 0]


def test_the_tip_of_a_mirrored_contour_is_over_its_own_centroid():
    """A right triangle's centroid is a third of its legs from them, and sqrt(2) / 6 from its longest side."""
    rod = sw.GeneralizedCylinder(TRIANGLE, UP, scale_x=-1.0, end="round")
    tip = np.array([(-1 / 3, 1 / 3, 1 + sqrt(2) / 6)])
    assert sw.classify(rod, tip + [(0, 0, 0), (0, 0, -0.01), (0, 0, 0.01)]).tolist() == [0, 1, -1]


def test_a_tube_that_runs_backward_beyond_the_centre_has_its_round_ends_outside():
    """A contour 0.8 inwards of a quarter of a circle of 0.5 goes round one of 0.3: all that is near that quarter."""
    tube = sw.GeneralizedCylinder(
        sw.contours.Circle(0.1), sw.trajectories.Arc(0.5, pi / 2), offset_x=-0.8, start="round", end="round"
    )
    p = points((-0.5, -0.5, -0.12), (0.2, 0.2, 0.12))
    angle = np.clip(np.arctan2(-p[:, 1], -p[:, 0]), 0, pi / 2)
    nearest = -0.3 * np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1)
    assert (sw.classify(tube, p) == np.sign(0.1 - np.linalg.norm(p - nearest, axis=1))).all()


@pytest.mark.parametrize("law", ["1 - t", "sqrt(1 - t^2)", "sqrt(1 - t)"])
@pytest.mark.parametrize("frame", ["rotation-minimizing", "fixed-up"])
def test_a_tip_is_on_the_trajectory_however_steeply_a_contour_beside_it_shrinks(law, frame):
    path = sw.trajectories.Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0.5)])
    beside = sw.contours.Outline([[(0.02, 0.02), (0.1, 0.04), (0.04, 0.1)]])
    horn = sw.GeneralizedCylinder(beside, path, scale_x=law, scale_y=law, frame=frame)
    assert sw.classify(horn, [(1, 1, 0.5), (1, 1, 0.5001), (1, 1.0001, 0.5)]).tolist() == [0, -1, -1]
