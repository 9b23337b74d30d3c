# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Corners of straight legs: mitred, round or bevelled, they have the lengths and volumes that geometry gives them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solids import assert_solid, box

from sweep_addon.core.contours import Circle, Fit, Outline, Rectangle, fitted
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.rings.corners import Bevel, Mitre, Round
from sweep_addon.core.rings.ends import Flat, Open, Taper
from sweep_addon.core.rings.ends import Round as Dome
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import FixedUp, Frenet, RotationMinimizing
from sweep_addon.core.stations.sampling import Count, Tolerance, place
from sweep_addon.core.trajectories import Arc, Formula, Polyline

ANGLES = [5, 20, 60, 90, 120, 150, 170, 175]
ZIGZAG = [(0, 0, 0), (2, 0, 0), (2, 1.5, 0), (3, 2, 1), (4, 0, 1)]


def elbow(degrees, corner):
    """Two legs of 5 m that turn by an angle."""
    turn = np.radians(degrees)
    steps = [(0, 0, 0), (5, 0, 0), (5 * np.cos(turn), 3 * np.sin(turn), 4 * np.sin(turn))]
    return Polyline(np.cumsum(steps, axis=0), False, corner)


def turns(path):
    """The angles between legs that follow each other."""
    legs = path.legs / np.linalg.norm(path.legs, axis=1, keepdims=True)
    ahead = np.roll(legs, -1, axis=0) if path.closed else legs[1:]
    return np.arccos(np.einsum("ij,ij->i", legs[: len(ahead)], ahead))


@pytest.mark.parametrize("closed", [False, True])
def test_lengths_are_those_of_elementary_geometry(closed):
    """An arc takes its two tangents and gives radius times turn; a bevel the base of an isosceles triangle."""
    mitred = Polyline(ZIGZAG, closed)
    half, whole = turns(mitred) / 2, mitred.length()
    rounded, bevelled = Polyline(ZIGZAG, closed, Round(0.2)), Polyline(ZIGZAG, closed, Bevel(0.4))
    assert rounded.length() == pytest.approx(whole - (0.2 * 2 * (np.tan(half) - half)).sum(), rel=1e-13)
    assert bevelled.length() == pytest.approx(whole - (0.4 * 2 * (1 - np.cos(half))).sum(), rel=1e-13)


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("corner", [Mitre(), Round(0.2), Bevel(0.4)])
def test_u_counts_the_corners(corner, closed):
    """At whole u is the middle: as far along the path from what comes before the corner as from what comes after."""
    path = Polyline(ZIGZAG, closed, corner)
    inner = np.arange(0 if closed else 1, len(ZIGZAG) - (not closed))
    middle, nearest = path.evaluate(inner), path.evaluate(np.linspace(*path.domain, 20_001))
    points = np.array(ZIGZAG)[inner]
    away = np.linalg.norm(middle - points, axis=1)
    least = np.linalg.norm(nearest[:, None] - points, axis=2).min(axis=0)
    assert away == pytest.approx(least, abs=1e-6)
    assert path.domain == (0, len(ZIGZAG) - (not closed))
    assert path.evaluate(np.array([1.5]))[0] == pytest.approx((2, 0.75, 0), abs=1e-15)


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("corner", [Mitre(), Round(0.2), Bevel(0.4)])
def test_derivatives_are_those_of_the_points(corner, closed):
    path, step = Polyline(ZIGZAG, closed, corner), 1e-5
    u = np.linspace(*path.domain, 501)[1:-1]
    u = u[np.abs(u[:, None] - path.joints()).min(axis=1) > 2 * step]
    for order, asked in ((1, path.evaluate), (2, path.derivative)):
        found = (asked(u + step) - asked(u - step)) / (2 * step)
        scale = np.abs(path.derivative(u, order)).max()
        assert np.abs(path.derivative(u, order) - found).max() <= 1e-7 * scale
    before, after = (path.tangents(path.joints()[1:-1], before) for before in (True, False))
    assert (np.abs(before - after).max() < 1e-14) == isinstance(corner, Round)


