# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The PD curve sweep: a constant cross-section solid with the volume that theorems give it, between exact caps."""

import numpy as np
import pytest
from conftest import BRIEF, FULL
from solids import GLYPHS, TEAPOT_INNER, TEAPOT_OUTER, assert_solid

from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.declared.forms import dump, load
from sweep_addon.core.declared.options import Texture
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.rings.corners import Round
from sweep_addon.core.rings.cutting import ONCE
from sweep_addon.core.rings.limits import Flat, Open, Plane
from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
from sweep_addon.core.stations.directions import Arrows, Cubic, Guide, Tilt
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Arc, Bezier, Helix, Line, Polyline, Sampled, TorusKnot
from sweep_addon.core.vectors import dot, norms

UPRIGHT = Line(end=(0, 0, 4))
ALONG_X = Arrows([(0, 1, 0, 0)])
LEVEL = Arrows([(0, 0, 0, 1)])  # of an arc about the z axis
REFUSALS = ("once", "leave something", "must cut within")


def columns(mesh):
    return mesh.vertices.reshape(mesh.chart.grid.columns, -1, 3)


@pytest.mark.parametrize("name", GLYPHS)
@pytest.mark.parametrize("seed", range(5))
def test_a_straight_solid_between_two_planes_is_a_cut_prism(name, seed):
    """Its volume is the area times the length between the planes along the axis through the centroid."""
    outline, holes = GLYPHS[name]
    rng = np.random.default_rng(seed)
    low, high = ((*rng.uniform(-0.4, 0.4, 2), rng.choice([-1, 1])) for _ in range(2))
    planes = Plane((0.3, -0.2, 1), low), Plane((0, 0.1, 9), high)
    shape = PDCurveSweep(outline, Line(end=(0, 0, 8)), ALONG_X, *planes, Count(int(rng.integers(2, 20))))
    section, mesh = outline.section(), shape.mesh()
    heights = [
        plane.point[2] - (section.centroid - plane.point[:2]) @ plane.normal[:2] / plane.normal[2] for plane in planes
    ]
    assert mesh.volume() == pytest.approx(section.area * (heights[1] - heights[0]), rel=1e-12)
    assert_solid(mesh, sum(2 * (1 - hole) for hole in holes))
    ends = columns(mesh)
    assert np.abs(planes[0].heights(ends[:, 0])).max() < 1e-14
    assert np.abs(planes[1].heights(ends[:, -1])).max() < 1e-14


def test_a_turning_direction_leaves_a_straight_solid_its_volume():
    """Cavalieri: every cross-section is the contour, turned."""
    turning = Cubic([(1, 0, 0), (1, 0, 0), (-1, 2, 0), (-1, 0.2, 0)])
    shape = PDCurveSweep(Rectangle(0.4, 0.2), UPRIGHT, turning, samples=Tolerance(1e-6))
    assert shape.mesh().volume() == pytest.approx(0.4 * 0.2 * 4, rel=1e-4)


def test_the_teapots_handle_has_the_volume_of_its_constant_cross_section():
    """Weyl: area times length, for the centroid is on the curve; the length by Simpson's rule on the cubic."""
    t = np.linspace(0, 1, 2001)
    total = 0.0
    for first in (0, 3):
        p0, p1, p2, p3 = np.array(TEAPOT_INNER[first : first + 4])
        ways = np.outer((1 - t) ** 2, p1 - p0) + np.outer(2 * t * (1 - t), p2 - p1) + np.outer(t**2, p3 - p2)
        speed = 3 * np.linalg.norm(ways, axis=1)
        total += (speed[0] + speed[-1] + 4 * speed[1::2].sum() + 2 * speed[2:-1:2].sum()) / 6000
    contour = Rectangle(0.1, 0.3)
    errors = []
    for chord in (1e-4, 1e-5):
        mesh = PDCurveSweep(contour, Bezier(TEAPOT_INNER), Guide(TEAPOT_OUTER), samples=Tolerance(chord)).mesh()
        assert_solid(mesh, 2)
        errors.append(abs(mesh.volume() / (0.03 * total) - 1))
    assert errors[0] < 2e-4 and errors[1] < 2e-5


