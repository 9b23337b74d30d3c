# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A contour that becomes others: its volume, its matching, and that it never goes farther than they do."""

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from solids import GLYPHS, assert_solid

import sweep_addon as sw
from sweep_addon.core.contours import Circle, Outline, Rectangle, RegularPolygon, Star, Superellipse
from sweep_addon.core.declared.forms import python_source
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.rings.ends import Flat, Open, Round, Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Helix, Line, Polyline, TorusKnot
from sweep_addon.core.variation.matching import matched
from sweep_addon.core.variation.morph import Blend, Match

UP = Line(end=(0, 0, 3))
CONTOURS = [
    Circle(0.05, points=17),
    Rectangle(0.09, 0.06),
    RegularPolygon(sides=5, radius=0.05),
    Star(points=6, outer=0.06, inner=0.03),
    Superellipse(width=0.1, height=0.08, quarter_points=5),
    Outline([[(-0.04, -0.05), (0.05, -0.04), (0.06, 0.04), (0, 0.06), (-0.06, 0.02)]]),
]


def sections(*contours):
    return [contour.section() for contour in contours]


def test_a_square_that_becomes_a_larger_one_is_a_frustum_of_eight_vertices():
    mesh = GeneralizedCylinder(Rectangle(2, 2), UP, morph=[(1, Rectangle(4, 4))]).mesh()
    assert len(mesh.vertices) == 8
    assert mesh.volume() == pytest.approx(3 / 3 * (4 + 16 + np.sqrt(4 * 16)), rel=1e-14)


def test_a_prismatoid_has_simpsons_volume():
    """A rectangle 4 x 1 over one 2 x 3: the width and the height are linear, so the area is a quadratic."""
    mesh = GeneralizedCylinder(Rectangle(2, 3), UP, morph=[(1, Rectangle(4, 1))], match="by-corner").mesh()
    assert mesh.volume() == pytest.approx(3 / 6 * (6 + 4 * 3 * 2 + 4), rel=1e-14)


@pytest.mark.parametrize("blend", Blend)
def test_a_square_that_becomes_a_circle_has_the_quadrature_of_its_area(blend):
    """The blend of square and disc with points at equal angles round: its area by a fine polygon, summed along t.

    A square's point is taken at the same part of its perimeter as the circle's; the finer of two meshes must be nearer.
    """
    part = (np.arange(4096) + 0.5) / 4096
    side, along = np.divmod(4 * part, 1)
    square = (1 - 1j + 2j * along) * 1j**side * 1.0
    circle = np.exp(2j * np.pi * (part - 1 / 8))
    t = (np.arange(400) + 0.5) / 400
    rising = t if blend is not Blend.EASED else t * t * (3 - 2 * t)
    outlines = square + rising[:, None] * (circle - square)
    areas = (np.conj(outlines) * np.roll(outlines, -1, axis=1)).imag.sum(axis=1) / 2
    expected = 3 * areas.mean()
    errors = []
    for points, contours in ((64, 33), (256, 129)):
        shape = GeneralizedCylinder(
            Rectangle(2, 2), UP, Count(contours), morph=[(1, Circle(1, points=points))], blend=blend
        )
        errors.append(abs(shape.mesh().volume() - expected) / expected)
    assert errors[0] < 2e-3 and errors[1] < errors[0] / 12


def test_a_circle_that_becomes_another_along_an_arc_has_pappus_volume():
    """Half a ring whose radius grows evenly: the integral of pi r^2 over the centroid's way (Pappus)."""
    shape = GeneralizedCylinder(Circle(0.1, points=512), Arc(1.0), Count(200), morph=[(1, Circle(0.3, points=512))])
    expected = np.pi * np.pi * (0.01 + 0.03 + 0.09) / 3
    assert shape.mesh().volume() == pytest.approx(expected, rel=2e-4)


@pytest.mark.parametrize("match", [Match.BY_ARC_LENGTH, Match.BY_CORNER])
def test_every_point_of_every_contour_is_kept(match):
    contours = sections(Rectangle(2, 2), Circle(1, points=14), Rectangle(1, 3), Circle(2, points=9))
    for section, own in zip(matched(contours, match), contours, strict=True):
        apart = np.abs((section.points @ (1, 1j))[:, None] - own.points @ (1, 1j)).min(axis=0)
        assert apart.max() == 0
        assert section.area == pytest.approx(own.area, rel=1e-12)


def test_corners_meet_corners_where_they_are_matched_so():
    square, wide = sections(Rectangle(1, 1), Rectangle(5, 1))
    first, last = matched([square, wide], Match.BY_CORNER)
    assert len(first.points) == 4 and (np.sign(first.points) == np.sign(last.points)).all()


