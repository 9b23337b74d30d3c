# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership of what lies in a plane: sweeps of contours within their own plane, and what discs visit there.

All against formulas, or against many poses of the contour: how far places of the plane are from the set.
"""

from functools import partial
from math import pi

import numpy as np
import pytest
from conftest import FULL
from contour_inputs import superellipse
from line_arc_outlines import inside_by_rays, random_outline

import sweep_addon as sw
from sweep_addon.core.membership.plane.regions import region

contours = sw.contours
WASHER = contours.Outline([[(0.5, 0), (-0.5, 0)], [(0.2, 0), (-0.2, 0)]], [[1, 1], [1, 1]])
HALF = contours.Outline([[(0.5, 0), (-0.5, 0)]], [[1, 0]], closed=False)  # of a circle, open below
STEP = contours.Outline([[(-1.0, 0.0), (-0.5, 0.0), (0.0, 0.5), (0.5, 0.5)]], closed=False)


def sweep(contour, height, direction=(1, 0, 0), **others):
    return sw.TranslationalSweep(contour, height, direction=direction, **others)


def plane(count, low, high, seed=0):
    return np.random.default_rng(seed).uniform(low, high, (count, 2))


def lifted(places, z=0.0):
    return np.column_stack((places, np.broadcast_to(z, len(places))))


def from_segment(p, start, end):
    """How far places are from a segment."""
    way = np.subtract(end, start)
    share = np.clip((p - start) @ way / (way @ way), 0, 1)
    return np.hypot(*(p - start - share[:, None] * way).T)


def stadium(p, length, radius):
    return np.maximum(from_segment(p, (0, 0), (length, 0)) - radius, 0)


def washer(p, length):
    """The stadium of the outer circle, but for the places that stay in the hole: those of its first and its last."""
    ends = np.maximum(*(np.hypot(p[:, 0] - x, p[:, 1]) for x in (0, length)))
    return np.maximum(stadium(p, length, 0.5), 0.2 - ends)


def half_circle(p, length):
    """All that is between its first and its last on each level, and below it what is next to its two feet' ways."""
    x, y = p.T
    half = np.sqrt(np.maximum(0.25 - y**2, 0))
    between = (y >= 0) & (y <= 0.5) & (
        (x >= -half) & (x <= length - half) | (x >= half) & (x <= length + half)
    )  # fmt: skip
    arcs = [np.where(y >= 0, np.abs(np.hypot(x - a, y) - 0.5), np.inf) for a in (0, length)]
    feet = [from_segment(p, (a, 0), (a + length, 0)) for a in (-0.5, 0.5)]
    top = from_segment(p, (0, 0.5), (length, 0.5))
    return np.where(between, 0.0, np.minimum.reduce([*arcs, *feet, top]))


def step(p, length):
    """Two edges along the way, each longer by it, and the parallelogram of the edge between them."""
    x, y = p.T
    first, last = from_segment(p, (-1, 0), (length - 0.5, 0)), from_segment(p, (0, 0.5), (0.5 + length, 0.5))
    sides = [from_segment(p, (a - 0.5, 0), (a, 0.5)) for a in (0, length)]
    within = (y >= 0) & (y <= 0.5) & (x >= y - 0.5) & (x <= y - 0.5 + length)
    return np.where(within, 0.0, np.minimum.reduce([first, last, *sides]))


def rectangle(p, half_x, half_y):
    return np.hypot(np.maximum(np.abs(p[:, 0]) - half_x, 0), np.maximum(np.abs(p[:, 1]) - half_y, 0))


