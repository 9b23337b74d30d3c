# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A smooth path known by points is the curve they were taken from, and stays near them where they are rough."""

import json
from pathlib import Path

import numpy as np
import pytest

from sweep_addon.core.contours import Circle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.canal_surface import CanalSurface
from sweep_addon.core.shapes.general_sweep import GeneralSweep
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
from sweep_addon.core.stations.frames import rotation_minimizing
from sweep_addon.core.stations.rotations import rotated, signed_angle, wrapped
from sweep_addon.core.stations.sampling import Tolerance, place, stations
from sweep_addon.core.stations.transport import transport
from sweep_addon.core.trajectories import Arc, Formula, Helix, Sampled, TorusKnot
from sweep_addon.core.trajectories.arc_length import arc_length

LINES = json.loads((Path(__file__).parents[1] / "data" / "centrelines.json").read_text())["lines"]
KNOT = TorusKnot(2, 3, 2.0, 0.8)


def taken(trajectory, samples, uneven=0.0):
    """Parameters and a path through the points there."""
    x = np.linspace(0, 1, samples + trajectory.closed)[:samples]
    u = trajectory.domain[1] * (x + uneven * np.sin(2 * np.pi * x) / (2 * np.pi))
    return u, Sampled(trajectory.evaluate(u), trajectory.closed)


@pytest.mark.parametrize(
    ("trajectory", "samples", "degrees"),
    [(Helix(), 101, 1e-4), (Helix(), 401, 1e-8), (KNOT, 101, 1e-4), (KNOT, 401, 1e-8)],
)
def test_normals_turn_as_those_of_the_curve(trajectory, samples, degrees):
    """The angle about the tangent between the normals of both; the figures asked for are 1e-4 at 101 and 401."""
    u, path = taken(trajectory, samples)
    placed = stations(trajectory, arc_length(trajectory).at(u))
    expected, _ = rotation_minimizing(placed)
    tangents = path.tangents(np.arange(samples))
    reference, angle = transport(path).at(np.arange(samples), tangents)
    turn = signed_angle(expected, rotated(reference, tangents, angle), placed.leave)
    assert np.degrees(np.abs(wrapped(turn - turn[0])).max()) < degrees


@pytest.mark.parametrize("uneven", [0.0, 0.5])
@pytest.mark.parametrize("trajectory", [Helix(), Helix(1.0, 2.0, 1.5), KNOT, Arc(angle=2 * np.pi), Arc(angle=3.0)])
def test_tangents_and_curvature_are_those_of_the_curve(trajectory, uneven):
    """Of sixth order inside, so that twice the points leave a 64th of the error, and a 32th beside open ends."""

    def errors(samples):
        u, path = taken(trajectory, samples, uneven)
        middle = (u[1:] + u[:-1]) / 2
        there = arc_length(trajectory).at(middle) / trajectory.length()
        s = arc_length(path).parameter(there * path.length())
        return (
            np.abs(path.tangents(np.arange(samples)) - trajectory.tangents(u)).max(),
            np.abs(path.tangents(s) - trajectory.tangents(middle)).max(),
        )

    coarse, fine = errors(200), errors(400)
    assert max(fine) < 1e-4
    assert all(f < c / 20 or f < 1e-12 for c, f in zip(coarse, fine, strict=True))


@pytest.mark.parametrize("name", [line["name"] for line in LINES])
def test_a_real_path_is_passed_through_and_never_left_far(name):
    """Of a path with noise and gaps no piece is a third longer than its chord, or farther from it than a fifth."""
    points = np.array(next(line["points"] for line in LINES if line["name"] == name))
    path = Sampled(points)
    assert np.abs(path.evaluate(np.arange(len(points))) - points).max() < 1e-9
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert (np.diff(arc_length(path).at(np.arange(len(points)))) / chords).max() < 1.33
    inner = np.linspace(0, 1, 33)
    pieces = path.evaluate((np.arange(len(chords))[:, None] + inner).ravel()).reshape(len(chords), -1, 3)
    straight = (1 - inner)[:, None] * points[:-1, None] + inner[:, None] * points[1:, None]
    across = np.diff(points, axis=0)[:, None] / chords[:, None, None]
    away = pieces - straight
    away -= np.einsum("kij,kij->ki", away, across + 0 * away)[..., None] * across
    assert (np.linalg.norm(away, axis=2).max(axis=1) / chords).max() < 0.2


