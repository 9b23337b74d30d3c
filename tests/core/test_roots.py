# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where functions change their sign, of many at once, of which some take longer."""

import numpy as np
import pytest

from sweep_addon.core.contours import Rectangle
from sweep_addon.core.rings.limits import Plane
from sweep_addon.core.self_intersection.folds import roots
from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
from sweep_addon.core.trajectories import Line


def of_both(one, other):
    """What `roots` says of two functions between 0 and 1."""

    def both(places):
        return np.array([one(places[0]), other(places[1])])

    low, high = np.zeros(2), np.ones(2)
    return roots(both, low, high, both(low), both(high))


def jump(place):
    return np.copysign(1.0, place - 0.3)


@pytest.mark.parametrize(
    ("function", "root"),
    [
        (lambda x: x - 0.5, 0.5),
        (lambda x: 4 * x - 1, 0.25),
        (lambda x: -x, 0.0),
        (lambda x: x - 1, 1.0),
        (lambda x: np.exp(x) - 1.1, np.log(1.1)),
    ],
)
def test_a_root_that_is_found_early_is_not_left_while_others_are_looked_for(function, root):
    """A line is 0 after one step; a jump is halved on for the full count, and every fourth step halves them all."""
    found = of_both(function, jump)
    assert found[0] == pytest.approx(root, abs=1e-13)
    assert found[1] == pytest.approx(0.3, abs=1e-11)


def test_a_function_of_a_millionth_of_a_millionth_has_its_root_where_a_larger_one_has():
    found = of_both(lambda x: 1e-12 * (np.exp(x) - 1.1), lambda x: 1e-12 * (0.25 - x**2))
    assert found == pytest.approx([np.log(1.1), 0.5], abs=1e-12)


def test_a_flat_root_is_where_rounding_leaves_nothing_of_the_function():
    found = of_both(lambda x: (x - 0.3) ** 3, lambda x: (x - 0.7) ** 5)
    assert abs(found[0] - 0.3) ** 3 < 1e-13
    assert abs(found[1] - 0.7) ** 5 < 1e-13


@pytest.mark.parametrize("noise", [1e-12, 1e-9, 1e-6])
def test_a_root_of_a_function_that_is_never_quite_nothing_is_as_near_as_its_rounding(noise):
    """As heights above planes far from the origin: they end up on one side, and no bracket closes in."""

    def rough(place):
        height = np.expm1(place - 0.25)
        return height + noise if abs(height) < noise else height

    found = of_both(rough, lambda x: rough(2 * x - 0.5))
    assert found == pytest.approx([0.25, 0.375], abs=3 * noise)


def test_a_box_of_kilometres_between_two_planes_is_as_long_as_its_middle_line():
    """Cut obliquely, a prism holds its section times the length of the line through the section's centroid."""
    start, end = np.array((0.47, 0.83, 0.51)), np.array((-0.131, 0.078, -0.096))
    points = np.array((-0.9, -457.0, 1.5)), np.array((6.4, -208.0, 2221.0))
    box = PDCurveSweep(
        Rectangle(300, 200),
        Line(end=(0, 0, 3000)),
        start=Plane(tuple(points[0]), tuple(start)),
        end=Plane(tuple(points[1]), tuple(end)),
    )
    low, high = (point @ across / across[2] for point, across in zip(points, (start, end), strict=True))
    mesh = box.mesh()
    assert len(mesh.vertices) == 12  # no edge is halved to follow a cut that is straight
    assert mesh.volume() == pytest.approx(300 * 200 * (high - low), rel=1e-12)