SWEEPS = {
    "disc": (sweep(contours.Circle(0.5, 8), 1.0), lambda p: stadium(p, 1.0, 0.5)),
    "washer": (sweep(WASHER, 0.3), lambda p: washer(p, 0.3)),
    "washer that fills its hole": (sweep(WASHER, 0.5), lambda p: stadium(p, 0.5, 0.5)),
    "half circle": (sweep(HALF, 0.4), lambda p: half_circle(p, 0.4)),
    "half circle upwards": (
        sweep(contours.Outline([[(0, -0.5), (0, 0.5)]], [[1, 0]], closed=False), 0.4, (0, 1, 0)),
        lambda p: half_circle(np.column_stack((p[:, 1], p[:, 0])), 0.4),
    ),
    "step": (sweep(STEP, 0.7), lambda p: step(p, 0.7)),
    "rectangle": (sweep(contours.Rectangle(0.4, 0.6), 0.5), lambda p: rectangle(p - (0.25, 0), 0.45, 0.3)),
    "point and edges": (
        sweep(contours.Mixed([], [[(0, -0.5), (0.3, -0.5)]], [(0, 0.5)]), 0.6),
        lambda p: np.minimum(from_segment(p, (0, -0.5), (0.9, -0.5)), from_segment(p, (0, 0.5), (0.6, 0.5))),
    ),
    "area with a tail": (
        sweep(contours.Mixed([[(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (0, 0.2), (-0.2, 0.2)]],
                             [[(0, 0.2), (0, 0.8)]]), 0.5),
        lambda p: np.minimum(rectangle(p - (0.25, 0), 0.45, 0.2), rectangle(p - (0.25, 0.4), 0.25, 0.4)),
    ),
}  # fmt: skip


@pytest.mark.parametrize("tolerance", [1e-9, 1e-3, 0.1])
@pytest.mark.parametrize("name", SWEEPS)
def test_a_sweep_in_its_plane_is_on_as_far_as_the_tolerance(name, tolerance):
    """Also beside the plane, where the height counts."""
    shape, far = SWEEPS[name]
    p = plane(20_000, -1.3, 1.8)
    z = np.random.default_rng(1).uniform(-1.2 * tolerance, 1.2 * tolerance, len(p)) * (np.arange(len(p)) % 2)
    apart = np.hypot(far(p), z)
    clear = np.abs(apart - tolerance) > 1e-12
    labels = sw.classify(shape, lifted(p, z), tolerance)
    assert (labels == np.where(apart <= tolerance, 0, -1))[clear].all()
    assert (labels == -1).sum() > 1000
    assert tolerance < 1e-6 or (labels == 0).sum() > (4 if name == "point and edges" else 500)


@pytest.mark.parametrize("name", SWEEPS)
def test_where_a_sweep_in_its_plane_ends_is_told_to_a_hundred_millionth(name):
    """Between a place of the set and one a little beside it the border is found by bisection of the formula."""
    shape, far = SWEEPS[name]
    p = plane(40_000, -1.3, 1.8, seed=2)
    inner, outer = (p[far(p) < 0.02], p[far(p) > 0.02])
    count = min(len(inner), len(outer), 1000)
    inner, outer = inner[:count], outer[:count]
    for _ in range(60):
        middle = (inner + outer) / 2
        within = (far(middle) < 0.02)[:, None]
        inner, outer = np.where(within, middle, inner), np.where(within, outer, middle)
    assert count > 200
    assert (sw.classify(shape, lifted(outer), 0.02 + 1e-8) == 0).all()
    assert (sw.classify(shape, lifted(outer), 0.02 - 1e-8) == -1).all()


@pytest.mark.parametrize("direction", [(1, 0, 0), (0, -2, 0), (0.3, 0.7, 0)])
@pytest.mark.parametrize("contour, exponent", [
    (contours.Ellipse(0.6, 0.3, 8), 2.0), (contours.Superellipse(1.2, 0.6, 4.0, 2), 4.0),
    (contours.Superellipse(1.2, 0.6, 1.0, 2), 1.0),
])  # fmt: skip
def test_a_true_curve_sweeps_what_is_before_it_and_behind_it(contour, exponent, direction):
    """Places with normals that lead ahead end on the last curve, others on the first, and so do those beside them."""
    way = 0.5 * np.array(direction[:2]) / np.hypot(*direction[:2])
    angle = np.random.default_rng(3).uniform(0, 2 * pi, 2000)
    places, normal = superellipse((0.6, 0.3), exponent, angle)
    ends = places + np.where((normal @ way > 0)[:, None], way, 0.0)
    shape = sweep(contour, 0.5, direction)
    for away, tolerance in ((0.0, None), (1e-3, 1e-3 + 1e-10), (0.05, 0.05 + 1e-10)):
        assert (sw.classify(shape, lifted(ends + away * normal), tolerance) == 0).all()
    for away, tolerance in ((1e-7, None), (1e-3, 1e-3 - 1e-10), (0.05, 0.05 - 1e-10)):
        assert (sw.classify(shape, lifted(ends + away * normal), tolerance) == -1).all()
    share = np.random.default_rng(4).uniform(0, 1, (2, 2000, 1))
    assert (sw.classify(shape, lifted(share[0] * places + share[1] * way)) == 0).all()


def from_edges(p, vertices, last=None):
    """How far places are from lines and arcs, x, y and bulge: of an arc, those in its sector by the radius."""
    least, edges = np.full(len(p), np.inf), list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))
    for (ax, ay, bulge), (bx, by, _) in edges[:last]:
        a, b = np.array((ax, ay)), np.array((bx, by))
        if not bulge:
            least = np.minimum(least, from_segment(p, a, b))
            continue
        chord = complex(*(b - a))
        centre = complex(*a) + chord / 2 + 1j * chord * (1 - bulge**2) / (4 * bulge)
        radius = abs(chord) * (1 + bulge**2) / (4 * abs(bulge))
        ahead = np.angle((p @ (1, 1j) - centre) / (complex(*a) - centre)) * np.sign(bulge) % (2 * pi)
        ends = np.minimum(np.hypot(*(p - a).T), np.hypot(*(p - b).T))
        on = ahead <= 4 * np.arctan(abs(bulge))
        least = np.minimum(least, np.where(on, np.abs(np.abs(p @ (1, 1j) - centre) - radius), ends))
    return least


