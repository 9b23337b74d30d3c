# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Milling: from the parameters of machined stock to its mesh, and what people are told of it."""

from dataclasses import replace

import numpy as np

from ..declared.parameters import ShapeError, at
from ..machining.chart import Cut
from ..machining.cutting import Question, cut, path_of, takes_long
from ..machining.remains import remains
from ..machining.verification import NO_PART, verify
from ..progress import unheard, within

__all__ = ["check", "made", "mesh", "takes_long", "verify"]


def check(shape):
    """Refuse a text that is no program, and two tools of one number."""
    with at("program"):
        path_of(shape.program, shape.tool, shape.tools)
    numbers = [each.number for each in shape.tools]
    for place, number in enumerate(numbers, 1):
        if number in numbers[: place - 1]:
            raise ShapeError(f"must be of one tool alone, got {number} again", f"tools.{place}.number")


def mesh(shape, dtype=np.float64):
    """The mesh of machined stock."""
    return made(shape, None).astype(dtype)


def made(shape, progress):
    progress = progress or unheard
    machined = cut(Question.of(shape, within(progress, 0.0, 0.5)))
    found = verify(shape, progress=within(progress, 0.5, 1.0))
    left = remains(machined.lattice, machined.heights, machined.low[2], machined.high[2])
    told = tuple(sentence for sentence in found.sentences() if sentence != NO_PART)  # which is usual for a shape
    solid = left.mesh(told=told)
    values = attributes(machined, found, left) if shape.attributes else {}
    return replace(solid, chart=Cut(values, len(machined.path)))


def attributes(machined, found, left):
    """Values at each vertex by name; below they are those of no cut."""
    values = {"depth": machined.high[2] - machined.left, "line": machined.lines}
    if found.deviation is not None:
        values["deviation"] = found.deviation
    return {name: np.where(left.on_top, grid.ravel()[left.place], 0.0) for name, grid in values.items()}
