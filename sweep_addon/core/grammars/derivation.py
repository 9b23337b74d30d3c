# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Derivations: how a system gets from its axiom to a word, by the fastest way that its productions allow."""

from operator import index

from ..parameters import require
from . import doubling
from .budget import Budget, Meter
from .directives import LARGEST_SEED, MOST_GENERATIONS
from .draws import root
from .growth import foretold
from .reading import DEPTH
from .stepping import State, first, step
from .word import Word

DECOMPOSED = 1  # moments of the levels of a decomposition begin here; that of a production is 0
LEVELS = 512  # moments in each step
WAYS = {
    "doubling": "words are copied together from the words of their successors",
    "in order": "all modules of a word at once, step by step",
}


def derived(system, generations, seed, budget, progress):
    """The word of a system; `LSystem.derive` says of what."""
    generations = whole(generations, MOST_GENERATIONS, "generations")
    seed = whole(seed, LARGEST_SEED, "seed")
    tables = system.compiled
    meter = Meter(budget or Budget(), generations, tables.columns, progress)
    sizes = foretold(tables, generations)
    if sizes:
        meter.room(sizes[-1], None if len(sizes) > generations else len(sizes) - 1)
        meter.room(max(sizes), sizes.index(max(sizes)))
    if strategy(tables) == "doubling" and sizes:
        symbols = doubling.word(tables, generations)
        meter.tick(generations)
        return Word(tables, State(symbols, []), generations, seed)
    return Word(tables, in_order(tables, generations, seed, meter), generations, seed)


def whole(value, most, key):
    """A whole number from 0 to the most."""
    try:
        number = index(value)
    except TypeError:
        number = -1
    require(0 <= number <= most, f"must be a whole number from 0 to {most:,}", value, key)
    return number


def strategy(tables):
    """Which way suits a system: "doubling" or "in order"."""
    return "doubling" if doubling.suits(tables) else "in order"


def in_order(tables, generations, seed, meter):
    """The word, step by step."""
    for state in states(tables, generations, seed, meter):  # noqa: B007 the last one counts
        pass
    return state


def states(tables, generations, seed, meter):
    """The words of all generations, from that of the axiom on."""
    state = first(tables, root(seed))
    meter.room(len(state), 0)
    state = decomposed(state, tables, 0, meter)
    yield state
    for generation in range(1, generations + 1):
        rules = tables.of_step(generation)

        def room(total, generation=generation):
            meter.room(total, generation)

        state, _ = step(state, tables, rules, generation * LEVELS, generation, room)
        state = decomposed(state, tables, generation, meter)
        meter.tick(generation)
        yield state


def sizes(system, generations, seed, budget, progress):
    """The numbers of modules of all generations; `LSystem.sizes` says of what."""
    tables, generations = system.compiled, whole(generations, MOST_GENERATIONS, "generations")
    meter = Meter(budget or Budget(), generations, tables.columns, progress)
    found = foretold(tables, generations)
    if found and len(found) > generations:
        return found
    return [len(state) for state in states(tables, generations, whole(seed, LARGEST_SEED, "seed"), meter)]


def decomposed(state, tables, generation, meter):
    """The word whose modules are replaced by what they are made of."""
    if not tables.decomposition:
        return state
    depth = tables.system.decomposition_depth
    return repeated(state, tables, tables.decomposition, depth, generation, DECOMPOSED, meter, "decomposition")


def repeated(state, tables, rules, depth, generation, moment, meter, what):
    """The word after as many levels as productions apply, or as the depth allows."""
    for level in range(DEPTH + 1 if depth is None else depth):
        moments = generation * LEVELS + moment + level
        state, changed = step(state, tables, rules, moments, generation, lambda total: meter.room(total, generation))
        if not changed:
            break
        require(
            depth is not None or level < DEPTH,
            f"must end within {DEPTH} levels or say its maximum depth",
            level + 1,
            what,
        )
        meter.tick(generation)
    return state
