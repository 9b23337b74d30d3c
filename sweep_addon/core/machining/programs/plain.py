# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of plain lines, of which most programs consist: straight moves by numbers, read many at once."""

import re

import numpy as np

from ...declared.refusals import ShapeError
from .lines import at_line
from .machine import turned, within

NUMBER = r"([-+]?(?:\d+(?:\.\d*)?|\.\d+))[ \t]*"  # read in one way only, so that a wrong line is left at once
LINE = re.compile(
    rf"[ \t]*(?:[Nn]\d+[ \t]*)?(?:[Gg]0*([01])(?![\d.])[ \t]*)?"
    rf"(?=[XYZxyz])(?:[Xx]{NUMBER})?(?:[Yy]{NUMBER})?(?:[Zz]{NUMBER})?(?:[Ff]{NUMBER})?"
    r"(?:\([^()]*\)[ \t]*|;.*)?\r?$",
    re.ASCII,
)
BLANK = (None,) * 5  # what a line without anything says
FEWEST = 4  # lines, for which arrays are faster than one after the other


def run_of(machine, lines, start):
    """The plain lines from one on to the last that moves: what is in each, if the machine can take them so.

    It can where the first place of all axes is known, so that a move is what its line says and no more.
    """
    straight = machine.motion in (0, 10) and not (machine.spline or machine.beside or machine.lost or machine.away)
    if not straight or machine.first is None or machine.feed_mode == 930:
        return []
    found, match = [], LINE.match
    for line in range(start, len(lines)):
        plain = match(lines[line])
        if plain is None:
            if not found or lines[line].strip():
                break
            found.append(BLANK)  # found is a line each
        else:
            found.append(plain.groups())
    while found and found[-1] is BLANK:
        found.pop()
    return found if len(found) >= FEWEST else []


def move_along(machine, found, start):
    """Make the moves of plain lines."""
    codes, *places, feeds = zip(*found, strict=True)
    x, y, z = (np.array([p is not None for p in axis]) for axis in places)
    moving = np.flatnonzero(x | y | z)
    kinds = latest(codes, machine.motion // 10)[moving]
    paces = latest(feeds, machine.feed)
    wrong = (kinds == 1) & (paces[moving] <= 0)
    if wrong.any():
        with at_line(start + moving[np.argmax(wrong)]):
            raise ShapeError("moves at a feed before there is one: F")
    table = np.column_stack([followed(machine, axis, here) for axis, here in zip(places, machine.place, strict=True)])
    place = as_machine(machine, table[moving])
    far = np.abs(place).max(axis=1, initial=0.0)
    if len(far):
        with at_line(start + moving[np.argmax(far)]):
            within(place.ravel()[np.argmax(np.abs(place))])
    rows = np.empty((len(moving), 6))
    rows[:, :3], rows[:, 3], rows[:, 4], rows[:, 5] = place, kinds, start + 1 + moving, machine.tool
    machine.moved.add_run(rows)
    machine.at, machine.off_contour = place[-1].tolist(), False
    machine.known = [known or bool(told.any()) for known, told in zip(machine.known, (x, y, z), strict=True)]
    machine.motion, machine.feed = int(kinds[-1]) * 10, float(paces[-1])


def latest(texts, before):
    """Numbers by line, each going on where nothing is said."""
    told = np.array([text is not None for text in texts])
    values = np.array([before, *(float(text) for text in texts if text is not None)])
    return values[np.cumsum(told)]


def followed(machine, texts, here):
    """Places of an axis by line in metres: where each is said, or from the one before where they are relative."""
    if machine.absolute:
        told = np.array([text is not None for text in texts])
        lengths = [float(text) * machine.unit for text in texts if text is not None]
        return np.array([here, *lengths])[np.cumsum(told)]
    steps = [0.0 if text is None else float(text) * machine.unit for text in texts]
    return here + np.cumsum(steps)


def as_machine(machine, places):
    """Places (n, 3) of the program, as the machine knows them."""
    places = places + machine.shift
    x, y = turned(places[:, 0], places[:, 1], machine.rotations[machine.system])
    return np.column_stack((x, y, places[:, 2])) + machine.offsets[machine.system]
