# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership against solids that are known by a formula: no point is wrong, wherever it is.

Each formula is the distance from the solid, or less, with its sign: a point is on where it is 0 to rounding.
"""

from math import pi

import numpy as np
import pytest

import sweep_addon as sw

HALF_DISC = sw.contours.Outline([[(0, -1), (0, 1)]], bulges=[[1, 0]])
TORUS = sw.GeneralizedCylinder(sw.contours.Circle(0.5), sw.trajectories.Arc(2.0, 2 * pi))
SPINDLE = sw.GeneralizedCylinder(sw.contours.Circle(0.45), sw.trajectories.Arc(0.3, 2 * pi))
BALL = sw.RotationalSweep(HALF_DISC)
CONE = sw.GeneralizedCylinder(
    sw.contours.Circle(1.0), sw.trajectories.Line(end=(0, 0, 2)), scale_x="1 - t", scale_y="1 - t"
)
ELL = sw.TranslationalSweep(sw.contours.Outline(), 2.0)
FRUSTUM = sw.TranslationalSweep(sw.contours.Rectangle(2.0, 2.0), 1.0, taper=0.3)
ELBOW = sw.GeneralizedCylinder(
    sw.contours.Rectangle(0.4, 0.2), sw.trajectories.Polyline([(0, 0, 0), (2, 0, 0), (2, 2, 0)])
)
FRAME = sw.GeneralizedCylinder(
    sw.contours.Circle(0.2), sw.trajectories.Polyline([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)], closed=True)
)
PILL = sw.GeneralizedCylinder(sw.contours.Circle(0.5), sw.trajectories.Line(end=(0, 0, 2)), start="round", end="round")
CUT = sw.PDCurveSweep(
    sw.contours.Rectangle(0.4, 0.2),
    sw.trajectories.Line(end=(0, 0, 4)),
    sw.directions.Arrows(),
    sw.limits.Plane((0, 0, -0.5), (1, 0, 2)),
    sw.limits.Plane((0, 0, 4.5), (-1, 2, 3)),
)
CANAL = sw.CanalSurface(sw.trajectories.Line(end=(0, 0, 2)), "0.3 + 0.5*s")
OBLIQUE = sw.GeneralSweep(sw.contours.Rectangle(1.0, 1.0), sw.trajectories.Line(end=(1, 0, 2)))
SCREW = sw.RotationalSweep(sw.contours.Outline([[(1, 0), (2, 0), (2, 0.5), (1, 0.5)]]), angle=6 * pi, pitch=0.5)
DRILLED = sw.solids.Block(2.0, 2.0, 1.0) - sw.solids.Cylinder(0.5, 3.0)
MOVED_BLOCK = sw.SweptSolid(sw.solids.Block(1.0, 1.0, 1.0), sw.trajectories.Line(end=(0, 0, 2)))
MOVED_BALL = sw.SweptSolid(sw.solids.Ball(0.5), sw.trajectories.Line(end=(0, 0, 2)))
TURNED = sw.SweptSolid(  # at the corner it turns at once, from lying along x to lying along y
    sw.solids.Block(0.2, 0.2, 0.6),
    sw.RigidMotion(sw.trajectories.Polyline([(0, 0, 0), (2, 0, 0), (2, 2, 0)]), sw.frames.FixedUp()),
)
MOVED_TWICE = sw.SweptSolid(
    sw.SweptSolid(sw.solids.Block(0.4, 0.4, 0.4), sw.trajectories.Line(end=(1, 0, 0))),
    sw.trajectories.Line(end=(0, 1, 0)),
)
MESH = sw.solids.Triangles.of(sw.solids.Block(1.0, 1.0, 1.0).mesh())
OFFSET = sw.OffsetSurface(sw.solids.Block(1.0, 1.0, 1.0), 0.2)


def ring(radius, tube):
    return lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - radius, p[:, 2]) - tube


def box(low, high):
    return lambda p: np.maximum(np.array(low) - p, p - np.array(high)).max(axis=1)


def beyond(point, normal):
    normal = np.array(normal) / np.linalg.norm(normal)
    return lambda p: (p - point) @ normal


def all_of(*sets):
    return lambda p: np.max([each(p) for each in sets], axis=0)


def any_of(*sets):
    return lambda p: np.min([each(p) for each in sets], axis=0)


def spindle(p):
    across, up = np.hypot(p[:, 0], p[:, 1]), p[:, 2]
    return np.minimum(np.hypot(across - 0.3, up), np.hypot(across + 0.3, up)) - 0.45


def cone(p):
    return np.maximum(np.hypot(p[:, 0], p[:, 1]) - (1 - p[:, 2] / 2), np.maximum(-p[:, 2], p[:, 2] - 2))


def pill(p):
    return np.linalg.norm(p - (0, 0, 1) * np.clip(p[:, 2:], 0, 2), axis=1) - 0.5


def square_frame(p):
    return np.hypot(np.abs(p[:, :2] - 1).max(axis=1) - 1, p[:, 2]) - 0.2


def cone_of_balls(p):
    """The ball that is nearest to touching stands by the sine of the cone's angle, 0.5, farther on."""
    across = np.hypot(p[:, 0], p[:, 1])
    s = np.clip(p[:, 2] + 0.5 * across / np.sqrt(0.75), 0, 2)
    return np.hypot(across, p[:, 2] - s) - 0.3 - 0.5 * s


