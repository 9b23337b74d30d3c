# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sampling: as many contours as asked for, or as few as the tolerance allows, and where they must be."""

from math import sqrt

import numpy as np
import pytest

from sweep_addon.core.contours import Circle
from sweep_addon.core.rings.ends import Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.sampling import Count, Tolerance, place
from sweep_addon.core.trajectories import Bezier, Formula, Helix, Line, Nurbs, Polyline, TorusKnot
from sweep_addon.core.trajectories.arc_length import arc_length

QUARTERS = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)], dtype=float)
KNOT = TorusKnot(2, 3, 2.0, 0.8)
ELLIPSE = Nurbs(  # ten to one, exactly
    np.insert(QUARTERS * (10, 1), 2, 0.0, axis=1),
    [1, sqrt(0.5)] * 4 + [1],
    order=3,
    knots=[0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
)
HAIRPIN = Formula("5*cos(u)", "sin(u)/(1 + 8*cos(u)^2)", "0.2*sin(3*u)")
CHAIN = Bezier(np.random.default_rng(1).normal(size=(13, 3)))
S_CURVE = Bezier([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])
HANDRAIL = Bezier([(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0), (3.3, 0, 0), (3.5, 0.2, 0), (3.5, 0.5, 0)])
SMOOTH = {"knot": KNOT, "ellipse": ELLIPSE, "hairpin": HAIRPIN, "chain": CHAIN, "helix": Helix()}
BEGINNING = {  # where the curvature begins in the middle
    "s": S_CURVE,
    "sine": Formula("u", "sin(u)", "0", 0, 20),
    "quartic": Formula("u", "u^4", "0", -1, 1),
    "handrail": HANDRAIL,
}


def spans(trajectory, stations):
    """First and last parameter of each step."""
    ends = stations.u[1:]
    return (stations.u, np.append(ends, trajectory.domain[1])) if stations.closed else (stations.u[:-1], ends)


def distances(trajectory, stations, looks=33):
    """How far the trajectory goes away from each chord."""
    start, end = spans(trajectory, stations)
    u = start[:, None] + (end - start)[:, None] * np.linspace(0, 1, looks)
    points = trajectory.evaluate(u.ravel()).reshape(len(start), looks, 3)
    chord = points[:, -1] - points[:, 0]
    away = points - points[:, :1]
    chord /= np.linalg.norm(chord, axis=1, keepdims=True)
    away -= np.einsum("ijk,ik->ij", away, chord)[..., None] * chord[:, None]
    return np.linalg.norm(away, axis=2).max(axis=1)


def fewest_chords(trajectory, tolerance, looks=20_000):
    """The theory: the integral of the square root of the curvature over that of eight tolerances.

    Where such a chord would turn by more than 60 degrees, that of the curvature over 60 degrees.
    """
    joints = trajectory.joints()
    step = np.diff(joints) / looks
    u = (joints[:-1, None] + step[:, None] * (np.arange(looks) + 0.5)).ravel()
    first, second = trajectory.derivative(u), trajectory.derivative(u, 2)
    speed = np.linalg.norm(first, axis=1)
    curvature = np.linalg.norm(np.cross(first, second), axis=1) / speed**3
    density = np.maximum(np.sqrt(curvature / (8 * tolerance)), curvature / np.radians(60))
    return (density * speed * np.repeat(step, looks)).sum()


def turns(stations):
    ahead = np.roll(stations.arrive, -1, axis=0)[: len(stations.onward)]
    cosine = np.einsum("ij,ij->i", stations.leave[: len(ahead)], ahead)
    return np.degrees(np.arccos(cosine.clip(-1, 1)))


@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-4, 1e-6])
@pytest.mark.parametrize("name", SMOOTH | BEGINNING)
def test_no_chord_is_farther_from_its_curve_than_the_tolerance(name, tolerance):
    """Nor one from where the curvature begins, though equal integrals of its root would allow that: 2 / sqrt(3) times
    where it grows as the arc length, 4 times where it is there at once behind a straight piece."""
    trajectory = (SMOOTH | BEGINNING)[name]
    assert distances(trajectory, place(trajectory, Tolerance(tolerance))).max() <= tolerance


