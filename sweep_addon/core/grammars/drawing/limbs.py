# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Limbs: what of a word takes part in where its turtle goes, without branches that it leaves as it entered them.

Half of the branches of a plant are buds, in which nothing moves; what stands in them, and behind the last move of any
branch, turns a turtle that is forgotten.
"""

from functools import cached_property

import numpy as np

from ..text.modules import CLOSE, OPEN
from .branches import Branches
from .running import Running

TURNS = {"+": (2, 1), "-": (2, -1), "&": (1, 1), "^": (1, -1), "\\": (0, -1), "/": (0, 1)}  # axis and sense
ABOUT = "|"
LEVELS = ("$", "@v")
OPENS, CLOSES, MOVE, LEVEL, SPIN = range(1, 6)  # what modules do; those up to a move are firm, those behind are turns
SPINS = (*TURNS, ABOUT)  # the first of these is a SPIN, each other one more
MOST = 100  # branches within branches that are left out: fewer than a byte counts
FEWEST = 16  # of so many firm modules in a row at least one pair of brackets must be left out, or it does not pay


class Limbs:
    """The moves of a word, what turns the turtle on its way to them, and the brackets of branches that have moves.

    Parameters
    ----------
    walk : Walk
        Turns are left out if it stays in its plane, where they are counted.

    Attributes
    ----------
    kind : (k,) uint8 array
        What each of these modules does.
    places : (k,) int array
        Where in the word it is.
    """

    def __init__(self, walk):
        self.walk = walk
        kinds = np.zeros(max(len(walk.word.tables.symbols), 1), dtype=np.uint8)
        turning = [(LEVEL, LEVELS), *((SPIN + n, (name,)) for n, name in enumerate(SPINS))] if walk.spatial else []
        for kind, names in (*turning, (OPENS, OPEN), (CLOSES, CLOSE)):
            kinds[walk.numbers(*names)] = kind
        kinds[walk.moving] = MOVE
        whole = walk.looked_up(kinds)
        if walk.regions:
            whole = np.where(walk.regions.closing, 0, whole).astype(np.uint8)
        self.places = self.every = np.flatnonzero(whole > 0)
        self.kind = whole.take(self.places)
        self.within = self.stays = None
        if walk.branched:
            self.leave_out(np.flatnonzero(self.kind <= MOVE) if turning else slice(None))

    def leave_out(self, firm):
        """Leave out bare branches with all that is in them, and what stands before the end of any branch or word."""
        kind = self.kind[firm]
        bare = moveless(kind)
        if not bare.any():
            return
        steps = (kind == OPENS).view(np.int8) - (kind == CLOSES).view(np.int8)
        steps *= bare
        self.within = np.zeros(len(kind), dtype=bool)
        self.within[1:] = Running(steps).bytes[:-1]
        stays = ~bare
        if not isinstance(firm, slice):
            stays = np.repeat(~self.within & (kind != CLOSES), np.diff(firm, prepend=-1))
            stays[firm] = ~bare
        self.stays = np.flatnonzero(stays)
        self.places, self.kind = self.every.take(self.stays), self.kind.take(self.stays)

    def counts(self, table, dtype):
        """(k,) array: what steps of modules add up to, in the order of the word, without those of bare branches.

        Parameters
        ----------
        table : (s,) int8 array
            The step of each kind of module.
        dtype : numpy dtype
            As uint8 that is modulo 256.
        """
        counted = Running(self.walk.looked_up(table))
        found = counted.bytes.take(self.every) if dtype == np.uint8 else counted.at(self.every)
        if self.stays is None:
            return found
        found[1:] -= found[:-1].copy()
        found[self.within] = 0
        return np.cumsum(found, dtype=dtype, out=found).take(self.stays)

    @cached_property
    def branches(self):
        """Branches: those that have moves; its brackets are places among these modules."""
        brackets = np.flatnonzero(self.kind <= CLOSES)
        return Branches(brackets, self.kind.take(brackets) == OPENS)

    @cached_property
    def moves(self):
        """(m,) int array: which of these modules are moves."""
        return np.flatnonzero(self.kind == MOVE)

    @cached_property
    def first(self):
        """(b + 2,) int array: which of the moves is the first of each stretch, and how many there are."""
        return self.branches.first(self.kind == MOVE)


def moveless(kind):
    """(k,) bool array: which brackets, among these and moves, are of branches without moves; not of all of them.

    >>> word = "F[F[]][[][[]]]F"
    >>> kind = np.array([{"[": OPENS, "]": CLOSES}.get(letter, MOVE) for letter in word], dtype=np.uint8)
    >>> "".join(letter for letter, bare in zip(word, moveless(kind)) if not bare)
    'F[F]F'
    """
    found = np.zeros(len(kind), dtype=bool)
    numbers = np.arange(0)
    for depth in range(MOST):
        left_out = np.zeros(len(kind), dtype=bool)
        np.logical_and(kind[:-1] == OPENS, kind[1:] == CLOSES, out=left_out[:-1])
        if np.count_nonzero(left_out) * FEWEST <= len(kind):
            break
        left_out[1:] |= left_out[:-1].copy()
        found[numbers.take(np.flatnonzero(left_out)) if depth else left_out] = True
        stays = np.flatnonzero(~left_out)
        numbers, kind = numbers.take(stays) if depth else stays, kind.take(stays)
    return found