def rounded_block(p):
    return np.linalg.norm(np.maximum(np.abs(p) - 0.5, 0), axis=1) - 0.2


def screwed(p):
    """Turns of half a metre follow each other without a gap: within the ends all that is 1 to 2 m from the axis."""
    angle = np.arctan2(-p[:, 2], p[:, 0]) % (2 * pi)
    along = p[:, 1] - 0.5 * angle / (2 * pi)  # of the first turn from 0 to 0.5, of the last to 1.5
    across = np.hypot(p[:, 0], p[:, 2])
    return np.maximum.reduce([1 - across, across - 2, -along, along - 1.5])


SHRINKING = sw.GeneralSweep(
    sw.contours.Region("x^2 + y^2 - (0.2 - 0.1*t)^2", size=0.5), sw.trajectories.Line(end=(0, 0, 2))
)

SOLIDS = {
    "region of a formula": (
        SHRINKING,
        lambda p: np.maximum(np.hypot(p[:, 0], p[:, 1]) - 0.2 + 0.05 * p[:, 2], np.abs(p[:, 2] - 1) - 1),
        np.array((0.3, 0.3, 2.2)),
    ),
    "torus": (TORUS, ring(2.0, 0.5), 2.6),
    "spindle torus": (SPINDLE, spindle, 0.8),
    "sphere as a revolved half disc": (BALL, lambda p: np.linalg.norm(p, axis=1) - 1, 1.2),
    "cone by a taper to a point": (CONE, cone, 2.1),
    "extruded L": (ELL, any_of(box((-0.5, -0.5, 0), (0.5, -0.3, 2)), box((-0.5, -0.5, 0), (-0.3, 0.5, 2))), 2.1),
    "frustum": (
        FRUSTUM,
        lambda p: np.maximum(np.abs(p[:, :2]).max(axis=1) - 1 + np.tan(0.3) * p[:, 2], np.abs(p[:, 2] - 0.5) - 0.5),
        1.2,
    ),
    "elbow": (ELBOW, any_of(box((0, -0.2, -0.1), (2.2, 0.2, 0.1)), box((1.8, -0.2, -0.1), (2.2, 2, 0.1))), 2.4),
    "closed frame": (FRAME, square_frame, 2.4),
    "round ends": (PILL, pill, 2.7),
    "between planes": (
        CUT,
        all_of(
            box((-0.2, -0.1, -9), (0.2, 0.1, 9)), beyond((0, 0, -0.5), (-1, 0, -2)), beyond((0, 0, 4.5), (-1, 2, 3))
        ),
        np.array((0.3, 0.2, 5.0)),
    ),
    "canal": (CANAL, cone_of_balls, 3.5),
    "oblique": (
        OBLIQUE,
        lambda p: np.maximum.reduce(
            [-p[:, 2], p[:, 2] - 2, np.abs(p[:, 0] - p[:, 2] / 2) - 0.5, np.abs(p[:, 1]) - 0.5]
        ),
        2.2,
    ),
    "screw": (SCREW, screwed, 2.2),
    "drilled block": (
        DRILLED,
        all_of(box((-1, -1, -0.5), (1, 1, 0.5)), lambda p: 0.5 - np.hypot(p[:, 0], p[:, 1])),
        1.2,
    ),
    "moving block": (MOVED_BLOCK, box((-0.5, -0.5, -0.5), (0.5, 0.5, 2.5)), 2.7),
    "moving ball": (MOVED_BALL, pill, 2.7),
    "moving block that turns at once": (
        TURNED,
        any_of(box((-0.3, -0.1, -0.1), (2.3, 0.1, 0.1)), box((1.9, -0.3, -0.1), (2.1, 2.3, 0.1))),
        2.5,
    ),
    "mesh": (MESH, box((-0.5,) * 3, (0.5,) * 3), 0.8),
    "offset": (OFFSET, rounded_block, 0.9),
}


