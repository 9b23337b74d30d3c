# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Headings of figures that stay in their plane: angles add up, so there is nothing to multiply.

Where no turn says its angle, turns are counted in whole numbers and each heading is looked up.
"""

import numpy as np

from . import turns
from .running import Running

WIDEST = 1 << 20  # headings in a table
BLOCK = 1 << 15  # modules
COUNTED = 256  # by a byte
TURNS, ABOUT = {"+": 1, "-": -1}, {"|": 1}  # steps of modules by their names


class Plane:
    """The headings of the turtle at the moves of a word that turns left and right alone.

    Parameters
    ----------
    walk : Walk
    """

    def __init__(self, walk):
        self.walk = walk
        self.at_first = 0.0 if walk.along == "x" else 90.0  # degrees
        self.upright = walk.along == "z"
        self.halves = self.counted(ABOUT) % 2 if walk.named.get("|") else None

    def steps(self, steps):
        """(s,) int8 array: the step of each module, by that of its name."""
        found = np.zeros(len(self.walk.word.tables.symbols), dtype=np.int8)
        for name, step in steps.items():
            found[self.walk.numbers(name)] = step
        return found

    def counted(self, steps):
        """(m,) int array: what the steps of turns add up to on the way to each move."""
        walk = self.walk
        if walk.branched:
            counts, limbs = walk.limbs.counted(steps), walk.limbs
            edges, found = counts.at(limbs.branches.brackets), counts.at(limbs.moves)
            return limbs.branches.counts_at(edges, found, walk.sums)
        found = np.empty(walk.count, dtype=np.int32)
        for part, places, sums in self.blocks(self.steps(steps)):
            found[part] = sums.at(places)
        return found

    def counted_in_bytes(self):
        """(m,) uint8 array: the turns on the way to each move of a word with branches, without multiples of 256."""
        limbs = self.walk.limbs
        counts = limbs.counted(TURNS).bytes
        edges, found = counts.take(limbs.branches.brackets), counts.take(limbs.moves)
        return limbs.branches.counts_at(edges, found, self.walk.sums)

    def blocks(self, table):
        """Which moves are in each block of modules, where in it, and the sums of steps there; without branches."""
        walk, before, begin = self.walk, 0, 0
        for edge in range(0, len(walk.symbols), BLOCK):
            symbols = walk.symbols[edge : edge + BLOCK]
            places = np.flatnonzero(walk.looked_up(walk.moving, symbols))
            sums = Running(walk.looked_up(table, symbols), before)
            before, stop = sums.total, begin + len(places)
            yield slice(begin, stop), places, sums
            begin = stop

    def degrees(self):
        """Angles, and which of them each move has; None where each has its own."""
        walk = self.walk
        if walk.turns_differ:
            return self.at_first + self.added(), None
        count = self.counted(TURNS)
        least, most = (int(count.min()), int(count.max())) if len(count) else (0, 0)
        if most - least > WIDEST:
            return self.at_first + count * walk.system.angle, None
        count -= least
        return self.at_first + np.arange(least, most + 1) * walk.system.angle, count

    def added(self):
        """(m,) float array: the sum of the angles that turns say, on the way to each move."""
        walk = self.walk
        chosen = walk.chosen("+", "-")
        places = np.flatnonzero(chosen)
        sense = np.where(np.isin(walk.symbols[places], walk.numbers("-")), -1.0, 1.0)
        given = sense * walk.angles(places)
        after = np.append(walk.branches.sums(given, walk.branches.first(chosen))[1], 0.0)
        return after[walk.branches.before(walk.moves, chosen)]

    def headings(self):
        """Directions in the plane as complex numbers, and which of them each move has; None where each has its own."""
        degrees, which = self.degrees()
        found = turns.unit(degrees)
        if self.halves is None:
            return found, which
        if which is None:
            return found * (1 - 2 * self.halves), None
        return np.concatenate((found, -found)), which + len(found) * self.halves

    def ways(self, length):
        """(m,) complex array: how far each move goes, in the plane; lengths are an array, or one number."""
        if self.by_bytes and self.walk.branched:
            found, which = self.circle, self.counted_in_bytes()
        else:
            found, which = self.headings()
        if np.ndim(length) or which is None:
            return length * (found if which is None else found.take(which))
        return (found * length).take(which)

    @property
    def by_bytes(self):
        """Whether a byte counts enough of the turns: 256 of them are whole turns of the circle."""
        return not self.walk.turns_differ and self.halves is None and not self.walk.system.angle * COUNTED % 360

    @property
    def circle(self):
        """(256,) complex array: the directions after so many turns."""
        return turns.unit(self.at_first + np.arange(COUNTED) * self.walk.system.angle)

    def path(self, length):
        """Two (m, 3) float arrays: where moves of one length begin and end, of a word without branches.

        What is on the way to them stays in a processor's cache.
        """
        count = self.walk.count
        made = np.zeros((count + 1, 3))
        places = made[:, :2].view(complex)[:, 0]
        for part, ways in self.parts(length):
            ways[:1] += places[part.start]
            np.cumsum(ways, out=places[part.start + 1 : part.stop + 1])
        if self.upright:
            stand(made)
        return made[:-1], made[1:]

    def parts(self, length):
        """Moves in rows, and the ways that they go."""
        if self.by_bytes:
            found = self.circle * length
            for part, places, sums in self.blocks(self.steps(TURNS)):
                yield part, found.take(sums.bytes.take(places))
            return
        ways = self.ways(length)
        for start in range(0, len(ways), BLOCK):
            yield slice(start, min(start + BLOCK, len(ways))), ways[start : start + BLOCK]

    def quaternions(self):
        """Quaternions at each move."""
        degrees, which = self.degrees()
        degrees = degrees if which is None else degrees[which]
        degrees = degrees + (0 if self.halves is None else 180.0 * self.halves) - self.at_first
        return turns.product(self.walk.start, turns.rotation(2, np.mod(degrees, 720.0)))


def stand(points):
    """Let points (..., 3) of the plane, an array that is written, stand upright on the ground: y is their height."""
    points[..., 2] = points[..., 1]
    points[..., 1] = 0.0