def test_a_square_of_round_corners_that_meet_is_a_circle():
    square = Polyline([(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0)], closed=True, corner=Round(1.0))
    points = square.evaluate(np.linspace(0, 4, 1001))
    assert np.abs(np.linalg.norm(points, axis=1) - 1).max() < 1e-15
    assert square.length() == pytest.approx(2 * np.pi, rel=1e-14) and len(square.corners()) == 0
    rings = GeneralizedCylinder(Circle(0.1, 12), square, Count(32)).mesh()
    assert rings.volume() == pytest.approx(
        GeneralizedCylinder(Circle(0.1, 12), Arc(1.0, 2 * np.pi), Count(32)).mesh().volume(), rel=1e-12
    )


def along_legs(tube):
    """How far each column goes with each step, along the leg that the step is on: (m, n) in metres."""
    stations, mesh = tube.swept().stations, tube.mesh()
    columns = mesh.vertices.reshape(-1, len(stations.s), 3)
    steps = columns[:, stations.onward] - columns[:, stations.starts]
    return np.einsum("mni,ni->mn", steps, stations.leave[stations.starts])


@pytest.mark.parametrize("degrees", ANGLES)
@pytest.mark.parametrize("contour", [Circle(0.1, points=9), Rectangle(0.2, 0.1)])
@pytest.mark.parametrize("fit", Fit)
def test_contours_near_a_mitre_do_not_run_through_it(contour, degrees, fit):
    """Both legs are prisms, and no step of a column turns back. A mitre takes off a leg what the contour reaches times
    the tangent of half the turn; steps on twice that, or on the whole leg if it is shorter, share it evenly."""
    tube = GeneralizedCylinder(contour, elbow(degrees, Mitre()), Count(401), fit=fit)
    assert tube.mesh().volume() == pytest.approx(fitted(contour, fit).area * 10, rel=1e-12)
    cut = np.linalg.norm(fitted(contour, fit).points, axis=1).max() * np.tan(np.radians(degrees) / 2)
    step = 5 / 200
    assert along_legs(tube).min() >= step * (1 - max(cut / 5, 0.5)) - 1e-9
    if fit is Fit.INSCRIBED:
        assert not len(tube.self_intersections())


@pytest.mark.parametrize("side", [1, -1])
def test_a_leg_with_no_room_for_both_fans_divides_its_columns_evenly(side):
    """Two right angles 0.3 m apart, each of which takes up to 0.1 m, on one side of the leg or on both."""
    path = Polyline([(0, 0, 0), (2, 0, 0), (2, 0.3, 0), (2 - 2 * side, 0.3, 0)])
    tube = GeneralizedCylinder(Circle(0.1, 12), path, Count(400))
    u = tube.swept().stations.u
    on = np.flatnonzero((u >= 1) & (u <= 2))
    columns = tube.mesh().vertices.reshape(12, -1, 3)[:, on]
    expected = columns[:, :1] + (u[on] - 1)[:, None] * (columns[:, -1:] - columns[:, :1])
    assert len(on) > 20 and np.abs(columns - expected).max() < 1e-12
    assert along_legs(tube).min() > 0 and not len(tube.self_intersections())


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("corner", [Mitre(), Mitre(1.1), Bevel(0.2)])
@pytest.mark.parametrize(
    "laws", [{}, {"scale_x": [(0, 1), (0.5, 0.2), (1, 1)], "scale_y": [(0, 1), (0.5, 0.2), (1, 1)]}]
)
def test_many_contours_on_many_legs_keep_their_order(closed, corner, laws):
    """Also where a scale changes on the way, on legs round a hexagon, bevelled or not."""
    angle = np.radians(60) * np.arange(6)
    path = Polyline(np.column_stack((np.cos(angle), np.sin(angle), 0 * angle)), closed, corner)
    tube = GeneralizedCylinder(Circle(0.2, 12), path, Count(400), **laws)
    assert_solid(tube.mesh(), 0 if closed else 2)
    assert along_legs(tube).min() > 0 and not len(tube.self_intersections())


