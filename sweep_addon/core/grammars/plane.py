# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Headings of figures that stay in their plane: angles add up, so there is nothing to multiply.

Where no turn says its angle, turns are counted in whole numbers and each heading is looked up.
"""

import numpy as np

from . import turns

WIDEST = 1 << 20  # headings in a table


class Plane:
    """The headings of the turtle at the moves of a word that turns left and right alone.

    Parameters
    ----------
    walk : Walk
    """

    def __init__(self, walk):
        self.walk = walk
        self.halves = self.counted("|", "") % 2 if walk.named.get("|") else None

    def counted(self, left, right):
        """(m,) int array: how often the turtle has turned left, and how often less right, on its way to each move."""
        walk = self.walk
        sense = np.zeros(len(walk.word.tables.symbols), dtype=np.int8)
        sense[walk.numbers(left)] = 1
        sense[walk.numbers(right)] = -1
        return walk.branches.counts(walk.looked_up(sense))[walk.moves]

    def degrees(self):
        """Angles, and which of them each move has; None where each has its own."""
        walk = self.walk
        first = 90.0 if walk.along == "y" else 0.0
        if walk.turns_differ:
            return first + self.added(), None
        count = self.counted("+", "-")
        least, most = (int(count.min()), int(count.max())) if len(count) else (0, 0)
        if most - least > WIDEST:
            return first + count * walk.system.angle, None
        count -= least
        return first + np.arange(least, most + 1) * walk.system.angle, count

    def added(self):
        """(m,) float array: the sum of the angles that turns say, on the way to each move."""
        walk = self.walk
        chosen = walk.chosen("+", "-")
        places = np.flatnonzero(chosen)
        sense = np.where(np.isin(walk.symbols[places], walk.numbers("-")), -1.0, 1.0)
        given = sense * walk.angles(places)
        after = np.append(walk.branches.sums(given, walk.branches.first(chosen))[1], 0.0)
        return after[walk.branches.before(walk.moves, chosen)]

    def ways(self, length):
        """(m,) complex array: how far each move goes, in the plane; lengths are an array, or one number."""
        degrees, which = self.degrees()
        found = turns.unit(degrees)
        if np.ndim(length) == 0:
            found *= length
        found = found if which is None else found.take(which)
        found = found * length if np.ndim(length) else found
        return found if self.halves is None else found * (1 - 2 * self.halves)

    def quaternions(self):
        """Quaternions at each move."""
        degrees, which = self.degrees()
        degrees = degrees if which is None else degrees[which]
        return turns.rotation(2, np.mod(degrees + (0 if self.halves is None else 180.0 * self.halves), 720.0))
