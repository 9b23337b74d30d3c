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


def position(walk, places, end):
    """(n, 3) float array: where the turtle is at places of the word, from where its moves end."""
    return np.concatenate((end, np.zeros((1, 3))))[walk.branches.before(places, walk.is_moving)]


def polygons(walk, end):
    """The polygons of a word: their vertices are where braces open, at each F, f and dot, each once in a row.

    A polygon goes on through brackets; braces within braces make one of their own. What has fewer than three vertices
    is none.
    """
    if not walk.chosen(START).any():
        return ()
    places = np.flatnonzero(walk.chosen(START, END, MARK, *UNMARKED))
    at = position(walk, places, end)
    opens, closes = (walk.table(name)[walk.symbols[places]].tolist() for name in (START, END))
    made, unfinished = [], []
    for place in range(len(places)):
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


def organs(walk, end):
    """The organs of a word, by name: each is the module behind a tilde."""
    tildes = np.flatnonzero(walk.chosen(ORGAN))
    places = tildes[tildes + 1 < len(walk.symbols)] + 1
    names = np.array([name for name, _ in walk.word.tables.symbols], dtype=object)[walk.symbols[places]]
    at, scale = position(walk, places, end), np.broadcast_to(walk.parameter(places, 1.0), places.shape)
    return tuple(
        Organ(name, places[names == name], at[names == name], scale[names == name]) for name in dict.fromkeys(names)
    )
