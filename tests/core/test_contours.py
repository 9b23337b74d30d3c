# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours bound the area that geometry says, with corners where there are corners; what has no area is refused."""

from time import process_time

import numpy as np
import pytest
from contour_inputs import OUTLINES, drawn, ngon, shoelace, square, star
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.contours import Circle, Outline, Rectangle, Section
from sweep_addon.core.contours.crossing import crossings
from sweep_addon.core.declared.parameters import ShapeError


@pytest.mark.parametrize("points", [3, 4, 64, 4096])
def test_a_circle_has_the_area_of_its_inscribed_polygon(points):
    section = Circle(radius=2.0, points=points).section()
    assert section.area == pytest.approx(points / 2 * 4 * np.sin(2 * np.pi / points), rel=1e-12)
    assert section.points[0].tolist() == [2, 0]
    assert not section.sharp.any()


@pytest.mark.parametrize("rounding", [0.1, 0.3, 0.5])
def test_a_rounded_rectangle_has_the_area_of_a_cross_and_four_quarter_polygons(rounding):
    width, height, corner = 2.0, 1.0, 9
    section = Rectangle(width, height, rounding, corner_points=corner).section()
    chords = corner - 1
    quarter = chords / 2 * rounding**2 * np.sin(np.pi / 2 / chords)
    expected = width * height - 4 * (rounding**2 - quarter)
    assert section.area == pytest.approx(expected, rel=1e-12)
    assert not section.sharp.any()


def test_a_rectangle_is_sharp_at_four_corners_unless_rounded():
    assert Rectangle(2.0, 1.0).section().sharp.tolist() == [True] * 4


@pytest.mark.parametrize(("size", "points"), [((2.0, 1.0), 34), ((1.0, 1.0), 32)])
def test_arcs_that_meet_share_a_point(size, points):
    """Of 4 x 9 points the ends of arcs coincide on the sides that the rounding uses up."""
    section = Rectangle(*size, rounding=0.5, corner_points=9).section()
    assert len(section.points) == points
    assert section.edge_lengths.min() > 0.09


def test_a_rectangle_refuses_a_rounding_beyond_half_its_shorter_side():
    with pytest.raises(ShapeError, match="rounding: must be at most 0.5, half the shorter side, got 0.6"):
        Rectangle(2.0, 1.0, rounding=0.6)


@pytest.mark.parametrize("outline", OUTLINES, ids=lambda outline: outline["id"])
def test_outlines_of_lines_and_arcs_have_their_area(outline):
    """Chords within a distance of their arcs miss at most that distance times the length."""
    size = np.ptp(np.array(outline["vertices"])[:, :2], axis=0).max()
    section = drawn(outline, tolerance=size / 1e5).section()
    assert abs(section.area - outline["area"]) <= size / 1e5 * section.perimeters[0] + 1e-6 * outline["area"]


@pytest.mark.parametrize("bulge", [1e-9, 1e-17, 1e-300, 5e-324])
def test_an_arc_that_is_nearly_a_line_is_one_chord(bulge):
    """Also where the cosine of its angle rounds to 1."""
    assert len(Outline([square(1)], [(bulge, 0, -bulge, 0)]).section().points) == 4


@pytest.mark.parametrize("tolerance", [1e-1, 1e-3, 1e-5])
def test_chords_of_a_bulge_keep_the_tolerance_and_turn_by_at_most_30_degrees(tolerance):
    section = Outline(loops=[[(-1, 0), (1, 0)]], bulges=[(1, 1)], tolerance=tolerance).section()
    sagitta = 1 - np.cos(np.pi / len(section.points))
    assert np.hypot(*section.points.T) == pytest.approx(1, abs=1e-12)
    assert sagitta <= tolerance
    assert np.degrees(section.turns).max() <= 30 + 1e-9