@pytest.mark.parametrize("closed", [False, True])
def test_curvature_does_not_jump(closed):
    path = Sampled(np.random.default_rng(4).normal(size=(20, 3)), closed)
    stepped = path.joints()[1:-1]
    before, after = ([path.derivative(stepped, n, side) for n in (1, 2)] for side in (True, False))

    def curvature(first, second):
        return np.cross(first, second) / np.linalg.norm(first, axis=1)[:, None] ** 3

    assert np.abs(curvature(*before) - curvature(*after)).max() < 1e-9 * np.abs(curvature(*after)).max()
    assert not len(path.corners())


HELIX = {"x": "0.8*cos(0.3*u)", "y": "0.8*sin(0.3*u)", "z": "0.04*u", "end": 24.0}
ROUNDED = Sampled(Formula(**HELIX).evaluate(np.arange(25)).round(5))
HOSE = "0.04 + 0.025*sin(0.7*u)"


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("points", [ROUNDED.points.values, np.random.default_rng(4).normal(size=(20, 3)) ** 3])
def test_the_speed_does_not_jump(points, closed):
    """However unlike the distances of the points are: on both sides of each, u counts them equally fast."""
    path = Sampled(points, closed)
    between = path.joints()[1:-1]
    before, after = (path.derivative(between, 1, side) for side in (True, False))
    assert np.abs(after - before).max() < 1e-12 * np.abs(after).max()


def test_derivatives_are_those_of_the_path():
    """Differences of the sixth order over an eighth of a step, of points that lie very unevenly."""
    path = Sampled(np.random.default_rng(4).normal(size=(20, 3)) ** 3)
    u, step = np.linspace(0, 19, 20)[:-1] + 0.5, 1 / 64
    for order in (1, 2, 3):
        stencil = [
            (path.derivative(u + k * step, order - 1) if order > 1 else path.evaluate(u + k * step))
            for k in (-3, -2, -1, 1, 2, 3)
        ]
        expected = np.einsum("k,kij->ij", np.array([-1, 9, -45, 45, -9, 1]) / 60 / step, stencil)
        assert np.abs(path.derivative(u, order) - expected).max() < 1e-6 * np.abs(expected).max()
    for found, expected in zip(
        path.moving(u), (path.evaluate(u), path.derivative(u), path.derivative(u, 2)), strict=True
    ):
        assert np.abs(found - expected).max() < 1e-12 * np.abs(expected).max()


def test_a_radius_of_u_over_rounded_points_makes_the_smooth_hose():
    """Balls of that radius on the helix itself touch each vertex, but for the rounding: 5e-6 in each coordinate."""
    hose = CanalSurface(ROUNDED, HOSE, points=16)
    mesh = hose.mesh()
    assert mesh.told == () and len(hose.self_intersections()) == 0
    u = np.linspace(0, 24, 24 * 400 + 1)
    middles, radii = Formula(**HELIX).evaluate(u), 0.04 + 0.025 * np.sin(0.7 * u)
    outside = [(np.linalg.norm(vertex - middles, axis=1) - radii).min() for vertex in mesh.vertices]
    assert np.abs(outside).max() < 2 * np.sqrt(3) * 5e-6


def test_a_radius_of_u_does_not_fold_where_points_lie_unevenly():
    """One step is twice the next: where u ran evenly in each, the radius would grow at once twice as fast."""
    u = np.arange(25) + 0.33 * (np.arange(25) % 2)
    hose = CanalSurface(Sampled(Formula(**HELIX).evaluate(u)), HOSE)
    assert hose.mesh().told == () and len(hose.self_intersections()) == 0


