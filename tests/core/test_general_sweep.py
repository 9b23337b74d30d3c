# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""General sweeps: planar figures, surfaces and solids in any motion, against closed forms and other sweeps."""

from math import pi, sqrt

import numpy as np
import pytest
from conftest import BRIEF, FULL
from solids import assert_solid

from sweep_addon.core.contours import Circle, Outline, Rectangle, RegularPolygon, Star
from sweep_addon.core.contours.region import Region
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.membership import classify
from sweep_addon.core.shapes.general_sweep import GeneralSweep
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.solids import Ball, Block, Bracket, Cylinder, DrilledBlock, Triangles
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Bezier, Formula, Helix, Line, Polyline, TorusKnot
from sweep_addon.core.variation.motion import Motion, Parallel
from sweep_addon.core.vectors import unit

CUBE = Block(0.4, 0.4, 0.4)
RANDOM = 250 if FULL else 2 if BRIEF else 5  # of each of five solids one
CELLS = 48 if FULL else 32  # of solids whose bounds are parts of a cell


# Planar figures


def test_a_figure_that_stays_parallel_sweeps_its_area_times_the_height():
    """Cavalieri: whatever the way aside, and however the mesh is cut."""
    way = Formula("sin(3*u)", "u^2", "u", 0.0, 1.5)
    mesh = GeneralSweep(Star(5), way).mesh()
    assert mesh.volume() == pytest.approx(Star(5).section().area * 1.5, rel=1e-12)
    assert_solid(mesh, 2)


@pytest.mark.parametrize("trajectory", [Helix(turns=2.0), TorusKnot(), Arc(angle=2 * pi), Line()], ids=repr)
def test_in_a_frame_it_is_the_generalized_cylinder(trajectory):
    given = dict(samples=Count(101), frame="rotation-minimizing")
    one = GeneralSweep(RegularPolygon(5, 0.1), trajectory, **given).mesh()
    other = GeneralizedCylinder(RegularPolygon(5, 0.1), trajectory, samples=Count(101)).mesh()
    if trajectory.closed:  # the frame of a general sweep comes back whole, that of a pentagon by a fifth of a turn
        assert one.volume() == pytest.approx(other.volume(), rel=1e-3)
    else:
        assert np.abs(one.vertices - other.vertices).max() < 1e-12
    assert_solid(one, 0 if trajectory.closed else 2)


def test_it_scales_along_its_own_axes_before_it_turns():
    """A square that is stretched along its x axis and then turned by a right angle lies along y."""
    mesh = GeneralSweep(Rectangle(1.0, 1.0), Line(), samples=Count(2), scale_x=3.0, turn_z=pi / 2).mesh()
    assert np.ptp(mesh.vertices, axis=0) == pytest.approx((1, 3, 1), abs=1e-12)


def test_turns_follow_each_other_about_x_y_and_z():
    """Of the directions that turns by right angles about x, y, z take: z to -y, there it stays, and then to x."""
    motion = Motion(Line(), Parallel(), GeneralSweep(turn_x=pi / 2, turn_y=pi / 2, turn_z=pi / 2).motion.turns,
                    GeneralSweep().motion.scales, ("x", "y", "z"))  # fmt: skip
    assert motion.at(np.array([0.0, 1.0])).matrix[0] @ (0, 0, 1) == pytest.approx((1, 0, 0), abs=1e-12)


def test_a_deformation_is_what_its_formulas_say():
    shape = GeneralSweep(Rectangle(1.0, 1.0), Line(), samples=Count(3), deform_x="x*(1 + t)", deform_y="y + t*s")
    mesh = shape.mesh()
    top, middle = (mesh.vertices[np.isclose(mesh.vertices[:, 2], z)] for z in (1.0, 0.5))
    assert sorted(map(tuple, top.round(12).tolist())) == [(-1, 0.5, 1), (-1, 1.5, 1), (1, 0.5, 1), (1, 1.5, 1)]
    assert middle[:, 0].max() == pytest.approx(0.75)
    assert_solid(mesh, 2)


