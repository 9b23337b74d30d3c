# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership of sweeps that move as solids: against formulas, and against many poses of what stands still."""

from math import pi

import numpy as np
import pytest
from conftest import FULL

import sweep_addon as sw
from sweep_addon.core.membership.members import member

HALF_DISC = sw.contours.Outline([[(0, -1), (0, 1)]], bulges=[[1, 0]])
TORUS = sw.GeneralizedCylinder(sw.contours.Circle(0.5), sw.trajectories.Arc(2.0, 2 * pi))
CONE = sw.GeneralizedCylinder(
    sw.contours.Circle(1.0), sw.trajectories.Line(end=(0, 0, 2)), scale_x="1 - t", scale_y="1 - t"
)
BALL = sw.RotationalSweep(HALF_DISC)
POINTS = 400 if FULL else 150
UP, ASIDE = sw.trajectories.Line(end=(0, 0, 2)), sw.trajectories.Line(end=(3, 0, 0))


def torus_moved_up(p):
    return np.hypot(np.hypot(p[:, 0], p[:, 1]) - 2, p[:, 2] - np.clip(p[:, 2], 0, 2)) - 0.5


def torus_spun(p):
    """Half a turn about a diameter: each place of the circle comes to all of a ring, together to the sphere of 2 m."""
    return np.abs(np.linalg.norm(p, axis=1) - 2) - 0.5


def cone_moved_aside(p):
    """Beside the slope; what is nearer to the rim than to it or to the base is left out by who asks."""
    across = np.hypot(p[:, 0] - np.clip(p[:, 0], 0, 3), p[:, 1])
    return np.maximum(-p[:, 2], (across + p[:, 2] / 2 - 1) / np.hypot(1, 0.5))


def capsule(p):
    return np.linalg.norm(p - np.column_stack((np.clip(p[:, 0], 0, 3), np.zeros((len(p), 2)))), axis=1) - 1


CANAL = sw.CanalSurface(UP, "0.2 + 0.5*t")
ROD = sw.CanalSurface(UP, 0.5, start="flat", end="flat")


def balls_moved_aside(p):
    """From the ball of radius 0.2 + s / 4 about (0, 0, s) that is nearest, from 0 to 2 m; all of them move along x."""
    aside = np.hypot(p[:, 0] - np.clip(p[:, 0], 0, 3), p[:, 1])
    s = np.clip(p[:, 2] + aside / np.sqrt(15), 0, 2)
    return np.hypot(aside, p[:, 2] - s) - 0.2 - s / 4


def rod_moved_aside(p):
    across = np.hypot(p[:, 0] - np.clip(p[:, 0], 0, 3), p[:, 1]) - 0.5
    along = np.abs(p[:, 2] - 1) - 1
    return np.hypot(np.maximum(across, 0), np.maximum(along, 0)) + np.minimum(np.maximum(across, along), 0)


TOLD = {
    "a canal that grows": (sw.SweptSolid(CANAL, ASIDE), balls_moved_aside, 1e-3),
    "a canal with flat ends": (sw.SweptSolid(ROD, ASIDE), rod_moved_aside, 1e-3),
    "a torus along its axis": (sw.SweptSolid(TORUS, UP), torus_moved_up, 1e-3),
    "a torus turned about a diameter": (
        sw.SweptSolid(TORUS, sw.RigidMotion(sw.trajectories.Line(end=(1e-9, 0, 0)), turn_x="pi*t")),
        torus_spun,
        1e-3,
    ),
    "a cone across its axis": (sw.SweptSolid(CONE, ASIDE), cone_moved_aside, 1e-3),
    "a half disc's ball": (sw.SweptSolid(BALL, ASIDE), capsule, 1e-6),
}


FAR = {
    "torus": (TORUS, lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]) - 2, p[:, 2]) - 0.5),
    "ball": (BALL, lambda p: np.linalg.norm(p, axis=1) - 1),
    "canal": (CANAL, lambda p: balls_moved_aside(np.column_stack((-np.hypot(p[:, 0], p[:, 1]), 0 * p[:, 0], p[:, 2])))),
    "rod": (ROD, lambda p: rod_moved_aside(np.column_stack((-np.hypot(p[:, 0], p[:, 1]), 0 * p[:, 0], p[:, 2])))),
    "round rod": (
        sw.GeneralizedCylinder(sw.contours.Circle(0.5), UP, start="round", end="round"),
        lambda p: np.hypot(np.hypot(p[:, 0], p[:, 1]), p[:, 2] - np.clip(p[:, 2], 0, 2)) - 0.5,
    ),
}


@pytest.mark.parametrize("name", FAR)
def test_a_distance_is_exact_near_the_surface_and_nowhere_too_large(name):
    shape, formula = FAR[name]
    found = member(shape)
    low, high = found.box
    points = np.random.default_rng(4).uniform(1.5 * low - 0.5 * high, 1.5 * high - 0.5 * low, (5000, 3))
    distance, expected = found.distance(points), formula(points)
    assert (np.sign(distance) == np.sign(expected)).all()
    assert (np.abs(distance) < np.abs(expected) + 1e-8).all()
    assert (distance > expected / 3)[expected > 0].all()
    slope = np.stack([formula(points + step) - formula(points - step) for step in 1e-5 * np.eye(3)], axis=1) / 2e-5
    near = points - (expected - np.random.default_rng(5).uniform(0, 0.005, len(points)))[:, None] * slope
    assert np.abs(found.distance(near) - formula(near)).max() < 1e-8


