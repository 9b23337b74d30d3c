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
        self.turned = walk.places("+", "-", "|")
        symbols = walk.symbols[self.turned]
        self.sense = np.where(np.isin(symbols, walk.numbers("-")), -1, 1).astype(np.int32)
        self.about = np.isin(symbols, walk.numbers("|"))
        self.first = walk.branches.first(self.turned)
        self.at = walk.branches.before(walk.moves, self.turned)
        self.halves = self.summed(self.about.astype(np.int32)) % 2 if self.about.any() else 0

    def summed(self, values):
        """(m,) array: what values of turns add up to on the way to moves."""
        return np.append(self.walk.branches.sums(values, self.first)[1], values.dtype.type(0))[self.at]

    def degrees(self):
        """Angles of which each move has one, and which; a half turn more where `halves` says so."""
        walk = self.walk
        if any(count for name in "+-" for _, count in walk.named.get(name, ())):
            given = self.sense * walk.parameter(self.turned, walk.system.angle)
            return self.summed(np.where(self.about, 0.0, given)), None
        count = self.summed(np.where(self.about, 0, self.sense))
        least, most = (int(count.min()), int(count.max())) if len(count) else (0, 0)
        if most - least > WIDEST:
            return count * walk.system.angle, None
        return np.arange(least, most + 1) * walk.system.angle, count - least

    def directions(self):
        """(m,) complex array: the heading at each move, in the plane."""
        degrees, which = self.degrees()
        found = turns.unit(degrees)
        found = found if which is None else found[which]
        return found * (1 - 2 * self.halves) if self.about.any() else found

    def quaternions(self):
        """Quaternions at each move."""
        degrees, which = self.degrees()
        degrees = degrees if which is None else degrees[which]
        return turns.rotation(2, np.mod(degrees + 180.0 * self.halves, 720.0))
