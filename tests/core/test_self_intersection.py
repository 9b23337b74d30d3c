# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection against closed forms, all pairs of triangles, and the volume that is really there."""

import numpy as np
import pytest
from brute_force import crossing_faces, tube_volume
from conftest import FULL
from test_reach import helix_reach

from sweep_addon.core.contours import Circle, Ellipse, Outline, Rectangle, RegularPolygon, Star
from sweep_addon.core.rings.corners import Mitre, Round
from sweep_addon.core.self_intersection.faces import faces_of
from sweep_addon.core.self_intersection.folds import roots, turning_back
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import RotationMinimizing
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Formula, Helix, Line, Polyline, TorusKnot

KNOT = TorusKnot(2, 3, major=2.0, minor=0.8)
PARABOLA = Formula("u", "4*u^2", "0", start=-1.0, end=1.0)
EIGHT = Formula("sin(u)", "sin(u)*cos(u)", "0", start=0.3, end=0.3 + 2 * np.pi)
RING = Arc(radius=1.0, angle=2 * np.pi)
HOOK = [(0, 0, 0), (10, 0, 0), (10, 5, 0), (5, 5, 0), (5, 1, 0)]  # ends one metre from its first leg, at a right angle
BRIDGE = [(0, 0, 0), (10, 0, 0), (10, 0, 4), (10, 8, 4), (10, 8, 1), (5, 8, 1), (5, -8, 1)]  # passes a metre above
LOOP = [(0, 0, 0), (4, 0, 0), (4, 4, 1), (0, 4, 2)]
L = Outline([[(0, 0), (2, 0), (2, 0.6), (0.6, 0.6), (0.6, 2), (0, 2)]])
FRAME = Outline([[(-1, -1), (1, -1), (1, 1), (-1, 1)], [(-0.6, -0.6), (0.6, -0.6), (0.6, 0.6), (-0.6, 0.6)]])


def found(contour, trajectory, *samples, **given):
    return GeneralizedCylinder(contour, trajectory, *samples, **given).self_intersections()


TUBES = {
    "knot whose two strands are opposite": (KNOT, 0.8, "global"),
    "torus": (RING, 1.0, "local"),
    "parabola": (PARABOLA, 1 / 8, "local"),
    "helix": (Helix(radius=1.0, pitch=0.5, turns=3.0), helix_reach(0.5), "global"),
    "hook whose end meets its start": (Polyline(HOOK, corner=Round(2.0)), 1.0, "global"),
}


@pytest.mark.parametrize("name", TUBES)
def test_a_round_tube_is_clean_up_to_the_closed_form(name):
    trajectory, radius, kind = TUBES[name]
    thin, thick = (found(Circle(radius * factor), trajectory) for factor in (1 - 1e-4, 1 + 1e-4))
    assert not thin and kind in {place.kind for place in thick}
    assert thin.largest_safe_size == pytest.approx(radius, rel=1e-9) == thick.largest_safe_size


@pytest.mark.parametrize(("radius", "clean"), [(0.7999, True), (0.8001, False)])
def test_the_verdict_is_that_of_the_true_shape_however_coarse_the_mesh(radius, clean):
    for contours in (12, 400, 10_000):
        assert (len(found(Circle(radius), KNOT, Count(contours))) == 0) is clean


def test_a_scale_that_does_not_change_counts_in_the_radius():
    places = found(Circle(0.5), KNOT, scale_x=2.0, scale_y=2.0)
    assert places and places.unit == "radius" and places.largest_safe_size == pytest.approx(0.4, rel=1e-9)


def test_nowhere_on_a_helix_is_the_critical_pair_alone_and_it_is_found_all_the_same():
    """All pairs a turn or so apart are as near: Newton's method without a pseudo-inverse divides by nothing there."""
    helix = Helix(radius=1.0, pitch=0.5, turns=3.0)
    (place, *_) = found(Circle(0.26), helix)
    (a, b), (c, d) = place.parameters
    assert place.kind == "global" and a == 0 and b - a == pytest.approx(d - c, rel=0.02)
    apart = np.linalg.norm(np.diff(helix.evaluate(np.array([a, c])), axis=0))
    assert apart == pytest.approx(2 * helix_reach(0.5), rel=0.01)