def test_samples_keep_the_tolerance_of_a_turning_figure():
    """A point r from the axis of a screw of pitch p is nowhere farther from its chord than was asked."""
    shape = GeneralSweep(Rectangle(1.0, 0.2), Line(), turn_z="2*pi*t")
    ((poses, _),) = shape.swept().stood
    outer = np.hypot(0.5, 0.1)
    sagitta = outer * (1 - np.cos(pi * np.diff(poses.t)))
    assert sagitta.max() <= 0.001
    assert sagitta.max() >= 0.0005  # and no closer than that takes


def test_where_it_comes_back_it_has_no_ends_and_else_two():
    ring = Arc(angle=2 * pi)
    assert_solid(GeneralSweep(Circle(0.2), ring, frame="rotation-minimizing").mesh(), 0)
    assert_solid(GeneralSweep(Rectangle(0.2, 0.1), ring, frame="rotation-minimizing", turn_z="2*pi*t").mesh(), 0)
    assert_solid(GeneralSweep(Rectangle(0.2, 0.1), ring, frame="rotation-minimizing", turn_z="pi/2*t").mesh(), 2)


@pytest.mark.parametrize("frame", ["rotation-minimizing", "frenet", "fixed-up"])
def test_a_closed_polyline_makes_the_same_legs_whether_it_starts_at_a_corner_or_amid_a_side(frame):
    """Four bars of a square's side. In a frame that grows by less than whole sectors the leg of the seam is two."""
    square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    for corners in (square, [(0.5, 0, 0), *square[1:], square[0]]):
        path = Polyline(corners, closed=True)
        ring = GeneralSweep(Rectangle(0.1, 0.1), path, Count(40), frame=frame)
        assert_solid(ring.mesh(), 4 * 2)
        assert ring.mesh().volume() == pytest.approx(0.1 * 0.1 * 4, rel=1e-7)
    assert_solid(GeneralSweep(Rectangle(0.1, 0.1), path, Count(40), frame=frame, turn_z="pi/3*t").mesh(), 5 * 2)


CORNERED = Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)])
SHEET = Triangles([(-0.1, -0.1, 0), (0.1, -0.1, 0), (0.1, 0.1, 0), (-0.1, 0.1, 0)], [(0, 1, 2), (0, 2, 3)])
MOVED = {
    "figure": (Rectangle(0.2, 0.2), 0.0),
    "region": (Region("max(abs(x), abs(y)) - 0.1", 0.3), 0.0),
    "surface": (SHEET, 0.0),
    "solid": (Block(0.2, 0.2, 0.2), 0.1),
}


@pytest.mark.parametrize("generator, beyond", MOVED.values(), ids=MOVED)
def test_what_turns_at_once_at_a_corner_passes_over_nothing_there(generator, beyond):
    """Two bars, as long as their legs and what a solid has on both sides: all points visited, and no wedge between."""
    pytest.importorskip("manifold3d", reason="legs are united")
    sweep = GeneralSweep(generator, CORNERED, frame="rotation-minimizing", cells=24 if beyond else 64)
    solid, reach = sweep.solid(), 1 + beyond
    assert solid.volume() == pytest.approx(0.2 * 0.2 * (2 * (reach + beyond) - (0.1 + beyond) ** 2 / 0.2), rel=5e-4)
    p = np.random.default_rng(0).uniform((-0.3, -0.3, -0.15), (1.3, 1.3, 0.15), (20_000, 3))
    x, y, z = p.T
    first = (-beyond < x) & (x < reach) & (np.abs(y) < 0.1)
    second = (np.abs(x - 1) < 0.1) & (-beyond < y) & (y < reach)
    true = (first | second) & (np.abs(z) < 0.1)
    assert ((classify(sweep, p) > 0) == true).all() and true.sum() > 500


