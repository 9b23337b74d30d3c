# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input is refused in one sentence: the parameter, what would do, and what was given."""

import re
from math import inf, nan

import numpy as np
import pytest

from sweep_addon.core.contours import Aerofoil, Circle, Ellipse, Outline, Rectangle, RegularPolygon, Star, Superellipse
from sweep_addon.core.declared.digest import digest
from sweep_addon.core.declared.parameters import Array, ShapeError
from sweep_addon.core.rings import corners
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
from sweep_addon.core.shapes.rotational_sweep import RotationalSweep
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.trajectories import Arc, Bezier, Formula, Helix, Line, Nurbs, Polyline, Sampled, TorusKnot

TRAJECTORIES = "line, arc, helix, torus-knot, polyline, bezier, nurbs, sampled, formula"
CONTOURS = "circle, ellipse, rectangle, regular-polygon, star, superellipse, aerofoil, screw-thread, outline"
SQUARE = [(0, 0), (3, 0), (3, 3), (0, 3)]
S_CURVE = Bezier([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])
BENT = [(0, 0, 0), (2, 0, 0), (2, 3, 0)]
THERE, BACK = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (3, 0, 0)], [(2, 0, 0), (1, 0, 0)]
CUSP = [(0, 0, 0), (1, 1, 0), (0, 1, 0), (1, 0, 0)]


def taper(length):
    return {"kind": "taper", "length": length}


def count(contours):
    return {"kind": "count", "contours": contours}