@pytest.mark.parametrize("degrees", ANGLES)
@pytest.mark.parametrize("fit", Fit)
def test_twisted_legs_are_solids_of_the_volume_of_their_length(degrees, fit):
    """A turn of a square about its centre keeps its area: chords across h radians lack h^2 / 6 of it."""
    tube = GeneralizedCylinder(
        Rectangle(0.1, 0.1), elbow(degrees, Mitre()), Count(400), twist=[(0, 0), (1, 4)], fit=fit
    )
    mesh = tube.mesh()
    assert_solid(mesh, 2)
    if fit is Fit.CIRCUMSCRIBED:
        assert 0.1 < mesh.volume() < 0.1 * 1.02
    else:
        assert mesh.volume() == pytest.approx(0.1, rel=(4 / 399) ** 2 / 6 * 1.1)
        assert not len(tube.self_intersections())


def test_a_straight_leg_leans_where_the_other_one_is_curved():
    """A formula whose first half is straight: there the steps of the innermost column are half as long at a mitre."""
    path = Formula("u", "max(-u, 0)*3 + max(u, 0)^2", "0", start=-1, end=1)
    tube = GeneralizedCylinder(Circle(0.1, 12), path, Count(200))
    stations = tube.swept().stations
    (corner,) = stations.corners
    step = stations.s[corner] / corner
    assert along_legs(tube)[:, :corner].min() == pytest.approx(step / 2, rel=1e-6)


@pytest.mark.parametrize("samples", [Tolerance(), Count(400)])
@pytest.mark.parametrize(("side", "safe"), [(1, 0.25), (-1, 2.0)])
def test_contours_between_mitres_do_not_change_which_size_is_safe(samples, side, safe):
    """Two right angles 0.5 m apart take a radius each of what is between them, or on opposite sides none of it: then
    each takes its radius off a leg of 2 m."""
    path = Polyline([(0, 0, 0), (2, 0, 0), (2, 0.5, 0), (2 - 2 * side, 0.5, 0)])
    found = GeneralizedCylinder(Circle(0.1, 16), path, samples).self_intersections()
    assert found.largest_safe_size == pytest.approx(safe, rel=1e-6)


@pytest.mark.parametrize("degrees", ANGLES)
@pytest.mark.parametrize("contour", [Circle(0.1, points=9), Rectangle(0.2, 0.1)])
@pytest.mark.parametrize("closed", [False, True])
def test_a_bevelled_corner_has_the_volume_of_the_bevelled_path(contour, degrees, closed):
    """Each of its mitres takes from one side what it gives to the other, if the centroid is on the path."""
    path = elbow(degrees, Bevel(0.5))
    if closed:
        path = Polyline(path.points, True, Bevel(0.2))
    mesh = GeneralizedCylinder(contour, path).mesh()
    assert mesh.volume() == pytest.approx(contour.section().area * path.length(), rel=1e-12)


@pytest.mark.parametrize("degrees", ANGLES)
@pytest.mark.parametrize("tolerance", [1e-3, 1e-5])
def test_a_round_corner_has_the_volume_of_the_rounded_path(degrees, tolerance):
    """Weyl 1939. Where chords of length h stand for an arc of curvature k, they lack a 6th of (k h)^2 of the volume,
    and (k h)^2 is 8 tolerances times k at most."""
    radius = 0.2
    path, contour = elbow(degrees, Round(radius)), Circle(0.1, points=9)
    mesh = GeneralizedCylinder(contour, path, Tolerance(tolerance)).mesh()
    lacking = 1 - mesh.volume() / (contour.section().area * path.length())
    bent = radius * np.radians(degrees) / path.length()
    assert 0 < lacking < bent * 8 * tolerance / radius / 6 * 1.01


