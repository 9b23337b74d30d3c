# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Branches of a word, and what adds up on the way from its root to each module.

Between two brackets lies a stretch. Stretches that are sorted by how many branches they are in, and keep their order
otherwise, stand behind the stretch that they go on from; so no stack is needed.
"""

from functools import cached_property

import numpy as np

from ..deriving.neighbours import narrow
from .running import GROUP, Running
from .sums import Sums


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
    >>> branches.sums(np.ones(6), branches.first(word == "F"))[1].tolist()
    [1.0, 2.0, 3.0, 4.0, 4.0, 2.0]
    >>> branches.previous(branches.first(word == "F")).tolist()
    [-1, 0, 1, 2, 2, 0]
    """

    def __init__(self, brackets, opens):
        self.brackets, count = brackets, len(brackets) + 1
        self.order = np.argsort(levels(opens), kind="stable")
        begins = np.concatenate(([True], opens))
        self.begins = begins[self.order]
        self.starts = np.flatnonzero(self.begins)  # of branches, in the sorted order
        ends = np.append(self.starts[1:], count) - 1
        self.closing = self.order[ends]  # the last stretch of each branch, of the whole word's first

    @cached_property
    def parent(self):
        found, order = np.arange(-1, len(self.brackets)), self.order
        found[order[1:]] = np.where(self.begins[1:], order[1:] - 1, order[:-1])
        return found

    @cached_property
    def branch(self):
        return self.numbered()

    def numbered(self):
        """(b + 1,) int array: the same as `branch`, not kept."""
        found, number = np.empty(len(self.order), dtype=np.intp), np.cumsum(self.begins)
        number -= 1
        found[self.order] = number
        return found

    def first(self, chosen):
        """Which of some items is the first of each stretch.

        Parameters
        ----------
        chosen : (n,) bool array
            Which modules of the word are items.

        Returns
        -------
        (b + 2,) int array
            At its end how many items there are.
        """
        if not len(self.brackets):
            return np.array([0, np.count_nonzero(chosen)])
        return self.first_of(Running(chosen))

    def first_of(self, counted):
        """The same, of the running sums of that array."""
        found = np.zeros(len(self.brackets) + 2, dtype=np.intp)
        found[1:-1], found[-1] = counted.at(self.brackets), counted.total
        return found

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

        """
        return Sums(self, first).of(values.copy())

    def counts(self, steps):
        """(n,) int32 array: what whole numbers at modules of a word add up to on the way to each module.

        Parameters
        ----------
        steps : (n,) int8 array
            0 at brackets.
        """
        if not len(self.brackets):
            return np.cumsum(steps, dtype=np.int32)
        ends = np.concatenate(([0], self.brackets))
        own = np.add.reduceat(steps, ends, dtype=np.int32) if len(steps) else np.zeros(1, dtype=np.int32)
        own = np.add.reduceat(own[self.order], self.starts)[1:]
        steps = steps.astype(np.int32)
        steps[self.brackets[self.closing[1:]]] -= own
        return np.cumsum(steps, out=steps)

    def counts_at(self, edges, found, sums):
        """The same at items alone.

        Parameters
        ----------
        edges, found : (b,) and (m,) array of one type
            What the numbers add up to in the order of the word, at brackets and at items; ``found`` is written over.
        sums : Sums
            Those of the items.
        """
        if len(self.brackets):
            steps = np.zeros(len(self.order), dtype=found.dtype)  # of stretches; that of the last is not asked for
            np.subtract(edges[1:], edges[:-1], out=steps[1:-1])
            own = np.zeros(len(self.starts), dtype=found.dtype)
            np.add.at(own, sums.branches_of, steps)  # of one type, else that takes twenty times as long
            back = np.zeros(len(self.order) + 1, dtype=found.dtype)
            back[self.closing[1:] + 1] = own[1:]
            found -= np.cumsum(back, dtype=found.dtype).take(sums.stretch)
        return found

    def passed(self, first):
        """(n,) int array: how many items are before each on its way from the root.

        Parameters
        ----------
        first : (b + 2,) int array
            As `first` gives.
        """
        found = np.arange(first[-1])
        if len(self.brackets):
            count = np.diff(first)
            own = np.add.reduceat(count.take(self.order), self.starts)
            back = np.zeros(len(count) + 1, dtype=np.intp)
            back[self.closing[1:] + 1] = own[1:]
            found -= np.repeat(np.cumsum(back[:-1]), count)
        return found

    def previous(self, first):
        """(n,) int array: the item before each on its way from the root, or -1."""
        found = np.arange(-1, first[-1] - 1)
        filled = np.flatnonzero(first[1:] > first[:-1])
        found[first[filled]] = self.latest(first)[filled]
        return found

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

    def before(self, places, chosen):
        """(n,) int array: the last of some items at or before each place, on the way from the root; or -1.

        Parameters
        ----------
        places : (n,) int array
            Places in the word, in its order.
        chosen : (n,) bool array
            Which modules of the word are items.
        """
        first = self.first(chosen)
        stretch = np.searchsorted(self.brackets, places, side="right")
        found = np.searchsorted(np.flatnonzero(chosen), places, side="right") - 1
        return np.where(found >= first[stretch], found, self.latest(first)[stretch])


def levels(opens):
    """(b + 1,) int array: in how many branches each stretch is, in as few bytes as numbers can be sorted in."""
    steps = np.zeros(len(opens) + 1, dtype=np.int8)
    np.subtract(opens, ~opens, out=steps[1:], dtype=np.int8)
    counted = Running(steps, GROUP)  # so that within a group no sum is below 0
    if counted.before.min() >= GROUP and counted.before.max() <= 255 - GROUP:
        return counted.bytes
    return narrow(counted.at(np.arange(len(steps))))
