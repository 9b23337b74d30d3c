# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The turtle: what it draws when it walks a word, for all modules at once.

Symbols are those of the book: ``F G`` draw a segment and ``f`` moves without; ``+ -`` turn left and right, ``& ^``
down and up, ``\\ /`` roll left and right, ``|`` turns about; ``$`` and ``@v`` roll until the left is level; ``!`` sets
the diameter and ``'`` the colour; ``[ ]`` begin and end a branch; ``{ . }`` make a polygon, and ``~`` places an organ;
``@Gs @Gc @Ge`` make a generalized cylinder.
"""

import re
from functools import cached_property

import numpy as np

from ..deriving.subsystems import ENDS, Regions
from ..text.modules import CLOSE, OPEN
from ..word import Word
from . import turns
from .bounding import bounded
from .branches import Branches
from .cylinders import MARKS, Cylinders, marked
from .figure import Figure
from .limbs import LEVELS, TURNS, Limbs
from .plane import BLOCK, Plane, stand
from .scaling import ANGLE, LENGTH, scaled
from .sums import Sums
from .tokens import Tokens

DRAWS, SKIPS = ("F", "G"), ("f",)
FEW = 2  # numbers of modules
SPATIAL = ("&", "^", "\\", "/", *LEVELS)
EDGE = re.compile("F[A-Za-z0-9]")  # edges of which there are several kinds, as Fl and Fr
FACING = (0.5 + 0.5j, -0.5 + 0.5j)  # upwards, with its left along -x and its up along -y: as drawn, from in front
STARTS = {"x": (1 + 0j, 0j), "y": turns.rotation(2, 90.0), "z": FACING}


class Walk:
    """One walk of a turtle through a word.

    Parameters
    ----------
    word : Word
        Interpreted.
    upright : bool or None
        Whether it starts upwards; None where the system decides.
    system : LSystem, optional
        Whose angle, step, width and tropism count; else that of the word.
    stops : tuple of int
        Numbers of further modules where it stops, as at moves of no length.
    budget : Budget, optional
        Of the arrays of the word in which marks stand once for each of their segments.
    """

    def __init__(self, word, upright=None, system=None, stops=(), budget=None):
        self.asked, self.system = (word, upright, system), system or word.tables.system
        self.cylinders = Cylinders(word, budget) if marked(word) else None
        if self.cylinders:
            word = Word(word.tables, self.cylinders.state, word.generations, word.seed)
        self.word, self.symbols = word, word.symbols
        self.named = {}
        for number, (name, count) in enumerate(word.tables.symbols):
            self.named.setdefault(name, []).append((number, count))
        drawn = [name for name in self.named if name in DRAWS or EDGE.fullmatch(name)]
        self.drawing, self.moving, self.stops = self.table(*drawn), self.table(*drawn, *SKIPS), list(stops)
        self.stops += self.numbers(*MARKS)
        self.moving[self.stops] = True
        self.whole = not self.cylinders and np.array_equal(self.drawing, self.moving)
        nested = self.word.tables.nested
        self.regions = Regions(self.word.tables, self.word.state) if nested else None
        self.scale = self.regions.scales() if nested else None
        turning = any(self.named.get(name) for name in SPATIAL if not (nested and name == ENDS))
        self.spatial = turning or self.system.tropism is not None
        along = self.system.heading if upright is None else "z" if upright else "x"
        self.along = along or ("z" if self.spatial and self.named.get(OPEN) else "x")
        self.start = tuple(complex(part) for part in STARTS[self.along])

    @cached_property
    def branches(self):
        brackets = np.flatnonzero(self.chosen(OPEN, CLOSE)) if self.branched else np.zeros(0, dtype=np.intp)
        return Branches(brackets, self.table(OPEN)[self.symbols[brackets]])

    @cached_property
    def branched(self):
        """Whether the word has brackets."""
        return bool(self.numbers(OPEN)) and bool(self.chosen(OPEN).any())

    @cached_property
    def is_moving(self):
        """(n,) bool array: which modules of the word move the turtle."""
        return self.looked_up(self.moving)

    @cached_property
    def shown(self):
        """(n,) bool array: which modules of the word leave a segment."""
        if self.cylinders:
            return self.looked_up(self.drawing) & ~self.cylinders.hidden | self.cylinders.bends
        return self.is_moving if self.whole else self.looked_up(self.drawing)

    @cached_property
    def count(self):
        """How many of them move the turtle."""
        if self.branched:
            return len(self.limbs.moves)
        blocks = range(0, len(self.symbols), BLOCK)
        return sum(int(np.count_nonzero(self.looked_up(self.moving, self.symbols[at : at + BLOCK]))) for at in blocks)

    @cached_property
    def moves(self):
        """(m,) int array: the modules that move the turtle."""
        return np.flatnonzero(self.is_moving)

    @cached_property
    def is_drawn(self):
        """(m,) bool array: which of the moves leave a segment."""
        return np.ones(self.count, dtype=bool) if self.whole else self.shown[self.moves]

    @cached_property
    def limbs(self):
        return Limbs(self)

    def numbers(self, *names):
        """The numbers of all modules of these names."""
        return [number for name in names for number, _ in self.named.get(name, ())]

    def table(self, *names, given=None):
        """(s,) bool array: which numbers are modules of these names; with a parameter, without, or either."""
        found = np.zeros(max(len(self.word.tables.symbols), 1), dtype=bool)
        found[[n for name in names for n, count in self.named.get(name, ()) if given in (None, count > 0)]] = True
        return found

    def chosen(self, *names, given=None):
        """(n,) bool array: which modules of the word are of these names."""
        return self.looked_up(self.table(*names, given=given))

    def looked_up(self, table, symbols=None):
        """(n,) array: what a table of bytes holds for each module of the word, or for some symbols.

        To compare all modules with a few numbers is quicker than to look them up, which `bytes` does in a fifth of the
        time that NumPy takes.
        """
        symbols, numbers = self.symbols if symbols is None else symbols, np.flatnonzero(table).tolist()
        if len(numbers) <= FEW:
            found = None
            for number in numbers:
                here = (symbols == number).view(table.dtype)
                here *= table[number]
                found = here if found is None else np.add(found, here, out=found)
            return np.zeros(len(symbols), dtype=table.dtype) if found is None else found
        if symbols.dtype != np.uint8:
            return table[symbols]
        return np.frombuffer(symbols.tobytes().translate(table.tobytes().ljust(256, b"\0")), dtype=table.dtype)

    def parameter(self, places, default):
        """(n,) float array, or one number for all: the first parameter of modules, or the default where none is."""
        if not self.word.columns:
            return default
        given = np.array([count > 0 for _, count in self.word.tables.symbols])[self.symbols[places]]
        if not given.any():
            return default
        return np.where(given, self.word.columns[0][places], default)

    def angles(self, places):
        """(m,) float array, or one number for all: what turns at places turn by, in degrees."""
        return bounded(
            self.parameter(places, self.system.angle * scaled(self, ANGLE, places)),
            np.max,
            "turn by at most {} degrees",
        )

    def figure(self):
        """The figure that is drawn."""
        length = self.system.step
        if self.word.columns:
            length = self.parameter(self.moves, length * scaled(self, LENGTH, self.moves))
        if self.regions:
            length = length * self.scale[self.moves]
        if self.stops:
            length = np.where(np.isin(self.symbols[self.moves], self.stops), 0.0, length)
        bounded(length if np.ndim(length) else length * self.count, np.sum, "go at most {} m in all")
        if not self.spatial:
            plane = Plane(self)
            if np.ndim(length) or self.branched:
                start, end = self.points(plane.ways(length), stands=plane.upright)
            else:
                start, end = plane.path(length)
            found = plane.quaternions
        else:
            pair, which = Tokens(self).orientations()
            x, yz = (way.take(which) for way in turns.heading(*pair))
            start, end = self.points(x * length, yz * length)

            def found():
                return turns.taken(pair, which)

        if self.cylinders:
            start, end = self.cylinders.shaped(self, start, end, found())
        return Figure(self, start, end, found)

    def points(self, *ways, stands=False):
        """Two (m, 3) float arrays: where moves begin and end that go ways, of one coordinate or complex ones of two."""
        made = np.zeros((2, self.count, 3) if self.branched else (self.count + 1, 3))
        column = 0
        for way in ways:
            width = way.itemsize // made.itemsize
            places = made[..., column : column + width].view(way.dtype)[..., 0]
            if self.branched:
                self.sums.of(way, places)
            else:  # each begins where one ends
                np.cumsum(way, out=places[1:])
            column += width
        if stands:
            stand(made)
        return made if self.branched else (made[:-1], made[1:])

    @cached_property
    def sums(self):
        return Sums(self.limbs.branches, self.limbs.first)

    @property
    def up(self):
        """(3,) float array: the up of the turtle at first, and always where it stays in its plane."""
        return turns.axes(*(np.array([part]) for part in self.start))[0, 2]

    @property
    def bends(self):
        """Whether segments bend towards a tropism."""
        tropism = self.system.tropism
        return tropism is not None and tropism[3] != 0

    @property
    def turns_differ(self):
        """Whether turns may turn by other angles than that of the system."""
        return bool(self.numbers(ANGLE)) or any(count for turn in TURNS for _, count in self.named.get(turn, ()))

    @property
    def levels(self):
        """Whether the word may have what rolls the turtle level."""
        return bool(self.numbers(*LEVELS))