def test_repeated_points_count_once():
    points = np.random.default_rng(1).normal(size=(9, 3))
    again = np.repeat(points, [1, 2, 1, 1, 3, 1, 1, 1, 2], axis=0)
    u = np.linspace(0, 8, 101)
    assert np.abs(Sampled(again).evaluate(u) - Sampled(points).evaluate(u)).max() == 0
    round_trip = np.concatenate((points, points[:1]))
    assert np.abs(Sampled(round_trip, closed=True).evaluate(u) - Sampled(points, closed=True).evaluate(u)).max() < 1e-14


TWICE = Sampled([(0, 0, 0), (9, 0, 0), (9, 0, 0), (9, 9, 0)])
AND_BACK = Sampled([(0, 0, 0), (0, 0, 0), (9, 0, 0), (9, 9, 0), (0, 0, 0)], closed=True)


def test_points_that_do_not_count_are_told():
    assert Sampled([(0, 0, 0), (9, 0, 0), (9, 9, 0)]).told == ()
    assert TWICE.told == ("Trajectory: 1 of its 4 points repeats a neighbour and does not count.",)
    assert AND_BACK.told == ("Trajectory: 2 of its 5 points repeat a neighbour and do not count.",)


@pytest.mark.parametrize("shape", [GeneralizedCylinder, CanalSurface, PDCurveSweep, GeneralSweep])
def test_every_shape_along_such_points_tells_of_them(shape):
    generator = {"generator": Circle(0.1)} if shape is GeneralSweep else {}
    assert TWICE.told[0] in shape(trajectory=TWICE, **generator).mesh().told


def test_the_way_back_begins_with_a_hairpin():
    """There and back along a line: the path stays smooth, a tube follows it, and it is little longer."""
    there = np.stack((np.arange(6.0), np.zeros(6), np.zeros(6)), axis=1)
    path = Sampled(np.concatenate((there, there[-2::-1])))
    assert not len(path.corners())
    assert 10 < path.length() < 10.5
    assert np.abs(path.evaluate(np.arange(11)) - path.points.values).max() < 1e-14
    mesh = GeneralizedCylinder({"kind": "circle", "radius": 0.01, "points": 8}, path).mesh()
    assert len(mesh.boundary_edges()) == 0


@pytest.mark.parametrize("count", [2, 3, 4, 5, 6, 7, 8])
def test_few_points_are_enough(count):
    """Two make a straight line; the points of a line of any number do too."""
    points = np.outer(np.cumsum(np.arange(1.0, count + 1)), (1, 2, 2))
    path = Sampled(points)
    assert abs(path.length() - np.linalg.norm(points[-1] - points[0])) < 1e-12
    assert len(place(path, Tolerance()).u) == 2
    if count > 2:
        bent = Sampled(np.column_stack((points[:, 0], points[:, 0] ** 2, 0 * points[:, 0])), closed=True)
        assert bent.length() > 0 and not len(bent.corners())


@pytest.mark.parametrize(
    ("points", "closed", "sentence"),
    [
        ([(0, 0, 0)], False, "points: must have at least 2 different points, got 1"),
        ([(0, 0, 0)] * 5, False, "points: must have at least 2 different points, got 1"),
        ([(0, 0, 0), (1, 0, 0), (0, 0, 0)], True, "points: must have at least 3 different points, got 2"),
        ([], False, "points: must be a list of 3 numbers each, got []"),
        ([(0, 0, 0), (0, 0, np.nan)], False, "points: must have finite numbers up to 1e+12 in size, got nan in row 2"),
    ],
)
def test_what_is_no_path_is_refused(points, closed, sentence):
    with pytest.raises(ShapeError) as refusal:
        Sampled(points, closed)
    assert str(refusal.value) == sentence


def test_the_derivative_of_order_0_is_the_place_and_beyond_3_there_is_none():
    path = Sampled([(0, 0, 0), (1, 0, 0), (2, 1, 0), (4, 1, 1)])
    u = np.linspace(*path.domain, 7)
    assert np.array_equal(path.derivative(u, 0), path.evaluate(u))
    with pytest.raises(ShapeError, match="order: must be at most 3, got 4"):
        path.derivative(u, 4)
