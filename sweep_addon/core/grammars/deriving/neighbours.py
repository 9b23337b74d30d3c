# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Neighbours of modules in a word with branches, for all modules at once.

Modules that are sorted by how many branches they are in, and keep their order otherwise, stand next to their
neighbours: those of one branch follow each other, behind a mark where the branch begins. On the left of a branch is
what it grows out of; on the right of its last module is nothing.
"""

from functools import cached_property

import numpy as np

from .tables import ASKS, CLOSES, OPENS, SEEN

MODULE, PASSES, BEGINS = range(3)  # what stands in the sorted order: PASSES sees neighbours and is not seen
MOST = 1 << 30  # modules, of each of which there may be two entries, that 32 bits can number
STEP = np.zeros(256, dtype=np.int8)
STEP[OPENS], STEP[CLOSES] = 1, -1


def depths(kind):
    """(n,) int array: in how many branches each module is; a bracket that opens is inside, one that closes is not."""
    return np.cumsum(STEP[kind], dtype=np.int32)


class Neighbours:
    """The neighbours of all modules of a word.

    Parameters
    ----------
    kind : (n,) uint8 array
        What each module is to contexts.

    Attributes
    ----------
    left, right : (n + 1,) int array
        The module before on the way to the root, and the next in the same branch; n where there is none.

    Examples
    --------
    >>> word = "A[B]C[DE]F"
    >>> kind = np.array([{"[": OPENS, "]": CLOSES}.get(letter, SEEN) for letter in word], dtype=np.uint8)
    >>> found = Neighbours(kind)
    >>> [(word + "-")[found.left[word.index(letter)]] for letter in "ABCDEF"]
    ['-', 'A', 'A', 'C', 'D', 'C']
    >>> [(word + "-")[found.right[word.index(letter)]] for letter in "ABCDEF"]
    ['C', '-', 'F', 'E', '-', '-']
    >>> [(word + "-")[found.branch(0, [word.index(letter)])[0]] for letter in "ACD"]
    ['B', 'D', '-']
    """

    def __init__(self, kind):
        self.none = len(kind)
        self.dtype = np.int32 if self.none < MOST else np.intp
        self.at, self.level, self.what, self.begun = self.in_order(kind)
        self.before, self.after = self.solid()
        self.brackets = np.flatnonzero(self.opens())
        self.left, self.right = self.links()

    def in_order(self, kind):
        """The sorted order: the module of each entry, its level, what it is, and where what a bracket opens begins."""
        at = np.flatnonzero((kind == SEEN) | (kind == OPENS) | (kind == ASKS)).astype(self.dtype)
        at = np.repeat(at, 1 + (kind[at] == OPENS))  # a bracket passes where its branch grows out, and begins it
        own = kind[at]
        begins = np.zeros(len(at), dtype=bool)
        begins[np.flatnonzero(own == OPENS)[1::2]] = True
        level = narrow(depths(kind)[at] - ((own == OPENS) & ~begins))
        what = np.full(len(at), PASSES, dtype=np.uint8)
        what[own == SEEN] = MODULE
        what[begins] = BEGINS
        order = np.argsort(level, kind="stable").astype(self.dtype)
        place = np.empty(len(order), dtype=self.dtype)
        place[order] = np.arange(len(order), dtype=self.dtype)
        begun = place[np.minimum(order + 1, len(order) - 1)] if len(order) else place  # by a bracket that passes
        return at[order], level[order], what[order], begun

    def solid(self):
        """The entry before and behind each in the sorted order that is seen; -1 and the number of entries for none."""
        count = len(self.what)
        number = np.arange(count, dtype=self.dtype)
        seen = self.what != PASSES
        before, after = np.full((2, count + 1), [[-1], [count]], dtype=self.dtype)
        np.maximum.accumulate(np.where(seen, number, before[1:]), out=before[1:])
        np.minimum.accumulate(np.where(seen, number, after[:-1])[::-1], out=after[:-1][::-1])
        return before[:-1], after[1:]

    def links(self):
        left, right = (np.full(self.none + 1, self.none, dtype=self.dtype) for _ in range(2))
        asking = np.flatnonzero(self.what != BEGINS).astype(self.dtype)
        brackets = self.brackets
        owner = np.full(len(self.what) + 1, -1, dtype=self.dtype)  # of what begins a branch; -1 of others, and of none
        owner[self.begun[brackets]] = self.before[brackets]
        beginning = self.begun[brackets]
        while True:  # out of branches that begin with branches
            out = owner[beginning]
            again = (out >= 0) & (self.what[out] == BEGINS)
            if not again.any():
                break
            owner[beginning[again]] = owner[out[again]]
        found = self.before[asking]
        inner = (found >= 0) & (self.what[found] == BEGINS)
        found[inner] = owner[found[inner]]
        known = found >= 0
        left[self.at[asking[known]]] = self.at[found[known]]
        right[self.at[asking]] = self.module_after(asking)
        return left, right

    def opens(self):
        """(k,) bool array: which entries are brackets, and not modules that pass."""
        same = np.zeros(len(self.at), dtype=bool)
        passing = self.what == PASSES
        follows = self.begun[passing]
        same[passing] = (self.what[follows] == BEGINS) & (self.at[follows] == self.at[passing])
        return same

    def module_after(self, entries):
        """The module of the same branch behind entries, or none."""
        found = np.minimum(self.after[entries], len(self.what) - 1)
        is_there = (self.after[entries] < len(self.what)) & (self.what[found] == MODULE)
        is_there &= self.level[found] == self.level[entries]
        found = self.at[found]
        found[~is_there] = self.none
        return found

    @cached_property
    def entry(self):
        """(n + 1,) int array: which entry of the sorted order each module is; -1 for what is none."""
        found = np.full(self.none + 1, -1)
        modules = self.what != BEGINS
        modules[self.brackets] = False
        found[self.at[modules]] = np.flatnonzero(modules)
        return found

    def branch(self, number, places):
        """(m,) int array: the first module of the so-manieth branch behind modules, before their right neighbours.

        Parameters
        ----------
        number : int
            From 0.
        places : (m,) int array
            In the word; n where there is none.
        """
        found, entry = np.full(len(places), self.none), self.entry[places]
        place = np.searchsorted(self.brackets, entry) + number
        asking = np.flatnonzero((entry >= 0) & (place < len(self.brackets)))
        entry, bracket = entry[asking], self.brackets[place[asking]]
        behind = np.where(self.what[entry] == MODULE, entry, self.before[entry]) == self.before[bracket]
        behind &= self.level[entry] == self.level[bracket]
        found[asking[behind]] = self.module_after(self.begun[bracket[behind]])
        return found


def narrow(level):
    """Levels in as few bytes as hold them, which sort faster."""
    most = int(level.max(initial=0))
    return level.astype(np.uint8 if most < 256 else np.uint16 if most < 65536 else np.uint32)


def removed(kind, cuts):
    """(n,) bool array: what cuts take away, each itself and all behind it in its branch.

    >>> word = "A[B%C[D]]E"
    >>> kind = np.array([{"[": OPENS, "]": CLOSES}.get(letter, SEEN) for letter in word], dtype=np.uint8)
    >>> "".join(letter for letter, cut in zip(word, removed(kind, [3])) if not cut)
    'A[B]E'
    """
    depth = depths(kind)
    inner = depth + (kind == CLOSES)
    at = np.union1d(cuts, np.flatnonzero(kind == CLOSES))
    order = np.argsort(narrow(inner[at]), kind="stable")
    at, level = at[order], inner[at][order]
    closing = np.where(kind[at] == CLOSES, np.arange(len(at)), len(at))
    closing = np.minimum.accumulate(closing[::-1])[::-1]
    cut = np.flatnonzero(kind[at] != CLOSES)
    end = np.append(at, len(kind))[closing[cut]]
    apart = np.append(level, -1)[closing[cut]] != level[cut]
    change = np.zeros(len(kind) + 1, dtype=np.int32)
    np.add.at(change, at[cut], 1)
    np.add.at(change, np.where(apart, len(kind), end), -1)
    return np.cumsum(change[:-1]) > 0