VALUES = {  # refused when it is made
    "radius: must be more than 0, got 0": (Circle, 0),
    "radius: must be more than 0, got -1": (Circle, -1),
    "radius: must be a number of metres, got nan": (Circle, nan),
    "radius: must be a number of metres, got '1 mm'": (Circle, "1 mm"),
    "radius: must be a number of metres, got True": (Circle, True),
    "radius: must be at most 1e+12 in size, got 1e+300": (Circle, 1e300),
    f"radius: must be at most 1e+12 in size, got 1{'0' * 56}...": (Circle, 10**400),
    "points: must be at least 3, got 2": (Circle, 1, 2),
    "points: must be a whole number, got 3.5": (Circle, 1, 3.5),
    "points: must be at most 4096, got 1000000000": (Circle, 1, 10**9),
    "rounding: must be at most 0.5, half the shorter side, got 0.6": (Rectangle, 1, 2, 0.6),
    "height: must be at least 1e-06, a millionth of width, got 1e-14": (Rectangle, 1, 1e-14),
    "radius_y: must be at least 2e-06, a millionth of radius_x, got 1e-06": (Ellipse, 2, 1e-6),
    "radius_x: must be at least 1e-06, a millionth of radius_y, got 1e-07": (Ellipse, 1e-7, 1),
    "points: must be at least 3, got 1": (Ellipse, 1, 1, 1),
    "sides: must be at least 3, got 2": (RegularPolygon, 2),
    "radius_to: must be one of corners, sides, got 'flats'": (RegularPolygon, 6, 1, "flats"),
    "rounding: must be at most 0.5, where the sides are, got 0.6": (RegularPolygon, 3, 1, "corners", 0.6),
    "rounding: must be at most 1, where the sides are, got 1.1": (RegularPolygon, 3, 1, "sides", 1.1),
    "points: must be at least 2, got 1": (Star, 1),
    "inner: must be more than 0, got 0": (Star, 5, 1, 0),
    "inner: must be at least 1e-06, a millionth of outer, got 1e-07": (Star, 5, 1, 1e-7),
    "exponent: must be at least 0.25, got 0": (Superellipse, 1, 1, 0),
    "exponent: must be at most 100, got 1000": (Superellipse, 1, 1, 1000),
    "width: must be at least 1e-06, a millionth of height, got 1e-07": (Superellipse, 1e-7, 1),
    "code: must be the four digits of a NACA aerofoil, such as 2412, got '23012'": (Aerofoil, "23012"),
    "code: must be the four digits of a NACA aerofoil, such as 2412, got 'Clark Y'": (Aerofoil, "Clark Y"),
    "code: must be the four digits of a NACA aerofoil, such as 2412, got ''": (Aerofoil, ""),
    "code: must be the four digits of a NACA aerofoil, such as 2412, got '٢٤١٢'": (Aerofoil, "٢٤١٢"),
    "code: must be text, got 2412": (Aerofoil, 2412),
    "code: must have a camber and its place, or 00 for neither, got '2012'": (Aerofoil, "2012"),
    "code: must have a camber and its place, or 00 for neither, got '0412'": (Aerofoil, "0412"),
    "code: must have a thickness, its last two digits, got '2400'": (Aerofoil, "2400"),
    "chord: must be more than 0, got 0": (Aerofoil, "2412", 0),
    "reference: must be at most 1, got 1.5": (Aerofoil, "2412", 1, 1.5),
    "trailing_edge: must be one of closed, open, got 'blunt'": (Aerofoil, "2412", 1, 0.25, "blunt"),
    "side_points: must be at least 3, got 2": (Aerofoil, "2412", 1, 0.25, "open", 2),
    "loops: must have at least 3 different points, got 2": (Outline, [SQUARE[:2]]),
    "loops: must enclose an area, got 3 points on one line": (Outline, [[(0, 0), (1, 0), (2, 0)]]),
    "loops: must not cross or touch itself, got a crossing near (0.5, 0.5)": (
        Outline, [[(0, 0), (1, 1), (1, 0), (0, 1)]]
    ),
    "loops: loops 0 and 1 must not cross or touch each other, got a crossing near (3, 1)": (
        Outline, [SQUARE, [(1, 1), (4, 1), (4, 2), (1, 2)]]
    ),
    "loops: must have finite numbers up to 1e+12 in size, got nan in row 2": (Outline, [[(0, 0), (nan, 0), (1, 1)]]),
    "points: must have at least 2 points, got 0": (Polyline, np.empty((0, 3))),
    "points: must have at least 3 points, got 2": (Polyline, THERE[:2], True),
    "points: must not be where the next one is, got point 2 at [1.0, 0.0, 0.0]": (
        Polyline, [(0, 0, 0), (1, 0, 0), (1, 0, 0), (1, 1, 0)]
    ),
    "points: must not be where the next one is, got point 3 at [0.0, 0.0, 0.0]": (
        Polyline, [(0, 0, 0), (1, 1, 0), (0, 0, 0)], True
    ),
    "points: must not turn back on itself, got point 2 at [1.0, 0.0, 0.0]": (Polyline, [*THERE[:2], (0.5, 0, 0)]),
    "points: must not turn back on itself, got point 1 at [0.0, 0.0, 0.0]": (Polyline, THERE, True),
    "points: must have finite numbers up to 1e+12 in size, got nan in row 5": (Polyline, [*THERE, (0, 1, nan)]),
    "points: must have finite numbers up to 1e+12 in size, got -inf in row 5": (Polyline, [*THERE, (0, -inf, 0)]),
    "points: must have finite numbers up to 1e+12 in size, got 1e+13 in row 5": (Polyline, [*THERE, (0, 1e13, 0)]),
    "points: must be a list of 3 numbers each, got (0, 0) in row 1": (Polyline, [(0, 0), (1, 1)]),
    "points: must be a list of 3 numbers each, got (1, 0) in row 2": (Polyline, [(0, 0, 0), (1, 0)]),
    "points: must be a list of 3 numbers each, got ('0', '0', '1') in row 1": (Polyline, [("0", "0", "1")]),
    "points: must be a list of 3 numbers each, got (0, 0, None) in row 1": (Polyline, [(0, 0, None)]),
    "points: must be a list of 3 numbers each, got array(1) in row 1": (Polyline, [np.array(1), (0, 0, 1)]),
    "points: must be a list of 3 numbers each, got 'points'": (Polyline, "points"),
    "corner: must be one of mitre, round, bevel, got 'miter': did you mean 'mitre'?": (
        Polyline, THERE[:2], False, "miter"
    ),
    "corner.limit: must be at least 1, got 0.5": (Polyline, BENT, False, {"kind": "mitre", "limit": 0.5}),
    "corner.radius: must be more than 0, got 0": (Polyline, BENT, False, {"kind": "round", "radius": 0}),
    "corner.radius: must be at most 2 to fit into the leg from point 1 to point 2, got 3": (
        Polyline, BENT, False, corners.Round(3)
    ),
    "corner.setback: must be at most 1.5 to fit into the leg from point 2 to point 3, got 1.75": (
        Polyline, [*BENT, (0, 3, 3)], False, corners.Bevel(1.75)
    ),
    "corner.setback: must be at most 1 to fit into the leg from point 1 to point 2, got 1.75": (
        Polyline, BENT, True, corners.Bevel(1.75)
    ),
    "end: must differ from the start, got [1.0, 2.0, 3.0]": (Line, (1, 2, 3), (1, 2, 3)),
    "end: must be a list of 3, got (1, 2)": (Line, (1, 2, 3), (1, 2)),
    "points: must be 1 more than a multiple of 3: knot, handle, handle, ..., got 5": (Bezier, [*THERE, (4, 0, 0)]),
    "points: must be a multiple of 3: knot, handle, handle, ..., got 4": (Bezier, THERE, True),
    "points: must have no segment without length, got segment 2": (Bezier, [*THERE, *[(3, 0, 0)] * 3]),
    "points: must not turn back on itself, got a cusp at u = 0.5": (Bezier, CUSP),
    "points: must have at least 4 points, got 1": (Bezier, THERE[:1]),
    "points: must have at least 3 points, got 0": (Bezier, np.empty((0, 3)), True),
    "points: must have at least 2 points, got 1": (Nurbs, THERE[:1]),
    "points: must have at most 5555 points where the order is 12, got 5556": (
        Nurbs, np.eye(5556, 3), (), 12
    ),
    "order: must be at most 2, the number of control points, got 4": (Nurbs, THERE[:2]),
    "points: must not all be in one place, got [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0,...": (
        Nurbs, [(0, 0, 0)] * 5
    ),
    "weights: must all be more than 0, got [1.0, 1.0, 0.0, 1.0]": (Nurbs, THERE, [1, 1, 0, 1]),
    "weights: must be 4 numbers, one a control point, got 2": (Nurbs, THERE, [1, 1]),
    "knots: must be 8 numbers, got 2": (Nurbs, THERE, (), 4, [0, 1]),
    "knots: must not fall, got [0.0, 1.0, 2.0, 3.0, 2.0, 5.0, 6.0, 7.0]": (
        Nurbs, THERE, (), 4, [0, 1, 2, 3, 2, 5, 6, 7]
    ),
    "angle: must be more than 0, got 0": (Arc, 1.0, 0),
    "angle: must be a number of radians, got '90 deg'": (Arc, 1.0, "90 deg"),
    "end: must be a number of metres, got '1 m'": (Line, (0, 0, 0), (0, 0, "1 m")),
    "angle: must be at most 6.28321, got 6.284": (Arc, 1.0, 6.284),
    "turns: must be at most 10000, got 1e+09": (Helix, 1.0, 0.5, 1e9),
    "pitch: must be at least 1e-06 in size, or a whole turn lies on itself, got 0": (Helix, 1.0, 0.0, 1.0),
    "q: must share no factor with p, which is 2, got 4": (TorusKnot, 2, 4),
}  # fmt: skip

