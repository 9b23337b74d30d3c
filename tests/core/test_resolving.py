# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweeps that meet themselves, resolved into solids."""

import sys
from math import asin, cos, pi, sin, sqrt

import numpy as np
import pytest
from inverse_sweep import estimate
from solids import box

from sweep_addon.core.contours import Circle, Outline, Rectangle, Star
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.resolving.of_rings import solid_of_rings
from sweep_addon.core.resolving.sides import across, halves
from sweep_addon.core.shapes.general_sweep import GeneralSweep
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
from sweep_addon.core.shapes.rotational_sweep import RotationalSweep
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.stations.directions import Arrows
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Formula, Helix, Line, Polyline, Sampled, TorusKnot

EIGHT = Formula("2*sin(u)", "sin(2*u)", "0", start=0.0, end=2 * pi)
PARABOLA = Formula("u", "4*u^2", "0", start=-1.0, end=1.0)
CROSSING = Polyline([(-2, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, -2, 0)])
SPINDLE = GeneralizedCylinder(Circle(0.5, points=32), Arc(0.3, 2 * pi), Count(64))
THREAD = Outline([[(1, 0), (2, 0), (2, 0.5), (1, 0.5)]])


@pytest.fixture(autouse=True)
def manifold3d():
    return pytest.importorskip("manifold3d")


def square(size):
    return size / 2 * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def ring(radius, points=24):
    return Circle(radius, points=points).section().points


def assert_valid(mesh):
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    assert len(mesh.dimensions().singular_points) == 0 and mesh.volume() > 0


def assert_no_slivers(mesh):
    """Single precision is what Blender keeps."""
    single = mesh.astype(np.float32)
    assert len(np.unique(single.vertices, axis=0)) == len(single.vertices)
    assert np.linalg.norm(single.astype(float).normals, axis=1).min() > 0


def genus(mesh):
    return 1 - mesh.euler_characteristic() // 2


def test_two_legs_that_cross_count_once_where_they_do():
    """Weyl: a leg has the volume of its section times its length; two beams that cross have a cube in common."""
    solid = GeneralizedCylinder(Rectangle(0.5, 0.5), CROSSING).solid()
    assert solid.volume() == pytest.approx(0.25 * 12 - 0.5**3, rel=1e-13)
    assert_valid(solid)
    assert genus(solid) == 1 and solid.dimensions().solids == 1


def test_hollow_beams_that_cross_keep_their_cavities():
    """Their walls have in common what is within both outer squares, and outside of both inner ones."""
    beam = GeneralizedCylinder(Outline([square(0.5), square(0.3)]), CROSSING, start="flat")
    both = 0.5**2 * 0.2 + 0.2**2 * 0.3
    assert beam.solid().volume() == pytest.approx((0.25 - 0.09) * 12 - both, rel=1e-13)
    assert_valid(beam.solid())


def test_figure_eight_has_the_volume_of_blenders_exact_boolean():
    """Blender 4.5, EXACT with self-union on the same 32,000 vertices: 1.4802902."""
    u, around = np.arange(1000) * 2 * pi / 1000, np.arange(32) * 2 * pi / 32
    tangent = np.stack((2 * np.cos(u), 2 * np.cos(2 * u), 0 * u), axis=1)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    e2, e3 = np.stack((-tangent[:, 1], tangent[:, 0], 0 * u), axis=1), (0, 0, 1)
    middle = np.stack((2 * np.sin(u), np.sin(2 * u), 0 * u), axis=1)[:, None]
    rings = middle + 0.2 * (np.cos(around)[:, None] * e2[:, None] + np.sin(around)[:, None] * np.array(e3))
    solid = solid_of_rings(rings, closed=True)
    assert solid.volume() == pytest.approx(1.4802902, abs=1e-6)
    assert_valid(solid)
    assert genus(solid) == 2 and solid.dimensions().solids == 1


