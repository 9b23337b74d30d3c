# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tokens: what of a walk in space has one orientation, and on the way to what."""

import numpy as np

from .limbs import CLOSES, LEVEL, MOVE, SPIN
from .paths import along_paths
from .running import Running
from .runs import rotations
from .tropism import tropism


class Tokens:
    """Runs of rotations, each with what follows it: what rolls level, moves, both or neither.

    Moves in a row go the same way and are of one token, unless segments bend what comes behind them.

    Parameters
    ----------
    walk : Walk
    """

    def __init__(self, walk):
        self.walk, self.limbs = walk, walk.limbs
        self.kind = kind = self.limbs.kind
        self.begins = kind > CLOSES
        before, here = kind[:-1], kind[1:]
        apart = (before < SPIN) & (here != MOVE)
        if walk.bends:
            apart |= before == MOVE
        apart |= before <= CLOSES
        self.begins[1:] &= apart
        self.counted = Running(self.begins)

    def of(self, places):
        """(m,) int array: the tokens of modules of the limbs, but brackets."""
        return np.subtract(self.counted.at(places), 1, dtype=np.intp)

    def orientations(self):
        """Quaternions, and which of them each move has."""
        walk, branches, kind, count = self.walk, self.limbs.branches, self.kind, self.counted.total
        first = branches.first_of(self.counted)
        parent, depth = branches.previous(first), branches.passed(first)
        levels, bends, towards = None, None, None
        moves = self.of(self.limbs.moves)
        if walk.levels:
            levels = np.zeros(count, dtype=bool)
            levels[self.of(np.flatnonzero(kind == LEVEL))] = True
        if walk.bends:
            towards, bends = tropism(walk.system.tropism), np.zeros(count, dtype=bool)
            bends[moves[walk.drawing[walk.symbols[walk.moves]]]] = True
        turned_by = rotations(walk, kind, np.flatnonzero(self.begins), self.of)
        found, place = along_paths(turned_by, parent, depth, walk.start, levels, bends, towards)
        return found, moves if place is None else place.take(moves)
