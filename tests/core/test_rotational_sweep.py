# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotational sweeps against Pappus, on the axis and across it, and their refusals."""

from math import cos, hypot, pi, sin, sqrt, tau

import numpy as np
import pytest
from solids import GLYPHS, assert_solid, box
from test_translational_sweep import star

from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.rings import caps
from sweep_addon.core.rings.parting import parted
from sweep_addon.core.shapes.rotational_sweep import RotationalSweep
from sweep_addon.core.stations.sampling import Count, Tolerance

CLOSE = dict(rel=1e-12)  # rounding: sums of a few hundred numbers
BLOCK = Outline([box((0, 0), (2, 1))])  # with an edge on the axis
RING = Outline([box((1, 0), (2, 1))])


def chords(angle, steps):
    """What the sectors of a turn in so many steps have of the whole: their chords leave the rest of a circle out."""
    return sin(abs(angle) / steps) / (abs(angle) / steps)


def pappus(section, angle):
    """Area times the way of the centroid, signed."""
    return section.area * section.centroid[0] * abs(angle)


@pytest.mark.parametrize("angle", [tau, -tau, 1.0, -2.0, pi, 6.0])
@pytest.mark.parametrize("glyph", GLYPHS)
def test_volume_is_the_area_times_the_way_of_the_centroid(glyph, angle):
    """Pappus' second theorem; a body turned in part is a prism bent, all round each loop is a torus."""
    contour, holes = GLYPHS[glyph]
    shape = RotationalSweep(contour, angle, samples=Count(20), axis_point=(-3.0, 0.0))
    mesh, whole = shape.mesh(), abs(angle) == tau
    section = contour.section()
    expected = section.area * (section.centroid[0] + 3) * abs(angle) * chords(angle, 20 - (not whole))
    assert mesh.volume() == pytest.approx(expected, **CLOSE)
    assert_solid(mesh, 0 if whole else sum(2 - 2 * h for h in holes))


@pytest.mark.parametrize("angle", [tau, 1.0, -2.5])
@pytest.mark.parametrize("steps", [4, 9, 50])
def test_area_true_turns_have_the_volume_of_pappus(angle, steps):
    for contour in (RING, BLOCK, Outline([[(0, 0), (2, 1), (0, 3)]])):
        mesh = RotationalSweep(contour, angle, samples=Count(steps), fit="area-true").mesh()
        assert mesh.volume() == pytest.approx(pappus(contour.section(), angle), **CLOSE)
    torus = RotationalSweep(Circle(0.5, 12), samples=Count(steps), axis_point=(-2, 0), fit="area-true").mesh()
    assert torus.volume() == pytest.approx(2 * pi**2 * 2 * 0.25, **CLOSE)


@pytest.mark.parametrize("chord", [0.1, 1e-3, 1e-5])
def test_half_disc_is_a_ball_with_two_poles(chord):
    """Made of frustums of pyramids: h / 3 (A + sqrt(A B) + B), the area of their n-gons n / 2 sin(2 pi / n) r^2."""
    half = Outline([[(0, -1), (0, 1)]], bulges=[(1, 0)], tolerance=chord)
    mesh = RotationalSweep(half, samples=Tolerance(chord)).mesh()
    x, y = half.section().points.T
    order = np.argsort(y)
    r, h, n = x[order], np.diff(y[order]), mesh.rings
    expected = (h * (r[1:] ** 2 + r[1:] * r[:-1] + r[:-1] ** 2)).sum() / 3 * n / 2 * sin(tau / n)
    assert mesh.volume() == pytest.approx(expected, **CLOSE)
    assert mesh.volume() == pytest.approx(4 / 3 * pi, rel=4 * chord)
    assert len(mesh.vertices) == n * (len(x) - 2) + 2, "one vertex for each pole"
    assert (np.abs(mesh.vertices[-2:, [0, 2]]) == 0).all()
    assert_solid(mesh, 2)


def test_part_of_a_turn_of_a_contour_with_an_edge_on_the_axis_is_a_wedge_with_one_edge_there():
    """A quarter of a cylinder: a prism over a polygon of the axis and the chords."""
    mesh = RotationalSweep(BLOCK, pi / 2, samples=Count(9)).mesh()
    assert mesh.volume() == pytest.approx(8 / 2 * sin(pi / 16) * 4, **CLOSE)
    assert len(mesh.vertices) == 2 * 9 + 2
    on_axis = np.abs(mesh.vertices[:, [0, 2]]).max(axis=1) == 0
    along = on_axis[mesh.edges].all(axis=1)
    assert along.sum() == 1 and mesh.topology.sharp[along].all()
    assert_solid(mesh, 2)


