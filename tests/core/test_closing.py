# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A contour carried round a closed trajectory meets itself in any turn that maps it to itself: with the least twist."""

from itertools import pairwise
from math import gcd, pi, radians, tau

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solids import assert_solid, ngon

from sweep_addon.core.contours import Aerofoil, Circle, Outline, Rectangle, RegularPolygon, Star
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import Continuation, FixedUp, Frenet, RotationMinimizing, rotation_minimizing
from sweep_addon.core.stations.rotations import signed_angle
from sweep_addon.core.stations.sampling import Count, Tolerance, place
from sweep_addon.core.trajectories import Arc, Bezier, Line, Polyline, TorusKnot

RING = Arc(2.0, tau)
KNOT = TorusKnot(2, 3, 2.0, 0.8)
HOLONOMY = 238.657637051473  # degrees, of the knot: minus its total torsion
SQUARE = Rectangle(0.4, 0.4)
DRILLED = Outline([ngon((0, 0), 0.5, 24), *(ngon(0.25 * np.array(p), 0.1, 8) for p in ngon((0, 0), 1.0, 4))])
TUBE = Outline([ngon((0, 0), 0.2, 24), ngon((0, 0), 0.1, 24)])
WAVE = "2 + cos(2*pi*t)"
CLOSED = [KNOT, RING, TorusKnot(1, 1), TorusKnot(3, 2, 3.0, 1.0), Polyline(ngon((0, 0), 3, 5) @ np.eye(2, 3), True)]


def components(pairs, count):
    """How many separate parts numbers have that pairs connect."""
    part = np.arange(count)
    while True:
        low = np.minimum(*part[pairs.T])
        found = part.copy()
        for side in pairs.T:
            np.minimum.at(found, side, low)
        found = found[found]
        if (found == part).all():
            return len(np.unique(part))
        part = found


def sides(mesh):
    """How many parts the sharp edges leave of the surface, and how many lines the sharp edges are."""
    topology = mesh.topology
    order = np.argsort(topology.corner_edges, kind="stable")
    face = np.repeat(np.arange(len(mesh.offsets) - 1), np.diff(mesh.offsets))[order].reshape(-1, 2)
    lines, edges = np.unique(mesh.edges[topology.sharp], return_inverse=True)
    return components(face[~topology.sharp], len(mesh.offsets) - 1), components(edges.reshape(-1, 2), len(lines))


def shift(mesh, columns):
    """The columns of the first ring that those of the last one lead to."""
    rings = len(mesh.vertices) // columns
    column, ring = np.divmod(mesh.edges, rings)
    closing = (np.sort(ring, axis=1) == (0, rings - 1)).all(axis=1)
    column, ring = column[closing], ring[closing]
    first = np.take_along_axis(column, ring.argmin(axis=1)[:, None], 1)[:, 0]
    return first[np.argsort(np.take_along_axis(column, ring.argmax(axis=1)[:, None], 1)[:, 0])]


@pytest.mark.parametrize("samples", [40, 333])
@pytest.mark.parametrize("contour", [RegularPolygon(sides, 0.2) for sides in range(3, 9)])
def test_a_knot_is_twisted_by_the_least_that_maps_the_contour_to_itself(contour, samples):
    """The (2, 3) knot brings the normal back turned by 238.66 degrees: a hexagon untwists the 1.34 from 240 alone."""
    mesh = GeneralizedCylinder(contour, KNOT, Count(samples)).mesh()
    sides = len(contour.section().points)
    stations = place(KNOT, Count(samples))
    middle = mesh.vertices.reshape(sides, samples, 3).mean(axis=0)
    e2 = mesh.vertices.reshape(sides, samples, 3)[0] - middle
    twist = np.unwrap(signed_angle(rotation_minimizing(stations)[0], e2, stations.leave))
    step = 360 / sides
    least = (180 / sides - HOLONOMY) % step - 180 / sides
    assert np.abs(twist - twist[0] - radians(least) * stations.t).max() < 1e-11
    back = round((HOLONOMY + least) / step)
    assert shift(mesh, sides).tolist() == [(column + back) % sides for column in range(sides)]
    assert_solid(mesh, euler=0)


