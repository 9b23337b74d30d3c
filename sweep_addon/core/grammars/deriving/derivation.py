# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivations: how a system gets from its axiom to a word, by the fastest way that its productions allow."""

from collections import deque
from operator import index

import numpy as np

from ...declared.parameters import require
from ..text.directives import LARGEST_SEED, MOST_GENERATIONS
from ..text.reading import DEPTH
from ..word import Word
from . import doubling, layout, linking
from .budget import Budget, Meter
from .draws import LEVELS, root
from .forest import Forest
from .growth import fewest, foretold
from .pool import Pool
from .statements import executed
from .stepping import State, first, step

DECOMPOSED = 1  # moments of the levels of a decomposition begin here; that of a production is 0
INTERPRETED = 256  # those of a homomorphism
LONG = 2000  # modules of a successor, each of which a forest or a pool would look at by itself
WAYS = {
    "doubling": "words are copied together from the words of their successors",
    "forest": "modules grow as a forest that is laid out once",
    "pool": "modules know their neighbours in a pool, and are laid out once",
    "in order": "all modules of a word at once, step by step",
}


def derived(system, generations, seed, budget, progress, environment=None):
    """The word of a system; `LSystem.derive` says of what."""
    require(environment is None or callable(environment), "must be a function", environment, "environment")
    generations = whole(generations, MOST_GENERATIONS, "generations")
    seed = whole(seed, LARGEST_SEED, "seed")
    tables = system.compiled
    meter = Meter(budget or Budget(), generations, tables.columns, progress)
    sizes = foretold(tables, generations)
    if sizes:
        meter.room(sizes[-1], None if len(sizes) > generations else len(sizes) - 1)
        meter.room(max(sizes), sizes.index(max(sizes)))
    elif (least := fewest(tables, generations)) is not None:
        meter.room(least, least=True)
    way = strategy(tables)
    if way == "doubling" and sizes:
        symbols = doubling.word(tables, generations, meter.check)
        meter.tick(generations)
        state = State(symbols, [], None, lambda: doubling.births(tables, generations, again(meter).check))
    elif way in ("forest", "doubling"):
        forest, _ = grown(Forest, tables, generations, seed, meter)
        state = layout.word(forest, lambda: layout.births(forest))
    elif way == "pool":
        linked, _ = grown(Pool, tables, generations, seed, meter)
        state = layout.word(linked, lambda: in_order(tables, generations, seed, again(meter)).births)
    else:
        state = in_order(tables, generations, seed, meter, environment)
    return Word(tables, state, generations, seed)


def again(meter):
    """A meter of the same budget, for what is found when somebody asks for it."""
    return Meter(meter.budget, meter.generations, meter.columns, None)


def whole(value, most, key):
    """A whole number from 0 to the most."""
    try:
        number = index(value)
    except TypeError:
        number = -1
    require(0 <= number <= most, f"must be a whole number from 0 to {most:,}", value, key)
    return number


def strategy(tables):
    """Which of the ways suits a system."""
    if tables.queries or tables.variables or tables.nested:
        return "in order"
    if doubling.suits(tables):
        return "doubling"
    if tables.longest > LONG:
        return "in order"
    every = (tables.common, *tables.groups.values())
    alone = not tables.decomposition and tables.cut is None and not any(rules.context for rules in every)
    return "forest" if alone else "pool" if linking.suits(tables) else "in order"


def grown(kind, tables, generations, seed, meter):
    """The forest or the pool after all generations, and how many modules the word had after each."""
    with np.errstate(all="ignore"):
        growth = kind(tables, seed, meter)
        meter.room(growth.total, 0)
        totals = [growth.total]
        for generation in range(1, generations + 1):
            growth.step(tables.of_step(generation), generation, generation * LEVELS)
            meter.tick(generation)
            totals.append(growth.total)
    return growth, totals


def in_order(tables, generations, seed, meter, environment=None):
    """The last word, step by step."""
    (state,) = deque(states(tables, generations, seed, meter, environment), maxlen=1)
    return state


def states(tables, generations, seed, meter, environment=None):
    """The words of all generations, from that of the axiom on."""
    variables = dict.fromkeys(tables.variables, 0.0)
    variables = executed(tables.system, "start", variables, 0, 0, seed)
    state = first(tables, root(seed), variables)
    meter.room(len(state), 0)
    state = finished(decomposed(state, tables, 0, meter), tables, 0, seed, meter, environment)
    yield state
    for generation in range(1, generations + 1):
        moment = generation * LEVELS
        state.variables = executed(tables.system, "start_each", state.variables, generation, moment, seed)
        rules = tables.of_step(generation)
        systems = tables.systems if tables.nested else None
        with np.errstate(all="ignore"):
            state, _ = step(state, tables, rules, moment, generation, meter, systems=systems)
        state = decomposed(state, tables, generation, meter)
        for block in ("end_each", "end")[: 2 if generation == generations else 1]:
            state.variables = executed(tables.system, block, state.variables, generation, moment, seed)
        state = finished(state, tables, generation, seed, meter, environment)
        meter.tick(generation)
        yield state


def sizes(system, generations, seed, budget, progress):
    """The numbers of modules of all generations; `LSystem.sizes` says of what."""
    tables, generations = system.compiled, whole(generations, MOST_GENERATIONS, "generations")
    meter = Meter(budget or Budget(), generations, tables.columns, progress)
    found = foretold(tables, generations)
    if found and len(found) > generations:
        return found
    seed = whole(seed, LARGEST_SEED, "seed")
    if strategy(tables) == "in order":
        return [len(state) for state in states(tables, generations, seed, meter)]
    kind = Pool if strategy(tables) == "pool" else Forest
    return grown(kind, tables, generations, seed, meter)[1]


def finished(state, tables, generation, seed, meter, environment):
    """A word with the answers to its queries."""
    if not tables.queries:
        return state
    from .queries import answered  # which interprets words, by what is below

    return answered(state, tables, generation, seed, meter, environment)


def homomorphic(state, tables, generation, meter):
    """The word in whose modules' place stands what the homomorphism says."""
    if not tables.homomorphism:
        return state
    depth = tables.system.homomorphism_depth
    return repeated(state, tables, tables.homomorphism, depth, generation, INTERPRETED, meter, "homomorphism")


def decomposed(state, tables, generation, meter):
    """The word whose modules are replaced by what they are made of."""
    if not tables.decomposition:
        return state
    depth = tables.system.decomposition_depth
    return repeated(state, tables, tables.decomposition, depth, generation, DECOMPOSED, meter, "decomposition")


def repeated(state, tables, rules, depth, generation, moment, meter, what):
    """The word after as many levels as productions apply to what the last one made, or as the depth allows."""
    fresh = np.ones(len(state), dtype=bool)
    state = State(state.symbols, state.columns, state.keys, state.births, fresh, state.variables)
    for level in range(DEPTH + 1 if depth is None else depth):
        moments = generation * LEVELS + moment + level
        with np.errstate(all="ignore"):
            state, changed = step(state, tables, rules, moments, generation, meter, cutting=False)
        if not changed:
            break
        ends = depth is not None or level < DEPTH
        require(ends, f"must end within {DEPTH} levels or say its maximum depth", level + 1, what)
        meter.tick(generation)
    return State(state.symbols, state.columns, state.keys, state.births, variables=state.variables)
