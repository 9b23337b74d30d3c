# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership of canal surfaces without round ends, of deformed contours, and of surfaces without an inside.

All against formulas: the distance from the solid or the surface, or less, with the sign that tells.
"""

from math import pi

import numpy as np
import pytest

import sweep_addon as sw

UP = sw.trajectories.Line(end=(0, 0, 2))
DISC, ARC = sw.contours.Circle(0.3), sw.trajectories.Arc(1.0, pi / 2)
TURNING = "-3*t^2*(1 + x)"  # up and back, so that the figure folds at a height that depends on x


def frustum(p):
    """Of balls of radius 0.3 + s/2 the circles are half a radius behind, as large as the root of 3/4 of it."""
    part = np.sqrt(0.75)
    low, high = -0.15, 2 - 0.65
    radius = part * (0.3 + (p[:, 2] - low) / (high - low))
    return np.maximum((np.hypot(p[:, 0], p[:, 1]) - radius) * part, np.maximum(low - p[:, 2], p[:, 2] - high))


def tapered(p):
    return np.maximum((np.hypot(p[:, 0], p[:, 1]) - 1 + p[:, 2] / 4) / np.hypot(1, 0.25), np.abs(p[:, 2] - 1) - 1)


def bowl(p):
    across = np.hypot(p[:, 0], p[:, 1])
    return np.maximum(across - 1, (np.abs(p[:, 2] - across**2 / 2 - 1) - 1) / np.sqrt(2))


def folded(p):
    """A place rises as 2 t - 3 t^2 (1 + x) for t from 0 to 1: highest where its slope is 0."""
    steep = 1 + p[:, 0]
    t = np.clip(1 / (3 * steep), 0, 1)
    low, high = np.minimum(0, 2 - 3 * steep), 2 * t - 3 * t**2 * steep
    return np.maximum(np.hypot(p[:, 0], p[:, 1]) - 0.3, np.maximum(low - p[:, 2], p[:, 2] - high) / 4)


SOLIDS = {
    "canal with flat ends": (sw.CanalSurface(UP, "0.3 + 0.5*s", start="flat", end="flat"), frustum),
    "deformed to a cone": (sw.GeneralSweep(sw.contours.Circle(1.0), UP, deform_x="x*(1 - t/2)", deform_y="y*(1 - t/2)"),
                           tapered),
    "deformed to a bowl": (sw.GeneralSweep(sw.contours.Circle(1.0), UP, deform_z="(x^2 + y^2)/2"), bowl),
    "deformed to and fro": (sw.GeneralSweep(DISC, UP, deform_z=TURNING), folded),
}  # fmt: skip


@pytest.mark.thorough
@pytest.mark.parametrize("name", SOLIDS)
def test_no_point_is_told_wrongly(name):
    shape, distance = SOLIDS[name]
    points = np.random.default_rng(0).uniform(-2, 2.5, (30_000, 3))
    labels = sw.classify(shape, points)
    assert (labels == np.sign(-distance(points))).all()
    assert (labels == 1).sum() > 100


@pytest.mark.thorough
@pytest.mark.parametrize("name", SOLIDS)
def test_what_is_on_the_boundary_is_on(name):
    """Found by bisection of the formula between a point inside and one outside."""
    shape, distance = SOLIDS[name]
    points = np.random.default_rng(1).uniform(-2, 2.5, (30_000, 3))
    inner, outer = points[distance(points) < 0][:100], points[distance(points) > 0][:100]
    for _ in range(60):
        middle = (inner + outer) / 2
        inside = (distance(middle) < 0)[:, None]
        inner, outer = np.where(inside, middle, inner), np.where(inside, outer, middle)
    assert len(outer) == len(inner) == 100
    assert (sw.classify(shape, outer, tolerance=1e-8) == 0).all()


def test_a_canal_of_one_radius_with_flat_ends_is_a_round_tube():
    """Also where it bends so tightly that it meets itself."""
    points = np.random.default_rng(2).uniform(-0.4, 0.4, (20_000, 3))
    bend = sw.trajectories.Arc(0.1, 4.0)
    canal = sw.classify(sw.CanalSurface(bend, 0.2, start="flat", end="flat"), points)
    assert (canal == sw.classify(sw.GeneralizedCylinder(sw.contours.Circle(0.2), bend), points)).all()
    assert (canal == 1).sum() > 1000


def in_tube(p):
    """How far points are from the skin of a quarter of a torus, where they are beside it."""
    angle = np.arctan2(p[:, 1], p[:, 0])
    beside = (angle >= 0) & (angle <= pi / 2)
    return np.where(beside, np.abs(np.hypot(np.hypot(p[:, 0], p[:, 1]) - 1, p[:, 2]) - 0.3), np.inf)


SKINS = {
    "tube": sw.GeneralizedCylinder(DISC, ARC, start="open", end="open"),
    "canal": sw.CanalSurface(ARC, 0.3, start="open", end="open"),
    "rotation": sw.RotationalSweep(
        sw.contours.Outline([[(1.3, 0), (0.7, 0)]], bulges=[[1, 1]]), pi / 2, start="open", end="open"
    ),
    "general sweep": sw.GeneralSweep(DISC, ARC, frame="frenet", start="open", end="open"),
    "PD curve sweep": sw.PDCurveSweep(DISC, ARC, start="open", end="open"),
}


@pytest.mark.parametrize("name", SKINS)
def test_a_tube_without_ends_is_a_surface(name):
    shape, tolerance = SKINS[name], 0.02
    points = np.random.default_rng(3).uniform(-0.4, 1.4, (20_000, 3)) * (1, 1, 0.4)
    far = in_tube(points)
    if name == "rotation":  # which is about the y axis, from x towards -z
        points = np.stack((points[:, 0], points[:, 2], -points[:, 1]), axis=1)
    labels = sw.classify(shape, points, tolerance)
    beside = far < np.inf
    clear = beside & (np.abs(far - tolerance) > 1e-3)
    assert (labels[clear] == np.where(far[clear] < tolerance, 0, -1)).all()
    assert (labels[clear] == 0).sum() > 300
    assert not (labels == 1).any()


def test_one_end_of_an_open_tube_may_have_a_face():
    shape = sw.TranslationalSweep(DISC, 1.0, end="open")
    middle, rim = np.zeros((2, 3)), np.array([(0.3, 0, 0.0), (0.3, 0, 1.0)])
    middle[1, 2] = 1.0
    assert sw.classify(shape, middle).tolist() == [0, -1]
    assert sw.classify(shape, rim).tolist() == [0, 0]


@pytest.mark.parametrize("end, expected", [("open", -1), ("flat", 0)])
def test_a_canal_ends_in_a_face_or_in_none(end, expected):
    shape = sw.CanalSurface(UP, 0.3, start="open", end=end)
    assert sw.classify(shape, [(0.1, 0, 2.0), (0.1, 0, 0.0), (0, 0.3, 1.0)]).tolist() == [expected, -1, 0]


def test_an_open_contour_sweeps_a_surface():
    """A half circle along z: half a cylinder's skin."""
    half = sw.contours.Outline([[(0.5, 0), (-0.5, 0)]], bulges=[[1, 0]], closed=False)
    shape = sw.TranslationalSweep(half, 1.0)
    points = np.random.default_rng(4).uniform((-0.7, -0.7, 0), (0.7, 0.7, 1), (20_000, 3))
    across = np.hypot(points[:, 0], points[:, 1])
    ends = np.hypot(np.abs(points[:, 0]) - 0.5, points[:, 1])
    far = np.where(points[:, 1] >= 0, np.abs(across - 0.5), ends)
    assert (sw.classify(shape, points, tolerance=0.05) == np.where(far <= 0.05, 0, -1)).all()


