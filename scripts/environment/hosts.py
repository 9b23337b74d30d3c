# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The hosts of the test suite: each proves the project in one kind of Python or Blender that people have."""

import os
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass, replace

from . import BUILD, CHECKOUT, SetupError, blenders, extension, packages, venvs
from .package import package
from .running import Counts, program, suite

PICTURES = BUILD / "window"
SCREEN = ("-screen", "0", "1400x900x24")
VERSIONS = "import platform, numpy; print(f'Python {platform.python_version()}, NumPy {numpy.__version__}')"
# In front of Blender's Python: failures decide the exit code, and pytest is found.
INSIDE_BLENDER = ("--python-use-system-env", "--python-exit-code", "1")
BRIEF = {"SWEEP_BRIEF": "1"}  # plain Python does what takes long; but what was asked for is done


@dataclass(frozen=True)
class Result:
    """What came of a host."""

    host: str
    counts: Counts = Counts()
    seconds: float = 0.0
    busy: float = 0.0  # seconds of a processor, which others on the machine do not change
    ran: str = ""  # which Python or Blender it was
    missing: str = ""  # why it could not run


def tried(name, host, arguments):
    """Run a host; one that cannot be had says why."""
    print(f"\n=== {name}: {host.__doc__}", flush=True)
    start, before = time.monotonic(), spent()
    try:
        result = Result(name, host(arguments), ran=what_ran(name))
    except SetupError as error:
        result = Result(name, missing=str(error))
    return replace(result, seconds=time.monotonic() - start, busy=spent() - before)


def spent():
    """Seconds of processors in all processes that were started here and have ended."""
    times = os.times()
    return times.children_user + times.children_system


def what_ran(name):
    """The version of the Python or Blender behind a host."""
    command, variables = {
        "style": ([venvs.PLAIN.python, "-I", "-m", "ruff", "--version"], {}),
        "plain Python": ([venvs.PLAIN.python, "-I", "-c", VERSIONS], {}),
        "NumPy alone": ([venvs.NUMPY.python, "-I", "-c", VERSIONS], {}),
        "bpy wheel": ([blenders.LAUNCHER, "--version"], {"SWEEP_BLENDER": "wheel"}),
    }.get(name, ([blenders.LAUNCHER, "--version"], {}))
    answer = subprocess.run(command, env={**os.environ, **variables}, capture_output=True, text=True, timeout=120)
    return answer.stdout.partition("\n")[0]


def style(arguments):
    """ruff's rules, the arrow of imports among them, and its format."""
    ruff = [venvs.made(venvs.PLAIN), "-I", "-m", "ruff"]
    return program([*ruff, "check", CHECKOUT]) + program([*ruff, "format", "--check", CHECKOUT])


def plain(arguments):
    """plain Python without Blender, with the newest NumPy; the examples in docstrings."""
    return suite("plain", venvs.made(venvs.PLAIN), *arguments)


def numpy(arguments):
    """plain Python with the oldest NumPy and nothing else."""
    brief = {} if arguments else BRIEF
    return suite("numpy", venvs.made(venvs.NUMPY), *(arguments or ["tests/core"]), environment=brief)


def wheel(arguments):
    """the bpy wheel of the oldest supported Blender, the checkout as a live extension."""
    environment = {"SWEEP_BLENDER": "wheel", **({} if arguments else BRIEF)}
    return suite("wheel", venvs.made(venvs.BLENDER), *arguments, environment=environment)


def blender(arguments):
    """the real Blender in background, the checkout as a live extension."""
    found = blenders.real()
    print(f"    {found.title}", flush=True)
    environment = {"PYTHONPATH": packages.inside("libraries", "tests"), **({} if arguments else BRIEF)}
    return through_pytest_blender("blender", environment, *arguments, "--", "--factory-startup", *INSIDE_BLENDER)


def installed(arguments):
    """the real Blender with the zip built, validated, installed, used and taken off again."""
    found = blenders.real()
    user = BUILD / "installed"
    shutil.rmtree(user, ignore_errors=True)
    theirs = {"SWEEP_BLENDER_USER": str(user)}
    zipped = {**theirs, "SWEEP_ZIP": str(package(found))}
    counts = suite("zip", venvs.made(venvs.PLAIN), "tests/package", environment=zipped)
    theirs |= {"PYTHONPATH": packages.inside("tests"), **({} if arguments else BRIEF)}
    return counts + through_pytest_blender("installed", theirs, *arguments, "--", *INSIDE_BLENDER)


def through_pytest_blender(name, environment, *options):
    launcher = ("-p", "pytest-blender", "--blender-executable", str(blenders.LAUNCHER))
    return suite(name, venvs.made(venvs.PLAIN), *launcher, *options, environment=environment)


def window(arguments):
    """the real Blender's window on a virtual screen, driven by mouse and keyboard."""
    sessions = sorted(CHECKOUT.glob("tests/window/[a-z]*.py"))
    if not sessions:
        raise SetupError("There is no session in tests/window.")
    found = blenders.real()
    if not found.system and not shutil.which("xvfb-run"):
        raise SetupError("A window needs xvfb-run. On Debian and Ubuntu: sudo apt-get install xvfb imagemagick")
    shutil.rmtree(PICTURES, ignore_errors=True)
    PICTURES.mkdir(parents=True)
    screen = replace(found, program=("xvfb-run", "--auto-servernum", "-s", " ".join(SCREEN), *found.program))
    options = ("--enable-event-simulate", "--gpu-backend", "opengl", "--window-geometry", "0", "0", "1400", "900")
    counts = Counts()
    for session in sessions:
        command, environment = extension.started(screen, *options, "--python", session)
        environment |= {"LIBGL_ALWAYS_SOFTWARE": "1", "SWEEP_PICTURES": str(PICTURES)}
        environment["PYTHONPATH"] += os.pathsep + str(session.parent)
        counts += program(command, environment=environment, timeout=300)
    print(f"    pictures are in {PICTURES}")
    return counts


FAST = {"style": style, "plain Python": plain}
ALL = {
    **FAST,
    "NumPy alone": numpy,
    "bpy wheel": wheel,
    "real Blender": blender,
    "installed zip": installed,
    "window": window,
}


def table(results, required):
    """The results as lines, and whether all is well: what could not run is loud, and a failure where required."""
    print(f"\n{'host':<16}{'passed':>8}{'failed':>8}{'skipped':>9}{'seconds':>9}{'CPU':>7}  what ran")
    for r in results:
        counts = ("NOT RUN", "", "") if r.missing else (r.counts.passed, r.counts.failed, r.counts.skipped)
        print("{:<16}{:>8}{:>8}{:>9}{:>9.0f}{:>7.0f}  {}".format(r.host, *counts, r.seconds, r.busy, r.ran))
    missing = [r for r in results if r.missing]
    for r in missing:
        print(f"\n*** {r.host}: its tests were NOT run. {r.missing}")
    total = sum((r.counts for r in results), Counts())
    if missing and required:
        total += Counts(failed=len(missing))
        print("\n*** A host that was to run and could not counts as a failure.")
    print(f"\n{total.passed} passed, {total.failed} failed, {total.skipped} skipped")
    sys.stdout.flush()
    return not total.failed