@pytest.mark.parametrize("tilt", [-0.9, 0.0, 0.6])
def test_a_bent_solid_between_planes_through_the_axis_of_its_bend(tilt):
    """Pappus: the area times the way of the centroid; of an oblique plane it is the mean of all points that counts."""
    arc = Arc(2.0, np.pi)
    normals = (np.sin(0.4), -np.cos(0.4), tilt), (np.sin(2.5), -np.cos(2.5), 0)
    shape = PDCurveSweep(Rectangle(0.6, 0.8), arc, LEVEL, Plane((0, 0, 0), normals[0]), Plane((0, 0, 0), normals[1]))
    errors = []
    for chord in (1e-4, 1e-5):
        mesh = PDCurveSweep(shape.contour, arc, LEVEL, shape.start, shape.end, Tolerance(chord)).mesh()
        errors.append(abs(mesh.volume() / (0.48 * 2 * 2.1) - 1))
    # A plane through the origin that leans by z cuts as much off above as it leaves below.
    assert errors[0] < 3e-4 and errors[1] < 3e-5
    assert_solid(mesh, 2)


def test_handles_in_single_precision_are_in_line():
    """As Blender keeps them; a degree is a corner that is refused."""
    chain = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 2, 0), (1 + 1e-6, 2.1, 0), (2, 3, 0), (3, 3, 0)]
    assert_solid(PDCurveSweep(Circle(0.1), Bezier(chain), LEVEL).mesh(), 2)
    chain[4] = (1 + 0.1 * np.tan(np.radians(1.01)), 2.1, 0)
    with pytest.raises(ShapeError, match="^trajectory: must be smooth, or its corners round, got a corner at u = 1$"):
        PDCurveSweep(Circle(0.1), Bezier(chain), LEVEL).mesh()


def test_beyond_the_end_of_a_curved_axis_the_solid_goes_on_straight():
    arc, contour = Arc(2.0, np.pi / 2), Circle(0.3, points=48)
    planes = Plane((2, -1, 0), (0.2, 1, 0.3)), Plane((-1.5, 2, 0), (1, -0.4, 0.1))
    mesh = PDCurveSweep(contour, arc, LEVEL, *planes, Tolerance(1e-6)).mesh()
    assert mesh.volume() == pytest.approx(contour.section().area * (np.pi + 1 + 1.5), rel=1e-5)
    assert_solid(mesh, 2)
    assert mesh.vertices[:, 1].min() < -1 and mesh.attributes["arc_length"].min() < -1
    assert mesh.attributes["u"].min() == 0.0


def test_where_a_plane_cuts_many_rings_every_vertex_stays_on_the_true_surface():
    """On a torus: the distance from the circle in the middle of the tube is the tube's radius."""
    contour = Circle(0.5, points=40)
    planes = Plane((1.6, 1.2, 0), (-0.6, 0.8, 0.8)), Plane((-1.2, -1.6, 0), (0.9, -0.4, -0.9))
    shape = PDCurveSweep(contour, Arc(2.0, 1.5 * np.pi), LEVEL, *planes, Tolerance(1e-3))
    mesh = shape.mesh()
    x, y, z = mesh.vertices.T
    assert np.hypot(np.hypot(x, y) - 2, z) == pytest.approx(0.5, abs=1e-12)
    ends = columns(mesh)
    for plane, side in zip(planes, (0, -1), strict=True):
        assert np.abs(plane.heights(ends[:, side])).max() < 1e-15
        assert np.ptp(mesh.attributes["arc_length"].reshape(40, -1)[:, side]) > 3 * 4.7 / mesh.rings
    steps = np.diff(mesh.attributes["arc_length"].reshape(40, -1), axis=1)
    assert steps.min() > 0 and steps.max() < 2 * np.median(steps)