@pytest.mark.thorough
def test_a_solid_may_turn_at_a_corner_of_short_legs():
    """Its distance leaps there; taken for one motion it had too much beyond the corner, or gaps, and was refused."""
    path = Polyline([(0, 0, 0), (0.4, 0, 0), (0.4, 0.4, 0)])
    bar = GeneralSweep(Block(0.2, 0.2, 0.2), path, frame="rotation-minimizing", cells=24)
    assert bar.mesh().volume() == pytest.approx(0.2 * 0.2 * (2 * 0.6 - 0.2), rel=1e-5)


def test_a_figure_that_runs_backward_looks_outward():
    down = GeneralSweep(Star(5), Line(end=(0, 0, -1))).mesh()
    assert down.volume() == pytest.approx(Star(5).section().area, rel=1e-12)


def test_an_open_line_sweeps_a_sheet():
    sheet = GeneralSweep(Outline([[(0, 0), (1, 0)]], closed=False), Line(end=(0, 0, 2))).mesh()
    assert sheet.area() == pytest.approx(2.0) and len(sheet.boundary_edges()) == 4 + 2 * (len(sheet.vertices) // 2 - 2)


def test_a_figure_that_turns_through_its_own_axis_is_told():
    """Half of the square moves back where it turns about an axis that it holds."""
    found = GeneralSweep(Rectangle(1.0, 1.0), Arc(0.3, pi), frame="rotation-minimizing").self_intersections()
    assert found[0].kind == "local" and found[0].parameters[0] == pytest.approx((0, pi))
    assert not GeneralSweep(Rectangle(0.5, 0.5), Arc(0.3, pi), frame="rotation-minimizing").self_intersections()


def test_a_figure_that_rises_and_falls_crosses_itself():
    """The lecture's case of a fixed orientation: where the tangent lies in the generator's plane."""
    arch = Formula("u", "0", "1 - u^2", -1.0, 1.0)
    found = GeneralSweep(Rectangle(0.2, 0.2), arch).self_intersections()
    assert found[0].kind == "local" and found[0].parameters[0] == pytest.approx((0, 1), abs=0.05)


def test_the_solid_of_a_figure_that_rises_and_falls_counts_what_both_visit_once():
    """Two oblique prisms of 0.04: at height z what they have in common is 0.2 z wide, and holds 0.02."""
    pytest.importorskip("manifold3d")
    way = Polyline([(0, 0, 0), (0.1, 0, 1), (0.2, 0, 0)])
    solid = GeneralSweep(Rectangle(0.2, 0.2), way).solid()
    assert solid.volume() == pytest.approx(0.08 - 0.02, rel=1e-9)
    assert_solid(solid, 2)


# Surfaces

ROOF = Triangles([(0, 0, 0), (1, 0, 0), (1, 1, 0.2), (0, 1, 0), (0.5, 0.5, 0.3)],
                 [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)])  # fmt: skip


@pytest.mark.parametrize("height", [2.0, -2.0])
def test_a_surface_sweeps_the_area_of_its_shadow_times_the_height(height):
    mesh = GeneralSweep(ROOF, Line(end=(0, 0, height))).mesh()
    assert mesh.volume() == pytest.approx(2.0, rel=1e-12)
    assert_solid(mesh, 2)


def test_a_surface_with_a_hole_sweeps_a_ring():
    outer, inner = (w * np.array([(1, 0, 0), (0, 1, 0.3), (-1, 0, 0), (0, -1, 0.3)]) for w in (2.0, 1.0))
    ahead = [1, 2, 3, 0]
    sides = [(i, ahead[i], 4 + i) for i in range(4)] + [(ahead[i], 4 + ahead[i], 4 + i) for i in range(4)]
    mesh = GeneralSweep(Triangles(np.concatenate((outer, inner)), sides), Line()).mesh()
    assert mesh.volume() == pytest.approx(8 - 2, rel=1e-12)
    assert_solid(mesh, 0)