@pytest.mark.parametrize("samples", [Tolerance(1e-3), Tolerance(0.05), Tolerance(10.0), Count(2), Count(40)])
@pytest.mark.parametrize("closed", [False, True])
def test_contours_stand_where_arcs_begin_and_end(samples, closed):
    """So that straight legs stay straight, and chords lie on one side of an arc, within the tolerance."""
    path = Polyline(ZIGZAG, closed, Round(0.2))
    stations = place(path, samples)
    half = turns(path) / 2
    starts = np.abs(stations.points[:, None] - path.evaluate(path.stops())).max(axis=2).min(axis=0)
    assert len(path.stops()) == 2 * len(half) and starts.max() < 1e-14
    if isinstance(samples, Tolerance):
        s = np.append(stations.s, stations.total) if closed else stations.s
        u = np.append(stations.u, path.domain[1]) if closed else stations.u
        away = path.evaluate((u[1:] + u[:-1]) / 2) - (path.evaluate(u[1:]) + path.evaluate(u[:-1])) / 2
        bent = np.linalg.norm(np.cross(away, np.diff(path.evaluate(u), axis=0)), axis=1) / np.diff(s)
        assert bent.max() <= samples.chord


@pytest.mark.parametrize("degrees", ANGLES)
def test_a_mitre_limit_is_that_of_svg(degrees):
    """Miter length / stroke width = 1 / sin(theta / 2), theta the angle between the legs; beyond the limit there is a
    bevel between the outer corners of the legs: SVG 2, 13.5.5."""
    turn = np.radians(degrees)
    ratio = 1 / np.sin((np.pi - turn) / 2)
    path = [(0, 0, 0), (9, 0, 0), (9 + 9 * np.cos(turn), 9 * np.sin(turn), 0)]
    outside = 0.1 * np.array([(0, -1, 0), (np.sin(turn), -np.cos(turn), 0)])

    def corner(limit):
        mesh = GeneralizedCylinder(Circle(0.1, 8), Polyline(path, corner=Mitre(limit))).mesh()
        assert not len(mesh.boundary_edges()) and mesh.volume() > 0
        return mesh.vertices.reshape(8, -1, 3)[:, 1:-1] - path[1], mesh.told

    rings, told = corner(ratio + 1e-9)
    assert rings.shape[1] == 1 and told == ()
    assert np.linalg.norm(rings, axis=2).max() == pytest.approx(0.1 * ratio, rel=1e-12)

    limit = max(ratio - 1e-9, 1.0)
    rings, (told,) = corner(limit)
    assert rings.shape[1] == 2
    assert np.abs(rings - outside).max(axis=2).min(axis=0).max() < 1e-14
    said = f"the mitre at point 2 would be {ratio:.3g} widths long, and the limit is {limit:.9g}"
    assert told == f"Corner: {said}; it is bevelled."


@pytest.mark.parametrize("degrees", ANGLES[2:-1])
@pytest.mark.parametrize("contour", [Circle(0.1, points=9), Rectangle(0.2, 0.1)])
@pytest.mark.parametrize("fit", Fit)
def test_a_bevel_for_a_mitre_has_the_volume_of_both_legs_and_what_lies_between(contour, degrees, fit):
    """The inner edges of both legs meet r tan(f) before the corner, f half the turn and r as far as the contour
    reaches; the outer edges end square to it. So the legs lack s = r tan(f) / 2 each, and between them columns are
    straight, in the middle 2 s cos(f) long, and their section is cos(f) + sin(f) s / r times as wide."""
    half, reach = np.radians(degrees) / 2, 2 * np.linalg.norm(fitted(contour, fit).points, axis=1).max()
    mesh = GeneralizedCylinder(contour, elbow(degrees, Mitre(1.1)), scale_x=2, scale_y=2, fit=fit).mesh()
    cut = 1.001 * reach * np.tan(half) / 2  # a thousandth more keeps the inner edges apart
    length = 10 - 2 * cut + 2 * cut * np.cos(half) * (np.cos(half) + np.sin(half) * cut / reach)
    assert mesh.told and mesh.volume() == pytest.approx(4 * fitted(contour, fit).area * length, rel=1e-12)