@pytest.mark.thorough
@pytest.mark.parametrize("name", TOLD)
def test_a_moving_sweep_is_what_a_formula_says(name):
    shape, distance, tolerance = TOLD[name]
    low, high = member(shape).box
    points = np.random.default_rng(0).uniform(low, high, (1000, 3))
    near = points[np.abs(distance(points)).argsort()[:200]]
    points = np.concatenate((points, near + 2 * tolerance * np.random.default_rng(1).normal(size=near.shape)))
    labels, far = sw.classify(shape, points, tolerance), distance(points)
    expected = np.where(np.abs(far) <= tolerance, 0, np.where(far < 0, 1, -1))
    sure = np.abs(np.abs(far) - tolerance) > 1e-3 * tolerance
    assert (labels[sure] == expected[sure]).all()


def poses(shape, count):
    """Random poses of the solid that moves, with those of the ends: rotation matrices and places."""
    rigid = shape.rigid
    motion = sw.GeneralSweep(sw.solids.Ball(), rigid.trajectory, frame=rigid.frame, turn_x=rigid.turn_x,
                             turn_y=rigid.turn_y, turn_z=rigid.turn_z).motion  # fmt: skip
    found = motion.at(np.linspace(0.0, rigid.trajectory.length(), count))
    return found.matrix, found.origin


CURVE = sw.trajectories.Bezier([(0, 0, 0), (0, 0, 0.6), (0, 0.5, 0.8), (0.3, 1, 0.8)])
BENT = sw.GeneralizedCylinder(sw.contours.Star(5, 0.2, 0.1), CURVE, twist="pi*t")
TAPERED = sw.GeneralizedCylinder(sw.contours.Rectangle(0.3, 0.2), CURVE, scale_x="1 - 0.5*t", end="round")
CROSSING = sw.GeneralizedCylinder(
    sw.contours.Rectangle(0.2, 0.2),
    sw.trajectories.Formula("0.7*sin(u)", "0.35*sin(2*u)", "0", 0, 2 * pi),
    frame="fixed-up",
)
ELBOW = sw.GeneralizedCylinder(
    sw.contours.Rectangle(0.2, 0.1), sw.trajectories.Polyline([(0, 0, 0), (0.7, 0, 0), (0.7, 0.6, 0)])
)
OVAL = sw.GeneralizedCylinder(sw.contours.Ellipse(0.3, 0.1), sw.trajectories.Arc(0.6, 3.0))
WASHER = sw.contours.Outline([[(-0.6, 0), (0.6, 0)], [(-0.5, 0), (0.5, 0)]], bulges=[[1, 1], [1, 1]])
NOTCHED = sw.contours.Outline([[(-0.5, 0), (-0.5, -0.75), (0.5, -0.75), (0.5, 0)]], bulges=[[0, 0, 0, -1]])
TURNING = sw.RigidMotion(sw.trajectories.Line(end=(0.3, 0.2, 0.4)), turn_z="1.5*t", turn_x="0.7*t^2")
MOVED = {
    "a twisted star": BENT,
    "a taper with a round end": TAPERED,
    "what crosses itself": CROSSING,
    "a mitre": ELBOW,
    "an oval": OVAL,
    "arcs scaled flat": sw.GeneralizedCylinder(WASHER, UP, scale_x=1, scale_y=0.1),
    "an arc that bends inwards, narrow": sw.GeneralizedCylinder(NOTCHED, UP, scale_x=0.1, scale_y="1 - 0.2*t"),
    "a deformed contour": sw.GeneralSweep(
        sw.contours.Rectangle(0.4, 0.2), sw.trajectories.Line(), deform_x="x*(1 + 0.5*sin(3*t + y))"
    ),
    "a union": BENT | OVAL,
    "a difference": OVAL - BENT,
    "an intersection": OVAL & sw.solids.Ball(0.55),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", MOVED)
def test_a_moving_sweep_is_where_its_poses_are(name):
    """A point that is in at some pose is in; one that is in is no farther from a pose than a step and the tolerance."""
    shape, tolerance, count = sw.SweptSolid(MOVED[name], TURNING), 2e-3, 400
    low, high = member(shape).box
    points = np.random.default_rng(2).uniform(low, high, (POINTS, 3))
    labels = sw.classify(shape, points, tolerance)
    matrix, origin = poses(shape, count)
    back = np.einsum("pji,npj->npi", matrix, points[:, None] - origin).reshape(-1, 3)
    still = sw.classify(MOVED[name], back, 1e-9).reshape(len(points), count)
    assert (labels[(still == 1).any(axis=1)] >= 0).all()
    step = norms_between(back.reshape(len(points), count, 3)).max(axis=1) / 2
    room = tolerance + step.max()
    wide = sw.classify(MOVED[name], back[np.repeat(labels >= 0, count)], room).reshape(-1, count)
    assert (wide >= 0).any(axis=1).all()
    deep = sw.classify(MOVED[name], back[np.repeat(labels <= 0, count)], room).reshape(-1, count)
    assert (deep < 1).all()


def norms_between(places):
    return np.linalg.norm(np.diff(places, axis=1), axis=2)


@pytest.mark.thorough
def test_sweeping_a_union_of_sweeps_is_sweeping_each():
    a, b = OVAL, BENT
    low, high = member(sw.SweptSolid(a | b, TURNING)).box
    points = np.random.default_rng(3).uniform(low, high, (4 * POINTS, 3))
    whole = sw.classify(sw.SweptSolid(a | b, TURNING), points, 1e-4)
    each = np.maximum(*(sw.classify(sw.SweptSolid(part, TURNING), points, 1e-4) for part in (a, b)))
    assert (whole == each)[each != 0].all() and (whole[each == 0] >= 0).all()