@pytest.mark.parametrize("count", [20_000, pytest.param(1_000_000, marks=pytest.mark.large)])
@pytest.mark.parametrize("name", SOLIDS)
def test_no_point_is_wrong(name, count):
    shape, distance, reach = SOLIDS[name]
    points = np.random.default_rng(0).uniform(-reach, reach, (count, 3))
    assert (sw.classify(shape, points) == np.sign(-distance(points))).all()


@pytest.mark.parametrize("name", SOLIDS)
def test_points_on_the_boundary_are_on(name):
    """Found on segments from in to out by bisection of the formula; the tolerance is what that leaves."""
    shape, distance, reach = SOLIDS[name]
    points = np.random.default_rng(1).uniform(-reach, reach, (80_000, 3))
    inner, outer = points[distance(points) < 0], points[distance(points) > 0]
    count = min(len(inner), len(outer), 200)
    inner, outer = inner[:count], outer[:count]
    for _ in range(60):
        middle = (inner + outer) / 2
        inside = (distance(middle) < 0)[:, None]
        inner, outer = np.where(inside, middle, inner), np.where(inside, outer, middle)
    assert count > 50
    assert (sw.classify(shape, outer, tolerance=1e-8) == 0).all()


def disc(count, radius, seed=2):
    """Points of a disc, evenly."""
    rng = np.random.default_rng(seed)
    points = np.sqrt(rng.uniform(0, radius**2, count)) * np.exp(2j * pi * rng.uniform(size=count))
    return points.view(float).reshape(-1, 2)


def test_the_plane_in_which_a_closed_trajectory_begins_is_no_end():
    """By rule 4 of the lecture all of it would be on."""
    x, z = disc(731, 0.499).T
    seam = np.stack((2 + x, np.zeros(731), z), axis=1)
    assert (sw.classify(TORUS, seam) == 1).all()


def test_the_plane_in_which_an_open_trajectory_begins_is_one():
    x, z = disc(500, 0.499).T
    half = sw.GeneralizedCylinder(sw.contours.Circle(0.5), sw.trajectories.Arc(2.0, pi))
    assert (sw.classify(half, np.stack((2 + x, np.zeros(500), z), axis=1)) == 0).all()


@pytest.mark.thorough
@pytest.mark.parametrize("shape, most", [(BALL, 1.0), (SPINDLE, np.sqrt(0.45**2 - 0.3**2))])
def test_points_on_the_axis_of_a_rotation_are_in(shape, most):
    """Every plane passes through them: by rule 2, Q on the contour of a half disc, they would be on."""
    along = np.linspace(-most, most, 1001)[1:-1]
    points = np.zeros((999, 3))
    points[:, 2] = along
    if shape is BALL and not BALL.upright:
        points = points[:, [0, 2, 1]]
    assert (sw.classify(shape, points) == 1).all()


def test_points_on_the_axis_of_a_partial_rotation_are_on():
    """A quarter of a ball has its edge there."""
    points = np.zeros((99, 3))
    points[:, 2 if BALL.upright else 1] = np.linspace(-0.9, 0.9, 99)
    assert (sw.classify(sw.RotationalSweep(HALF_DISC, angle=pi / 2), points) == 0).all()


