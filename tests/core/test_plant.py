# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A plant is what its grammar draws, with numbers of its own where some are given; it is told of before it is made."""

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.declared.forms import python_source
from sweep_addon.core.declared.options import Texture
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes import growing

TREE = """#define r 0.7     # 0.5 .. 0.9 how much shorter a branch is
#define half r/2
#angle 30
#generations 3
axiom: F(1)
F(l) : l > 0.2 -> F(l) [+ F(l*r)] [- F(l*half)]
"""


def test_the_mesh_is_that_of_the_figure_of_the_word():
    for sides in (0, 5):
        output = {"kind": "tubes", "sides": sides} if sides else "edges"
        figure = sw.LSystem.parse(TREE).derive(3).figure()
        mesh = sw.Plant(TREE, output=output, texture="none").mesh()
        alone = figure.mesh(sides, Texture.NONE)
        assert np.array_equal(mesh.vertices, alone.vertices) and np.array_equal(mesh.edges, alone.edges)


def test_numbers_that_are_not_given_are_those_of_the_text():
    plant = sw.Plant(TREE)
    assert (plant.generations, plant.angle, plant.step, plant.width, plant.seed) == (3, 30, 1, 0.1, 0)
    assert plant == sw.Plant(TREE, generations=3, angle=30) == sw.Plant(TREE, constants={"r": 0.7})
    system = sw.LSystem.parse(TREE)
    assert sw.Plant(system).system == str(system) and sw.Plant(system).mesh().area() == plant.mesh().area()


def test_numbers_that_are_given_stand_for_those_of_the_text():
    text = TREE.replace("0.7 ", "0.6 ").replace("#angle 30", "#angle 40\\n#step 2\\n#width 0.3").replace("\\n", chr(10))
    given = sw.Plant(TREE, constants={"r": 0.6}, angle=40, step=2, width=0.3)
    assert np.array_equal(given.mesh().vertices, sw.Plant(text).mesh().vertices)


@pytest.mark.parametrize("change", [{"angle": 31}, {"step": 2}, {"width": 0.2}, {"upright": True}, {"generations": 2}])
def test_what_is_kept_from_one_mesh_to_the_next_changes_none(change):
    """Each is made with all that the one before has left, and again where nothing was left."""
    plant = replace(sw.Plant("axiom: A\nA -> F[+A]F(2)A&"), generations=3)
    plant.mesh()
    found = replace(plant, **change).mesh()
    growing.word.cache_clear()
    growing.figure.cache_clear()
    alone = replace(plant, **change).mesh()
    assert np.array_equal(found.vertices, alone.vertices) and len(found.vertices)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"system": "axiom: F["}, r"system: line 1, column 9: expected '\]' after it"),
        ({"system": 7}, "system: must be the text of a grammar, got 7"),
        ({"constants": {"q": 1}}, "constants.q: is no constant of the text, which has r, half"),
        ({"constants": {"r": "x"}}, "constants.r: must be a number, got 'x'"),
        ({"constants": {"r": 10**400}}, "constants.r: must be a number, got 1000"),
        ({"constants": {"r": float("inf")}}, "constants.r: must be a number, got inf"),
        ({"constants": [1]}, r"constants: must be a table of numbers, got \[1\]"),
        ({"generations": -1}, "generations: must be at least 0, got -1"),
        ({"upright": "down"}, "upright: must be one of automatic, upwards, along-x, got 'down'"),
        ({"output": "leaves"}, "output: must be one of tubes, edges, curves, got 'leaves'"),
    ],
)
def test_what_is_wrong_is_refused_by_its_name(given, said):
    with pytest.raises(ShapeError, match=f"^{said}"):
        sw.Plant(**{"system": TREE, **given})


def test_a_word_beyond_the_budget_is_refused_with_its_size():
    doubling = sw.Plant("axiom: F\nF -> FF", generations=40)
    with pytest.raises(
        ShapeError, match="^generations: must make at most 2,000,000 modules, but 40 make 1,099,511,627,776$"
    ):
        doubling.mesh()
    assert not doubling.make_solid and growing.size(doubling).startswith("1,099,511,627,776 modules; next step 2,1")


def test_how_many_modules_a_word_of_chance_has_is_said_once_it_is_derived():
    plant = sw.Plant("axiom: F\nF -(0.5)-> F[+F]F\nF -(0.5)-> F", generations=6, seed=20261130)
    assert growing.size(plant) == f"1 to {3**6 + 3 * (3**6 - 1) // 2:,} modules"
    plant.mesh()
    assert growing.size(plant) == f"{len(growing.read(plant.system).derive(6, 20261130))} modules"


@pytest.mark.parametrize(
    ("generations", "output", "said"),
    [
        (19, {"kind": "tubes", "sides": 256}, f"output.sides: must .*, but needs about {(2**19 + 1) * 256 * 120:,}"),
        (22, "edges", f"budget: must .*, but needs about {2 * 2**22 * 120:,}"),
    ],
)
def test_a_mesh_beyond_the_budget_is_refused_before_it_takes_memory(generations, output, said):
    """A straight row is one axis, so that a tube has a ring more than segments; edges have two ends each."""
    plant = sw.Plant("axiom: F\nF -> FF", generations=generations, output=output, budget=5_000_000)
    tracemalloc.start()
    try:
        with pytest.raises(ShapeError, match=said):
            plant.mesh()
        assert tracemalloc.get_traced_memory()[1] < 2**29
    finally:
        tracemalloc.stop()


