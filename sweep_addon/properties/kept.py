# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of what is registered, kept beside Python's own compiled files, and made anew when its sources change.

Whoever starts Blender waits for it: to import the shapes, of which all of it follows, takes longer than all the rest.
"""

import marshal
import os
import sys
from contextlib import suppress
from importlib.util import cache_from_source
from pathlib import Path

from ..core import BEGAN
from ..core.later import later

made = later("bridge.table", "table")

LIBRARY = Path(__file__).parents[1]
FILE = Path(cache_from_source(__file__)).with_suffix(".table")


def table():
    """The table of `bridge.table`, read where that is quicker."""
    kept = read()
    if kept is None:
        kept = made()
        keep(kept)
    return kept


def read():
    """What is kept, or None where there is nothing, or where a source of it is another now."""
    try:
        held = marshal.loads(FILE.read_bytes())
        return held["table"] if held["sources"] == stamps(held["sources"]) else None
    except (OSError, ValueError, TypeError, KeyError, EOFError, MemoryError):  # it can be made again
        return None


def keep(table):
    """Write it for the next time, as Python does with what it compiles; a place that cannot be written is left.

    Where a source was written since the library was first imported, the table may be of what that was before.
    """
    if sys.dont_write_bytecode:
        return
    part = FILE.with_suffix(f".{os.getpid()}")
    try:
        made_from = stamps(sources())
        if max(time for time, _ in made_from.values()) >= BEGAN:
            return
        FILE.parent.mkdir(parents=True, exist_ok=True)
        part.write_bytes(marshal.dumps({"sources": made_from, "table": table}))
        os.replace(part, FILE)
    except OSError:
        with suppress(OSError):
            part.unlink()


def sources():
    """The files that the table was made from: of all modules of the core, those that are imported by now."""
    package = __package__.rpartition(".")[0]
    parts = (f"{package}.core", f"{package}.bridge.table")
    return [os.path.relpath(module.__file__, LIBRARY) for name, module in sys.modules.items() if name.startswith(parts)]


def stamps(files):
    """When each file was changed, in nanoseconds, and its size: by these Python knows its compiled files too."""
    return {file: [found.st_mtime_ns, found.st_size] for file in files for found in [os.stat(f"{LIBRARY}/{file}")]}