def from_area(p, vertices):
    return np.where(inside_by_rays(vertices, p), 0.0, from_edges(p, vertices))


@pytest.mark.thorough
@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("seed", range(6))
def test_a_place_is_as_far_as_it_is_from_the_nearest_pose(seed, closed):
    """Some hundred poses on the way: no place is nearer than to one of them less half a step, nor farther."""
    rng = np.random.default_rng(seed)
    vertices = random_outline(rng)
    outline = contours.Outline([vertices[:, :2]], [vertices[:, 2]], closed=closed)
    size = np.ptp(vertices[:, :2], axis=0).max()
    way = rng.uniform(-0.4, 0.4, 2) * size
    low, high = vertices[:, :2].min(axis=0) - 0.6 * size, vertices[:, :2].max(axis=0) + 0.6 * size
    p, poses = plane(600 if FULL else 450, low, high, seed), 401
    far = from_area if closed else partial(from_edges, last=-1)
    least = np.full(len(p), np.inf)
    for share in np.linspace(0, 1, poses):
        least = np.minimum(least, far(p - share * way, vertices))
    length, error = float(np.hypot(*way)), np.hypot(*way) / (poses - 1) / 2
    shape = sweep(outline, length, (*way, 0))
    for tolerance in (0.01 * size, 0.05 * size):
        labels = sw.classify(shape, lifted(p), tolerance)
        assert (labels[least <= tolerance] == 0).all()
        assert (labels[least > tolerance + error] == -1).all()
        assert (labels == 0).sum() > 10 and (labels == -1).sum() > 60


@pytest.mark.parametrize("directions, low, high", [("up", 0.0, 0.6), ("symmetric", -0.3, 0.3), ("both", -0.2, 0.6)])
def test_the_way_may_lead_both_ways_and_begin_at_any_point_of_the_contour(directions, low, high):
    """A square whose corner moves from the origin."""
    shape = sweep(contours.Rectangle(0.4, 0.4), 0.6, directions=directions, depth=0.2,
                  reference="point", reference_x=-0.2, reference_y=-0.2)  # fmt: skip
    p = plane(5000, -0.5, 1.2)
    inside = (p[:, 0] > low) & (p[:, 0] < high + 0.4) & (p[:, 1] > 0) & (p[:, 1] < 0.4)
    assert (sw.classify(shape, lifted(p)) == np.where(inside, 0, -1)).all()


def test_the_centroid_of_a_contour_may_move_from_the_origin():
    shape = sweep(contours.Outline([[(1, 1), (4, 1), (1, 4)]]), 1.0, (0, 1, 0), reference="centroid")
    p = plane(5000, -2, 4)  # the centroid is at (2, 2)
    x, y = p.T
    inside = (x > -1) & (y > -1) & (x < 2) & (x + y < 2)
    assert (sw.classify(shape, lifted(p)) == np.where(inside, 0, -1)).all()


