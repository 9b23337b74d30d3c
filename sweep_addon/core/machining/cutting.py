# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cutting stock by a program: what is left of it at the places of a lattice; the last ones are kept."""

import re
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np

from ..declared.parameters import ShapeError, at, require
from ..kept import kept
from .lattice import Lattice
from .programs import read
from .programs.toolpath import Toolpath
from .removal import removed
from .stock import Stock
from .tools import Tool

COARSEST = 256  # cells along the longer side of the stock, where nobody says how large they are
MOST_PLACES = 4_000_000
MOST_PIECES = 4_000_000  # of moves, of which arcs have many
COMPENSATING = re.compile(r"g[\s0]*(?:4[12]|\[|#)", re.IGNORECASE)  # what may be G41 or G42
NOTHING = "must move a tool from a place that is known to another, got a text that does not"
LONG, MANY = 100_000, 300_000  # characters of a program or pieces of its moves, and places: a person waits for more


def path_of(program, tool=None, tools=()):
    """The moves of a program with a tool and others by their numbers, or a refusal; with none, of one without width."""
    asks = COMPENSATING.search(program)  # nothing else changes with how wide tools are
    widths = tuple((each.number, each.tool.diameter) for each in tools) if asks else ()
    path, refusal = read_once(program, tool.diameter if tool and asks else 0.0, widths)
    if refusal:
        raise refusal.inside("")  # another one each time, for whoever catches it changes it
    return path


@lru_cache(maxsize=4)
def read_once(program, usual, widths):
    """The moves of a program and what it is refused with, of which one is None: loops without end take seconds."""
    try:
        return read(program, lambda tool: dict(widths).get(tool, usual)), None
    except ShapeError as refusal:
        return None, refusal


@dataclass(frozen=True)
class Question:
    """What decides what is left of stock, and a list of who is told how far it is, which is empty afterwards."""

    program: str
    tool: Tool
    tools: tuple
    stock: Stock
    cell: float
    tolerance: float
    listening: list = field(default_factory=list, compare=False)

    @classmethod
    def of(cls, shape, progress=None):
        asked = (getattr(shape, name) for name in ("program", "tool", "tools", "stock", "cell", "tolerance"))
        return cls(*asked, [progress] if progress else [])

    def tell(self, part):
        for progress in self.listening:
            progress(part)


@dataclass(frozen=True, eq=False)
class Machined:
    """Stock after a program.

    Attributes
    ----------
    path : Toolpath
    starts, ends : (m, 3) float arrays
        Straight pieces of its moves, in metres.
    moves : (m,) int array
        The move of the path that each is part of.
    tools : tuple of (Tool, (k,) int array)
        Each tool that is used, and its pieces.
    lattice : Lattice
    low, high : (3,) float arrays
        The corners of the block.
    heights : (n, k) float array
        What the moves leave at the places of the lattice, which may be below the bottom of the block.
    by : (n, k) int array
        The piece that cut each place last, or -1.
    """

    path: Toolpath
    starts: np.ndarray
    ends: np.ndarray
    moves: np.ndarray
    tools: tuple
    lattice: Lattice
    low: np.ndarray
    high: np.ndarray
    heights: np.ndarray = None
    by: np.ndarray = None

    @property
    def nbytes(self):
        return sum(part.nbytes for part in (self.starts, self.ends, self.moves, self.heights, self.by))

    @property
    def lines(self):
        """The line of the program that cut each place last, 0 where none did: (n, k) int array."""
        made = self.path.lines[self.moves] if len(self.moves) else np.zeros(1, dtype=np.int32)
        return np.where(self.by < 0, 0, made[self.by])

    @property
    def left(self):
        """The heights within the block: (n, k)."""
        return np.clip(self.heights, self.low[2], self.high[2])


@kept
def cut(question):
    """Run a program and cut the stock by all its moves: `Machined`."""
    found = laid_out(question)
    heights, by = np.full(found.lattice.size, found.high[2]), np.full(found.lattice.size, -1)
    for number, (tool, rows) in enumerate(found.tools):
        heights, by = removed(
            tool, found.starts[rows], found.ends[rows], found.lattice, heights, by, rows,
            lambda part, number=number: question.tell((number + part) / len(found.tools)),
        )  # fmt: skip
    question.listening.clear()  # the question is kept with its answer, and nobody else should be
    return replace(found, heights=heights, by=by)


def laid_out(question):
    """All but the cutting itself."""
    path = path_of(question.program, question.tool, question.tools)
    if len(path) <= path.first:
        raise ShapeError(NOTHING, "program")
    with at("tolerance"):
        starts, ends, moves = pieces(path, question.tolerance)
    tools = used(question, path.tools[moves])
    radii = np.zeros(len(moves))
    for tool, rows in tools:
        radii[rows] = tool.radius
    with at("stock"):
        low, high = question.stock.box(path, starts, ends, radii)
    cell = question.cell or max(high[:2] - low[:2]) / COARSEST
    count = np.prod(np.ceil((high[:2] - low[:2]) / cell) + 1)
    require(count <= MOST_PLACES, f"must make at most {MOST_PLACES:,} places", int(min(count, 1e18)), "cell")
    lattice = Lattice.across(tuple(low[:2].tolist()), tuple(high[:2].tolist()), cell)
    return Machined(path, starts, ends, moves, tools, lattice, low, high)


def pieces(path, tolerance):
    many = path.pieces(tolerance).sum()
    require(many <= MOST_PIECES, f"must make at most {MOST_PIECES:,} pieces of moves", int(many))
    return path.segments(tolerance)


def used(question, numbers):
    """Each tool that some pieces of moves are made with, and those pieces."""
    known = {each.number: each.tool for each in question.tools}
    by_tool = {}
    for number in np.unique(numbers):
        tool = known.get(int(number), question.tool)
        by_tool.setdefault(tool, []).append(np.flatnonzero(numbers == number))
    return tuple((tool, np.sort(np.concatenate(rows))) for tool, rows in by_tool.items())


def takes_long(shape):
    """Whether a person would wait for the mesh: of a long program, of many moves, or on many places."""
    if len(shape.program) > LONG:
        return True
    found = laid_out(Question.of(shape))
    return len(found.starts) > LONG or found.lattice.size[0] * found.lattice.size[1] > MANY