def test_the_usual_tolerance_is_a_thousandth_of_the_size():
    """At size 1 a half circle of radius 0.5 may sag 0.001: 25 chords of 7.2 degrees, 24 would sag 0.00107."""
    half = Outline(loops=[[(-0.3, 0), (0.3, 0)]], bulges=[(1, 1)])
    assert half == Outline(loops=[[(-0.3, 0), (0.3, 0)]], bulges=[(1, 1)], tolerance=0.0)
    loose, tight = (Outline(half.loops, half.bulges, t).section() for t in (0.0012, 0.0006))
    assert len(loose.points) <= len(half.section().points) <= len(tight.points)


def test_an_annulus_has_its_area_whichever_way_its_loops_run():
    for first in (1, -1):
        for second in (1, -1):
            loops = [ngon(90, 2.0)[::first], ngon(60, 1.0)[::second]]
            section = Outline(loops=loops).section()
            assert section.area == pytest.approx(45 * 4 * np.sin(np.pi / 45) - 30 * np.sin(np.pi / 30))
            assert (section.areas > 0).tolist() == [True, False]


def test_true_tangents_tell_corners_from_roundings():
    """A stadium, its arcs flattened to few chords, has no corner; a half disc has two."""
    stadium = Outline(loops=[[(0, 0), (2, 0), (2, 1), (0, 1)]], bulges=[(0, 1, 0, 1)], tolerance=0.2).section()
    half = Outline(loops=[[(-1, 0), (1, 0)]], bulges=[(0, 1)]).section()
    assert not stadium.sharp.any()
    assert half.points[half.sharp].tolist() == [[-1, 0], [1, 0]]


@pytest.mark.parametrize(("sides", "corners"), [(17, 17), (19, 0)])
def test_straight_loops_are_sharp_where_they_turn_by_more_than_20_degrees(sides, corners):
    assert Outline(loops=[ngon(sides, 1.0)]).section().sharp.sum() == corners


def test_an_island_in_a_hole_is_one_of_its_own():
    loops = [square(1, 4.5, 4.5), square(10), square(2, 4, 4), square(1, 1, 1), square(2, 20, 20)]
    section = Section.from_loops(loops)
    assert section.islands == ((0,), (1, 2, 3), (4,))
    assert section.area == 100 - 4 - 1 + 1 + 4


def test_coincident_and_closing_points_are_dropped_and_pass_on_their_corners():
    loop = np.repeat(square(1), 2, axis=0)
    section = Section.from_loops([[*loop, loop[0]]], sharp=[[0, 1, 0, 0, 0, 0, 1, 0, 0]])
    assert section.points.tolist() == square(1).tolist()
    assert section.sharp.tolist() == [True, False, False, True]


def test_the_first_point_stays_first_when_a_loop_is_turned():
    section = Section.from_loops([square(1)[::-1]])
    assert section.points[0].tolist() == [0, 1]
    assert section.area == 1


@pytest.mark.parametrize("size", [1e-160, 1.0, 1e12])
def test_the_centroid_of_a_triangle_of_any_size_is_the_mean_of_its_corners(size):
    corners = size * np.array([(0, 0), (1, 0), (0.5, 0.75)])
    assert Section.from_loops([corners]).centroid == pytest.approx(corners.mean(axis=0), rel=1e-12, abs=0)


def test_a_hole_counts_against_the_centroid():
    section = Section.from_loops([square(4, 10), square(2, 11, 1)[::-1]])
    assert section.centroid == pytest.approx([12, 2], abs=1e-12)
    assert section.perimeters.tolist() == [16, 8]


def test_equal_outlines_share_their_section():
    first, second = (Outline(loops=[square(1)]) for _ in range(2))
    assert first.section() is second.section()


