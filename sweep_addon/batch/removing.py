# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb of the command line that finds how a part gets out of an assembly."""

from pathlib import Path

from ..core.later import later
from . import verbs
from .counting import counted

removal_path = later("core.removal", "removal_path")
in_units = later("core.removal.lengths", "in_units")


def remove(told):
    """Say on which path the shape of a job gets out from among those of other jobs, or that none was found: then it
    ends with 1."""
    part = verbs.read(told.part).shape
    others = {name: verbs.read(path).shape for name, path in zip(names(told.others), told.others, strict=True)}
    options = {"tolerance": told.tolerance, "seed": told.seed}
    if told.budget is not None:
        options["budget"] = told.budget
    with counted(f"searching a way out for {told.part}") as progress:
        path = removal_path(part, others, **options, progress=progress)
    verbs.say(f"{told.part}: {path}")
    if not path:
        return 1
    deep, clear = in_units(path.tolerance), in_units(path.clearance)
    held = f"{deep} deep in others at most" if path.tolerance else f"{clear} clear"
    verbs.say(f"{told.part}: {held}, certified")
    return 0


def names(paths):
    """What people call the shapes of job files: as the file, and with its folder where two are called alike.

    >>> names(["one/lid.toml", "one/box.toml", "two/box.toml"])
    ['lid', 'one/box.toml', 'two/box.toml']
    """
    stems = [Path(path).stem for path in paths]
    return [stem if stems.count(stem) == 1 else path for stem, path in zip(stems, paths, strict=True)]
