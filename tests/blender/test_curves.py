# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Curves and texts of the scene as trajectories and outlines: what Blender itself shows of them is the truth."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, curve, places, text

from sweep_addon import contours, trajectories
from sweep_addon.bridge import curves, drawn_curves, filled
from sweep_addon.core.contours.flatten import cubics_from_lines
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.trajectories.arc_length import arc_length

SINGLE = 2e-6  # a few units of the last place of single precision, in curves of the size of 1 to 4


def shown(ob):
    """The points that Blender makes of a curve object, hooks and shape keys included."""
    bpy.context.view_layer.update()
    evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    points = places(evaluated.to_mesh())
    evaluated.to_mesh_clear()
    return points


def at_equal_parameters(trajectory, count):
    """Points of a trajectory at as many parameters, evenly spaced, as Blender evaluates a spline."""
    return trajectory.evaluate(np.linspace(*trajectory.domain, count, endpoint=not trajectory.closed))


def at_equal_lengths(trajectory):
    """A hundred points of a trajectory, evenly spaced by arc length."""
    measure = arc_length(trajectory)
    return trajectory.evaluate(measure.parameter(np.linspace(0, measure.total, 100)))


@pytest.mark.parametrize("endpoint", [False, True])
@pytest.mark.parametrize("bezier", [False, True])
@pytest.mark.parametrize("cyclic", [False, True])
@pytest.mark.parametrize(("count", "order"), [(4, 4), (4, 6), (6, 4), (8, 4), (9, 4), (7, 3), (5, 5), (8, 5), (6, 2)])
def test_nurbs_is_the_curve_that_blender_evaluates(scene, count, order, cyclic, bezier, endpoint):
    random = np.random.default_rng(count * order)
    points = np.column_stack((random.normal(size=(count, 3)), random.uniform(1, 2, count)))
    ob = curve("NURBS", points, use_cyclic_u=cyclic, use_endpoint_u=endpoint, use_bezier_u=bezier, order_u=order)

    (trajectory,) = curves.trajectories(ob)

    theirs = shown(ob)
    assert trajectory.closed == cyclic
    assert at_equal_parameters(trajectory, len(theirs)) == pytest.approx(theirs, abs=SINGLE)


@pytest.mark.parametrize("cyclic", [False, True])
def test_bezier_is_the_curve_that_blender_evaluates(scene, cyclic):
    random = np.random.default_rng(7)
    ob = curve("BEZIER", random.normal(size=(5, 9)), use_cyclic_u=cyclic)

    (trajectory,) = curves.trajectories(ob)

    theirs = shown(ob)
    assert trajectory.closed == cyclic
    assert at_equal_parameters(trajectory, len(theirs)) == pytest.approx(theirs, abs=SINGLE)


@pytest.mark.parametrize("cyclic", [False, True])
def test_poly_is_the_curve_that_blender_evaluates(scene, cyclic):
    ob = curve("POLY", np.random.default_rng(7).normal(size=(5, 3)), use_cyclic_u=cyclic)

    (trajectory,) = curves.trajectories(ob)

    theirs = shown(ob)
    assert trajectory.closed == cyclic
    assert at_equal_parameters(trajectory, len(theirs)) == pytest.approx(theirs, abs=SINGLE)


@pytest.mark.parametrize("kind", ["POLY", "NURBS"])
def test_hooks_and_shape_keys_move_the_trajectory_as_they_move_the_curve(scene, kind):
    ob = curve(kind, [(0, 0, 0), (1, 0, 0), (2, 1, 0), (3, 1, 1), (4, 0, 1)])
    ob.shape_key_add(name="Basis")
    key = ob.shape_key_add(name="Bent")
    key.data[3].co, key.value = (3, 5, 1), 0.5
    handle = add("handle", None)
    hook = ob.modifiers.new("Hook", "HOOK")
    hook.object = handle
    hook.vertex_indices_set([2])
    bpy.context.view_layer.update()
    handle.location.z = 3

    theirs = shown(ob)
    for depsgraph in (None, bpy.context.evaluated_depsgraph_get()):
        (trajectory,) = curves.trajectories(ob, depsgraph)
        assert at_equal_parameters(trajectory, len(theirs)) == pytest.approx(theirs, abs=SINGLE)
    assert np.ptp(theirs[:, 2]) > 1.01 and np.ptp(theirs[:, 1]) > 1.01  # both of them show


