# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Pythons of this machine, found by running them: a name on PATH may be a shim that only fails."""

import glob
import os
import subprocess
import sys

from . import BUILD, SetupError
from .steps import step

OLDEST = (3, 11)
WITH_WHEEL = ((3, 11), (3, 13))  # Pythons for which bpy is published: 4.5 LTS, the oldest supported, and 5.2 LTS
PROBE = """
import sys, ensurepip, venv
print(getattr(sys, "_base_executable", sys.executable), *sys.version_info[:2], sep="\\n")
"""


def any_python():
    """The newest Python for the library alone, this one if it will do."""
    found = [p for p in candidates() if p[1] >= OLDEST]
    if not found:
        return from_uv()
    return next((path for path, version in found if version == sys.version_info[:2]), max(found, key=lambda p: p[1])[0])


def python_with_wheel():
    """A Python for which there is a bpy wheel."""
    found = list(candidates())
    for wanted in WITH_WHEEL:
        for path, version in found:
            if version == wanted:
                return path
    return from_uv()


def candidates():
    """(path, version) of the Pythons here that run and can make virtual environments."""
    names = ["python3", *(f"python3.{minor}" for minor in (11, 13, 12, 14))]
    folders = os.environ.get("PATH", os.defpath).split(os.pathsep)
    paths = [sys.executable, *(os.path.join(folder, name) for name in names for folder in folders)]
    pyenv = os.environ.get("PYENV_ROOT") or os.path.expanduser("~/.pyenv")
    paths += sorted(glob.glob(os.path.join(glob.escape(pyenv), "versions", "*", "bin", "python3")), reverse=True)
    seen = set()
    for path in paths:
        if os.path.exists(path) and os.path.realpath(path) not in seen:
            seen.add(os.path.realpath(path))
            found = ask(path)
            if found:
                yield found


def ask(path):
    try:
        answer = subprocess.run([path, "-I", "-c", PROBE], capture_output=True, text=True, timeout=20)
    except (OSError, subprocess.TimeoutExpired):
        return None
    if answer.returncode:
        return None
    executable, major, minor = answer.stdout.splitlines()
    return executable, (int(major), int(minor))


def from_uv():
    """Python 3.11 fetched by uv, itself installed by pip into a small virtual environment."""
    way_out = "Install Python 3.11 or 3.13 with its venv module (python3.11-venv), or uv, and run this again."
    uv = BUILD / "venv" / "uv" / "bin" / "uv"
    if not uv.exists():
        maker = next(candidates(), None)
        if not maker:
            raise SetupError(
                "No Python here can make a virtual environment. On Debian and Ubuntu: sudo apt-get install python3-venv"
            )
        step("uv: virtual environment", [maker[0], "-I", "-m", "venv", uv.parents[1]], way_out)
        step("uv: install", [uv.with_name("python"), "-I", "-m", "pip", "install", "--quiet", "uv"], way_out)
    find = [uv, "python", "find", "--no-project", "--managed-python", "3.11"]
    found = subprocess.run(find, capture_output=True, text=True)
    if found.returncode:
        step("Python 3.11, fetched by uv", [uv, "python", "install", "3.11"], way_out)
        found = subprocess.run(find, capture_output=True, text=True, check=True)
    return found.stdout.strip()