@pytest.mark.thorough
def test_spindle_has_its_closed_form_in_the_limit():
    """Of a disc of radius r about an axis R from its centre, z by z: what its outer and inner side bound."""
    z, step = np.linspace(-0.5, 0.5, 2_000_001, retstep=True)
    half = np.sqrt(0.25 - z**2)
    truth = pi * step * ((0.3 + half) ** 2 - np.maximum(0.3 - half, 0) ** 2).sum()
    assert truth == pytest.approx(1.53774, abs=1e-5)
    coarse, fine = (
        GeneralizedCylinder(Circle(0.5, points=m), Arc(0.3, 2 * pi), Count(2 * m)).solid() for m in (16, 32)
    )
    assert_valid(fine)
    assert genus(fine) == 0 and fine.dimensions().solids == 1
    assert fine.volume() + (fine.volume() - coarse.volume()) / 3 == pytest.approx(truth, rel=1e-3)  # second order


@pytest.mark.thorough
@pytest.mark.parametrize("contour", [Circle(0.5, points=32), Rectangle(0.9, 0.9), Star()])
def test_where_many_hulls_meet_in_a_point_no_face_is_a_sliver(contour):
    """On the axis of a spindle all of them do."""
    solid = GeneralizedCylinder(contour, Arc(0.3, 2 * pi), Count(64)).solid()
    assert_valid(solid)
    assert_no_slivers(solid)


def test_knot_that_is_too_thick_stays_one_ring():
    solid = GeneralizedCylinder(Circle(0.9, points=32), TorusKnot(2, 3, 2.0, 0.8), Count(400)).solid()
    assert_valid(solid)
    assert genus(solid) == 1 and solid.dimensions().solids == 1


JUDGED = {
    "figure-eight": GeneralizedCylinder(Circle(0.2, points=32), EIGHT, Count(500)),
    "knot": GeneralizedCylinder(Circle(0.9, points=32), TorusKnot(2, 3, 2.0, 0.8), Count(400)),
    "spindle": SPINDLE,
    "star spindle": GeneralizedCylinder(Star(), Arc(0.3, 2 * pi), Count(64)),
    "parabola": GeneralizedCylinder(Circle(0.3, points=32), PARABOLA, Count(201)),
    "hollow": GeneralizedCylinder(Outline([ring(0.2), ring(0.1)]), EIGHT, Count(300)),
    "hollow fold": GeneralizedCylinder(Outline([ring(0.3), ring(0.2)]), PARABOLA, Count(101)),
    "varied": GeneralizedCylinder(
        Circle(0.2, points=32), EIGHT, Count(500), scale_x="1 + 0.3*sin(2*pi*t)", scale_y="1 + 0.3*sin(2*pi*t)"
    ),
    "Moebius": GeneralizedCylinder(Rectangle(0.3, 1.5), EIGHT, Count(400), twist="pi*t"),
    "helix": GeneralizedCylinder(Rectangle(0.3, 0.5), Helix(0.5, 0.3, 3.0), Count(300)),
    "horn": GeneralizedCylinder(Circle(0.5, points=32), PARABOLA, Count(201), scale_x="1 - t", scale_y="1 - t"),
}


@pytest.mark.thorough
@pytest.mark.parametrize("name", JUDGED)
def test_volume_is_that_of_all_places_visited(name):
    solid = JUDGED[name].solid()
    volume, error = estimate(JUDGED[name], 20_000)
    assert abs(solid.volume() - volume) < 3.5 * error
    assert_valid(solid)
    assert_no_slivers(solid)


CONTOURS = (
    Circle(0.35, points=24),
    Rectangle(0.5, 0.5),
    Star(),
    Outline([ring(0.4), ring(0.25)]),
    Outline([[(-0.3, -0.3), (0.4, -0.3), (0.4, 0), (0, 0), (0, 0.4), (-0.3, 0.4)]]),
)


