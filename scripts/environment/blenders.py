# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which Blender: $BLENDER, a supported one on PATH, the Debian root in the cache, the bpy wheel, in this order.

``SWEEP_BLENDER=path|root|wheel`` asks for one of these and no other.
"""

import os
import re
import shutil
import subprocess
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from . import CHECKOUT, SetupError, debian, venvs
from .steps import show

OLDEST = (4, 5)
LAUNCHER = CHECKOUT / "scripts" / "blender"


@dataclass(frozen=True)
class Blender:
    """A Blender: its program, and the words in front of any command that is to run in its system."""

    title: str
    program: tuple
    system: tuple = ()
    real: bool = True

    @property
    def command(self):
        return (*self.system, *self.program)


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


def some():
    """A Blender, made if need be: what is asked for, else the wheel, or where there is none for it, Debian's."""
    if not find() and os.environ.get("SWEEP_BLENDER") == "root":
        debian.make()
    elif not find():
        try:
            venvs.made(venvs.BLENDER)
        except SetupError as error:
            show(str(error))
            debian.make()
    return find() or refuse()


def others(blender):
    """How to get another Blender than one, for somebody who did not choose it."""
    other = (
        "SWEEP_BLENDER=wheel for the bpy wheel"
        if blender.real
        else "SWEEP_BLENDER=root for a real one, set up if need be"
    )
    return f"{other}, BLENDER=PROGRAM for one of yours"


def real():
    """A real Blender, Debian's made if need be."""
    found = find()
    if not found or not found.real:
        debian.make()
        found = find()
    return found if found and found.real else refuse()


def denoising():
    """The wheel, made if need be, unless another is asked for: Debian's Blender cannot denoise what it renders."""
    if not (os.environ.get("SWEEP_BLENDER") or os.environ.get("BLENDER")):
        with suppress(SetupError):
            venvs.made(venvs.BLENDER)
            return wheel()
    return some()


def refuse():
    raise SetupError(f"There is no such Blender as SWEEP_BLENDER={os.environ['SWEEP_BLENDER']} asks for.")


def variable():
    program = os.environ.get("BLENDER")
    if not program:
        return None
    if not shutil.which(program):
        raise SetupError(f"BLENDER must be the path of a Blender executable, got {program!r}")
    if version(program) < OLDEST:
        oldest = ".".join(map(str, OLDEST))
        raise SetupError(f"BLENDER must be a Blender of version {oldest} or newer, got {program!r}, which is none")
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
    system = debian.enter() if debian.there() else None
    return Blender("Debian's, in the cache", ("blender",), system) if system else None


def wheel():
    if not venvs.BLENDER.ready:
        return None
    launcher = str(Path(__file__).with_name("wheel.py"))
    return Blender("the bpy wheel", (str(venvs.BLENDER.python), launcher), real=False)
