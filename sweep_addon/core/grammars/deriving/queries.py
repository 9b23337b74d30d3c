# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Queries: modules whose parameters a turtle fills in after each step, and an environment that answers others.

``?P`` asks where the turtle is, ``?H ?L ?U`` for its heading, its left and its up, and ``?E`` the environment, which is
a function of Python: no file can hold one.

Source
------
Prusinkiewicz, James, Mech: Synthetic Topiary, SIGGRAPH 1994; Mech, Prusinkiewicz: Visual Models of Plants Interacting
with Their Environment, SIGGRAPH 1996.
"""

from functools import cached_property

import numpy as np

from ...declared.parameters import ShapeError, require
from ...declared.wording import shown
from ..drawing import turns
from ..drawing.turtle import Walk
from ..text.modules import ENVIRONMENT
from ..word import Word
from .derivation import homomorphic
from .stepping import State

AXES = ("?H", "?L", "?U")


class Asked:
    """Modules that ask an environment, in the order of the word.

    Attributes
    ----------
    at : (m, 3) float array
        Where the turtle is at each, in metres.
    heading, left, up : (m, 3) float array
        Its axes.
    values : (m, k) float array
        The parameters that they have now, 0 where one has fewer.
    generation : int
        The step that has been made.
    """

    def __init__(self, at, orientations, values, generation):
        self.at, self.orientations, self.values, self.generation = at, orientations, values, generation

    def __len__(self):
        return len(self.at)

    @cached_property
    def axes(self):
        return turns.axes(*self.orientations)

    @property
    def heading(self):
        return self.axes[:, 0]

    @property
    def left(self):
        return self.axes[:, 1]

    @property
    def up(self):
        return self.axes[:, 2]


def answered(state, tables, generation, seed, meter, environment=None):
    """The word with the parameters of its queries filled in.

    Parameters
    ----------
    state : State
    tables : Tables
    generation, seed : int
    meter : Meter
        Of what the homomorphism makes of the word.
    environment : callable, optional
        Takes an `Asked`, and returns (m,) or (m, k) numbers.

    Returns
    -------
    State
    """
    if not np.isin(state.symbols, list(tables.queries)).any():
        return state
    columns = [*state.columns, np.arange(1.0, len(state) + 1)]
    numbered = State(state.symbols, columns, state.keys, state.births, variables=state.variables)
    told = homomorphic(numbered, tables, generation, meter)
    walk = Walk(Word(tables, told, generation, seed), stops=tuple(tables.queries))
    figure = walk.figure()
    module = walk.word.columns[-1][walk.moves].astype(np.intp) - 1  # at each move; -1 of what stands for others
    stops = np.flatnonzero(np.isin(walk.symbols[walk.moves], list(tables.queries)) & (module >= 0))
    module, at, orientations = module[stops], figure.moves_end[stops], turns.taken(figure.orientations(), stops)

    columns = [column.copy() for column in state.columns]
    symbols = state.symbols[module]
    for number, (name, count) in tables.queries.items():
        which = np.flatnonzero(symbols == number)
        if name == ENVIRONMENT or not len(which):
            continue
        found = at[which] if name == "?P" else turns.axes(*turns.taken(orientations, which))[:, AXES.index(name)]
        for column in range(min(count, 3)):
            columns[column][module[which]] = found[:, column]
    counts = np.array([count if name == ENVIRONMENT else 0 for name, count in tables.symbols])[symbols]
    which = np.flatnonzero(counts)
    if environment is not None and len(which):
        values = np.stack([column[module[which]] for column in columns[: counts.max()]], axis=1)
        found = asked(environment, Asked(at[which], turns.taken(orientations, which), values, generation))
        for column in range(min(found.shape[1], counts.max())):
            has = counts[which] > column
            columns[column][module[which[has]]] = found[has, column]
    return State(state.symbols, columns, state.keys, state.births, variables=state.variables)


def asked(environment, those):
    """(m, k) float array: what an environment answers."""
    answer, rows = environment(those), f"must return {len(those)} rows of numbers"
    try:
        found = np.asarray(answer, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise ShapeError(f"{rows}, got {shown(answer)}", "environment") from None
    if found.ndim == 0:
        found = np.broadcast_to(found, len(those))
    if found.ndim > 2 or len(found) != len(those):
        raise ShapeError(f"{rows}, got an array of shape {found.shape}", "environment")
    found = found.reshape(len(those), -1)
    require(np.isfinite(found).all(), "must return finite numbers", found[~np.isfinite(found)][:1], "environment")
    return found
