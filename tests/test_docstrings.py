# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""`help` answers for every public name: what it is, in which units, what it refuses, and by an example.

That the examples hold is asked in `test_doctests`.
"""

import doctest
import importlib.util
import inspect
from types import UnionType
from typing import get_args

import pytest

import sweep_addon as sw
from sweep_addon.core.declared.description import summary
from sweep_addon.core.declared.parameters import parameters

IN_BLENDER = set() if importlib.util.find_spec("bpy") else {"to_object", "from_object"}
MEASURED = ("volume", "area", "boundary_edges", "non_manifold_edges", "euler_characteristic")
HELD = ("corners", "offsets", "edges", "uv", "attributes")
ASKED = ("evaluate", "length", "domain", "closed")
WORDS = {"length": "in metres", "angle": "in radians"}


def kinds(space):
    """The kinds that a union in a module is made of."""
    return [kind for union in vars(space).values() if isinstance(union, UnionType) for kind in get_args(union)]


def public():
    """Every public class and function by its name in ``sw``."""
    for name in sw.__all__:
        value = None if name in IN_BLENDER else getattr(sw, name)
        if inspect.ismodule(value):
            readers = [reader for reader in getattr(value, "__all__", ()) if reader.startswith("from_")]
            yield from ((f"{name}.{kind.__name__}", kind) for kind in kinds(value))
            yield from ((f"{name}.{reader}", getattr(value, reader)) for reader in readers)
        elif value is not None:
            yield name, value


def members():
    """Every public method and property of those; what is a plain value has no docstring of its own."""
    yield "GeneralizedCylinder.mesh", sw.GeneralizedCylinder.mesh
    yield from ((f"PDCurveSweep.{name}", getattr(sw.PDCurveSweep, name)) for name in ("mesh", "bend"))
    solids = (sw.GeneralizedCylinder, sw.PDCurveSweep, sw.RotationalSweep, sw.TranslationalSweep)
    yield from ((f"{shape.__name__}.solid", shape.solid) for shape in solids)
    yield "PDCurve.evaluate", sw.PDCurve.evaluate
    yield from ((f"Mesh.{name}", getattr(sw.Mesh, name)) for name in MEASURED + HELD)
    for kind in kinds(sw.trajectories):
        found = ((name, getattr(kind, name)) for name in ASKED)
        yield from (
            (f"trajectories.{kind.__name__}.{name}", member)
            for name, member in found
            if inspect.isroutine(member) or inspect.isdatadescriptor(member)
        )


PUBLIC, MEMBERS = dict(public()), dict(members())
MADE = ("Mesh", "LSystem")  # whose fields are no parameters
DECLARED = {
    name: value for name, value in PUBLIC.items() if hasattr(value, "__dataclass_fields__") and name not in MADE
}
NAMED = PUBLIC | MEMBERS
FUNCTIONS = [name for name, value in PUBLIC.items() if inspect.isroutine(value)]
IN_METRES = {*FUNCTIONS, *MEMBERS} - {"load", "to_object", "from_object"}
IN_METRES -= {
    name for name in MEMBERS if name.endswith(("corners", "offsets", "edges", "characteristic", "domain", "closed"))
}
REFUSING = [
    "GeneralizedCylinder.mesh",
    "PDCurveSweep.mesh",
    "PDCurveSweep.bend",
    *FUNCTIONS,
    *(name for name, kind in DECLARED.items() if parameters(kind)),
]


def test_the_walk_meets_the_public_names():
    assert {"contours.Circle", "contours.from_svg", "trajectories.from_gpx", "laws.Points", "load"} <= PUBLIC.keys()
    assert {"Mesh.uv", "trajectories.Arc.closed", "trajectories.Polyline.evaluate"} <= MEMBERS.keys()


@pytest.mark.parametrize("name", NAMED)
def test_each_has_a_docstring_with_an_example(name):
    doc = inspect.getdoc(NAMED[name])
    assert doc and ">>> " in doc


@pytest.mark.parametrize("name", ["Mesh.uv", "Mesh.attributes"])
def test_examples_of_cached_properties_hold(name):
    """`doctest` passes these over before Python 3.13."""
    example = doctest.DocTestParser().get_doctest(inspect.getdoc(NAMED[name]), {}, name, None, None)
    assert example.examples and doctest.DocTestRunner().run(example).failed == 0


@pytest.mark.parametrize("name", DECLARED)
def test_each_field_is_told_with_its_unit_and_limits(name):
    lines = inspect.getdoc(DECLARED[name]).splitlines()
    for p in parameters(DECLARED[name]):
        (told,) = [line for line in lines if line.startswith(f"{p.name} : ")]
        assert (WORDS[p.unit] if p.unit else "default") in told
        assert (f"at most {p.maximum:g}" in told) == (p.maximum < float("inf"))
        assert f"    {p.doc}." in lines


def test_a_radius_is_told_in_metres_and_a_turn_in_radians():
    assert "radius : float, in metres, more than 0, default 1.0\n" in inspect.getdoc(sw.contours.Circle)
    assert "radius_to : 'corners' or 'sides', default 'corners'\n" in inspect.getdoc(sw.contours.RegularPolygon)
    assert "points : (n, 3) float array, in metres" in inspect.getdoc(sw.trajectories.Polyline)
    assert "start : sequence of 3 floats, in metres, default (0, 0, 0)\n" in inspect.getdoc(sw.trajectories.Line)
    assert "twist : Constant, Formula or Points, in radians, default 0.0\n" in inspect.getdoc(sw.GeneralizedCylinder)


@pytest.mark.parametrize("name", sorted(IN_METRES))
def test_what_takes_or_gives_lengths_says_metres(name):
    assert "metres" in inspect.getdoc(NAMED[name]).lower()


@pytest.mark.parametrize("name", REFUSING)
def test_what_refuses_says_what(name):
    assert "\nRaises\n------\nShapeError\n    " in inspect.getdoc(NAMED[name])


@pytest.mark.parametrize("name", [name for name, kind in DECLARED.items() if hasattr(kind, "check")])
def test_a_check_says_what_it_refuses(name):
    """It continues the section of what raises."""
    said, told = (" ".join((inspect.getdoc(part) or "").split()) for part in (DECLARED[name].check, DECLARED[name]))
    assert said.startswith("Refuse ") and said.removeprefix("Refuse ") in told


def test_the_summary_stays_the_first_line():
    assert summary(sw.contours.Circle) == "A circle about its reference point"
    assert summary(sw.GeneralizedCylinder) == (
        "A contour that moves along a trajectory, scaled, turned and moved aside on the way"
    )