@pytest.mark.parametrize("degrees", ANGLES[2:])
def test_nothing_of_a_bevel_for_a_mitre_runs_back(degrees):
    """Its inner edge is nearly a point: that of the mitre, where the inner sides of both legs meet."""
    turn = np.radians(degrees)
    path = [(0, 0, 0), (9, 0, 0), (9 + 9 * np.cos(turn), 9 * np.sin(turn), 0)]
    mesh = GeneralizedCylinder(Circle(0.1, 8), Polyline(path, corner=Mitre(1.1))).mesh()
    assert_solid(mesh, euler=2)
    rings = mesh.vertices.reshape(8, 4, 3)
    steps = np.diff(rings, axis=1)
    across = rings[:, 2].mean(axis=0) - rings[:, 1].mean(axis=0)
    assert (steps[:, 0] @ (1, 0, 0)).min() > 0 and (steps[:, 1] @ across).min() > 0
    inner = path[1] + 0.1 / np.cos(turn / 2) * np.array((-np.sin(turn / 2), np.cos(turn / 2), 0))
    assert np.linalg.norm(rings[:, 1:3] - inner, axis=2).min(axis=0).max() < 0.001 * 0.1 * np.tan(turn / 2) * 1.01


@pytest.mark.parametrize("samples", [Tolerance(), Count(60)])
def test_all_corners_of_a_closed_path_are_bevelled_alike(samples):
    """u begins in the middle of the first bevel, so there a contour stands on it."""
    square = Polyline([(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0)], closed=True, corner=Mitre(1.1))
    mesh = GeneralizedCylinder(Circle(0.1, 12), square, samples).mesh()
    assert_solid(mesh, euler=0)
    cut, root = 1.001 * 0.1 / 2, np.sqrt(0.5)
    length = 8 + 4 * (2 * cut * root * (root + root * cut / 0.1) - 2 * cut)
    assert mesh.volume() == pytest.approx(Circle(0.1, 12).section().area * length, rel=1e-12)


def test_all_mitres_beyond_the_limit_are_bevelled_and_the_first_is_named():
    path = Polyline([(0, 0, 0), (1, 0, 0), (2, 0.1, 0), (1, 0.2, 0), (2, 0.3, 0), (3, 0.3, 0)], corner=Mitre(4))
    tube = GeneralizedCylinder(Circle(0.01), path)
    mesh = tube.mesh()
    assert mesh.rings == 6 + 2
    assert mesh.told == (
        "Corner: the mitre at point 3 would be 10 widths long, and the limit is 4; it and 1 more are bevelled.",
    )
    where = np.unique(mesh.attributes["u"])
    assert np.abs(where[[0, 1, -2, -1]] - (0, 1, 4, 5)).max() < 1e-12 and ((2 < where) & (where < 3)).sum() == 2


def test_a_bevel_for_a_mitre_leaves_a_third_of_each_leg():
    """However wide the contour is."""
    path = Polyline([(0, 0, 0), (1, 0, 0), (0, 0.1, 0), (1, 0.2, 0)], corner=Mitre(2))
    mesh = GeneralizedCylinder(Circle(0.5), path).mesh()
    assert np.unique(mesh.attributes["u"]) == pytest.approx([0, 2 / 3, 4 / 3, 5 / 3, 7 / 3, 3], abs=2e-3)


@pytest.mark.parametrize("far", [1.0, 1e6])
@pytest.mark.parametrize("corner", [Round, Bevel])
def test_corners_that_do_not_fit_are_refused_with_the_largest_that_do(corner, far):
    """The second leg has both corners of a right angle at its ends: half of it for each."""
    path = far * np.array([(0, 0, 0), (3, 0, 0), (3, 1, 0), (9, 1, 0)])
    with pytest.raises(ShapeError) as refusal:
        Polyline(path, corner=corner(0.6 * far))
    name = {Round: "radius", Bevel: "setback"}[corner]
    sentence = f"must be at most {0.5 * far:.7g} to fit into the leg from point 2 to point 3"
    assert str(refusal.value) == f"corner.{name}: {sentence}, got {0.6 * far:.9g}"
    fitting = Polyline(path, corner=corner(0.5 * far))
    assert_solid(GeneralizedCylinder(Circle(0.05 * far, 8), fitting, Tolerance(1e-3 * far)).mesh(), euler=2)
    as_blender_keeps_it = float(np.float32(0.5 * far)) * (1 + 6e-8)
    assert Polyline(path, corner=corner(as_blender_keeps_it)).length() == pytest.approx(fitting.length(), rel=1e-7)


