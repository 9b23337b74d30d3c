# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership of offsets against formulas: no chord of a ball, a rod or a hole counts, on whichever side.

Each formula is the distance from the solid that is offset, with its sign.
"""

from math import pi

import numpy as np
import pytest
from contour_inputs import superellipse

import sweep_addon as sw
from sweep_addon.core.membership.plane.smooth import Superdisc

solids = sw.solids
HALF = 0.15  # of the drilled block's height


def ball(p):
    return np.linalg.norm(p, axis=1) - 0.4


def capped(across, along):
    """The distance from a prism by those from its contour and from between its ends."""
    outside = np.hypot(np.maximum(across, 0), np.maximum(along, 0))
    return outside + np.minimum(np.maximum(across, along), 0)


def rod(p):
    return capped(np.hypot(p[:, 0], p[:, 1]) - 0.2, np.abs(p[:, 2]) - 0.3)


def rectangle(x, y, half_x, half_y):
    return capped(np.abs(x) - half_x, np.abs(y) - half_y)


def block(p):
    return capped(rectangle(p[:, 0], p[:, 1], 0.25, 0.15), np.abs(p[:, 2]) - 0.1)


def drilled(p):
    """Inside the block the hole is the nearer one where it is; outside its sides it never is."""
    hole = 0.15 - np.hypot(p[:, 0], p[:, 1])
    return capped(np.maximum(rectangle(p[:, 0], p[:, 1], 0.25, 0.25), hole), np.abs(p[:, 2]) - HALF)


def bracket(p):
    """Two legs: outside the nearer one; inside what is nearest of the six sides, or the hollow corner."""
    x, y = p[:, 0], p[:, 1]
    legs = np.minimum(rectangle(x - 0.25, y - 0.06, 0.25, 0.06), rectangle(x - 0.06, y - 0.25, 0.06, 0.25))
    corner = np.hypot(np.minimum(x - 0.12, 0), np.minimum(y - 0.12, 0))
    ends = np.minimum(0.5 - x, 0.5 - y)
    within = np.minimum.reduce([x, y, ends, np.where((x < 0.12) & (y < 0.12), corner, np.inf)])
    within = np.minimum(within, np.where(x > 0.12, 0.12 - y, np.where(y > 0.12, 0.12 - x, np.inf)))
    return capped(np.where(legs < 0, -within, legs), np.abs(p[:, 2]) - 0.1)


BODIES = {
    "ball": (solids.Ball(0.4, 8), ball),
    "cylinder": (solids.Cylinder(0.2, 0.6, 6), rod),
    "block": (solids.Block(0.5, 0.3, 0.2), block),
    "drilled block": (solids.DrilledBlock(points=6), drilled),
    "bracket": (solids.Bracket(), bracket),
}
SIDES = {
    "outside": lambda far, radius: far - radius,
    "inside": lambda far, radius: far + radius,
    "shell": lambda far, radius: np.abs(far) - radius,
}


def crossed(values, inner, outer):
    """Points where values turn from below 0 to above it, between points of both kinds, by bisection."""
    for _ in range(60):
        middle = (inner + outer) / 2
        inside = (values(middle) < 0)[:, None]
        inner, outer = np.where(inside, middle, inner), np.where(inside, outer, middle)
    return outer


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("name", BODIES)
def test_an_offset_is_that_of_the_true_solid(name, side):
    """However few points the solid has; what is on is so within the default tolerance, a billionth of the size."""
    body, distance = BODIES[name]
    radius = 0.04
    shape = sw.OffsetSurface(body, radius, side)

    def values(p):
        return SIDES[side](distance(p), radius)

    points = np.random.default_rng(0).uniform(-0.6, 0.7, (40_000, 3)) * (1, 1, 0.6)
    assert (sw.classify(shape, points) == np.sign(-values(points))).all()
    inner, outer = points[values(points) < 0], points[values(points) > 0]
    count = min(len(inner), len(outer), 500)
    assert count > 100
    assert (sw.classify(shape, crossed(values, inner[:count], outer[:count])) == 0).all()


def test_a_ball_s_offset_is_a_ball_and_beside_it_by_a_millionth_no_point_is_on():
    rng = np.random.default_rng(1)
    ways = rng.normal(size=(2000, 3))
    ways /= np.linalg.norm(ways, axis=1, keepdims=True)
    outside, inside = (sw.OffsetSurface(solids.Ball(0.5, 6), 0.2, side) for side in ("outside", "inside"))
    for shape, radius in ((outside, 0.7), (inside, 0.3)):
        for away, label in ((-1e-6, 1), (0.0, 0), (1e-6, -1)):
            assert (sw.classify(shape, (radius + away) * ways) == label).all()


def test_a_hole_that_is_offset_is_narrower_and_rounded_at_its_rims():
    """Outside, a hole of radius 0.15 becomes one of 0.1; beyond the block's ends its rims are quarters of a torus."""
    shape = sw.OffsetSurface(solids.DrilledBlock(points=6), 0.05)
    angle, z, rise = np.random.default_rng(2).uniform((0, -HALF, 0), (2 * pi, HALF, pi / 2), (1000, 3)).T
    around = np.stack((np.cos(angle), np.sin(angle)), axis=1)
    for away, label in ((1e-7, 1), (0.0, 0), (-1e-7, -1)):
        wall = np.column_stack(((0.1 + away) * around, z))
        assert (sw.classify(shape, wall) == label).all()
        out = 0.05 - away
        rim = np.column_stack(((0.15 - out * np.cos(rise))[:, None] * around, HALF + out * np.sin(rise)))
        assert (sw.classify(shape, rim) == label).all()
    closed = sw.OffsetSurface(solids.DrilledBlock(points=6), 0.16)
    assert (sw.classify(closed, np.column_stack((np.zeros((1000, 2)), z))) == 1).all()


