# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The interpretation of a word: what its modules stand for, told to a turtle and never derived further."""

from . import derivation
from .budget import Budget, Meter
from .stepping import State
from .word import Word

INTERPRETED = 256  # where moments of the levels of a homomorphism begin, in each step


def interpreted(word, budget, progress):
    """The word in whose modules' place stands what the homomorphism says; `Word.interpreted` says of what."""
    tables = word.tables
    if not tables.homomorphism:
        return word
    meter = Meter(budget or Budget(), word.generations, tables.columns, progress)
    state = derivation.repeated(
        State(word.symbols, word.columns, word.state.keys, word.births),
        tables,
        tables.homomorphism,
        tables.system.homomorphism_depth,
        word.generations,
        INTERPRETED,
        meter,
        "homomorphism",
    )
    return Word(tables, state, word.generations, word.seed)
