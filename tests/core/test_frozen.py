# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Frozen classes are to the standard library what its own `dataclass` makes of the same."""

import copy
import pprint
import sys
from dataclasses import Field, FrozenInstanceError, dataclass, fields, is_dataclass, replace

import pytest

from sweep_addon.core.contours import Circle
from sweep_addon.core.declared import frozen as module
from sweep_addon.core.declared.frozen import frozen, individual
from sweep_addon.core.declared.parameters import declared, length, parameters
from sweep_addon.core.shapes.kinds import SHAPES


def made(decorator):
    """Two classes, one the base of the other, each made what a decorator makes of it."""

    @decorator
    class Place:
        """A place"""

        x: float
        y: float = 1.0
        name = "no field"

    @decorator
    class Member(Place):
        """A place in a group"""

        y: float = 2.0
        group: tuple[int, ...] = ()

    return Place, Member


def said(cls):
    """What the fields of a class say, whatever a version of Python has them say."""
    return [{word: getattr(each, word) for word in Field.__slots__} for each in fields(cls)]


@pytest.mark.parametrize("decorator", [frozen, individual])
@pytest.mark.parametrize("place", [0, 1])
def test_fields_are_those_that_dataclass_makes(decorator, place):
    ours, theirs = made(decorator)[place], made(dataclass(init=False, eq=False, repr=False))[place]
    assert said(ours) == said(theirs)
    assert ours.__match_args__ == theirs.__match_args__
    assert repr(ours.__dataclass_params__) == repr(theirs.__dataclass_params__)
    assert (ours.y, getattr(ours, "x", None)) == (theirs.y, getattr(theirs, "x", None))
    assert set(vars(theirs)) - set(vars(ours)) <= {"__annotations_cache__"}  # since Python 3.14 kept where asked for


@pytest.mark.parametrize("shape", SHAPES)
def test_a_declared_shape_is_a_dataclass(shape):
    assert is_dataclass(shape)
    found = {each.name: each for each in fields(shape)}
    assert list(found) == [p.name for p in parameters(shape)]
    assert all(found[p.name].type == p.type and found[p.name].metadata["doc"] == p.doc for p in parameters(shape))


def test_fields_carry_what_their_declaration_says():
    radius, points = fields(Circle)
    assert dict(radius.metadata) == {"doc": "Distance of the points from the centre", "unit": "length", "above": 0.0}
    assert (radius.default, points.default, points.metadata["minimum"]) == (Circle.radius, Circle.points, 3)


def test_the_standard_library_copies_replaces_and_prints_them():
    first = made(frozen)[1](1.0, 3.0, (1,))
    assert replace(first, y=4.0) == type(first)(1.0, 4.0, (1,))
    assert copy.copy(first) == copy.deepcopy(first) == first
    assert pprint.pformat(first) == repr(first) == f"{type(first).__qualname__}(x=1.0, y=3.0, group=(1,))"
    if sys.version_info >= (3, 13):
        assert copy.replace(first, x=2.0) == type(first)(2.0, 3.0, (1,))
    with pytest.raises(FrozenInstanceError):
        first.x = 2.0


def test_without_the_private_mark_dataclass_makes_them(monkeypatch):
    ours = said(made(frozen)[1])
    monkeypatch.setattr(module, "MARK", None)
    assert said(made(frozen)[1]) == ours

    @declared
    class Place:
        """A place"""

        x: float = length(1.0, "How far")

    assert fields(Place)[0].metadata == {"doc": "How far", "unit": "length", "above": 0.0}
    assert Place(2).x == 2.0


def test_a_declared_class_has_the_parameters_of_its_base_too():
    @declared
    class Place:
        """A place"""

        x: float = length(1.0, "How far")

    @declared
    class Height(Place):
        """A place above the ground"""

        y: float = length(2.0, "How high")

    assert [p.name for p in parameters(Height)] == [each.name for each in fields(Height)] == ["x", "y"]
    assert (Height(3, 4).x, Height(3, 4).y, Height(y=5).x) == (3.0, 4.0, 1.0)