def test_open_ends_leave_the_sides_of_a_surface():
    mesh = GeneralSweep(ROOF, Line(), start="open", end="open").mesh()
    assert len(mesh.boundary_edges()) == 8


def test_a_surface_whose_boundary_touches_itself_is_refused():
    bow = Triangles([(0, 0, 0), (1, 0, 0), (1, 1, 0), (-1, 0, 0), (-1, -1, 0)], [(0, 1, 2), (0, 3, 4)])
    with pytest.raises(ShapeError, match="^generator: must be a surface whose boundary touches itself nowhere"):
        GeneralSweep(bow, Line()).mesh()


# Solids


def coarse(shape, size):
    """How much of a volume of that surface cells may take or add: a tenth of a cell all over it."""
    mesh = shape.mesh()
    step = np.ptp(mesh.vertices, axis=0).max() / shape.cells
    return mesh, 0.1 * step * mesh.area() / size


@pytest.mark.thorough
def test_a_block_along_a_line_is_a_longer_block():
    mesh, off = coarse(GeneralSweep(CUBE, Line(), cells=CELLS), 0.16 * 1.4)
    assert mesh.volume() == pytest.approx(0.16 * 1.4, rel=off)
    assert_solid(mesh, 2)


@pytest.mark.thorough
def test_a_block_along_a_diagonal():
    """A box along a vector w: its volume and the shadows of its sides, the sum of |w| area."""
    way = (0.5, 0.7, 0.3)
    mesh, off = coarse(GeneralSweep(CUBE, Line(end=way), cells=CELLS), 1)
    assert mesh.volume() == pytest.approx(0.4**3 + 0.16 * sum(way), abs=off)
    assert_solid(mesh, 2)


@pytest.mark.thorough
def test_a_ball_round_a_circle_is_a_torus():
    ball = Ball(0.25, points=48)
    mesh, off = coarse(GeneralSweep(ball, Arc(1.0, 2 * pi), cells=CELLS), 1)
    assert mesh.volume() == pytest.approx(2 * pi**2 * 0.25**2, abs=off)
    assert_solid(mesh, 0)


@pytest.mark.thorough
def test_a_rod_that_turns_about_its_middle_fills_a_disc():
    """Across the axis at x it is a slab, whose corners are sqrt(0.25 + 0.05^2 - x^2) away: the discs of that add up."""
    rod = Cylinder(0.05, 1.0, points=32)
    mesh, off = coarse(GeneralSweep(rod, Line(end=(0, 1e-6, 0)), turn_x="pi*t", cells=CELLS), 1)
    assert mesh.volume() == pytest.approx(pi * (0.25 * 0.1 + 4 / 3 * 0.05**3), abs=off)
    assert_solid(mesh, 2)


@pytest.mark.thorough
def test_a_hole_along_the_way_stays_and_one_across_it_closes():
    drilled = DrilledBlock(points=16)
    along = GeneralSweep(drilled, Line(end=(0, 0, 1)), cells=24).mesh()
    across = GeneralSweep(drilled, Line(end=(1, 0, 0)), cells=24).mesh()
    assert_solid(along, 0)
    assert_solid(across, 2)


@pytest.mark.thorough
def test_a_growing_ball_is_a_cone_with_round_ends():
    """Balls of radius 0.1 + 0.2 z along z: the cone that touches them and both caps, in closed form."""
    shape = GeneralSweep(Ball(0.1, points=48), Line(), cells=CELLS, **{f"scale_{a}": "1 + 2*t" for a in "xyz"})
    mesh, off = coarse(shape, 1)
    assert mesh.volume() == pytest.approx(cone_sphere(0.1, 0.3, 1.0), abs=off)
    assert_solid(mesh, 2)


