# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Words of grammars in which every module is always replaced by the same others: D0L-systems.

The word of a module after k steps is that of its successors after k - 1, one behind the other, so each word is copied
together from a few long pieces and no module is ever looked at.
"""

import numpy as np

MOST_BIRTHS = 255  # steps that fit a byte


def suits(tables):
    """Whether a system is one, with modules that fit a byte."""
    every = [choices[0] for choices in tables.common.choices.values()]
    plain = not tables.groups and not tables.decomposition and tables.cut is None and not tables.columns
    return plain and not tables.random and tables.dtype == np.uint8 and all(choice.certain for choice in every)


def successors(tables):
    """The modules that replace each kind of module, itself where nothing does."""
    found = {symbol: [symbol] for symbol in range(len(tables.symbols))}
    for symbol, choices in tables.common.choices.items():
        found[symbol] = choices[0].templates[0].symbols
    return found


def word(tables, generations, check):
    """(n,) uint8 array: the word after so many steps; ``check`` is called before each and may refuse to go on.

    >>> from sweep_addon.core.grammars import LSystem
    >>> word(LSystem.parse("axiom: A\\nA -> AB\\nB -> A").compiled, 4, lambda: None).tolist()
    [0, 1, 0, 0, 1, 0, 1, 0]
    """
    return joined(tables, generations, check, lambda symbol: bytes([symbol]), lambda pieces: b"".join(pieces))


def births(tables, generations, check):
    """(n,) uint8 array: the step that made each module of that word.

    A piece knows births as if its module were made at step 0; where it is copied it is one step older. A module that
    nothing replaces stays as it was made.
    """
    later = bytes(min(step + 1, MOST_BIRTHS) for step in range(256))

    def older(pieces):
        return b"".join(pieces).translate(later)

    steps = min(generations, MOST_BIRTHS)
    return joined(tables, steps, check, lambda symbol: b"\0", older, tables.common.choices.keys())


def joined(tables, generations, check, first, join, replaced=None):
    """The pieces of the axiom: those of a module join the pieces of its successors; those of what stays are kept."""
    after = successors(tables)
    kinds = {symbol: set(made) for symbol, made in after.items()}
    needed = [set(tables.axiom.symbols)]
    for _ in range(generations):
        needed.append(set().union(*(kinds[symbol] for symbol in needed[-1])))
    words = {symbol: first(symbol) for symbol in needed[-1]}
    for symbols in reversed(needed[:-1]):
        check()
        becoming = symbols if replaced is None else symbols & replaced
        words = {symbol: words[symbol] for symbol in symbols - becoming} | {
            symbol: join([words[child] for child in after[symbol]]) for symbol in becoming
        }
    return np.frombuffer(b"".join([words[symbol] for symbol in tables.axiom.symbols]), dtype=np.uint8)
