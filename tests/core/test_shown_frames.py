# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The frames and contours that are shown along a sweep."""

import numpy as np
import pytest

from sweep_addon import GeneralizedCylinder
from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.stations.frames import Frenet
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Helix, Line, Polyline, TorusKnot


def test_frenet_frames_of_a_helix_are_those_of_its_formula():
    """For (r cos u, r sin u, p u / 2 pi) e2 points to the axis and e3 is (k sin u, -k cos u, r) over its length."""
    radius, pitch = 1.0, 0.5
    frames = GeneralizedCylinder(trajectory=Helix(radius, pitch, 3), frame=Frenet()).frames()
    rise, u = pitch / (2 * np.pi), frames.u
    size = np.hypot(radius, rise)
    nothing = np.zeros_like(u)
    assert len(u) == 100
    assert frames.points == pytest.approx(np.stack((np.cos(u), np.sin(u), rise * u), axis=1))
    assert frames.e2 == pytest.approx(np.stack((-np.cos(u), -np.sin(u), nothing), axis=1), abs=1e-9)
    across = np.stack((rise * np.sin(u), -rise * np.cos(u), nothing + radius), axis=1) / size
    assert frames.e3 == pytest.approx(across, abs=1e-9)
    assert frames.e1 == pytest.approx(np.cross(frames.e2, frames.e3))
    assert np.ptp(np.diff(frames.s)) < 1e-9


@pytest.mark.parametrize("trajectory", [TorusKnot(), Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 2)]), Line()])
def test_contours_are_those_of_the_mesh(trajectory):
    """Where contours stand evenly in the mesh too: its vertices, column by column."""
    shape = GeneralizedCylinder(
        Rectangle(0.01, 0.02), trajectory, Count(60), twist="2*pi*t", scale_x=0.5, scale_y=0.5, offset_x=0.01
    )
    (contours,) = shape.frames(60).contours
    assert contours.swapaxes(0, 1).reshape(-1, 3) == pytest.approx(shape.mesh().vertices)


def test_contours_lie_in_e2_and_e3_about_the_reference_point():
    frames = GeneralizedCylinder(Circle(0.2, points=16), Helix(), scale_x="1 + t", scale_y="1 + t", twist="t").frames()
    arms = frames.contours[0] - frames.points[:, None]
    assert np.einsum("nmi,ni->nm", arms, frames.e1) == pytest.approx(np.zeros((len(frames.u), 16)), abs=1e-9)
    first = np.einsum("ni,ni->n", arms[:, 0], frames.e2)
    assert first == pytest.approx(0.2 * (1 + frames.s / frames.s[-1]))


def test_each_loop_of_a_contour_is_shown():
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    frames = GeneralizedCylinder(Outline([square, square / 2]), Line(end=(0, 0, 20))).frames()
    assert [loop.shape[1] for loop in frames.contours] == [4, 4]


@pytest.mark.parametrize("most", [2, 10, 100])
def test_there_are_never_more_than_asked_for(most):
    corners = np.random.default_rng(1).normal(size=(3000, 3))
    assert len(GeneralizedCylinder(Circle(0.001), Polyline(corners)).frames(most).u) == most
    assert len(GeneralizedCylinder(trajectory=TorusKnot()).frames(most).u) <= most