def test_points_meet_at_the_same_part_of_the_way_round():
    """A square's corners are quarters of its perimeter: of a 3 x 1 rectangle those are not its corners."""
    first, last = matched(sections(Rectangle(1, 1), Rectangle(3, 1)), Match.BY_ARC_LENGTH)
    assert len(first.points) == 8
    corners = first.points[np.isclose(np.abs(first.points), 0.5).all(axis=1)]
    facing = last.points[np.isclose(np.abs(first.points), 0.5).all(axis=1)]
    assert len(corners) == 4
    assert np.allclose(np.abs(facing), [1, 0.5])


def test_columns_of_a_square_and_a_circle_have_the_symmetry_of_both():
    """Least twist: each corner of the square meets the point of the circle in its direction, of any circle."""
    for points in (60, 64, 37):
        square, circle = matched(sections(Rectangle(2, 2), Circle(1, points=points)), Match.BY_ARC_LENGTH)
        corners = np.isclose(np.abs(square.points), 1).all(axis=1)
        directions = circle.points[corners] @ (1, 1j) / (square.points[corners] @ (1, 1j))
        assert np.abs(np.angle(directions)).max() < 2 * np.pi / points / 8


def test_first_points_meet_where_they_are_matched_by_index():
    turned = Outline([[(1, -1), (1, 1), (-1, 1), (-1, -1)]])
    first, last = matched(sections(Rectangle(2, 2), turned), Match.BY_INDEX)
    assert np.allclose(last.points, np.roll(first.points, 1, axis=0))


@pytest.mark.parametrize("name", GLYPHS)
def test_letters_with_holes_grow_into_themselves(name):
    glyph, _ = GLYPHS[name]
    larger = Outline([2 * loop.values for loop in glyph.loops])
    mesh = GeneralizedCylinder(glyph, UP, morph=[(1, larger)]).mesh()
    small = glyph.section().area
    assert mesh.volume() == pytest.approx(small * (1 + 2 + 4), rel=1e-12)  # 3 / 3 (A + 2 A + 4 A)
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0


@pytest.mark.parametrize("blend", Blend)
@pytest.mark.parametrize("closed", [False, True])
def test_no_vertex_goes_farther_than_the_contours_beside_it(blend, closed):
    contours = [Circle(0.1), Star(points=5, outer=0.3, inner=0.1), Rectangle(0.1, 0.4), Circle(0.15)]
    places = np.array([0.0, 0.2, 0.5, 0.9])
    shape = GeneralizedCylinder(
        contours[0],
        TorusKnot() if closed else UP,
        Count(400),
        morph=list(zip(places[1:].tolist(), contours[1:], strict=True)),
        blend=blend,
    )
    change, t = shape.moving()[1], np.linspace(0, 1, 1001)
    points = np.stack([change.weights(t) @ change.shape[:, axis::2].T for axis in (0, 1)], axis=2)
    piece = np.searchsorted(change.places, t, side="right").clip(1, len(change.places) - 1)
    pair = np.stack((change.points[piece - 1], change.points[piece]))
    assert (points <= pair.max(axis=0) + 1e-15).all() and (points >= pair.min(axis=0) - 1e-15).all()
    assert np.allclose(points[np.abs(t[:, None] - change.places).argmin(axis=0)], change.points, atol=1e-12)


def test_smooth_blends_have_no_kink():
    """The second differences of a smooth curve fall as the square of the steps, and those of a kink as the steps."""
    radii = [(0.2, 0.3), (0.5, 0.2), (0.8, 0.15)]
    contours = [(t, Circle(r)) for t, r in radii]
    for blend, order in ((Blend.SMOOTH, 2), (Blend.EASED, 2), (Blend.LINEAR, 1)):
        change = GeneralizedCylinder(Circle(0.1), UP, morph=contours, blend=blend).moving()[1]
        worst = []
        for count in (501, 1001):
            x = change.weights(np.linspace(0, 1, count)) @ change.shape[0, ::2]
            worst.append(np.abs(np.diff(x, 2)).max())
        assert worst[0] / worst[1] == pytest.approx(2**order, rel=0.1)


def test_a_smooth_radius_is_that_of_the_law_through_its_points():
    """Circles through radii are scaled by the monotone cubic of `laws.Points`, an independent path of the program."""
    radii = [(0, 0.1), (0.2, 0.3), (0.5, 0.2), (1, 0.15)]
    law = sw.laws.Points(radii)
    shape = GeneralizedCylinder(Circle(0.1), UP, morph=[(t, Circle(r)) for t, r in radii[1:]], blend="smooth")
    t = np.linspace(0, 1, 97)
    change = shape.moving()[1]
    assert change.weights(t) @ change.shape[0, ::2] == pytest.approx(law.evaluate(t, t, t), rel=1e-12)


