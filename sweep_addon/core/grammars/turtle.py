# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The turtle: what it draws when it walks a word, for all modules at once.

Symbols are those of the book: ``F G`` draw a segment and ``f`` moves without; ``+ -`` turn left and right, ``& ^``
down and up, ``\\ /`` roll left and right, ``|`` turns about; ``$`` and ``@v`` roll until the left is level; ``!`` sets
the diameter and ``'`` the colour; ``[ ]`` begin and end a branch; ``{ . }`` make a polygon, and ``~`` places an organ.
"""

import re

import numpy as np

from . import turns
from .branches import Branches
from .figure import Figure
from .filling import organs, polygons, position
from .plane import Plane

DRAWS, SKIPS = ("F", "G"), ("f",)
EDGE = re.compile("F[A-Za-z0-9]")  # edges of which there are several kinds, as Fl and Fr
TURNS = {"+": (2, 1), "-": (2, -1), "&": (1, 1), "^": (1, -1), "\\": (0, -1), "/": (0, 1)}  # axis and sense
LEVELS = ("$", "@v")
THINNER = 0.5**0.5  # what a diameter is multiplied by where none is said: two such branches are as thick as one before
ALONG_X = (1 + 0j, 0j)
UPWARDS = turns.rotation(1, -90.0)


class Walk:
    """One walk of a turtle through a word.

    Parameters
    ----------
    word : Word
        Interpreted.
    upright : bool or None
        Whether it starts upwards; None where the system decides.
    """

    def __init__(self, word, upright=None):
        self.word, self.symbols, self.system = word, word.symbols, word.tables.system
        self.named = {}
        for number, (name, count) in enumerate(word.tables.symbols):
            self.named.setdefault(name, []).append((number, count))
        self.brackets = self.places("[", "]")
        self.branches = Branches(self.brackets, np.isin(self.symbols[self.brackets], self.numbers("[")))
        drawn = [name for name in self.named if name in DRAWS or EDGE.fullmatch(name)]
        self.drawing = self.numbers(*drawn)
        self.moves = self.places(*drawn, *SKIPS)
        upright = is_spatial(word.tables) and bool(self.named.get("[")) if upright is None else upright
        self.start = tuple(complex(part) for part in (UPWARDS if upright else ALONG_X))

    def numbers(self, *names):
        return [number for name in names for number, _ in self.named.get(name, ())]

    def places(self, *names):
        """(n,) int array: where modules of these names are, in the order of the word."""
        chosen = np.zeros(max(len(self.word.tables.symbols), 1), dtype=bool)
        chosen[self.numbers(*names)] = True
        return np.flatnonzero(chosen[self.symbols])

    def parameter(self, places, default):
        """(n,) float array: the first parameter of modules, or the default where they have none."""
        given = np.array([count > 0 for _, count in self.word.tables.symbols] or [False])[self.symbols[places]]
        if not given.any():
            return np.full(len(places), float(default))
        return np.where(given, self.word.columns[0][places], default)

    def figure(self):
        """The figure that is drawn."""
        moves, first = self.moves, self.branches.first(self.moves)
        start, end, quaternions = self.ways(first)
        draws = np.isin(self.symbols[moves], self.drawing)
        last = self.branches.before(moves - 1, moves)
        drawn = np.cumsum(draws) - 1
        segment = self.branches.before(moves[draws] - 1, moves[draws])
        branch = self.branches.branch[self.branches.stretch(first)]
        same = (last >= 0) & draws[last] & (branch[last] == branch)
        joined = same[draws] & (segment == np.where(last >= 0, drawn[last], -1)[draws])
        place = moves[draws]
        (at,) = position(self, np.array([len(self.symbols)]), moves, end)
        figure = Figure(
            start[draws],
            end[draws],
            self.set_or_changed("!", self.system.width, lambda times: THINNER**times, np.multiply, place),
            self.set_or_changed("'", 0.0, lambda times: times, np.add, place),
            place,
            segment,
            branch[draws],
            joined,
            self.word.births[place],
            quaternions,
            at,
            polygons(self, moves, end),
            organs(self, moves, end),
        )
        return figure

    def set_or_changed(self, name, default, change, combine, places):
        """(n,) float array: what modules of a name with a parameter set and others change, at places of the word."""
        every = self.places(name)
        given = np.array([count > 0 for _, count in self.word.tables.symbols])[self.symbols[every]]
        sets, changes = every[given], every[~given]
        value = np.full(len(places), float(default))
        last = self.branches.before(places, sets)
        value[last >= 0] = self.parameter(sets, 0)[last[last >= 0]]
        if len(changes):
            _, total = self.branches.sums(np.ones(len(changes)), self.branches.first(changes))
            counted = np.append(total, 0.0)
            times = counted[self.branches.before(places, changes)]
            times[last >= 0] -= counted[self.branches.before(sets, changes)][last[last >= 0]]
            value = combine(value, change(times))
        return value

    def ways(self, first):
        """Where each move begins and ends, and a function that gives the quaternions of segments."""
        length = self.parameter(self.moves, self.system.step)
        draws = np.isin(self.symbols[self.moves], self.drawing)
        turning = any(self.named.get(name) for name in (*LEVELS, "&", "^", "\\", "/"))
        if not turning and not self.bends and self.start == ALONG_X:
            plane = Plane(self)
            before, after = self.branches.sums(plane.directions() * length, first)
            flat = np.zeros(len(before))
            start = np.column_stack((before.real, before.imag, flat))
            end = np.column_stack((after.real, after.imag, flat))
            return start, end, lambda: turns.taken(plane.quaternions(), draws)
        z, w = Tokens(self).orientations()
        x, yz = turns.heading(z, w)
        before_x, after_x = self.branches.sums(x * length, first)
        before, after = self.branches.sums(yz * length, first)
        start = np.column_stack((before_x, before.real, before.imag))
        return start, np.column_stack((after_x, after.real, after.imag)), lambda: (z[draws], w[draws])

    @property
    def bends(self):
        tropism = self.system.tropism
        return tropism is not None and tropism[3] != 0


def is_spatial(tables):
    """Whether a system turns out of the plane."""
    names = {name for name, _ in tables.symbols}
    return bool(names & {"&", "^", "\\", "/", *LEVELS}) or tables.system.tropism is not None


class Tokens:
    """Runs of rotations, each with what ends it: a ``$``, a move, both or neither."""

    def __init__(self, walk):
        self.walk = walk
        spins = walk.places(*TURNS, "|")
        levels = walk.places(*LEVELS)
        places = np.sort(np.concatenate((spins, levels, walk.moves)), kind="stable")
        is_move, is_level = np.isin(places, walk.moves), np.isin(places, levels)
        stretch = walk.branches.stretch(walk.branches.first(places))
        new = np.ones(len(places), dtype=bool)
        new[1:] = (stretch[1:] != stretch[:-1]) | is_move[:-1] | (is_level[:-1] & ~is_move[1:])
        self.token = np.cumsum(new) - 1
        self.places, self.first = places, places[new]
        self.count = len(self.first)
        self.is_level = np.zeros(self.count, dtype=bool)
        self.is_level[self.token[is_level]] = True
        self.move = np.zeros(self.count, dtype=bool)
        self.move[self.token[is_move]] = True
        self.of_move = self.token[is_move]
        spin = ~is_move & ~is_level
        z, w = self.spins(places[spin])
        self.relative = turns.products_of_runs(z, w, self.token[spin], self.count)

    def spins(self, places):
        """The rotations of modules, by name."""
        walk = self.walk
        z, w = turns.empty(len(places))
        symbols = walk.symbols[places]
        for name, (axis, sense) in (*TURNS.items(), ("|", (2, 1))):
            for number, count in walk.named.get(name, ()):
                at = np.flatnonzero(symbols == number)
                if name == "|":
                    z[at], w[at] = turns.rotation(axis, 180.0)
                elif count:
                    z[at], w[at] = turns.rotation(axis, sense * walk.word.columns[0][places[at]])
                else:
                    z[at], w[at] = turns.rotation(axis, sense * walk.system.angle)
        return z, w

    def orientations(self):
        """Quaternions at each move."""
        walk = self.walk
        if not self.count:
            return turns.empty(0)
        branches = walk.branches
        first = branches.first(self.first)
        parent = branches.before(self.first - 1, self.first)
        depth = branches.sums(np.ones(self.count, dtype=np.intp), first)[0]
        draws = np.isin(walk.symbols[walk.moves], walk.drawing)
        self.drawing = np.zeros(self.count, dtype=bool)
        self.drawing[self.of_move[draws]] = True
        change = self.changed if walk.bends or self.is_level.any() else None
        z, w = turns.along_paths(self.relative, parent, depth, walk.start, change)
        return z[self.of_move], w[self.of_move]

    def changed(self, tokens, z, w):
        """What ``$`` does at tokens, and the tropism behind them."""
        rolls = self.is_level[tokens]
        if rolls.any():
            rolled = turns.level(z, w)
            z, w = np.where(rolls, rolled[0], z), np.where(rolls, rolled[1], w)
        left = z, w
        if self.walk.bends:
            *towards, ease = self.walk.system.tropism
            towards = np.array(towards) / np.linalg.norm(towards)
            turned = turns.bent(z, w, towards, ease)
            draws = self.drawing[tokens]
            left = np.where(draws, turned[0], z), np.where(draws, turned[1], w)
        return (z, w), left