SHAPES = {  # refused when the shape is made, or its mesh
    f"contour: must be one of {CONTOURS}, got 'square': say {{ kind = \"regular-polygon\", sides = 4 }}": {
        "contour": "square"
    },
    f"contour: must be one of {CONTOURS}, got 'elipse': did you mean 'ellipse'?": {"contour": "elipse"},
    f"trajectory: must be one of {TRAJECTORIES}, got [(0, 0, 0), (1, 0, 0)]: points alone may be those of "
    'polyline, bezier, nurbs or sampled, say Polyline(points=...) or { kind = "polyline", points = ... }': {
        "trajectory": [(0, 0, 0), (1, 0, 0)]
    },
    "contour.radus: is no parameter of Circle, which has radius, points: did you mean 'radius'?": {
        "contour": {"kind": "circle", "radus": 1}
    },
    f"contour.kind: must be given, as one of {CONTOURS}": {"contour": {"radius": 1}},
    "contour.Kind: is no parameter: did you mean 'kind'?": {"contour": {"Kind": "circle"}},
    "twist: must be a number of radians, a formula in text or a list of points [t, value], got [1, 2]": {
        "twist": [1, 2]
    },
    "twist: must be one of constant, formula, points, got None: say a number, a formula in text, as \"2*pi*t\", "
    "or a list of points [t, value]": {"twist": None},
    "contour: must reach 2.5e-12 m or more on this trajectory, got 1e-14": {"contour": Circle(1e-14)},
    "trajectory: must be at least 1e-12 m long, got 1e-13": {"trajectory": Line(end=(0, 0, 1e-13))},
    "trajectory: must not turn back on itself, got a reversal at u = 1": {
        "trajectory": Bezier([*THERE, *BACK, (0, 0, 0)])
    },
    "trajectory: must not turn back on itself, got a reversal at u = 0": {
        "trajectory": Bezier(THERE + BACK, closed=True)
    },
    "trajectory: must not turn back on itself, got a reversal at u = 3": {
        "trajectory": Nurbs([*THERE, *BACK], order=2)
    },
    "samples.contours: must be at most 200000, got 1000000000": {"samples": count(10**9)},
    "samples.contours: must be at least 2, got 1": {"samples": count(1)},
    "samples: must make at most 20,000,000 vertices, got 819200000": {
        "contour": Circle(1, 4096), "samples": count(200_000)
    },
    "frame: must be one of rotation-minimizing, frenet, fixed-up, got 'up'": {"frame": "up"},
    "frame.up: must have a length, got [0.0, 0.0, 0.0]": {"frame": {"kind": "fixed-up", "up": (0, 0, 0)}},
    "frame.extra_turns: must be at most 1000, got 1000000": {
        "frame": {"kind": "rotation-minimizing", "extra_turns": 10**6}
    },
    "frame.continuation: must be smooth or exact where the curvature vanishes, got refuse near u = 0.5": {
        "trajectory": S_CURVE, "samples": count(3), "frame": {"kind": "frenet", "continuation": "refuse"}
    },
    "scale_x: must be finite everywhere, got inf": {"scale_x": "9**9**9**9"},
    "scale_x: must be a number, got inf": {"scale_x": inf},
    "scale_x: must be finite everywhere, got inf at u = 1, t = 1, s = 1": {"trajectory": Line(), "scale_x": "1/(1-t)"},
    "scale_x: must be at most 1e+12 in size, got 1e+300": {"scale_x": "1e300*t"},
    "twist: must be at most 1e+12 in size, got 1e+300": {"twist": "1e300*t"},
    "scale_x: must not be 0 everywhere, got 0": {"scale_x": 0, "scale_y": 0},
    "scale_y: must not be 0 where scale_x is not, got 0 at contour 1": {"scale_y": "t"},
    "scale_y: must not change its sign against scale_x, got -1 at contour 2": {
        "trajectory": Line(), "scale_y": "1-2*t"
    },
    "scale_x: must not stay 0 along a stretch, got 0 at contour 1": {
        "scale_x": "max(0, t-0.5)", "scale_y": "max(0, t-0.5)"
    },
    "scale_x: must reach 0 where it changes its sign, got -1 at contour 2": {
        "samples": count(5), "scale_x": "if(t<0.6,-1,1)", "scale_y": "if(t<0.6,-1,1)"
    },
    "scale_y: must be the same at both ends of a closed trajectory, 1, got 2": {
        "trajectory": TorusKnot(), "scale_y": "1+t"
    },
    "twist: must grow by whole turns along a closed trajectory, got 0.5 turns": {
        "contour": Outline(), "trajectory": TorusKnot(), "twist": "pi*t"
    },
    "twist: must grow by whole turns along a closed trajectory, got 1.5 turns": {
        "trajectory": TorusKnot(), "twist": "3*pi*t", "offset_y": 0.1
    },
    "twist: must grow by multiples of 1/4 turn along a closed trajectory, got 0.125 turns": {
        "contour": Rectangle(1, 1), "trajectory": TorusKnot(), "twist": "pi/4*t"
    },
    "twist: must grow by multiples of 1/2 turn along a closed trajectory, got -0.25 turns": {
        "contour": Rectangle(1, 1), "trajectory": TorusKnot(), "twist": "-pi/2*t", "scale_x": "1 + 0.1*sin(2*pi*t)"
    },
    "start.length: must be more than 0, got 0": {"start": taper(0)},
    "end.height: must be more than 0, got -1": {"end": {"kind": "round", "height": -1}},
    "end: must be flat, open or taper where the contour has holes, which a dome would close, got 'round'": {
        "contour": Outline([SQUARE, [(0.5, 0.5), (0.75, 0.5), (0.5, 0.75)]]), "end": "round"
    },
    "start: must be flat, open or taper where the contour's centroid does not see all of its outline, got 'round'": {
        "contour": Outline([[(0, 0), (9, 0), (9, 1), (1, 1), (1, 9), (0, 9)]]), "start": "round"
    },
    "end.length: must be at most 1, what is left of the trajectory, got 2": {"trajectory": Line(), "end": taper(2)},
    "end.length: must be at most 0.25, what is left of the trajectory, got 0.5": {
        "trajectory": Line(), "start": taper(0.75), "end": taper(0.5)
    },
}  # fmt: skip