def test_what_stays_in_its_plane_is_a_figure_of_it():
    """Discs on an arc of half a turn, their end flat at its start: half an annulus and half a disc."""
    discs = sw.CanalSurface(sw.trajectories.Arc(0.5, pi), 0.1, "disc", start="flat")
    strip = sw.TranslationalSweep(sw.contours.Rectangle(0.2, 0.4), 1.0, direction=(1, 0, 0))
    p = np.random.default_rng(5).uniform(-0.7, 1.2, (20_000, 3)) * (1, 1, 0)
    x, y, _ = p.T
    annulus = (np.abs(np.hypot(x, y) - 0.5) <= 0.1) & (y >= 0) | (np.hypot(x + 0.5, y) <= 0.1)
    assert (sw.classify(discs, p) == np.where(annulus, 0, -1)).all()
    assert (sw.classify(strip, p) == np.where((np.abs(x - 0.5) <= 0.6) & (np.abs(y) <= 0.2), 0, -1)).all()
    assert (sw.classify(discs, p + (0, 0, 1e-3)) == -1).all()


@pytest.mark.thorough
def test_a_surface_that_moves_sweeps_what_its_mesh_bounds():
    triangle = sw.solids.Triangles([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
    p = np.random.default_rng(6).uniform(-0.2, 1.2, (20_000, 3))
    x, y, z = p.T
    inside = (x > 0) & (y > 0) & (x + y < 1) & (z > 0) & (z < 1)
    for moved in (sw.GeneralSweep, sw.SweptSolid):
        assert (sw.classify(moved(triangle, sw.trajectories.Line()), p) == np.where(inside, 1, -1)).all()
    assert sw.classify(triangle, [(0.2, 0.2, 0.0), (0.2, 0.2, 0.1)]).tolist() == [0, -1]


def test_open_ends_have_images_too():
    """The planes that pass through a point are those of the same tube with faces."""
    points = np.random.default_rng(7).uniform(-1.5, 1.5, (200, 3))
    open_, closed = (sw.inverse_sweep(sw.GeneralizedCylinder(DISC, ARC, end=end), points) for end in ("open", "flat"))
    assert len(open_.u) > 50
    assert np.array_equal(open_.u, closed.u) and np.array_equal(open_.images, closed.images)


def test_a_canal_may_move_and_be_an_operand():
    """A sphere swept along a line and moved across it: a rounded plate."""
    moved = sw.SweptSolid(sw.CanalSurface(sw.trajectories.Line(), 0.2, points=96), sw.trajectories.Line(end=(1, 0, 0)))
    p = np.random.default_rng(8).uniform(-0.4, 1.4, (2_000, 3))
    nearest = p - np.clip(p * (1, 0, 1), 0, (1, 0, 1))
    distance = np.linalg.norm(nearest, axis=1) - 0.2
    clear = np.abs(distance) > 0.003
    assert (sw.classify(moved, p[clear], tolerance=1e-3) == np.sign(-distance[clear])).all()
