# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packages for the Python inside a Blender: the wheels that the extension bundles, and what its tests need."""

import hashlib
import os
import platform
import shutil
import sys
import zipfile
from itertools import product
from pathlib import Path

from . import BUILD
from .steps import locked, step
from .venvs import PLAIN, made

PINNED = Path(__file__).with_name("wheels.txt")
LACKED = Path(__file__).with_name("wheels_not_for_windows_arm.txt")
WHEELS, INSIDE = BUILD / "wheels", BUILD / "inside"
PYTHONS = ("3.11", "3.13", "3.14")  # of Blender 4.5 and 5.0, of 5.1 and newer, and of Debian's
PLATFORMS = ("manylinux_2_28_x86_64", "win_amd64", "win_arm64", "macosx_11_0_arm64", "macosx_11_0_x86_64")
SYSTEMS = {"linux": "linux", "darwin": "macosx", "win32": "win"}  # as wheels name them
PURE = ("--only-binary=:all:", "--platform=any", "--implementation=py", "--abi=none", "--python-version=3.11")
TESTS = ("pytest", "hypothesis")


def wheels():
    """The pinned wheels for all platforms and Pythons of Blender, downloaded once."""
    stamp = WHEELS / "pinned.txt"
    wanted = PINNED.read_text() + LACKED.read_text() + repr((PYTHONS, PLATFORMS))
    with locked(BUILD / "venv" / "wheels.lock"):
        if not stamp.exists() or stamp.read_text() != wanted:
            shutil.rmtree(WHEELS, ignore_errors=True)
            for python, machine in product(PYTHONS, PLATFORMS):
                download(python, machine)
            stamp.write_text(wanted)
    return sorted(WHEELS.glob("*.whl"))


def download(python, machine):
    pip = [made(PLAIN), "-I", "-m", "pip", "download", "--quiet", "--disable-pip-version-check"]
    options = ["--no-deps", "--only-binary=:all:", f"--python-version={python}", f"--platform={machine}"]
    pinned = [PINNED, *([] if machine == "win_arm64" else [LACKED])]
    step(
        f"wheels to bundle: Python {python}, {machine}",
        [*pip, *options, *(f"--requirement={path}" for path in pinned), "--find-links", WHEELS, "--dest", WHEELS],
    )


def runs_here(wheel):
    """Whether a wheel is for this machine, whichever its Python."""
    tag = wheel.stem.rpartition("-")[2]
    return tag == "any" or (SYSTEMS[sys.platform] in tag and tag.lower().endswith(platform.machine().lower()))


def inside(*parts):
    """Folders of packages for the Python inside a real Blender, as its PYTHONPATH: ``libraries`` and ``tests``."""
    for part in parts:
        with locked(BUILD / "venv" / "inside.lock"):
            {"libraries": unpack, "tests": install}[part](INSIDE / part)
    return os.pathsep.join(str(INSIDE / part) for part in parts)


def unpack(folder):
    """Lay out the bundled wheels as Blender does; the Pythons find each their own among the compiled modules."""
    found = [wheel for wheel in wheels() if runs_here(wheel)]
    if renewed(folder, [wheel.name for wheel in found]):
        for wheel in found:
            with zipfile.ZipFile(wheel) as packed:
                packed.extractall(folder)
        finish(folder, [wheel.name for wheel in found])


def install(folder):
    if renewed(folder, TESTS):
        pip = [made(PLAIN), "-I", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *PURE]
        step("for Blender's Python: tests", [*pip, "--target", folder, *TESTS])
        finish(folder, TESTS)


def renewed(folder, contents):
    """Whether a folder does not hold these contents; it is empty then."""
    stamp = folder / "stamp"
    if stamp.exists() and stamp.read_text() == stamped(contents):
        return False
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return True


def finish(folder, contents):
    (folder / "stamp").write_text(stamped(contents))


def stamped(contents):
    return hashlib.sha256(repr((contents, PURE)).encode()).hexdigest()