BEGINNINGS = {  # of sentences that go on with a count or with what the language has
    "samples.chord: must be larger, or the sweep turn less: it needs ": {
        "trajectory": Helix(1000.0),
        "samples": {"kind": "tolerance", "chord": 1e-9},
    },
    "samples.chord: must be larger, or the sweep turn less: it needs 3,": {"twist": "1e9*t"},
    "scale_x: must be an expression of u, t, s: it is 20001 characters long": {
        "scale_x": "(" * 10_000 + "1" + ")" * 10_000
    },
    "scale_x: must be an expression of u, t, s: 'radius' at character 1 is no name": {"scale_x": "radius"},
    "scale_x: must be an expression of u, t, s: '.' at character 2 ": {"scale_x": "t.__class__"},
    "scale_x: must be an expression of u, t, s: '__import__' at character 1 ": {"scale_x": "__import__('os')"},
}


def refusal(make):
    with pytest.raises(ShapeError) as caught:
        make()
    sentence = str(caught.value)
    assert "\n" not in sentence and re.search(", got |is no parameter|must be given", sentence)
    return sentence


@pytest.mark.parametrize("sentence", VALUES)
def test_a_value_that_will_not_do_is_refused_when_it_is_made(sentence):
    kind, *values = VALUES[sentence]
    assert refusal(lambda: kind(*values)) == sentence