@pytest.mark.parametrize("tolerance", [1e-2, 1e-4, 1e-6])
@pytest.mark.parametrize("name", SMOOTH)
def test_the_number_of_chords_is_within_five_percent_of_theory(name, tolerance):
    """Each piece between corners has a step begun, so with corners there may be one more for each."""
    trajectory = SMOOTH[name]
    chords, corners = len(place(trajectory, Tolerance(tolerance)).onward), len(trajectory.corners())
    theory = fewest_chords(trajectory, tolerance)
    assert 0.99 * theory <= chords <= 1.05 * theory + corners + bool(corners)


@pytest.mark.parametrize("trajectory", [*SMOOTH.values(), Helix(0.01, 0.0, 0.9)])
def test_no_step_turns_by_more_than_sixty_degrees(trajectory):
    stations = place(trajectory, Tolerance(1e6))
    assert len(stations.onward) >= 1 and turns(stations).max() < 61


@pytest.mark.parametrize("trajectory", [KNOT, ELLIPSE, Helix(), Line(), S_CURVE])
@pytest.mark.parametrize("contours", [3, 4, 57, 1000])
def test_a_smooth_trajectory_has_as_many_contours_as_asked_for_evenly_spaced(trajectory, contours):
    stations = place(trajectory, Count(contours))
    steps = np.diff(np.append(stations.s, stations.total) if stations.closed else stations.s)
    assert len(stations.u) == contours
    assert np.abs(steps / steps.mean() - 1).max() < 1e-10


def test_corners_are_among_a_number_of_contours():
    corners = np.random.default_rng(4).normal(size=(7, 3))
    for contours in (2, 7, 8, 9, 10, 64, 1000):
        stations = place(Polyline(corners), Count(contours))
        assert len(stations.u) == max(contours, 7)
        assert np.abs(stations.points[:, None] - corners).max(axis=2).min(axis=0).max() < 1e-15


def test_a_closed_tube_has_three_contours_or_more():
    lens = [(0, 0, 0), (0.3, 0.01, 0), (0.6, 0.01, 0), (1, 0, 0), (0.6, -0.01, 0), (0.3, -0.01, 0)]
    assert len(place(KNOT, Count(2)).u) == 3
    assert len(place(Bezier(lens, closed=True), Tolerance(1.0)).u) >= 3


@pytest.mark.parametrize("tolerance", [1e-6, 1e-2, 1.0])
def test_straight_legs_are_one_step(tolerance):
    corners = np.random.default_rng(2).normal(size=(50, 3))
    assert len(place(Line(), Tolerance(tolerance)).u) == 2
    for closed in (False, True):
        stations = place(Polyline(corners, closed), Tolerance(tolerance))
        assert np.abs(stations.points - corners).max() < 1e-15
    mixed = Bezier([(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0), (3, 1, 0), (4, 2, 0), (5, 2, 0)])
    stations = place(mixed, Tolerance(tolerance))
    assert (stations.points[:, 0] > 1e-9).sum() == (stations.points[:, 0] > 3 - 1e-9).sum()


@pytest.mark.parametrize("samples", [Tolerance(), Count(5)])
def test_there_is_a_contour_at_every_mark(samples):
    marks = [0.1, 1.0, 1.0 + 1e-12, 7.7]
    stations = place(Helix(), samples, marks)
    assert [np.abs(stations.s - mark).min() < 1e-11 for mark in marks] == [True] * 4
    assert (np.diff(stations.s) > 1e-9 * stations.total).all()


@pytest.mark.parametrize("samples", [Tolerance(0.1), Count(6)])
def test_a_taper_begins_at_a_contour(samples):
    mesh = GeneralizedCylinder(Circle(0.1), Line(), samples, start=Taper(0.125), end=Taper(0.3)).mesh()
    away = np.hypot(*mesh.vertices[:, :2].T)
    for height in (0.125, 0.7):
        rim = np.abs(mesh.vertices[:, 2] - height) < 1e-12
        assert rim.sum() == 64 and np.abs(away[rim] - 0.1).max() < 1e-15


