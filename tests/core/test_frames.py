# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames against theorems: Bishop's on the helix, the holonomy of a knot, and what each frame is defined by."""

from math import fsum, hypot, pi

import numpy as np
import pytest

from sweep_addon.core.contours import Rectangle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.rings.corners import Round
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import (
    Continuation,
    FixedUp,
    Frenet,
    RotationMinimizing,
    axes,
    rotation_minimizing,
)
from sweep_addon.core.stations.rotations import turned
from sweep_addon.core.stations.sampling import Count, Tolerance, place, stations
from sweep_addon.core.trajectories import Arc, Bezier, Formula, Helix, Line, Nurbs, Polyline, TorusKnot
from sweep_addon.core.trajectories.curve import unit

KNOT = TorusKnot(2, 3, 2.0, 0.8)
HOLONOMY = 238.657637051473  # degrees, minus the total torsion of KNOT, -16.73173216593699 radians, modulo 360
S_CURVE = Bezier([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])
HANDLE = 4 / 3 * np.tan(pi / 8)
LOOP = np.array([(1, 0), (1, HANDLE), (HANDLE, 1), (0, 1), (-HANDLE, 1), (-1, HANDLE)])
LOOP = np.concatenate((LOOP, -LOOP))  # a circle by four cubic segments
VERTICAL_LOOP = Bezier(np.insert(LOOP, 1, 0.0, axis=1), closed=True)
SPACE = Bezier(np.random.default_rng(5).normal(size=(10, 3)))
QUARTIC = Nurbs([(-1, -1, 1), (-0.5, 0.5, -1), (0, 0, 1), (0.5, -0.5, -1), (1, 1, 1)], order=5)  # (t, t^3, t^4)
STRAIGHT_AND_BENT = Bezier([(0, 0, 0), (1, 0, 1), (2, 0, 2), (3, 0, 3), (4, 0, 4), (4, 0, 5), (3, 0, 6)])
ZIGZAG = Polyline([(0, 0, 0), (2, 0, 0), (2, 1, 1), (0, 3, 2), (0, 3, -1), (1, 2, 0)])


def framed(frame, trajectory, samples, twist=0.0):
    """The stations of a trajectory, the axes there and what is said of them."""
    placed = samples if hasattr(samples, "points") else place(trajectory, samples)
    return placed, *axes(frame, placed, np.full(len(placed.u), twist))


def rotate(vectors, axis, angle):
    """Rodrigues' rotation of vectors about the unit axes they are perpendicular to."""
    return np.cos(angle)[:, None] * vectors + np.sin(angle)[:, None] * np.cross(axis, vectors)


def angle_between(start, end, axis):
    return np.arctan2(np.einsum("ij,ij->i", np.cross(axis, start), end), np.einsum("ij,ij->i", start, end))


def carried(trajectory, normals, start, end, steps=100):
    """Normals carried from parameters to parameters without spin, by the paper's loop over many small steps."""
    for i in range(steps):
        here, there = start + (end - start) * i / steps, start + (end - start) * (i + 1) / steps
        leaves, arrives = trajectory.tangents(here), trajectory.tangents(there)
        for mirror in (trajectory.evaluate(there) - trajectory.evaluate(here), None):
            if mirror is None:
                mirror = arrives - leaves
            squared = np.einsum("ij,ij->i", mirror, mirror)[:, None]
            normals, leaves = (
                v - 2 * np.einsum("ij,ij->i", v, mirror)[:, None] / np.where(squared, squared, 1) * mirror
                for v in (normals, leaves)
            )
    return normals


def twists(trajectory, placed, e2):
    """The angle by which each step turns e2 more than it must, that of the closing step among them."""
    ends = np.append(placed.u[1:], trajectory.domain[1])
    return angle_between(
        carried(trajectory, e2, placed.u, ends), np.roll(e2, -1, axis=0), np.roll(placed.leave, -1, axis=0)
    )