def test_where_two_covers_touch_points_are_in():
    """The turns of a screw whose thread is as high as its pitch: Q is on the contour twice, and P is in."""
    angle, across = np.random.default_rng(3).uniform((0.1, 1.01), (2 * pi, 1.99), (500, 2)).T
    met = np.stack((across * np.cos(angle), 0.5 * angle / (2 * pi) + 0.5, -across * np.sin(angle)), axis=1)
    assert (sw.classify(SCREW, met) == 1).all()


def test_double_roots_are_found():
    """A disc that stays upright on its way round a circle: the lecture's fixed orientation.

    At the top and at the bottom of the circle its plane touches: there all that it passes it passes twice.
    """
    disc_round = sw.GeneralSweep(sw.contours.Circle(0.3), sw.trajectories.Formula("cos(u)", "0", "sin(u)", 0, 2 * pi))
    points = np.random.default_rng(4).uniform(-1.4, 1.4, (20_000, 3))
    points[:2000, 2] = np.linspace(-1, 1, 2000)
    x, y, z = points.T
    inside = np.abs(z) <= 1
    c = np.sqrt(np.maximum(1 - z**2, 0))
    far = np.minimum(np.hypot(x - c, y), np.hypot(x + c, y)) - 0.3
    sure = np.abs(far) > 1e-6
    sure &= np.abs(np.abs(z) - 1) > 1e-6
    assert (sw.classify(disc_round, points) == np.where(inside & (far < 0), 1, -1))[sure].all()


def test_no_membrane_is_left_between_boxes_that_share_a_face():
    block = sw.solids.Block(1.0, 1.0, 1.0)
    y, z = np.random.default_rng(5).uniform(-0.49, 0.49, (2, 500))
    shared = np.stack((np.full(500, 0.5), y, z), axis=1)
    assert (sw.classify(block | block.moved(x=1.0), shared) == 1).all()
    assert (sw.classify(block & block.moved(x=1.0), shared) == -1).all()
    assert (sw.classify(block - block.moved(x=1.0), shared) == 0).all()
    assert (sw.classify(block - block, shared) == -1).all()


def test_a_mitre_is_no_boundary():
    """Both legs end in the bisector plane, which is within the solid."""
    y, z = np.random.default_rng(6).uniform((-0.19, -0.09), (0.19, 0.09), (500, 2)).T
    assert (sw.classify(ELBOW, np.stack((2 - y, y, z), axis=1)) == 1).all()


@pytest.mark.parametrize("name", ["torus", "spindle torus", "elbow", "round ends", "canal", "drilled block", "screw"])
def test_labels_do_not_depend_on_where_all_is(name):
    shape, distance, reach = SOLIDS[name]
    points = np.random.default_rng(7).uniform(-reach, reach, (5_000, 3))
    turn = np.linalg.qr(np.random.default_rng(8).normal(size=(3, 3)))[0]
    by = np.array((3.0, -2.0, 5.0))
    placed = sw.Placed(shape, np.column_stack((turn, by)))
    assert (sw.classify(placed, points @ turn.T + by) == np.sign(-distance(points))).all()


def helix(u="u"):
    return sw.trajectories.Formula(f"cos({u})", f"sin({u})", f"0.1*({u})", 0, 12)


@pytest.mark.parametrize(
    "other",
    [
        sw.trajectories.Formula("cos(u^2)", "sin(u^2)", "0.1*u^2", 0, np.sqrt(12)),
        sw.trajectories.Formula("cos(12 - u)", "sin(12 - u)", "0.1*(12 - u)", 0, 12),
    ],
    ids=["reparametrized", "reversed"],
)
def test_labels_do_not_depend_on_how_a_trajectory_is_run(other):
    points = np.random.default_rng(9).uniform((-1.4, -1.4, -0.3), (1.4, 1.4, 1.5), (20_000, 3))
    labels = [sw.classify(sw.GeneralizedCylinder(sw.contours.Circle(0.25), path), points) for path in (helix(), other)]
    assert (labels[0] == labels[1]).all()
    assert (labels[0] == 1).sum() > 1000