@st.composite
def shapes(draw):
    """Any of the contours, one after another, on any of the trajectories."""
    contour, *others = draw(st.lists(st.sampled_from(CONTOURS), min_size=2, max_size=4))
    places = draw(st.lists(st.integers(1, 19), min_size=len(others), max_size=len(others), unique=True))
    trajectory = draw(
        st.sampled_from([UP, Helix(turns=1.5), TorusKnot(), Arc(1.0), Polyline([(0, 0, 0), (0, 0, 1), (0, 1, 1)])])
    )
    return GeneralizedCylinder(
        contour,
        trajectory,
        draw(st.sampled_from([Count(9), Count(60)])),
        scale_x=draw(st.sampled_from([1.0, -1.0, "1 - 0.3*sin(2*pi*t)"])),
        twist=draw(st.sampled_from([0.0, "2*pi*t"])),
        start=draw(st.sampled_from([Flat(), Taper(0.3)])),
        end=draw(st.sampled_from([Flat(), Round()])),
        morph=[(place / 20, other) for place, other in zip(places, others, strict=True)],
        match="by-arc-length",
        blend=draw(st.sampled_from(Blend)),
    )


@given(shapes())
def test_every_morph_is_a_solid(shape):
    try:
        mesh = shape.mesh()
    except ShapeError as refusal:
        assert "centroid" in refusal.sentence  # of a star, a round end may not see all
        assume(False)
    assert_solid(mesh, 0 if shape.trajectory.closed else 2)


def test_domes_stand_on_the_contours_of_their_ends():
    """Half a ball of the radius at either end: pi h (a^2 + a b + b^2) / 3 + 2/3 pi (a^3 + b^3)."""
    ends = {"start": Round(), "end": Round()}
    shape = GeneralizedCylinder(Circle(0.5, points=512), UP, Count(64), morph=[(1, Circle(1, points=512))], **ends)
    expected = np.pi * (0.25 + 0.5 + 1) + 2 / 3 * np.pi * (0.125 + 1)
    assert shape.mesh().volume() == pytest.approx(expected, rel=1e-3)


def test_open_lines_make_surfaces_with_the_lines_of_both():
    shape = GeneralizedCylinder(
        Outline([[(-1, 0), (1, 0)]], closed=False),
        UP,
        morph=[(1, Outline([[(-1, 0), (0, 1), (1, 0)]], closed=False))],
    )
    mesh = shape.mesh()
    assert {(-1, 0, 3), (0, 1, 3), (1, 0, 3)} <= {tuple(point.round(12).tolist()) for point in mesh.vertices}
    assert mesh.euler_characteristic() == 1


def test_a_ring_comes_back_to_the_contour_it_began_with():
    mesh = GeneralizedCylinder(Rectangle(0.2, 0.2), Arc(1.0, 2 * np.pi), morph=[(0.5, Circle(0.1))]).mesh()
    assert mesh.euler_characteristic() == 0 and not len(mesh.boundary_edges())


def test_straight_blends_are_sharp_all_round_where_they_meet_at_an_angle():
    shape = GeneralizedCylinder(Circle(1), UP, morph=[(0.5, Circle(2)), (1, Circle(1))])
    grid = shape.swept().chart.grid
    assert grid.creases == (1,)
    assert replaced(shape, blend="smooth").swept().chart.grid.creases == ()


def test_edges_are_sharp_where_a_contour_has_corners_and_not_beyond():
    """A square, a circle and another circle: edges along the corners on the way from the square alone."""
    shape = GeneralizedCylinder(Rectangle(2, 2), UP, morph=[(0.5, Circle(1)), (1, Circle(1))])
    mesh = shape.mesh()
    ends = mesh.vertices[mesh.edges[mesh.topology.sharp]]
    along = ends[np.ptp(ends[..., 2], axis=1) > 0]
    assert len(along) and along[..., 2].max() == pytest.approx(1.5)
    assert np.abs(along[along[..., 2] == 0][:, :2]) == pytest.approx(1)


@pytest.mark.parametrize("blend", Blend)
def test_a_tube_that_grows_folds_from_where_it_is_as_thick_as_its_bend_is_wide(blend):
    """Round a circle of 1 m, from a radius of 0.5 to 1.5: half the way on linearly, and halfway too if eased."""
    shape = GeneralizedCylinder(
        Circle(0.5, points=512), Arc(1.0, 3.0), morph=[(1, Circle(1.5, points=512))], blend=blend, end=Open()
    )
    found = shape.self_intersections()
    folds = [place for place in found if place.kind == "local"]
    assert folds[0].parameters[0] == pytest.approx((1.5, 3.0), abs=1e-3)
    assert found.largest_safe_size == pytest.approx(1 / 1.5, rel=1e-3)
    assert any("the sweep folds" in said for said in shape.mesh().told)