def spin(placed, normals, against):
    """Degrees by which normals have turned about the tangent against other ones, from the first station on."""
    turned = angle_between(against, normals, placed.leave)
    return np.degrees((turned - turned[0] + pi) % (2 * pi) - pi)


def total_torsion(trajectory, u):
    """The integral of the torsion from the first of some parameters to each, by 20 nodes between neighbours."""
    nodes, weights = np.polynomial.legendre.leggauss(20)
    middle, half = (u[1:] + u[:-1]) / 2, np.diff(u) / 2
    first, second, third = (trajectory.derivative((middle + half * nodes[:, None]).ravel(), n) for n in (1, 2, 3))
    binormal = np.cross(first, second)
    rate = np.einsum("ij,ij->i", binormal, third) / np.einsum("ij,ij->i", binormal, binormal)
    steps = weights @ (rate * np.linalg.norm(first, axis=1)).reshape(20, -1) * half
    return np.array([fsum(steps[:i]) for i in range(len(u))])


@pytest.mark.parametrize("samples", [2, 11, 101, 401, 10_000])
def test_a_helix_frame_lags_the_frenet_frame_by_its_total_torsion(samples):
    """The rotation-minimizing normal turns by minus the torsion's integral (Bishop 1975), however few contours."""
    helix = Helix(1.0, 0.5, 5.0)
    placed, e2, _, _ = framed(RotationMinimizing(), helix, Count(samples))
    principal = np.stack((-np.cos(placed.u), -np.sin(placed.u), 0 * placed.u), axis=1)
    rise = 0.5 / (2 * pi)
    expected = -np.degrees(rise / np.hypot(1.0, rise)) * placed.u
    assert np.abs((spin(placed, e2, principal) - expected + 180) % 360 - 180).max() < 1e-12


@pytest.mark.parametrize(("radius", "rise"), [(1e-4, 3.0), (3.0, -1e-4), (0.5, -0.5)])
def test_a_steep_or_flat_helix_frame_lags_by_its_total_torsion(radius, rise):
    helix = Helix(radius, 2 * pi * rise, 1.5)
    placed = place(helix, Count(101))
    normals, _ = rotation_minimizing(placed)
    principal = np.stack((-np.cos(placed.u), -np.sin(placed.u), 0 * placed.u), axis=1)
    expected = -np.degrees(rise / hypot(radius, rise)) * placed.u
    assert np.abs((spin(placed, normals, principal) - expected + 180) % 360 - 180).max() < 1e-11


@pytest.mark.parametrize("samples", [101, 401])
def test_a_knot_frame_lags_the_frenet_frame_by_its_total_torsion(samples):
    placed = place(KNOT, Count(samples))
    normals, _ = rotation_minimizing(placed)
    expected = -np.degrees(total_torsion(KNOT, placed.u))
    assert np.abs((spin(placed, normals, unit(placed.bend)) - expected + 180) % 360 - 180).max() < 1e-12


@pytest.mark.parametrize("samples", [3, 10, 100, 1000])
def test_a_knot_brings_the_normal_back_turned_by_minus_its_total_torsion(samples):
    _, holonomy = rotation_minimizing(place(KNOT, Count(samples)))
    assert abs((np.degrees(holonomy) - HOLONOMY + 180) % 360 - 180) < 1e-12


@pytest.mark.parametrize("trajectory", [KNOT, SPACE, ZIGZAG, QUARTIC, Nurbs(SPACE.points), TorusKnot(7, 11)])
def test_normals_are_those_of_the_loop_over_many_small_steps(trajectory):
    """Double reflection is of fourth order: with 100 steps from station to station the error is 1e-8 of one's.
    At a corner the least rotation takes one tangent to the other."""
    placed = place(trajectory, Count(200))
    normals, _ = rotation_minimizing(placed)
    arrived = carried(trajectory, normals[:-1], placed.u[:-1], placed.u[1:] - 1e-14)
    arrived = turned(arrived, placed.arrive[1:], placed.leave[1:])
    assert np.abs(arrived - normals[1:]).max() < 1e-8


