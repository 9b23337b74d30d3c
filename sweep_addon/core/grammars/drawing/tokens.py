# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotations of a walk in space, taken together where nothing is between them."""

from functools import cached_property

import numpy as np

from . import turns
from .scaling import ANGLE

TURNS = {"+": (2, 1), "-": (2, -1), "&": (1, 1), "^": (1, -1), "\\": (0, -1), "/": (0, 1)}  # axis and sense
ABOUT = "|"
LEVELS = ("$", "@v")
SPATIAL = ("&", "^", "\\", "/", *LEVELS)
SPIN, MOVE, LEVEL = 1, 2, 3


class Tokens:
    """Runs of rotations, each with what ends it: what rolls level, a move, both or neither.

    Parameters
    ----------
    walk : Walk
    """

    def __init__(self, walk):
        self.walk = walk
        kinds = np.zeros(len(walk.word.tables.symbols), dtype=np.uint8)
        kinds[walk.numbers(*TURNS, ABOUT)] = SPIN
        kinds[walk.numbers(*LEVELS)] = LEVEL
        kinds[walk.moving[: len(kinds)]] = MOVE
        whole = walk.looked_up(kinds)
        if walk.regions:
            whole = np.where(walk.regions.closing, 0, whole).astype(np.uint8)
        chosen = whole > 0
        places = np.flatnonzero(chosen)
        kind = whole.take(places)
        first = walk.branches.first(chosen)

        new = np.zeros(len(places) + 1, dtype=bool)
        new[first[:-1]] = True
        new = new[:-1]
        new[1:] |= (kind[:-1] == MOVE) | ((kind[:-1] == LEVEL) & (kind[1:] != MOVE))
        numbered = np.empty(len(places) + 1, dtype=np.intp)
        token = np.cumsum(new, out=numbered[:-1])
        self.count = numbered[-1] = int(token[-1]) if len(places) else 0
        token -= 1
        self.first = numbered.take(first)
        self.of_move = token.take(np.flatnonzero(kind == MOVE))  # a third of the time of a mask
        self.is_level = np.zeros(self.count, dtype=bool)
        self.is_level[token.take(np.flatnonzero(kind == LEVEL))] = True
        spin = np.flatnonzero(kind == SPIN)
        self.relative = turns.products_of_runs(*self.spins(places.take(spin)), token.take(spin), self.count)

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
        parent = walk.branches.previous(self.first)
        depth = walk.branches.sums(np.ones(self.count, dtype=np.int32), self.first)[0]
        self.drawing = np.zeros(self.count, dtype=bool)
        self.drawing[self.of_move[walk.drawing[walk.symbols[walk.moves]]]] = True
        change = self.changed if walk.bends or walk.levels else None
        z, w = turns.along_paths(self.relative, parent, depth, walk.start, change)
        return z[self.of_move], w[self.of_move]

    def changed(self, tokens, z, w):
        """What rolling level does at tokens, and the tropism behind them."""
        if self.walk.levels:
            rolls = np.flatnonzero(self.is_level[tokens])
            if len(rolls):
                z[rolls], w[rolls] = turns.level(z[rolls], w[rolls])
        if not self.walk.bends:
            return (z, w), (z, w)
        drawing = self.drawing[tokens]
        if drawing.all():
            return (z, w), turns.bent(z, w, *self.bend)
        draws = np.flatnonzero(drawing)
        left = z.copy(), w.copy()
        left[0][draws], left[1][draws] = turns.bent(z[draws], w[draws], *self.bend)
        return (z, w), left

    @cached_property
    def bend(self):
        """The direction of the tropism, as its x and y + iz, and how easily segments bend."""
        *towards, ease = self.walk.system.tropism
        towards = np.array(towards) / np.abs(towards).max()  # whose square may be no number
        x, y, z = (towards / np.linalg.norm(towards)).tolist()
        return (x, complex(y, z)), ease
