# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Describing: what there is that a job may name, and what each of it may be told, as text for a terminal."""

import shutil
import textwrap
from pathlib import Path

from ..core.csg import NODES
from ..core.declared import description, forms
from ..core.declared.hints import meant
from ..core.declared.parameters import ShapeError, parameters, shown, spelled
from ..core.shapes.kinds import CLASSIFICATION
from ..presets import BY_NAME, GROWN
from .grammar import STANDARD_INPUT
from .job import DESCRIBED, Render

WIDE = 100  # letters of a line of names
MORE = "`describe NAME` says what each may be told, `describe --schema` says all of it as a JSON Schema."


def everything():
    """Lines that name all that can be described: shapes by what moves, what their parameters may be, presets."""
    groups = CLASSIFICATION | {"Sets, and how they are made": NODES, "Picture": (Render,)}
    for title, kinds in groups.items():
        yield from (title, *(f"  {spelled(kind)}: {description.summary(kind)}" for kind in kinds), "")
    yield "Kinds, by the parameter that first has them"
    yield from (f"  {name}: {', '.join(kinds)}" for name, kinds in chosen().items())
    yield from ("", "Presets, each a job to begin with: `describe NAME > JOB.toml`")
    listed = sorted(BY_NAME, key=lambda name: BY_NAME[name].group == GROWN)
    yield from textwrap.wrap(", ".join(listed), WIDE, initial_indent="  ", subsequent_indent="  ")
    yield from ("", MORE)


def chosen():
    """The names of the kinds that parameters may be, each once, by the first parameter that may be it."""
    owners = {}
    for shape in DESCRIBED.values():
        for parameter, kind in choices(shape):
            owners.setdefault(kind, parameter)
    return {name: [spelled(kind) for kind, owner in owners.items() if owner == name] for name in owners.values()}


def preset(name):
    """The text of a preset's job, or nothing where a name is of none."""
    found = BY_NAME.get(name)
    return found.path.read_text(encoding="utf-8").rstrip("\n") if found else ""


def named(name):
    """What can be described by a name in a job, of a law and a trajectory both a formula; nothing for a grammar."""
    found = [kind for kind in kinds() if spelled(kind) == name]
    if not found and name != STANDARD_INPUT and not Path(name).exists():
        raise ShapeError(f"must be a name that `describe` alone lists, or the file of a grammar, got {shown(name)}"
                         f"{meant([*map(spelled, kinds()), *BY_NAME], name)}", "SHAPE")  # fmt: skip
    return found


def kinds():
    """All classes that can be described."""
    chosen = (kind for shape in DESCRIBED.values() for _, kind in choices(shape))
    return dict.fromkeys((*DESCRIBED.values(), *chosen, Render))


def choices(owner):
    """The kinds that the parameters of a shape, or of a kind, can be, and those of their own parameters; each with
    the name of its parameter."""
    for p in parameters(owner):
        for kind in p.kinds:
            yield p.name, kind
            yield from choices(kind)


def table(name, kind):
    """The parameters of a shape for people, each with its default, and beneath it what it means and takes."""
    width = max(60, shutil.get_terminal_size((100, 24)).columns - 4)
    lines = [f"{name}: {description.summary(kind)}", ""]
    for row in description.describe(kind):
        default = "" if row.default is None else f" = {forms.tidy(row.default, forms.scalar, len(row.key))}"
        means = f"{row.doc}. {row.takes}" + (f"; {row.limits}" if row.limits else "")
        lines.append(f"{row.key}{default}")
        lines.extend(textwrap.wrap(means, width, initial_indent="    ", subsequent_indent="    "))
    return "\n".join(lines)