def test_a_fold_is_where_the_curvature_of_a_parabola_reaches_one_over_the_radius():
    """y = 4 x^2 has the curvature 8 / (1 + 64 x^2)^(3/2)."""
    for radius in (0.13, 0.3, 1.0):
        (a, b), = found(Circle(radius), PARABOLA, Count(100))[0].parameters  # fmt: skip
        x = np.sqrt((8 * radius) ** (2 / 3) - 1) / 8
        assert (a, b) == pytest.approx((-x, x), abs=1e-6)


@pytest.mark.parametrize("turn", [0.0, 0.5, 1.0])
def test_of_a_fold_only_what_the_contour_reaches_towards_the_centre_counts(turn):
    """A rectangle turned by phi about the tangent reaches a cos(phi) + b sin(phi) towards the centre of a ring."""
    reached = 0.25 * np.cos(turn) + np.sin(turn)
    shapes = [GeneralizedCylinder(Rectangle(x, y), RING, Count(32), twist=turn) for x, y in ((0.5, 2.0), (2.0, 0.5))]
    safe = [shape.self_intersections().largest_safe_size for shape in shapes]
    assert min(abs(np.array(safe) - 1 / reached)) < 3e-5  # of either, whichever axis lies in the plane of the ring


def test_a_fold_of_a_changing_scale_is_where_the_scaled_radius_is_that_of_curvature():
    law = "1 - 0.5*cos(u)"
    (a, b), = found(Circle(1.0), RING, Count(50), scale_x=law, scale_y=law)[0].parameters  # fmt: skip
    assert (a, b) == pytest.approx((np.pi / 2, 3 * np.pi / 2), abs=1e-6)


def test_a_fold_of_an_ellipse_is_where_its_support_reaches_the_centre():
    """Turned by phi, an ellipse reaches sqrt(a^2 cos^2 phi + b^2 sin^2 phi) towards the centre."""
    places = found(Ellipse(1.5, 0.5), RING, Count(64), twist="u")
    half = np.arccos(np.sqrt((1 - 0.5**2) / (1.5**2 - 0.5**2)))  # there that is the radius of the ring
    folds = [place.parameters[0] for place in places if place.kind == "local"]
    assert [(b - a) % (2 * np.pi) for a, b in folds] == pytest.approx([2 * half] * len(folds), abs=1e-6)
    assert len(folds) == 2 and abs(folds[1][0] - folds[0][0]) == pytest.approx(np.pi, abs=1e-6)


def test_beyond_the_centre_of_curvature_all_along_nothing_folds():
    assert not found(Circle(0.3), RING, Count(32), offset_x=-1.5) or not found(
        Circle(0.3), RING, Count(32), offset_x=1.5
    )
    sides = [len(found(Circle(0.3), RING, Count(32), offset_x=offset)) for offset in (-1.5, 1.5, -1.2, 1.2)]
    assert sides[:2] == [0, 0] and sorted(sides[2:]) == [0, 1]  # on one side it is 0.2 m from the axis of the ring


def test_an_unchanging_orientation_runs_back_from_where_the_tangent_is_in_the_plane():
    """x = u^3 - u runs back between the zeros of 3 u^2 - 1."""
    path = Formula("u^3 - u", "u", "0", start=-2.0, end=2.0)
    (a, b), = turning_back(path, (2, 0, 0), np.linspace(-2, 2, 41))  # fmt: skip
    assert (a, b) == pytest.approx((-np.sqrt(1 / 3), np.sqrt(1 / 3)), abs=1e-9)
    assert not len(turning_back(path, (0, 1, 0), np.linspace(-2, 2, 41)))


