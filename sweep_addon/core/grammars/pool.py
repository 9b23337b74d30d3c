# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivations with contexts: a pool of modules that know their neighbours, so that none is ever searched for.

What contexts do not see, and brackets, are not in the pool at all, unless productions replace them. A production
leaves its predecessor's place in the pool to the last module that contexts see on the axis of its successor: what
pointed to the predecessor from the right stays true, and from the left at most one module points to it.
"""

import numpy as np

from .draws import root
from .matching import Site, finite, tried
from .modules import CLOSE, OPEN
from .stepping import told
from .tables import HIDDEN, SEEN

NONE = 0  # the number of no module
WIDEST = 64  # kinds of modules whose triples are looked up
MOST_TRIES = 300_000  # productions that are compared with pairs of neighbours before the first step


def suits(tables):
    """Whether the productions of a system leave all contexts to be known without a search."""
    every = (tables.common, *tables.groups.values())
    count = len(tables.symbols) + 1
    if tables.decomposition or tables.cut is not None or count > WIDEST:
        return False
    if sum(map(len, (choices for rules in every for choices in rules.choices.values()))) * count**2 > MOST_TRIES:
        return False
    return not any(rules.branches for rules in every) and all(
        plain(tables, symbol, choice)
        for rules in every
        for symbol, choices in rules.choices.items()
        for choice in choices
    )


def plain(tables, symbol, choice):
    """Whether productions keep the axis where they are seen on it, and off it where they are not."""
    if tables.kind[symbol] == SEEN:
        return all(Shape(template, tables).heir is not None for template in choice.templates)
    made = {symbol for template in choice.templates for symbol in template.symbols}
    return not choice.nodes and all(tables.kind[symbol] == HIDDEN for symbol in made)


class Shape:
    """Which modules of a successor are in the pool, and how they are linked.

    Attributes
    ----------
    heir : int or None
        The place that takes over the number of the predecessor.
    places : list of int
        The others that are in the pool.
    links : dict of int to (int or None, int or None)
        By place what is on the left and on the right: a place, -1 for the neighbour of the predecessor, None for none.
    first : int or None
        The first that is seen on the axis.
    """

    def __init__(self, template, tables):
        lives = tables.lives
        self.links, self.places, self.heir, self.first = {}, [], None, None
        outer, left, depth = [], -1, 0
        last = {0: None}  # the last seen module of each branch that is open, whose right is not known yet
        for place, symbol in enumerate(template.symbols):
            name = tables.symbols[symbol][0]
            if name == OPEN:
                outer.append(left)
                depth += 1
                last[depth] = None
            elif name == CLOSE:
                left, depth = outer.pop(), depth - 1
            elif tables.kind[symbol] == SEEN:
                self.links[place] = [left, -1 if depth == 0 else None]
                if last[depth] is not None:
                    self.links[last[depth]][1] = place
                left = last[depth] = place
                if depth == 0:
                    self.heir = place
                    self.first = place if self.first is None else self.first
                self.places.append(place)
            elif symbol in lives:
                self.places.append(place)
        self.others = [place for place in self.places if place != self.heir]


class Lookup:
    """What modules do by their own kind and those of their neighbours.

    Attributes
    ----------
    table : (s + 1, s + 1, s + 1) uint16 array
        By the kinds of the left neighbour, of the module and of the right one: the kind that it becomes, or from s + 1
        on which list of choices it tries.
    lists : list of list of (Choice, bool)
    """

    def __init__(self, rules, tables):
        count = len(tables.symbols) + 1
        self.none = count - 1
        self.table = np.empty((count, count, count), dtype=np.uint16)
        self.table[:] = np.arange(count, dtype=np.uint16)[None, :, None]
        self.lists, known = [], {}
        for symbol, choices in rules.choices.items():
            for left, right in np.ndindex(count, count):
                tries = self.tries(choices, left, right)
                if tries and self.renames(tables, symbol, tries[0]):
                    self.table[left, symbol, right] = tries[0][0].templates[0].symbols[0]
                elif tries:
                    key = tuple(id(choice) for choice, _ in tries)
                    if key not in known:
                        known[key] = count + len(self.lists)
                        self.lists.append(tries)
                    self.table[left, symbol, right] = known[key]

    def tries(self, choices, left, right):
        """What a module between two neighbours may take, in order, up to what it surely takes."""
        found = []
        for choice in choices:
            near = {link: symbol for origin, link, _, symbol in choice.nodes if origin == 0}
            if near.get("left", left) == left and near.get("right", right) == right:
                exact = len(choice.nodes) == len(near)
                found.append((choice, exact))
                if exact and choice.condition is None:
                    break
        return found

    @staticmethod
    def renames(tables, symbol, tried):
        """Whether all that a choice does is to make a module another, without parameters."""
        choice, exact = tried
        made = choice.templates[0].symbols
        return (
            exact and choice.always and choice.condition is None and len(made) == 1 and not tables.symbols[made[0]][1]
        )


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
    """

    def __init__(self, template, shape, nodes, values):
        self.template, self.shape, self.nodes, self.values = template, shape, nodes, values
        self.children, self.keys = {}, None

    @property
    def inherits(self):
        """Whether one of the successors has the number of the predecessor."""
        return self.shape.heir is not None and self.shape.heir not in self.children

    @property
    def size(self):
        return len(self.nodes)


