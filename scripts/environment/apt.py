# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Packages of a Debian or Ubuntu machine: installed where this runs as root, or unpacked into a folder."""

import os
import shutil
import subprocess

from . import SetupError
from .steps import show, step


def install(names, need):
    """Install packages, or refuse with the line that does it; `need` says what wants them."""
    line = ["apt-get", "install", "--yes", "--no-install-recommends", *names]
    way_out = f"{need} On Debian and Ubuntu: sudo {' '.join(line)}"
    if os.geteuid() or not shutil.which("apt-get"):
        raise SetupError(way_out)
    show(need)
    step("apt-get update", ["apt-get", "update"], way_out)
    step(" ".join(line), line, way_out, env={**os.environ, "DEBIAN_FRONTEND": "noninteractive"})


def unpack(names, folder, way_out):
    """Download packages and unpack them into a folder; nothing is installed, and no right is needed."""
    if not shutil.which("apt-get"):
        raise SetupError(f"This needs {' and '.join(names)}, and there is no apt-get here. {way_out}")
    own = []
    if subprocess.run(["apt-cache", "show", *names], capture_output=True).returncode:  # as in a fresh container
        (folder / "lists" / "partial").mkdir(parents=True)
        own = ["-o", f"Dir::State::Lists={folder / 'lists'}", "-o", f"Dir::Cache={folder}"]
        step("apt-get update, into a folder of its own", ["apt-get", *own, "update"], way_out)
    step(f"fetch {' and '.join(names)}", ["apt-get", *own, "download", *names], way_out, cwd=folder)
    for package in folder.glob("*.deb"):
        subprocess.run(["dpkg", "-x", package, folder], check=True)
