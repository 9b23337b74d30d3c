# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Generalized cylinders: axes that are smooth curves through control points, which a turtle sets on its way.

``@Gs`` begins one, ``@Gc(n)`` sets a control point, ``@Ge(n)`` the last one. Between two of them the axis is a Hermite
curve, whose tangents are the turtle's headings there, as long as the points are apart times a factor that ``@Gt(a)`` or
``@Gt(in, out)`` sets; n segments are drawn along it. ``F`` and ``f`` in between move the turtle and draw nothing.

A turtle walks a word in which a mark stands once for each of its segments; so all that is known of segments is known of
these.

Source
------
Mech, Prusinkiewicz, Hanan: Extensions to the Graphical Interpretation of L-systems Based on Turtle Geometry, 1997.
"""

import numpy as np

from ...declared.parameters import ShapeError, require
from ..deriving.stepping import State
from ..text.modules import CLOSE, OPEN
from . import turns
from .branches import Branches

MARKS, TANGENTS = ("@Gs", "@Gc", "@Ge"), "@Gt"
BEGUN, OPENED = 1, (1, 2)  # kinds of marks, from 1
SEGMENTS = 8  # between two control points, where nothing is said
MOST_SEGMENTS, MOST = 1000, 20_000_000  # between two control points, and modules of a word with all segments
OF_SEGMENT = 200  # bytes of all arrays of a figure while it is drawn, for each module of the word with all segments
APART = 1.2  # by how much tangents are longer than the points are apart, where nothing is said


def marked(word):
    """Whether a word may have marks of generalized cylinders."""
    return any(name in MARKS for name, _ in word.tables.symbols)


class Cylinders:
    """The marks of a word, each in place of as many as it has segments.

    Parameters
    ----------
    word : Word
    budget : Budget, optional
        Of the arrays of a figure of all segments.

    Attributes
    ----------
    state : State
        The word in which marks stand once for each of their segments.
    bends : (n,) bool array
        Which of its modules are segments of a curve.
    begins, ends : (n,) float array
        Where on its curve each of these is, from 0 to 1.
    before : (n,) int array
        The place of the control point where its curve begins.
    hidden : (n,) bool array
        Which modules stand in a cylinder that is begun and not ended.
    """

    def __init__(self, word, budget=None):
        names = [name for name, _ in word.tables.symbols]
        symbols = word.symbols
        kind = np.array([MARKS.index(name) + 1 if name in MARKS else 0 for name in names], dtype=np.uint8)[symbols]
        brackets = np.flatnonzero(np.isin(names, (OPEN, CLOSE))[symbols])
        branches = Branches(brackets, np.isin(names, OPEN)[symbols[brackets]])
        marks = np.flatnonzero(kind)
        opened = np.append(np.isin(kind[marks], OPENED), False)  # the last stands for no mark
        previous = branches.previous(branches.first(kind > 0))
        curves = np.flatnonzero(opened[previous] & (kind[marks] != BEGUN))
        places = marks[curves]

        times = np.ones(len(symbols), dtype=np.intp)
        times[places] = segments(word, places)
        require(times.sum() <= MOST, f"must have at most {MOST:,} segments", int(times.sum()), MARKS[1])
        if budget:
            budget.of_arrays(int(times.sum()) * OF_SEGMENT, "figure")
        stop = np.cumsum(times)
        of = np.repeat(np.arange(len(symbols)), times)
        nth = np.arange(len(of)) - (stop - times)[of]
        bends, before = np.zeros(len(symbols), dtype=bool), np.zeros(len(symbols), dtype=np.intp)
        bends[places], before[places] = True, stop[marks[previous[curves]]] - 1
        self.bends, self.before = bends[of], before[of]
        self.begins, self.ends = nth / times[of], (nth + 1) / times[of]
        self.hidden = opened[branches.before(np.arange(len(symbols)), kind > 0)][of]
        births = word.state.births
        births = None if births is None else lambda: word.births[of]
        self.state = State(symbols[of], [column[of] for column in word.columns], None, births)

    def shaped(self, walk, start, end, orientations):
        """Two (m, 3) float arrays: where moves begin and end when those of no length go along the curves."""
        number = np.cumsum(walk.is_moving) - 1
        place = np.flatnonzero(self.bends)
        at, first = number[place], number[self.before[place]]
        one, other = end[first], end[at]
        apart = np.linalg.norm(other - one, axis=1)[:, None]
        leaving = apart * tangents(walk, self.before[place], 1) * heading(orientations, first)
        coming = apart * tangents(walk, place, 0) * heading(orientations, at)
        start, end = start.copy(), end.copy()
        start[at] = hermite(one, other, leaving, coming, self.begins[place][:, None])
        end[at] = hermite(one, other, leaving, coming, self.ends[place][:, None])
        return start, end


def heading(orientations, which):
    """(k, 3) float array: the heading at moves."""
    return turns.axes(*turns.taken(orientations, which))[:, 0]


def hermite(one, other, leaving, coming, t):
    """(k, 3) float array: points of cubic curves between two points with a tangent at each."""
    s = 1 - t
    return s * s * (1 + 2 * t) * one + t * t * (1 + 2 * s) * other + t * s * (s * leaving - t * coming)


def tangents(walk, places, column):
    """(k, 1) float array: how long tangents are where points are 1 apart: of curves that arrive (0) or leave (1)."""
    chosen = walk.chosen(TANGENTS, given=True)
    found = np.full(len(places), APART)
    last = walk.branches.before(places, chosen)
    known = np.flatnonzero(last >= 0)
    if len(known):
        where = np.flatnonzero(chosen)[last[known]]
        both = np.array([count > 1 for _, count in walk.word.tables.symbols])[walk.symbols[where]]
        columns = walk.word.columns
        found[known] = np.where(both, columns[min(column, len(columns) - 1)][where], columns[0][where])
    return found[:, None]


def segments(word, places):
    """(m,) int array: how many segments marks ask for."""
    given = np.array([count > 0 for _, count in word.tables.symbols])[word.symbols[places]]
    asked = np.where(given, word.columns[0][places] if word.columns else 0, SEGMENTS)
    if not ((asked >= 1) & (asked <= MOST_SEGMENTS)).all():
        wrong = np.flatnonzero(~((asked >= 1) & (asked <= MOST_SEGMENTS)))[0]
        name, _ = word.tables.symbols[word.symbols[places[wrong]]]
        raise ShapeError(f"must ask for 1 to {MOST_SEGMENTS} segments, got {asked[wrong]:g}", name)
    return asked.astype(np.intp)