def test_an_arch_stands_on_the_ground_with_both_feet():
    """One plane cuts every line twice: the start takes the first cut and the end the last."""
    ground = Plane((0, 0.3, 0), (0.1, 1, 0.2))
    mesh = PDCurveSweep(Circle(0.2), Arc(2.0, np.pi), LEVEL, ground, ground).mesh()
    assert_solid(mesh, 2)
    assert ground.heights(mesh.vertices).min() > -1e-14
    assert (np.abs(ground.heights(mesh.vertices)) < 1e-14).sum() == 128


@pytest.mark.parametrize("count", [2, 3, 7])
@pytest.mark.parametrize("start", [Flat(), Plane((0, 0, -0.5), (0.4, 0, 1))])
@pytest.mark.parametrize("end", [Flat(), Plane((0, 0, 3), (-0.3, 0.5, 1))])
def test_texture_lengths_are_true_on_sides_and_caps(start, end, count):
    """Of a straight solid all faces lie flat: the area of the texture is that of the surface."""
    mesh = PDCurveSweep(Rectangle(0.4, 0.3), UPRIGHT, ALONG_X, start, end, Count(count)).mesh()
    start, following = mesh.uv[np.arange(len(mesh.corners))], mesh.uv[mesh.topology.following]
    cross = (start[:, 0] * following[:, 1] - start[:, 1] * following[:, 0]) / 2
    areas = np.add.reduceat(cross, mesh.offsets[:-1])
    assert np.abs(areas) == pytest.approx(norms(mesh.normals), rel=1e-12)


def test_textures_between_planes_reach_from_0_to_1_or_are_left_out():
    planes = Plane((0, 0, -0.5), (0.4, 0, 1)), Plane((0, 0, 3), (-0.3, 0.5, 1))
    unit = PDCurveSweep(Rectangle(0.4, 0.3), UPRIGHT, ALONG_X, *planes, texture=Texture.UNIT).mesh().uv
    assert unit.min() == 0 and unit.max() == pytest.approx(1)
    assert PDCurveSweep(start=planes[0], texture="none").mesh().uv is None


def test_caps_lie_beside_the_longest_side_of_an_oblique_end_in_the_texture():
    planes = Plane((0, 0, -1), (2, 0, 1)), Plane((0, 0, 6), (-3, 0, 1))
    mesh = PDCurveSweep(Rectangle(1, 1), UPRIGHT, ALONG_X, *planes, Count(7)).mesh()
    faces = np.split(mesh.uv[:, 0], mesh.offsets[1:-1])
    sides = np.concatenate([face for face, cap in zip(faces, mesh.topology.material, strict=True) if not cap])
    start, end = (face for face, cap in zip(faces, mesh.topology.material, strict=True) if cap)
    assert start.max() < sides.min() and sides.max() < end.min()
    assert (sides.min(), sides.max()) == pytest.approx((-2, 7.5), abs=1e-12)


def test_attributes_can_be_left_out_at_planes_too():
    shape = PDCurveSweep(trajectory=UPRIGHT, direction=ALONG_X, start=Plane((0, 0, 1), (1, 0, 1)), attributes=False)
    assert shape.mesh().attributes == {}


def test_chart_keys_differ_where_a_plane_does():
    keys = {
        PDCurveSweep(trajectory=UPRIGHT, direction=ALONG_X, start=Plane((0, 0, 1), (x, 0, 1))).mesh().chart.keys
        for x in (0, 0.1, 0.2)
    }
    assert len(keys) == 3