OFFSET = 0.08
TRUE = {
    "circle": (contours.Circle(0.5, 6), lambda p: np.hypot(*p.T) - 0.5),
    "rectangle": (
        contours.Rectangle(1.0, 0.6),
        lambda p: rectangle(p, 0.5, 0.3) + np.minimum(np.maximum(np.abs(p[:, 0]) - 0.5, np.abs(p[:, 1]) - 0.3), 0),
    ),
    "washer": (WASHER, lambda p: np.abs(np.hypot(*p.T) - 0.35) - 0.15),
    "round corners": (
        contours.Rectangle(1.0, 0.6, rounding=0.2),
        lambda p: rectangle(p, 0.3, 0.1) - 0.2 + np.minimum(
            np.maximum(np.abs(p[:, 0]) - 0.3, np.abs(p[:, 1]) - 0.1), 0),
    ),
}  # fmt: skip
SIDES = {
    "outside": lambda far: far - OFFSET,
    "inside": lambda far: far + OFFSET,
    "shell": lambda far: np.abs(far) - OFFSET,
}


def offset(contour, side):
    return sw.OffsetSurface(contour, OFFSET, side)


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("name", TRUE)
def test_a_disc_visits_what_is_as_near_to_the_boundary_as_its_radius(name, side):
    contour, signed = TRUE[name]
    shape, p = offset(contour, side), plane(20_000, -0.8, 0.8)
    values = SIDES[side](signed(p))
    assert (sw.classify(shape, lifted(p)) == np.where(values <= 0, 0, -1)).all()
    assert (sw.classify(shape, lifted(p, 2e-9)) == -1).all()
    inner, outer = p[values < 0], p[values > 0]
    count = min(len(inner), len(outer), 1000)
    inner, outer = inner[:count], outer[:count]
    for _ in range(60):
        middle = (inner + outer) / 2
        within = (SIDES[side](signed(middle)) < 0)[:, None]
        inner, outer = np.where(within, middle, inner), np.where(within, outer, middle)
    assert count > 300
    assert (sw.classify(shape, lifted(outer)) == 0).all()
    beside = outer + 1e-7 * normals(signed, outer) * np.sign(SIDES[side](signed(outer) + 1e-3))[:, None]
    clear = SIDES[side](signed(beside)) > 5e-8  # no corner is near
    assert clear.sum() > 0.9 * count
    assert (sw.classify(shape, lifted(beside[clear])) == -1).all()


def normals(signed, p):
    axes = 1e-6 * np.eye(2)
    slope = np.stack([signed(p + axis) - signed(p - axis) for axis in axes], axis=1)
    return slope / np.linalg.norm(slope, axis=1, keepdims=True)


