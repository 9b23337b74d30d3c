# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Branches of a word, and what adds up on the way from its root to each module.

Between two brackets lies a stretch. Stretches that are sorted by how many branches they are in, and keep their order
otherwise, stand behind the stretch that they go on from; so no stack is needed.
"""

import numpy as np

from .neighbours import narrow


class Branches:
    """The stretches between the brackets of a word.

    Parameters
    ----------
    brackets : (b,) int array
        Their places in the word.
    opens : (b,) bool array
        Which of them open a branch.

    Attributes
    ----------
    parent : (b + 1,) int array
        The stretch that each goes on from; -1 for the first.
    branch : (b + 1,) int array
        The branch of each stretch, numbered by depth.

    Examples
    --------
    >>> word = np.array(list("F[FF[F]F]F"))
    >>> brackets = np.flatnonzero((word == "[") | (word == "]"))
    >>> branches = Branches(brackets, word[brackets] == "[")
    >>> branches.parent.tolist()
    [-1, 0, 1, 1, 0]
    >>> segments = np.flatnonzero(word == "F")
    >>> branches.sums(np.ones(len(segments)), branches.first(segments))[1].tolist()
    [1.0, 2.0, 3.0, 4.0, 4.0, 2.0]
    """

    def __init__(self, brackets, opens):
        self.brackets, count = brackets, len(brackets) + 1
        depth = np.concatenate(([0], np.cumsum(np.where(opens, 1, -1), dtype=np.int32)))
        self.order = np.argsort(narrow(depth), kind="stable")
        begins = np.concatenate(([True], opens))
        self.starts = np.flatnonzero(begins[self.order])  # of branches, in the sorted order
        self.parent = np.arange(-1, count - 1)
        self.parent[self.order[1:]] = np.where(begins[self.order[1:]], self.order[1:] - 1, self.order[:-1])
        self.branch = np.empty(count, dtype=np.intp)
        self.branch[self.order] = np.cumsum(begins[self.order]) - 1
        ends = np.append(self.starts[1:], count) - 1
        self.closing = self.order[ends]  # the last stretch of each branch, of the whole word's first

    def first(self, places):
        """(b + 2,) int array: which of the items at sorted places in the word is the first of each stretch."""
        return np.concatenate(([0], np.searchsorted(places, self.brackets), [len(places)]))

    def stretch(self, first):
        """(n,) int array: the stretch of each item."""
        return np.repeat(np.arange(len(first) - 1), np.diff(first))

    def sums(self, values, first):
        """Sums of values on the way from the root to each item.

        Parameters
        ----------
        values : (n,) array
            Of items in the order of the word.
        first : (b + 2,) int array
            As `first` gives.

        Returns
        -------
        (n,) array
            The sum before each item.
        (n,) array
            The sum with it.

        Notes
        -----
        Where a branch ends the sum of its own stretches is taken off again; those within it have done so before.
        """
        heads = first[:-1] + np.arange(len(first) - 1)
        place = np.arange(1, len(values) + 1) + self.stretch(first)
        spread = np.zeros(len(values) + len(heads), dtype=values.dtype)
        spread[place] = values
        own = np.add.reduceat(np.add.reduceat(spread, heads)[self.order], self.starts)
        closed = self.closing[1:]
        inner = closed + 1 < len(heads)
        spread[heads[closed[inner] + 1]] -= own[1:][inner]
        total = np.cumsum(spread)
        return total[place - 1], total[place]

    def latest(self, first):
        """(b + 1,) int array: the last item before each stretch on its way from the root, or -1."""
        last = np.where(np.diff(first) > 0, first[1:] - 1, -1)
        above = self.parent.copy()
        found = np.where(above >= 0, last[above], -1)
        while True:
            waiting = np.flatnonzero((found < 0) & (above >= 0))
            waiting = waiting[self.parent[above[waiting]] >= 0]
            if not waiting.size:
                return found
            known = found[above[waiting]]
            found[waiting] = known
            above[waiting] = above[above[waiting]]

    def before(self, places, items):
        """(n,) int array: the last of some items at or before each place, on the way from the root; or -1.

        Parameters
        ----------
        places, items : (n,), (m,) int array
            Sorted places in the word.
        """
        first = self.first(items)
        stretch = np.searchsorted(self.brackets, places, side="right")
        found = np.searchsorted(items, places, side="right") - 1
        return np.where(found >= first[stretch], found, self.latest(first)[stretch])
