# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Describing: what there is that a job may name, and what each of it may be told, as text for a terminal."""

import shutil
import textwrap
from pathlib import Path

from ..core.csg import NODES
from ..core.declared import description, forms
from ..core.declared.hints import meant
from ..core.declared.parameters import ShapeError, inside, parameters, spelled
from ..core.declared.wording import shown
from ..core.shapes.kinds import CLASSIFICATION
from ..presets import BY_NAME, GROWN
from .grammar import STANDARD_INPUT
from .job import DESCRIBED, Render

INDENTED = {"initial_indent": "    ", "subsequent_indent": "    "}
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
        for parameter, kind, _ in choices(parameters(shape)):
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
    chosen = (kind for shape in DESCRIBED.values() for _, kind, _ in choices(parameters(shape)))
    return dict.fromkeys((*DESCRIBED.values(), *chosen, Render))


def choices(declared):
    """The kinds that some parameters can be, and those of their own parameters; each with the name of its parameter,
    and with its own parameters as they are there, where their defaults may be others."""
    for p in declared:
        for kind in p.kinds:
            there = inside(p, kind)
            yield p.name, kind, there
            yield from choices(there)


def elsewhere(kind):
    """The other defaults that parameters of a kind have where it stands in shapes.

    Returns
    -------
    dict of list of str
        By the name of the parameter, for each other default a sentence that says where.

    Examples
    --------
    >>> from sweep_addon.core.contours import Rectangle
    >>> elsewhere(Rectangle)["width"][0]
    '0.3 in pd-curve-sweep (contour)'
    """
    found = {}
    for owner, shape in DESCRIBED.items():
        for name, chosen, there in choices(parameters(shape)):
            for alone, p in zip(parameters(kind), there, strict=True) if chosen is kind else ():
                if description.short(alone) != description.short(p):
                    default = description.toml_value(description.short(p))
                    found.setdefault(p.name, {}).setdefault(default, {}).setdefault(owner, {})[name] = True
    return {key: [placed(*other) for other in defaults.items()] for key, defaults in found.items()}


def placed(default, owners):
    """A default and the shapes that have it, each with the parameters where."""
    places = [f"{owner} ({', '.join(names)})" for owner, names in owners.items()]
    return f"{default} in {', '.join(places)}"


def table(name, kind):
    """The parameters of a shape for people, each with its default, and beneath it what it means and takes."""
    width = max(60, shutil.get_terminal_size((100, 24)).columns - 4)
    lines = [f"{name}: {description.summary(kind)}", ""]
    others = elsewhere(kind)
    for row in description.describe(kind):
        default = "" if row.default is None else f" = {forms.tidy(row.default, forms.scalar, len(row.key))}"
        means = f"{row.doc}. {row.takes}" + (f"; {row.limits}" if row.limits else "")
        lines.append(f"{row.key}{default}")
        for sentence in (means, *others.get(row.key, ())):
            lines.extend(textwrap.wrap(sentence, width, break_on_hyphens=False, **INDENTED))
    return "\n".join(lines)
