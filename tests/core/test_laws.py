# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws: what they are made from, what they are at samples, and what they refuse."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.declared.coercing import coerce
from sweep_addon.core.declared.parameters import Array, Parameter, ShapeError, inside, parameters
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.variation.laws import Constant, Formula, Law, Points

T = np.linspace(0, 1, 101)
SCALE = Parameter("scale_x", Law, Constant(1.0))


def evaluated(law, t=T):
    return law.evaluate(u=2 * t, t=t, s=3 * t)


@pytest.mark.parametrize(
    "given, law",
    [
        (0.5, Constant(0.5)),
        (2, Constant(2.0)),
        (np.float64(2), Constant(2.0)),
        ("1 - t", Formula("1 - t")),
        ([(0, 1), (1, 0)], Points([(0, 1), (1, 0)])),
        (np.eye(2)[::-1], Points([(0, 1), (1, 0)])),
        ("points", Points([(0, 1), (1, 1)])),
        ({"kind": "formula", "text": "t"}, Formula("t")),
        (Formula("t"), Formula("t")),
    ],
)
def test_numbers_texts_and_lists_are_laws(given, law):
    assert coerce(SCALE, given) == law


@pytest.mark.parametrize("text, expected", [("u", 2 * T), ("t^2", T**2), ("s - u - t", 0 * T), ("3", 0 * T + 3)])
def test_formulas_know_three_names(text, expected):
    assert evaluated(Formula(text)) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(
    "law, constant",
    [
        (Constant(3), True),
        (Formula("2*pi"), True),
        (Formula("t"), False),
        (Points([(0, 1), (1, 1)]), True),
        (Points([(0, 1), (1, 2)]), False),
    ],
)
def test_a_law_knows_whether_it_is_constant(law, constant):
    assert law.is_constant is constant
    assert (np.ptp(evaluated(law)) == 0) == constant


@pytest.mark.parametrize(
    "given, sentence",
    [
        ("1 - q", "must be an expression of u, t, s: 'q' at character 5 is no name (u, t, s, pi, tau, e are)"),
        ("9**9**9**9", "must be finite everywhere, got inf"),
        ([(0, 1), (0, 2)], "must have t rising from point to point, got [0.0, 0.0]"),
        ([(0, 1), (1, float("nan"))], "must have finite numbers up to 1e+12 in size, got nan in row 2"),
        ([(0, 1), (1, -1e308)], "must have finite numbers up to 1e+12 in size, got -1e+308 in row 2"),
        ([], "must be a number, a formula in text or a list of points [t, value], got []"),
        ([0, 1], "must be a number, a formula in text or a list of points [t, value], got [0, 1]"),
        (float("inf"), "must be a number, got inf"),
        (None, "must be one of constant, formula, points, got None"),
        ({"kind": "formula", "txt": "t"}, "txt: is no parameter of Formula, which has text: did you mean 'text'?"),
    ],
)
def test_what_is_no_law_is_refused_when_it_is_made(given, sentence):
    with pytest.raises(ShapeError) as refusal:
        coerce(SCALE, given)
    assert str(refusal.value).startswith(sentence)


@pytest.mark.parametrize(("key", "value"), [("scale_x", 1), ("twist", 0), ("offset_y", 0)])
def test_a_law_of_another_kind_starts_as_the_constant_that_is_the_default(key, value):
    """Whoever changes the kind in a list must not see the sweep jump."""
    law = next(p for p in parameters(GeneralizedCylinder) if p.name == key)
    (text,), (points,) = inside(law, Formula), inside(law, Points)
    assert text.default == str(value) and points.default == Array([(0, value), (1, value)])


def test_a_value_that_is_not_finite_is_refused_with_its_place():
    with pytest.raises(ShapeError) as refusal:
        evaluated(Formula("1/(1 - 2*t)"))
    assert str(refusal.value) == "must be finite everywhere, got inf at u = 1, t = 0.5, s = 1.5"


def test_points_have_the_slopes_of_pchip():
    """The worked example of Moler, Numerical Computing with MATLAB (2004), section 3.4: interpolate at 1:6."""
    law = Points(np.stack([np.arange(1, 7), [16, 18, 21, 17, 15, 12]], axis=1))
    step = 1e-6
    left = evaluated(law, np.arange(2.0, 7.0) - step)
    right = evaluated(law, np.arange(1.0, 6.0) + step)
    slopes = [1.5, 2 / (1 / 2 + 1 / 3), 0, -2 / (1 / 4 + 1 / 2), -2 / (1 / 2 + 1 / 3), -3.5]
    assert (right - [16, 18, 21, 17, 15]) / step == pytest.approx(slopes[:-1], abs=1e-4)
    assert ([18, 21, 17, 15, 12] - left) / step == pytest.approx(slopes[1:], abs=1e-4)


def test_the_rpn14_data_stay_monotone():
    """The radiochemical data on which Fritsch and Carlson (1980) show that a cubic spline overshoots."""
    x = [7.99, 8.09, 8.19, 8.7, 9.2, 10, 12, 15, 20]
    y = [0, 2.76429e-5, 4.37498e-2, 0.169183, 0.469428, 0.943740, 0.998636, 0.999919, 0.999994]
    assert (np.diff(evaluated(Points(np.stack([x, y], axis=1)), np.linspace(7, 21, 2001))) >= 0).all()


heights = st.lists(st.floats(-100, 100), min_size=1, max_size=8)


@given(heights, st.randoms(use_true_random=False))
def test_points_are_met_and_never_overshot(values, random):
    knots = np.cumsum([random.uniform(0.05, 1) for _ in values])
    law = Points(np.stack([knots, values], axis=1))
    assert evaluated(law, knots) == pytest.approx(values, abs=1e-9)
    for i in range(len(values) - 1):
        between = evaluated(law, np.linspace(knots[i], knots[i + 1], 33))
        low, high = sorted(values[i : i + 2])
        assert between.min() >= low - 1e-9 and between.max() <= high + 1e-9
    assert np.array_equal(evaluated(law, np.array([knots[0] - 1, knots[-1] + 1])), [values[0], values[-1]])
