# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The zip, as a user meets it: what is in it, installing it, its command, and taking it off again."""

import itertools
import os
import re
import subprocess
import tomllib
import zipfile
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]
NAME = "bl_ext.user_default.sweep_addon"
ZIP = os.environ.get("SWEEP_ZIP", "")
pytestmark = pytest.mark.skipif(not ZIP, reason="needs the zip, which scripts/test builds and names in SWEEP_ZIP")


def blender(*arguments):
    """Blender in background with the user folder of this run: its exit code and all it printed."""
    command = [CHECKOUT / "scripts" / "blender", "--background", *arguments]
    return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)


@pytest.fixture(scope="module")
def names():
    with zipfile.ZipFile(ZIP) as packed:
        return packed.namelist()


@pytest.fixture(scope="module")
def installed():
    answer = blender("--command", "extension", "install-file", "--repo", "user_default", "--enable", ZIP)
    assert answer.returncode == 0, answer.stdout[-2000:]
    return answer


def test_zip_holds_what_ships_and_nothing_else(names):
    tops = {name.partition("/")[0] for name in names}
    assert {"blender_manifest.toml", "__init__.py", "LICENSE", "sweep_addon", "wheels"} <= tops
    assert tops <= {"blender_manifest.toml", "__init__.py", "LICENSE", "sweep_addon", "wheels", "operators", "panels"}
    assert not [name for name in names if name.endswith((".pyc", ".zip", ".part")) or "__pycache__" in name]


def test_every_source_file_of_the_library_ships(names):
    ships = {path.relative_to(CHECKOUT).as_posix() for path in CHECKOUT.glob("sweep_addon/**/*.py")}
    assert ships <= set(names)


def test_bundled_wheels_run_on_every_platform_and_are_declared(names):
    bundled = {f"./{name}" for name in names if name.endswith(".whl")}
    with zipfile.ZipFile(ZIP) as packed:
        manifest = tomllib.loads(packed.read("blender_manifest.toml").decode())
    assert bundled == set(manifest["wheels"])
    pure = {name for name in bundled if name.endswith("-none-any.whl")}
    assert {name.rpartition("/")[2].partition("-")[0] for name in pure} == {"svgelements", "fonttools"}
    compiled = [name.removesuffix(".whl").split("-") for name in bundled - pure]
    systems = "manylinux.*x86_64", "win_amd64", "macosx.*x86_64", "macosx.*arm64"
    needed = {"./wheels/manifold3d": (*systems, "win_arm64"), "./wheels/python_fcl": systems}
    pythons = "cp311", "cp313", "cp314"
    assert {name for name, *_ in compiled} == set(needed)
    assert len(compiled) == sum(map(len, needed.values())) * len(pythons)
    for library, platforms in needed.items():
        for python, system in itertools.product(pythons, platforms):
            found = [machine for name, _, tag, _, machine in compiled if (name, tag) == (library, python)]
            assert any(re.fullmatch(system, machine) for machine in found)


def test_zip_installs_and_enables(installed):
    assert "Traceback" not in installed.stdout


def test_command_is_there_once_installed(installed):
    answer = blender("--command", "sweep", "--help")
    assert answer.returncode == 0, answer.stdout
    assert "sweep" in answer.stdout


def test_bundled_libraries_are_imported_from_the_extension(installed):
    answer = blender(
        "--python-exit-code", "1", "--python-expr", "import svgelements, fontTools, manifold3d, fcl; print(fcl)"
    )
    assert answer.returncode == 0, answer.stdout
    assert os.environ["SWEEP_BLENDER_USER"] in answer.stdout


def test_disabling_leaves_nothing_behind(installed):
    script = Path(__file__).with_name("leave_nothing.py")
    answer = blender("--factory-startup", "--python-exit-code", "1", "--python", script)
    assert answer.returncode == 0 and "Traceback" not in answer.stdout, answer.stdout


def test_blender_finds_no_policy_violation(installed):
    expression = f"import addon_utils; print(addon_utils._extensions_warnings_get().get({NAME!r}, 'none'))"
    answer = blender("--python-exit-code", "1", "--python-expr", expression)
    assert answer.returncode == 0 and "Policy" not in answer.stdout, answer.stdout