def test_materials_and_creases_are_those_of_caps_and_corners():
    mesh = PDCurveSweep(Rectangle(), UPRIGHT, ALONG_X, Plane((0, 0, 1), (1, 0, 1)), samples=Count(5)).mesh()
    assert mesh.topology.material.tolist().count(1) == 2
    assert mesh.topology.sharp.sum() == 4 * (mesh.rings - 1) + 8


def test_a_closed_axis_has_no_ends():
    shape = PDCurveSweep(Circle(0.2, points=24), Arc(2.0, 2 * np.pi), LEVEL, Plane(), samples=Tolerance(1e-5))
    mesh = shape.mesh()
    assert_solid(mesh, 0)
    assert mesh.volume() == pytest.approx(shape.contour.section().area * 4 * np.pi, rel=1e-4)
    assert mesh.told == ("Limits: a closed trajectory has no ends, so no plane cuts anything off.",)


def test_open_limits_leave_a_surface():
    shape = PDCurveSweep(Circle(0.1, points=12), start=Open(), end=Plane((0, 0.8, 1), (0.2, 1, 0)))
    assert_solid(shape.mesh(), 1, boundary=12)


def test_an_open_outline_makes_a_surface_between_planes_with_true_textures():
    outline = Outline([[(0, 0), (0.3, 0), (0.3, 0.2)]], closed=False)
    planes = Plane((0, 0, 0.5), (0.4, 0, 1)), Plane((0, 0, 2.5), (-0.3, 0.2, 1))
    mesh = PDCurveSweep(outline, UPRIGHT, ALONG_X, *planes, Count(5)).mesh()
    start, following = mesh.uv, mesh.uv[mesh.topology.following]
    cross = (start[:, 0] * following[:, 1] - start[:, 1] * following[:, 0]) / 2
    areas = np.abs(np.add.reduceat(cross, mesh.offsets[:-1]))
    # By hand: trapezia as wide as the two edges, as long as between the planes at the middle of each.
    assert mesh.area() == pytest.approx(0.3 * (2 + 0.7 * 0.15) + 0.2 * (2 + 0.7 * 0.3 - 0.2 * 0.1), rel=1e-12)
    assert areas == pytest.approx(norms(mesh.normals), rel=1e-12)
    assert len(mesh.non_manifold_edges()) == 0 and mesh.euler_characteristic() == 1


def test_bending_an_upright_axis_changes_nothing():
    points = np.random.default_rng(1).normal(size=(50, 3)) + (0, 0, 1)
    shape = PDCurveSweep(trajectory=UPRIGHT, direction=ALONG_X)
    assert np.abs(shape.bend(points) - points).max() < 1e-14


def test_bending_keeps_the_distance_from_the_axis_and_the_lengths_along_it():
    """A tube of any mesh: on a torus again, with angles that are arc lengths over the radius."""
    z = np.linspace(-1, 8, 91)
    angle = np.linspace(0, 20, 91)
    straight = np.column_stack((0.4 * np.cos(angle), 0.4 * np.sin(angle), z))
    bent = PDCurveSweep(trajectory=Arc(2.0, np.pi), direction=LEVEL).bend(straight)
    x, y, height = bent.T
    inside = (z >= 0) & (z <= 2 * np.pi)
    assert np.hypot(np.hypot(x, y) - 2, height)[inside] == pytest.approx(0.4, abs=1e-12)
    assert np.arctan2(y, x)[inside] == pytest.approx(z[inside] / 2, abs=1e-12)
    before, after = z < 0, z > 2 * np.pi
    assert y[before] == pytest.approx(z[before], abs=1e-12) and y[after] == pytest.approx(
        2 * np.pi - z[after], abs=1e-12
    )


