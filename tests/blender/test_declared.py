# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's properties say what the shape's declaration says, and hold any shape it allows."""

from dataclasses import is_dataclass
from enum import Enum

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import tried

import sweep_addon as sw
from sweep_addon import presets
from sweep_addon.bridge import rna
from sweep_addon.core.declared.parameters import Array, ShapeError, inside, parameters, spelled
from sweep_addon.core.declared.texts import ASIDE
from sweep_addon.core.shapes.kinds import SHAPES


def properties(shape):
    """Each declared parameter of a shape, those of all kinds of its unions too, with the name of its property."""

    def flat(declared, prefix=""):
        for p in declared:
            if p.item:
                continue  # no property of an operator
            yield prefix + p.name, p
            for kind in p.kinds:
                yield from flat(inside(p, kind), f"{prefix}{p.name}_{spelled(kind, '_')}_")

    return dict(flat(parameters(shape)))


@pytest.fixture(params=SHAPES, ids=spelled)
def shape(request, scene):
    return request.param


def groups(shape):
    """What Blender knows of a shape's property group and of the operator that adds it."""
    group = getattr(bpy.data.meshes.new("any").sweep, spelled(shape, "_"))
    operator = getattr(bpy.ops.mesh, f"{spelled(shape, '_')}_add").get_rna_type()
    return group.bl_rna.properties, operator.properties


def test_every_parameter_has_a_property_with_its_words(shape):
    for known in groups(shape):
        for name, p in properties(shape).items():
            assert len(name) <= 63
            assert known[name].description == p.doc and p.doc
            assert known[name].name == p.name.replace("_", " ").title()


def test_numbers_have_unit_limits_and_default_of_the_declaration(shape):
    units = {None: "NONE", "length": "LENGTH", "angle": "ROTATION"}
    for known in groups(shape):
        for name, p in properties(shape).items():
            if p.type not in (int, float):
                continue
            found = known[name]
            assert found.type == {int: "INT", float: "FLOAT"}[p.type] and found.unit == units[p.unit]
            assert found.default == pytest.approx(p.shown if p.default is None else p.default)
            widest = 2**31 - 1 if p.type is int else float(np.finfo(np.float32).max)
            assert found.hard_min == pytest.approx(max(p.minimum, -widest)) and found.hard_max == pytest.approx(widest)
            assert found.soft_min > p.above
            highest = p.maximum if p.soft_maximum is None else p.soft_maximum
            assert highest >= widest or found.soft_max == pytest.approx(highest)


def test_lists_are_hidden_text_and_everything_else_can_be_keyed(shape):
    for known in groups(shape):
        for name, p in properties(shape).items():
            aside = p.type in ASIDE  # a text, and the values of its constants
            assert known[name].is_hidden == p.is_list or aside
            assert known[name].is_animatable or p.is_list or aside


def test_unions_are_enums_of_their_kinds_and_of_an_object_where_one_can_be_read(shape):
    group, operator = groups(shape)
    for name, p in properties(shape).items():
        choices = {spelled(kind, "_").upper() for kind in p.kinds}
        if choices:
            assert set(operator[name].enum_items.keys()) == choices
            assert set(group[name].enum_items.keys()) == choices | ({"OBJECT"} if p.accepts else set())


def test_numbers_of_enum_items_are_those_of_their_names(shape):
    """They are stored in files and keyframes, whose values are float32 and rounded by adding a half: 23 bits."""
    for known in groups(shape):
        for name in properties(shape):
            if known[name].type == "ENUM":
                numbers = [item.value for item in known[name].enum_items]
                assert len(set(numbers)) == len(numbers) and all(0 <= number < 2**23 for number in numbers)


COARSE = {"cells": 8, "tolerance": 0.1}  # of a mesh that is made anew for each choice and in each frame


def test_a_keyframe_of_any_choice_is_that_choice_again(scene, shape):
    ob = sw.to_object(shape(**{name: value for name, value in COARSE.items() if name in properties(shape)}))
    group = getattr(ob.data.sweep, spelled(shape, "_"))
    with rna.at_once(ob.data.sweep):  # each frame makes a mesh anyway
        for name, known in groups(shape)[0].items():
            if known.type == "ENUM":
                for number, item in enumerate(known.enum_items):
                    setattr(group, name, item.identifier)
                    group.keyframe_insert(name, frame=number)
    for frame in range(12):
        bpy.context.scene.frame_set(frame)
        for name, known in groups(shape)[0].items():
            if known.type == "ENUM" and frame < len(known.enum_items):
                assert getattr(group, name) == known.enum_items[frame].identifier