@pytest.mark.parametrize("points", [6, 64])
def test_the_offset_of_an_ellipse_is_on_its_normals_however_few_points_it_has(points):
    angle = np.random.default_rng(5).uniform(0, 2 * pi, 2000)
    places = np.stack((0.6 * np.cos(angle), 0.4 * np.sin(angle)), axis=1)
    normal = np.stack((np.cos(angle) / 0.6, np.sin(angle) / 0.4), axis=1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    for side, ends in (("outside", [1]), ("inside", [-1]), ("shell", [1, -1])):
        shape = offset(contours.Ellipse(0.6, 0.4, points), side)
        for end in ends:  # inside, the least radius of curvature is 0.4^2 / 0.6
            leads = -end if side == "inside" else end
            for away, label in ((-1e-7, 0), (0.0, 0), (1e-7, -1)):
                far = end * OFFSET + leads * away
                assert (sw.classify(shape, lifted(places + far * normal)) == label).all()


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("seed", range(4))
def test_the_offset_of_lines_and_arcs_is_by_the_distance_from_them(seed, side):
    vertices = random_outline(np.random.default_rng(seed))
    size = np.ptp(vertices[:, :2], axis=0).max()
    vertices[:, :2] *= 2.0 / size
    contour = contours.Outline([vertices[:, :2]], [vertices[:, 2]])
    p = plane(4000, vertices[:, :2].min(axis=0) - 0.2, vertices[:, :2].max(axis=0) + 0.2, seed)
    signed = from_edges(p, vertices) * np.where(inside_by_rays(vertices, p), -1, 1)
    labels = sw.classify(offset(contour, side), lifted(p))
    assert (labels == np.where(SIDES[side](signed) <= 0, 0, -1)).all()
    assert (labels == 0).sum() > 100 and (labels == -1).sum() > 100


def test_curves_without_an_equation_have_an_arc_over_each_chord():
    """As the boundary of their offset has: the ends of its lines and arcs are on, and no wider ones."""
    pytest.importorskip("manifold3d", reason="the boundary of an offset is asked of manifold3d")
    contour = contours.Aerofoil("4412", 1.0, 0.4)
    outline = offset(contour, "outside").outline()
    corners, _, bulges = outline.edges()
    assert np.count_nonzero(bulges) > 50
    shape = offset(contour, "outside")
    assert (sw.classify(shape, lifted(corners), 1e-6) == 0).all()
    region = outline.section()
    ahead = region.points[region.following] - region.points
    right = np.column_stack((ahead[:, 1], -ahead[:, 0])) / np.hypot(*ahead.T)[:, None]
    tops = outline.apexes()
    assert (sw.classify(shape, lifted(tops + 1e-5 * right), 1e-6) == -1).all()
    assert (sw.classify(shape, lifted(tops - 1e-5 * right), 1e-6) == 0).all()


@pytest.mark.parametrize("ask, sentence", [
    (lambda: sw.OffsetSurface(HALF, 0.1), "body: must be closed, a solid or the boundary of an area, got "),
    (lambda: offset(contours.Rectangle(0.1, 2.0), "inside"), "radius: must leave something of the area inside, got "),
    (lambda: sweep(WASHER, 1.0, regularize=True), "regularize: must be off where no part is solid"),
])  # fmt: skip
def test_what_has_no_mesh_in_the_plane_has_no_points_either(ask, sentence):
    with pytest.raises(sw.ShapeError) as refused:
        sw.classify(ask(), [(0, 0, 0)])
    assert str(refused.value).startswith(sentence)


def test_single_points_sweep_lines_and_nothing_between_them():
    shape = sw.TranslationalSweep(contours.Mixed([], [], [(0, 0), (1, 0), (1, 1)]), 1.0)
    asked = [(0, 0, 0.5), (1, 0, 1), (0.5, 0, 0.5), (0.5, 0.5, 0.5), (1, 1, 0), (0, 0, 1.1)]
    assert sw.classify(shape, asked).tolist() == [0, 0, -1, -1, 0, -1]


@pytest.mark.thorough
@pytest.mark.parametrize("corners", [300, 3000])
def test_contours_of_many_corners_are_told_in_their_plane(corners):
    """A wavy ring, of which only cells near where the sweep ends are asked."""
    angle = 2 * pi * np.arange(corners) / corners
    wavy = 1 + 0.1 * np.sin(30 * angle)
    outline = contours.Outline([np.stack((wavy * np.cos(angle), wavy * np.sin(angle)), axis=1)])
    p = plane(20_000 if FULL else 6_000, -1.3, 2.3)

    def inside(q):
        return np.hypot(*q.T) < 1 + 0.1 * np.sin(30 * np.arctan2(q[:, 1], q[:, 0]))

    visited = np.any([inside(p - (x, 0)) for x in np.linspace(0, 1, 401)], axis=0)
    labels = sw.classify(sweep(outline, 1.0), lifted(p), 1e-6)
    differs = np.flatnonzero(labels != np.where(visited, 0, -1))
    assert len(differs) < 3e-3 * len(p)
    for place in p[differs]:  # between two poses, or between a chord and its curve
        near = place + 8e-3 * np.stack((np.cos(angle), np.sin(angle)), axis=1)
        around = np.any([inside(near - (x, 0)) for x in np.linspace(0, 1, 401)], axis=0)
        assert around.any() and not around.all()


INNER = {  # radii of the largest circles in them
    "circle": (contours.Circle(0.5, 6), 0.5),
    "ellipse": (contours.Ellipse(0.6, 0.4, 6), 0.4),
    "rectangle": (contours.Rectangle(1.0, 0.6), 0.3),
    "washer": (WASHER, 0.15),
    "triangle": (contours.Outline([[(0, 0), (3, 0), (0, 4)]]), 1.0),
    "bracket": (contours.Outline([[(0, 0), (3, 0), (3, 1), (1, 1), (1, 4), (0, 4)]]), 2 - np.sqrt(2)),
    "half a disc": (contours.Outline([[(0, -1), (0, 1)]], [[1, 0]]), 0.5),
}


@pytest.mark.parametrize("name", INNER)
def test_an_offset_inside_is_refused_where_it_is_more_than_the_largest_circle(name):
    """But for a thousandth, in which a ridge is not followed all along: then all points are out."""
    contour, radius = INNER[name]
    left = sw.OffsetSurface(contour, radius * (1 - 1e-9), "inside")
    assert (sw.classify(left, lifted(plane(2000, -0.1, 0.1))) <= 0).all()
    with pytest.raises(sw.ShapeError, match="^radius: must leave something of the area inside, got "):
        sw.classify(sw.OffsetSurface(contour, radius * (1 + 1e-3), "inside"), [(0, 0, 0)])


PLANAR = ("mixed_dimension_dangling_edges", "mixed_dimension_joined_by_an_edge")


@pytest.mark.parametrize("name", PLANAR)
def test_the_meshes_of_the_lecture_s_sweeps_in_a_plane_are_on(name):
    """Vertices and middles of edges, also of loose ones, within what chords leave; a little beside the mesh nothing."""
    shape = sw.presets.shape(name)
    mesh = shape.mesh()
    ends = mesh.vertices[mesh.edges]
    assert (sw.classify(shape, mesh.vertices, 2e-6) == 0).all()
    assert (sw.classify(shape, ends.mean(axis=1), 1e-3) == 0).all()
    assert (sw.classify(shape, mesh.vertices + (0, 0, 1e-5), 2e-6) == -1).all()
    loose = mesh.edges[np.bincount(mesh.topology.corner_edges, minlength=len(mesh.edges)) == 0]
    beside = mesh.vertices[loose].mean(axis=1) + (0, 1e-5, 0)
    assert len(loose) and (sw.classify(shape, beside, 2e-6) == -1).all()


def test_what_lies_in_a_plane_may_be_placed_and_moved():
    strip = sweep(contours.Rectangle(0.2, 0.4), 1.0)  # from x -0.1 to 1.1, y -0.2 to 0.2
    p = np.random.default_rng(7).uniform((-0.3, -0.4, -0.2), (1.3, 0.4, 0.7), (5000, 3))
    inside = (np.abs(p[:, 0] - 0.5) < 0.6) & (np.abs(p[:, 1]) < 0.2) & (p[:, 2] > 0) & (p[:, 2] < 0.5)
    moved = sw.SweptSolid(strip, sw.trajectories.Line(end=(0, 0, 0.5)))
    assert (sw.classify(moved, p) == np.where(inside, 1, -1)).all()
    upright = sw.Placed(strip, [(1, 0, 0, 0), (0, 0, -1, 0.2), (0, 1, 0, 0)])  # its plane becomes y = 0.2
    flat = p * (1, 0, 1) + (0, 0.2, 0)
    within = (np.abs(p[:, 0] - 0.5) < 0.6) & (np.abs(p[:, 2]) < 0.2)
    assert (sw.classify(upright, flat) == np.where(within, 0, -1)).all()
    assert (sw.classify(upright, p) == -1).all()


KEYHOLE = np.array(
    [(-0.2, -1.0, 0.0), (0.2, -1.0, 0.0), (0.2, 0.0, 2.5), (-0.2, 0.0, 0.0)]
)  # most of a circle on a bar
BITTEN = np.array(
    [(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 2.0, 0.0), (0.3, 2.0, -2.0), (-0.3, 2.0, 0.0), (-1.0, 2.0, 0)]
)


@pytest.mark.parametrize(
    "vertices", [KEYHOLE, BITTEN, *(random_outline(np.random.default_rng(k)) for k in (20, 21, 22))]
)
def test_a_prism_of_lines_and_arcs_is_as_far_as_its_contour(vertices):
    """As the solids that move and trees ask it, with arcs of more than half a turn, and on lines through corners."""
    size = np.ptp(vertices[:, :2], axis=0)
    low = vertices[:, :2].min(axis=0)
    p = plane(4000, low - 0.8 * size, low + 1.8 * size)
    p[:400, 1], p[400:800, 0] = vertices[np.arange(400) % len(vertices), 1], vertices[np.arange(400) % len(vertices), 0]
    found = region(contours.Outline([vertices[:, :2]], [vertices[:, 2]])).distance(*p.T)
    np.testing.assert_allclose(np.abs(found), from_edges(p, vertices), atol=1e-12)
    clear = np.abs(found) > 1e-8
    beside = p + 1e-9  # a ray along the line of a corner would meet two edges there, or none
    assert np.array_equal((found < 0)[clear], inside_by_rays(vertices, beside)[clear])