@pytest.mark.parametrize(
    ("loops", "sentence"),
    [
        ([], "must have at least one loop, got []"),
        ([[(0, 0), (1, 0)]], "must have at least 3 different points, got 2"),
        ([[(0, 0), (1, 0), (1, 1e-12), (0, 0)]], "must have at least 3 different points, got 2"),
        ([[(0, 0), (1, 0), (float("nan"), 1)]], "must have finite numbers up to 1e+12, got (nan, 1) at point 2"),
        ([[(0, 0), (1, 0), (3, 0), (2, 0)]], "must enclose an area, got 4 points on one line"),
        ([[(0, 0), (1, 1), (1, 0), (0, 1)]], "must not cross or touch itself, got a crossing near (0.5, 0.5)"),
        ([square(1), square(1, 0.5, 0.5)], "loops 0 and 1 must not cross or touch each other, got a crossing near"),
        ([square(1), square(1, 1, 1)], "loops 0 and 1 must not cross or touch each other, got a crossing near (1, 1)"),
        ([square(1), square(1, 1, 0)], "loops 0 and 1 must not cross or touch each other"),
        ([square(1), [(5, 5), (6, 5)]], "loop 1 must have at least 3 different points, got 2"),
        ([[(0, 0), (2, 0), (1, 0), (1, 1)]], "must not cross or touch itself, got a crossing near (2, 0)"),
        (["abc"], "must be a list of 2 numbers each, got 'abc'"),
    ],
)
def test_loops_without_an_area_of_their_own_are_refused_in_one_sentence(loops, sentence):
    with pytest.raises(ShapeError) as refusal:
        Section.from_loops(loops)
    assert str(refusal.value).startswith(sentence)


def test_a_refusal_of_an_outline_names_its_parameter():
    with pytest.raises(ShapeError, match="^loops: loop 1 must have at least 3 different points, got 2$"):
        Outline(loops=[square(1), [(5, 5), (6, 5)]])
    with pytest.raises(ShapeError, match="^bulges: must have one number a corner"):
        Outline(loops=[square(1)], bulges=[(1, 1)])
    with pytest.raises(ShapeError, match="^tolerance: must be large enough to give at most 200000 points"):
        Outline(loops=[[(-1, 0), (1, 0)]], bulges=[(1, 1)], tolerance=1e-14)


def crossings_by_definition(points):
    """All pairs of edges of one loop that have a point in common, by whole-number arithmetic, one after another."""
    n = len(points)
    edges = [(points[i], points[(i + 1) % n]) for i in range(n)]

    def side(a, b, c):
        turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        return (turn > 0) - (turn < 0)

    def meet(a, b, c, d):
        boxes = all(max(min(a[k], b[k]), min(c[k], d[k])) <= min(max(a[k], b[k]), max(c[k], d[k])) for k in (0, 1))
        across = side(a, b, c) * side(a, b, d) <= 0 and side(c, d, a) * side(c, d, b) <= 0
        return boxes and across

    apart = [(i, j) for i in range(n) for j in range(i + 2, n) if (i, j) != (0, n - 1)]
    return sorted(pair for pair in apart if meet(*edges[pair[0]], *edges[pair[1]]))


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), min_size=4, max_size=12))
def test_crossings_are_those_of_the_definition(corners):
    points = [corner for i, corner in enumerate(corners) if corner != corners[i - 1]]
    if len(points) < 4:
        return
    following = np.roll(np.arange(len(points)), -1)
    found = crossings(np.array(points, dtype=float), following)
    neighbours = (following[found[:, 0]] == found[:, 1]) | (following[found[:, 1]] == found[:, 0])
    assert sorted(map(tuple, found[~neighbours].tolist())) == crossings_by_definition(points)


@pytest.mark.parametrize("lean", [0, 1, 7])
def test_crossings_of_many_long_edges_are_those_of_the_definition(lean):
    """Sheared, most edges run one way and their boxes lean with them."""
    rng = np.random.default_rng(lean)
    points = rng.integers(0, 40, (120, 2)) @ np.array([[1, lean], [0, 1]]) * 1000
    points = points[(points != np.roll(points, 1, axis=0)).any(axis=1)]
    following = np.roll(np.arange(len(points)), -1)
    found = crossings(points.astype(float), following)
    neighbours = (following[found[:, 0]] == found[:, 1]) | (following[found[:, 1]] == found[:, 0])
    assert sorted(map(tuple, found[~neighbours].tolist())) == crossings_by_definition(points.tolist())


