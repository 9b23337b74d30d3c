# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets of grammars have the words of the book, or what their curves are known for; their sliders can be pulled."""

import json
import re
from dataclasses import replace
from functools import cache
from hashlib import sha256
from math import sqrt
from pathlib import Path

import numpy as np
import pytest
from conftest import FULL

from sweep_addon import presets
from sweep_addon.core.grammars import LSystem
from sweep_addon.core.shapes import growing
from sweep_addon.presets import grammars

PRESETS = {preset.path.stem: preset for preset in presets.PRESETS if preset.group == "l_system"}
PAGE = Path(__file__).parents[1] / "docs" / "l_system_presets.md"
ENTRIES = json.loads((Path(__file__).parent / "data" / "abop.json").read_text())["entries"]
MOST_VERTICES = 65_536  # Blender draws so many in a few milliseconds
GOLDEN = (1 + sqrt(5)) / 2
OF_THE_BOOK = {  # the presets of the conformance set, and values of constants where the set has others
    "abop-1.1-fib": "fibonacci_cells",
    "abop-1.4-anabaena": "anabaena",
    "abop-1.6": "koch_island",
    "abop-1.7a": "koch_island_of_eighteen",
    "abop-1.7b": "quadratic_snowflake",
    "abop-1.8": "islands_and_lakes",
    "abop-1.9a": "koch_curve_a",
    "abop-1.9b": "koch_curve_b",
    "abop-1.9d": "koch_curve_d",
    "abop-1.9f": "koch_curve_f",
    "abop-1.10a": "dragon_curve",
    "abop-1.10b": "sierpinski_arrowhead",
    "abop-1.11b": "quadratic_gosper",
    "hilbert-2d": "hilbert_curve",
    "abop-1.16a": "fass_curve_of_nine",
    "abop-1.19": "hilbert_cube",
    "abop-1.24a": "plant_a",
    "abop-1.24b": "plant_b",
    "abop-1.24c": "plant_c",
    "abop-1.24e": "plant_e",
    "abop-1.24f": "plant_f",
    "abop-1.25": "leafy_bush",
    "abop-1.27": "stochastic_plant",
    "abop-1.31a": "hogeweg_hesper_a",
    "abop-1.31b": "hogeweg_hesper_b",
    "abop-1.31d": "hogeweg_hesper_d",
    "abop-1.30a": "signal_up",
    "abop-1.30b": "signal_down",
    "abop-1.29-signal": "signal_wave",
    "abop-eq1.7": "parametric_words",
    "abop-1.37a": "row_of_trees",
    "abop-1.39": "branching_pattern",
    "abop-eq1.10": "branching_pattern_growing",
    "abop-anabaena-heterocysts": "heterocysts",
    "abop-2.6a": "monopodial_tree",
    "abop-2.6b": "monopodial_tree_broad",
    "abop-2.6d": "monopodial_tree_hooked",
    "abop-2.7a": "sympodial_tree",
    "abop-2.7c": "sympodial_tree_uneven",
    "abop-2.7d": "sympodial_tree_even",
    "abop-2.8a": "weeping_tree_a",
    "abop-2.8b": "weeping_tree_b",
    "abop-2.8c": "weeping_tree_c",
    "abop-4.1-sunflower": "sunflower",
    "abop-5.5-cordate": "cordate_leaf",
    "abop-5.6-simple": "simple_leaf",
    "abop-5.8-rose": "rose_leaf",
    "abop-5.11a": "compound_leaf_a",
    "abop-5.11c": "compound_leaf_c",
    "abop-5.11d": "compound_leaf_d",
    "abop-5.12a": "alternate_leaf",
    "koch-snowflake": "koch_snowflake",
    "cantor": "cantor_set",
    "algae": "algae",
    "cpfg-quadratic-koch": "minkowski_sausage",
    "cpfg-compound-param": "tutorial_leaf",
}
AS_PRINTED = {"abop-2.8c": {"lr": 1.79}}  # a misprint, which the preset does not have


@cache
def plant(name):
    return presets.shape(f"l_system_{name}")


def text(name):
    return str(plant(name).system)


def system(name, **values):
    return LSystem.parse(text(name), values) if values else plain(name)