def test_what_takes_long_is_known_before_and_told_of_on_the_way():
    text = "axiom: F\nF : 1 < 2 -> FF"  # a condition: nothing is foretold
    plant = sw.Plant(text, generations=19, output="edges")
    assert plant.make_solid and plant.surface() is None and not replace(plant, generations=8).make_solid
    parts = []
    assert len(plant.solid(parts.append).edges) == 2**19
    assert parts == sorted(parts) and parts[-1] == 1 and len(parts) > 19

    def stop(part):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        plant.solid(stop)


SLOW = "axiom: FFFF\nF < F > F : ran(1)<0.5 -> G\nG < F -> F\nF > G -> G\nG -> +F\n"  # its sizes are not foretold


@pytest.mark.parametrize("budget", [1000, 2_000_000])
def test_a_word_that_a_busy_machine_derives_slowly_takes_long_and_is_not_refused(monkeypatch, budget):
    """Whatever its budget; and only until the machine has time again."""
    plant = sw.Plant(SLOW, generations=50, budget=budget)
    growing.word.cache_clear()
    monkeypatch.setattr(growing, "MOMENT", -1.0)
    assert plant.make_solid
    at_length = plant.mesh(), plant.solid()
    monkeypatch.undo()
    assert not plant.make_solid and len(plant.mesh().vertices)
    assert all(np.array_equal(mesh.vertices, plant.mesh().vertices) for mesh in at_length)


def test_words_of_plants_are_derived_once_until_something_changes(monkeypatch):
    derived = []
    derive = sw.LSystem.derive
    monkeypatch.setattr(sw.LSystem, "derive", lambda *told: derived.append(told) or derive(*told))
    growing.word.cache_clear()
    for change in ({}, {"angle": 10}, {"width": 0.2}, {"seed": 1}):
        plant = replace(sw.Plant(SLOW, generations=50), **change)
        assert not plant.make_solid and plant.mesh().euler_characteristic() == plant.mesh().euler_characteristic()
    assert len(derived) == 2


def test_a_refusal_that_is_kept_is_raised_anew_and_keeps_no_frames():
    raised = []
    for _ in range(2):
        with pytest.raises(ShapeError) as refusal:
            growing.read("axiom: F[")
        raised.append(refusal.value)
    kept = growing.tried("axiom: F[", growing.NONE)
    assert kept not in raised and raised[0] is not raised[1] and str(raised[0]) == str(raised[1]) == str(kept)
    assert kept.__traceback__ is kept.__context__ is None


def test_forms_hold_text_and_constants():
    plant = sw.Plant(TREE, constants={"half": 0.1}, upright=False)
    assert sw.load(sw.dump(plant)) == plant and f"system = '''\n{TREE}'''" in sw.dump(plant)
    source = python_source(plant)
    assert 'constants={"half": 0.1}' in source and eval(source, {"sw": sw}) == plant
    quoted = sw.Plant("axiom: F'''F\\(3)F")  # colours, which end a text of lines in TOML, and a roll
    assert sw.load(sw.dump(quoted)) == quoted and eval(python_source(quoted), {"sw": sw}) == quoted


def test_a_production_that_is_a_function_has_no_text():
    grown = sw.LSystem.parse("axiom: A(1)").with_production("A(x)", lambda x: [("F", x)])
    with pytest.raises(ShapeError, match="has no text where a successor is a Python function"):
        sw.Plant(grown)


HONDA = """
n=6
#define r1 0.9
#define r2 0.6
ω : A(1,10)
p1 : A(l,w) : * → !(w)F(l)[&(45)B(l*r2,w*0.707)]/(137.5)A(l*r1,w*0.707)
p2 : B(l,w) : * → !(w)F(l)[−(45)$C(l*r2,w*0.707)]C(l*r1,w*0.707)
p3 : C(l,w) : * → !(w)F(l)[+(45)$B(l*r2,w*0.707)]B(l*r1,w*0.707)
"""
AS_PRINTED = "n=5,δ=22.5°\nX\nX→F−[[X]+X]+F[+FX]−X\nF→FF"  # the book's figure 1.24 e


def test_the_words_that_tell_of_thick_tubes_make_them_thin():
    """The trunk is 10 thick in the book's units; a hundredth of that is 0.1 m."""
    printed = sw.Plant(HONDA).mesh()
    assert any("!(w) -> !(w/100)" in sentence for sentence in printed.told)
    thin = sw.Plant(f"{HONDA}homomorphism:\nmaximum depth: 1\n!(w) -> !(w/100)\n").mesh()
    assert not thin.told
    low = thin.vertices[np.isclose(thin.vertices[:, 2], 0)]
    assert np.hypot(low[:, 0], low[:, 1]).max() == pytest.approx(0.05)


@pytest.mark.parametrize(
    ("plant", "lies"),
    [
        (sw.Plant(AS_PRINTED), True),
        (sw.Plant(AS_PRINTED, upright="along-x"), False),
        (sw.Plant(AS_PRINTED, upright="upwards"), False),
        (sw.Plant(f"#heading z\n{AS_PRINTED}"), False),
        (sw.Plant(HONDA), False),
        (sw.Plant("axiom: F-F-F-F"), False),
    ],
)
def test_a_plant_that_lies_on_the_ground_says_how_it_stands(plant, lies):
    assert (growing.LYING in plant.mesh().told) == lies
