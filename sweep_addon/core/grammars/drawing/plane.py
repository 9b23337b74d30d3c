# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Headings of figures that stay in their plane: angles add up, so there is nothing to multiply.

Where no turn says its angle, turns are counted in whole numbers and each heading is looked up.
"""

import numpy as np

from . import turns

WIDEST = 1 << 20  # headings in a table
BLOCK = 1 << 15  # modules


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
        steps = walk.looked_up(sense)
        if len(walk.branches.brackets):
            return walk.branches.counts_at(steps, walk.moves, walk.first)
        found, until = np.empty(len(walk.moves), dtype=np.int32), 0
        edges = range(0, len(steps), BLOCK)
        stops = np.searchsorted(walk.moves, [edge + BLOCK for edge in edges]).tolist()
        for edge, begin, stop in zip(edges, [0, *stops], stops, strict=False):
            counted = np.cumsum(steps[edge : edge + BLOCK], dtype=np.int32)
            counted += until
            counted.take(walk.moves[begin:stop] - edge, out=found[begin:stop])
            until = counted[-1]
        return found

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

    def headings(self):
        """Directions as complex numbers, and which of them each move has; None where each has its own."""
        degrees, which = self.degrees()
        found = turns.unit(degrees)
        if self.halves is None:
            return found, which
        if which is None:
            return found * (1 - 2 * self.halves), None
        return np.concatenate((found, -found)), which + len(found) * self.halves

    def ways(self, length):
        """(m,) complex array: how far each move goes, in the plane; lengths are an array, or one number."""
        found, which = self.headings()
        return length * (found if which is None else found.take(which))

    def path(self, length):
        """Two (m, 3) float arrays: where moves of one length begin and end, of a word without branches.

        What is on the way to them stays in a processor's cache.
        """
        (found, which), count = self.headings(), len(self.walk.moves)
        found = found * length
        made = np.zeros((count + 1, 3))
        on_the_way = np.zeros(BLOCK + 1, dtype=complex)
        for start in range(0, count, BLOCK):
            part = slice(start, min(start + BLOCK, count))
            place = on_the_way[: part.stop - start + 1]
            place[1:] = found[part] if which is None else found.take(which[part])
            np.cumsum(place, out=place)
            made[start + 1 : part.stop + 1, 0], made[start + 1 : part.stop + 1, 1] = place[1:].real, place[1:].imag
            on_the_way[0] = place[-1]
        return made[:-1], made[1:]

    def quaternions(self):
        """Quaternions at each move."""
        degrees, which = self.degrees()
        degrees = degrees if which is None else degrees[which]
        return turns.rotation(2, np.mod(degrees + (0 if self.halves is None else 180.0 * self.halves), 720.0))
