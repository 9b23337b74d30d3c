# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a render is, for somebody who waits: Blender's own count of samples, on standard error."""

import re
import sys
import time
from contextlib import contextmanager

import bpy

SAMPLE = re.compile(r"Sample (\d+)/(\d+)")
OFTEN = 0.2, 5.0  # seconds from one count to the next: on a terminal, where it is written over, and in a log


@contextmanager
def watched(title, in_a_log=False):
    """Say on standard error what is rendered and how far it is, if that is a terminal or is asked for.

    Parameters
    ----------
    title : str
    in_a_log : bool
        Say it also where standard error is no terminal, in lines of their own.
    """
    terminal = sys.stderr.isatty()
    if not (terminal or in_a_log):
        yield
        return
    before, after = ("\r\033[K", "") if terminal else ("", "\n")
    last = -OFTEN[1]

    def count(stats, *rest):
        nonlocal last
        found, now = SAMPLE.search(str(stats)), time.monotonic()
        if found and now - last >= OFTEN[not terminal]:
            last = now
            sys.stderr.write(f"{before}{title}: sample {found[1]} of {found[2]}{after}")
            sys.stderr.flush()

    bpy.app.handlers.render_stats.append(count)
    try:
        yield
    finally:
        bpy.app.handlers.render_stats.remove(count)
        sys.stderr.write(f"{before}{title}\n" if terminal else "")
