# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From modules that lived to the word: how much room each takes, where that begins, and everything written once.

A forest and a pool are laid out alike: both have batches of modules that productions replace, in whose successors some
live on under numbers of their own, and all else is written here for the first time.
"""

import numpy as np

from .stepping import State, put


def word(growth, births):
    """The word of a forest or a pool as a State.

    Parameters
    ----------
    growth : Forest or Pool
    births : callable
        What finds the step that made each module of it.
    """
    sizes = room(growth)
    total = int(sizes[growth.root])
    state = State(
        np.empty(total, dtype=growth.tables.dtype),
        [np.zeros(total) for _ in range(growth.tables.columns)],
        np.empty(total, dtype=np.uint64) if growth.tables.homomorphism.random else None,
        births,
    )
    begins = np.zeros(growth.nodes, dtype=np.intp)
    for batch in growth.batches:
        for place, stop, cursor in runs(batch, begins, sizes):
            write(batch, place, stop, cursor, state)
    for symbol, nodes, columns, keys in growth.living():
        at = begins[nodes]
        state.symbols[at] = symbol
        for column, value in zip(state.columns, columns, strict=False):
            column[at] = value
        if state.keys is not None:
            state.keys[at] = keys
    return state


def births(forest):
    """(n,) int array: the step that made each module of the word of a forest."""
    sizes = room(forest)
    found, begins = np.empty(int(sizes[forest.root]), dtype=np.int32), np.zeros(forest.nodes, dtype=np.intp)
    for batch in forest.batches:
        for place, stop, cursor in runs(batch, begins, sizes):
            put(found, cursor, np.full(stop - place, batch.step, dtype=np.int32))
    for chunks in forest.population.values():
        for chunk in chunks:
            found[begins[chunk.nodes]] = chunk.birth
    return found


def room(growth):
    """(n,) int array: how many modules of the last word grew out of each number."""
    sizes = np.ones(growth.nodes, dtype=np.intp)
    for batch in reversed(growth.batches):
        sizes[batch.nodes] = beside(batch, sizes) + (sizes[batch.nodes] if batch.inherits else 0)
    return sizes


def beside(batch, sizes):
    """How many modules a successor becomes, without what has the number of its predecessor."""
    total = len(batch.template.symbols) - len(batch.children) - batch.inherits
    for first in batch.children.values():
        total = total + sizes[first : first + batch.size]
    return total


def runs(batch, begins, sizes):
    """Note where modules of a batch begin that live on.

    Yields
    ------
    int, int
        From which place of the successor on to which others stand in a row that do not.
    (m,) int array
        Where in the word that row begins, for each module that is replaced.
    """
    cursor, place = begins[batch.nodes], 0
    cursor = cursor.copy() if isinstance(batch.nodes, slice) else cursor  # which goes on in place, module by module
    follows = {child: slice(first, first + batch.size) for child, first in batch.children.items()}
    if batch.inherits:
        sizes[batch.nodes] -= beside(batch, sizes)
        follows[batch.shape.heir] = batch.nodes
    for child in (*sorted(follows), len(batch.template.symbols)):
        if place < child:
            yield place, child, cursor
            cursor += child - place
        if child in follows:
            begins[follows[child]] = cursor
            cursor += sizes[follows[child]]
        place = child + 1


def write(batch, place, stop, cursor, state):
    """Write the modules of a successor that stand in a row."""
    put(state.symbols, cursor, np.array(batch.template.symbols[place:stop], dtype=state.symbols.dtype))
    for (at, column), value in batch.values.items():
        if place <= at < stop:
            state.columns[column][at - place :][cursor] = value
    if state.keys is not None:
        for at in range(place, stop):
            state.keys[at - place :][cursor] = batch.template.child_keys(batch.keys, at)