def test_doubled_points_of_an_edited_polyline_are_one(scene):
    ob = curve("POLY", [(0, 0, 0), (0, 0, 1), (0, 0, 1), (0, 1, 1), (0, 0, 0)], use_cyclic_u=True)
    (trajectory,) = curves.trajectories(ob)
    assert trajectory.points.values.tolist() == [[0, 0, 0], [0, 0, 1], [0, 1, 1]]


def test_polyline_that_comes_back_to_its_start_keeps_its_last_leg(scene):
    points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0]]
    (trajectory,) = curves.trajectories(curve("POLY", points))
    assert trajectory.points.values.tolist() == points and not trajectory.closed


@pytest.mark.parametrize("kind", ["POLY", "NURBS", "BEZIER"])
def test_curve_without_length_is_refused_by_name(scene, kind):
    ob = curve(kind, np.ones((4, 9 if kind == "BEZIER" else 3)), name="Speck")
    with pytest.raises(ShapeError, match="must be a curve with a length, got 'Speck'"):
        curves.trajectories(ob)


@pytest.mark.parametrize("kind", ["POLY", "BEZIER", "NURBS"])
@pytest.mark.parametrize("cyclic", [False, True])
def test_radius_and_tilt_of_the_points_are_those_of_blenders_bevel(scene, kind, cyclic):
    """The first of four points of each contour of a bevel of 1 m: how far out it is, and by how much it has turned."""
    random = np.random.default_rng(5)
    ob = curve(kind, random.normal(size=(6, 9 if kind == "BEZIER" else 3)), use_cyclic_u=cyclic)
    points = ob.data.splines[0].bezier_points if kind == "BEZIER" else ob.data.splines[0].points
    (straight,) = curves.trajectories(ob)
    arms = []
    ob.data.bevel_depth, ob.data.bevel_resolution = 1.0, 0
    for radii, tilts in ((np.ones(6), np.zeros(6)), (random.uniform(0.5, 2, 6), random.uniform(-1, 1, 6))):
        points.foreach_set("radius", radii)
        points.foreach_set("tilt", tilts)
        arms.append(shown(ob).reshape(-1, 4, 3))
    arms = [(rings - rings.mean(axis=1, keepdims=True))[:, 0] for rings in arms]
    lengths = [np.linalg.norm(arm, axis=1) for arm in arms]
    if kind == "BEZIER" and cyclic:  # whose bevel begins at the last knot
        arms, lengths = ([np.roll(part, -12, axis=0) for part in parts] for parts in (arms, lengths))
    turned = np.arccos(np.clip(np.einsum("ij,ij->i", *arms) / (lengths[0] * lengths[1]), -1, 1))

    (trajectory,) = curves.trajectories(ob)

    u = np.linspace(*trajectory.domain, len(turned), endpoint=not cyclic)
    radius, tilt = trajectory.carried(u)
    assert not straight.carries and trajectory.carries
    assert radius == pytest.approx(lengths[1], abs=1e-5)
    assert np.abs(tilt) == pytest.approx(turned, abs=2e-3)  # an arc cosine near 0, in single precision


def test_radius_and_tilt_of_points_that_are_one_are_one(scene):
    ob = curve("BEZIER", [(0, 0, 0) * 3, (0, 0, 0) * 3, (0, 0, 1, 0, 0, 2, 0, 0, 3)])
    for point, radius in zip(ob.data.splines[0].bezier_points, (5, 2, 3), strict=True):
        point.radius = radius
    (trajectory,) = curves.trajectories(ob)
    assert trajectory.radii.values.tolist() == [2, 3] and not len(trajectory.tilts)


def test_a_flat_curve_has_no_tilt(scene):
    """As Blender draws its bevel."""
    ob = curve("POLY", [(0, 0, 0), (1, 0, 0)])
    ob.data.dimensions = "2D"
    ob.data.splines[0].points[1].tilt = 1
    (trajectory,) = curves.trajectories(ob)
    assert not trajectory.carries


def test_curve_without_splines_is_refused(scene):
    with pytest.raises(ShapeError, match="must be a curve with a length"):
        curves.trajectories(add("Empty", bpy.data.curves.new("Empty", "CURVE")))


def test_outline_of_a_bezier_circle_has_its_area(scene):
    """Blender's own circle: four cubics, the radius right to 3e-4."""
    bpy.ops.curve.primitive_bezier_circle_add(radius=2)
    area = curves.outline(bpy.context.active_object).section().area
    assert area == pytest.approx(4 * np.pi, rel=5e-3)


