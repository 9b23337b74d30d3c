# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory by formulas is the one that the formulas say: closed where it closes, with corners where it has them."""

import json
import re
from math import pi, sqrt, tau
from pathlib import Path

import numpy as np
import pytest

from sweep_addon.core.contours import Circle
from sweep_addon.core.declared.coercing import coerce_kind
from sweep_addon.core.declared.forms import plain
from sweep_addon.core.declared.parameters import ShapeError, parameters
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import rotation_minimizing
from sweep_addon.core.stations.sampling import Count, place
from sweep_addon.core.trajectories import Closing, Formula, Helix, TorusKnot

KNOTS = json.loads((Path(__file__).parents[1] / "data" / "knots.json").read_text())["knots"]
ROUND = ("cos(u)", "sin(u)", "0")
LEAF = ("u*(u - 1)", "u*(u - 1)*(2*u - 1)", "0")


@pytest.mark.parametrize(
    ("formula", "trajectory"),
    [
        (Formula("2*cos(u)", "2*sin(u)", "0.3*u/tau", 0, 5 * tau), Helix(2.0, 0.3, 5.0)),
        (Formula("(2+0.8*cos(3*u))*cos(2*u)", "(2+0.8*cos(3*u))*sin(2*u)", "0.8*sin(3*u)"), TorusKnot(2, 3, 2.0, 0.8)),
    ],
)
def test_formulas_of_a_kind_are_that_kind(formula, trajectory):
    u = np.linspace(*trajectory.domain, 101)
    assert formula.closed == trajectory.closed
    assert abs(formula.length() / trajectory.length() - 1) < 1e-13
    assert np.abs(formula.evaluate(u) - trajectory.evaluate(u)).max() < 1e-14 * np.abs(trajectory.evaluate(u)).max()
    for order in (1, 2, 3):
        expected = trajectory.derivative(u, order)
        assert np.abs(formula.derivative(u, order) - expected).max() < 1e-13 * max(1, np.abs(expected).max())
    normals, holonomy = rotation_minimizing(place(formula, Count(101)))
    expected, turned = rotation_minimizing(place(trajectory, Count(101)))
    assert np.abs(normals - expected).max() < 1e-12
    assert abs((holonomy - turned + pi) % tau - pi) < 1e-12


@pytest.mark.parametrize("knot", KNOTS, ids=lambda knot: knot["name"])
def test_knots_of_the_collection_close_smoothly(knot):
    x, y, z = (re.sub(r"\bt\b", "u", knot[axis]) for axis in "xyz")
    formula = Formula(x, y, z, *knot["t"])
    assert formula.closed == (knot["kind"] == "closed") and not len(formula.breaks)


@pytest.mark.parametrize(
    ("formulas", "end", "closed"),
    [
        (ROUND, tau, True),
        (ROUND, 6.2831855, True),  # a turn in single precision
        (ROUND, 6.28, False),
        (("cos(u)", "sin(u)", "0.01*u"), tau, False),
        (LEAF, 1, False),  # back in place, but not in direction
        (("sin(u)", "sin(2*u)", "0"), tau, True),
        (("abs(sin(u/2))", "sin(u)", "0"), tau, False),
    ],
)
def test_it_is_closed_where_place_and_direction_agree(formulas, end, closed):
    assert Formula(*formulas, end=end).closed == closed
    assert not Formula(*formulas, end=end, closed=False).closed


def test_told_that_it_is_closed_it_is():
    leaf = Formula(*LEAF, end=1, closed=True)
    assert leaf.closed and leaf.corners().tolist() == [0]
    assert len(GeneralizedCylinder(Circle(0.05), leaf).mesh().boundary_edges()) == 0


@pytest.mark.parametrize(
    ("said", "meant"),
    [(None, Closing.YES), (True, Closing.YES), (False, Closing.NO), ("auto", Closing.YES), ("no", Closing.NO)],
)
def test_closing_is_said_in_python_and_in_jobs(said, meant):
    formula = Formula(closed=said)
    assert formula.closed is meant
    union = next(p for p in parameters(GeneralizedCylinder) if p.name == "trajectory")
    assert coerce_kind(union, plain(formula)) == formula


def test_a_table_that_does_not_say_so_closes_by_itself():
    """Also though the formula that is there by default is closed."""
    union = next(p for p in parameters(GeneralizedCylinder) if p.name == "trajectory")
    assert not coerce_kind(union, {"kind": "formula", "x": "u", "y": "u^2", "z": "0"}).closed
    assert coerce_kind(union, {"kind": "formula", "z": "0"}).closed