@pytest.mark.parametrize("trajectory", [S_CURVE, VERTICAL_LOOP, STRAIGHT_AND_BENT, Arc(angle=2 * pi), Line()])
@pytest.mark.parametrize("samples", [3, 8, 101, 1000])
def test_in_a_plane_the_normal_keeps_its_angle_to_it(trajectory, samples):
    """Through inflections, straight stretches and the vertical, with no flip and no jump."""
    placed = place(trajectory, Count(samples))
    normals, holonomy = rotation_minimizing(placed)
    sideways = placed.points - placed.points[0]
    plane = np.linalg.svd(sideways)[2][2]
    assert np.abs(normals @ plane - normals[0] @ plane).max() < 1e-12
    assert abs((holonomy + pi) % (2 * pi) - pi) < 1e-12


@pytest.mark.parametrize("extra_turns", [0, 1, -7])
def test_a_closed_frame_twists_evenly_however_unevenly_it_is_sampled(extra_turns):
    total = KNOT.length()
    x = np.linspace(0, 1, 2001)[:-1]
    placed = stations(KNOT, total * (x + 0.9 * np.sin(2 * pi * x) / (2 * pi)))  # steps differ 19 times
    _, e2, _, _ = framed(RotationMinimizing(extra_turns), KNOT, placed)
    twist = twists(KNOT, placed, e2)
    rate = twist / np.diff(np.append(placed.s, total))
    assert np.ptp(placed.s[1:] - placed.s[:-1]) > 15 * np.diff(placed.s).min()
    assert rate.max() / rate.min() <= 1.001 and rate.min() / rate.max() <= 1.001
    expected = 2 * pi * extra_turns - ((np.radians(HOLONOMY) + pi) % (2 * pi) - pi)
    assert abs(twist.sum() - expected) < 1e-6


@pytest.mark.parametrize("frame", [RotationMinimizing(), Frenet(), Frenet(Continuation.EXACT), FixedUp((1, 2, 3))])
@pytest.mark.parametrize("trajectory", [KNOT, Helix(), SPACE, ZIGZAG, S_CURVE, VERTICAL_LOOP, Nurbs(closed=True)])
def test_axes_are_orthonormal_and_right_handed(frame, trajectory):
    placed, e2, e3, _ = framed(frame, trajectory, Tolerance(0.01), twist=0.7)
    basis = np.stack((placed.tangent, e2, e3), axis=1)
    assert np.abs(basis @ basis.swapaxes(1, 2) - np.eye(3)).max() < 1e-14
    assert np.linalg.det(basis).min() > 0.99


def test_a_corner_turns_the_frame_by_the_least_rotation():
    """So both ends of a leg agree on its normal: about the axis across both tangents, by the angle between them."""
    placed, e2, _, _ = framed(RotationMinimizing(), ZIGZAG, Tolerance())

    def least_rotation(vectors, start, end):
        axis = np.cross(start, end)
        cosine = np.einsum("ij,ij->i", start, end)[:, None]
        return vectors + np.cross(axis, vectors) + np.cross(axis, np.cross(axis, vectors)) / (1 + cosine)

    leaving = least_rotation(e2, placed.tangent, placed.leave)[:-1]
    arriving = least_rotation(e2, placed.tangent, placed.arrive)[1:]
    assert len(placed.corners) == 4 and np.abs(leaving - arriving).max() < 1e-14


def test_frenet_on_a_helix_is_the_principal_normal():
    placed, e2, _, told = framed(Frenet(), Helix(2.0, -3.0, 4.0), Count(100))
    assert np.abs(e2 - np.stack((-np.cos(placed.u), -np.sin(placed.u), 0 * placed.u), axis=1)).max() < 1e-13
    assert told == ()


