# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many modules a derivation will have, before any of them is made.

The numbers of modules of each kind in a word give those of the next one, by what each kind is replaced by: the growth
matrix (ABOP section 1.9). They are exact where every production is taken wherever its predecessor is, in whole numbers
of any size.
"""

from collections import Counter
from functools import reduce
from operator import and_, or_

LONGEST = 2000  # steps that are foretold
WIDEST = 1 << 4096  # beyond which a size is not counted on
QUICK = 16  # modules of a successor that are counted in the time that one number is added up
MOST_WORK = 500_000  # numbers that are added up for it: some take half a microsecond, so that nobody waits


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
    return grown(tables, generations, surely) if certain(tables) else None


def bounds(tables, generations):
    """How many modules there are at least and at most after so many steps.

    Each kind of module is replaced by no less, and by no more, of each other kind than all that it may take say.

    Returns
    -------
    tuple of int or None
        None where cuts or decompositions leave nothing to be said.

    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> bounds(LSystem.parse("axiom: F\\nF -(0.5)-> FF\\nF -(0.5)-> FFF").compiled, 4)
    (16, 81)
    """
    found = [bound(tables, generations, which) for which in (at_least, at_most)]
    return None if None in found else tuple(found)


def fewest(tables, generations):
    """How many modules there are at least after so many steps, or None."""
    return bound(tables, generations, at_least)


def bound(tables, generations, which):
    if tables.decomposition or tables.cut is not None or tables.nested:
        return None
    sizes = grown(tables, generations, which)
    return sizes[-1] if sizes and len(sizes) > generations else None


def grown(tables, generations, which):
    """Sizes after each step where each kind of module becomes what a function says of its productions."""
    if generations > LONGEST:
        return None
    counts = Counter(tables.axiom.symbols)
    made, growth, work = [counts.total()], {}, 0
    for step in range(1, generations + 1):
        group = tables.group_of(step)
        for symbol in [symbol for symbol in counts if (group, symbol) not in growth]:
            choices = tables.of_step(step).choices.get(symbol, ())
            growth[group, symbol] = which(symbol, choices) if choices else Counter([symbol])
            work += sum(len(template.symbols) for choice in choices for template in choice.templates) // QUICK
        work += sum(len(growth[group, symbol]) for symbol in counts)
        if work > MOST_WORK:
            return None
        before, counts = counts, after(counts, group, growth)
        made.append(counts.total())
        if made[-1] > WIDEST:
            break
        if made[-1] == made[-2] and counts == before and not tables.groups:  # and so it stays
            return made + made[-1:] * (generations - step)
    return made


def surely(symbol, choices):
    """What a kind of module becomes that always takes its first production."""
    return Counter(choices[0].templates[0].symbols)


def outcomes(symbol, choices):
    """All that a kind of module may become, itself where nothing is sure to match."""
    found = []
    for choice in choices:
        found += [Counter(template.symbols) for template in choice.templates]
        if choice.condition is None and not choice.nodes:
            return found if choice.bounds[-1] == 1 else [*found, Counter([symbol])]
    return [*found, Counter([symbol])]


def at_least(symbol, choices):
    return reduce(and_, outcomes(symbol, choices))


def at_most(symbol, choices):
    return reduce(or_, outcomes(symbol, choices))


def certain(tables):
    """Whether every module is replaced wherever it is, by its first production."""
    every = (tables.common, *tables.groups.values())
    plain = all(choices[0].certain for rules in every for choices in rules.choices.values())
    return plain and not tables.decomposition and tables.cut is None and not tables.nested


def after(counts, group, growth):
    """The numbers of modules of each kind after a step."""
    found = Counter()
    for symbol, count in counts.items():
        for made, times in growth[group, symbol].items():
            found[made] += count * times
    return found