def test_the_parts_of_a_way_make_the_whole():
    whole = sw.GeneralizedCylinder(sw.contours.Circle(0.25), helix())
    parts = [
        sw.GeneralizedCylinder(sw.contours.Circle(0.25), sw.trajectories.Formula("cos(u)", "sin(u)", "0.1*u", *ends))
        for ends in ((0, 5), (5, 12))
    ]
    points = np.random.default_rng(10).uniform((-1.4, -1.4, -0.3), (1.4, 1.4, 1.5), (20_000, 3))
    labels = sw.classify(whole, points)
    assert (sw.classify(parts[0] | parts[1], points) == labels).all()


def test_de_morgan():
    a, b, whole = TORUS, sw.solids.Block(3.0, 3.0, 0.6), sw.solids.Block(9.0, 9.0, 9.0)
    points = np.random.default_rng(11).uniform(-2.6, 2.6, (20_000, 3))
    assert (sw.classify(whole - (a | b), points) == sw.classify((whole - a) & (whole - b), points)).all()
    assert (sw.classify(whole - (a & b), points) == sw.classify((whole - a) | (whole - b), points)).all()
    assert (sw.classify(a | a, points) == sw.classify(a, points)).all()


def test_sweeping_is_of_each_part_of_a_union_and_not_of_an_intersection():
    """Both have a common part aside; what else they visit one after the other is not visited by any common point."""
    block, aside = sw.solids.Block(0.5, 0.5, 0.5), sw.solids.Block(0.5, 0.5, 0.5).moved(z=1.0)
    a, b = block | aside, block.moved(x=1.0) | aside
    along = sw.trajectories.Line(end=(2, 0, 0))
    points = np.random.default_rng(12).uniform((-0.4, -0.3, -0.4), (3.4, 0.3, 1.4), (10_000, 3))

    def labels(tree):
        return sw.classify(tree, points, tolerance=1e-6)

    moved_a, moved_b = sw.SweptSolid(a, along), sw.SweptSolid(b, along)
    assert (labels(sw.SweptSolid(a | b, along)) == labels(moved_a | moved_b)).all()
    both, each = labels(sw.SweptSolid(a & b, along)), labels(moved_a & moved_b)
    assert (each[both == 1] == 1).all() and (both == 1).any()
    assert (both[each == 1] == -1).any()  # strictly less


def test_a_moving_tree_is_told_within_the_tolerance():
    """A drilled block on a screw, against all that Monte-Carlo poses of it visit and a bound beyond which none do."""
    motion = sw.RigidMotion(sw.trajectories.Line(end=(0, 0, 2)), turn_z="2*pi*t")
    tree = sw.solids.Block(1.0, 0.4, 0.3) - sw.solids.Cylinder(0.1, 1.0)
    points = np.random.default_rng(13).uniform((-0.6, -0.6, -0.3), (0.6, 0.6, 2.3), (3_000, 3))
    times = np.linspace(0, 1, 4001)
    least = np.full(len(points), np.inf)
    for t in times:
        c, s = np.cos(2 * pi * t), np.sin(2 * pi * t)
        x, y, z = points[:, 0] * c + points[:, 1] * s, points[:, 1] * c - points[:, 0] * s, points[:, 2] - 2 * t
        block = np.maximum.reduce([np.abs(x) - 0.5, np.abs(y) - 0.2, np.abs(z) - 0.15])
        least = np.minimum(least, np.maximum(block, 0.1 - np.hypot(x, y)))
    error = 0.5 / 4000 * np.hypot(2, 2 * pi * 0.85)  # what a point moves in half a step
    labels = sw.classify(sw.SweptSolid(tree, motion), points, tolerance=1e-3)
    assert (labels[least < -1e-3 - error] == 1).all()
    assert (labels[least > 1e-3 + error] == -1).all()