def test_numbers_of_enum_items_are_those_in_files_that_exist(scene):
    group, _ = groups(sw.GeneralizedCylinder)
    numbers = {item.identifier: item.value for item in group["contour"].enum_items}
    assert [numbers[key] for key in ("CIRCLE", "RECTANGLE", "OUTLINE", "OBJECT")] == [3630457, 1702553, 8344293, 0]


@pytest.mark.parametrize("preset", tried(preset.name for preset in presets.PRESETS))
def test_preset_is_the_same_text_after_it_was_an_object(scene, made_once, preset):
    text = sw.dump(presets.shape(preset))
    ob = sw.to_object(sw.load(text))
    assert ob.data.sweep.error == ""
    assert sw.dump(sw.from_object(ob)) == text


def test_shape_of_lengths_below_a_micrometre_is_what_it_is(scene):
    tiny = sw.GeneralizedCylinder(sw.contours.Circle(1e-7), samples=sw.sampling.Tolerance(1e-8))
    made = sw.from_object(sw.to_object(sw.GeneralizedCylinder(sw.contours.Circle(1e-7), sw.trajectories.Line())))
    assert made.contour.radius == 1e-7
    mesh = bpy.data.meshes.new("tiny")
    rna.write(mesh.sweep.generalized_cylinder, parameters(sw.GeneralizedCylinder), tiny)
    assert rna.read(mesh.sweep.generalized_cylinder, sw.GeneralizedCylinder) == tiny


def values(p):
    """Values of a parameter, of every kind and up to every limit."""
    if p.item:
        return st.lists(described(p.item), max_size=min(p.most, 3))
    if p.kinds:
        return st.one_of([described(kind, lambda kind=kind: inside(p, kind)) for kind in p.kinds])
    if isinstance(p.default, Enum):
        return st.sampled_from(type(p.default))
    if p.type is int:
        return st.integers(int(max(p.minimum, -1e6)), int(min(p.maximum, 1e6)))
    if p.type is float:
        return numbers(p)
    if p.type in (bool, str):
        return st.booleans() if p.type is bool else st.sampled_from(["1", "1 - t/2", "cos(pi*u) + 2", "s^2 + 1"])
    if isinstance(p.default, Array):
        return rows(p)
    if p.is_list:  # outlines
        return st.lists(rows(p), max_size=2) if p.columns else st.just(())
    return st.tuples(*[single(-10, 10) for _ in p.default])


def numbers(p):
    """Numbers that single precision tells from 0."""
    lowest, highest = max(p.minimum, p.above, -1e6), min(p.maximum, 1e6)
    return single(lowest, highest, exclude_min=p.above >= lowest)


def single(lowest, highest, **options):
    return st.floats(lowest, highest, **options).filter(lambda number: number == 0 or abs(number) > 1e-30)


def rows(p):
    number = st.floats(-100, 100, allow_subnormal=False)
    return st.lists(st.tuples(*[number] * p.columns) if p.columns else number, max_size=6)


@st.composite
def described(draw, cls, declared=None):
    """Shapes or kinds of any values that they take themselves."""
    drawn = {p.name: draw(values(p)) for p in (declared or (lambda: parameters(cls)))()}
    try:
        return cls(**drawn)
    except ShapeError:
        assume(False)


def in_single_precision(value):
    """A declared value as plain ones, numbers but those of lists rounded as Blender's properties are."""
    if isinstance(value, float):
        return float(np.float32(value))
    if isinstance(value, tuple) and value and all(map(is_dataclass, value)):
        return [in_single_precision(item) for item in value]
    if isinstance(value, tuple) and not any(isinstance(item, Array) for item in value):
        return [in_single_precision(item) for item in value]
    if not is_dataclass(value):
        return value
    return spelled(type(value)), {p.name: in_single_precision(getattr(value, p.name)) for p in parameters(type(value))}


@pytest.mark.parametrize("p", parameters(sw.GeneralizedCylinder), ids=lambda p: p.name)
def test_properties_hold_any_shape(p):
    mesh = bpy.data.meshes.new("any")
    group = mesh.sweep.generalized_cylinder

    @given(values(p))
    def holds(value):
        shape = sw.GeneralizedCylinder(**{p.name: value})
        rna.write(group, parameters(sw.GeneralizedCylinder), shape)
        once = rna.read(group, sw.GeneralizedCylinder)
        assert in_single_precision(once) == in_single_precision(shape)
        rna.write(group, parameters(sw.GeneralizedCylinder), once)
        assert rna.read(group, sw.GeneralizedCylinder) == once

    holds()


@given(st.decimals(-1000, 1000, places=4))
def test_a_number_that_a_person_types_is_that_number(number):
    """Float32 has seven digits: 0.7 must not read back as 0.69999999."""
    group = bpy.data.meshes.new("any").sweep.generalized_cylinder
    group.twist_constant_value = float(number)
    assert rna.read(group, sw.GeneralizedCylinder).twist.value == float(number)
