# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How productions leave the neighbours of modules, and what modules do by the kinds of these and their own."""

from itertools import product

import numpy as np

from ..text.modules import CLOSE, OPEN
from .tables import HIDDEN, SEEN

WIDEST = 64  # kinds of modules whose triples are looked up
MOST_TRIES = 300_000  # productions that are compared with pairs of neighbours before the first step


def suits(tables):
    """Whether the productions of a system leave all contexts to be known without a search."""
    every = (tables.common, *tables.groups.values())
    count = len(tables.symbols) + 1
    if tables.decomposition or tables.cut is not None or count > WIDEST:
        return False
    most = max((rules.count for rules in tables.groups.values()), default=0) + tables.common.count
    if most * count**2 > MOST_TRIES:
        return False
    return not any(rules.lateral for rules in every) and all(
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
    alone : bool
        Whether contexts see none but the heir, whose neighbours stay.
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
        self.alone = [*self.links] == [self.heir]


class Trial:
    """What some modules try one after the other.

    Parameters
    ----------
    lists : dict of int to list of (Choice, bool)
        What each of them tries, by its number in `Lookup.lists`, and whether the context is known to match.

    Attributes
    ----------
    choices : list of (Choice, bool)
        What all of them try first.
    rest : dict of int to list of (Choice, bool)
        And what some then.
    """

    def __init__(self, lists):
        one, *others = lists.values()
        alike = min([len(one), *(shared(one, other) for other in others)])
        self.choices = one[:alike]
        self.rest = {number: tries[alike:] for number, tries in lists.items() if len(tries) > alike}


def shared(one, other):
    """How many items two lists share from the first on."""
    differs = (place for place, (a, b) in enumerate(zip(one, other, strict=False)) if a != b)
    return next(differs, min(len(one), len(other)))


def holding(count):
    """The type of keys of so many kinds, and so of kinds."""
    return np.uint16 if count**3 <= 1 << 16 else np.uint32


class Lookup:
    """What modules do by a key: their left neighbour's kind, their own and that of the right one, as one number.

    Attributes
    ----------
    becomes : (k,) uint16 or uint32 array or None
        The kind that a module becomes by that alone; None where no kind does.
    every : dict of int to Trial
    trials : (k,) uint16 array
        Which of the trials it makes; 0 for none.
    lists : (k,) uint16 array
        Which list of choices it tries; 0 for none.
    """

    def __init__(self, rules, tables):
        count = len(tables.symbols) + 1
        becomes = np.empty((count, count, count), dtype=holding(count))
        becomes[:] = np.arange(count)[None, :, None]
        lists, numbers, heads, renaming = np.zeros(becomes.shape, dtype=np.uint16), {}, {}, False
        for symbol, choices in rules.choices.items():
            for left, right in product(range(count), repeat=2):
                tries = self.tries(choices, left, right)
                if tries and self.renames(tables, symbol, tries[0]):
                    becomes[left, symbol, right] = tries[0][0].templates[0].symbols[0]
                    renaming = True
                elif tries:
                    number = numbers.setdefault(tuple(choice for choice, _ in tries), len(numbers) + 1)
                    heads.setdefault(tries[0], {})[number] = tries
                    lists[left, symbol, right] = number
        self.becomes = becomes.ravel() if renaming else None
        self.lists = lists.ravel()
        self.every = {number: Trial(alike) for number, alike in enumerate(heads.values(), 1)}
        trials = np.zeros(len(numbers) + 1, dtype=np.uint16)
        for number, alike in enumerate(heads.values(), 1):
            trials[list(alike)] = number
        self.trials = trials[self.lists]

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