def cone_sphere(r, big, length):
    """The hull of two balls at a distance: a frustum between the circles of contact, and the caps beyond them."""
    slope = (big - r) / length
    turn = sqrt(1 - slope**2)
    low, high = -r * slope, length - big * slope  # heights of the circles
    a, b = r * turn, big * turn
    frustum = pi * (high - low) * (a * a + a * b + b * b) / 3

    def cap(radius, height):
        return pi * height**2 * (3 * radius - height) / 3

    return frustum + cap(r, r - r * slope) + cap(big, big + big * slope)


@pytest.mark.thorough
def test_points_are_told_as_all_poses_tell_them():
    """In brute force: a point has been visited if it is inside any of a thousand poses of the solid."""
    shape = GeneralSweep(Bracket(), Arc(), turn_x="2*t", turn_z="pi*t")
    swept = shape.swept()
    from sweep_addon.core.swept.field import Field
    from sweep_addon.core.swept.visited import Visited

    poses, back, step = swept.close
    field = Field.of(swept.generator, step / 2)
    points = np.random.default_rng(4).uniform(-1.5, 1.5, (600, 3)) * (1, 1, 0.3)
    told = Visited(field, swept.motion, poses, back).inside(points)
    many, least = swept.motion.at(np.linspace(0, pi, 601)), np.full(len(points), np.inf)
    for origin, matrix in zip(many.origin, many.matrix, strict=True):
        least = np.minimum(least, field.exact((points - origin) @ matrix)[0])
    clear = np.abs(least) > 0.05 * step  # what the mesh could not tell either
    assert (told == (least < 0))[clear].all() and clear.mean() > 0.95 and told.sum() > 20


@pytest.mark.thorough
def test_a_deformed_solid_is_where_its_points_went():
    """Every vertex of the solid in every pose is inside or on the surface, and the surface touches some of them."""
    shape = GeneralSweep(Bracket(), Line(end=(0, 0, 2)), deform_x="x + 0.1*sin(6*y + 4*pi*t)", cells=CELLS // 2)
    mesh, swept = shape.mesh(), shape.swept()
    assert_solid(mesh, 2)
    poses, _, step = swept.close
    points = swept.motion.posed(swept.some, poses).reshape(-1, 3)
    assert (points.max(axis=0) <= mesh.vertices.max(axis=0) + 0.2 * step).all()
    assert (points.min(axis=0) >= mesh.vertices.min(axis=0) - 0.2 * step).all()


@pytest.mark.thorough
def test_random_motions_of_solids_are_closed_manifold_and_outward():
    rng = np.random.default_rng(7)
    for number in range(RANDOM):
        solid = (CUBE, Ball(0.2, 12), Cylinder(0.2, 0.5, 12), Bracket(), DrilledBlock(points=12))[number % 5]
        turns = {f"turn_{axis}": f"{rng.uniform(-4, 4):.3f}*t" for axis in "xyz"}
        mesh = GeneralSweep(solid, Bezier(rng.uniform(-1, 1, (4, 3))), cells=CELLS // 2, **turns).mesh()
        assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges()) and mesh.volume() > 0


def test_random_motions_of_figures_are_closed_manifold_and_outward():
    rng = np.random.default_rng(8)
    for _ in range(8 * RANDOM):
        turns = {f"turn_{axis}": f"{rng.uniform(-2, 2):.3f}*t" for axis in "xyz"}
        way = Bezier(rng.uniform(-1, 1, (4, 3)))
        mesh = GeneralSweep(Star(int(rng.integers(2, 9)), 0.2, 0.1), way, samples=Count(20), **turns).mesh()
        assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
        assert mesh.euler_characteristic() == 2


def test_poses_without_a_size_are_left_out_and_a_solid_that_has_none_is_refused():
    tip = GeneralSweep(CUBE, Line(), cells=24, **{f"scale_{axis}": "1 - t" for axis in "xyz"})
    assert_solid(tip.mesh(), 2)
    with pytest.raises(ShapeError, match="^scale_x: must not be 0 everywhere"):
        GeneralSweep(CUBE, Line(), scale_x=0.0).mesh()


@pytest.mark.thorough
def test_axes_scaled_by_different_factors_leave_faces_where_they_are():
    """The sides of a block that is scaled by 0.5 and 0.02 are at 0.25, to a hundredth of a cell."""
    shape = GeneralSweep(Block(1.0, 1.0, 1.0), Line(), scale_x=0.5, scale_z=0.02, cells=32)
    mesh, (_, _, step) = shape.mesh(), shape.swept().close
    assert mesh.vertices[:, 0].max() == pytest.approx(0.25, abs=0.01 * step)
    assert mesh.vertices[:, 0].min() == pytest.approx(-0.25, abs=0.01 * step)


@pytest.mark.thorough
def test_a_solid_that_bends_out_of_its_box_is_held():
    rod = GeneralSweep(Block(0.2, 0.2, 2.0), Line(end=(0, 2, 0)), deform_x="x + 0.5*cos(pi*z/2)", cells=24)
    mesh = rod.mesh()
    assert_solid(mesh, 2)
    assert mesh.vertices[:, 0].max() == pytest.approx(0.6, abs=0.02)


@pytest.mark.parametrize("flat", [np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0.0)])])
def test_a_body_that_holds_nothing_is_refused(flat):
    with pytest.raises(ShapeError, match="^generator: must hold something"):
        GeneralSweep(Triangles(flat, [(0, 1, 2), (0, 2, 1)]), Line()).mesh()