def random_sweep(seed, samples):
    """A contour that is turned along a closed curve of four harmonics, most of which folds."""
    dice = np.random.default_rng(seed)
    u, k = np.linspace(0, 2 * pi, 400, endpoint=False), np.arange(1, 5)
    cosine, sine = dice.normal(size=(2, 4, 3)) / k[:, None] ** 1.2
    path = Sampled(np.cos(np.outer(u, k)) @ cosine + np.sin(np.outer(u, k)) @ sine, closed=True)
    return GeneralizedCylinder(CONTOURS[seed % 5], path, Count(samples), twist=f"{2 * pi * dice.integers(-2, 3)}*t")


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("count", "samples", "places"), [(5, 250, 5000), pytest.param(60, 800, 30_000, marks=pytest.mark.large)]
)
def test_random_curves_have_the_volume_that_they_visit_but_for_the_judges_own_error(count, samples, places):
    scores = []
    for seed in range(count):
        sweep = random_sweep(seed, samples)
        solid = sweep.solid()
        volume, error = estimate(sweep, places, seed)
        scores.append((solid.volume() - volume) / error)
        assert_valid(solid)
    assert abs(np.mean(scores)) < 0.4 * max(1, 4 / np.sqrt(count))
    if count >= 60:
        assert 0.75 < np.std(scores, ddof=1) < 1.3
    assert np.abs(scores).max() < 4


@pytest.mark.thorough
@pytest.mark.parametrize("count", [6, pytest.param(200, marks=pytest.mark.large)])
def test_solids_of_random_curves_have_no_slivers(count):
    solids = 0
    for seed in range(count):
        try:
            solid = random_sweep(seed, 250).solid()
        except ShapeError:  # a curve that turns too much for so few contours
            continue
        solids += 1
        assert_valid(solid)
        assert_no_slivers(solid)
    assert solids >= 0.9 * count


def test_a_sweep_that_is_clean_is_left_as_it_is():
    for shape in (
        GeneralizedCylinder(Circle(0.1), TorusKnot()),
        GeneralizedCylinder(Circle(0.1), Helix(), start="round"),
        GeneralizedCylinder(Rectangle(0.3, 0.2), Polyline([(0, 0, 0), (2, 0, 0), (2, 1, 0)])),
    ):
        surface, solid = shape.surface(), shape.solid()
        assert solid.topology is surface.topology and np.array_equal(solid.vertices, surface.vertices)


def test_faces_that_nothing_cuts_are_as_they_were():
    shape = GeneralizedCylinder(Circle(0.2, points=16), EIGHT, Count(200))
    surface, solid = shape.surface(), shape.solid()
    rows = {row.tobytes(): number for number, row in enumerate(surface.vertices)}
    quads = np.flatnonzero(np.diff(solid.offsets) == 4)
    corners = solid.corners[solid.offsets[quads][:, None] + np.arange(4)]
    was = np.array([[rows[solid.vertices[v].tobytes()] for v in face] for face in corners])
    faces = {tuple(sorted(face)): number for number, face in enumerate(surface.corners.reshape(-1, 4).tolist())}
    number = np.array([faces[tuple(sorted(face))] for face in was.tolist()])
    assert len(quads) > 0.85 * len(faces) and len(set(number)) == len(number)
    assert np.array_equal(solid.uv[solid.offsets[quads]], surface.uv[4 * number])
    assert np.isfinite(solid.uv).all() and len(solid.uv) == len(solid.corners)
    assert np.array_equal(solid.attributes["arc_length"][corners], surface.attributes["arc_length"][was])


def test_caps_and_corners_keep_their_material_and_edges():
    surface, solid = (
        getattr(GeneralizedCylinder(Rectangle(0.5, 0.5), CROSSING), kind)() for kind in ("surface", "solid")
    )
    assert np.count_nonzero(solid.topology.material) == np.count_nonzero(surface.topology.material) == 2
    sharp = solid.vertices[solid.edges[solid.topology.sharp]]
    along_x = np.ptp(sharp, axis=1)[:, 0] > 1.5
    assert along_x.any()  # those of the contour's corners


