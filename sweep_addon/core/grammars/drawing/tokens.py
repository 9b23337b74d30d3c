# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotations of a walk in space, taken together where nothing is between them."""

from functools import cached_property

import numpy as np

from . import turns
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
        self.relative = turns.products_of_runs(*self.spins(limbs.places.take(spin)), token.take(spin), self.count)

    def spins(self, places):
        """The rotations of modules: looked up where the angle is always the same."""
        walk = self.walk
        symbols = walk.symbols[places]
        tables = turns.empty(len(walk.word.tables.symbols))
        named = [(number, axis, sense, c) for n, (axis, sense) in TURNS.items() for number, c in walk.named.get(n, ())]
        for number, axis, sense, _ in named:
            tables[0][number], tables[1][number] = turns.rotation(axis, sense * walk.system.angle)
        for number in walk.numbers(ABOUT):
            tables[0][number], tables[1][number] = turns.rotation(2, 180.0)
        z, w = turns.taken(tables, symbols)
        scaled = bool(walk.numbers(ANGLE))
        for number, axis, sense, count in named:
            at = np.flatnonzero(symbols == number) if count or scaled else ()
            if len(at):
                angle = np.broadcast_to(walk.angles(places[at]), at.shape)
                angle = angle[0] if (angle == angle[0]).all() else angle
                z[at], w[at] = turns.rotation(axis, sense * angle)
        return z, w

    def orientations(self):
        """Quaternions at each move."""
        walk = self.walk
        if not self.count:
            return turns.empty(0)
        branches = walk.limbs.branches
        parent = branches.previous(self.first)
        depth = branches.sums(np.ones(self.count, dtype=np.int32), self.first)[0]
        levels, bends = self.is_level if walk.levels else None, None
        if walk.bends:
            bends = np.zeros(self.count, dtype=bool)
            bends[self.of_move[walk.drawing[walk.symbols[walk.moves]]]] = True
        return turns.along_paths(
            self.relative, parent, depth, walk.start, self.of_move, levels, bends, self.bend if walk.bends else None
        )

    @cached_property
    def bend(self):
        """The direction of the tropism, as its x and y + iz, and how easily segments bend."""
        *towards, ease = self.walk.system.tropism
        towards = np.array(towards) / np.abs(towards).max()  # whose square may be no number
        x, y, z = (towards / np.linalg.norm(towards)).tolist()
        return (x, complex(y, z)), ease
