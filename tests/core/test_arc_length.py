# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arc length and the way back: closed forms, for few places and for so many that polynomials answer."""

from math import hypot, pi, tau

import numpy as np
import pytest

from sweep_addon.core.stations.chebyshev import angles, counted, fitting, summed
from sweep_addon.core.trajectories import Arc, Formula, Helix, Line, Sampled, TorusKnot
from sweep_addon.core.trajectories.arc_length import ArcLength

FEW, MANY = 20, 20_000
PARABOLA = Formula("u", "4*u^2", "0", start=-1.0, end=1.0, closed="no")
CUSP = Formula("u^2", "u^3", "0", start=-1.0, end=1.0, closed="no")
WAY = Sampled(np.random.default_rng(3).normal(size=(12, 3)))


def along_parabola(u):
    """The integral of sqrt(1 + (8 u)^2) from -1."""
    primitive = (8 * u * np.sqrt(1 + 64 * u**2) + np.arcsinh(8 * u)) / 16
    return primitive - (-8 * np.sqrt(65) - np.arcsinh(8)) / 16


def along_cusp(u):
    """Neile's: the integral of |u| sqrt(4 + 9 u^2) from -1."""
    primitive = ((4 + 9 * u**2) ** 1.5 - 8) / 27
    return (13**1.5 - 8) / 27 + np.sign(u) * primitive


@pytest.mark.parametrize("count", [FEW, MANY])
@pytest.mark.parametrize(("way", "along"), [(PARABOLA, along_parabola), (CUSP, along_cusp)], ids=["parabola", "cusp"])
def test_parameters_are_those_of_the_closed_form(way, along, count):
    measure = ArcLength(way)
    s = np.linspace(0, measure.total, count)
    u = measure.parameter(s)
    assert np.abs(along(u) - s).max() < 3e-14 * measure.total
    assert (u[0], u[-1]) == way.domain and (np.diff(u) > 0).all()


@pytest.mark.parametrize("way", [TorusKnot(), WAY, Helix(turns=7.0), Arc(2.0, pi), Line(end=(1, 2, 3))], ids=repr)
def test_the_way_back_leads_to_where_it_began(way):
    measure = ArcLength(way)
    s = np.linspace(0, measure.total, MANY)
    assert np.abs(measure.at(measure.parameter(s)) - s).max() < 3e-14 * measure.total


def test_where_the_speed_is_the_same_everywhere_both_ways_are_proportions():
    helix = ArcLength(Helix(2.0, 3.0, 4.0))
    assert helix.steady and ArcLength(Arc(0.3, 2.0)).steady and ArcLength(Line()).steady
    assert helix.at(np.array([0.0, 1.0])).tolist() == pytest.approx([0.0, hypot(2.0, 3.0 / tau)], rel=1e-15)
    assert not any(ArcLength(way).steady for way in (TorusKnot(), WAY, PARABOLA))
    assert not ArcLength(Formula("u + 1e-13*sin(u)", "0", "0", end=9.0)).steady


def test_polynomials_leave_out_terms_that_are_no_more_than_was_allowed():
    x = np.linspace(-1, 1, 101)
    terms = fitting(20) @ np.exp(np.cos(angles(20)))[:, None] * [1.0, 2.0]
    short = counted(terms, 1e-8)
    assert len(short) < len(counted(terms, 1e-12)) < 20
    errors = [np.abs(summed(short[:, [i] * 101], x) - (i + 1) * np.exp(x)).max() for i in (0, 1)]
    assert max(errors) < 1e-8 and max(errors) > 1e-11
    assert len(counted(np.zeros((5, 3)), 1e-8)) == 1
