# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the turtle draws by arrays is what one draws that walks from module to module, and what the book shows."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sequential_turtle import left_beside, walk
from test_grammar_conformance import ENTRIES, by_id, text

from sweep_addon.core.formulas.expressions import Expression
from sweep_addon.core.grammars import LSystem
from sweep_addon.core.grammars.text.modules import Module

DRAWN = [entry for entry in ENTRIES if "geometry" in entry]
ALONG_X = {"H": np.array([1.0, 0, 0]), "L": np.array([0, 1.0, 0]), "U": np.array([0, 0, 1.0])}
UPWARDS = {"H": np.array([0, 0, 1.0]), "L": np.array([-1.0, 0, 0]), "U": np.array([0, -1.0, 0])}
FLAT, SPATIAL, LEVELLING = "FFFffG+-|!'[]", "FFFfG+-&^\\/|!'[]", [*"FFFfG+-&^\\/|$!'[]", "@v"]
BESIDE = [*"FFFfG+-[]{{}}..", "~K", "~L"]


@by_id(DRAWN)
def test_figures_of_the_book(entry):
    figure, told = LSystem.parse(text(entry)).derive().figure(), entry["geometry"]
    assert len(figure.start) == told["segments"]
    if "bbox" in told:
        bounds, wanted, size = figure.bounds, told["bbox"], 3
    else:
        bounds, wanted, size = figure.bounds[:, :2], np.reshape(told["bbox_of_F_endpoints"], (2, 2)), 2
    assert bounds == pytest.approx(np.array(wanted), abs=1e-3)
    assert figure.at[:size] == pytest.approx(told["end"], abs=1e-3)
    corners = np.unique(np.concatenate((figure.start, figure.end)).round(6), axis=0)
    if told.get("self_avoiding"):
        assert len(corners) == told.get("distinct_points") or told["lattice_points"] == told["segments"] + 1


def random_word(draw, letters, count, told=0.5):
    """A word of so many modules with brackets in pairs, as (name, parameters); how often these are told."""
    modules, depth = [], 0
    for letter in draw.choice(list(letters), count):
        if letter == "]" and not depth:
            continue
        depth += (letter == "[") - (letter == "]")
        parameters = ()
        if letter in "+-&^\\/" and draw.random() < told:
            parameters = (round(draw.uniform(-180, 180), 2),)
        elif letter in "FfG" and draw.random() < told:
            parameters = (round(draw.uniform(0.1, 2), 2),)
        elif letter in "!'" and draw.random() < told:
            parameters = (round(draw.uniform(0.1, 2), 2),)
        modules.append((str(letter), parameters))
    return modules + [("]", ())] * depth


def compared(modules, upright, tropism=None, angle=25.0):
    """The figure of a word, and the segments of the reference beside it."""
    word = [Module(name, tuple(Expression(repr(p), (), (p,)) for p in parameters)) for name, parameters in modules]
    system = LSystem(tuple(word) or (Module("X"),), angle=angle, tropism=tropism)  # what a text of it is read as
    segments, at = walk(modules, UPWARDS if upright else ALONG_X, angle, tropism=tropism)
    figure = system.derive(0).figure(upright=upright)
    assert np.array_equal(figure.place, [segment["place"] for segment in segments])
    return figure, segments, at


def errors(figure, segments):
    """How far ends and axes are from those of the reference, of its size."""
    if not segments:
        return np.zeros(0)
    size = 1 + max(np.abs(segment["end"]).max() for segment in segments)
    ends = [(segment["start"], segment["end"]) for segment in segments]
    axes = [list(segment["axes"].values()) for segment in segments]
    wrong = np.abs(np.stack((figure.start, figure.end), axis=1) - ends).max(axis=(1, 2)) / size
    return np.maximum(wrong, np.abs(figure.axes - axes).max(axis=(1, 2)))