@pytest.mark.parametrize("contour", [Circle(0.2), Circle(0.2, points=5), TUBE])
def test_what_is_round_comes_back_as_it_left_so_that_its_texture_meets_itself(contour):
    mesh = GeneralizedCylinder(contour, KNOT, Count(100)).mesh()
    columns = len(contour.section().points)
    assert shift(mesh, columns).tolist() == list(range(columns))
    with pytest.raises(ShapeError, match="^twist: must grow by whole turns along a closed trajectory, got "):
        GeneralizedCylinder(contour, KNOT, twist="pi*t").mesh()


@pytest.mark.parametrize("trajectory", CLOSED)
@pytest.mark.parametrize(
    "contour", [Rectangle(0.2, 0.4), Star(5, 0.3, 0.2), Circle(0.2, points=7), DRILLED, Aerofoil(chord=0.3)]
)
def test_the_last_contour_lies_where_it_leads_to(contour, trajectory):
    """From the last ring on, along the trajectory to the plane of the first, each point meets the one it leads to."""
    section = contour.section()
    mesh = GeneralizedCylinder(contour, trajectory, Count(4000), RotationMinimizing(extra_sectors=1)).mesh()
    columns = mesh.vertices.reshape(len(section.points), -1, 3)
    first, last, ahead = columns[:, 0], columns[:, -1], place(trajectory, Count(4000)).arrive[0]
    normal = np.linalg.svd(first - first.mean(axis=0))[2][2]
    expected = last + ((first.mean(axis=0) - last) @ normal / (ahead @ normal))[:, None] * ahead
    assert np.linalg.norm(expected - first[shift(mesh, len(section.points))], axis=1).max() < 1e-3


@pytest.mark.parametrize("quarters", [0, 1, 2, 3, -1, 5])
@pytest.mark.parametrize("samples", [Count(3), Count(64), Tolerance()])
def test_a_square_ring_has_as_many_sides_as_its_turn_leaves(quarters, samples):
    """gcd(4, quarters) sides and as many edges: a quarter turn leaves one of each, and the solid a ring."""
    mesh = GeneralizedCylinder(SQUARE, RING, samples, RotationMinimizing(extra_sectors=quarters)).mesh()
    assert_solid(mesh, euler=0)
    assert sides(mesh) == (gcd(4, quarters), gcd(4, quarters))
    by_law = GeneralizedCylinder(SQUARE, RING, samples, twist=f"{quarters}*pi/2*t").mesh()
    assert np.abs(by_law.vertices - mesh.vertices).max() < 1e-14 and by_law.topology is mesh.topology