@pytest.mark.parametrize("start", ["flat", "round"])
def test_ends_of_an_open_trajectory_stay_closed(start):
    shape = GeneralizedCylinder(Circle(0.3, points=32), PARABOLA, Count(201), start=start, end=start)
    solid = shape.solid()
    assert_valid(solid)
    assert genus(solid) == 0 and solid.volume() < shape.surface().volume()


def test_a_contour_on_both_sides_of_an_axis_has_the_volume_of_the_larger_side():
    """Pappus, of the part of the disc beyond the axis; the part on this side sweeps within that."""
    contour, steps = Circle(0.5, points=64), 48
    shape = RotationalSweep(contour, samples=Count(steps), axis_point=(-0.3, 0.0), crossing="keep")
    points = contour.section().points + (0.3, 0)
    right = clipped(points)
    x, y = right.T
    u, v = np.roll(x, -1), np.roll(y, -1)
    moment = ((x * v - y * u) * (x + u)).sum() / 6
    solid = shape.solid()
    assert solid.volume() == pytest.approx(steps * sin(2 * pi / steps) * moment, rel=1e-9)
    assert_valid(solid)


def clipped(points):
    """A polygon's part with x > 0."""
    found = []
    for a, b in zip(points, np.roll(points, -1, axis=0), strict=True):
        if a[0] >= 0:
            found.append(a)
        if a[0] * b[0] < 0:
            found.append(a + (b - a) * a[0] / (a[0] - b[0]))
    return np.array(found)


def test_turns_of_a_screw_that_meet_fill_what_is_between_them():
    """The thread is 0.5 high and rises by 0.4 a turn: a shaft of rectangles, but for a turn at its ends."""
    screw = RotationalSweep(THREAD, angle=8 * pi, pitch=0.4, samples=Count(201))
    solid = screw.solid()
    assert_valid(solid)
    chords = 50 * sin(2 * pi / 50) / (2 * pi)  # of the area of a round shaft
    assert solid.volume() == pytest.approx(chords * pi * (2**2 - 1**2) * (0.5 + 3 * 0.4), rel=2e-3)


def test_pd_curve_that_folds_has_the_volume_of_the_same_cylinder():
    direction = Arrows([(0, 0, 0, 1)])
    sweep = PDCurveSweep(Rectangle(0.2, 0.6), PARABOLA, direction, samples=Count(201))
    cylinder = GeneralizedCylinder(Rectangle(0.6, 0.2), PARABOLA, Count(201))
    assert_valid(sweep.solid())
    assert sweep.solid().volume() == pytest.approx(cylinder.solid().volume(), rel=1e-6)


def test_blade_on_both_sides_of_the_axis_of_a_screw_is_hardly_thicker_than_it_is():
    """Pappus for each side: a turn is 0.5 m high and the blade 0.2 m, so nothing is covered twice."""
    blade = Outline([box((-0.5, 0.0), (2.0, 0.2))])
    screw = RotationalSweep(blade, 9.0, 0.5, Count(600), crossing="keep")
    solid = screw.solid()
    assert_valid(solid)
    visited = 9.0 * 0.2 * (2.0**2 + 0.5**2) / 2
    assert visited < solid.volume() < 1.015 * visited  # hulls of whole blades hold three in a hundred too much


@pytest.mark.thorough
def test_bar_that_folds_and_slides_holds_little_more_than_it_visits():
    bar = GeneralizedCylinder(Rectangle(1.0, 0.2), Helix(0.3, 1.0, 2.0), Count(400), "frenet")
    volume, error = estimate(bar, 20_000, 1)
    solid = bar.solid()
    assert_valid(solid)
    assert volume - 3 * error < solid.volume() < 1.035 * volume + 3 * error