@cache
def plain(name):
    """The system of a preset with its own values, which many tests ask for."""
    return LSystem.parse(text(name))


def by(cases):
    return pytest.mark.parametrize("case", cases, ids=lambda case: case[0])


def test_every_grammar_of_the_conformance_set_is_a_preset():
    assert list(OF_THE_BOOK) == [entry["id"] for entry in ENTRIES]
    assert set(OF_THE_BOOK.values()) <= PRESETS.keys() and len(PRESETS) >= 60


@pytest.mark.parametrize("entry", ENTRIES, ids=[entry["id"] for entry in ENTRIES])
def test_a_preset_derives_the_words_of_the_book(entry):
    found = system(OF_THE_BOOK[entry["id"]], **AS_PRINTED.get(entry["id"], {}))
    if entry["stochastic"]:
        least, most = entry["bounds_modules"]
        assert least <= len(found.derive(entry["iterations"], seed=1)) <= most
        return
    assert [str(found.derive(n)) for n in range(len(entry["words"]))] == entry["words"]
    word = found.derive(entry["iterations"])
    assert (len(word), sha256(str(word).encode()).hexdigest()) == (entry["final"]["modules"], entry["final"]["sha256"])
    assert found.angle == entry.get("angle", found.angle)


@pytest.mark.parametrize(
    "entry", [e for e in ENTRIES if "bbox_of_F_endpoints" in e.get("geometry", {})], ids=lambda e: e["id"]
)
def test_a_preset_draws_the_figure_of_the_book(entry):
    """Its bounds and its end in steps, from the set."""
    found = system(OF_THE_BOOK[entry["id"]])
    figure = found.derive(entry["iterations"]).figure(upright=False)
    left, low, right, high = entry["geometry"]["bbox_of_F_endpoints"]
    assert len(figure) == entry["geometry"]["segments"]
    assert figure.bounds / found.step == pytest.approx(np.array([[left, low, 0], [right, high, 0]]), abs=1e-3)
    assert figure.at[:2] / found.step == pytest.approx(np.array(entry["geometry"]["end"]), abs=1e-3)


# How an edge becomes others: edges of the initiator, edges that each becomes, and how much further apart its ends are.
EDGES = [
    ("koch_island", 4, 8, 4),
    ("koch_island_of_eighteen", 4, 18, 6),
    ("quadratic_snowflake", 1, 5, 3),
    ("koch_curve_a", 4, 8, sqrt(10)),
    ("koch_curve_b", 4, 7, 3),
    ("koch_curve_c", 4, 7, sqrt(5)),
    ("koch_curve_d", 4, 5, 3),
    ("koch_curve_e", 4, 5, sqrt(5)),
    ("koch_curve_f", 4, 5, sqrt(5)),
    ("koch_snowflake", 3, 4, 3),
    ("koch_antisnowflake", 3, 4, 3),
    ("minkowski_sausage", 1, 8, 4),
    ("cesaro_square", 4, 4, 1),
    ("hexagonal_koch_island", 6, 3, sqrt(7)),
    ("pentagonal_koch", 5, 6, sqrt(6 + sqrt(5))),
    ("pentaplexity", 5, 6, GOLDEN**2),
    ("vicsek_cross", 4, 5, 3),
    ("levy_c", 1, 2, 1),
    ("dragon_curve", 1, 2, sqrt(2)),
    ("terdragon", 1, 3, sqrt(3)),
    ("sierpinski_arrowhead", 1, 3, 2),
    ("gosper_curve", 1, 7, sqrt(7)),
    ("quadratic_gosper", 1, 25, 5),
]


@by(EDGES)
def test_corners_of_a_fractal_curve_stay_where_the_scale_of_its_edges_puts_them(case):
    name, sides, edges, scale = case
    found = system(name)
    figure = found.derive().figure()
    each = edges**found.generations
    assert len(figure) == sides * each

    corners = np.concatenate((figure.start[::each], figure.end[-1:]))
    size = np.linalg.norm(corners[1] - corners[0])
    first = LSystem.parse(text(name)).derive(0).figure()
    assert np.linalg.norm(np.diff(corners, axis=0), axis=1) == pytest.approx(np.full(sides, size), rel=1e-9)
    assert size == pytest.approx(np.linalg.norm(first.end[0] - first.start[0]) * scale**found.generations, rel=1e-9)
    assert np.linalg.norm(corners[-1] - corners[0]) == pytest.approx(0 if sides > 1 else size, abs=1e-9 * size)


