# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Running tests: a command or a pytest suite to its end, under a time limit, as counts."""

import os
import signal
import subprocess
from dataclasses import dataclass
from xml.etree import ElementTree

from . import BUILD, CHECKOUT

TIMEOUT = 7200 if os.environ.get("SWEEP_FULL") == "1" else 1800  # hosts share the processors


@dataclass(frozen=True)
class Counts:
    """How many tests passed, failed, were skipped."""

    passed: int = 0
    failed: int = 0
    skipped: int = 0

    def __add__(self, other):
        return Counts(self.passed + other.passed, self.failed + other.failed, self.skipped + other.skipped)


def program(command, environment=None, timeout=TIMEOUT):
    """Run a command as one test."""
    return Counts(passed=1) if finish(command, environment, timeout) == 0 else Counts(failed=1)


def suite(name, python, *arguments, environment=None):
    """Run pytest; the counts are those of its report, and a crash or an empty run is a failure."""
    report = BUILD / "reports" / f"{name}.xml"
    report.parent.mkdir(parents=True, exist_ok=True)
    report.unlink(missing_ok=True)
    # Isolated from the person's own packages. pytest-blender reads its configuration in a way that pytest 9 warns of.
    isolated = ["-I", "-W", "ignore:config.inicfg"]
    command = [python, *isolated, "-m", "pytest", "--quiet", f"--junitxml={report}", *arguments]
    code = finish(command, {**os.environ, **(environment or {})}, TIMEOUT)
    counts = read(report) if report.exists() else Counts()
    if code and not counts.failed:
        print(f"*** pytest ended with exit code {code}")
        counts += Counts(failed=1)
    return counts


def read(report):
    suites = ElementTree.parse(report).getroot().iter("testsuite")
    counts = Counts()
    for found in suites:
        tests, failures, errors, skipped = (int(found.get(key)) for key in ("tests", "failures", "errors", "skipped"))
        counts += Counts(tests - failures - errors - skipped, failures + errors, skipped)
    return counts


def finish(command, environment, timeout):
    """The exit code of a command; after the time limit it is ended, with all that it started."""
    process = subprocess.Popen(
        list(map(str, command)), env=environment, cwd=CHECKOUT, stdin=subprocess.DEVNULL, start_new_session=True
    )
    try:
        return process.wait(timeout)
    except subprocess.TimeoutExpired:
        print(f"*** no end after {timeout} s", flush=True)
        return 124
    finally:
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