@pytest.mark.parametrize("tolerance", [1e-3, 1e-4, 1e-5])
@pytest.mark.parametrize("twist", ["3*2*pi*t", "20*t^2", "4*sin(2*pi*t)"])
def test_a_twisted_edge_keeps_within_the_tolerance(twist, tolerance):
    """A point at radius r turned by an angle a from contour to contour leaves the chord by r (1 - cos a/2) at most."""
    shape = GeneralizedCylinder(Circle(0.5, points=3), Line(), Tolerance(tolerance), twist=twist)
    column = shape.mesh().vertices.reshape(3, -1, 3)[0]
    angle = np.diff(np.unwrap(np.arctan2(column[:, 1], column[:, 0])))
    assert 0.5 * (1 - np.cos(angle / 2)).max() <= tolerance
    assert np.abs(angle).max() < np.radians(30.5)


@pytest.mark.parametrize("tolerance", [1e-3, 1e-4, 1e-5])
def test_a_profile_keeps_within_the_tolerance(tolerance):
    shape = GeneralizedCylinder(
        Circle(1.0, points=3), Line(), Tolerance(tolerance), scale_x="2+sin(6*t)", scale_y="2+sin(6*t)"
    )
    column = shape.mesh().vertices.reshape(3, -1, 3)[0]
    z = np.linspace(0, 1, 100_001)
    radius = np.interp(z, column[:, 2], np.hypot(column[:, 0], column[:, 1]))
    assert np.abs(radius - 2 - np.sin(6 * z)).max() <= tolerance
    assert len(column) < 2 * 1.05 * 6 / sqrt(8 * tolerance)


def test_ten_thousand_points_and_ten_thousand_turns_are_placed():
    corners = np.random.default_rng(6).normal(size=(10_000, 3)).cumsum(axis=0)
    assert np.abs(place(Polyline(corners), Tolerance()).points - corners).max() < 1e-12 * np.abs(corners).max()
    turned = place(Helix(turns=10_000.0), Tolerance(0.1))
    assert turns(turned).max() < 61 and turned.points[-1, 2] == pytest.approx(5000, rel=1e-15)


def test_parameters_and_points_of_the_stations_belong_together():
    for trajectory in (KNOT, CHAIN, ELLIPSE):
        stations = place(trajectory, Tolerance(0.01))
        assert np.abs(trajectory.evaluate(stations.u) - stations.points).max() < 1e-15
        assert np.abs(arc_length(trajectory).at(stations.u) - stations.s).max() < 1e-13 * stations.total
        assert stations.t[0] == 0 and (np.diff(stations.t) > 0).all()
        assert (stations.t[-1] == 1) == (not trajectory.closed)


@pytest.mark.parametrize(
    "waves",
    [3, 100, 1000, 1024, 2048, 2049, *(pytest.param(many, marks=pytest.mark.thorough) for many in (6144, 7001))],
)
def test_a_law_that_changes_often_is_followed_as_one_that_changes_rarely(waves):
    """A ripple of any number of waves takes as many contours for each, and its chords keep the tolerance."""
    length, chord = 0.01 * waves, 1e-5
    ripple = f"1 + 0.1*sin(2*pi*{waves}*t)"
    path = Line(end=(0, 0, length))
    mesh = GeneralizedCylinder(Circle(0.01, points=3), path, Tolerance(chord), scale_x=ripple, scale_y=ripple).mesh()
    x, y, z = mesh.vertices[: mesh.rings].T
    middle, radius = (z[1:] + z[:-1]) / 2, np.hypot(x, y)
    off = (radius[1:] + radius[:-1]) / 2 - 0.01 * (1 + 0.1 * np.sin(2 * np.pi * middle / 0.01))
    assert np.abs(off).max() < 1.05 * chord
    assert mesh.rings / waves == pytest.approx(26, rel=0.2)