def test_frenet_through_an_inflection_keeps_its_side_changes_it_or_refuses():
    placed, e2, _, told = framed(Frenet(), S_CURVE, Count(101))
    assert (np.einsum("ij,ij->i", e2[1:], e2[:-1]) > 0.9).all() and "u = 0.5" in told[0]
    placed, e2, _, told = framed(Frenet(Continuation.EXACT), S_CURVE, Count(100))
    assert "near u = 0.5," in told[0]  # amid the step, where no contour stands
    curved = np.cross(S_CURVE.derivative(placed.u), S_CURVE.derivative(placed.u, 2))[:, 2]
    assert (np.sign(np.cross(placed.leave, e2)[:, 2]) == np.sign(curved)).all()
    with pytest.raises(ShapeError, match="frame.continuation: must be smooth or exact where .* near u = 0.5"):
        framed(Frenet(Continuation.REFUSE), S_CURVE, Count(101))


def test_frenet_turns_evenly_over_a_straight_stretch():
    """Two arcs in planes at a right angle, joined by a straight line along the tangent of both."""
    bent = [(-1, 1, 0), (-1, HANDLE, 0), (-HANDLE, 0, 0), (0, 0, 0)]
    chain = [*bent, (1, 0, 0), (2, 0, 0), (3, 0, 0), (3 + HANDLE, 0, 0), (4, 0, HANDLE), (4, 0, 1)]
    placed, e2, _, told = framed(Frenet(), Bezier(chain), Count(201))
    straight = (placed.points[:, 0] > 1e-6) & (placed.points[:, 0] < 3 - 1e-6)
    angle = np.unwrap(np.arctan2(e2[straight, 2], e2[straight, 1]))
    assert np.abs(np.diff(angle, 2)).max() < 1e-9 and abs(np.ptp(angle)) > 0.9 * pi / 2
    assert "vanishes" in told[0]


@pytest.mark.parametrize("offset", [0, 5, 50, 500])
def test_frenet_is_not_deceived_by_joints_of_single_precision(offset):
    """Handles of a smooth joint, as Blender keeps them, are a ten-millionth of their coordinates off."""
    turn = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))[0]
    circle = (np.insert(LOOP, 2, 0.0, axis=1) @ turn + offset).astype(np.float32)
    placed, e2, _, _ = framed(Frenet(), Bezier(circle, closed=True), Tolerance(1e-3))
    inward = offset - placed.points
    cosine = np.einsum("ij,ij->i", e2, inward) / np.linalg.norm(inward, axis=1)
    assert cosine.min() > np.cos(0.01 + 1e-3 * offset)


def test_fixed_up_is_level_and_its_y_axis_points_up():
    for up in ((0, 0, 1), (1, -2, 0.5)):
        _, e2, e3, told = framed(FixedUp(up), KNOT, Count(200))
        assert np.abs(e2 @ np.array(up)).max() < 1e-14 and (e3 @ np.array(up)).min() > 0
        assert told == ()


@pytest.mark.parametrize("samples", [32, 33, 63])
def test_fixed_up_goes_over_the_vertical_without_a_turn(samples):
    """In a vertical circle the axis of the circle is level all the way round."""
    _, e2, _, told = framed(FixedUp(), VERTICAL_LOOP, Count(samples))
    assert np.abs(e2 - e2[0]).max() < 1e-12 and abs(abs(e2[0, 1]) - 1) < 1e-12
    assert told[0].startswith("Frame: the trajectory runs along the up direction near u = ")


FIGURE_EIGHT = Formula("u^3-3*u", "u*(u^2-1)*(u^2-4)", "u^7-42*u", start=-3.2, end=3.2)  # Shastri 1992


@pytest.mark.parametrize("samples", [Tolerance(1.5), Tolerance(0.15), Count(2000)])
def test_fixed_up_is_level_where_a_long_path_bends_in_a_short_part_of_it(samples):
    """Within a two-thousandth of this knot its level normal turns by more than a right angle; the y axis points up."""
    tube = GeneralizedCylinder(Rectangle(1.0, 0.5), FIGURE_EIGHT, samples, FixedUp((0.3, 1, 0.2)))
    swept = tube.swept()
    e2, e3 = (unit(axis) for axis in swept.rings[1:])
    assert np.abs(e2 @ (0.3, 1, 0.2)).max() < 1e-12 and (e3 @ (0.3, 1, 0.2)).min() > 0
    assert not any("up direction" in sentence for sentence in swept.told)
    if isinstance(samples, Tolerance):
        assert (e2[1:] * e2[:-1]).sum(axis=1).min() > np.cos(np.radians(60))


