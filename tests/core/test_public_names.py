# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The namespaces of the library offer their kinds, and nothing of what these are made with."""

import ast
import subprocess
import sys
from importlib.util import find_spec
from operator import attrgetter
from pathlib import Path
from typing import get_args

import pytest

import sweep_addon as sw
from sweep_addon.core.csg import NODES
from sweep_addon.core.declared.forms import public_name
from sweep_addon.core.declared.parameters import parameters
from sweep_addon.core.shapes.kinds import SHAPES

UNIONS = {
    "contours": "Contour",
    "corners": "Corner",
    "directions": "Direction",
    "ends": "End",
    "frames": "Frame",
    "laws": "Law",
    "limits": "Limit",
    "sampling": "Sampling",
    "trajectories": "Trajectory",
}


@pytest.mark.parametrize("name", UNIONS)
def test_a_namespace_offers_its_kinds_and_nothing_else(name):
    space = getattr(sw, name)
    assert sorted(dir(space)) == sorted(space.__all__)
    assert all(hasattr(space, public) for public in space.__all__)
    assert {kind.__name__ for kind in get_args(getattr(space, UNIONS[name]))} <= set(dir(space))
    assert not {"np", "Enum", "require", "parameter", "declared"} & set(dir(space))


@pytest.mark.parametrize("shape", [sw.GeneralizedCylinder, sw.PDCurveSweep])
def test_every_choice_of_a_shape_is_in_a_namespace(shape):
    offered = {id(getattr(getattr(sw, name), union)) for name, union in UNIONS.items()}
    assert all(id(p.type) in offered for p in parameters(shape) if p.kinds)


def test_every_kind_that_a_copy_as_python_may_name_is_public():
    """But for what has no parameters, which is written as its name, and items of lists, which are written as tuples."""
    todo, items, seen = [*SHAPES, *NODES], set(), set()
    while todo:
        kind = todo.pop()
        if kind not in seen:
            seen.add(kind)
            items |= {p.item for p in parameters(kind) if p.item}
            todo += [each for p in parameters(kind) for each in (*p.kinds, *filter(None, [p.item]))]
    named = [kind for kind in seen - items if parameters(kind)]
    assert len(named) > 50
    assert [kind for kind in named if attrgetter(public_name(kind).removeprefix("sw."))(sw) is not kind] == []


def test_the_library_offers_its_public_names_alone():
    assert sorted(dir(sw)) == sorted(sw.__all__)
    assert sw.presets.shape("spring") == sw.load(sw.presets.FOLDER / "spring.toml")


def test_editors_are_told_where_every_public_name_is():
    front = ast.parse(Path(sw.__file__).read_text(encoding="utf-8"))
    (told,) = (node for node in front.body if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING")
    places = {alias.name: node.module for node in told.body for alias in node.names}
    assert set(places) == {*sw.__all__, "from_object", "to_object"}
    assert {name: module for name, module in places.items() if name not in sw.SPACES} == {
        name: module.removeprefix(".") for name, module in sw.NAMES.items()
    }


@pytest.mark.skipif(bool(find_spec("bpy")), reason="is about Python without Blender")
def test_all_public_names_can_be_imported_without_blender():
    """By an interpreter of its own, where no other test has imported anything."""
    script = "from sweep_addon import *; print(load.__name__, presets.__name__, 'to_object' in globals())"
    found = subprocess.run(
        [sys.executable, "-c", script], cwd=Path(sw.__file__).parents[1], capture_output=True, text=True
    )
    assert (found.stderr, found.stdout) == ("", "load sweep_addon.presets False\n")


@pytest.mark.skipif(not find_spec("bpy"), reason="needs Blender, and this host has none")
def test_what_needs_blender_is_public_where_it_is():
    assert {"from_object", "to_object"} <= set(sw.__all__)
    assert all(hasattr(sw, name) for name in sw.__all__)


@pytest.mark.parametrize(
    ("name", "where"),
    [("Circle", "contours.Circle"), ("Round", "corners.Round or ends.Round"), ("from_csv", "trajectories.from_csv")],
)
def test_a_name_that_is_elsewhere_is_told_where(name, where):
    with pytest.raises(AttributeError, match=f"^module '.*' has no attribute '{name}': it is {where}$"):
        getattr(sw, name)
    with pytest.raises(AttributeError, match="^module '.*' has no attribute 'Sphere'$"):
        sw.Sphere  # noqa: B018
