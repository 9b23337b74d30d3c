# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Certificates say what dense sampling by another library finds, and miss nothing that lies between samples."""

import numpy as np
import pytest

from sweep_addon.core.meshes.booleans import body_of
from sweep_addon.core.meshes.polyhedron import polyhedron
from sweep_addon.core.removal.bodies import Body, taken
from sweep_addon.core.removal.certificate import clearance
from sweep_addon.core.removal.legs import START, Leg, Pose, turn
from sweep_addon.core.removal.shrinking import drawn_in
from sweep_addon.core.removal.touching import Moving, Surroundings
from sweep_addon.core.solids import Ball, Block, Bracket, Cylinder, DrilledBlock

pytest.importorskip("fcl", reason="distances are asked of python-fcl")
pytest.importorskip("manifold3d", reason="its distances are compared")

Z = np.array([0.0, 0.0, 1.0])


def certified(part, others, leg):
    body = taken(part, "part")
    around = Surroundings([taken(other, "other") for other in others])
    return clearance(Moving(body.vertices, body.triangles), around, leg, START)


def sampled(part, others, leg, count=60):
    """The least gap at many places of a leg, by manifold3d."""
    own, found = part.mesh(), []
    for part_of_way in np.linspace(0, 1, count):
        vertices = leg.pose(part_of_way).of(own.vertices)
        moved = body_of(polyhedron(vertices, own.corners, own.offsets))
        found.append(min(moved.min_gap(body_of(other.mesh()), 2.0) for other in others))
    return min(found)


@pytest.mark.parametrize("thickness", [0.1, 1e-3, 1e-6, 1e-9])
@pytest.mark.parametrize("angle", [0.0, 0.3])
def test_a_wall_that_is_crossed_between_two_samples_is_found(thickness, angle):
    wall = Block(3.0, 3.0, thickness).moved(z=1.0)
    leg = Leg(np.array([0.0, 0.0, 2.0]), np.zeros(3), Z, angle)
    assert certified(Block(0.2, 0.2, 0.2), [wall], leg) == 0.0


@pytest.mark.parametrize("size", [0.3, 1e-2, 1e-5])
def test_a_pebble_that_a_face_passes_over_is_found(size):
    """It lies amid the way of one triangle, and crosses no side of the prism that the triangle visits."""
    pebble = Ball(size).moved(x=1.7, y=0.31, z=0.27)
    assert certified(Block(2.0, 2.0, 2.0), [pebble.moved(x=2.0)], Leg(np.array([4.0, 0, 0]))) == 0.0


def test_clearance_on_a_straight_leg_is_that_of_what_is_passed():
    """A cube of 1 m passes a pole 0.25 m beside it and under a lid 0.125 m above it."""
    pole, lid = Block(0.1, 0.1, 5.0).moved(x=3.0, y=0.8), Block(1, 1, 1).moved(x=3.0, z=1.125)
    way = Leg(np.array([8.0, 0, 0]))
    assert certified(Block(1, 1, 1), [pole], way) == pytest.approx(0.25, abs=1e-12)
    assert certified(Block(1, 1, 1), [pole, lid], way) == pytest.approx(0.125, abs=1e-12)


POLE, BALL = Cylinder(0.1, 1.0, points=12), Ball(0.3, points=12)
CASES = [
    (Bracket(), [POLE.moved(x=0.35, y=0.4)], 0.3, 0.9),
    (Bracket(), [BALL.moved(x=0.6, y=0.6)], 0.0, 1.2),
    (DrilledBlock(points=12), [POLE], 1.0, 3.0),
    (Block(0.2, 0.9, 0.2), [BALL.moved(x=0.5, z=0.2)], -1.0, -0.5),
    (Bracket(), [POLE.moved(x=-0.2, y=0.2)], 0.0, 2.5),
]


@pytest.mark.thorough
@pytest.mark.parametrize(("part", "others", "along", "angle"), CASES)
def test_certificates_agree_with_dense_samples(part, others, along, angle):
    """A bound from below that is more than a fifth of the truth where there is a gap, and 0 where something is met."""
    for leg in (Leg(along * Z + (0.2, 0, 0)), Leg(along * Z, np.array([0.01, 0.02, 0.0]), Z, angle)):
        truth, found = sampled(part, others, leg), certified(part, others, leg)
        assert found <= truth + 1e-9
        assert found > truth / 5 or truth < 2e-3


def test_drawing_in_moves_no_vertex_farther_and_every_flat_face_inwards():
    for solid in (Block(), Bracket(), Cylinder(points=12), DrilledBlock(points=8)):
        body = taken(solid, "part")
        drawn = drawn_in(body, 0.01)
        assert np.allclose(np.linalg.norm(drawn.vertices - body.vertices, axis=1), 0.01)
        assert (body.depths(drawn.vertices) > 0.01 / 2).all()  # the corner of a cube moves along its diagonal


def test_a_leg_ends_where_its_parts_lead():
    rng = np.random.default_rng(0)
    axis = rng.normal(size=3)
    leg = Leg(rng.normal(size=3), rng.normal(size=3), axis / np.linalg.norm(axis), 1.1)
    points = rng.normal(size=(5, 3))
    first, whole = leg.until(0.4), leg.pose(1.0)
    rest = Leg(0.6 * leg.way, leg.pivot + 0.4 * leg.way, leg.axis, 0.6 * leg.angle)
    assert np.allclose(rest.pose(1.0).of(first.pose(1.0).of(points)), whole.of(points))
    pose = Pose(turn(Z, 0.7), np.ones(3))
    assert np.allclose(leg.seen(pose).pose(1.0).of(pose.of(points)), pose.of(whole.of(points)))
    assert np.allclose(pose.inverse().of(pose.of(points)), points)


@pytest.mark.parametrize("size", [1.0, 1e-3, 1e-4, 1e-6, 1e-8])
def test_a_corner_over_a_face_is_half_its_size_away_however_small_both_are(size):
    """A corner is 0.5 over the inside of a level triangle; the edges of both are farther from each other."""
    level = size * np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
    over = size * np.array([(0.2, 0.2, 0.5), (1.2, 0.3, 0.6), (0.1, 1.1, 0.7)])
    alone = np.array([[0, 1, 2]])
    found = Surroundings([Body("level", level, alone)]).clearance(Moving(over, alone).object)
    assert found == pytest.approx(0.5 * size, rel=1e-9)
