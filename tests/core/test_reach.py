# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reach against closed forms, and against its definition by a grid of all pairs of points."""

import numpy as np
import pytest

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.envelopes.reach import reach
from sweep_addon.core.trajectories import Arc, Formula, Helix, Line, Polyline, TorusKnot


def by_definition(trajectory, count=240, closest=12, finer=15, zooms=6):
    """The least |y - x|^2 / (2 dist(y - x, tangent at x)): of a grid of all pairs, then of finer ones about the least.

    Source: Federer, Curvature measures, Trans. Amer. Math. Soc. 93, 1959, Theorem 4.18.
    """
    first, last = trajectory.domain
    step = (last - first) / count
    x = y = first + step * np.arange(count)
    least = quotient(trajectory, x[:, None], y[None])
    rows = np.argsort(least.min(axis=1))[:closest]
    x, y = x[rows], y[least.argmin(axis=1)[rows]]
    for _ in range(zooms):
        window = step * np.linspace(-1.5, 1.5, finer)
        xs, ys = x[:, None, None] + window[:, None], y[:, None, None] + window
        least = quotient(trajectory, xs + 0 * ys, ys + 0 * xs).reshape(len(x), -1)
        i, j = np.unravel_index(least.argmin(axis=1), (finer, finer))
        x, y, step = x + window[i], y + window[j], 3 * step / finer
    return float(least.min())


def quotient(trajectory, x, y):
    """Of pairs of parameters that broadcast; infinite where two are too near for their distance to say anything."""
    shape = np.broadcast_shapes(x.shape, y.shape)
    at_x, at_y, tangent = (f(u.ravel()).reshape(*u.shape, 3) for f, u in
                           ((trajectory.evaluate, x), (trajectory.evaluate, y), (trajectory.tangents, x)))  # fmt: skip
    chord = np.broadcast_to(at_y - at_x, (*shape, 3))
    aside = np.linalg.norm(np.cross(chord, np.broadcast_to(tangent, chord.shape)), axis=-1)
    squared = (chord**2).sum(axis=-1)
    told = (aside > 1e-3 * np.sqrt(squared)) & (squared > 1e-10)
    return np.where(told, squared / np.where(told, 2 * aside, 1.0), np.inf)


def helix_reach(pitch):
    """Of a helix of radius 1: half the least distance of two points a turn or so apart, square to it; by bisection.

    From the point at angle 0 the square of the distance is 2 - 2 cos u + (h u)^2, h the pitch by 2 pi, and grows from
    where sin u + h^2 u = 0.
    """
    h = pitch / (2 * np.pi)
    low, high = 1.5 * np.pi, 2 * np.pi
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if np.sin(middle) + h**2 * middle < 0 else (low, middle)
    return np.sqrt(2 - 2 * np.cos(low) + (h * low) ** 2) / 2


CLOSED_FORMS = {
    "knot whose two strands are opposite": (TorusKnot(2, 3, major=2.0, minor=0.8), 0.8),
    "circle": (Arc(radius=2.0, angle=2 * np.pi), 2.0),
    "arc": (Arc(radius=2.0, angle=1.0), 2.0),
    "parabola": (Formula("u", "4*u^2", "0", start=-1.0, end=1.0), 1 / 8),
    "ellipse": (Formula("3*cos(u)", "sin(u)", "0", start=0.0, end=2 * np.pi), 1 / 3),
    "flat helix": (Helix(radius=1.0, pitch=0.5, turns=3.0), helix_reach(0.5)),
    "flatter helix": (Helix(radius=1.0, pitch=0.25, turns=8.0), helix_reach(0.25)),
    "steep helix": (Helix(radius=1.0, pitch=20.0, turns=3.0), 1 + (10 / np.pi) ** 2),
}


@pytest.mark.parametrize("name", CLOSED_FORMS)
def test_reach_is_the_closed_form(name):
    trajectory, expected = CLOSED_FORMS[name]
    assert reach(trajectory).radius == pytest.approx(expected, rel=1e-9)


def test_a_curve_that_crosses_itself_has_none_and_says_where():
    eight = Formula("sin(u)", "sin(u)*cos(u)", "0", start=0.3, end=0.3 + 2 * np.pi)
    found = reach(eight)
    assert found.radius == 0 and found.parameters == pytest.approx((np.pi, 2 * np.pi), abs=1e-9)


@pytest.mark.parametrize("straight", [Line(end=(0, 0, 3)), Polyline([(0, 0, 0), (0, 0, 1), (0, 0, 3)])])
def test_a_straight_line_may_be_as_thick_as_one_likes(straight):
    assert reach(straight).radius == np.inf and reach(straight).parameters == ()


def test_a_corner_is_refused():
    with pytest.raises(ShapeError, match=r"^trajectory: must be smooth, or it has no reach, got a corner at u = 1$"):
        reach(Polyline([(0, 0, 0), (0, 0, 1), (0, 1, 1)]))


def test_the_parameters_are_where_the_two_points_are():
    knot = TorusKnot(3, 2, major=2.0, minor=0.8)
    found = reach(knot)
    a, b = knot.evaluate(np.array(found.parameters))
    tangents = knot.tangents(np.array(found.parameters))
    assert np.linalg.norm(a - b) == pytest.approx(2 * found.radius, rel=1e-12)
    assert np.abs(tangents @ (a - b)).max() < 1e-7 * np.linalg.norm(a - b)


def random_curve(seed, terms=4):
    random = np.random.default_rng(seed)
    amplitude, phase = random.normal(size=(3, terms)) / np.arange(1, terms + 1), random.uniform(0, 6.28, (3, terms))
    texts = [
        " + ".join(f"({a:.6f})*sin({k}*u + {p:.6f})" for k, (a, p) in enumerate(zip(*row, strict=True), 1))
        for row in zip(amplitude, phase, strict=True)
    ]
    return Formula(*texts, start=0.0, end=2 * np.pi)


@pytest.mark.thorough
def test_reach_of_random_curves_is_that_of_the_definition(draws):
    for seed in range(draws // 5):
        curve = random_curve(seed)
        found, grid = reach(curve).radius, by_definition(curve)
        assert curve.closed and found <= grid * (1 + 1e-7), seed
        assert grid <= 1.001 * found, seed  # pairs of a grid only come near the nearest