@pytest.mark.parametrize(("side", "kinds"), [(0.39, set()), (0.41, {"corner"})])
def test_two_mitres_of_a_right_angle_need_a_leg_as_long_as_the_contour_is_broad(side, kinds):
    path = Polyline([(0, 0, 0), (4, 0, 0), (4, 0.4, 0), (0, 0.4, 0)])
    places = found(Rectangle(side, side), path)
    assert kinds <= {place.kind for place in places} and bool(places) == bool(kinds)
    assert places.largest_safe_size * side == pytest.approx(0.4, rel=3e-5)
    if kinds:
        assert places[0].parameters == ((1.0, 2.0),) and places[0].sentence == (
            "the leg from u = 1 to 2 is 0.4 m long, and its mitres need 0.41 m."
        )


def test_one_mitre_of_60_degrees_needs_its_tangent_of_the_end():
    leg = 0.5 * np.tan(np.radians(30))
    for factor, kinds in ((1.001, set()), (0.999, {"corner"})):
        turn = np.radians(60)
        path = Polyline([(0, 0, 0), (4, 0, 0), (4 + factor * leg * np.cos(turn), factor * leg * np.sin(turn), 0)])
        assert {place.kind for place in found(Rectangle(1, 1), path)} - {"ends"} == kinds


@pytest.mark.parametrize("contour", [Rectangle(2, 2), FRAME, Rectangle(2, 0.3)])
def test_an_end_that_reaches_a_leg_is_told_with_both_places(contour):
    """The sides are 1 m from the trajectory: they reach what is 1 m away when they are any larger."""
    path = Polyline(HOOK)
    assert not found(contour, path, scale_x=0.999, scale_y=0.999)
    places = found(contour, path, scale_x=1.001, scale_y=1.001)
    assert {"global", "ends"} & {place.kind for place in places}
    for (a, b), (c, d) in (place.parameters for place in places):
        assert 0 <= a <= b <= 1 and 3.99 < c <= d <= 4


def test_of_two_square_beams_that_cross_the_sides_are_the_distance():
    path = Polyline(BRIDGE)
    for side, clean in ((0.999, True), (1.001, False)):
        places = found(Rectangle(side, side), path)
        assert (not places) is clean
        assert places.largest_safe_size * side == pytest.approx(1.0, rel=3e-5)
        for place in places:
            (a, b), (c, d) = place.parameters
            assert 0.44 < a <= b < 0.56 and 5.46 < c <= d < 5.54  # half a metre about the middle of 10 m, and of 16 m
            assert place.point == pytest.approx((5, 0, 0.5), abs=0.51)


CLEAN = {
    "holes": (FRAME, KNOT, {"scale_x": 0.4, "scale_y": 0.4}),
    "a seam that leads to other columns": (RegularPolygon(6, radius=0.7), KNOT, {}),
    "a seam of a square turned": (Rectangle(0.7, 0.7), KNOT, {"frame": RotationMinimizing(extra_sectors=1)}),
    "tips": (Rectangle(0.3, 0.3), Helix(), {"start": "taper", "end": "taper"}),
    "a tip in the middle": (Circle(0.3), Line(), {"scale_x": "1 - 2*t", "scale_y": "1 - 2*t"}),
    "domes": (Circle(0.2), Helix(), {"start": "round", "end": "round"}),
    "mitres": (Star(5), Polyline(BRIDGE), {"scale_x": 0.4, "scale_y": 0.4}),
    "many contours near a mitre": (Rectangle(0.5, 0.5), Polyline(HOOK), {"samples": Count(400)}),
    "a closed path of straight legs": (Rectangle(1, 1), Polyline(LOOP, closed=True), {}),
    "an open end": (L, Helix(radius=3.0, pitch=8.0), {"start": "open", "end": "open"}),
    "a twisted band": (Rectangle(1.0, 0.01), RING, {"twist": "2*pi*t", "scale_x": 0.9, "scale_y": 0.9}),
    "a straight line": (L, Line(), {"twist": "20*t"}),
    "volume-true": (Rectangle(0.5, 0.5), KNOT, {"fit": "area-true"}),
    "enclosing": (Rectangle(0.5, 0.5), KNOT, {"fit": "circumscribed"}),
}  # fmt: skip


