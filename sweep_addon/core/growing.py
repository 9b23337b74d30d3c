# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Growing: from the parameters of a plant to its mesh; what the last one needed is kept for the next."""

from dataclasses import replace
from functools import lru_cache

from .grammar_text import Values
from .grammars import Budget, GrammarError, LSystem
from .grammars.tubes import mesh as drawn
from .grammars.turtle import Walk

NONE = Values()


@lru_cache(maxsize=64)
def read(text, constants=NONE):
    """The system of a text, with values for some of its constants."""
    return LSystem.parse(str(text), dict(constants))


def problems(text):
    """What is wrong in a text, line by line: a tuple of Problem."""
    try:
        read(text)
    except GrammarError as refusal:
        return refusal.problems
    return ()


def free(text):
    """The constants of a text that need no others, by name: those that people may turn at will."""
    return {constant.name: constant for constant in read(text).constants if not constant.formula.names}


def other(text, constants):
    """Those of some values that are not what the text says anyway."""
    plain = {name: constant.value for name, constant in free(text).items()}
    order = [constant.name for constant in read(text).constants]
    return Values({name: constants[name] for name in order if name in constants and plain.get(name) != constants[name]})


def system(plant):
    """The system of a plant, with the plant's own numbers."""
    found = read(plant.system, plant.constants)
    own = {name: getattr(plant, name) for name in ("angle", "step", "width")}
    return replace(found, **own) if any(getattr(found, name) != value for name, value in own.items()) else found


@lru_cache(maxsize=1)
def word(text, constants, generations, seed, budget):
    """The word of a system, for which its numbers alone count that are about modules."""
    return read(text, constants).derive(generations, seed, Budget(modules=budget))


@lru_cache(maxsize=1)
def figure(text, constants, generations, seed, budget, system, upright):
    """What the turtle of a system draws of the word of a text."""
    told = word(text, constants, generations, seed, budget).interpreted(Budget(modules=budget))
    return Walk(told, upright, system).figure()


def mesh(plant, dtype):
    """The mesh of a plant; `Plant.mesh` says of what."""
    asked = plant.system, plant.constants, plant.generations, plant.seed, plant.budget
    found = figure(*asked, system(plant), plant.upright.upright)
    return drawn(found, getattr(plant.output, "sides", 0), plant.texture, plant.attributes, dtype)