def test_contour_that_touches_the_axis_in_a_point_is_pinched_there():
    """A horn torus: all round its one pole belongs to two sheets, and the Euler characteristic is 1."""
    diamond = Outline([[(0, 0), (1, -1), (2, 0), (1, 1)]])
    mesh = RotationalSweep(diamond, samples=Count(12)).mesh()
    assert mesh.volume() == pytest.approx(pappus(diamond.section(), tau) * chords(tau, 12), **CLOSE)
    assert len(mesh.vertices) == 3 * 12 + 1
    assert_solid(mesh, 1)
    assert_solid(RotationalSweep(diamond, 3.0, samples=Count(12)).mesh(), 2)


@pytest.mark.parametrize("direction", [(0, 1), (1, 0), (3, -2), (-1e-3, 2e-3)])
def test_any_axis_turns_as_a_right_hand_does(direction):
    """The contour's far point is where the rotation matrix of Rodrigues takes it."""
    axis = np.array((*direction, 0.0)) / hypot(*direction)
    away = np.array((direction[1], -direction[0])) / hypot(*direction)
    contour = Outline([away * 3 + corner for corner in [np.array(box((-0.5, -0.5), (0.5, 0.5)))]])
    shape = RotationalSweep(contour, 1.0, samples=Count(2), axis_point=(0.0, 0.0), axis_direction=direction)
    mesh = shape.mesh()
    here = np.column_stack((contour.section().points, np.zeros(4)))
    there = here * cos(1) + np.cross(axis, here) * sin(1) + np.outer(here @ axis, axis) * (1 - cos(1))
    expected = np.concatenate((here, there))
    apart = np.linalg.norm(mesh.vertices[:, None] - expected, axis=2).min(axis=1)
    assert apart.max() < 1e-12 and mesh.volume() > 0
    moved = RotationalSweep(
        contour, 1.0, samples=Count(2), axis_point=(5 * axis[0], 5 * axis[1]), axis_direction=direction
    )
    assert np.abs(moved.mesh().vertices - mesh.vertices).max() < 1e-12, "a point anywhere on the axis"


SPINDLE = dict(contour=Circle(0.5, 2048), axis_point=(-0.3, 0.0), samples=Count(24), fit="area-true")


def test_spindle_solid_has_its_volume():
    """The apple of a spindle torus, R = 0.3 and r = 0.5, is what a circle's larger part turns into: Pappus in closed
    form, pi (4 / 3 h^3 + 2 R r^2 (pi - acos(R / r)) + 2 R^2 h) with h^2 = r^2 - R^2, less what h^3 counts of R^2.
    """
    big_r, r = 0.3, 0.5
    h = sqrt(r**2 - big_r**2)
    moment = 2 / 3 * h**3 + big_r * (r**2 * (pi / 2 + np.arcsin(big_r / r)) + big_r * h)  # of x over the part at x > 0
    apple = tau * moment
    assert apple == pytest.approx(1.53774, abs=1e-5)
    lemon = apple - tau * pi * r**2 * big_r
    both = RotationalSweep(**SPINDLE, crossing="split")
    small, large = both.bodies()
    assert large.volume() == pytest.approx(apple, rel=2e-6) and small.volume() == pytest.approx(lemon, rel=2e-5)
    assert_solid(large, 2)
    assert_solid(small, 2)
    assert both.mesh().volume() == pytest.approx(large.volume() + small.volume(), **CLOSE)


@pytest.mark.parametrize(("angle", "overlap"), [(2.0, False), (pi, False), (pi + 0.01, True), (tau, True)])
def test_split_bodies_that_overlap_are_told_and_stay(angle, overlap):
    """In half a turn each comes to where the other began, and no farther. Boxes above each other never do."""
    mesh = RotationalSweep(Rectangle(1, 1), angle, crossing="split").mesh()
    sentence = "beyond half a turn both sides of the contour sweep the same places, and their bodies overlap."
    assert mesh.told == ((f"Self-intersection: {sentence}",) if overlap else ())
    above = Outline([box((-1, 2), (0, 3)), box((0, 0), (1, 1))])
    assert RotationalSweep(above, angle, crossing="split").mesh().told == ()


