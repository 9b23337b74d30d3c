# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that formulas deform as they move, against what is known of what they visit, and against many poses."""

from math import pi

import numpy as np
import pytest
from conftest import FULL

import sweep_addon as sw

ALONG_X, UP = sw.trajectories.Line(end=(1, 0, 0)), sw.trajectories.Line(end=(0, 0, 2))
TOLERANCES = [None, 1e-6, 1e-3]
THOUSANDS = 3_000 if FULL else 1_000


def box(points, low, high):
    return np.maximum(np.array(low) - points, points - np.array(high)).max(axis=1)


@pytest.mark.parametrize("tolerance", TOLERANCES)
def test_a_sheared_block_moves_as_a_parallelepiped(tolerance):
    """Sheared by x + 0.6 z, and moved along x: unsheared it is a longer block."""
    sweep = sw.GeneralSweep(sw.solids.Block(0.5, 0.4, 0.6), ALONG_X, deform_x="x + 0.6*z")
    points = np.random.default_rng(1).uniform((-0.7, -0.4, -0.5), (1.7, 0.4, 0.5), (5_000, 3))
    own = points - points[:, 2:] * (0.6, 0, 0)
    far = box(own, (-0.25, -0.2, -0.3), (1.25, 0.2, 0.3))
    clear = np.abs(far) > 3 * (tolerance or 1e-8)
    assert (sw.classify(sweep, points, tolerance) == np.sign(-far))[clear].all()


@pytest.mark.thorough
@pytest.mark.parametrize("tolerance", [1e-6, 1e-3])
def test_beside_a_sheared_face_points_are_on_within_the_tolerance(tolerance):
    """The distance counts as it is in the world, not in the solid before it is sheared: half of that, here."""
    off = np.tile([-1.6, -0.4, 0.4, 1.6], 25) * tolerance
    random = np.random.default_rng(2)
    z, y = random.uniform(0.2, 0.8, 100), random.uniform(-0.15, 0.15, 100)
    moved_across = sw.trajectories.Line(end=(0, 1, 0))
    sheared = sw.GeneralSweep(sw.solids.Block(0.5, 0.4, 0.6), moved_across, deform_x="x + sqrt(3)*z")
    points = np.stack((0.25 + np.sqrt(3) * (z - 0.5) * 0.5, y + 0.5, 0.5 * (z - 0.5)), axis=1)
    points += off[:, None] * np.array((0.5, 0, -np.sqrt(3) / 2))
    assert (sw.classify(sheared, points, tolerance) == np.tile([1, 0, 0, -1], 25)).all()


@pytest.mark.thorough
@pytest.mark.parametrize("tolerance", TOLERANCES)
def test_a_twisted_bar_moved_across_is_at_each_height_a_turned_rectangle_moved(tolerance):
    """At the height z the bar is turned by 2 z: a point is visited if the way back from it meets the rectangle."""
    twist = {"deform_x": "x*cos(2*z) - y*sin(2*z)", "deform_y": "x*sin(2*z) + y*cos(2*z)"}
    sweep = sw.GeneralSweep(sw.solids.Block(0.6, 0.2, 2.0), ALONG_X, **twist)
    points = np.random.default_rng(3).uniform((-0.5, -0.5, -1.2), (1.5, 0.5, 1.2), (THOUSANDS, 3))
    c, s = np.cos(2 * points[:, 2]), np.sin(2 * points[:, 2])
    start = np.stack((points[:, 0] * c + points[:, 1] * s, points[:, 1] * c - points[:, 0] * s), axis=1)
    way = -np.stack((c, -s), axis=1)
    enter, leave = np.zeros(len(points)), np.ones(len(points))
    for axis, half in enumerate((0.3, 0.1)):
        times = np.sort((np.array([[-half], [half]]) - start[:, axis]) / way[:, axis], axis=0)
        enter, leave = np.maximum(enter, times[0]), np.minimum(leave, times[1])
    visited = (leave > enter) & (np.abs(points[:, 2]) < 1)
    clear = (np.abs(leave - enter) > 0.03) & (np.abs(np.abs(points[:, 2]) - 1) > 4e-3)
    assert (sw.classify(sweep, points, tolerance) == np.where(visited, 1, -1))[clear].all()


