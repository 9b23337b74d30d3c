# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chunks: modules of one kind that are replaced together, in whatever order."""

import numpy as np

from ...formulas.expressions import DRAW
from .draws import even


class Chunk:
    """Modules of one kind.

    Attributes
    ----------
    nodes : slice or (m,) int array
        Their numbers in the forest.
    size : int
        How many there are.
    columns : list of float or (m,) float array
        Their parameters; a number where it is the same for all.
    birth : int or (m,) int array
        The step that made them.
    keys : (m,) uint64 array or None
        What their random numbers hang on.
    """

    def __init__(self, nodes, size, columns, birth, keys):
        self.nodes, self.size, self.columns, self.birth, self.keys = nodes, size, columns, birth, keys

    def values(self, formula, moment, asking=False):
        """The value of a formula of their parameters: a number where it is the same for all."""

        def find(source, part):
            if isinstance(source, tuple):
                column = self.columns[source[1]]
                return column[part] if np.ndim(column) else column
            return even(self.keys[part], moment, 1 + int(source.removeprefix(DRAW)))

        return formula.of(find, self.size, asking)

    def parameter(self, column, place):
        """A parameter of one of them."""
        values = self.columns[column]
        return values[place] if np.ndim(values) else values

    def part(self, chosen):
        """Those at some places."""
        columns = [column[chosen] if np.ndim(column) else column for column in self.columns]
        birth = self.birth[chosen] if np.ndim(self.birth) else self.birth
        nodes = self.nodes.start + chosen if isinstance(self.nodes, slice) else self.nodes[chosen]
        return Chunk(nodes, len(chosen), columns, birth, None if self.keys is None else self.keys[chosen])

    def parted(self, holds):
        """Those for which something holds, and the others; None instead of no modules."""
        if not np.ndim(holds):
            return (self, None) if holds else (None, self)
        yes = np.flatnonzero(holds)
        if len(yes) in (0, self.size):
            return (self, None) if len(yes) else (None, self)
        return self.part(yes), self.part(np.flatnonzero(~holds))

    def numbers(self):
        """(m,) int array: their numbers in the forest."""
        return np.arange(self.nodes.start, self.nodes.stop) if isinstance(self.nodes, slice) else self.nodes


def merged(chunks, nodes=None):
    """One chunk of all modules of some, whose numbers may be known to be in a row."""
    columns = [spread([chunk.columns[k] for chunk in chunks], chunks) for k in range(len(chunks[0].columns))]
    keys = None if chunks[0].keys is None else np.concatenate([chunk.keys for chunk in chunks])
    nodes = np.concatenate([chunk.numbers() for chunk in chunks]) if nodes is None else nodes
    return Chunk(
        nodes, sum(chunk.size for chunk in chunks), columns, spread([chunk.birth for chunk in chunks], chunks), keys
    )


def spread(values, chunks):
    """Values of chunks as one array; or as a number where all are the same one."""
    if not any(map(np.ndim, values)) and len(set(values)) == 1:
        return values[0]
    sizes = [chunk.size for chunk in chunks]
    return np.concatenate([np.broadcast_to(value, size) for value, size in zip(values, sizes, strict=True)])