def test_the_offset_of_triangles_is_that_of_their_faces():
    """An octahedron's stand 1 / sqrt(3) from its middle, and its corners 1."""
    octahedron = solids.Triangles(
        [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)],
        [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (1, 0, 5), (2, 1, 5), (3, 2, 5), (0, 3, 5)],
    )
    shape, way = sw.OffsetSurface(octahedron, 0.25), np.ones(3) / np.sqrt(3)
    for away, label in ((-1e-7, 1), (0.0, 0), (1e-7, -1)):
        assert sw.classify(shape, [(1 / np.sqrt(3) + 0.25 + away) * way]).tolist() == [label]
        assert sw.classify(shape, [(0, 0, 1.25 + away)]).tolist() == [label]


def test_an_open_surface_has_no_offset():
    triangle = solids.Triangles([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    with pytest.raises(sw.ShapeError, match="^body: must be a solid: a surface has no inside, got 'Triangles'"):
        sw.classify(sw.OffsetSurface(triangle, 0.1), [(0, 0, 0)])


@pytest.mark.thorough
@pytest.mark.parametrize(
    "contour",
    [sw.contours.Ellipse(0.5, 0.3, 8), sw.contours.Superellipse(1.0, 0.6, 4.0, 2), sw.contours.Superellipse(1.0, 0.6)],
)
def test_a_prism_of_a_true_curve_that_moves_across_itself_is_where_the_curve_is(contour):
    """Moved along z it is a longer prism: of it at rest and of it as a moving solid labels are the same."""
    prism = sw.TranslationalSweep(contour, 0.4)
    moved = sw.SweptSolid(prism, sw.trajectories.Line(end=(0, 0, 0.6)))
    points = np.random.default_rng(3).uniform((-0.6, -0.4, -0.1), (0.6, 0.4, 1.1), (10_000, 3))
    n, a, b = getattr(contour, "exponent", 2.0), *contour.section().points.max(axis=0)
    level = (np.abs(points[:, 0] / a) ** n + np.abs(points[:, 1] / b) ** n) ** (1 / n)
    expected = np.where((level < 1) & (np.abs(points[:, 2] - 0.5) < 0.5), 1, -1)
    assert (expected == 1).sum() > 1000
    assert (sw.classify(moved, points) == expected).all()


@pytest.mark.parametrize("exponent", [1.0, 1.5, 2.0, 4.0, 20.0])
def test_places_along_the_normals_of_a_superellipse_are_as_far_from_it(exponent):
    """Outside all the way; inside an ellipse up to the least radius of curvature, b^2 / a."""
    a, b = 2.0, 1.0
    angle = np.random.default_rng(4).uniform(0, 2 * pi, 4000)
    c, s = np.cos(angle), np.sin(angle)
    reach = (np.abs(c) ** exponent + np.abs(s) ** exponent) ** (-1 / exponent)
    places = np.stack((a * reach * c, b * reach * s), axis=1)
    normal = np.stack(
        (np.sign(c) * np.abs(c) ** (exponent - 1) / a, np.sign(s) * np.abs(s) ** (exponent - 1) / b), axis=1
    )
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    for far in (3.0, 0.4, 1e-3, 0.0):
        found = Superdisc((a, b), exponent).distance(*(places + far * normal).T)
        assert np.abs(found - far).max() < 4e-14
    if exponent == 2:
        for far in (0.49, 0.1):
            assert np.abs(Superdisc((a, b), 2.0).distance(*(places - far * normal).T) + far).max() < 4e-14


def test_inside_a_superellipse_the_nearest_of_all_places_counts():
    """Near the diagonal of a square with round corners there are two, one on each side of the corner."""
    places = np.random.default_rng(5).uniform(-1, 1, (300, 2))
    angle = np.linspace(0, pi / 2, 200_001)
    reach = (np.cos(angle) ** 12 + np.sin(angle) ** 12) ** (-1 / 12)
    x, y = reach * np.cos(angle), reach * np.sin(angle)
    places = places[(places**12).sum(axis=1) < 1]
    far = np.array([np.hypot(abs(px) - x, abs(py) - y).min() for px, py in places])
    found = -Superdisc((1.0, 1.0), 12.0).distance(*places.T)
    step = 2 * pi / 2 / 200_000  # along the curve, between places that it is compared with
    assert len(places) > 250 and (found <= far + 1e-15).all() and (found**2 > far**2 - step**2).all()


@pytest.mark.parametrize("exponent, far", [(2.0, 0.06), (2.0, -0.06), (4.0, 0.06), (1.5, 0.06)])
def test_beside_a_prism_of_a_true_curve_on_is_as_far_as_the_tolerance(exponent, far):
    """Also where that is large beside how the curve bends: along its normals, from either side."""
    angle = np.random.default_rng(6).uniform(0, 2 * pi, 2000)
    places, normal = superellipse((0.6, 0.3), exponent, angle)
    prism = sw.TranslationalSweep(sw.contours.Superellipse(1.2, 0.6, exponent, 2), 1.0)
    beside = np.column_stack((places + far * normal, np.full(2000, 0.5)))
    assert (sw.classify(prism, beside, abs(far) + 1e-12) == 0).all()
    assert (sw.classify(prism, beside, abs(far) - 1e-12) == -np.sign(far)).all()