def test_a_ball_that_is_bent_stays_round_across():
    """Moved aside by x + 0.3 sin z the slices of a ball stay discs."""
    sweep = sw.GeneralSweep(sw.solids.Ball(0.5), sw.trajectories.Line(end=(0, 1, 0)), deform_x="x + 0.3*sin(4*z)")
    points = np.random.default_rng(4).uniform((-1, -0.7, -0.6), (1, 1.7, 0.6), (4_000, 3))
    x, y, z = points.T
    squares = 0.25 - z**2 - (x - 0.3 * np.sin(4 * z)) ** 2
    inside = (squares > 0) & (np.abs(y - 0.5) < 0.5 + np.sqrt(np.maximum(squares, 0)))
    nearest = np.abs(y - np.clip(y, 0, 1))
    clear = np.abs(squares - nearest**2) > 1e-6
    assert (sw.classify(sweep, points) == np.where(inside, 1, -1))[clear].all()


@pytest.mark.thorough
def test_a_bar_that_is_bent_to_an_open_ring_keeps_its_gap():
    """Bent by 5.6 of a turn of 2 pi, and moved along the axis: both ends are near each other, and far in the bar."""
    turn, radius = 5.6, 0.6
    bend = {
        "deform_x": f"({radius} - y)*sin({turn / 2}*x)",
        "deform_y": f"{radius} - ({radius} - y)*cos({turn / 2}*x)",
    }
    ring = sw.GeneralSweep(sw.solids.Block(2.0, 0.3, 0.2), sw.trajectories.Line(), **bend)
    points = np.random.default_rng(7).uniform((-1, -0.4, -0.3), (1, 1.6, 1.3), (THOUSANDS, 3))
    few = THOUSANDS // 6
    points[:few] = points[:few] * (0.2, 0.2, 1) + (0, 1.2, 0)
    x, y, z = points[:, 0], points[:, 1] - radius, points[:, 2]
    r, angle = np.hypot(x, y), np.abs(np.arctan2(x, -y))
    far = np.maximum.reduce([np.abs(r - radius) - 0.15, np.abs(z - 0.5) - 0.6, (angle - turn / 2) * r])
    clear = np.abs(far) > 1e-7
    assert (sw.classify(ring, points) == np.sign(-far))[clear].all()
    assert (far[:few] > 0).sum() > few / 10


@pytest.mark.thorough
def test_a_block_may_be_pressed_flat_at_the_end():
    """Along x it becomes thinner: where it is thickest as it passes over a point, its rear end does so first."""
    flat = sw.GeneralSweep(sw.solids.Block(0.5, 0.4, 0.6), ALONG_X, deform_z="z*(1 - t)")
    points = np.random.default_rng(8).uniform((-0.4, -0.3, -0.4), (1.4, 0.3, 0.4), (2_000, 3))
    points[:300, 2] *= 0.01
    x, y, z = points.T
    half = 0.3 * (1 - np.clip(x - 0.25, 0, 1))
    far = np.maximum.reduce([np.abs(x - 0.5) - 0.75, np.abs(y) - 0.2, np.abs(z) - half])
    clear = np.abs(far) > 3e-8
    assert (sw.classify(flat, points) == np.sign(-far))[clear].all()


def back_by_newton(place, points):
    """The places of a solid that go to points (n, 3), by Newton's method from these."""
    found, step = points.copy(), 1e-7
    for _ in range(8):
        off = place(found) - points
        slopes = np.stack(
            [(place(found + step * axis) - place(found - step * axis)) / (2 * step) for axis in np.eye(3)], 2
        )
        found -= np.linalg.solve(slopes, off[..., None])[..., 0]
    return found


BRACKET = sw.solids.Bracket(0.5, 0.5, 0.12, 0.2)


def in_bracket(p):
    legs = box(p, (0, 0, -0.1), (0.5, 0.12, 0.1)), box(p, (0, 0, -0.1), (0.12, 0.5, 0.1))
    return np.minimum(*legs)