def test_a_figure_that_is_turned_inside_out_is_told():
    found = GeneralSweep(Rectangle(1.0, 1.0), Line(), scale_x="1 - 2*t", samples=Count(9)).self_intersections()
    assert [place.kind for place in found][:1] == ["local"]


def test_a_figure_that_moves_within_its_plane_says_so():
    assert "within its own plane" in GeneralSweep(Circle(0.2)).mesh().told[0]
    assert GeneralSweep(Circle(0.2), frame="rotation-minimizing").mesh().told == ()


# Regions


def test_a_region_may_part_and_a_part_of_it_may_vanish():
    """One disc becomes two, beside a third that is gone halfway: two bodies, each closed."""
    mesh = GeneralSweep(Region(), Line(end=(0, 0, 1.0)), cells=64).mesh()
    assert_solid(mesh, 4)
    discs = 2 * 0.01 * pi - lens_on_the_way()
    assert mesh.volume() == pytest.approx(discs + pi * 0.06**2 * 0.5 / 3, rel=0.01)


def lens_on_the_way():
    """The volume that two discs of radius 0.1 have in common, whose centres part from 0 to 0.3 in a metre."""
    away = np.linspace(0, 0.2, 20001)
    lens = 2 * 0.01 * np.arccos(away / 0.2) - away / 2 * np.sqrt(np.maximum(0.04 - away**2, 0))
    return float(((lens[1:] + lens[:-1]) / 2).sum() * (away[1] - away[0]) / 0.3)


def test_a_region_that_shrinks_is_a_frustum():
    mesh = GeneralSweep(Region("x^2 + y^2 - (0.2 - 0.1*t)^2"), Line(), cells=96).mesh()
    assert mesh.volume() == pytest.approx(pi / 3 * (0.04 + 0.02 + 0.01), rel=3e-3)
    assert_solid(mesh, 2)


def test_a_region_is_carried_by_the_frame():
    """Pappus: the area of a disc times the way of its centre, round half a circle."""
    mesh = GeneralSweep(Region("x^2 + y^2 - 0.04"), Arc(), frame="rotation-minimizing", cells=128).mesh()
    assert mesh.volume() == pytest.approx(0.04 * pi * pi, rel=1e-2)
    assert np.hypot(*mesh.vertices[:, :2].T).max() == pytest.approx(1.2, abs=1e-3)


RING = dict(trajectory=Arc(1.0, 2 * pi), frame="rotation-minimizing")