def test_a_trimmed_straight_solid_bent_is_the_model_that_a_curved_axis_transforms():
    """Its volume is that of the straight one where the centroid of every slice is on the axis (Weyl, Pappus)."""
    contour = Rectangle(0.3, 0.2)
    planes = Plane((0, 0, 0.5), (0.3, 0.2, 1)), Plane((0, 0, 3.5), (-0.5, 0, 1))
    straight = PDCurveSweep(contour, UPRIGHT, ALONG_X, *planes, Count(400)).mesh()
    bender = PDCurveSweep(trajectory=Arc(4 / np.pi, np.pi), direction=LEVEL)
    bent = type(straight)(bender.bend(straight.vertices), straight.topology)
    assert_solid(bent, 2)
    assert bent.volume() == pytest.approx(straight.volume(), rel=1e-3)  # the bent caps are as flat as their faces


SOMEWHERE = "where the direction runs along the trajectory or is 0"
BAD = {
    "trajectory: must be smooth, or its corners round, got a corner at u = 1": dict(
        trajectory=Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)]), direction=LEVEL
    ),
    f"end: {ONCE}, got that of point 1 not cut": dict(end=Plane((0, 0, 1), (1, 0, 0))),
    f"start: {ONCE}, got that of point 1 cut again before all others are": dict(
        trajectory=Helix(1.0, 0.5, 3), direction=LEVEL, start=Plane((0, 0, 0.75), (0, 0.5, 1))
    ),
    "end: must cut the solid off beyond its start everywhere, got 0.05 m before it": dict(
        start=Plane((0, 0, 1), (1, 0, 1)), end=Plane((0, 0, 1.1), (0, 0, 1))
    ),
    "end: must cut within 415 m of the trajectory's end, got 996": dict(end=Plane((0, 0, 1000), (0, 0, 1))),
    f"direction.parallel: must be continue {SOMEWHERE}, got refuse at u = 0.5": dict(
        direction=Cubic([(1, 0, -1), (1, 0, -1), (-1, 0, 3), (-1, 0, 3)], parallel="refuse")
    ),
    "direction: must not run along the whole trajectory, got one that says no side anywhere": dict(
        direction=Arrows([(0, 0, 0, 1)])
    ),
}


@pytest.mark.parametrize("sentence", BAD)
def test_what_cannot_be_made_is_refused_in_one_sentence(sentence):
    shape = PDCurveSweep(**{"trajectory": UPRIGHT, "direction": ALONG_X} | BAD[sentence])
    with pytest.raises(ShapeError) as refusal:
        shape.mesh()
    assert str(refusal.value) == sentence


def test_a_job_holds_all_of_it():
    shape = PDCurveSweep(
        Circle(0.1), Bezier(TEAPOT_INNER), Guide(TEAPOT_OUTER), Plane((1, 2, 3), (1, 0, 0)), Open(), Count(9)
    )
    assert load((PDCurveSweep,), dump(shape)) == shape


