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
SPINS = [(name, told) for told in (False, True) for name in (*TURNS, ABOUT)]  # each one more than the one before, and
# whether it says by how much it turns
ROW = 8  # turns that are looked through at the end of a branch
FEWEST = 12  # of so many modules in a row at least one must be left out, or it does not pay
BLOCK = 1 << 15  # modules


class Limbs:
    """The moves of a word, what turns the turtle on its way to them, and the brackets of branches that have moves.

    Parameters
    ----------
    walk : Walk

    Attributes
    ----------
    kind : (k,) uint8 array
        What each of these modules does.
    """

    def __init__(self, walk):
        self.walk, self.stayed = walk, []
        kinds = np.zeros(max(len(walk.word.tables.symbols), 1), dtype=np.uint8)
        for number, (name, told) in enumerate(SPINS):
            kinds[[which for which, count in walk.named.get(name, ()) if (count > 0) == told]] = SPIN + number
        for kind, names in ((LEVEL, LEVELS if walk.spatial else ()), (OPENS, OPEN), (CLOSES, CLOSE)):
            kinds[walk.numbers(*names)] = kind
        kinds[walk.moving] = MOVE
        self.kind = walk.looked_up(kinds)
        self.keep(self.kind > 0 if walk.regions is None else (self.kind > 0) & ~walk.regions.closing)
        while walk.branched:
            idle = idling(self.kind)
            if np.count_nonzero(idle) * FEWEST <= len(idle):
                break
            self.keep(~idle)

    def keep(self, which):
        """Leave out the modules that do not stay; of bytes alone, block by block, so that no place need be stored."""
        self.stayed.append(which)
        kind, self.kind, stop = self.kind, np.empty(np.count_nonzero(which), dtype=np.uint8), 0
        for edge in range(0, len(kind), BLOCK):
            places = np.flatnonzero(which[edge : edge + BLOCK])
            start, stop = stop, stop + len(places)
            kind[edge : edge + BLOCK].take(places, out=self.kind[start:stop], mode="clip")

    @cached_property
    def places(self):
        """(k,) int array: where in the word these modules are."""
        found = np.flatnonzero(self.stayed[0])
        for which in self.stayed[1:]:
            found = found.take(np.flatnonzero(which))
        return found

    def counted(self, steps):
        """Running: what turns add up to in the order of the word, by the step of each name."""
        found = np.zeros(SPIN + len(SPINS), dtype=np.int8)
        found[SPIN:] = [steps.get(name, 0) for name, _ in SPINS]
        return Running(self.walk.looked_up(found, self.kind))

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


def idling(kind):
    """(k,) bool array: which modules turn no move: turns at the end of a branch, and branches that are nothing else.

    Not all of them: of many in a row the last, and no branch in which there are others.

    >>> word = "F[F+[]+][&[+]/-[+[]]]+F-&"
    >>> kinds = {"[": OPENS, "]": CLOSES, "F": MOVE}
    >>> kind = np.array([kinds.get(letter, SPIN) for letter in word], dtype=np.uint8)
    >>> "".join(letter for letter, idle in zip(word, idling(kind)) if not idle)
    'F[F+][&/-[+]]+F-&'
    """
    turn, last = kind > MOVE, kind == CLOSES
    ending = last.copy()  # what stands at the end of a branch
    for _ in range(ROW):
        last = turn[: len(last) - 1] & last[1:]
        if not last.any():
            break
        ending[: len(last)] |= last
    idle = ending & turn
    inside = (kind[:-1] == OPENS) & ending[1:]  # a branch of which no more is than its end
    idle[:-1] |= inside
    for place in range(1, ROW + 2):
        inside &= ending[place:]
        if not inside.any():
            break
        idle[place:] |= inside
        inside = inside[:-1] & turn[place:-1]
    return idle