@pytest.mark.parametrize("angle", [tau, 2.0])
def test_kept_spindle_is_one_surface_through_itself(angle):
    """Its volume is signed: what is beyond the axis counts against the rest, so that Pappus holds."""
    shape = RotationalSweep(Circle(0.5), angle, samples=Count(40), axis_point=(-0.3, 0.0), crossing="keep")
    mesh = shape.mesh()
    (section,) = shape.sections()
    assert (section.points[:, 0] == 0).sum() == 2
    expected = pappus(section, angle) * chords(angle, 40 if angle == tau else 39)
    assert mesh.volume() == pytest.approx(expected, **CLOSE)
    assert mesh.told == ("Self-intersection: the contour crosses the axis, and the sweep passes through itself there.",)
    assert_solid(mesh, 2)


def test_section_is_parted_at_the_axis_with_its_holes():
    """A hole across the axis opens both parts; the areas add up, and each part is closed along the axis."""
    square, hole = box((-2, -2), (2, 2)), box((-1, -1), (1, 1))
    left, right = parted(Outline([square, hole]).section())
    assert left.area == right.area == 6 and len(left.areas) == len(right.areas) == 1
    left, right = parted(Outline([square, hole + (0.5, 0), hole / 8 + (-1, 0)]).section())
    assert left.area == pytest.approx(8 - 1 - 1 / 16) and right.area == pytest.approx(8 - 3)
    assert [len(part.areas) for part in (left, right)] == [2, 1]


def test_touching_corners_are_parted_too():
    """An hourglass on its side, its waist on the axis: two triangles."""
    waist = Outline([[(-1, -1), (0, -0.1), (1, -1), (1, 1), (0, 0.1), (-1, 1)]])
    left, right = parted(waist.section())
    assert left.area == right.area == pytest.approx(1.1)
    mesh = RotationalSweep(waist, samples=Count(8), crossing="split").mesh()
    assert mesh.euler_characteristic() == 4 and len(mesh.non_manifold_edges()) == 0


@pytest.mark.parametrize(("angle", "pitch"), [(5 * tau, 1.2), (-5 * tau, 1.2), (5 * tau, -1.2), (0.5, 3.0)])
def test_screw_has_the_volume_of_the_ring_for_each_turn(angle, pitch):
    """Cavalieri: what a cylinder about the axis cuts out of a screw is that of a ring, sheared along the axis."""
    mesh = RotationalSweep(RING, angle, pitch, samples=Count(101)).mesh()
    assert mesh.volume() == pytest.approx(pappus(RING.section(), angle) * chords(angle, 100), **CLOSE)
    assert_solid(mesh, 2)
    rise = np.ptp(mesh.vertices[:, 1])
    assert rise == pytest.approx(1 + abs(angle * pitch) / tau, **CLOSE)


def test_ends_of_a_screw_are_flat_and_stand_on_the_axis():
    mesh = RotationalSweep(RING, 1.0, 4.0, samples=Count(9)).mesh()
    for turn, face in ((0.0, 0), (1.0, 8)):
        out = np.array((cos(turn), 0, -sin(turn)))
        places = mesh.vertices.reshape(4, 9, 3)[:, face]
        assert np.abs(np.linalg.det(np.stack((places[1] - places[0], places[2] - places[0], out)))) < 1e-12
    assert len(mesh.boundary_edges()) == 0


def test_line_across_the_axis_sweeps_a_helicoid_of_two_arms():
    """Area, r up to 1: pi (sqrt(1 + c^2) + c^2 asinh(1 / c)) for each arm and turn, c the rise in a radian."""
    line = Outline([np.stack((np.linspace(-1, 1, 101), np.zeros(101)), axis=1)], closed=False)
    mesh = RotationalSweep(line, 2 * tau, 1.0, samples=Count(801), crossing="keep").mesh()
    c = 1 / tau
    arm = tau / 2 * (sqrt(1 + c * c) + c * c * np.arcsinh(1 / c))
    assert mesh.area() == pytest.approx(2 * 2 * arm, rel=1e-4)
    assert_solid(mesh, 1, boundary=2 * 100 + 2 * 800)


