# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which Blender: $BLENDER, a supported one on PATH, the Debian root in the cache, the bpy wheel, in this order.

``SWEEP_BLENDER=path|root|wheel`` asks for one of these and no other.
"""

import os
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

from . import CHECKOUT, SetupError, debian, venvs

OLDEST = (4, 5)
LAUNCHER = CHECKOUT / "scripts" / "blender"


@dataclass(frozen=True)
class Blender:
    """A Blender: the command that starts it, and the words in front of any command that is to run in its system."""

    title: str
    command: tuple
    system: tuple = ()
    real: bool = True


def find():
    """The first Blender that is there, or None. Makes nothing."""
    kinds = {"variable": variable, "path": path, "root": root, "wheel": wheel}
    wanted = os.environ.get("SWEEP_BLENDER")
    if wanted and wanted not in kinds:
        raise SetupError(f"SWEEP_BLENDER must be one of {', '.join(kinds)}, got {wanted!r}")
    for kind in [kinds[wanted]] if wanted else kinds.values():
        found = kind()
        if found:
            return found
    return None


def variable():
    program = os.environ.get("BLENDER")
    if not program:
        return None
    if not shutil.which(program):
        raise SetupError(f"BLENDER must be the path of a Blender executable, got {program!r}")
    return Blender(f"$BLENDER, {program}", (program,))


def path():
    for folder in os.environ.get("PATH", os.defpath).split(os.pathsep):
        program = Path(folder, "blender")
        if os.access(program, os.X_OK) and program.resolve() != LAUNCHER and version(program) >= OLDEST:
            return Blender(str(program), (str(program),))
    return None


def version(program):
    try:
        answer = subprocess.run([program, "--version"], capture_output=True, text=True, timeout=60).stdout
    except (OSError, subprocess.TimeoutExpired):
        return ()
    found = re.match(r"Blender (\d+)\.(\d+)", answer)
    return tuple(map(int, found.groups())) if found else ()


def root():
    if not debian.there() or not debian.can_enter():
        return None
    system = debian.enter()
    return Blender("Debian's, in the cache", (*system, "blender"), system)


def wheel():
    if not venvs.BLENDER.ready:
        return None
    launcher = str(Path(__file__).with_name("wheel.py"))
    return Blender("the bpy wheel", (str(venvs.BLENDER.python), launcher), real=False)
