# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The virtual environments: each made once, and again when what it should hold changes."""

import hashlib
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from . import BUILD, CHECKOUT, SetupError, apt
from .interpreters import any_python, python_with_wheel
from .steps import locked, step

# What the bpy wheel loads and a machine without a desktop lacks.
SYSTEM_LIBRARIES = ["libxrender1", "libxfixes3", "libxi6", "libxkbcommon0", "libsm6", "libgl1"]


@dataclass(frozen=True)
class Environment:
    """A virtual environment: where it is, which Python makes it, what pip installs."""

    title: str
    folder: Path
    interpreter: Callable
    install: tuple

    @property
    def python(self):
        return self.folder / "bin" / "python"

    @property
    def stamp(self):
        """What the environment should hold, as a hash: the project's table and version, not its tools' settings."""
        project = (CHECKOUT / "pyproject.toml").read_text().partition("[tool.pytest")[0]
        version = re.search(r"^version.*", (CHECKOUT / "blender_manifest.toml").read_text(), re.MULTILINE)[0]
        return hashlib.sha256(repr((project, version, self.install, str(CHECKOUT))).encode()).hexdigest()

    @property
    def ready(self):
        stamp = self.folder / "stamp"
        return stamp.exists() and stamp.read_text() == self.stamp


BLENDER = Environment("Python with the bpy wheel", CHECKOUT / ".venv", python_with_wheel, ("-e", ".[blender,test]"))
PLAIN = Environment("plain Python", BUILD / "venv" / "plain", any_python, ("-e", ".[test]"))
OLDEST = ("numpy~=1.26.4; python_version < '3.13'", "numpy")  # the bpy wheel's; newer Pythons need a newer one
NUMPY = Environment("NumPy alone", BUILD / "venv" / "numpy", any_python, (*OLDEST, "pytest", "hypothesis"))


def made(environment):
    """The environment's Python, after making the environment if need be."""
    if not environment.ready:
        with locked(BUILD / "venv" / f"{environment.folder.name}.lock"):
            if not environment.ready:
                make(environment)
    return environment.python


def make(environment):
    if not runs(environment.python):
        shutil.rmtree(environment.folder, ignore_errors=True)
        step(
            f"{environment.title}: virtual environment",
            [environment.interpreter(), "-I", "-m", "venv", environment.folder],
        )
    pip = [environment.python, "-I", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    step(
        f"{environment.title}: install {' '.join(environment.install)}",
        [*pip, *environment.install],
        "If the package index cannot be reached, try again with a network.",
        cwd=CHECKOUT,
    )
    if environment is BLENDER:
        prove_bpy(environment.python)
    (environment.folder / "stamp").write_text(environment.stamp)


def runs(python):
    """Whether an environment made earlier still has its Python and its pip."""
    return (
        python.exists() and not subprocess.run([python, "-I", "-m", "pip", "--version"], capture_output=True).returncode
    )


def prove_bpy(python):
    """Import bpy once: pip installs no wheel in silence, and a bare machine lacks libraries that the wheel loads."""
    trial = import_bpy(python)
    if "cannot open shared object file" in trial.stderr:
        apt.install(SYSTEM_LIBRARIES, "The bpy wheel needs libraries of the system.")
        trial = import_bpy(python)
    if trial.returncode:
        reason = (trial.stderr.strip().splitlines() or ["no reason given"])[-1]
        raise SetupError(f"The bpy wheel cannot be imported: {reason}")


def import_bpy(python):
    return subprocess.run(
        [python, "-I", "-c", "import bpy, os; os._exit(0)"], capture_output=True, text=True, timeout=120, cwd=BUILD
    )