def test_open_contours_make_surfaces_with_poles():
    """Cones: trapezoids between two n-gons; a line from the axis is a disc, one back to it is closed."""
    n = 24
    profile = [(0, 0), (3, 0), (1, 2)]
    mesh = RotationalSweep(Outline([profile], closed=False), samples=Count(n)).mesh()
    side = 2 * sin(pi / n)
    slant = hypot(2, (3 - 1) * cos(pi / n))
    assert mesh.area() == pytest.approx(n / 2 * sin(tau / n) * 9 + n * side * (3 + 1) / 2 * slant, **CLOSE)
    assert_solid(mesh, 1, boundary=n)
    spinning_top = RotationalSweep(Outline([[(0, 0), (0, 1), (2, 2), (0, 4), (0, 5)]], closed=False), samples=Count(n))
    assert len(spinning_top.mesh().vertices) == n + 2
    assert_solid(spinning_top.mesh(), 2)
    assert_solid(replaced_angle(spinning_top, 1.0), 1, boundary=4)


def replaced_angle(shape, angle):
    return RotationalSweep(shape.contour, angle, samples=shape.samples).mesh()


@pytest.mark.parametrize("chord", [0.3, 1e-2, 1e-4])
def test_tolerance_holds_where_the_contour_is_farthest_from_the_axis(chord):
    shape = RotationalSweep(RING, samples=Tolerance(chord))
    steps = shape.mesh().rings
    assert 2 * (1 - cos(pi / steps)) <= chord and (steps == 6 or 2 * (1 - cos(pi / (steps - 1))) > chord)


def test_texture_has_the_area_of_the_surface():
    """Its length along is that of Pappus' first theorem: perimeter times the way of the line's own centroid."""
    mesh = RotationalSweep(RING, 2.0, samples=Count(200), start="open", end="open").mesh()
    uv = mesh.uv.reshape(-1, 4, 2)
    spread = (uv[:, 0, 1] - uv[:, 1, 1]) * (uv[:, 2, 0] - uv[:, 0, 0])  # more than 0: it is not seen in a mirror
    assert spread.min() > 0 and spread.sum() == pytest.approx(4 * 1.5 * 2.0, **CLOSE)
    assert mesh.area() == pytest.approx(4 * 1.5 * 2.0, rel=1e-4)
    assert mesh.attributes["u"].max() == 2.0 and mesh.attributes["v"].max() == 3.0


def bodies(random):
    """A random contour on one side of the y axis and what it touches there: nothing, a corner or an edge."""
    touches = str(random.choice(["nothing", "corner", "edge"]))
    points = star(random, np.array([2.0, 0.0]), 1.0, random.integers(5, 14))
    if touches == "corner":
        points[:, 0] -= points[:, 0].min()
    if touches == "edge":
        leftmost = int(points[:, 0].argmin())
        x, y = points[leftmost]
        points = np.insert(points, leftmost + 1, (x, y - 0.05), axis=0) - (x, 0)
    return Outline([points]), {"nothing": 0, "corner": 1, "edge": 2}[touches]


def test_random_turns_are_solids(draws):
    """All round, the Euler characteristic is the number of poles, of a part of a turn it is that of a ball.

    The axis lies anywhere; the volume is that of Pappus.
    """
    random = np.random.default_rng(7)
    for _ in range(draws):
        contour, poles = bodies(random)
        section = contour.section()
        angle = random.choice([tau, -tau, random.uniform(0.1, 6.2), -random.uniform(0.1, 6.2)])
        way, point = random.uniform(-pi, pi), random.uniform(-5, 5, 2)
        x, y = np.array((cos(way), sin(way))), np.array((-sin(way), cos(way)))
        side = random.choice([-1, 1])
        moved = Outline(
            [point + side * points[:, :1] * x + points[:, 1:] * y for points in map(np.array, contour.loops)]
        )
        pitch = random.choice([0.0, random.uniform(3, 5)]) if poles == 0 else 0.0
        count = int(random.integers(5, 30))
        mesh = RotationalSweep(moved, angle, pitch, Count(count), point, y).mesh()
        closed = abs(angle) == tau and not pitch
        assert_solid(mesh, poles if closed else 2)
        expected = pappus(section, angle) * chords(angle, count - (not closed))
        assert mesh.volume() == pytest.approx(expected, rel=1e-9)