class Pool:
    """The modules of a word that contexts see or productions replace.

    Attributes
    ----------
    symbols : (n,) uint8 array
        Their kinds; of what is no module, one that there is not.
    left, right : (n,) int array
        The numbers of their neighbours.
    columns : list of (n,) float64 array
    keys : (n,) uint64 array or None
    batches : list of Batch
    total : int
        How many modules the word has.
    """

    branch, root = (), 1

    def __init__(self, tables, seed, meter):
        self.tables, self.meter = tables, meter
        self.none = len(tables.symbols)
        self.count, self.shapes, self.lookups, self.batches = 2, {}, {}, []
        self.symbols = np.full(2, self.none, dtype=np.uint8)
        self.left, self.right = np.zeros(2, dtype=np.intp), np.zeros(2, dtype=np.intp)
        self.columns = [np.zeros(2) for _ in range(tables.columns)]
        self.keys = np.repeat(root(seed), 2) if tables.random else None
        self.total = len(tables.axiom.symbols)
        parameters = self.evaluated(tables.axiom, Site(self, [np.array([1])], 0))
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
        for symbol in np.unique(symbols[symbols != self.none]).tolist():
            nodes = np.flatnonzero(symbols == symbol)
            columns = [column[nodes] for column in self.columns[: self.tables.symbols[symbol][1]]]
            yield symbol, nodes, columns, None if self.keys is None else self.keys[nodes]

    def shape(self, template):
        if template not in self.shapes:
            self.shapes[template] = Shape(template, self.tables)
        return self.shapes[template]

    def evaluated(self, template, site):
        """The parameters of a successor, by place and column."""
        values = {(place, column): value for place, column, value in template.fixed}
        known = {}
        for place, column, formula in template.formulas:
            if formula.program not in known:
                found = site.values(formula, template.sources)
                known[formula.program] = finite(found, template.rule, told(template, place, column))
            values[place, column] = known[formula.program]
        return values

    def step(self, rules, generation, moment):
        """Replace all modules at once."""
        if rules not in self.lookups:
            self.lookups[rules] = Lookup(rules, self.tables)
        lookup = self.lookups[rules]
        symbols = self.symbols[: self.count]
        size = self.none + 1
        key = symbols[self.left[: self.count]].astype(np.uint32)
        key *= size
        key += symbols
        key *= size
        key += symbols[self.right[: self.count]]
        code = lookup.table.ravel()[key]
        busy = np.flatnonzero(code > self.none)
        changes, batches = [], []
        for number in np.unique(code[busy]).tolist():
            waiting = busy[code[busy] == number]
            for template, site in tried(self, waiting, lookup.lists[number - size], moment, self):
                values = self.evaluated(template, site)
                if len(template.symbols) == 1:
                    changes.append((site.rows[0], template.symbols[0], values))
                else:
                    batches.append(Batch(template, self.shape(template), site.rows[0], values))
        self.total += sum(len(batch.nodes) * (len(batch.template.symbols) - 1) for batch in batches)
        self.meter.room(self.total, generation)
        code[busy] = symbols[busy]
        self.symbols[: self.count] = code
        for nodes, symbol, values in changes:
            self.symbols[nodes] = symbol
            self.set_columns(nodes, 0, symbol, values)
        for batch in batches:
            self.replace(batch, heir=self.tables.kind[self.symbols[batch.nodes[0]]] == SEEN)

    def set_columns(self, nodes, place, symbol, values):
        for column in range(self.tables.symbols[symbol][1]):
            self.columns[column][nodes] = values[place, column]

    def reserve(self, count):
        """Make room for so many more modules."""
        if self.count + count > len(self.symbols):
            size = 2 * (self.count + count)
            grow = ["symbols", "left", "right", *(["keys"] if self.keys is not None else [])]
            for name in grow:
                setattr(self, name, np.resize(getattr(self, name), size))
            self.columns = [np.resize(column, size) for column in self.columns]

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
        numbers = {place: at if at is nodes else np.arange(at.start, at.stop) for place, at in where.items()}
        left, right = self.left[nodes], self.right[nodes]
        keys = batch.keys = None if self.keys is None else self.keys[nodes]
        if not heir:
            self.symbols[nodes] = self.none
            left, right = NONE, NONE
        elif shape.first != shape.heir:
            pointing = np.flatnonzero(self.right[left] == nodes)
            self.right[left[pointing]] = numbers[shape.first][pointing]
        for place, at in where.items():
            symbol = template.symbols[place]
            self.symbols[at] = symbol
            self.set_columns(at, place, symbol, batch.values)
            if keys is not None:
                self.keys[at] = template.child_keys(keys, place)
            before, after = shape.links.get(place, (None, None))
            self.left[at] = NONE if before is None else left if before == -1 else numbers[before]
            if not heir or place != shape.heir:  # whose right neighbour stays, and may have pointed to its successor
                self.right[at] = NONE if after is None else right if after == -1 else numbers[after]
        self.batches.append(batch)
