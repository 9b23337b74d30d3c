# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One step of any grammar: all modules of a word are replaced at once, in the order of the word.

Lengths of successors give places by a cumulative sum; then each module is written once. What takes longer than this for
special kinds of grammars is in `doubling` and `forest`, whose words are the same.
"""

from functools import cached_property

import numpy as np

from ...formulas.expressions import DRAW
from .draws import even, mixed
from .matching import refuse, sound, taken
from .neighbours import Neighbours, removed
from .subsystems import Regions


class State:
    """A word in the making.

    Attributes
    ----------
    symbols : (n,) uint8 or uint16 array
    columns : list of (n,) float64 array
        The first parameter of all modules, the second, ...; 0 where a module has none.
    keys : (n,) uint64 array or None
        What the random numbers of each module hang on, where there are any.
    births : (n,) int32 array, callable or None
        The step that made each module, or what finds that out.
    fresh : (n,) bool array or None
        Which modules may be replaced at all; None for all of them.
    variables : dict of str to float
        What statements have given values to.
    """

    def __init__(self, symbols, columns, keys=None, births=None, fresh=None, variables=None):
        self.symbols, self.columns, self.keys, self.births, self.fresh = symbols, columns, keys, births, fresh
        self.variables = variables or {}

    @cached_property
    def ended(self):
        """(n + 1,) array: the symbols, and what is no symbol where there is no module."""
        return np.append(self.symbols, self.symbols.dtype.type(-1 % 2 ** (8 * self.symbols.itemsize)))

    def __len__(self):
        return len(self.symbols)


def first(tables, key, variables=None):
    """The axiom."""
    template = tables.axiom
    columns = [np.zeros(len(template.symbols)) for _ in range(tables.columns)]
    keys = mixed(key + template.salts) if tables.random else None
    births = np.zeros(len(template.symbols), np.int32)
    state = State(np.array(template.symbols, dtype=tables.dtype), columns, keys, births, variables=variables)
    for (place, column), value in template.fixed.items():
        columns[column][place] = value
    for formula, targets in template.formulas:  # of random numbers and variables alone
        names = formula.expression.names
        drawn = {n: even(key, 0, 1 + int(n.removeprefix(DRAW)))[0] for n in names if n.startswith(DRAW)}
        value = formula.expression.run(state.variables | drawn)
        for place, column in targets:
            columns[column][place] = value
    return state


def step(state, tables, rules, moment, birth, meter, cutting=True, systems=None):
    """The word after a step.

    Parameters
    ----------
    state : State
    tables : Tables
    rules : Rules
    moment : int
        The step, for random numbers.
    birth : int
        The step, as modules remember it.
    meter : Meter
        Asked before modules are made, and while they are looked at.
    cutting : bool
        Whether cuts act.
    systems : dict of int to Rules, optional
        The productions of sub-systems, where words may have them.

    Returns
    -------
    State
    bool
        Whether any module was replaced.
    """
    kind = tables.kind[state.symbols]
    shares = [(rules, None)] if systems is None else [*Regions(tables, state).shares(systems, rules)]
    links = Neighbours(kind) if any(those.context for those, _ in shares) else None
    cuts = np.flatnonzero(state.symbols == tables.cut) if cutting and tables.cut is not None else ()
    gone = removed(kind, cuts) if len(cuts) else None

    replaced = []
    sizes = np.ones(len(state), dtype=np.intp)
    for template, site in (each for share in shares for each in taken(state, *share, moment, links, meter.check)):
        if gone is not None:
            site = site.keep(np.flatnonzero(~gone[site.places]))
        sizes[site.places] = len(template.symbols)
        replaced.append((template, site))
    if gone is not None:
        sizes[gone] = 0
    if not replaced and gone is None:
        return state, False

    starts = np.cumsum(sizes)
    total = int(starts[-1]) if len(starts) else 0
    meter.room(total, birth)
    starts -= sizes
    return written(state, replaced, gone, starts, total, moment, birth), True


def written(state, replaced, gone, starts, total, moment, birth):
    """The word of the modules that stay and of what replaces the others, each from its place on."""
    symbols = np.empty(total, dtype=state.symbols.dtype)
    columns = [np.zeros(total) for _ in state.columns]
    keys = None if state.keys is None else np.empty(total, dtype=np.uint64)
    births = None if state.births is None else np.full(total, birth, dtype=np.int32)
    fresh = None if state.fresh is None else np.ones(total, dtype=bool)

    stays = np.ones(len(state), dtype=bool) if gone is None else ~gone
    for _, site in replaced:
        stays[site.places] = False
    stays = np.flatnonzero(stays)
    to = starts[stays]
    symbols[to] = state.symbols[stays]
    for column, old in zip(columns, state.columns, strict=True):
        column[to] = old[stays]
    if keys is not None:
        keys[to] = state.keys[stays]
    if births is not None:
        births[to] = state.births[stays]
    if fresh is not None:
        fresh[to] = False

    for template, site in replaced:
        at = starts[site.places]
        put(symbols, at, np.array(template.symbols, dtype=symbols.dtype))
        for (place, column), value in template.fixed.items():
            columns[column][place:][at] = value
        for formula, targets in template.formulas:
            value = site.values(formula)
            if not sound(value):
                refuse(value, template.rule, told(template, *targets[0]), site, site.moment)
            for place, column in targets:
                columns[column][place:][at] = value
        if keys is not None:
            put_keys(keys, at, state.keys[site.places], template)
    return State(symbols, columns, keys, births, fresh, state.variables)


def put(array, cursor, row):
    """Write a row from each place on: its items at once, as overlapping windows of bytes."""
    if len(row) == 1:
        array[cursor] = row[0]
    elif len(cursor) and len(row):
        windows = np.ndarray((len(array) - len(row) + 1,), f"V{row.nbytes}", array, 0, (array.itemsize,))
        windows[cursor] = row.view(f"V{row.nbytes}")[0]


def put_keys(keys, cursor, parents, template):
    """Write the keys of a successor from each place on: place by place, or where it is long one successor at a time."""
    size = len(template.symbols)
    if size <= len(parents):
        for place in range(size):
            keys[place:][cursor] = template.child_keys(parents, place)
    else:
        for at, start in enumerate(cursor.tolist()):
            keys[start : start + size] = template.child_keys(parents[at : at + 1], slice(None))


def told(template, place, column):
    """Of which module of a successor a parameter is."""
    return f"parameter {column + 1} of {template.names[place]} in the successor"