def random_shape(rng):
    """A shape of any kinds, with the Euler characteristic that it must have and how many of its ends are open."""
    length = rng.uniform(2, 4)
    steps = rng.uniform((0.3, -0.4, -0.4), (1, 0.4, 0.4), (5, 3))
    trajectory, side = [
        lambda: (Line(end=(length, 0, 0)), (0, 0, 1)),
        lambda: (Arc(length, rng.uniform(0.5, 5)), (0, 0, 1)),
        lambda: (Helix(length, rng.uniform(0.1, 1), rng.uniform(0.2, 2)), (0, 0, 1)),
        lambda: (Sampled(np.cumsum(steps, axis=0)), (0, 0, 1)),
        lambda: (Bezier(np.cumsum(steps[:4], axis=0)), (0, 1, 1)),
        lambda: (TorusKnot(2, 3, length, length / 3), (0, 0, 1)),
        lambda: (Arc(length, 2 * np.pi), (0, 0, 1)),
    ][rng.integers(7)]()
    closed = trajectory.closed
    around = np.array(side) + rng.uniform(-0.3, 0.3, (4, 3)) * (not closed)
    direction = [
        lambda: Cubic(around, ["bezier", "hermite", "b-spline"][rng.integers(3)]),
        lambda: Arrows(np.column_stack(([0, 0.2, 0.7, 1], around))),
        lambda: Tilt(),
        lambda: Guide(around * 50, "b-spline") if not closed else Tilt(),
    ][rng.integers(4)]()
    name = list(GLYPHS)[rng.integers(len(GLYPHS))]
    outline, holes = (GLYPHS[name]) if rng.random() < 0.4 else (None, (0,))
    contour = Circle(rng.uniform(0.02, 0.15), int(rng.integers(3, 24)))
    if outline:
        contour = type(outline)([0.1 * loop.values for loop in outline.loops])
    limits = []
    for part in (rng.uniform(-0.1, 0.3), rng.uniform(0.7, 1.1)):
        u = np.array([trajectory.domain[0] + np.clip(part, 0, 1) * (trajectory.domain[1] - trajectory.domain[0])])
        tangent = trajectory.tangents(u)[0]
        point = trajectory.evaluate(u)[0] + (part - np.clip(part, 0, 1)) * trajectory.length() * tangent
        plane = Plane(point, tangent * rng.choice([-1, 1]) + rng.uniform(-0.6, 0.6, 3))
        limits.append([plane, plane, plane, Flat(), Open()][rng.integers(5)])
    opened = 0 if closed else sum(isinstance(limit, Open) for limit in limits)
    euler = 0 if closed else sum((1 - hole) * (2 - opened) for hole in holes)
    shape = PDCurveSweep(contour, trajectory, direction, *limits, Count(int(rng.integers(12, 40))))
    return shape, euler, opened


@pytest.mark.parametrize("chord", [1e-3, 1e-4, 1e-5])
def test_the_cut_of_a_bent_beam_is_followed_between_the_corners_of_its_contour(chord):
    """Over each place of the contour the beam is as long as its radius times the angle at which the plane is reached.

    That angle p solves r (sin p - 0.3 cos p) + 0.6 z = 1. The integral is Gauss-Legendre's, exact to rounding; edges
    that are all straight are off by a hundredth. What chords miss is at most the surface times the tolerance.
    """
    shape = PDCurveSweep(
        Rectangle(1.6, 0.4), Arc(2.0, np.pi / 2), Arrows([(0, 0, 0, 1)]), end=Plane((0, 1, 0), (-0.3, 1, 0.6)),
        samples=Tolerance(chord),
    )  # fmt: skip
    places, weights = np.polynomial.legendre.leggauss(40)
    z, r = 0.8 * places[:, None], 2 + 0.2 * places
    angle = np.arctan(0.3) + np.arcsin((1 - 0.6 * z) / (r * np.sqrt(1.09)))
    truth = 0.8 * 0.2 * weights @ (r * angle) @ weights
    mesh = shape.mesh()
    assert abs(mesh.volume() - truth) < mesh.area() * chord
    assert_solid(mesh, 2, 0)


def test_the_cut_of_a_straight_bar_that_turns_is_followed_too():
    """Turned back by the angle of d at its height, an edge of the cap lies on the side of the rectangle."""
    d = np.array([(1, 0, 0), (1, 1, 0), (0, 1, 0), (-1, 1, 0)])
    end = Plane((0, 0, 2.5), (0.5, 0, 1))
    shape = PDCurveSweep(Rectangle(1.6, 0.4), UPRIGHT, Cubic(d), end=end, samples=Tolerance(1e-4))
    mesh = shape.mesh()
    corners = columns(mesh)[:, -1]
    x, y, z = ((corners + np.roll(corners, -1, axis=0)) / 2).T
    t = z[:, None] / 4
    across = (1 - t) ** 3 * d[0] + 3 * t * (1 - t) ** 2 * d[1] + 3 * t**2 * (1 - t) * d[2] + t**3 * d[3]
    back = (x + 1j * y) * np.exp(-1j * np.arctan2(across[:, 1], across[:, 0]))
    off = np.minimum(np.abs(np.abs(back.real) - 0.8), np.abs(np.abs(back.imag) - 0.2))
    assert 1e-6 < off.max() < 1e-4
    assert_solid(mesh, 2)