@pytest.mark.parametrize("sectors", range(8))
@pytest.mark.parametrize("contour", [*(RegularPolygon(sides, 0.2) for sides in (3, 5, 6, 8)), Star(4, 0.3, 0.2)])
def test_sides_join_into_the_greatest_common_divisor(contour, sectors):
    mesh = GeneralizedCylinder(contour, TorusKnot(1, 1), frame=RotationMinimizing(extra_sectors=sectors)).mesh()
    symmetry, corners = contour.section().symmetry, len(contour.section().points)
    joined = gcd(symmetry, round_trip(mesh, symmetry, corners))
    assert sides(mesh) == (joined * corners // symmetry,) * 2
    assert_solid(mesh, euler=0)


def round_trip(mesh, symmetry, corners):
    """By how many sectors the contour comes back turned."""
    return int(shift(mesh, corners)[0]) * symmetry // corners


def test_a_band_of_half_a_turn_has_one_side():
    """Moebius: a flat rectangle's four sides become two, and once round its middle line one has changed sides."""
    band = GeneralizedCylinder(Rectangle(0.05, 0.6), RING, Count(200), twist="pi*t").mesh()
    assert sides(band) == (2, 2)
    assert shift(band, 4).tolist() == [2, 3, 0, 1]
    assert_solid(band, euler=0)


@pytest.mark.parametrize(("sectors", "tubes"), [(0, 5), (1, 2), (2, 3), (3, 2)])
def test_holes_become_one_that_goes_round_several_times(sectors, tubes):
    """The rim is one tube of its own, four holes on a circle become gcd(4, sectors)."""
    mesh = GeneralizedCylinder(DRILLED, RING, Count(60), RotationMinimizing(extra_sectors=sectors)).mesh()
    assert_solid(mesh, euler=0)
    assert components(mesh.edges, len(mesh.vertices)) == tubes


@pytest.mark.parametrize("quarters", [1, 2, 7])
def test_a_twisted_ring_has_the_volume_of_pappus(quarters):
    """The centroid's way times the area, whatever the twist (Goodman and Goodman 1969); steps cost their square."""
    lacking = []
    for samples in (100, 200):
        mesh = GeneralizedCylinder(SQUARE, RING, Count(samples), twist=f"{quarters}*pi/2*t").mesh()
        lacking.append(1 - mesh.volume() / (0.16 * tau * 2))
    step = np.hypot(tau, quarters * pi / 2) / 200
    assert 0 < lacking[1] < step**2 and lacking[0] / lacking[1] == pytest.approx(4, rel=0.01)


@pytest.mark.parametrize("trajectory", CLOSED)
@pytest.mark.parametrize("frame", [RotationMinimizing(1), Frenet(), Frenet(Continuation.EXACT), FixedUp()])
@pytest.mark.parametrize("laws", [{}, {"twist": "pi*t/2"}, {"scale_x": -1.0}, {"scale_x": WAVE, "twist": "pi*t"}])
def test_every_frame_closes(frame, laws, trajectory):
    mesh = GeneralizedCylinder(SQUARE, trajectory, frame=frame, **laws).mesh()
    assert_solid(mesh, euler=0)
    if not isinstance(frame, RotationMinimizing):
        back = round(4 * {"pi*t/2": 1 / 4, "pi*t": 1 / 2}.get(laws.get("twist"), 0))
        assert shift(mesh, 4).tolist() == [(column + back) % 4 for column in range(4)]


@given(
    st.sampled_from([SQUARE, Rectangle(0.2, 0.4, 0.05), Star(7, 0.3, 0.1), Circle(0.2, points=9), DRILLED, Aerofoil()]),
    st.sampled_from(CLOSED),
    st.one_of(st.builds(Tolerance, st.floats(1e-3, 0.1)), st.builds(Count, st.integers(60, 150))),
    st.sampled_from([Frenet(), FixedUp((1, 2, 3))])
    | st.builds(RotationMinimizing, st.integers(-2, 2), st.integers(-9, 9)),
    st.sampled_from([(1.0, 1.0), (-0.7, 0.7), (0.5, 1.0), (WAVE, WAVE), (1.0, WAVE)]),
    st.integers(-9, 9),
)
def test_a_ring_of_any_sectors_is_a_solid(contour, trajectory, samples, frame, scales, sectors):
    section, (x, y) = contour.section(), scales
    symmetry = section.symmetry if x in (y, -0.7) else gcd(section.symmetry, 2)
    contour = Outline([0.1 * section.points[a:b] for a, b in pairwise(section.offsets)])
    twist = f"{sectors}/{symmetry}*2*pi*t"
    shape = GeneralizedCylinder(contour, trajectory, samples, frame, x, y, twist)
    assert_solid(shape.mesh(), euler=0)


@pytest.mark.parametrize("scale", ["sin(pi*t)", "abs(1 - 2*t)", "sin(2*pi*t)"])
@pytest.mark.parametrize("twist", ["pi*t/2", "-pi*t"])
def test_a_ring_with_tips_closes_in_any_turn(scale, twist):
    """A ring has the Euler characteristic 0, and each tip adds one."""
    mesh = GeneralizedCylinder(SQUARE, RING, Count(60), scale_x=scale, scale_y=scale, twist=twist).mesh()
    assert_solid(mesh, euler=2 if scale == "sin(2*pi*t)" else 1)


@pytest.mark.parametrize(
    ("contour", "laws", "symmetry"),
    [
        (SQUARE, {}, 4),
        (SQUARE, {"scale_y": -1.0}, 4),
        (SQUARE, {"scale_x": "1 + t*(1 - t)", "scale_y": "1 + t*(1 - t)"}, 4),
        (SQUARE, {"scale_x": 2.0}, 2),
        (SQUARE, {"scale_x": "1 + t*(1 - t)"}, 2),
        (SQUARE, {"offset_x": 0.1}, 1),
        (SQUARE, {"offset_y": "sin(2*pi*t)"}, 1),
        (Star(5), {"scale_x": 2.0}, 1),
        (Star(6), {}, 6),
        (Star(6), {"scale_x": 2.0}, 2),
        (Aerofoil(), {}, 1),
    ],
)
def test_twist_may_grow_by_the_turns_that_the_laws_leave(contour, laws, symmetry):
    for turns in (1 / symmetry, -3 / symmetry):
        assert_solid(
            GeneralizedCylinder(contour, Arc(20.0, tau), Count(50), twist=f"{turns}*2*pi*t", **laws).mesh(), euler=0
        )
    sentence = f"multiples of 1/{symmetry} turn" if symmetry > 1 else "whole turns"
    with pytest.raises(ShapeError, match=f"^twist: must grow by {sentence} along a closed trajectory, got "):
        GeneralizedCylinder(contour, RING, twist=f"{1 / (2 * symmetry)}*2*pi*t", **laws).mesh()


def test_dragging_what_does_not_move_the_seam_keeps_the_topology():
    """Twist, size, and a trajectory whose holonomy stays nearest to the same sector: 1.3 degrees from it here."""
    knot = GeneralizedCylinder(RegularPolygon(6, 0.2), KNOT, Count(100))
    first = knot.mesh().topology
    for other in (
        GeneralizedCylinder(RegularPolygon(6, 0.2), KNOT, Count(100), twist=0.3),
        GeneralizedCylinder(RegularPolygon(6, 0.1), KNOT, Count(100), scale_x=0.5, scale_y=0.5),
        GeneralizedCylinder(RegularPolygon(6, 0.2), TorusKnot(2, 3, 2.0, 0.82), Count(100)),
        GeneralizedCylinder(RegularPolygon(6, 0.2), KNOT, Count(100), RotationMinimizing(extra_turns=1)),
    ):
        assert other.mesh().topology is first
    turned = GeneralizedCylinder(RegularPolygon(6, 0.2), KNOT, Count(100), RotationMinimizing(extra_sectors=1)).mesh()
    assert turned.topology.key != first.key


@pytest.mark.parametrize("trajectory", [Line(end=(0, 0, 2)), Bezier(), RING])
def test_extra_turns_are_sampled_as_the_same_twist_is(trajectory):
    """A line of two contours would show none of them."""
    for frame, turns in ((RotationMinimizing(3), 3), (RotationMinimizing(-1, extra_sectors=-2), -1.5)):
        turned = GeneralizedCylinder(SQUARE, trajectory, frame=frame).mesh()
        twisted = GeneralizedCylinder(SQUARE, trajectory, twist=f"{turns}*2*pi*t").mesh()
        assert turned.rings == twisted.rings > 12 * abs(turns)
        assert np.abs(turned.vertices - twisted.vertices).max() < 1e-12
