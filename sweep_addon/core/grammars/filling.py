# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons and organs: what a turtle leaves beside its segments."""

import numpy as np

from ..frozen import individual

START, MARK, END = "{", ".", "}"
ORGAN = "~"
UNMARKED = ("F", "f")  # moves that make a vertex within a polygon; G makes none


@individual
class Organ:
    """Organs of one name.

    Attributes
    ----------
    name : str
    place : (n,) int array
        The module of each in the word.
    at : (n, 3) float array
        Where they are, in metres.
    scale : (n,) float array
        Their first parameter, else 1.
    """

    name: str
    place: np.ndarray
    at: np.ndarray
    scale: np.ndarray


def position(walk, places, moves, end):
    """(n, 3) float array: where the turtle is at places of the word."""
    return np.concatenate((end, np.zeros((1, 3))))[walk.branches.before(places, moves)]


def polygons(walk, moves, end):
    """The polygons of a word: their vertices are where braces open, at each F, f and dot, each once in a row.

    A polygon goes on through brackets; braces within braces make one of their own. What has fewer than three vertices
    is none.
    """
    braces = walk.places(START, END)
    if not len(braces):
        return ()
    places = walk.places(START, END, MARK, *UNMARKED)
    opens = np.isin(walk.symbols[places], walk.numbers(START))
    closes = np.isin(walk.symbols[places], walk.numbers(END))
    at = position(walk, places, moves, end)
    made, unfinished = [], []
    for place in range(len(places)) if len(places) else ():
        if opens[place]:
            unfinished.append([place])
        elif closes[place] and unfinished:
            made.append(unfinished.pop())
        elif unfinished:
            unfinished[-1].append(place)
    return tuple(polygon for polygon in (once(at[vertices]) for vertices in made) if len(polygon) > 2)


def once(points):
    """The points without those that are where the one before is, around the polygon."""
    return points[(points != np.roll(points, 1, axis=0)).any(axis=1)] if len(points) > 1 else points


def organs(walk, moves, end):
    """The organs of a word, by name: each is the module behind a tilde."""
    tildes = walk.places(ORGAN)
    tildes = tildes[tildes + 1 < len(walk.symbols)]
    if not len(tildes):
        return ()
    places = tildes + 1
    names = np.array([name for name, _ in walk.word.tables.symbols], dtype=object)[walk.symbols[places]]
    at, scale = position(walk, places, moves, end), walk.parameter(places, 1.0)
    return tuple(
        Organ(name, places[names == name], at[names == name], scale[names == name]) for name in dict.fromkeys(names)
    )
