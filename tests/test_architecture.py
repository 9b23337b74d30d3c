# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Imports point one way: panels -> operators -> batch -> properties -> bridge -> core, and batch -> presets -> core."""

import ast
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
# What each part may import of the others. The library's front, sweep_addon/__init__.py, offers all that is below it.
BELOW = {
    "sweep_addon/core": set(),
    "sweep_addon/presets": {"sweep_addon/core"},
    "sweep_addon/bridge": {"sweep_addon/core"},
    "sweep_addon/properties": {"sweep_addon/core", "sweep_addon/bridge"},
    "sweep_addon/batch": {"sweep_addon/core", "sweep_addon/bridge", "sweep_addon/properties", "sweep_addon/presets"},
}
BELOW["operators"] = set(BELOW)
BELOW["panels"] = set(BELOW)


def test_each_test_file_has_a_name_of_its_own():
    """Where two have one, the second is not run: they are modules, and no packages."""
    names = [path.name for path in (CHECKOUT / "tests").rglob("test_*.py")]
    assert len(names) > 100 and len(names) == len(set(names))


@pytest.mark.parametrize("front", sorted(CHECKOUT.glob("sweep_addon/core/**/__init__.py")), ids=lambda f: f.parent.name)
def test_no_front_takes_the_name_of_a_module_for_something_of_it(front):
    """Whoever imports the module by its name would put it in the place of what the front offers."""
    taken = {
        alias.asname or alias.name
        for node in ast.walk(ast.parse(front.read_text(encoding="utf-8")))
        if isinstance(node, ast.ImportFrom) and node.module
        for alias in node.names
    }
    assert taken.isdisjoint(path.stem for path in front.parent.glob("*.py"))


def part(path):
    """The part of the house that a name belongs to, or None for the root and the library's front."""
    return next((name for name in BELOW if path == name or path.startswith(name + "/")), None)


def imported(source, file):
    """The names that a source imports, as paths from the root of this project, with their lines."""
    folder = file.parent.relative_to(CHECKOUT)
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name.replace(".", "/")
        if isinstance(node, ast.ImportFrom):
            above = [folder, *folder.parents][node.level - 1].as_posix() if node.level else "."
            module = f"{above}/{(node.module or '').replace('.', '/')}".strip("/").removeprefix("./")
            for alias in node.names:
                yield node.lineno, f"{module}/{alias.name}".removeprefix("./")
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "later":
            if isinstance(node.args[0], ast.Constant):
                yield node.lineno, "sweep_addon/" + node.args[0].value.replace(".", "/")


def upward(file):
    home = part(file.relative_to(CHECKOUT).as_posix())
    for line, path in imported(file.read_text(encoding="utf-8"), file):
        target = part(path)
        front = not target and path.startswith("sweep_addon") and home.startswith("sweep_addon")
        if front or target and target not in BELOW[home] | {home}:
            yield f"{file.relative_to(CHECKOUT)}:{line} imports {path}"


FOLDERS = [name for name in BELOW if (CHECKOUT / name).is_dir()]


def test_every_part_of_the_library_has_its_place():
    parts = {file.parent.relative_to(CHECKOUT).as_posix() for file in CHECKOUT.glob("sweep_addon/*/__init__.py")}
    assert parts == {name for name in BELOW if name.startswith("sweep_addon/")}


@pytest.mark.thorough
@pytest.mark.parametrize("folder", FOLDERS)
def test_nothing_imports_upwards(folder):
    found = [problem for file in CHECKOUT.glob(f"{folder}/**/*.py") for problem in upward(file)]
    assert not found, "\n".join(found)


@pytest.mark.parametrize(
    ("line", "path"),
    [
        ("from ..bridge import meshes", "sweep_addon/bridge/meshes"),
        ("from .. import batch", "sweep_addon/batch"),
        ("from ...operators.add import Add", "operators/add/Add"),
        ("from ... import sweep_addon", "sweep_addon"),
        ("import sweep_addon.properties", "sweep_addon/properties"),
        ('joined = later("core.meshes.joining", "joined")', "sweep_addon/core/meshes/joining"),
        ("from .frames import Frenet", "sweep_addon/core/frames/Frenet"),
    ],
)
def test_the_reader_sees_where_an_import_points(line, path):
    assert list(imported(line, CHECKOUT / "sweep_addon" / "core" / "mesh.py")) == [(1, path)]