@pytest.mark.thorough
def test_random_shapes_are_solids(draws):
    """Those that are not refused, at most one in twenty, are closed, manifold and outward, and so are bounded ones."""
    refused, draws = 0, draws if FULL or BRIEF else draws // 2
    for seed in range(draws):
        shape, euler, opened = random_shape(np.random.default_rng(divmod(seed, 100)))
        try:
            mesh = shape.mesh()
        except ShapeError as error:
            assert any(words in str(error) for words in REFUSALS), error
            refused += 1
            continue
        assert_solid(mesh, euler, opened * mesh.chart.grid.columns)  # more than the contour's points where cuts bend
        for limit, side in ((shape.start, 0), (shape.end, -1)):
            if isinstance(limit, Plane) and not shape.trajectory.closed:
                assert np.abs(limit.heights(columns(mesh)[:, side])).max() < 1e-14
    assert refused <= draws / 20


HOOK = Polyline([(0, 0, 0), (10, 0, 0), (10, 5, 0), (5, 5, 0), (5, -5, 0)], corner=Round(1.0))


@pytest.mark.parametrize("size, clean", [(0.79, True), (0.81, False)])
def test_a_round_knot_is_clean_up_to_its_reach(size, clean):
    """The reach of this torus knot is 0.8."""
    found = PDCurveSweep(Circle(size), TorusKnot(2, 3, 2.0, 0.8), Cubic([(0, 0, 1)] * 4)).self_intersections()
    assert (len(found) == 0) == clean and found.largest_safe_size == pytest.approx(0.8, abs=1e-9)


def test_a_path_that_crosses_itself_is_clean_where_a_plane_cuts_it_off():
    """It comes down through its own first leg at (5, 0, 0), and no more where it ends at y = 1, leaning either way."""
    square = Rectangle(1.0, 1.0)
    crossing = PDCurveSweep(square, HOOK, LEVEL).self_intersections()
    assert [place.kind for place in crossing] == ["global"]
    assert np.hypot(*(np.array(crossing[0].point[:2]) - (5, 0))) < 1
    for lean in (-0.4, 0.0, 0.3):
        short = PDCurveSweep(square, HOOK, LEVEL, end=Plane((5, 1.2, 0), (lean, 1, 0.2)))
        assert len(short.self_intersections()) == 0
    longer = PDCurveSweep(square, HOOK, LEVEL, end=Plane((5, 0, 0), (0.2, 1, 0.2))).self_intersections()
    assert len(longer) > 0


def test_a_fold_that_a_plane_cuts_off_is_none():
    """Round a bend of 0.3 m a contour of 0.4 m to the inside folds; straight on before it does not."""
    path = Polyline([(0, 0, 0), (3, 0, 0), (3, 3, 0)], corner=Round(0.3))
    contour = Rectangle(0.2, 0.8)
    assert "local" in [place.kind for place in PDCurveSweep(contour, path, LEVEL).self_intersections()]
    assert len(PDCurveSweep(contour, path, LEVEL, end=Plane((2.0, 0, 0), (1, 0.3, 0))).self_intersections()) == 0


def test_frames_are_the_axes_of_the_mesh():
    shape = PDCurveSweep(Rectangle(0.2, 0.1), Bezier(TEAPOT_INNER), Guide(TEAPOT_OUTER), samples=Count(9))
    frames = shape.frames(9)
    assert frames.contours[0] == pytest.approx(columns(shape.mesh()).swapaxes(0, 1), abs=1e-14)
    assert np.abs(dot(frames.e1, frames.e2)).max() < 1e-15
    with pytest.raises(ShapeError, match="most: must be a whole number, at least 2"):
        shape.frames(1)
