# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sweep-to-CSG: outlines of lines and arcs taken apart, held against the outlines themselves."""

import json
import time
from collections import Counter

import numpy as np
import pytest
from conftest import FULL
from contour_inputs import DATA
from line_arc_outlines import band, inside_by_rays, random_outline, turn, valid

from sweep_addon.core.contours import Circle, Outline, Star
from sweep_addon.core.conversion import KINDS, convert, decompose
from sweep_addon.core.declared.parameters import ShapeError

REAL = json.loads((DATA / "real_outlines.json").read_text())["outlines"]
QUARTER, HALF = np.tan(np.pi / 8), 1.0


SAMPLES = pytest.mark.parametrize("samples", [1_000, pytest.param(20_000, marks=pytest.mark.large)])


TIMES = []  # that the decompositions of all real outlines took, in seconds of processor time


@pytest.fixture(scope="module")
def real():
    """All real outlines with their decompositions."""
    found = []
    for outline in REAL:
        before = time.process_time()
        found.append((outline, *taken_apart(np.array(outline["vertices"]))))
        TIMES.append(time.process_time() - before)
    return found


@pytest.fixture(scope="module", params=[60, pytest.param(1000, marks=pytest.mark.large)])
def drawn_by_chance(request):
    """Random outlines with their decompositions."""
    return [taken_apart(random_outline(np.random.default_rng([seed, 1985]))) for seed in range(request.param)]


def taken_apart(vertices):
    return vertices, decompose(vertices[:, :2], vertices[:, 2])


def told(decomposition):
    """How many of each kind are united and taken off."""
    return Counter((operation, primitive.kind) for operation, primitive in decomposition.operations)


def ears_and_segments(vertices):
    """The primitives that triangulation takes: n - 2 triangles and a segment of a disc for each arc."""
    return len(vertices) - 2 + np.count_nonzero(vertices[:, 2])