def agree(found, wanted):
    """Whether numbers are those of the reference but for rounding; `pytest.approx` takes longer than both to find."""
    wanted = np.array(wanted)
    return found.shape == wanted.shape and (np.abs(found - wanted) <= 1e-12 * np.abs(wanted)).all()


@pytest.mark.parametrize("roll", ["", "/(0)"])
def test_an_upright_plant_is_seen_from_in_front_as_the_book_draws_it(roll):
    """Its page: x to the right, z up, and the turtle's up towards the reader, whose front view looks along y."""
    figure = LSystem.parse(f"axiom: {roll}F(2)[+(90)F(1)][-(90)F(3)]").derive(0).figure(upright=True)
    assert figure.end == pytest.approx(np.array([(0, 0, 2), (-1, 0, 2), (3, 0, 2)]), abs=1e-12)
    assert figure.axes[0] == pytest.approx(np.array([(0, 0, 1), (-1, 0, 0), (0, -1, 0)]), abs=1e-12)


@pytest.mark.parametrize("letters", [FLAT, SPATIAL])
@pytest.mark.parametrize("upright", [False, True])
def test_random_words_are_drawn_as_by_the_reference(letters, upright, draws):
    draw = np.random.default_rng(20261129)
    for _ in range(draws):
        modules = random_word(draw, letters, draw.integers(0, 120))
        figure, segments, at = compared(modules, upright)
        assert errors(figure, segments).max(initial=0) < 1e-12
        assert np.abs(figure.at - at).max() < 1e-12 * (1 + np.abs(at).max())
        assert agree(figure.width, [segment["width"] for segment in segments])
        assert agree(figure.colour, [segment["colour"] for segment in segments])


