# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The camera shows all of a shape, and is no farther away than that takes."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.batch.camera import NEAREST, axes, fit, turned

angles = st.floats(-1.5, 1.5)
clouds = st.integers(0, 2**32 - 1).map(lambda seed: np.random.default_rng(seed).normal(size=(30, 3)) * [3, 1, 0.3] + 5)


def seen(points, place, view, slopes):
    """Where points are in the picture, from -1 to 1."""
    right, up, away = view @ (points - place).T
    assert (away > 0).all()
    return np.stack([right / away / slopes[0], up / away / slopes[1]])


@given(clouds, angles, angles, st.floats(0.05, 1), st.floats(0.05, 1))
def test_the_picture_is_filled_and_nothing_is_cut(points, azimuth, elevation, across, along):
    view = axes(azimuth, elevation)
    place = fit(points, view, (across, along))
    extent = seen(points, place, view, (across, along))
    low, high = extent.min(axis=1), extent.max(axis=1)
    assert low.min() > -1 - 1e-9 and high.max() < 1 + 1e-9
    touching = (abs(low + 1) < 1e-9) & (abs(high - 1) < 1e-9)
    nearest = ((points - place) @ view[2]).min() / np.linalg.norm(np.ptp(points, axis=0))
    assert touching.any() or nearest == pytest.approx(NEAREST)


@pytest.mark.parametrize("azimuth, elevation", [(0, 0), (1, 0.5), (-2, -1.5)])
def test_axes_are_right_handed_and_look_at_the_shape(azimuth, elevation):
    right, up, away = axes(azimuth, elevation)
    assert np.allclose(np.cross(right, up), -away) and np.allclose(axes(azimuth, elevation) @ away, [0, 0, 1])
    assert up[2] > 0 and right[2] == 0


@given(clouds, st.floats(0, 6.3))
def test_one_camera_shows_every_turn(points, azimuth):
    slopes = (0.2, 0.15)
    steady = fit(turned(points, 256), axes(azimuth, 0.4), slopes)
    extent = seen(points, steady, axes(azimuth, 0.4), slopes)
    assert np.abs(extent).max() < 1 + 0.02
