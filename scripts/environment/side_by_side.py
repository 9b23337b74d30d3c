# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hosts side by side: a scripts/test of its own runs each, and its lines are shown as they come, behind its name."""

import json
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict
from pathlib import Path

from . import BUILD, CHECKOUT, hosts
from .running import Counts

AT_ONCE = 3  # for two processors: one host or another waits for downloads or for its window. Each takes a gigabyte
LONGEST = "plain Python", "real Blender", "installed zip", "window", "bpy wheel", "NumPy alone"  # the last is shortest
SCRIPT = CHECKOUT / "scripts" / "test"


def run(chosen, arguments):
    """The results of hosts, in the order in which they are given: those that take longest begin.

    Parameters
    ----------
    chosen : iterable of str
        Names of hosts.
    arguments : list of str
        Handed to pytest on every host.
    """
    begun = sorted(chosen, key=lambda name: LONGEST.index(name) if name in LONGEST else -1)  # style takes a second
    with ThreadPoolExecutor(min(AT_ONCE, (os.cpu_count() or 1) + 1)) as pool:
        results = dict(pool.map(lambda name: (name, result(name, arguments)), begun))
    return [results[name] for name in chosen]


def result(name, arguments):
    """What came of a host that another scripts/test runs."""
    file = BUILD / "reports" / f"{name.replace(' ', '_')}.json"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    command = [sys.executable, SCRIPT, "--only", name, "--result", file, "--", *arguments]
    pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    process = subprocess.Popen(list(map(str, command)), text=True, errors="replace", **pipes)
    for line in process.stdout:
        sys.stdout.write(f"{name:>13} | {line}")
        sys.stdout.flush()
    if process.wait() or not file.exists():
        return hosts.Result(name, Counts(failed=1), ran=f"ended with exit code {process.returncode}")
    return read(file)


def write(found, file):
    """Leave a result to whoever asked for it."""
    Path(file).write_text(json.dumps(asdict(found)))


def read(file):
    """What `write` has left."""
    values = json.loads(file.read_text())
    return hosts.Result(**{**values, "counts": Counts(**values["counts"])})