@pytest.mark.thorough
def test_a_ball_that_grows_as_it_moves_leaves_a_cone():
    """The envelope of balls of radius 0.3 + 0.25 s is a cone with two caps, of polyhedra nearly so."""
    ball = sw.solids.Triangles.of(sw.solids.Ball(0.3, 256).mesh())
    growing = {f"scale_{axis}": "1 + t/0.6" for axis in "xyz"}
    sweep = sw.GeneralSweep(ball, sw.trajectories.Line(end=(0, 0, 2)), cells=48, **growing)
    points = np.random.default_rng(14).uniform((-1, -1, -0.5), (1, 1, 3), (5_000, 3))
    across, z = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
    s = np.clip(z + 0.25 * across / np.sqrt(1 - 0.25**2), 0, 2)
    far = np.hypot(across, z - s) - 0.3 - 0.25 * s
    sure = np.abs(far) > 2e-3  # the ball is a polyhedron
    assert (sw.classify(sweep, points) == np.sign(-far))[sure].all()


def test_a_moving_solid_may_be_moved_as_a_whole():
    points = np.random.default_rng(14).uniform((-0.4, -0.4, -0.4), (1.4, 1.4, 0.4), (300, 3))
    distance = box((-0.2, -0.2, -0.2), (1.2, 1.2, 0.2))(points)
    away = np.abs(distance) > 0.02
    labels = sw.classify(MOVED_TWICE, points[away], tolerance=1e-3)
    assert (labels == np.sign(-distance[away])).all()


@pytest.mark.parametrize(
    "ask, sentence",
    [
        (lambda: sw.classify(TORUS, [1, 2, 3]), "points: must be rows of three numbers, got [1, 2, 3]"),
        (lambda: sw.classify(TORUS, None), "points: must be rows of three numbers, got None"),
        (lambda: sw.classify(TORUS, [(0, 0, float("nan"))]), "points: must be finite, got [[0.0, 0.0, nan]]"),
        (
            lambda: sw.classify(TORUS, [(0, 0, 0)], tolerance=0),
            "tolerance: must be a number of metres, more than 0, got 0",
        ),
        (
            lambda: sw.classify(TORUS, [(0, 0, 0)], tolerance="x"),
            "tolerance: must be a number of metres, more than 0, got ",
        ),
        (lambda: sw.classify(TORUS, [(0, 0, 0)], tolerance=5.0), "tolerance: must be at most 0.7"),
        (lambda: sw.classify([TORUS, TORUS], [(0, 0, 0)]), "shape: must be a shape, a solid or a tree, got "),
        (lambda: sw.classify(3, [(0, 0, 0)]), "shape: must be a shape, a solid or a tree, got 3"),
        (
            lambda: sw.classify(BALL - sw.GeneralizedCylinder(start="open"), [(0, 0, 0)]),
            "steps.1.operand: must be a solid: a surface has no inside, got 'Generalized Cylinder'",
        ),
        (lambda: sw.inverse_sweep(CANAL, [(0, 0, 0)]), "shape: must be the sweep of a contour, out of its plane, got "),
    ],
)
def test_what_has_no_inside_is_refused(ask, sentence):
    with pytest.raises(sw.ShapeError) as refused:
        ask()
    assert str(refused.value).startswith(sentence)


def test_inverse_sweep_tells_all_planes_through_a_point():
    """The plane of a helix passes through points of its axis once in each half turn: sin of the angle between is 0."""
    path = sw.trajectories.Helix(radius=1.0, pitch=0.5, turns=3.0)
    found = sw.inverse_sweep(sw.GeneralizedCylinder(sw.contours.Circle(0.1), path), [(1.5, 0.0, 0.0), (0.0, 2.0, 0.1)])
    c = 0.5 / (2 * pi)
    for number, (x, y, z) in enumerate([(1.5, 0.0, 0.0), (0.0, 2.0, 0.1)]):
        u = found.of(number)
        assert len(u) >= 6
        assert np.abs(-x * np.sin(u) + y * np.cos(u) + c * (z - c * u)).max() < 1e-9  # across the tangent
        dense = np.linspace(0, 6 * pi, 100_001)
        values = -x * np.sin(dense) + y * np.cos(dense) + c * (z - c * dense)
        assert len(u) == np.count_nonzero(np.diff(np.sign(values)))