def sampled(rng, vertices, count):
    """Points all over the outline and round it, half of them near its vertices."""
    low, high = vertices[:, :2].min(axis=0), vertices[:, :2].max(axis=0)
    size = (high - low).max()
    wide = rng.uniform(low - 0.1 * size, high + 0.1 * size, (count // 2, 2))
    near = vertices[rng.integers(len(vertices), size=count // 2), :2]
    away = size * 10 ** rng.uniform(-5, -1, (count // 2, 1)) * rng.normal(size=near.shape)
    return np.concatenate([wide, near + away])


def require_same_set(vertices, decomposition, seed, samples):
    points = sampled(np.random.default_rng(seed), vertices, samples)
    np.testing.assert_array_equal(decomposition.classify(points), inside_by_rays(vertices, points))


def require_same_area(vertices, decomposition):
    area = Outline([vertices[:, :2]], [vertices[:, 2]]).area
    assert decomposition.signed_area() == pytest.approx(area, rel=1e-9)


def require_reductions(decomposition):
    """Every step lowers vertices and arcs together, but for the halving of an arc."""
    before = decomposition.loop
    for step in decomposition.steps[:-1]:
        assert step.operation == "halve" or step.remaining.complexity < before.complexity
        before = step.remaining
    last = decomposition.steps[-1]
    assert (last.operation, last.remaining, last.primitive.loop) == ("start", None, before)


@pytest.mark.thorough
@SAMPLES
def test_operations_on_primitives_give_every_real_outline_back(real, samples):
    assert len(real) == 349
    for seed, (_, vertices, decomposition) in enumerate(real):
        require_same_set(vertices, decomposition, seed, samples)


@pytest.mark.thorough
@SAMPLES
def test_operations_on_primitives_give_random_outlines_back(drawn_by_chance, samples):
    for seed, (vertices, decomposition) in enumerate(drawn_by_chance):
        require_same_set(vertices, decomposition, seed, samples)


@pytest.mark.thorough
def test_signed_areas_of_primitives_are_the_area(real, drawn_by_chance):
    for outline, vertices, decomposition in real:
        require_same_area(vertices, decomposition)
        assert decomposition.signed_area() == pytest.approx(outline["area"], rel=1e-8)  # nine decimals
    for vertices, decomposition in drawn_by_chance:
        require_same_area(vertices, decomposition)


@pytest.mark.thorough
def test_every_step_lowers_vertices_and_arcs(real, drawn_by_chance):
    for *_, decomposition in (*real, *drawn_by_chance):
        require_reductions(decomposition)


def test_every_primitive_is_of_the_kind_it_is_called_and_a_valid_outline(real):
    """Its own loop, checked as contours are, encloses what it says."""
    for *_, decomposition in real[::10]:
        for primitive in decomposition.primitives:
            assert primitive.kind in KINDS
            assert primitive.outline.area == pytest.approx(primitive.area, rel=1e-9)


def test_primitives_are_at_most_six_tenths_of_ears_and_segments(real, drawn_by_chance):
    for outlines in (real, drawn_by_chance):
        taken = sum(len(decomposition.primitives) for *_, decomposition in outlines)
        assert taken <= 0.6 * sum(ears_and_segments(vertices) for *_, vertices, _ in outlines)


@pytest.mark.thorough
def test_the_median_real_outline_takes_at_most_10_milliseconds(real):
    assert len(TIMES) == len(real) and np.median(TIMES) <= 0.010


def moved(rng, vertices, mirrored):
    """The outline turned, mirrored, scaled, shifted, from another start and, mirrored, the other way round."""
    vertices = np.roll(vertices * (-1, 1, -1) if mirrored else vertices, rng.integers(len(vertices)), axis=0)
    far = np.ptp(vertices[:, :2]) * rng.normal(size=2) * rng.choice([0, 10, 100])
    corners = (vertices[:, :2] @ turn(rng.uniform(0, 2 * np.pi)) + far) * 10.0 ** rng.uniform(-3, 3)
    return (corners, vertices[:, 2]) if rng.random() < 0.5 else (corners[::-1], -np.roll(vertices[::-1, 2], -1))


@pytest.mark.thorough
def test_kinds_and_operations_do_not_depend_on_how_an_outline_lies(real, drawn_by_chance):
    """Each is mirrored or not by turns; in full runs both."""
    rng = np.random.default_rng(5)
    for number, (*_, vertices, decomposition) in enumerate((*real, *drawn_by_chance)):
        for mirrored in (False, True) if FULL else (bool(number % 2),):
            assert told(decompose(*moved(rng, vertices, mirrored))) == told(decomposition)


BLOCK = [(0, 0), (3, 0), (3, 2), (0, 2)]
SLANT = [(0, 0), (4, 0), (3, 2), (0.5, 2)]
RIGHT, OBTUSE = [(0, 0), (3, 0), (0, 4)], [(0, 0), (3, 0), (-1, 4)]
ENDS = [(1, 0), (-1, 0)]
DIAGONALS = [(1, 1), (-1, 1), (-1, -1), (1, -1)]


@pytest.mark.parametrize(
    "kind, corners, bulges",
    [
        ("block", BLOCK, None),
        ("convex prism", SLANT, None),
        ("wedge", RIGHT, None),
        ("triangular prism", OBTUSE, None),
        ("fillet", [(0, 0), (1, 0), (0, 1)], [0, -QUARTER, 0]),
        ("cylinder", ENDS, [1, 1]),
        ("cylinder", ENDS, [np.tan(0.1), np.tan(np.pi / 2 - 0.1)]),
        ("minor chorded cylinder", ENDS, [0, 1]),
        ("minor chorded cylinder", ENDS, [0, 0.3]),
        ("major chorded cylinder", ENDS, [0, 1.7]),
        ("lens", ENDS, [0.3, 0.9]),
        ("double cylinder", ENDS, [0.9, 1.7]),
        ("crescent", ENDS, [0.9, -0.3]),
    ],
)
def test_a_primitive_is_its_own_decomposition(kind, corners, bulges):
    assert told(decompose(corners, bulges)) == {("start", kind): 1}


@pytest.mark.parametrize("arcs", [2, 3, 4, 8, 100])
def test_a_circle_is_one_cylinder_however_many_arcs_it_is(arcs):
    angles = np.sort(np.random.default_rng(arcs).uniform(0, 2 * np.pi, arcs))
    sweeps = np.diff([*angles, angles[0] + 2 * np.pi])
    circle = decompose(np.stack([np.cos(angles), np.sin(angles)], axis=1), np.tan(sweeps / 4))
    assert told(circle) == {("start", "cylinder"): 1}
    assert circle.signed_area() == pytest.approx(np.pi, rel=1e-12)


@pytest.mark.parametrize(
    "corners, bulges, expected",
    [
        ([(0, 0), (3, 0), (3, 1), (0, 1)], [0, HALF, 0, HALF], ["block", "+ minor chorded cylinder"]),
        ([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], None, ["block", "- block"]),
        ([(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)], None, ["block", "- block"]),
        ([(0, 0), (3, 0), (3, 1), (2, 1), (2, 4), (1, 4), (1, 1), (0, 1)], None, ["block", "+ block"]),
        ([(0, 0), (3, 0), (3, 2), (2, 3), (0, 3)], None, ["convex prism"]),
    ],
)
def test_simple_parts_are_what_a_draughtsman_would_call_them(corners, bulges, expected):
    signs = {"start": "", "union": "+ ", "difference": "- "}
    assert {signs[operation] + kind for operation, kind in told(decompose(corners, bulges))} == set(expected)


def test_rounded_corners_are_fillets_taken_off_and_hollow_ones_put_in():
    """A plate of 4 x 3 with corners of radius 1, and an L with its inner corner rounded."""
    plate = [(1, 0), (3, 0), (4, 1), (4, 2), (3, 3), (1, 3), (0, 2), (0, 1)]
    assert told(decompose(plate, [0, QUARTER] * 4)) == {("start", "block"): 1, ("difference", "fillet"): 4}
    bracket = [(0, 0), (4, 0), (4, 1), (2, 1), (1, 2), (1, 4), (0, 4)]
    found = told(decompose(bracket, [0, 0, 0, -QUARTER, 0, 0, 0]))
    assert found == {("start", "block"): 1, ("difference", "block"): 1, ("union", "fillet"): 1}


def test_a_bite_out_of_a_disc_leaves_its_circle_whole_again():
    """A disc of radius 1 with a bite of radius 1/2 about a point of its rim, and with two."""
    rim = 2 * np.arcsin(0.25)  # as seen from the centre, half the angle that the bite takes of the rim
    bite = -np.tan((np.pi - rim) / 4)

    def bitten(*places):
        ends = [(place + side * rim) for place in places for side in (-1, 1)]
        rest = [np.tan((b - a) / 4) for a, b in zip(ends[1::2], [*ends[2::2], ends[0] + 2 * np.pi], strict=True)]
        bulges = [bulge for pair in zip([bite] * len(rest), rest, strict=True) for bulge in pair]
        return decompose(np.stack([np.cos(ends), np.sin(ends)], axis=1), bulges)

    lens = rim - np.sin(2 * rim) / 2 + (np.pi - rim - np.sin(rim)) / 8  # a segment of each of the discs
    assert bitten(0.0).signed_area() == pytest.approx(np.pi - lens, rel=1e-12)
    assert bitten(0.0, 2.0).signed_area() == pytest.approx(np.pi - 2 * lens, rel=1e-12)
    assert told(bitten(0.0)) == {("start", "crescent"): 1}
    assert told(bitten(0.0, 2.0)) == {("start", "crescent"): 1, ("difference", "lens"): 1}


def test_a_flat_on_a_shaft_takes_a_chorded_cylinder_off():
    flat = decompose([(np.cos(0.5), -np.sin(0.5)), (np.cos(0.5), np.sin(0.5))], [0, np.tan((2 * np.pi - 1) / 4)])
    assert told(flat) == {("start", "major chorded cylinder"): 1}
    angles = np.array([0.0, 1.0, np.pi, np.pi + 1.0])  # two flats
    rims = np.tan((np.pi - 1) / 4)
    shaft = decompose(np.stack([np.cos(angles), np.sin(angles)], axis=1), [0, rims, 0, rims])
    assert told(shaft) == {("start", "major chorded cylinder"): 1, ("difference", "minor chorded cylinder"): 1}


@pytest.mark.parametrize("angle", [1.0, 3.0, 5.0, 6.2])
@pytest.mark.parametrize("thin", [0.1, 0.001])
def test_a_thin_part_of_a_ring_takes_three_primitives(angle, thin):
    """Its inner disc is taken off and its outer one put on, on the chords or the gap between them."""
    ends = np.array([(np.cos(angle), np.sin(angle)), (1, 0)])
    corners = [ends[1], ends[0], (1 - thin) * ends[0], (1 - thin) * ends[1]]
    ring = decompose(corners, [np.tan(angle / 4), 0, -np.tan(angle / 4), 0])
    assert len(ring.primitives) == 3
    assert ring.signed_area() == pytest.approx(angle / 2 * (1 - (1 - thin) ** 2), rel=1e-9)


@pytest.mark.parametrize("count, samples", [(40, 2_000), pytest.param(400, 20_000, marks=pytest.mark.large)])
def test_bands_of_arcs_that_block_one_another_are_converted_by_halving(count, samples):
    halved = 0
    for seed in range(count):
        vertices = band(np.random.default_rng([seed, 70]))
        if not valid(vertices, 1e-3) or not valid(vertices, 1e-6):
            continue
        vertices, decomposition = taken_apart(vertices)
        require_same_set(vertices, decomposition, seed, samples)
        require_same_area(vertices, decomposition)
        require_reductions(decomposition)
        halved += sum(step.operation == "halve" for step in decomposition.steps)
    assert halved > 0


def test_needless_vertices_repeated_ones_and_either_direction_change_nothing():
    plain = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (0, 1)]
    dense = [(0, 0), (1, 0), (1, 0), (3, 0), (4, 0), (4, 1e-13), (4, 3), (3, 3), (3, 2), (3, 1), (0, 1), (0, 0)]
    assert told(decompose(dense)) == told(decompose(plain)) == told(decompose(plain[::-1]))
    nearly = decompose(plain, [1e-17, 0, -1e-16, 0, 1e-15, 0])  # arcs that are lines
    assert told(nearly) == told(decompose(plain))


@pytest.mark.parametrize("height", [1e-4, 1e-6, 1e-8])
def test_nearly_collinear_vertices_and_flat_arcs_are_kept(height):
    """Their areas are counted: a triangle of that height over a side of 2, two thirds of it for an arc."""
    for way in (1, -1):
        corner = decompose([(0, 0), (1, -way * height), (2, 0), (2, 2), (0, 2)])
        arc = decompose([(0, 0), (2, 0), (2, 2), (0, 2)], [way * height, 0, 0, 0])
        assert corner.signed_area() == pytest.approx(4 + way * height, rel=1e-14)
        assert arc.signed_area() == pytest.approx(4 + way * height * 4 / 3, rel=1e-14)


@pytest.mark.parametrize("edge", [1e-3, 1e-6, 1e-8])
def test_tiny_steps_are_kept(edge):
    corners = [(0, 0), (1, 0), (1, edge), (2, edge), (2, 1), (0, 1)]
    step = decompose(corners)
    assert step.signed_area() == pytest.approx(2 - edge, rel=1e-14)
    assert len(step.primitives) == 2


def test_points_of_edges_that_primitives_share_are_neither_lost_nor_counted_twice():
    """A grid whose points lie on chords and corners: the union has no seams, as the outline itself has none."""
    corners = np.array([(0, 0), (4, 0), (4, 2), (3, 2), (3, 3), (1, 3), (1, 2), (0, 2)]) / 4
    bulges = [0, 0.5, 0, 0, -0.5, 0, 0, 1]
    grid = np.stack(np.meshgrid(np.arange(-8, 41) / 32, np.arange(-8, 33) / 32), axis=-1).reshape(-1, 2)
    round_it = [inside_by_rays(np.column_stack([corners, bulges]), grid + 1e-9 * np.array(way)) for way in DIAGONALS]
    off = np.all(round_it, axis=0) == np.any(round_it, axis=0)  # no edge of the outline is here
    assert len(decompose(corners, bulges).primitives) > 3
    np.testing.assert_array_equal(decompose(corners, bulges).classify(grid)[off], round_it[0][off])


def square(size, x, y):
    return [(x, y), (x + size, y), (x + size, y + size), (x, y + size)]


def test_holes_are_taken_off_and_islands_united():
    loops = [square(10, 0, 0), square(6, 2, 2)[::-1], [(4, 5), (6, 5)], square(1, 20, 0)]
    area = convert(Outline(loops, [[0] * 4, [0] * 4, [1, 1], [0] * 4]))
    assert [operation for operation, _ in area.parts] == ["start", "union", "difference", "union"]
    assert Counter(primitive.kind for primitive in area.primitives) == {"block": 3, "cylinder": 1}
    assert area.signed_area() == pytest.approx(100 - 36 + np.pi + 1, rel=1e-12)
    assert area.classify([(1, 1), (3, 3), (5, 5), (20.5, 0.5), (15, 0.5)]).tolist() == [True, False, True, True, False]


def test_other_contours_are_converted_too():
    assert [primitive.kind for primitive in convert(Circle(2.0)).primitives] == ["cylinder"]
    star = convert(Star())
    assert star.signed_area() == pytest.approx(Star().section().area, rel=1e-12)


@pytest.mark.parametrize(
    "corners, bulges, sentence",
    [
        ([(0, 0), (1, 0)], [0, 0], "outline: must enclose an area"),
        ([(0, 0), (1, 0), (2, 0)], None, "outline: must enclose an area"),
        ([(0, 0)], None, "corners: must be at least two"),
        ([(0, 0), (2, 0), (2, 2), (0.5, -1)], None, "outline: must not cross"),
        ([(0, 0), (2, 0), (2, 2), (1, 0), (0, 2)], None, "outline: must not cross"),
        ([(0, 0), (2, 0), (2, 2), (0, 2)], [0, 0, -1.5, 0], "outline: must not cross"),
        ([(0, 0), (2, 0), (2, 2)], [0, 0], "bulges: must be one number a corner"),
        ([(0, 0, 0), (2, 0, 0), (2, 2, 0)], None, "corners: must be pairs"),
        ([(0, 0), (np.nan, 0), (2, 2)], None, "corners and bulges: must be finite"),
    ],
)
def test_what_is_no_outline_is_refused_in_a_sentence(corners, bulges, sentence):
    with pytest.raises(ShapeError, match=sentence):
        decompose(corners, bulges)


def test_open_contours_are_refused():
    with pytest.raises(ShapeError, match="contour: must be closed"):
        convert(Outline([square(1, 0, 0)], closed=False))


@pytest.mark.parametrize("size", [1e-4, 1e-7, 1e-9, 1e-11])
def test_details_however_small_are_kept(size):
    """A block less one, and less a fillet if its corner is round; one more where a fillet is too small a pattern.

    Nothing is halved: what touches is not measured by what is larger than the detail.
    """
    corners = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (size, 2), (0, 2 - size)]
    for bulge, expected, most in ((0.0, 3 - size**2 / 2, 2), (QUARTER, 3 - (1 - np.pi / 4) * size**2, 4)):
        found = decompose(corners, [0, 0, 0, 0, 0, bulge, 0])
        assert found.signed_area() == pytest.approx(expected, rel=1e-14)
        assert [step.operation for step in found.steps].count("halve") == 0
        assert len(found.primitives) <= most - (bulge > 0 and size > 1e-8)