def test_outline_is_scaled_as_its_object_is(scene):
    ob = curve("POLY", [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], use_cyclic_u=True)
    ob.scale = (2, -3, 5)  # mirrored too
    section = curves.outline(ob).section()
    assert section.area == pytest.approx(6)
    assert np.ptp(section.points, axis=0).tolist() == [2, 3]


def test_outline_that_is_not_cyclic_is_closed_by_a_straight_line(scene):
    half_circle = curve("NURBS", [(1, 0, 0), (1, 1, 0), (-1, 1, 0), (-1, 0, 0)], use_endpoint_u=True, order_u=4)
    section = curves.outline(half_circle).section()
    # the area under a cubic with these control points: the integral of y dx of its Bernstein form
    assert section.area == pytest.approx(1.2, rel=5e-3)
    assert section.sharp.sum() == 2


def test_contour_whose_splines_are_all_not_cyclic_stays_open(scene):
    """And is scaled as its object is only where that does not carry the sweep."""
    lines = curve("POLY", [(0, 0, 0), (1, 0, 0), (1, 1, 0)], [(3, 0, 0), (4, 0, 0)])
    lines.scale = (2, 3, 4)
    section = curves.contour(lines, scaled=False).section()
    assert not section.closed and section.perimeters.tolist() == [2, 1]
    assert curves.contour(lines).section().perimeters.tolist() == [5, 2]
    assert curves.contour(text("I")).section().closed


def test_small_rounding_of_a_large_outline_is_no_corner(scene):
    """A curve within an outline is drawn smooth: no chord of it turns by the 20 degrees of an edge."""
    r, k = 0.02, 0.02 * 0.5523
    right = [(1 - r, 0, 0), (1 - r, 0, 0), (1 - r + k, 0, 0)], [(1, r - k, 0), (1, r, 0), (1, r, 0)]
    left = [(1, 1, 0)] * 3, [(0, 1, 0)] * 3, [(0, 0, 0)] * 3
    ob = curve("BEZIER", np.reshape([*right, *left], (-1, 9)), use_cyclic_u=True)
    section = curves.outline(ob).section()
    assert section.sharp.sum() == 3  # the three corners, and none of the rounding's
    assert section.area == pytest.approx(1 - (1 - np.pi / 4) * r**2, abs=1e-4)


def test_outline_of_a_text_is_what_blender_fills(scene):
    ob = text("B%@")
    evaluated = ob.evaluated_get(bpy.context.evaluated_depsgraph_get())
    filled = evaluated.to_mesh()
    area = sum(polygon.area for polygon in filled.polygons)
    evaluated.to_mesh_clear()

    assert curves.outline(ob).section().area == pytest.approx(area, rel=5e-3)


@pytest.mark.parametrize("letters", ["Q", "\N{EURO SIGN}", "II"])
def test_letters_that_overlap_or_turn_back_on_themselves_are_an_outline_around_them(scene, letters):
    """In Blender's own font the Q has a spike without width, the euro two bars across its bow."""
    ob = text(letters)
    ob.data.space_character = 0.35  # the last two run into each other
    section = curves.outline(ob).section()
    assert len(section.offsets) - 1 == {"Q": 2, "\N{EURO SIGN}": 1, "II": 1}[letters]
    bounds = np.array(ob.bound_box)[:, :2]
    assert section.points.min(axis=0) == pytest.approx(bounds.min(axis=0), abs=1e-3)
    assert section.points.max(axis=0) == pytest.approx(bounds.max(axis=0), abs=1e-3)


def test_letters_are_as_smooth_in_a_long_text_as_alone(scene):
    alone, many = (curves.outline(text(letters)).section() for letters in ("O", "O" * 30))
    assert many.area == pytest.approx(30 * alone.area, rel=1e-4)
    assert len(many.points) == 30 * len(alone.points)


@pytest.mark.parametrize("turn", [1, -1])
def test_a_line_under_a_text_fills_what_it_crosses_whichever_way_letters_run(scene, turn):
    """As those of fonts do: a letter of one square metre, and a line of three by a quarter, a third of it on that."""
    ob = text("g")
    ob.data.body_format[0].use_underline = True
    _, under = curves.as_shown(ob, None, filled.letters)
    assert under == (0, 0, 0, 1)
    corners = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    square, line = (np.stack((each, np.roll(each, -1, axis=0)), axis=1) for each in (corners[::turn], corners))
    crossing = [cubics_from_lines(square), cubics_from_lines(line * (3, 0.25) - (1, -0.5))]
    assert filled.around_letters(crossing, (0, 1)).section().area == pytest.approx(1.5, rel=1e-6)


