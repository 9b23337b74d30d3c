# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivations without contexts: a forest of modules, of which only those live that a production may replace.

The word is not rewritten. A batch notes which modules a production replaces in a step, and where in its successor
others stand that live on; how much room each takes in the last word is added up backwards, and where it begins
forwards. So each module of the word is written once, and what nothing replaces costs nothing until then: so does all
that the last step makes, which is most of a word.
"""

import numpy as np

from .chunks import Chunk, merged
from .draws import drawn, even, mix, root
from .matching import answer, refuse, sound
from .stepping import told

MOST_CHUNKS = 32  # of a kind, before they are made one


class Batch:
    """Modules that a production replaces in a step.

    Attributes
    ----------
    template : Template
    chunk : Chunk
        The modules.
    step : int
    values : dict of (int, int) to float or (m,) float array
        The parameters of what replaces them, by place and column.
    children : dict of int to int
        The number of the first module that lives on, by place.
    """

    def __init__(self, template, chunk, step):
        self.template, self.chunk, self.step, self.values, self.children = template, chunk, step, {}, {}

    inherits = False

    @property
    def nodes(self):
        return self.chunk.nodes

    @property
    def size(self):
        return self.chunk.size

    @property
    def keys(self):
        return self.chunk.keys

    def evaluate(self, moment):
        """Find the parameters of what replaces the modules."""
        template, chunk = self.template, self.chunk
        self.values = dict(template.fixed)
        for formula, targets in template.formulas:
            value = chunk.values(formula, moment)
            if not (formula.copies or sound(value)):
                refuse(value, template.rule, told(template, *targets[0]), chunk, moment)
            self.values.update(dict.fromkeys(targets, value))

    def parameters(self, place, count):
        return [self.values[place, column] for column in range(count)]


class Forest:
    """The modules of a derivation that live, and the batches of those that did.

    Parameters
    ----------
    tables : Tables
    seed : int
    meter : Meter
    """

    def __init__(self, tables, seed, meter):
        self.tables, self.meter = tables, meter
        self.arity = [count for _, count in tables.symbols]
        self.lives = tables.lives
        self.population = {symbol: [] for symbol in self.lives}
        self.batches, self.nodes, self.total = [], 1, len(tables.axiom.symbols)
        self.width = 16 + 8 * tables.columns + 8 * tables.random  # bytes of each: its room and place, what it holds
        axiom = Batch(tables.axiom, Chunk(slice(0, 1), 1, [], 0, root(seed) if tables.random else None), 0)
        self.grow([axiom], 0, last=not meter.generations)

    root = 0

    def living(self):
        """Modules that live, by their kinds: their numbers, parameters and keys."""
        for symbol, chunks in self.population.items():
            yield from ((symbol, chunk.nodes, chunk.columns, chunk.keys) for chunk in chunks)

    def step(self, rules, generation, moment):
        """Replace all modules that live."""
        before, self.population = self.population, {symbol: [] for symbol in self.lives}
        batches = []
        for symbol, chunks in before.items():
            for chunk in chunks:
                self.meter.check()
                for template, part in taken(chunk, rules.choices.get(symbol, ()), moment):
                    if template is None:
                        self.population[symbol].append(part)
                    elif len(template.symbols) == 1 and template.symbols[0] in self.lives:
                        self.renew(template, part, generation, moment)
                    else:
                        batches.append(Batch(template, part, generation))
        self.total += sum(batch.chunk.size * (len(batch.template.symbols) - 1) for batch in batches)
        self.meter.room(self.total, generation)
        self.meter.nodes(self.nodes, self.width, generation)
        self.grow(batches, moment, last=generation == self.meter.generations)
        for symbol, chunks in self.population.items():
            if len(chunks) > MOST_CHUNKS:
                self.population[symbol] = [merged(chunks)]

    def renew(self, template, chunk, generation, moment):
        """Make modules another, each for one."""
        batch = Batch(template, chunk, generation)
        batch.evaluate(moment)
        symbol = template.symbols[0]
        columns = batch.parameters(0, self.arity[symbol])
        self.population[symbol].append(Chunk(chunk.nodes, chunk.size, columns, generation, chunk.keys))

    def grow(self, batches, moment, last):
        """Let what replaces the modules of batches follow; after the last step none of it needs to live."""
        for batch in batches:
            batch.evaluate(moment)
        self.batches += batches
        followers = {}
        for batch in [] if last else batches:
            for place, symbol in enumerate(batch.template.symbols):
                if symbol in self.lives:
                    followers.setdefault(symbol, []).append((batch, place))
        for symbol, slots in followers.items():
            self.population[symbol].append(self.born(symbol, slots))

    def born(self, symbol, slots):
        """The modules of a kind at some places of batches, which get numbers in a row."""
        parts, first = [], self.nodes
        for batch, place in slots:
            batch.children[place] = self.nodes
            nodes = slice(self.nodes, self.nodes + batch.chunk.size)
            columns = batch.parameters(place, self.arity[symbol])
            parts.append(Chunk(nodes, batch.chunk.size, columns, batch.step, None))
            self.nodes = nodes.stop
        chunk = merged(parts, slice(first, self.nodes)) if len(parts) > 1 else parts[0]
        if self.tables.random:
            chunk.keys = np.empty(chunk.size, dtype=np.uint64)
            for (batch, place), part in zip(slots, parts, strict=True):
                own = slice(part.nodes.start - first, part.nodes.stop - first)
                np.add(batch.chunk.keys, batch.template.salts[place], out=chunk.keys[own])
            mix(chunk.keys)
        return chunk


def taken(chunk, choices, moment):
    """The productions that modules of a chunk take, each with those; and None with those that stay."""
    for choice in choices:
        if choice.condition is not None:
            value = chunk.values(choice.condition, moment, asking=True)
            matching, chunk = chunk.parted(answer(value, choice, chunk, moment))
        else:
            matching, chunk = chunk, None
        if matching is not None and choice.always:
            yield choice.templates[0], matching
        elif matching is not None:
            which = drawn(choice.bounds, even(matching.keys, moment, 0))
            rest = () if choice.bounds[-1] == 1 else (None,)
            for number, template in enumerate((*choice.templates, *rest)):
                chosen = (which == number).nonzero()[0]
                if chosen.size:
                    yield template, matching.part(chosen)
        if chunk is None:
            return
    yield None, chunk