@pytest.mark.parametrize("name", CLEAN)
def test_nothing_is_told_of_what_is_clean(name):
    contour, trajectory, given = CLEAN[name]
    shape = GeneralizedCylinder(contour, trajectory, **given)
    assert list(shape.self_intersections()) == []
    assert str(shape.self_intersections()) == "No self-intersection."


def random_shape(seed):
    """A sweep of any contour along a random curve, closed or open, that meets itself or not about as often."""
    random = np.random.default_rng(seed)
    terms = np.arange(1, 4)
    amplitude, phase = random.normal(size=(3, 3)) / terms**1.5, random.uniform(0, 6.28, (3, 3))
    texts = [
        " + ".join(f"({a:.6f})*sin({k}*u + {p:.6f})" for k, a, p in zip(terms, *row, strict=True))
        for row in zip(amplitude, phase, strict=True)
    ]
    closed = random.random() < 0.5
    path = Formula(*texts, start=0.0, end=2 * np.pi if closed else random.uniform(3, 6))
    contours = (Ellipse(1.0, 0.8, points=6), Rectangle(1, 1.6), Star(3), RegularPolygon(3), L, FRAME)
    scale = random.uniform(0.02, 0.16)
    given = {"scale_x": scale, "scale_y": scale}
    if random.random() < 0.3:
        given = dict.fromkeys(given, f"{scale:.4f}*(1 + 0.5*cos(2*pi*t))")
    if random.random() < 0.4:
        given["twist"] = "2*pi*t"
    if not closed:
        given["end"] = random.choice(["flat", "taper", "open"])
    return GeneralizedCylinder(contours[seed % 6], path, Count(int(random.integers(48, 64))), **given)


@pytest.mark.thorough
def test_of_random_curves_the_verdict_is_that_of_all_pairs_of_triangles(draws):
    for seed in range(draws // 5):
        shape = random_shape(seed)
        mesh, places, tangents = shape.mesh(), shape.self_intersections(), shape.swept().stations.tangent
        if np.einsum("ij,ij->i", tangents[1:], tangents[:-1]).min() < 0:
            continue  # nearly a cusp, between two contours: the mesh is far from the shape
        crossing = crossing_faces(mesh)
        kinds = {place.kind for place in places}
        assert not len(crossing) or kinds, seed  # what crosses is told
        assert len(crossing) or not kinds & {"global", "ends"}, seed  # a fold may be too slight for the mesh to show
        assert "local" in kinds or set(crossing) <= set(faces_of(mesh.chart, places)), seed


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(0, 60, 8 if FULL else 16))
def test_up_to_the_largest_safe_size_a_sweep_is_clean_and_no_farther(seed):
    shape = random_shape(seed)
    size = shape.self_intersections().largest_safe_size
    base = shape.scale_x, shape.scale_y
    for factor, clean in ((0.999, True), (1.001, False)):
        laws = [f"({law.text})*{size * factor}" if hasattr(law, "text") else law.value * size * factor for law in base]
        again = GeneralizedCylinder(
            shape.contour, shape.trajectory, shape.samples, twist=shape.twist, scale_x=laws[0], scale_y=laws[1],
            end=shape.end,
        )  # fmt: skip
        assert (not again.self_intersections()) is clean


@pytest.mark.parametrize(("radius", "clean"), [(0.79, True), (0.95, False)])
def test_a_clean_tube_holds_area_times_length_and_no_other(radius, clean):
    """Weyl, On the Volume of Tubes, Am. J. Math. 61, 1939; where it meets itself, that is counted twice."""
    volume, error = tube_volume(KNOT, radius, np.random.default_rng(1))
    weyl = np.pi * radius**2 * KNOT.length()
    assert bool(abs(volume - weyl) < 3 * error) is clean is (not found(Circle(radius), KNOT))
    assert clean or volume < weyl - 6 * error


