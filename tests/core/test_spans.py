# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spans: polynomials that are the axis and its frame to rounding, or say that they are not."""

import numpy as np
import pytest

from sweep_addon.core.grids.drawn import affine
from sweep_addon.core.rings.corners import Round
from sweep_addon.core.stations.bending import Bending
from sweep_addon.core.stations.directions import Arrows, Cubic, Tilt
from sweep_addon.core.stations.spans import FEW, MOST_SPANS, Fan, spans
from sweep_addon.core.trajectories import Arc, Bezier, Helix, Line, Polyline, Sampled

LEVEL = Arrows([(0, 0, 0, 1)])
TURNING = Arrows([(0, 0.2, 0.1, 1), (0.3, -0.2, 0.3, 1), (0.7, 0.1, -0.3, 1), (1, 0.3, 0.2, 1)])
WALK = np.cumsum(np.random.default_rng(3).uniform((0.3, -0.4, -0.4), (1, 0.4, 0.4), (1000, 3)), axis=0)
KINDS = {
    "a line": (Line(end=(0, 0, 4)), Arrows()),
    "a cubic far away": (Bezier(np.array([(0, 0, 0), (1, 1, 0), (2, 0, 0), (3, 1, 1)]) + 1000.0), LEVEL),
    "a start without speed": (Bezier([(0, 0, 0), (0, 0, 0), (1, 1, 0), (1, 2, 1)]), Tilt()),
    "arcs and lines": (Polyline([(0, 0, 0), (3, 0, 0), (3, 3, 0), (0, 3, 1)], corner=Round(0.3)), LEVEL),
    "arrows, whose turn has joints": (Arc(2.0, 3.0), TURNING),
    "a direction nearly along the line": (
        Line(end=(0, 0, 4)),
        Cubic([(1, 0, -1), (1, 1e-4, -1), (-1, 0, 3), (-1, 0, 3)]),
    ),
    "a hundred turns": (Helix(1.0, 0.3, 100), LEVEL),
    "a few samples": (Sampled(WALK[:12]), Tilt()),
    "more joints than spans": (Sampled(WALK), Tilt()),
}


def bending(kind, mirrored=False):
    trajectory, direction = KINDS[kind]
    return Bending(trajectory, direction, trajectory.length(), mirrored)


def test_lines_round_a_circle_are_where_its_equation_puts_them():
    """With d along the circle's axis e2 lies along it and e3 away from it; beyond both ends it goes on straight."""
    rng = np.random.default_rng(1)
    points, z = rng.uniform(-0.5, 0.5, (20, 2)), np.sort(rng.uniform(-1, 2 * np.pi + 1, (20, 300)), axis=1)
    found = spans(Bending(Arc(2.0, np.pi), LEVEL, 2 * np.pi)).lines(affine(points), z)
    (x, y), s = points.T[..., None], np.clip(z, 0, 2 * np.pi)
    beyond = z - s
    expected = np.stack(
        ((2 + y) * np.cos(s / 2) - beyond * np.sin(s / 2), (2 + y) * np.sin(s / 2) + beyond * np.cos(s / 2), x + 0 * z),
        axis=-1,
    )
    assert np.abs(found[:, :3].swapaxes(1, 2) - expected).max() < 1e-13
    assert np.abs(found[:, 3] - s / 2).max() < 1e-13


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("kind", KINDS)
def test_lines_are_where_a_frame_for_each_place_puts_them(kind, mirrored):
    """In clusters as at a plane, and all over: then there may be more spans than are looked at one by one."""
    axis, rng = bending(kind, mirrored), np.random.default_rng(2)
    pieces = spans(axis)
    points = rng.uniform(-0.5, 0.5, (8, 2))
    for low, high in ((-0.01, 0.01), (0.31, 0.33), (0.99, 1.01), (-0.1, 1.1)):
        z = axis.total * rng.uniform(low, high, (8, 60))
        expected = axis.bend(np.column_stack((np.repeat(points, 60, axis=0), z.ravel()))).reshape(8, 60, 3)
        size = max(np.abs(expected).max(), axis.total)
        assert np.abs(pieces.lines(affine(points), z)[:, :3].swapaxes(1, 2) - expected).max() < 2e-12 * size
        line = pieces.line(points, z[:, 0])
        assert np.abs(line(z[:, 0]) - expected[:, 0]).max() < 2e-12 * size


@pytest.mark.parametrize("kind", KINDS)
def test_lines_of_a_fan_are_where_a_frame_for_each_place_puts_them(kind):
    """From the ends, from amid a span, and with a base of its own for each line."""
    axis, rng = bending(kind), np.random.default_rng(4)
    points, pieces = rng.uniform(-0.5, 0.5, (8, 2)), spans(axis)
    apart = 0.5 * axis.total + rng.uniform(-0.01, 0.01, 8)
    for base, most in ((0.02, 0.05), (0.98, 0.05), (0.4, 0.01), (0.4, 0.5), (apart / axis.total, 0.1)):
        fan = Fan(np.asarray(base) * axis.total, rng.uniform(-most, most, 8) * axis.total, np.linspace(1, 0.1, 30))
        expected = axis.bend(np.column_stack((np.repeat(points, 30, axis=0), fan.heights.ravel()))).reshape(8, 30, 3)
        size = max(np.abs(expected).max(), axis.total)
        found = pieces.lines(affine(points), fan.heights, fan)[:, :3].swapaxes(1, 2)
        assert np.abs(found - expected).max() < 2e-12 * size


def test_there_are_few_spans_and_those_that_are_inexact_say_so():
    found = {kind: spans(bending(kind)) for kind in KINDS}
    assert max(len(pieces.ends) for pieces in found.values()) <= MOST_SPANS + 1
    assert not found["more joints than spans"].exact[1:-1].any()
    for kind in ("a line", "a cubic far away", "arcs and lines"):
        assert found[kind].exact.all() and len(found[kind].ends) <= FEW