@pytest.mark.parametrize("sentence", SHAPES)
def test_a_shape_that_will_not_do_is_refused(sentence):
    assert refusal(lambda: GeneralizedCylinder(**SHAPES[sentence]).mesh()) == sentence


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"raduis": 1}, "'raduis' is no parameter of Circle, which has radius, points: did you mean 'radius'?"),
        ({"centre": 1}, "'centre' is no parameter of Circle, which has radius, points"),
    ],
)
def test_a_misspelt_argument_of_a_constructor_is_told_the_name_it_is_near(given, sentence):
    with pytest.raises(TypeError, match=f"^{re.escape(sentence)}$"):
        Circle(**given)


def test_a_refusal_knows_what_else_is_wrong_with_the_same_value():
    told = {"radus": 1, "points": 1}
    with pytest.raises(ShapeError) as caught:
        GeneralizedCylinder(contour={"kind": "circle", **told}, trajectory="lin", twist="2 t", scale_x=1)
    keys = [refusal.key for refusal in caught.value.each()]
    assert keys == ["contour.radus", "contour.points", "trajectory", "twist"]
    assert str(caught.value).startswith("contour.radus: is no parameter of Circle")
    assert [refusal.others for refusal in caught.value.others] == [(), (), ()]


def test_what_goes_together_is_not_asked_where_a_parameter_is_misspelt():
    """A rounding of 2 does not go with the default width, but would with the one that was meant."""
    with pytest.raises(ShapeError) as caught:
        GeneralizedCylinder(contour={"kind": "rectangle", "widht": 9, "height": 9, "rounding": 2})
    assert [refusal.key for refusal in caught.value.each()] == ["contour.widht"]


@pytest.mark.parametrize("beginning", BEGINNINGS)
def test_a_refusal_says_how_much_is_too_much(beginning):
    assert refusal(lambda: GeneralizedCylinder(**BEGINNINGS[beginning]).mesh()).startswith(beginning)


@pytest.mark.parametrize("shape", [GeneralizedCylinder, TranslationalSweep, RotationalSweep, PDCurveSweep])
@pytest.mark.parametrize("dtype", [int, np.float16, complex, "metres"])
def test_vertices_are_in_single_or_double_precision(shape, dtype):
    """Whole numbers would cut off all coordinates, and half precision would leave three digits of them."""
    assert refusal(lambda: shape().mesh(dtype)).startswith("dtype: must be float32 or float64, got ")
    assert shape().mesh("float32").vertices.dtype == np.float32


