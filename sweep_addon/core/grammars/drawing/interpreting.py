# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The interpretation of a word: what its modules stand for, told to a turtle and never derived further."""

from ..deriving.budget import Budget, Meter
from ..deriving.derivation import homomorphic
from ..deriving.stepping import State
from ..word import Word


def interpreted(word, budget, progress):
    """The word in whose modules' place stands what the homomorphism says; `Word.interpreted` says of what."""
    tables = word.tables
    if not tables.homomorphism:
        return word
    meter = Meter(budget or Budget(), word.generations, tables.columns, progress)
    state = State(word.symbols, word.columns, word.state.keys, word.births, variables=word.state.variables)
    return Word(tables, homomorphic(state, tables, word.generations, meter), word.generations, word.seed)
