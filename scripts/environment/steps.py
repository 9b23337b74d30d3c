# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps of a set-up: commands that take a while, shown as one line with the seconds, and one at a time."""

import fcntl
import os
import shutil
import subprocess
import sys
import tempfile
import time
from contextlib import contextmanager

from . import SetupError

NEWS = 20  # seconds from one line to the next of a step that takes long, where lines are not written over


def step(title, command, way_out="", timeout=1800, **options):
    """Run a command whose output is one line here; if it fails, its last lines are shown and the way out is said."""
    start, said = time.monotonic(), 0
    with tempfile.TemporaryFile("w+", errors="replace") as log:
        try:
            process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, **options)
        except OSError as error:
            raise SetupError(f"{title}: {error}. {way_out}".strip()) from None
        try:
            while process.poll() is None:
                seconds = time.monotonic() - start
                if seconds > timeout:
                    raise SetupError(f"{title}: no end after {timeout} s. {way_out}".strip())
                news = int(seconds // NEWS)
                written_over = sys.stderr.isatty() or news == said
                show(f"{title} ... {seconds:.0f} s  {last_line(log)}", end="" if written_over else "\n")
                said = news
                time.sleep(0.2 if seconds > 1 else 0.02)
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()
        if process.returncode:
            log.seek(0)
            show(f"{title}: failed")
            print(*log.read().splitlines()[-15:], sep="\n", file=sys.stderr)
            raise SetupError(f"{title}: exit code {process.returncode}, see above. {way_out}".strip())
    show(f"{title}: {time.monotonic() - start:.0f} s")


def last_line(log):
    """The newest line of a log that another process writes."""
    start = max(0, os.fstat(log.fileno()).st_size - 400)
    lines = os.pread(log.fileno(), 400, start).decode(errors="replace").replace("\r", "\n").split("\n")
    return next((line.strip() for line in reversed(lines) if line.strip()), "")


def show(line, end="\n"):
    """A line on stderr, where stdout may be somebody's result; on a terminal an unended line is written over."""
    if sys.stderr.isatty():
        width = shutil.get_terminal_size().columns - 1
        print(f"\r\033[K{line if end else line[:width]}", end=end, file=sys.stderr, flush=True)
    elif end:
        print(line, file=sys.stderr, flush=True)


@contextmanager
def locked(path):
    """Keep others out who would make the same thing; they wait, and then find it made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            show(f"waiting for another run that holds {path}")
            fcntl.flock(file, fcntl.LOCK_EX)
        yield
