# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotations of a walk in space, taken together where nothing is between them."""

import numpy as np

from . import paths, turns
from .limbs import ABOUT, CLOSES, LEVEL, MOVE, SPIN, TURNS
from .scaling import ANGLE


class Tokens:
    """Runs of rotations, each with what ends it: what rolls level, a move, both or neither.

    Parameters
    ----------
    walk : Walk
    """

    def __init__(self, walk):
        self.walk, limbs = walk, walk.limbs
        kind = limbs.kind
        new = kind > CLOSES
        new[1:] &= (kind[:-1] <= MOVE) | ((kind[:-1] == LEVEL) & (kind[1:] != MOVE))
        token = np.cumsum(new)
        self.count = int(token[-1]) if len(token) else 0
        self.first = np.concatenate(([0], token.take(limbs.branches.brackets), [self.count]))
        token -= 1
        self.of_move = token.take(limbs.moves)  # a third of the time of a mask
        self.is_level = np.zeros(self.count, dtype=bool)
        self.is_level[token.take(np.flatnonzero(kind == LEVEL))] = True
        spin = np.flatnonzero(kind == SPIN)
        self.relative = paths.products_of_runs(self.spins(limbs.places.take(spin)), token.take(spin), self.count)

    def spins(self, places):
        """The rotations of modules: looked up where the angle is always the same."""
        walk = self.walk
        symbols = walk.symbols[places]
        tables = np.empty((2, len(walk.word.tables.symbols)), dtype=complex)
        named = [(number, axis, sense, c) for n, (axis, sense) in TURNS.items() for number, c in walk.named.get(n, ())]
        for number, axis, sense, _ in named:
            tables[:, number] = turns.rotation(axis, sense * walk.system.angle)
        for number in walk.numbers(ABOUT):
            tables[:, number] = turns.rotation(2, 180.0)
        found = paths.taken(tables, symbols)
        scaled = bool(walk.numbers(ANGLE))
        for number, axis, sense, count in named:
            at = np.flatnonzero(symbols == number) if count or scaled else ()
            if len(at):
                angle = np.broadcast_to(walk.angles(places[at]), at.shape)
                angle = angle[0] if (angle == angle[0]).all() else angle
                paths.put(found, at, turns.rotation(axis, sense * angle))
        return found

    def orientations(self):
        """Quaternions at each move."""
        walk, branches = self.walk, self.walk.limbs.branches
        parent = branches.previous(self.first)
        depth = branches.sums(np.ones(self.count, dtype=np.int32), self.first)[0]
        levels, bends, towards = self.is_level if walk.levels else None, None, None
        if walk.bends:
            towards, bends = tropism(walk.system.tropism), np.zeros(self.count, dtype=bool)
            bends[self.of_move[walk.drawing[walk.symbols[walk.moves]]]] = True
        return paths.along_paths(self.relative, parent, depth, walk.start, self.of_move, levels, bends, towards)


def tropism(told):
    """What segments bend towards, of its direction and how easily they bend."""
    *towards, ease = told
    towards = np.array(towards) / np.abs(towards).max()  # whose square may be no number
    return paths.Tropism(towards / np.linalg.norm(towards), ease)