@by([("koch_snowflake", 4 / 3), ("koch_antisnowflake", 4 / 3), ("minkowski_sausage", 2), ("vicsek_cross", 5 / 3)])
def test_the_length_of_a_koch_curve_grows_by_a_ratio(case):
    name, ratio = case
    found = system(name)
    figure = found.derive().figure()
    each = len(figure) // len(found.derive(0).figure())
    edge = np.linalg.norm(figure.start[each] - figure.start[0]) if each < len(figure) else np.linalg.norm(figure.at)
    assert each * found.step == pytest.approx(edge * ratio**found.generations, rel=1e-9)


def test_a_row_of_right_triangles_is_as_long_as_its_ground():
    """Upright trees stand on the altitudes of right triangles, so the ends stay where they are."""
    found = replace(system("row_of_trees", size=3, p=0.4), angle=90.0)
    assert found.derive(5).figure().at == pytest.approx([3, 0, 0], abs=1e-9)


def test_the_torn_square_tears_less_the_wider_its_teeth():
    """Teeth of 60 degrees make Koch's curve: four thirds as long in each step."""
    figure = system("cesaro_square", a=60, size=1).derive(4).figure()
    assert lengths(figure).sum() == pytest.approx(4 * (4 / 3) ** 4, rel=1e-9)


def lengths(figure):
    return np.linalg.norm(figure.end - figure.start, axis=1)


FILLING = [  # cells along a side for each generation, how many generations more a curve has than its text
    ("hilbert_curve", 2, 0),
    ("moore_curve", 2, 1),
    ("peano_curve", 3, 0),
    ("fass_curve_of_nine", 3, 0),
    ("fass_curve_of_sixteen", 4, 0),
]


@by(FILLING)
def test_a_space_filling_curve_visits_each_cell_of_a_square_once(case):
    name, tile, more = case
    found = system(name)
    assert_visits_all(found, 2, tile ** (found.generations + more))


def test_hilberts_curve_in_space_visits_each_cell_of_a_cube_once():
    found = system("hilbert_cube")
    for generations in (1, 2, 3):
        assert_visits_all(found, 3, 2**generations, generations)


def assert_visits_all(found, dimensions, side, generations=None):
    figure = found.derive(generations).figure(upright=False)
    places = np.concatenate((figure.start[:1], figure.end)) / found.step
    cells = np.round(places - places.min(axis=0)).astype(int)
    assert places - places.min(axis=0) == pytest.approx(cells, abs=1e-9)
    assert len(cells) == len(np.unique(cells, axis=0)) == side**dimensions
    assert cells.max(axis=0)[:dimensions].tolist() == [side - 1] * dimensions


def test_moores_curve_ends_beside_its_beginning():
    found = system("moore_curve")
    assert np.linalg.norm(found.derive().figure().at) == pytest.approx(found.step)