def test_a_crossing_is_one_place_with_both_stretches():
    """The figure-eight crosses at u = pi and 2 pi, at a right angle: a tube of radius 0.2 over 0.2 m of each."""
    places = found(Circle(0.2), EIGHT, Count(1000))
    (a, b), (c, d) = places[0].parameters
    half = 0.2 / np.sqrt(2)  # there the speed is sqrt(2)
    assert len(places) == 1 and places.largest_safe_size == 0
    assert (a, b) == pytest.approx((np.pi - half, np.pi + half), abs=0.02)
    assert (c, d) == pytest.approx((2 * np.pi - half, 2 * np.pi + half), abs=0.02)
    assert np.linalg.norm(places[0].point) < 0.3


def test_a_stretch_over_the_start_of_a_closed_trajectory_begins_with_the_larger_parameter():
    eight = Formula("sin(u)", "sin(u)*cos(u)", "0", start=np.pi, end=3 * np.pi)
    places = found(Rectangle(0.3, 0.2), eight, Count(400))
    stretches = [stretch for place in places for stretch in place.parameters]
    assert len(places) == 1 and any(a > b for a, b in stretches) and any(a < 2 * np.pi < b for a, b in stretches)


def test_places_are_in_order_and_read_as_sentences():
    places = found(Circle(0.3), PARABOLA)
    assert [place.kind for place in places] == ["local", "global"]
    assert str(places).splitlines() == [*map(str, places), "A radius up to 0.125 m is clear of it."]
    assert places.told == (*(f"Self-intersection: {place}" for place in places), places.advice)
    assert places.in_place_of(("one thing", "Self-intersection: near u = 0.")) == ("one thing", *places.told)
    assert (
        str(places[0]) == "from u = -0.111 to 0.111 the contour reaches the centre of curvature, and the sweep folds."
    )
    assert str(found(Rectangle(1.5, 1.5), KNOT, Count(400))).endswith(
        "A contour scaled by up to 0.7618 is clear of it."
    )


def test_the_faces_of_a_fold_are_those_between_its_parameters():
    shape = GeneralizedCylinder(Circle(0.3, points=8), PARABOLA, Count(101), end="open")
    mesh, places = shape.mesh(), shape.self_intersections()
    faces = faces_of(mesh.chart, places[:1])
    (a, b), = places[0].parameters  # fmt: skip
    stations = mesh.chart.u
    bands = np.flatnonzero((stations[:-1] < b) & (stations[1:] > a))
    assert sorted(set(faces % 100)) == bands.tolist() and len(faces) == 8 * len(bands)


def test_the_face_at_an_end_is_among_the_faces():
    """The face cuts off the top of a leg that is round, 5 cm of it; flat sides of both would lie in one plane."""
    shape = GeneralizedCylinder(Circle(1.05), Polyline(HOOK))
    mesh, places = shape.mesh(), shape.self_intersections()
    assert len(mesh.offsets) - 2 in faces_of(mesh.chart, places) and len(mesh.offsets) - 3 not in faces_of(
        mesh.chart, places
    )


def test_a_bevelled_mitre_is_no_short_leg():
    hairpin = Polyline([(0, 0, 0), (6, 0, 0), (0, 3, 0)], corner=Mitre(limit=1.5))
    assert not found(Rectangle(0.5, 0.5), hairpin)


def test_of_open_lines_the_gap_does_not_cross():
    """A line about the path, its gap where the other strand goes through, as a slotted pipe's slot."""
    arc = [(np.cos(a), np.sin(a)) for a in np.linspace(0.5, 2 * np.pi - 0.5, 12)]
    open_line = Outline([arc], closed=False)
    assert not found(open_line, Helix(radius=4.0, pitch=4.0))
    assert found(open_line, Helix(radius=4.0, pitch=1.0))


def test_a_root_is_found_where_it_is_an_end_of_its_interval_too():
    low, high = np.array([1.0, 0.0, -1.0]), np.array([3.0, 2.0, 1.0])
    found = roots(lambda x: x**3 - 1, low, high, low**3 - 1, high**3 - 1)
    assert np.abs(found - 1).max() < 1e-9
