# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivations with contexts: a pool of modules that know their neighbours, so that none is ever searched for.

What contexts do not see, and brackets, are not in the pool at all, unless productions replace them. A production
leaves its predecessor's place in the pool to the last module that contexts see on the axis of its successor: what
pointed to the predecessor from the right stays true, and from the left at most one module points to it.
"""

from functools import lru_cache

import numpy as np

from .draws import root
from .linking import Lookup, Shape, holding
from .matching import Site, parted, refuse, sound, tried
from .stepping import told
from .tables import RECENT, SEEN

NONE = 0  # the number of no module


class Batch:
    """Modules that a production replaces in a step by several; or the axiom.

    Attributes
    ----------
    template : Template
    shape : Shape
    nodes : (m,) int array
        The numbers of the modules.
    children : dict of int to int
        The first number of those at each place that are new in the pool.
    values : dict of (int, int) to float or (m,) float array
        The parameters of what replaces them.
    keys : (m,) uint64 array or None
    inherits : bool
        Whether one of the successors has the number of the predecessor.
    """

    inherits = False

    def __init__(self, template, shape, nodes, values):
        self.template, self.shape, self.nodes, self.values = template, shape, nodes, values
        self.children, self.keys = {}, None

    @property
    def size(self):
        return len(self.nodes)


class Pool:
    """The modules of a word that contexts see or productions replace.

    Attributes
    ----------
    symbols : (n,) uint16 or uint32 array
        Their kinds; of what is no module, one that there is not.
    left, right : (n,) int array
        The numbers of their neighbours.
    columns : list of (n,) float64 array
    keys : (n,) uint64 array or None
    batches : list of Batch
    total : int
        How many modules the word has.
    """

    root = 1

    def __init__(self, tables, seed, meter):
        self.tables, self.meter = tables, meter
        self.none = len(tables.symbols)
        self.count, self.shapes, self.batches = 2, {}, []
        self.lookup = lru_cache(maxsize=RECENT)(lambda rules: Lookup(rules, tables))
        dtype = holding(self.none + 1)
        self.symbols = np.full(2, self.none, dtype)
        self.kinds = np.array(self.none + 1, dtype)  # an array, with which NumPy is quicker than with a number
        self.left, self.right = np.zeros(2, dtype=np.intp), np.zeros(2, dtype=np.intp)
        self.columns = [np.zeros(2) for _ in range(tables.columns)]
        self.keys = np.repeat(root(seed), 2) if tables.random else None
        self.total = len(tables.axiom.symbols)
        self.width = 48 + 16 * tables.columns + 16 * tables.random  # bytes of each, of which room is kept for as many
        parameters = self.evaluated(tables.axiom, Site(self, np.array([1]), 0))
        axiom = Batch(tables.axiom, self.shape(tables.axiom), np.array([1]), parameters)
        self.replace(axiom, heir=False)

    @property
    def ended(self):
        return self.symbols

    @property
    def nodes(self):
        """How many numbers are given."""
        return self.count

    def living(self):
        """Modules that are in the pool, by their kinds: their numbers, parameters and keys."""
        symbols = self.symbols[: self.count]
        for symbol in np.bincount(symbols, minlength=self.none)[: self.none].nonzero()[0].tolist():
            nodes = np.flatnonzero(symbols == symbol)
            columns = [column[nodes] for column in self.columns[: self.tables.symbols[symbol][1]]]
            yield symbol, nodes, columns, None if self.keys is None else self.keys[nodes]

    def shape(self, template):
        if template not in self.shapes:
            self.shapes[template] = Shape(template, self.tables)
        return self.shapes[template]

    def evaluated(self, template, site):
        """The parameters of a successor, by place and column."""
        values = dict(template.fixed)
        for formula, targets in template.changes:
            value = site.values(formula)
            if not (formula.copies or sound(value)):
                refuse(value, template.rule, told(template, *targets[0]), site, site.moment)
            values.update(dict.fromkeys(targets, value))
        return values

    def step(self, rules, generation, moment):
        """Replace all modules at once."""
        lookup = self.lookup(rules)
        key = self.key()
        changes, batches = [], []
        for template, site in self.taken(lookup, key, moment):
            values = self.evaluated(template, site)
            if len(template.symbols) == 1:
                changes.append((site.places, template.symbols[0], values))
            else:
                batches.append(Batch(template, self.shape(template), site.places, values))
        self.total += sum(len(batch.nodes) * (len(batch.template.symbols) - 1) for batch in batches)
        self.meter.room(self.total, generation)
        self.meter.nodes(self.count, self.width, generation)
        if lookup.becomes is not None:
            lookup.becomes.take(key, None, self.symbols[: self.count], "clip")
        for nodes, symbol, values in changes:
            self.symbols[nodes] = symbol
            for (_, column), value in values.items():
                self.columns[column][nodes] = value
        for batch in batches:
            self.replace(batch, heir=self.tables.kind[self.symbols[batch.nodes[0]]] == SEEN)

    def key(self):
        """(n,) int array: the kinds of the left neighbour of each module, its own and that of the right one."""
        symbols = self.symbols[: self.count]
        key = symbols.take(self.left[: self.count])
        key *= self.kinds
        key += symbols
        key *= self.kinds
        key += symbols.take(self.right[: self.count])
        return key.astype(np.intp)

    def taken(self, lookup, key, moment):
        """The productions that modules take, each with these."""
        check = self.meter.check
        for number, nodes in parted(lookup.trials.take(key), lookup.every):
            trial = lookup.every[number]
            left = yield from tried(Site(self, nodes, moment, self), trial.choices, check)
            if left and trial.rest:
                for number, chosen in parted(lookup.lists.take(key.take(left.places)), trial.rest):
                    yield from tried(left.keep(chosen), trial.rest[number], check)

    def set_columns(self, nodes, place, symbol, values):
        for column in range(self.tables.symbols[symbol][1]):
            self.columns[column][nodes] = values[place, column]

    def reserve(self, count):
        """Make room for so many more modules."""
        if self.count + count > len(self.symbols):
            size = 2 * (self.count + count)
            for name in ("symbols", "left", "right", *(["keys"] if self.keys is not None else [])):
                setattr(self, name, longer(getattr(self, name), size))
            self.columns = [longer(column, size) for column in self.columns]

    def replace(self, batch, heir):
        """Put the successor of modules into the pool."""
        shape, template, nodes, m = batch.shape, batch.template, batch.nodes, len(batch.nodes)
        fresh = shape.others if heir else shape.places
        self.reserve(m * len(fresh))
        where = {shape.heir: nodes} if heir else {}
        for place in fresh:
            batch.children[place] = self.count
            where[place] = slice(self.count, self.count + m)
            self.count += m
        keys = batch.keys = None if self.keys is None else self.keys[nodes]
        if not heir:
            self.symbols[nodes] = self.none
        for place, at in where.items():
            symbol = template.symbols[place]
            self.symbols[at] = symbol
            self.set_columns(at, place, symbol, batch.values)
            if keys is not None:
                self.keys[at] = template.child_keys(keys, place)
        if not (heir and shape.alone):
            self.link(shape, nodes, where, heir)
        batch.inherits = heir
        self.batches.append(batch)

    def link(self, shape, nodes, where, heir):
        """Let modules that are new in the pool, and those beside them, know their neighbours."""
        numbers = {place: at if at is nodes else np.arange(at.start, at.stop) for place, at in where.items()}
        left, right = (self.left[nodes], self.right[nodes]) if heir else (NONE, NONE)
        if heir and shape.first != shape.heir:
            pointing = np.flatnonzero(self.right[left] == nodes)
            self.right[left[pointing]] = numbers[shape.first][pointing]
        for place, (before, after) in shape.links.items():
            at = where[place]
            self.left[at] = NONE if before is None else left if before == -1 else numbers[before]
            if not heir or place != shape.heir:  # whose right neighbour stays, and may have pointed to its successor
                self.right[at] = NONE if after is None else right if after == -1 else numbers[after]


def longer(array, size):
    """An array with room for more: zeros."""
    found = np.zeros(size, dtype=array.dtype)
    found[: len(array)] = array
    return found