def test_sides_of_a_line_share_the_cut_between_them():
    """A square of side 2, level and turned by 0.1 about the x axis, cut by that axis: two rectangles of 2 x 1."""
    flat = np.column_stack((square(2.0), np.zeros(4)))
    turned = flat @ np.array([(1, 0, 0), (0, cos(0.1), sin(0.1)), (0, -sin(0.1), cos(0.1))]) + (0.3, 0, 0)
    points = np.stack((flat, turned), axis=1)
    sides = across(points, np.array([(0, 0, 1), (0, -sin(0.1), cos(0.1))]))
    assert np.abs(np.abs(sides) - cos(0.05)).max() < 1e-12
    one, other = halves(points, sides)
    assert len(one) == len(other) == 8
    for half in (one, other):
        on = half[np.abs(half[:, 1]) + np.abs(half[:, 2]) < 1e-12]
        assert sorted(on[:, 0].round(12).tolist()) == [-1.0, -0.7, 1.0, 1.3]
    assert (
        across(np.stack((flat, turned - (0.3, 0, 0)), axis=1), np.array([(0, 0, 1), (0, -sin(0.1), cos(0.1))])) is None
    )


@pytest.mark.parametrize("contours", [50, 200])
def test_square_that_keeps_its_orientation_over_an_arch_leaves_the_arch_open(contours):
    """At each height it visits two squares, which overlap under the top: its way is tangent to its plane there.

    On the way down all of it moves back, without a turn: what it visits is still no hull of all that.
    """
    arch = GeneralSweep(
        Rectangle(0.2, 0.2), Formula("cos(u)", "0", "sin(u)", start=0.0, end=pi), samples=Count(contours)
    )
    overlap = sqrt(1 - 0.1**2)  # from this height on; above it, half as far apart as the arch is wide
    above = (pi / 2 - asin(overlap) - overlap * 0.1) / 2
    solid = arch.solid()
    assert_valid(solid)
    assert solid.volume() == pytest.approx(0.2 * (0.4 * overlap + 0.2 * (1 - overlap) + 2 * above), rel=6e-3)
    assert genus(solid) == 0


def test_a_translational_sweep_is_a_solid_already():
    sweep = TranslationalSweep(Star(), height=2.0, taper=0.1)
    assert np.array_equal(sweep.solid().vertices, sweep.mesh().vertices)


def test_make_solid_is_the_same_as_an_option_of_the_shape():
    shape = GeneralizedCylinder(Circle(0.5, points=16), Arc(0.3, 2 * pi), Count(32), make_solid=True)
    assert shape.mesh().volume() == shape.solid().volume() > shape.surface().volume()
    assert shape.mesh(dtype=np.float32).vertices.dtype == np.float32
    assert shape.surface().told and not shape.mesh().told  # what was told of the fold is not true any longer
    assert not shape.self_intersections()


@pytest.mark.parametrize(
    "shape",
    [
        GeneralizedCylinder(Circle(0.5), Arc(0.3), start="open"),
        GeneralizedCylinder(Outline([[(0, 0), (1, 0), (1, 1)]], closed=False), Line()),
        RotationalSweep(Outline([[(1, 0), (2, 1)]], closed=False)),
        TranslationalSweep(end="open"),
    ],
)
def test_open_surfaces_are_refused(shape):
    with pytest.raises(ShapeError, match="needs a closed contour and closed ends, got an open surface"):
        shape.solid()


def test_a_contour_that_turns_too_much_from_sample_to_sample_is_refused():
    with pytest.raises(ShapeError, match="samples: must be more: the contour turns by more than a right angle"):
        GeneralizedCylinder(Circle(0.5), Arc(0.3, 2 * pi), Count(8), twist="10*pi*t").solid()


def test_without_the_library_the_refusal_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "manifold3d", None)
    with pytest.raises(ShapeError, match="pip install manifold3d"):
        SPINDLE.solid()


@pytest.mark.thorough
def test_progress_rises_and_what_it_raises_ends_the_work():
    told = []
    SPINDLE.solid(told.append)
    assert told == sorted(told) and 0 < told[0] and told[-1] <= 1 and len(told) >= 4

    def stop(part):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        SPINDLE.solid(stop)