CLOSED = [  # segments after n generations of closed lines
    ("sierpinski_curve", lambda n: 4 ** (n + 1)),
    ("anklets_of_krishna", lambda n: 4 * (4**n - 1) // 3),
    ("snake_kolam", lambda n: 4 + 16 * (4**n - 1) // 3),
    ("twin_dragon", lambda n: 2 ** (n + 1)),
]


@by(CLOSED)
def test_a_kolam_is_one_closed_line(case):
    name, segments = case
    found = system(name)
    for generations in range(1, found.generations + 1):
        figure = found.derive(generations).figure()
        assert len(figure) == segments(generations)
        assert figure.axis.max() == 0 and figure.at == pytest.approx(np.zeros(3), abs=1e-9)


def test_the_two_strands_of_a_twin_dragon_share_no_edge():
    figure = system("twin_dragon").derive().figure()
    middles = np.round((figure.start + figure.end) / 2, 6)
    assert len(np.unique(middles, axis=0)) == len(figure)


def test_triangles_of_sierpinski_have_three_edges_each():
    """A gasket of n levels has 3^n upright triangles, whose edges nobody shares."""
    found = system("sierpinski_triangle")
    figure = found.derive().figure()
    middles = np.round((figure.start + figure.end) / 2, 6)
    assert len(np.unique(middles, axis=0)) == len(figure) == 3 * 3**found.generations


def test_holes_of_the_carpet_leave_eight_ninths_each_time():
    found = system("sierpinski_carpet")
    figure = found.derive().figure()
    *holes, frame = np.sort(np.bincount(figure.axis, lengths(figure)) / 4)
    assert len(holes) == (8**found.generations - 1) // 7
    assert np.sum(np.square(holes)) == pytest.approx(frame**2 * (1 - (8 / 9) ** found.generations), rel=1e-9)


def test_bars_of_cantor_double_and_lose_what_is_not_kept():
    found = system("cantor_bars", keep=0.4, size=3)
    figure = found.derive().figure()
    height = np.round(figure.start[:, 1], 9)
    for level, at in enumerate(np.unique(height)[::-1]):
        assert lengths(figure)[height == at] == pytest.approx(np.full(2**level, 3 * 0.4**level), rel=1e-9)


def test_squares_of_pythagoras_have_one_area_on_each_level():
    found = system("pythagoras_tree", a=30)
    figure = found.derive().figure(upright=True)
    assert len(figure.polygons) == 2**found.generations - 1
    sizes = np.array([np.linalg.norm(square[1] - square[0]) for square in figure.polygons])
    assert np.sum(sizes**2) == pytest.approx(found.generations * sizes.max() ** 2, rel=1e-9)


def test_rhombs_of_penrose_have_unit_edges_angles_of_36_degrees_and_fill_their_outline():
    """Short diagonals of thin rhombs, 2 sin 18 degrees, are least distances; thick ones are golden times as many."""
    found = system("penrose_tiling")
    figure = found.derive().figure()
    steps = (figure.end - figure.start)[:, :2] / found.step
    turns = np.degrees(np.arctan2(steps[:, 1], steps[:, 0])) / 36
    assert np.hypot(*steps.T) == pytest.approx(np.ones(len(steps)), rel=1e-9)
    assert turns == pytest.approx(np.round(turns), abs=1e-6)

    ends = np.round(np.stack((figure.start, figure.end))[:, :, :2] / found.step, 6) + 0.0
    points, numbers = np.unique(ends.reshape(-1, 2), axis=0, return_inverse=True)
    edges = np.unique(np.sort(numbers.reshape(2, -1).T, axis=1), axis=0)
    apart = np.hypot(*(points[:, None] - points).transpose(2, 0, 1)) + 9 * np.eye(len(points))
    assert apart.min() == pytest.approx(2 * np.sin(np.pi / 10), abs=1e-5)
    rhombs = len(edges) - len(points) + 1
    thin = np.count_nonzero(np.isclose(apart, apart.min(), atol=1e-5)) / 2
    assert (rhombs - thin) / thin == pytest.approx(GOLDEN, rel=0.05)


def test_plant_d_has_the_segments_of_its_growth():
    """X triples, and F doubles while each X makes two more: 2 (3^n - 2^n)."""
    found = system("plant_d")
    assert [found.derive(n).count("F") for n in range(8)] == [2 * (3**n - 2**n) for n in range(8)]


def test_the_flowering_plant_has_its_leaves_and_petals():
    """Each plant makes three, three flowers and two leaves, and two internodes with two leaves each, a step later."""
    figure = system("flowering_plant").derive().figure()
    plants = [3**k for k in range(5)]
    petals, leaves, small = 5 * 3 * sum(plants[:3]), 2 * sum(plants[:4]), 4 * sum(plants[:3])
    assert len(figure.polygons) == petals + leaves + small


def test_a_tree_in_the_wind_grows_as_one_that_hangs():
    """Figure 2.8d is 2.8a with other numbers, so that all words are as long."""
    assert system("windswept_tree").sizes(6) == system("weeping_tree_a").sizes(6)


def test_rows_of_a_table_are_one_grammar_with_other_numbers():
    """Figure 2.6c is 2.6a with other numbers, and 2.7b is 2.7a."""
    assert system("monopodial_tree_dense").sizes(10) == system("monopodial_tree").sizes(10)
    assert system("sympodial_tree_wide").sizes(10) == system("sympodial_tree").sizes(10)


def test_an_h_tree_fills_a_rectangle_of_paper():
    """Its bars double and shorten by the root of 2: two levels halve what is left, and sides are as 1 to that root."""
    found = system("h_tree", r=sqrt(0.5), size=3)
    figure = found.derive(8).figure()
    assert len(figure) == 2 * (2**8 - 1)
    width, height, _ = np.ptp(figure.bounds, axis=0)
    assert width == pytest.approx(2 * 3 * (1 - 2**-4), rel=1e-9) and width / height == pytest.approx(sqrt(2), rel=1e-9)


def test_a_crocus_has_a_leaf_in_each_step_before_its_flower():
    """Leaves are fully grown in the end, and the internodes below them have stopped at 2 or a step later."""
    found = system("crocus")
    word = found.derive(40)
    ages = word.columns[0][np.isin(word.symbols, [k for k, (name, _) in enumerate(word.tables.symbols) if name == "L"])]
    constants = {constant.name: constant.value for constant in found.constants}
    assert ages.tolist() == [constants["TL"]] * (int(constants["Ta"]) - 1) and word.count("K") == 1
    *short, long = lengths(word.figure()) / constants["scale"]
    assert len(short) == 6 and long == pytest.approx(20) and all(2 - 1e-9 < length < 2.2 + 1e-9 for length in short)


def test_shoots_of_a_campion_flower_after_8_steps_and_after_4():
    def flowers(n):
        return 1 + flowers(n - 8) + flowers(n - 4) if n > 0 else 0

    found = system("lychnis")
    assert [found.derive(n).count("K") for n in range(30)] == [flowers(n) for n in range(30)]


def test_capsella_has_14_leaves_and_then_a_flower_in_each_step():
    found = system("capsella")
    for generations in (16, 20, 30):
        figure = found.derive(generations).figure()
        stalks = np.count_nonzero((figure.order[figure.parent] == 0) & (figure.order == 1) & (figure.parent >= 0))
        assert stalks == 2 * 14 + (generations - 14)


def test_flowers_of_wall_lettuce_open_from_the_top_and_the_lowest_shoots_are_the_longest():
    """In the end every bud is a flower, and a shoot that the signal reached later had more time to grow."""
    word = system("mycelis").derive(200)
    assert not word.count("A") and not word.count("G") and word.count("K") > 10
    figure = word.figure()
    stem = np.flatnonzero(figure.order == 0)
    first = np.flatnonzero((figure.order == 1) & (figure.parent >= 0) & np.isin(figure.parent, stem))
    shoots = np.bincount(figure.axis)[figure.axis[first]]
    assert (np.diff(shoots[np.argsort(figure.start[first, 2], kind="stable")]) <= 0).all()
    assert shoots.max() > 2 * shoots.min()


def constant(found, name):
    return next(other.value for other in found.constants if other.name == name)


def test_forks_of_blood_vessels_share_out_the_cube_of_the_thickness():
    """Murray 1926: r^3 = r1^3 + r2^3, and at his angles the three pull evenly, each by its thickness squared."""
    found = system("blood_vessels")
    figure = found.derive().figure()
    children = [np.flatnonzero(figure.parent == k) for k in range(len(figure))]
    forks = [k for k, found in enumerate(children) if len(found) == 2]
    assert len(forks) > 100
    one, other = np.array([children[k] for k in forks]).T
    width, heading = figure.width, figure.axes[:, 0]
    assert width[forks] ** 3 == pytest.approx(width[one] ** 3 + width[other] ** 3, rel=1e-9)
    pull = (width**2)[:, None] * heading
    assert pull[forks] == pytest.approx(pull[one] + pull[other], abs=1e-9)


@by([("conifer", "whorl"), ("saguaro", "arms")])
def test_branches_of_a_whorl_are_as_many_as_its_slider_says(case):
    name, slider = case
    orders = [system(name, **{slider: many}).derive().figure().order for many in (3, 5)]
    axes = [np.count_nonzero(order == 1) for order in orders]
    assert axes[0] * 5 == pytest.approx(axes[1] * 3)


@by(
    [
        ("pine_cone", "scales", "S"),
        ("pineapple", "fruitlets", "S"),
        ("succulent", "leaves", "L"),
        ("daisy", "florets", "D"),
        ("sunflower", None, "D"),
    ]
)
def test_organs_in_a_spiral_stand_137_5_degrees_apart(case):
    name, slider, organ = case
    found = system(name)
    word = found.derive()
    many = int(constant(found, slider)) if slider else found.generations
    assert word.count(organ) == many


def test_seeds_of_a_dandelion_are_spread_evenly():
    """The sum of all directions vanishes, and each seed has about its share of the ball to itself."""
    figure = system("dandelion").derive().figure()
    seeds = figure.axes[np.isclose(figure.width, 0.003), 0]
    assert len(seeds) == 110 and np.linalg.norm(seeds.sum(axis=0)) < 0.02 * len(seeds)
    nearest = np.arccos(np.clip(seeds @ seeds.T - 3 * np.eye(len(seeds)), -1, 1).max(axis=0))
    share = 2 * np.arccos(1 - 2 / len(seeds))  # across a cap of that part of the ball
    assert nearest.min() > 0.6 * share


def test_all_edges_of_a_snow_crystal_lie_at_multiples_of_60_degrees():
    figure = system("snow_crystal").derive().figure()
    turns = np.degrees(np.arctan2(figure.axes[:, 0, 1], figure.axes[:, 0, 0])) / 60
    assert turns == pytest.approx(np.round(turns), abs=1e-6)
    assert np.linalg.norm(np.sum(figure.end, axis=0)) < 1e-9 * len(figure)


def test_a_stroke_of_lightning_ends_where_its_height_says():
    """Corners move aside and branches die away, but the stroke itself leads to the ground."""
    figure = system("lightning", size=5).derive(seed=3).figure(upright=True)
    main = figure.axis == 0
    assert figure.end[main][-1] == pytest.approx([0, 0, -5], abs=1e-9)


SLIDERS = [(name, slider) for name in PRESETS for slider in system(name).constants if slider.low is not None]


@pytest.mark.thorough
@pytest.mark.parametrize(("name", "slider"), SLIDERS, ids=[f"{name}-{slider.name}" for name, slider in SLIDERS])
def test_a_slider_can_be_pulled_from_end_to_end(name, slider):
    """What it does is told, its value lies between, and nowhere is nothing drawn or more than a million points.

    Sliders are pulled to the one or the other end by turns; in full runs to both, and to a place between.
    """
    assert slider.low <= slider.value <= slider.high and slider.low < slider.high and slider.doc
    ends, turn = (slider.low, slider.high), SLIDERS.index((name, slider)) % 2
    for value in (*ends, slider.low / 3 + slider.high / 1.5) if FULL else ends[turn : turn + 1]:
        mesh = replace(plant(name), constants={slider.name: value}).mesh()
        assert 0 < len(mesh.vertices) < 1_000_000 and np.isfinite(mesh.vertices).all()
        assert not len(mesh.non_manifold_edges())


@pytest.mark.thorough
@pytest.mark.parametrize("name", PRESETS)
def test_a_preset_names_its_source_and_is_quick_to_draw(name):
    """Its text begins with the source, for whoever edits it; constants without a range follow from others."""
    shape = plant(name)
    assert re.match(r"# Source: [^\n]{8,}\.\n", shape.system)
    assert all(slider.low is not None for slider in system(name).constants if not slider.formula.names)
    mesh = shape.mesh()
    assert 0 < len(mesh.vertices) <= MOST_VERTICES and not len(mesh.non_manifold_edges())
    sizes = np.ptp(mesh.vertices, axis=0)
    assert 0.2 < sizes.max() < 20
    assert len(mesh.boundary_edges()) == len(growing.shown(shape).filled.points)


@pytest.mark.thorough
@pytest.mark.skipif(not PAGE.exists(), reason="the installed zip has no docs")
def test_the_page_has_the_table_of_the_presets():
    """Its text is what ``python -m sweep_addon.presets.grammars`` prints."""
    table = PAGE.read_text().partition("<!-- presets -->\n")[2].partition("<!-- end of presets -->")[0]
    assert table.strip() == grammars.markdown()
    assert str(len(PRESETS)) in (PAGE.parents[1] / "README.md").read_text()
