# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From a forest to the word: how much room each module takes, where that begins, and everything written once."""

import numpy as np

from .stepping import State


def word(forest):
    """The word of a forest as a State."""
    sizes = room(forest)
    total = int(sizes[0])
    state = State(
        np.empty(total, dtype=forest.tables.dtype),
        [np.zeros(total) for _ in range(forest.tables.columns)],
        np.empty(total, dtype=np.uint64) if forest.tables.homomorphism.random else None,
        lambda: births(forest),
    )
    begins = np.empty(forest.nodes, dtype=np.intp)
    begins[0] = 0
    for batch in forest.batches:
        for place, stop, cursor in runs(batch, begins, sizes):
            write(batch, place, stop, cursor, state)
    for symbol, chunk in living(forest):
        at = begins[chunk.nodes]
        state.symbols[at] = symbol
        for column, value in zip(state.columns, chunk.columns, strict=False):
            column[at] = value
        if state.keys is not None:
            state.keys[at] = chunk.keys
    return state


def births(forest):
    """(n,) int array: the step that made each module of that word."""
    sizes = room(forest)
    found, begins = np.empty(int(sizes[0]), dtype=np.int32), np.zeros(forest.nodes, dtype=np.intp)
    for batch in forest.batches:
        for place, stop, cursor in runs(batch, begins, sizes):
            put(found, cursor, np.full(stop - place, batch.step, dtype=np.int32))
    for _, chunk in living(forest):
        found[begins[chunk.nodes]] = chunk.birth
    return found


def living(forest):
    """The chunks of modules that live, each with their kind."""
    return ((symbol, chunk) for symbol, chunks in forest.population.items() for chunk in chunks)


def room(forest):
    """(n,) int array: how many modules of the last word grew out of each module that lived."""
    sizes = np.ones(forest.nodes, dtype=np.intp)
    for batch in reversed(forest.batches):
        total = len(batch.template.symbols) - len(batch.children)
        for first in batch.children.values():
            total = total + sizes[first : first + batch.chunk.size]
        sizes[batch.chunk.nodes] = total
    return sizes


def runs(batch, begins, sizes):
    """Note where modules of a batch begin that live on.

    Yields
    ------
    int, int
        From which place of the successor on to which others stand in a row that do not.
    (m,) int array
        Where in the word that row begins, for each module that is replaced.
    """
    count, m = len(batch.template.symbols), batch.chunk.size
    cursor, place = begins[batch.chunk.nodes], 0
    for child, first in (*sorted(batch.children.items()), (count, None)):
        if place < child:
            yield place, child, cursor
            cursor = cursor + (child - place)
        if first is not None:
            begins[first : first + m] = cursor
            cursor = cursor + sizes[first : first + m]
        place = child + 1


def write(batch, place, stop, cursor, state):
    """Write the modules of a successor that stand in a row."""
    put(state.symbols, cursor, np.array(batch.template.symbols[place:stop], dtype=state.symbols.dtype))
    for (at, column), value in batch.values.items():
        if place <= at < stop:
            state.columns[column][at - place :][cursor] = value
    if state.keys is not None:
        for at in range(place, stop):
            state.keys[at - place :][cursor] = batch.template.child_keys(batch.chunk.keys, at)


def put(array, cursor, row):
    """Write a row from each place on: its items at once, as overlapping windows of bytes."""
    if len(cursor):
        windows = np.ndarray((len(array) - len(row) + 1,), f"V{row.nbytes}", array, 0, (array.itemsize,))
        windows[cursor] = row.view(f"V{row.nbytes}")[0]