def test_both_bodies_of_random_contours_across_the_axis_are_solids(draws):
    """Split; and the difference of their volumes is what is swept with its sign."""
    random = np.random.default_rng(11)
    for _ in range(draws // 2):
        points = star(random, np.zeros(2), 1.0, random.integers(5, 20)) + (random.uniform(-0.3, 0.3), 0)
        angle = random.choice([tau, random.uniform(0.5, 6)])
        given = dict(contour=Outline([points]), angle=angle, samples=Count(12))
        split, kept = RotationalSweep(**given, crossing="split"), RotationalSweep(**given, crossing="keep")
        left, right = split.bodies()
        for body, section in zip((left, right), split.sections(), strict=True):
            pieces = len(section.areas)
            poles = int((section.points[:, 0] == 0).sum())
            assert_solid(body, poles if angle == tau else 2 * pieces)
        signed = abs(right.volume() - left.volume())
        assert abs(kept.mesh().volume()) == pytest.approx(signed, rel=1e-9, abs=1e-12)
        assert not len(kept.mesh().boundary_edges()) and not len(kept.mesh().non_manifold_edges())


def test_too_few_contours_are_refused_where_they_are_said():
    with pytest.raises(ShapeError, match="^samples.contours: must be at least 3 for this angle, got 2$"):
        RotationalSweep(samples=Count(2))
    RotationalSweep(samples=Count(2), angle=1.0)


@pytest.mark.parametrize(
    ("sentence", "given"),
    {
        "angle: must not be 0, got 0": dict(angle=0),
        "angle: must be at most a turn, 6.28319, without a pitch, got 7": dict(angle=7),
        "angle: must be at most 62831.9, got 70000": dict(angle=70000, pitch=1),
        "angle: must be a number of radians, got '90'": dict(angle="90"),
        "pitch: must be 0 for a contour with an edge along the axis, got 1": dict(pitch=1, contour=BLOCK),
        "crossing: must be keep where there is a pitch, by which the cut along the axis would slide in itself, "
        "got 'split'": dict(pitch=1, contour=Rectangle(2, 1), crossing="split"),
        "fit: must be inscribed for a contour that touches the axis with a curve, whose edges else cross it, "
        "got 'area-true'": dict(contour=Circle(1.0, 64), axis_point=(-1, 0), fit="area-true"),
        "axis_direction: must have a length, got [0.0, 0.0]": dict(axis_direction=(0, 0)),
        "axis_point: must be a list of 2, got [1, 2, 3]": dict(axis_point=[1, 2, 3]),
        "contour: must not lie on the axis, got only points on it": dict(
            contour=Outline([[(0, 0), (0, 1)]], closed=False)
        ),
        "crossing: must be one of refuse, keep, split, meet, got 'cut'": dict(crossing="cut"),
        "samples.contours: must be at least 3 for this angle, got 2": dict(samples=Count(2)),
        "samples.contours: must be at least 16 for this angle, got 12": dict(samples=Count(12), angle=5 * tau, pitch=1),
        "samples: must make at most 20,000,000 vertices, got 20500000": dict(
            samples=Count(200_000 // 4), contour=Circle(0.5, 4096 // 10 + 1), axis_point=(-9, 0)
        ),
        "fit: must be inscribed or area-true for a rotational sweep, got 'circumscribed'": dict(fit="circumscribed"),
        "start: must be one of flat, open, got 'round'": dict(start="round"),
    }.items(),
)
def test_what_will_not_do_is_refused_in_one_sentence(sentence, given):
    with pytest.raises(ShapeError) as caught:
        RotationalSweep(**given).mesh()
    assert str(caught.value) == sentence


def test_rectangle_across_the_axis_is_told_how_far_it_reaches():
    with pytest.raises(
        ShapeError,
        match=r"^contour: must be on one side of the axis, or crossing be .* or meet, got one from -1\.5 to 0\.5 m",
    ):
        RotationalSweep(Rectangle(2, 1), axis_point=(0.5, 0)).mesh()


@pytest.mark.parametrize("angle", [3 * tau, -3 * tau, 2 * tau])
def test_turns_of_a_screw_meet_where_its_pitch_is_less_than_it_is_high(angle):
    """And not where another turn never comes to the same side."""
    met = RotationalSweep(RING, angle, 0.99, samples=Count(100)).self_intersections()
    assert met[0].kind == "global" and 0.98 < met.largest_safe_size <= 0.99
    assert 0.99 < hypot(met[0].point[0], met[0].point[2]) < 2.01  # on a chord
    assert len(RotationalSweep(RING, angle, 1.01, samples=Count(100)).self_intersections()) == 0
    assert len(RotationalSweep(RING, 0.99 * tau, 0.5).self_intersections()) == 0


def test_arms_of_a_helicoid_meet_after_half_a_turn():
    """A slanting line across the axis, mirrored and half a pitch higher: they meet where the line has risen so far."""
    slope = 0.2
    line = Outline([[(-1, -slope), (1, slope)]], closed=False)
    for pitch, meets in ((4 * slope * 0.99, 1), (4 * slope * 1.01, 0)):
        shape = RotationalSweep(line, tau, pitch, crossing="keep", samples=Count(20))
        assert len(shape.self_intersections()) == meets


@pytest.mark.parametrize(
    ("angle", "crossing", "places"), [(tau, "keep", 1), (1.0, "keep", 1), (tau, "split", 1), (3.0, "split", 0)]
)
def test_contour_across_the_axis_meets_itself_there(angle, crossing, places):
    shape = RotationalSweep(Circle(0.5), angle, axis_point=(-0.3, 0.0), crossing=crossing)
    found = shape.self_intersections()
    assert len(found) == places
    assert all(place.point[0] == -0.3 and place.point[2] == 0 for place in found)
    assert len(RotationalSweep().self_intersections()) == 0


@pytest.mark.parametrize("angle", [0.5, 2.0, -4.0, 6.0])
def test_both_ends_of_a_contour_with_a_hole_across_the_axis_share_no_edge_on_it(angle):
    """Signed volume by Pappus, chords included: what is right of the axis less what is left of it."""
    outer, hole = [(-0.4, -0.4), (0.5, -0.4), (0.5, 0.4), (-0.4, 0.4)], [(-0.2, -0.1), (0.2, -0.1), (0.1, 0.2)]
    mesh = RotationalSweep(Outline([outer, hole]), angle, samples=Count(25), crossing="keep").mesh()
    assert len(mesh.non_manifold_edges()) == len(mesh.boundary_edges()) == 0
    moment = 0.8 * (0.5**2 - 0.4**2) / 2 - 0.06 * 0.1 / 3  # of the areas times their distances from the axis
    assert mesh.volume() == pytest.approx(24 * np.sin(abs(angle) / 24) * moment, rel=1e-9)


@pytest.mark.parametrize("seed", range(20))
def test_faces_between_points_that_are_kept_apart_fill_the_same_area(seed):
    random = np.random.default_rng(seed)
    around = (np.arange(7) + random.uniform(-0.3, 0.3, 7)) * tau / 7
    outer = random.uniform(0.5, 1, (7, 1)) * np.stack((np.cos(around), np.sin(around)), axis=1)
    hole = 0.2 * outer[::2] + 0.05
    sweep = RotationalSweep(Outline([outer, hole]), 2.0, samples=Count(9), crossing="keep")
    (section,) = sweep.sections()
    poles = np.flatnonzero(section.points[:, 0] == 0)
    corners, _ = caps.faces(section, tuple(poles.tolist()))
    triangles = np.reshape(corners, (-1, 3))
    a, b, c = section.points[triangles].swapaxes(0, 1)
    areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    assert (areas > 0).all() and areas.sum() == pytest.approx(section.area)
    assert not (np.isin(triangles, poles).sum(axis=1) > 1).any()


def test_ends_share_no_edge_where_a_diagonal_on_the_axis_can_be_flipped_after_others_alone():
    """The axis crosses the upper side of the hole in its middle, and what is above that is far."""
    outer = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    hole = [(-0.25, -0.03), (0.06, -0.22), (0.23, -0.68), (-0.3, -0.04)]
    mesh = RotationalSweep(Outline([outer, hole]), 2.0, samples=Count(9), crossing="keep").mesh()
    assert len(mesh.non_manifold_edges()) == len(mesh.boundary_edges()) == 0
