# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every function of the expression language is differentiated as differences and textbooks say."""

import numpy as np
import pytest

from sweep_addon.core.formulas.expressions import compile
from sweep_addon.core.formulas.functions import FUNCTIONS, INFIX, PREFIX
from sweep_addon.core.formulas.jets import Jet

PLACES = np.array([0.3, 0.71, 1.3, -0.4])
EVERY = """
    u^2 u^3 2^u abs(u)^u abs(u) sin(3*u) cos(u^2) tan(u) sinh(u) cosh(u) tanh(2*u) sqrt(1+u*u) exp(-u) log(2+u)
    log10(2+u)
    asin(u/2) acos(u/2)
    atan(3*u) atan2(u,1-u) atan2(1-u,u) atan2(-1,u) floor(3*u)*u ceil(u)*u trunc(2*u)*u round(3*u)*u
    sign(u)*u min(u,1-u) max(u,0.5,u*u) mod(u,0.37) u%-0.37 mod(1,u) pow(1+u*u,1.5) clamp(u,0,1)*u lerp(1,u,u*u)
    smoothstep(-1,2,u) if(u>0.5,u^3,sin(u)) 1/(2+u) u/(1+u*u) (1+u)/3 -u +u (u>0)*u^2 (u<=0||u>=1)*u (u==9)*u
    (u!=9)*u u^0 u^1 u^-1 u**2 !u+u (0.5<u&&u<1)*u^3 exp(u)
""".split()
EVERY += ["(not u > 1) * u", "(u < 0 or u > 1) * u ^ 2", "(u > 0 and u < 1) * u"]


def jet(text, u, order=3):
    return compile(text, ("u",)).run({"u": Jet.variable(np.asarray(u, dtype=float), order)})


@pytest.mark.parametrize("order", [1, 2, 3])
@pytest.mark.parametrize("text", EVERY)
def test_derivatives_are_those_of_the_one_below(text, order):
    """Central differences over four points err by 1e-12 of the fifth derivative and by 1e-13 / step of rounding."""
    step = 1e-3

    def below(u):
        return jet(text, u).derivative(order - 1)

    there, back = below(PLACES + step) - below(PLACES - step), below(PLACES - 2 * step) - below(PLACES + 2 * step)
    difference = (8 * there + back) / (12 * step)
    found = jet(text, PLACES).derivative(order)
    assert (np.abs(found - difference) < 1e-7 * (1 + np.abs(found))).all()


@pytest.mark.parametrize("text", EVERY)
def test_the_value_is_that_of_the_expression(text):
    expected = compile(text, ("u",)).evaluate(u=PLACES)
    assert np.abs(jet(text, PLACES).derivative(0) - expected).max() < 1e-15 * max(1, np.abs(expected).max())


def test_nothing_of_the_language_is_left_out():
    told = " ".join(EVERY)
    assert all(f"{name}(" in told for name in FUNCTIONS)
    assert all(symbol in told for symbol in (*INFIX, *PREFIX))


@pytest.mark.parametrize(
    ("text", "u", "expected"),
    [
        ("exp(sin(u))", 0, (1, 1, 1, 0)),  # 1 + u + u^2/2 - u^4/8 - ...
        ("log(1 + u)", 0, (0, 1, -1, 2)),
        ("tan(u)", 0, (0, 1, 0, 2)),
        ("1/(1 - u)", 0, (1, 1, 2, 6)),
        ("u^2", 0, (0, 0, 2, 0)),
        ("u^3", 0, (0, 0, 0, 6)),
        ("(u - 1)^3", -1, (-8, 12, -12, 6)),
        ("sqrt(1 + u)", 0, (1, 1 / 2, -1 / 4, 3 / 8)),
        ("atan2(sin(u), cos(u))", 3, (3, 1, 0, 0)),
        ("u^u", 1, (1, 1, 2, 3)),
    ],
)
def test_series_are_those_of_textbooks(text, u, expected):
    found = [jet(text, [u]).derivative(order)[0] for order in range(4)]
    assert np.abs(np.subtract(found, expected)).max() < 1e-14


@pytest.mark.parametrize("order", [0, 1, 2])
def test_fewer_derivatives_are_the_same(order):
    text = "atan2(exp(u) * sin(u), 2 + u^2) / sqrt(3 + u) ^ u"
    assert np.abs(jet(text, PLACES, order).series - jet(text, PLACES).series[: order + 1]).max() < 1e-15