@pytest.mark.parametrize("tolerance", [1e-6, 1e-3, 0.05])
@pytest.mark.parametrize(
    "name", ["extruded L", "torus", "elbow", "closed frame", "canal", "cone by a taper to a point"]
)
def test_what_is_nearer_than_the_tolerance_is_on_from_either_side(name, tolerance):
    """Along straight ways through the surface, across it: a little nearer is on, a little farther in or out."""
    shape, distance, reach = SOLIDS[name]
    random = np.random.default_rng(15)
    points = random.uniform(-reach, reach, (40_000, 3))
    inner, outer = points[distance(points) < 0], points[distance(points) > 0]
    count = min(len(inner), len(outer), 300)
    inner, outer = inner[:count], outer[:count]
    for _ in range(60):
        middle = (inner + outer) / 2
        inside = (distance(middle) < 0)[:, None]
        inner, outer = np.where(inside, middle, inner), np.where(inside, outer, middle)
    step = 1e-6 * np.eye(3)
    slope = np.stack([distance(outer + axis) - distance(outer - axis) for axis in step], axis=1)
    normal = slope / np.linalg.norm(slope, axis=1, keepdims=True)
    away = np.stack([distance(outer + part * tolerance * normal) for part in (1.2, 0.8, -0.8, -1.2)])
    plain = (np.abs(away / tolerance - np.array([[1.2], [0.8], [-0.8], [-1.2]])) < 0.05).all(axis=0)  # no edge is near
    assert plain.sum() > count / 4
    for part, label in ((1.2, -1), (0.8, 0), (-0.8, 0), (-1.2, 1)):
        found = sw.classify(shape, (outer + part * tolerance * normal)[plain], tolerance)
        assert (found == label).all()


def test_within_a_union_a_large_tolerance_leaves_what_is_in():
    block = sw.TranslationalSweep(sw.contours.Rectangle(2.0, 1.0), height=0.6)
    union = block | block.moved(z=0.6)
    points = [(0, 0, 0.6), (0, 0, 0.55), (0, 0, 0.6005), (0, 0, 1.2005), (0, 0, 1.1)]
    for tolerance, on in ((1e-3, [1, 1, 1, 0, 1]), (0.1, [1, 1, 1, 0, 0])):
        assert sw.classify(union, points, tolerance).tolist() == on


@pytest.mark.parametrize("corners", [500, 20_000])
def test_contours_of_many_corners_are_told_soon(corners):
    angle = 2 * pi * np.arange(corners) / corners
    wavy = 1 + 0.1 * np.sin(50 * angle)
    outline = sw.contours.Outline([np.stack((wavy * np.cos(angle), wavy * np.sin(angle)), axis=1)])
    points = np.random.default_rng(16).uniform((-1.2, -1.2, -0.5), (1.2, 1.2, 1.5), (20_000, 3))
    around = np.arctan2(points[:, 1], points[:, 0])
    across = np.hypot(points[:, 0], points[:, 1]) - 1 - 0.1 * np.sin(50 * around)
    sure = np.abs(across) > (2e-2 if corners < 1000 else 1e-4)
    inside = (across < 0) & (np.abs(points[:, 2] - 0.5) < 0.5)
    assert (sw.classify(sw.TranslationalSweep(outline, 1.0), points) == np.where(inside, 1, -1))[sure].all()


def test_no_points_have_no_labels_and_no_images():
    assert len(sw.classify(TORUS, np.empty((0, 3)))) == len(sw.inverse_sweep(TORUS, np.empty((0, 3))).u) == 0


def test_the_slope_of_a_surface_counts_in_what_is_on():
    """Beside a cone of half a right angle a point is nearer to the surface than in the contour's plane."""
    steep = sw.GeneralizedCylinder(sw.contours.Circle(1.0), sw.trajectories.Line(), scale_x="1 - t", scale_y="1 - t")
    normal = np.array((1.0, 0.0, 1.0)) / np.sqrt(2)
    points = np.array((0.5, 0.0, 0.5)) + np.outer((0.9e-3, 1.1e-3, -0.9e-3, -1.1e-3), normal)
    assert sw.classify(steep, points, tolerance=1e-3).tolist() == [0, -1, 0, 1]