def test_a_drawing_whose_splines_slip_is_the_outline_of_what_it_shows(scene):
    """As the icons that people import have them: a spike without width, a corner passed twice, a line to and fro."""
    square = [(0, 0), (1, 0), (1, 1), (1, 1.001), (1, 1), (0, 1)]
    hole = [(0.25, 0.25), (0.75, 0.25), (0.75, 0.751), (0.751, 0.75), (0.25, 0.75)]
    line = [(2, 0), (2, 1)]
    knots = ([((x, y, 0),) * 3 for x, y in spline] for spline in (square, hole, line))
    ob = curve("BEZIER", *(np.reshape(spline, (-1, 9)) for spline in knots), use_cyclic_u=True)
    for read in (curves.outline, curves.contour):
        section = read(ob).section()
        assert len(section.offsets) == 3
        assert section.area == pytest.approx(0.75, abs=1e-3)


def test_a_spline_that_goes_there_and_back_is_refused_as_what_it_is(scene):
    ob = curve("BEZIER", np.reshape([((0, 0, 0),) * 3, ((1, 0, 0),) * 3], (-1, 9)), use_cyclic_u=True)
    with pytest.raises(ShapeError, match="^must not turn back on itself, got a reversal at u = 0"):
        curves.outline(ob)


def test_curve_of_a_trajectory_is_that_trajectory(scene):
    """There and back: Blender's points stay within a thousandth of the length of where the trajectory is."""
    corner = trajectories.Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)])
    carrying = trajectories.Bezier(radii=[1, 2], tilts=[0, 0.5])
    spline = trajectories.Nurbs([(0, 0, 0), (0, 0, 1), (0, 1, 2), (0, 2, 2)], radii=[1, 1, 0.5, 2])
    known = (trajectories.Line(), trajectories.Helix(), trajectories.TorusKnot(), trajectories.Bezier())
    for made in (corner, *known, carrying, spline):
        ob = add("back", drawn_curves.from_trajectory(made, "back"))
        (again,) = curves.trajectories(ob)
        assert again.closed == made.closed
        assert again.length() == pytest.approx(made.length(), rel=1e-4)
        ours, theirs = (at_equal_lengths(path) for path in (made, again))
        assert ours == pytest.approx(theirs, abs=1e-3 * made.length())
        ours, theirs = (path.carried(arc_length(path).parameter([0, path.length() / 3])) for path in (made, again))
        assert np.array(ours) == pytest.approx(np.array(theirs), abs=1e-2)


MIXED = [[(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(1, 0.5, 0), (2, 0.5, 0)], [(3, 0, 0)]]


def mixed():
    """A curve object of a cyclic spline, of one that is not, and of one with a single point."""
    ob = curve("POLY", *MIXED)
    ob.data.splines[0].use_cyclic_u = True
    return ob


def test_splines_of_several_kinds_are_areas_curves_and_points(scene):
    read = curves.contour(mixed())
    assert read == contours.Mixed(*(np.array(part)[..., :2] for part in (MIXED[:1], MIXED[1:2], MIXED[2])))
    assert TranslationalSweep(read).mesh().dimensions().parts == (1, 1, 1, 0)


def test_splines_of_one_kind_are_an_outline(scene):
    assert curves.contour(curve("POLY", MIXED[0], use_cyclic_u=True)) == contours.Outline([np.array(MIXED[0])[:, :2]])
    lines = MIXED[0], [(1.5, 0.5, 0), (2, 0.5, 0)]
    both = [np.array(spline)[:, :2] for spline in lines]
    assert curves.contour(curve("POLY", *lines)) == contours.Outline(both, closed=False)


@pytest.mark.parametrize("kind", ["BEZIER", "NURBS"])
def test_spline_of_one_point_is_a_point_whatever_its_kind(scene, kind):
    point = [(3, 4, 0) * 3] if kind == "BEZIER" else [(3, 4, 0)]
    assert curves.contour(curve(kind, point)) == contours.Mixed([], [], [(3, 4)])


def test_curve_of_a_mixed_contour_is_that_contour(scene):
    contour = curves.contour(mixed())
    again = curves.contour(add("again", drawn_curves.from_contour(contour, "again")))
    for section, other in zip(again.sections(), contour.sections(), strict=True):
        assert np.abs(section.points - other.points).max() < SINGLE and (section.offsets == other.offsets).all()