def test_a_tube_that_grows_and_stays_thinner_than_its_bend_is_clean():
    shape = GeneralizedCylinder(Circle(0.5), Arc(1.0, 3.0), morph=[(1, Circle(0.99))])
    assert not len(shape.self_intersections()) and shape.mesh().told == ()


def replaced(shape, **named):
    return GeneralizedCylinder(**{**{key: getattr(shape, key) for key in vars(shape)}, **named})


def test_a_contour_turned_inside_out_on_its_way_is_told():
    back = Outline([[(-1, -1), (1, -1), (1, 1), (-1, 1)]])
    mesh = GeneralizedCylinder(Rectangle(2, 2), UP, morph=[(1, back)], match="by-index").mesh()
    assert mesh.told == (
        "Morph: between t = 0 and t = 1 the contour crosses itself: match it otherwise, or add a contour between.",
    )


def test_a_morph_is_the_same_after_it_was_text():
    shape = GeneralizedCylinder(morph=[(0.25, Circle(0.2)), (1, GLYPHS["L"][0])], match="by-corner", blend="eased")
    assert sw.load(sw.dump(shape)) == shape
    assert eval(python_source(shape), {"sw": sw}) == shape  # written by the program itself
    tables = [{"t": 0.25, "contour": {"kind": "circle", "radius": 0.2}}, {"t": 1, "contour": GLYPHS["L"][0]}]
    assert GeneralizedCylinder(morph=tables, match="by-corner", blend="eased") == shape


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"morph": 5}, "morph: must be a list, got 5"),
        ({"morph": [5]}, "morph.1: must be a table of t, contour, got 5"),
        ({"morph": [(0, Circle())]}, "morph.1.t: must be more than 0, got 0"),
        ({"morph": [(0.5, Circle()), (2, Circle())]}, "morph.2.t: must be at most 1, got 2"),
        ({"morph": [(0.5, Circle(), 1)]}, "morph.1: must have at most 2 values, got 3"),
        ({"morph": [{"place": 0.5}]}, "morph.1.place: is no parameter of Morph, which has t, contour"),
        ({"morph": [(0.5, {"kind": "circle", "radius": 0})]}, "morph.1.contour.radius: must be more than 0, got 0"),
        ({"morph": [(1, Circle())] * 101}, "morph: must have at most 100 items, got 101"),
        (
            {"morph": [(0.5, Circle()), (0.5, Rectangle())]},
            "morph.2.t: must be another t than that of the others, got 0.5",
        ),
        (
            {"morph": [(1, GLYPHS["L"][0]), (0.5, GLYPHS["B"][0])]},
            "morph.2.contour: must have 1 outline as the first contour has, got '1 outline with 2 holes'",
        ),
        (
            {"morph": [(1, Outline([[(0, 0), (1, 0)]], closed=False))]},
            "morph.1.contour: must have 1 outline as the first contour has, got '1 open line'",
        ),
        (
            {"morph": [(1, Star())], "contour": Rectangle(), "match": "by-corner"},
            "morph.1.contour: must have 4 corners as those before it or none where the match is by-corner, got 10",
        ),
        (
            {"morph": [(1, Circle(points=5))], "contour": Rectangle(), "match": "by-index"},
            "morph.1.contour: must have 4 points as the first contour where the match is by-index, got 5",
        ),
        (
            {"morph": [(1, Circle())], "trajectory": TorusKnot()},
            "morph.1.t: must be less than 1 on a closed trajectory, where the first contour stands again, got 1",
        ),
        ({"morph": [(1, Circle())], "fit": "area-true"}, "fit: must be inscribed where the contour changes, got"),
    ],
)
def test_what_makes_no_morph_is_refused_in_one_sentence(given, sentence):
    with pytest.raises(ShapeError) as refusal:
        GeneralizedCylinder(**given).mesh()
    assert str(refusal.value).startswith(sentence)


def test_shown_contours_are_those_of_their_places():
    frames = GeneralizedCylinder(Rectangle(2, 2), UP, morph=[(1, Rectangle(4, 4))]).frames(most=4)
    reach = np.abs(frames.contours[0] - frames.points[:, None]).max(axis=(1, 2))
    assert reach == pytest.approx(1 + frames.s / 3)


@pytest.mark.parametrize("end", [Flat(), Open()])
def test_texture_and_attributes_fit_the_mesh(end):
    mesh = GeneralizedCylinder(Circle(0.2), UP, morph=[(0.4, Rectangle()), (1, Star())], end=end).mesh()
    assert len(mesh.uv) == len(mesh.corners)
    assert all(len(values) == len(mesh.vertices) for values in mesh.attributes.values())