@pytest.mark.parametrize(
    ("formula", "squares"),
    [("x^2 + y^2 - 0.04", 0.04), ("x^2 + y^2 - (0.2 + 0.05*cos(6*pi*t))^2", 0.04 + 0.05**2 / 2)],
    ids=["a disc", "one that breathes"],
)
def test_round_a_closed_path_a_region_closes(formula, squares):
    """Pappus: the mean area of the discs times the way of their centre; and no face stands across the ring."""
    sweep = GeneralSweep(Region(formula), cells=160, **RING)
    mesh = sweep.mesh()
    assert_solid(mesh, 0)
    assert mesh.volume() == pytest.approx(pi * squares * 2 * pi, rel=5e-3)
    inner = mesh.vertices - unit(mesh.vertices * (1, 1, 0))
    assert np.linalg.norm(inner, axis=1).min() > 0.149  # of caps some vertices would be within the tube
    assert classify(sweep, np.array([(1.0, 0, 0), (1.0, 0.1, 0.0), (0.7, 0, 0)]), 1e-6).tolist() == [1, 1, -1]


def test_a_region_that_is_another_in_the_end_has_two_ends_round_a_closed_path():
    mesh = GeneralSweep(Region("x^2 + y^2 - 0.04*(1 - t/2)"), cells=64, **RING).mesh()
    assert mesh.euler_characteristic() == 2
    assert len(mesh.boundary_edges()) == 0


def test_a_region_closes_round_a_path_that_is_shorter_than_the_region_is_wide():
    """A disc of 0.2 m about an axis 0.3 m away, of which more is looked at than the way is long."""
    given = RING | {"trajectory": Arc(0.3, 2 * pi), "cells": 64}
    mesh = GeneralSweep(Region("x^2 + y^2 - 0.04", size=2.0), **given).mesh()
    assert mesh.volume() == pytest.approx(0.04 * pi * 0.6 * pi, rel=2e-2)
    assert_solid(mesh, 0)


def test_a_region_that_runs_backward_looks_outward():
    assert GeneralSweep(Region(), Line(end=(0, 0, -1)), cells=32).mesh().volume() > 0.05


# Refusals


@pytest.mark.parametrize(
    "given, sentence",
    {
        "deform_x: must be an expression of x, y, z, t, u, s: 'q' at character 1 is no name": {"deform_x": "q"},
        "deform_z: must be finite everywhere, got inf": {"generator": Rectangle(), "deform_z": "1/t"},
        "scale_y: must be finite everywhere": {"generator": Rectangle(), "scale_y": "log(t)"},
        "cells: must be at least 8, got 2": {"cells": 2},
        "generator.formula: must be negative somewhere": {"generator": {"kind": "region", "formula": "x^2 + 1"}},
        "generator.size: must be so large that the formula is positive at its rim": {
            "generator": {"kind": "region", "formula": "x^2 + y^2 - 1"}
        },
        "generator.faces: must be whole numbers below 3, got 3": {
            "generator": {"kind": "triangles", "vertices": np.eye(3).tolist(), "faces": [[0, 1, 3]]}
        },
        "generator.faces: must be a list of 3 numbers each, got []": {
            "generator": {"kind": "triangles", "vertices": np.eye(3).tolist(), "faces": []}
        },
        "generator.thickness: must be less than 0.5, the shorter leg": {
            "generator": {"kind": "bracket", "thickness": 0.6}
        },
        "generator.radius: must be less than 0.25": {"generator": {"kind": "drilled-block", "radius": 0.3}},
    }.items(),
    ids=lambda value: str(value)[:40],
)
def test_refusals_name_the_parameter(given, sentence):
    given, sentence = (given, sentence) if isinstance(given, dict) else (sentence, given)
    with pytest.raises(ShapeError) as refusal:
        GeneralSweep(**given).mesh()
    assert str(refusal.value).startswith(sentence)