@pytest.mark.parametrize("points", ["x", None, [(1, 2), (3,)], [(1, 2, "3")], [(1, 2, 3j)]])
def test_only_numbers_are_bent(points):
    assert refusal(lambda: PDCurveSweep().bend(points)).startswith("points: must be rows of 3 numbers, got ")


def test_a_long_list_is_refused_by_its_wrong_row():
    points = np.zeros((100_000, 3))
    points[:, 2] = np.arange(100_000)
    points[77_776, 1] = nan
    for given in (points, points.tolist()):
        assert refusal(lambda given=given: Polyline(given)).endswith("got nan in row 77777")


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (Polyline, "points: must have at most 200000 points, got 500000"),
        (Bezier, "points: must have at most 200000 points, got 500000"),
        (Sampled, "points: must have at most 100000 points, got 500000"),
        (Nurbs, "points: must have at most 50000 points, got 500000"),
        (lambda points: Outline([points]), "loops: must have at most 200000 points, got 500000"),
        (lambda points: Outline([[point] for point in points]), "loops: must have at most 200000 points, got 500000"),
        (lambda points: Outline([[]] * len(points)), "loops: must have at most 200000 points, got 500000"),
        (lambda points: Outline([SQUARE], [points]), "bulges: must have at most 200000 numbers, got 500000"),
    ],
)
def test_a_list_that_is_too_long_is_counted_before_it_is_read(make, sentence):
    """Not one of the rows is a point, and none is looked at."""
    assert refusal(lambda: make([None] * 500_000)) == sentence


@pytest.mark.parametrize(("kind", "most"), [(Polyline, 200_000), (Sampled, 100_000), (Nurbs, 50_000)])
def test_the_longest_list_is_taken(kind, most):
    turn = np.linspace(0, 100, most)
    assert len(kind(np.stack((np.cos(turn), np.sin(turn), turn), axis=1)).points) == most


def test_a_loop_outside_its_outline_is_an_island():
    """By the even-odd rule nothing is a hole but what lies inside."""
    outline = Outline([SQUARE, [(5, 0), (6, 0), (6, 1), (5, 1)]])
    assert outline.section().area == 10 and outline.section().islands == ((0,), (1,))


def test_arrays_cannot_be_changed_and_do_not_change_with_what_they_were_made_of():
    given = np.array([(0.0, 0.0, 0.0), (0.0, 0.0, 1.0)])
    line = Polyline(given)
    given[0] = 9
    assert line == Polyline([(0, 0, 0), (0, 0, 1)])
    with pytest.raises(ValueError, match="read-only"):
        line.points.values[0] = 9


def test_equal_values_have_equal_hashes_and_digests():
    for one, other in (
        (Line(end=(0, 0, 1)), Line(end=(-0.0, 0, 1.0))),
        (Polyline([(0, 0, 0), (0, 0, 1)]), Polyline([(0, -0.0, 0), (0, 0, 1)])),
        (GeneralizedCylinder(scale_x="1"), GeneralizedCylinder(scale_x={"kind": "formula", "text": "1"})),
    ):
        assert one == other and hash(one) == hash(other) and digest(one) == digest(other)
    assert Array([1, 2]) != Array([[1, 2]]) and digest(Circle(1)) != digest(Circle(1 + 1e-15))


ASKED = [Line(), Arc(), Helix(), TorusKnot(), Polyline(THERE), Bezier(), Nurbs(), Sampled(), Formula()]


@pytest.mark.parametrize("trajectory", ASKED, ids=lambda each: type(each).__name__)
@pytest.mark.parametrize("asked", ["x", 0.5, None, ["a", "b"], [[0.5, 1.0]], 1j])
def test_what_is_no_row_of_parameters_is_refused(trajectory, asked):
    for question in (trajectory.evaluate, trajectory.derivative):
        with pytest.raises(ShapeError, match="^u: must be a list or an array of numbers, got ") as refusal:
            question(asked)
        assert refusal.value.key == "u"


def test_moving_by_what_is_no_length_names_the_axis():
    with pytest.raises(ShapeError, match="^y: must be a number of metres, got 'up'$"):
        TranslationalSweep().moved(1.0, "up")


def test_the_mesh_of_a_tree_is_in_no_other_precision_than_that_of_a_shape():
    with pytest.raises(ShapeError, match="^dtype: must be float32 or float64, got 'x'$"):
        TranslationalSweep().mesh().astype("x")