DEFORMED = {
    "the lecture's": (
        {"deform_x": "x + 0.12*sin(4*pi*t)", "deform_y": "y + 0.12*sin(6*pi*t)"},
        lambda p, t: p + np.array((0.12 * np.sin(4 * pi * t), 0.12 * np.sin(6 * pi * t), 0)),
    ),
    "waves that run through it": (
        {"deform_x": "x + 0.08*sin(6*y + 4*pi*t)", "deform_z": "z*(1 + t*x)"},
        lambda p, t: np.stack(
            (p[:, 0] + 0.08 * np.sin(6 * p[:, 1] + 4 * pi * t), p[:, 1], p[:, 2] * (1 + t * p[:, 0])), axis=1
        ),
    ),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", DEFORMED)
def test_a_deformed_bracket_is_where_many_poses_of_it_are(name):
    formulas, place = DEFORMED[name]
    points = np.random.default_rng(5).uniform((-0.2, -0.2, -0.2), (0.7, 0.7, 2.2), (THOUSANDS // 2, 3))
    least, count = np.full(len(points), np.inf), 401
    for t in np.linspace(0, 1, count):
        own = back_by_newton(lambda p, t=t: place(p, t), points - (0, 0, 2 * t))
        least = np.minimum(least, in_bracket(own))
    room = 5 / (count - 1)  # it moves by less than 5 for each t, and no length becomes more than twice as long or short
    for tolerance in (1e-5, 2e-3):
        labels = sw.classify(sw.GeneralSweep(BRACKET, UP, **formulas), points, tolerance)
        assert (labels[least < -3 * tolerance - room / 8] == 1).all()
        assert (labels[least > 3 * tolerance + room] == -1).all()
        assert np.count_nonzero(labels == 1) > len(points) / 10


@pytest.mark.thorough
def test_many_small_waves_in_time_are_followed():
    """A block that shakes 40 times on its way: between two shakes it is where it shakes to."""
    sweep = sw.GeneralSweep(sw.solids.Block(0.4, 0.2, 0.2), UP, deform_x="x + 0.3*sin(80*pi*t)")
    heights = (np.arange(10, 30) + 0.25) * 0.05  # where it is farthest out
    out = np.stack((0.499 + 0 * heights, 0 * heights, heights), axis=1)
    assert (sw.classify(sweep, out) == 1).all()
    assert (sw.classify(sweep, out + (0.0011, 0, 0)) == -1).all()


@pytest.mark.thorough
@pytest.mark.parametrize("waves", [2, 4, 8])
@pytest.mark.parametrize("half_swings", [0, 9, 41])
def test_waves_that_fit_the_box_are_followed(waves, half_swings):
    """A beam that swings in one, two or more waves: they are 0 at its ends, in its middle, and at even parts of it."""
    swing, count = f"*sin({half_swings}*pi*t)" if half_swings else "", THOUSANDS // 5
    beam, path = sw.solids.Block(0.2, 0.2, 2.0), sw.trajectories.Line(end=(0, 1, 0))
    sweep = sw.GeneralSweep(beam, path, deform_x=f"x + 0.3*sin({waves}*pi*z){swing}")
    random = np.random.default_rng(7)
    x, y, z = random.uniform((-0.095, -0.095, -0.98), (0.095, 0.095, 0.98), (count, 3)).T
    t = random.uniform(0, 1, count)
    swung = 0.3 * np.sin(waves * pi * z) * (np.sin(half_swings * pi * t) if half_swings else 1)
    assert (sw.classify(sweep, np.stack((x + swung, y + t, z), axis=1), 1e-4) == 1).all()


@pytest.mark.thorough
def test_a_deformed_sheet_is_what_it_passes_over():
    """A square that bows as it rises, by 0.3 x (1 - x): moved along z it is a block with bowed faces."""
    square = sw.solids.Triangles([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3)])
    sweep = sw.GeneralSweep(square, sw.trajectories.Line(), deform_z="z + 0.8*x*(1 - x)")
    points = np.random.default_rng(6).uniform(-0.2, 1.4, (THOUSANDS, 3))
    x, y, z = points.T
    far = np.maximum.reduce([np.abs(x - 0.5) - 0.5, np.abs(y - 0.5) - 0.5, np.abs(z - 0.8 * x * (1 - x) - 0.5) - 0.5])
    for tolerance in (None, 1e-3):
        clear = np.abs(far) > 2 * (tolerance or 1e-8)
        assert (sw.classify(sweep, points, tolerance) == np.sign(-far))[clear].all()