@pytest.mark.parametrize("corner", [Round, Bevel])
def test_the_number_that_a_refusal_names_is_taken(corner):
    """Whether it is typed as it is written or kept by Blender in single precision."""
    for points in np.random.default_rng(3).normal(size=(50, 5, 3)):
        with pytest.raises(ShapeError) as refusal:
            Polyline(points, True, corner(1e9))
        most = float(refusal.value.sentence.split("at most ")[1].split()[0])
        for taken in (most, float(np.float32(most))):
            path = Polyline(points, True, corner(taken))
            assert path.evaluate(np.array([0.0, 5.0]))[0] == pytest.approx(path.evaluate(np.array([5.0]))[0])


@pytest.mark.parametrize("corner", [Round(1e-9), Bevel(1e-9)])
def test_a_corner_too_small_to_be_seen_is_mitred(corner):
    mesh, mitred = (GeneralizedCylinder(trajectory=Polyline(ZIGZAG, corner=c)).mesh() for c in (corner, Mitre()))
    assert np.array_equal(mesh.vertices, mitred.vertices)


def test_points_on_a_line_are_no_corners():
    straight = [(0, 0, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0)]
    for corner in (Round(0.9), Bevel(0.9)):
        path = Polyline(straight, corner=corner)
        assert path.evaluate(np.array([1.0])).tolist() == [[1.0, 0.0, 0.0]]
        assert len(place(path, Tolerance(10.0)).s) == {Round: 5, Bevel: 4}[type(corner)]


@st.composite
def legs(draw):
    """Points of a path whose legs turn by less than 170 degrees, open or closed, and the room of its corners."""
    numbers = st.floats(-1, 1, allow_nan=False)
    steps = np.array(draw(st.lists(st.tuples(st.floats(0.4, 1), numbers, numbers), min_size=3, max_size=8)))
    if draw(st.booleans()):
        return np.cumsum(steps, axis=0), False
    angle = 2 * np.pi * np.arange(len(steps)) / len(steps)
    radius = 2 + 0.4 * steps[:, 1]
    return np.column_stack((radius * np.cos(angle), radius * np.sin(angle), steps[:, 2])), True


@given(
    legs(),
    st.sampled_from([Mitre, Round, Bevel]),
    st.floats(0.01, 1.0),
    st.sampled_from([Circle(0.02, 7), Rectangle(0.03, 0.02, 0.005), Outline([box((-0.01, 0), (0.02, 0.01))])]),
    st.one_of(st.builds(Tolerance, st.floats(1e-3, 0.1)), st.builds(Count, st.integers(2, 90))),
    st.sampled_from([RotationMinimizing(), RotationMinimizing(1), Frenet(), FixedUp()]),
    st.lists(st.sampled_from([Flat(), Open(), Taper(0.1), Dome(), Dome(0.3)]), min_size=2, max_size=2),
)
def test_every_path_of_straight_legs_is_a_solid(path, kind, part, contour, samples, frame, ends):
    points, closed = path
    corner = Mitre(1 + part)
    if kind is not Mitre:
        try:
            Polyline(points, closed, kind(100.0))
        except ShapeError as refusal:
            corner = kind(part * float(refusal.sentence.split("at most ")[1].split()[0]))
    shape = GeneralizedCylinder(contour, Polyline(points, closed, corner), samples, frame, start=ends[0], end=ends[1])
    opened = 0 if closed else sum(isinstance(end, Open) for end in ends)
    assert_solid(shape.mesh(), 0 if closed else 2 - opened, opened * len(contour.section().points))