@pytest.mark.parametrize(
    "tropism",
    [None, (0.0, 0.0, -1.0, 0.22), (1.0, -2.0, 0.5, -0.3), (-3.0, 0.0, 0.0, 0.4), (-1.0, 0.2, 0.1, 0.3)],
)
def test_levelled_and_bent_words_are_drawn_as_by_the_reference(tropism, draws):
    """Each $ divides errors by the sine of the heading's angle to the vertical: that is the tolerance."""
    draw = np.random.default_rng(8)
    for _ in range(draws // 2):
        modules = random_word(draw, LEVELLING, draw.integers(0, 120))
        figure, segments, _ = compared(modules, True, tropism)
        loss = np.array([segment["loss"] for segment in segments])
        assert (errors(figure, segments) < 1e-12 / loss).all()


@pytest.mark.parametrize("letters", [BESIDE, [*BESIDE, *"&^/\\"]])
def test_polygons_and_organs_are_those_of_the_reference(letters, draws):
    draw = np.random.default_rng(12)
    for _ in range(draws // 2):
        modules = []
        for name, parameters in random_word(draw, letters, draw.integers(0, 60)):
            scaled = (2.5,) if draw.random() < 0.5 else ()
            modules += [("~", ()), (name[1], scaled)] if name[0] == "~" else [(name, parameters)]
        figure, segments, _ = compared(modules, True)
        told = left_beside(modules, lambda word: walk(word, UPWARDS, 25.0))
        assert errors(figure, segments).max(initial=0) < 1e-12
        assert [len(polygon) for polygon in figure.polygons] == [len(polygon) for polygon in told[0]]
        for found, wanted in zip(figure.polygons, told[0], strict=True):
            assert np.abs(found - wanted).max() < 1e-11
        found = [(o.name, *each) for o in figure.organs for each in zip(o.place, o.at, o.scale, strict=True)]
        found = sorted(found, key=lambda each: each[1])
        assert [(name, scale) for name, _, _, scale in found] == [(name, scale) for name, _, scale in told[1]]
        assert all(np.abs(a[2] - b[1]).max() < 1e-11 for a, b in zip(found, told[1], strict=True))


@pytest.mark.parametrize("letters", ["F+-[[]]", "F+-|[[]]", "F+-&/[[]]", "F+&/$[[]]"])
@pytest.mark.parametrize("upright", [False, True])
def test_branches_in_which_nothing_moves_change_nothing(letters, upright, draws):
    draw, left_out = np.random.default_rng(15), 0
    for _ in range(draws // 2):
        modules = random_word(draw, letters, draw.integers(0, 120))
        figure, segments, _ = compared(modules, upright)
        loss = np.array([segment["loss"] for segment in segments])
        assert (errors(figure, segments) < 1e-12 / loss).all()
        assert agree(figure.width, [segment["width"] for segment in segments])
        left_out += figure.walk.branched and len(figure.walk.limbs.stayed) > 1
    assert left_out > draws // 4


@pytest.mark.thorough
def test_long_paths_are_drawn_as_by_the_reference():
    draw = np.random.default_rng(4)
    for letters in ("FF+-&^/\\", "F+-&/[]"):
        modules = random_word(draw, letters, 20_000)
        figure, segments, _ = compared(modules, False)
        assert errors(figure, segments).max() < 1e-12


@pytest.mark.parametrize("longest", [1, 2, 5, 6, 40])
@pytest.mark.parametrize("letters", ["F[]", "FfF[]$"])
def test_runs_of_turns_by_one_angle_are_turned_as_by_the_reference(letters, longest, draws):
    """By that of the system where a module tells none, else by that of all modules of its name."""
    draw = np.random.default_rng(longest)
    for _ in range(draws // 4):
        told = {name: (round(draw.uniform(-180, 180), 2),) for name in draw.choice([*"+-&^\\/"], 3)}
        modules = []
        for module in random_word(draw, letters, draw.integers(0, 40), told=0):
            turns = map(str, draw.choice([*"+-&^\\/|"], draw.integers(0, longest + 1)))
            modules += [(turn, told.get(turn, ()) if draw.random() < 0.5 else ()) for turn in turns] + [module]
        figure, segments, _ = compared(modules, True, angle=float(draw.choice([90.0, 22.5, 137.5])))
        loss = np.array([segment["loss"] for segment in segments])
        assert (errors(figure, segments) < 1e-12 / loss).all()


def test_many_different_runs_of_turns_are_turned_as_by_the_reference():
    draw = np.random.default_rng(9)
    runs = draw.choice([*"+-&^\\/|"], (3000, 5))
    modules = [(str(name), ()) for name in np.concatenate((np.full((len(runs), 1), "F"), runs), axis=1).ravel()]
    figure, segments, _ = compared(modules, False, angle=22.5)
    assert errors(figure, segments).max() < 1e-12


def test_a_level_turtle_has_its_left_in_the_horizontal_plane():
    figure = LSystem.parse("axiom: [&(30)/(50)F$F&(20)/(70)F$F]F").derive(0).figure()
    assert figure.axes[[1, 3], 1, 2] == pytest.approx(0, abs=1e-15)
    assert (figure.axes[[1, 3], 2, 2] > 0).all()


def test_an_axiom_of_the_hilbert_cube_visits_every_place_once():
    entry = next(entry for entry in ENTRIES if entry["id"] == "abop-1.19")
    figure = LSystem.parse(text(entry)).derive(3).figure()
    points = np.concatenate((figure.start, figure.end)).round(9)
    assert len(np.unique(points, axis=0)) == 8**3


def test_segments_know_what_they_grow_out_of():
    figure = LSystem.parse("axiom: FF[+F[F]fF]F[-f F]").derive(0).figure()
    assert figure.parent.tolist() == [-1, 0, 1, 2, 2, 1, 5]
    assert figure.joined.tolist() == [False, True, False, False, False, True, False]
    assert figure.axis.tolist() == [0, 0, 1, 4, 2, 0, 3]
    assert figure.order.tolist() == [0, 0, 1, 2, 1, 0, 1]


def test_births_are_the_steps_that_made_segments():
    told = "axiom: F\nF -> F[+G]F"
    wanted = [1, 1, 1]
    assert LSystem.parse(told).derive(1).figure().birth.tolist() == wanted
    grown = LSystem.parse(told).derive(2).figure().birth.tolist()
    assert grown == [2, 2, 2, 1, 2, 2, 2]  # G stays as the first step made it
    ordered = LSystem.parse(told.replace("F\n", "F(1)\n", 1).replace("F ->", "F(x) ->").replace("]F", "]F(x)"))
    assert ordered.derive(1).figure().birth.tolist() == wanted


def test_a_polygon_has_its_vertices():
    figure = LSystem.parse("#angle 90\naxiom: {f+f+f+f}").derive(0).figure()
    (square,) = figure.polygons
    assert square[:, :2] == pytest.approx(np.array([[1, 0], [1, 1], [0, 1], [0, 0]]), abs=1e-12)


def test_a_polygon_that_closes_but_for_rounding_has_no_vertex_twice():
    """Seven edges that turn by a seventh of a circle end where they begin, or a rounding beside it."""
    for turn in ("+", "&", "^"):
        told = f"#angle 360/7\naxiom: F(0.3){turn}F(0.7){{{f'f{turn}' * 7}}}"
        (heptagon,) = LSystem.parse(told).derive(0).figure().polygons
        assert len(heptagon) == 7


def test_a_leaf_of_the_book_is_made_of_triangles():
    """ABOP figure 5.5: each polygon has three dots; the edges of the two youngest on each side have no length yet."""
    entry = next(entry for entry in ENTRIES if entry["id"] == "abop-5.5-cordate")
    figure = LSystem.parse(text(entry)).derive(20).figure()
    assert len(figure.polygons) == 2 * (20 - 2)
    assert {len(polygon) for polygon in figure.polygons} == {3}


@given(st.lists(st.sampled_from([*"{}{}..fFG+-", "[f]", "[+F.]"]), max_size=40))
def test_polygons_are_those_of_a_stack_of_braces(letters):
    """Each vertex is of the innermost brace that is open; braces that nothing opens or closes make no polygon."""
    figure = LSystem.parse(f"#angle 90\naxiom: F{''.join(letters)}").derive(0).figure()
    unfinished, wanted, at, way = [], [], 1 + 0j, 1 + 0j
    for letter in "".join(letters):
        way *= {"+": 1j, "-": -1j}.get(letter, 1)
        if letter == "[":
            home = at, way
        elif letter == "]":
            at, way = home
        at += way * (letter in "fFG")
        if letter == "{":
            unfinished.append([])
        if letter == "}" and unfinished:
            wanted.append(unfinished.pop())
        elif unfinished and letter in "{.fF":
            unfinished[-1].append(at)
    wanted = [[p for k, p in enumerate(points) if abs(p - points[k - 1]) > 1e-9] for points in wanted]
    wanted = [points for points in wanted if len(points) > 2]
    assert len(figure.polygons) == len(wanted)
    for polygon, points in zip(figure.polygons, wanted, strict=True):
        assert polygon[:, :2] == pytest.approx(np.array([(p.real, p.imag) for p in points]), abs=1e-9)


def test_organs_stand_where_the_turtle_is():
    figure = LSystem.parse("axiom: F[+~L(2)]F~K").derive(0).figure()
    assert [(organ.name, organ.scale.tolist(), organ.at.tolist()) for organ in figure.organs] == [
        ("L", [2], [[1, 0, 0]]),
        ("K", [1], [[2, 0, 0]]),
    ]


def test_a_long_row_of_rotations_is_turned_as_by_the_reference():
    draw = np.random.default_rng(6)
    modules = [("F", ()), *random_word(draw, "+-&^/\\", 300), ("F", ()), *random_word(draw, "+&/", 33), ("F", ())]
    figure, segments, _ = compared(modules, False)
    assert errors(figure, segments).max() < 1e-12