@pytest.mark.parametrize(
    ("formula", "corners", "length"),
    [
        (Formula("u", "abs(u)", "0", -1, 1), [0], 2 * sqrt(2)),
        (Formula("u", "abs(u - 0.3)", "abs(u + 0.2)", -1, 1), [-0.2, 0.3], 2 * sqrt(3)),
        (Formula("u", "abs(mod(u, 1) - 0.5)", "0", 0, 3.5), [0.5, 1, 1.5, 2, 2.5, 3], 3.5 * sqrt(2)),
        (Formula("u", "if(u < 1, 0, u - 1)", "0", 0, 2), [1], 1 + sqrt(2)),
        (Formula("sign(u)*u^2", "u^2", "0", -1, 1), [0], 2 * sqrt(2)),  # it stands still in its corner
        (Formula("u", "max(0, u - 0.25)", "0", 0, 1), [0.25], 0.25 + 0.75 * sqrt(2)),
        (Formula("max(-1, min(1, 2*cos(u)))", "max(-1, min(1, 2*sin(u)))", "0"), None, 8.0),  # a square
        (Formula("u", "smoothstep(0, 1, u)", "0", -1, 2), [], None),
        (Formula("u", "sin(100*u)/100", "0", 0, 6), [], None),
    ],
)
def test_corners_are_where_the_pieces_meet(formula, corners, length):
    if corners is not None:
        assert np.abs(formula.corners() - corners).max(initial=0.0) < 1e-11 and len(formula.corners()) == len(corners)
    if length is not None:
        assert abs(formula.length() - length) < 1e-8
        tube = GeneralizedCylinder(Circle(0.01), formula)
        assert tube.mesh().volume() == pytest.approx(tube.contour.section().area * length, rel=1e-8)  # mitred exactly


def test_a_square_by_formulas_has_its_corners():
    square = Formula("max(-1, min(1, 2*cos(u)))", "max(-1, min(1, 2*sin(u)))", "0")
    places = square.evaluate(square.corners())
    assert {tuple(np.round(place, 9)) for place in places} == {(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0)}


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("u", "1/u", "0", 0, 1), "y: must be finite everywhere, got inf at u = 0"),
        (("u", "0", "log(u)", -1, 1), "z: must be finite everywhere, got nan at u = -1"),
        (("u", "sqrt(u)", "0", 0, 1), "y: must be smooth, got a first derivative of inf at u = 0"),
        (("u", "u^1.5", "0", 0, 1), "y: must be smooth, got a second derivative of inf at u = 0"),
        (("u", "floor(u)", "0", 0, 2.5), "y: must be in one piece, got a jump of 1 m near u = "),
        (("u", "0", "tan(u)", 0, 3), "z: must be in one piece, got a jump of "),
        (("u", "1/(u - 0.123)", "0", 0, 1), "y: must be in one piece, got a jump of "),
        (("u", "sin(1e7*u)", "0", 0, 1), "x, y and z must be smooth but for some corners, got more than 8,192 pieces "),
        (("1", "2", "3"), "x, y and z must change with u, got ['1', '2', '3']"),
        (("u", "1e13*u", "0", 0, 1), "y: must be at most 1e+12 in size, got 1e+13"),
        (("u", "v", "0"), "y: must be an expression of u: 'v' at character 1 is no name (u, pi, tau, e are)"),
        (("u", "t", "0"), "y: must be an expression of u: 't' at character 1 is no name (u, pi, tau, e are)"),
        (("u", "0", "().__class__"), "z: must be an expression of u: "),
        (("u", "0", "0", 1, 1), "end: must be more than the start, 1, got 1"),
        (("u", "0", "0", 0, float("nan")), "end: must be a number, got nan"),
        ((*ROUND, 0, 3, True), "closed: must be no or auto where the ends are apart, in metres, got 1.99"),
        ((*ROUND, 0, 3, "maybe"), "closed: must be one of auto, yes, no, got 'maybe'"),
        ((*ROUND, 0, 3, 2), "closed: must be one of auto, yes, no, got 2"),
        ((*ROUND, 0, 3, [1]), "closed: must be one of auto, yes, no, got [1]"),
    ],
)
def test_what_is_no_path_is_refused(arguments, sentence):
    with pytest.raises(ShapeError) as refusal:
        Formula(*arguments)
    assert str(refusal.value).startswith(sentence)


def test_a_cusp_is_refused_where_it_is():
    with pytest.raises(ShapeError, match="trajectory: must not turn back on itself, got a reversal at u = 0"):
        GeneralizedCylinder(trajectory=Formula("u^3", "u^2", "0", -1, 1)).mesh()