@pytest.mark.parametrize("aside", [0.0, 1e-5, 1e-4])
def test_fixed_up_turns_little_between_contours_where_it_passes_the_vertical_closely(aside):
    """Where it goes over the vertical it keeps its side, and so do contours that stand where it is vertical."""
    path = Formula("cos(u+0.0004)", f"{aside}*u", "sin(u+0.0004)", start=-1.5, end=1.5)
    _, e2, _, _ = framed(FixedUp(), path, Count(20001))
    assert (e2[1:] * e2[:-1]).sum(axis=1).min() > np.cos(np.radians(5))


def test_fixed_up_along_a_vertical_line_keeps_the_first_normal():
    _, e2, _, told = framed(FixedUp(), Line(), Count(5))
    assert np.abs(e2 - (1, 0, 0)).max() < 1e-15 and "up direction" in told[0]


def test_fixed_up_that_cannot_close_level_turns_in_one_step_only():
    """Where a closed curve passes the up direction an odd number of times, one half turn has no place to hide."""
    up = tuple(KNOT.tangents(np.array([0.3]))[0])
    placed, e2, _, told = framed(FixedUp(up), KNOT, Count(2000))
    twist = np.abs(twists(KNOT, placed, e2))
    assert (twist > 0.5).sum() <= 2 and told


@pytest.mark.parametrize("frame", [FixedUp(), Frenet()])
@pytest.mark.parametrize("chord", [1e-2, 1e-3, 1e-4])
def test_contours_stand_as_close_as_the_turn_of_the_frame_asks(frame, chord):
    """Up a post, and off to another side: on the post a corner of the contour goes round it as on a cylinder."""
    knots = [(-1.4, 0, 0), (-0.8, 0, 0), (0, 0, 0), (0, 0, 0.6), (0, 0, 0.9), (0, 0, 1.2), (0, 0, 1.5), (0, 0, 2.1)]
    path = Bezier([*knots, (0, 0.8, 2.1), (0, 1.4, 2.1)])
    mesh = GeneralizedCylinder(Rectangle(0.5, 0.1), path, Tolerance(chord), frame).mesh()
    corner = mesh.vertices[: mesh.rings]
    corner = corner[(corner[:, 2] > 0.62) & (corner[:, 2] < 1.48), :2]
    assert len(corner) > 2
    assert np.hypot(0.25, 0.05) - np.hypot(*(corner[1:] + corner[:-1]).T / 2).min() < chord


@pytest.mark.parametrize(
    ("direction", "normal"),
    [((3, 4, 0), (0.8, -0.6, 0)), ((0, 0, 1), (1, 0, 0)), ((0, 0, -1), (1, 0, 0)), ((0, 1, 1), (1, 0, 0))],
)
def test_the_first_normal_is_blenders(direction, normal):
    """Blender's curve normals start with z x t, (t.y, -t.x, 0), or x where the tangent is vertical."""
    _, e2, _, _ = framed(RotationMinimizing(), Line(end=direction), Tolerance())
    assert np.abs(e2 - normal).max() < 1e-15


@pytest.mark.parametrize("count", [2, 3, 5])
def test_frenet_frame_of_straight_legs_is_that_of_the_bend_between_them_wherever_contours_stand(count):
    """A quarter of a turn to the left: its centre is at (0.8, 0.2), inwards of both legs."""
    path = Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)], corner=Round(0.2))
    stations = place(path, Count(count))
    e2, _, told = axes(Frenet(), stations, np.zeros(len(stations.s)))
    assert e2[0] == pytest.approx((0, 1, 0), abs=1e-12) and e2[-1] == pytest.approx((-1, 0, 0), abs=1e-12)
    assert told[0].startswith("Frame: the curvature vanishes near u = 0,")
