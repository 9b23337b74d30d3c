# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What Blender registers is read from a file, which is made anew when what it was made from changes."""

import marshal
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from sweep_addon.bridge.table import table
from sweep_addon.properties import kept

REGISTERED = """
import sys, bpy
before = set(sys.modules)
import sweep_addon.properties as properties
properties.register()
imported = {name for name in set(sys.modules) - before if name.startswith(("sweep_addon", "numpy"))}
group = bpy.types.Mesh.bl_rna.properties["sweep"].fixed_type.properties["generalized_cylinder"].fixed_type
print("told:", len(imported), "sweep_addon.core.shapes.kinds" in imported, "numpy" in imported)
print("told:", group.properties["contour_circle_radius"].description)
properties.unregister()
"""


@pytest.fixture
def file(tmp_path, monkeypatch):
    """Where the table is kept, in a folder that is not there yet."""
    monkeypatch.setattr(kept, "FILE", tmp_path / "new" / "kept.table")
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    return kept.FILE


def test_the_table_is_read_as_it_was_made(file):
    assert kept.read() is None
    made = kept.table()
    assert made == table() == kept.read()
    assert [path.name for path in file.parent.iterdir()] == [file.name]


def test_what_it_was_made_from_are_the_declarations(file):
    kept.table()
    sources = marshal.loads(file.read_bytes())["sources"]
    expected = {"bridge/table.py", "core/shapes/kinds.py", "core/contours/ovals.py", "core/variation/laws.py"}
    assert expected <= {Path(source).as_posix() for source in sources}


@pytest.mark.parametrize("change", [{"size": 1}, {"time": 1}, {"name": "core/gone.py"}], ids=str)
def test_one_of_other_sources_is_not_read(file, change):
    kept.table()
    held = marshal.loads(file.read_bytes())
    source = next(name for name in held["sources"] if name.endswith("laws.py"))
    time, size = held["sources"].pop(source)
    held["sources"][change.get("name", source)] = [time + change.get("time", 0), size + change.get("size", 0)]
    file.write_bytes(marshal.dumps(held))
    assert kept.read() is None
    assert kept.table() == table() == kept.read()


WHOLE = marshal.dumps({"sources": {}, "table": {}})
SPOILT = (
    b"",
    WHOLE[:-1],
    b"\0",
    b"[\1\0\0\0" * 100_000,
    *map(marshal.dumps, ([], {}, 1, {"sources": {}}, {"sources": [1]})),
)


@pytest.mark.parametrize("held", SPOILT, ids=range(len(SPOILT)))
def test_one_that_was_spoilt_is_made_anew(file, held):
    file.parent.mkdir()
    file.write_bytes(held)
    assert kept.read() is None
    assert kept.table() == table() == kept.read()


def test_a_place_that_cannot_be_written_is_left(file):
    file.parent.write_text("a file where the folder would be", encoding="utf-8")
    assert kept.table() == table()
    assert kept.read() is None


def test_nothing_is_written_where_python_is_to_write_nothing(file, monkeypatch):
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    assert kept.table() == table()
    assert not file.parent.exists()


def registered(folder, before=""):
    """What a Blender just started tells of registering a library: what it imported for it, and what that says.

    It may do something else before.
    """
    variables = {name: value for name, value in os.environ.items() if name != "PYTHONDONTWRITEBYTECODE"}
    if bpy.app.binary_path:
        command = [bpy.app.binary_path, "--background", "--factory-startup", "--python-exit-code", "1", "--python-expr"]
        command.append(f"import sys; sys.path.insert(0, {str(folder)!r})\n{before}{REGISTERED}")
    else:
        command = [sys.executable, "-c", before + REGISTERED]
    done = subprocess.run(command, cwd=folder, env=variables, capture_output=True, text=True, timeout=120)
    told = [line.removeprefix("told: ") for line in done.stdout.splitlines() if line.startswith("told: ")]
    assert len(told) == 2, done.stderr
    return told


def copied(folder):
    """The library in a folder, as it is before anybody imports it."""
    ignore = shutil.ignore_patterns("__pycache__")
    shutil.copytree(Path(kept.__file__).parents[1], folder / "sweep_addon", ignore=ignore)


def test_a_table_of_shapes_that_changed_since_they_were_imported_is_not_kept(tmp_path):
    copied(tmp_path)
    source = tmp_path / "sweep_addon/core/contours/ovals.py"
    text = source.read_text(encoding="utf-8").replace("Distance of the points", "How far the points are")
    pulled = f"open({str(source)!r}, 'w', encoding='utf-8').write({text!r})"
    old = registered(tmp_path, f"import sweep_addon\nsweep_addon.TranslationalSweep\n{pulled}\n")[1]
    assert old.startswith("Distance of the points")
    assert registered(tmp_path)[1].startswith("How far the points are")


def test_starting_again_imports_no_shapes_until_one_of_them_changes(tmp_path):
    copied(tmp_path)
    first, words = registered(tmp_path)
    assert "True" in first
    count, *others = registered(tmp_path)[0].split()
    assert int(count) < 15 and others == ["False", "False"]
    source = tmp_path / "sweep_addon/core/contours/ovals.py"
    text = source.read_text(encoding="utf-8")
    assert words in text
    source.write_text(text.replace(words, "How far round it is from the middle"), encoding="utf-8")
    assert registered(tmp_path)[1] == "How far round it is from the middle"
