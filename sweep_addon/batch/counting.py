# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a search is, for somebody who waits: a line on a terminal, that is taken away at the end."""

import sys
import time
from contextlib import contextmanager

from ..core.progress import unheard

OFTEN = 0.2  # seconds from one count to the next
CLEARED = "\r\033[K"  # the line, so that the next is written over it


@contextmanager
def counted(title):
    """What is to be told which part is done, from 0 to 1; it says so on standard error if that is a terminal.

    Parameters
    ----------
    title : str
        What is done.
    """
    if not sys.stderr.isatty():
        yield unheard
        return
    last = -OFTEN

    def count(part):
        nonlocal last
        now = time.monotonic()
        if now - last >= OFTEN:
            last = now
            sys.stderr.write(f"{CLEARED}{title}: {part:.0%}")
            sys.stderr.flush()

    try:
        yield count
    finally:
        sys.stderr.write(CLEARED)