def teeth(points, angle):
    """A comb of long narrow teeth, turned by an angle."""
    along = np.linspace(0, 1, points - 2)
    comb = np.concatenate([np.stack([along, np.arange(points - 2) % 2], axis=1), [(1, -0.1), (0, -0.1)]])
    return comb @ np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])


def spikes(points):
    return ngon(points, 1.0) * np.where(np.arange(points) % 2, 1, 1e-3)[:, None]


def rings(count, sides):
    return list(np.arange(1, count + 1)[:, None, None] * ngon(sides, 1.0))


def specks(columns, rows):
    places = np.stack(np.meshgrid(np.arange(columns) - columns / 2, np.arange(rows) - rows / 2, indexing="ij"), axis=-1)
    return list(ngon(3, 0.2) + places.reshape(-1, 1, 2))


TOO_CLOSE = "must have at most 33,554,432 pairs of edges that lie beside each other, got "


@pytest.mark.parametrize(
    ("loops", "sentence"),
    [
        ([np.random.default_rng(1).random((20_000, 2))], "must not cross or touch itself, got a crossing near"),
        ([np.random.default_rng(1).random((200_000, 2))], "must not cross or touch itself, got a crossing near"),
        ([ngon(200_001, 1.0)], "must have at most 200000 points, got 200001"),
        ([teeth(100_000, 0.5)], None),
        ([spikes(2_000)], None),
        pytest.param([spikes(40_000)], TOO_CLOSE, marks=pytest.mark.thorough),
        pytest.param(rings(30_000, 3), TOO_CLOSE, marks=pytest.mark.thorough),
        ([*rings(800, 24)[100:], *specks(80, 80)], "must have at most 4,194,304 edges around other loops, got"),
        (specks(200, 200), None),
        ([ngon(100_000, 200.0), *specks(100, 100)], None),
    ],
    ids=range(10),
)
def test_large_loops_are_decided_or_refused_in_seconds(loops, sentence):
    """The slowest takes 3 s of a processor; looking at all pairs would take minutes."""
    begun = process_time()
    try:
        Section.from_loops(loops)
        refusal = ""
    except ShapeError as error:
        refusal = str(error)
    assert process_time() - begun < 60
    assert refusal.startswith(sentence) if sentence else not refusal


@pytest.mark.parametrize("angle", [0, 0.5, np.pi / 2])
def test_one_tooth_that_reaches_into_the_next_is_found(angle):
    comb = teeth(20_000, angle)
    comb[[10_001, 10_003]] = comb[[10_003, 10_001]]
    with pytest.raises(ShapeError, match="^must not cross or touch itself, got a crossing near"):
        Section.from_loops([comb])


def test_loops_lie_in_all_that_are_around_them():
    """Squares in squares in two stacks, in no order: each lies in the larger ones of its own stack."""
    rng = np.random.default_rng(3)
    size, stack = np.divmod(rng.permutation(60), 2)
    loops = [square(2 * s + 1, 100 * t - s, -s) for s, t in zip(size, stack, strict=True)]
    found = Section.from_loops(loops).nesting
    expected = [(i, j) for i in range(60) for j in range(60) if stack[i] == stack[j] and size[i] < size[j]]
    assert sorted(map(tuple, found.tolist())) == expected


@given(st.integers(0, 2**32 - 1), st.integers(8, 300))
def test_a_star_keeps_its_area_however_it_is_turned_and_moved(seed, points):
    loop = star(np.random.default_rng(seed), points)
    section = Section.from_loops([loop[::-1] * 1000 + (1e4, -3e4)])
    assert section.area == pytest.approx(shoelace(loop) * 1e6, rel=1e-6)
    assert section.turns.sum() == pytest.approx(2 * np.pi)
