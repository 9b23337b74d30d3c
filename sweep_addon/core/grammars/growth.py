# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many modules a derivation will have, before any of them is made.

The numbers of modules of each kind in a word give those of the next one, by what each kind is replaced by: the growth
matrix (ABOP section 1.9). They are exact where every production is taken wherever its predecessor is, in whole numbers
of any size.
"""

from collections import Counter

LONGEST = 2000  # steps that are foretold: one takes a microsecond for each kind of modules
WIDEST = 1 << 4096  # beyond which a size is not counted on


def foretold(tables, generations):
    """The numbers of modules after each step.

    Parameters
    ----------
    tables : Tables
    generations : int

    Returns
    -------
    list of int or None
        From the axiom on; None where they hang on parameters, neighbours or chance. The list ends early where numbers
        go beyond 1,200 digits.

    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> foretold(LSystem.parse("axiom: A\\nA -> AB\\nB -> A").compiled, 8)
    [1, 2, 3, 5, 8, 13, 21, 34, 55]
    """
    if generations > LONGEST or not certain(tables):
        return None
    counts = Counter(tables.axiom.symbols)
    made = [counts.total()]
    growth = {}
    for step in range(1, generations + 1):
        rules = tables.of_step(step)
        if id(rules) not in growth:
            growth[id(rules)] = {
                symbol: Counter(choices[0].templates[0].symbols) for symbol, choices in rules.choices.items()
            }
        counts = after(counts, growth[id(rules)])
        made.append(counts.total())
        if made[-1] > WIDEST:
            break
    return made


def certain(tables):
    """Whether every module is replaced wherever it is, by its first production."""
    every = (tables.common, *tables.groups.values())
    plain = all(choices[0].certain for rules in every for choices in rules.choices.values())
    return plain and not tables.decomposition and tables.cut is None


def after(counts, growth):
    """The numbers of modules of each kind after a step."""
    found = Counter()
    for symbol, count in counts.items():
        for made, times in growth.get(symbol, {symbol: 1}).items():
            found[made] += count * times
    return found
