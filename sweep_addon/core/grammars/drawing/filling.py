# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons and organs: what a turtle leaves beside its segments."""

import numpy as np

from ...declared.frozen import individual
from ..deriving.neighbours import narrow

START, MARK, END = "{", ".", "}"
ORGAN = "~"
ALMOST = 1e-12  # of the largest coordinate: what is nearer is one place
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


@individual
class Polygons:
    """Polygons, one behind the other.

    Attributes
    ----------
    place : (p,) int array
        The module of each in the word: its opening brace.
    points : (n, 3) float array
        Their vertices, in metres.
    offsets : (p + 1,) int array
        Polygon ``i`` has ``points[offsets[i]:offsets[i + 1]]``.
    """

    place: np.ndarray
    points: np.ndarray
    offsets: np.ndarray


def position(walk, places, end):
    """(n, 3) float array: where the turtle is at places of the word, from where its moves end."""
    return np.concatenate((end, np.zeros((1, 3))))[walk.branches.before(places, walk.is_moving)]


def polygons(walk, end):
    """The polygons of a word: their vertices are where braces open, at each F, f and dot, each once in a row.

    A polygon goes on through brackets; braces within braces make one of their own. What has fewer than three vertices
    is none, and so is what is not closed. Sorted by how many braces they are in, and in the order of the word
    otherwise, the vertices of each polygon stand in a row.
    """
    places = np.flatnonzero(walk.chosen(START, END, MARK, *UNMARKED))
    opens, closes = (walk.table(name)[walk.symbols[places]] for name in (START, END))
    level = levels(opens, closes)
    order = np.flatnonzero(level)
    order = order[np.argsort(narrow(level[order]), kind="stable")]
    polygon = np.cumsum(opens[order]) - 1
    closed = np.full(np.count_nonzero(opens), -1)
    closed[polygon[closes[order]]] = order[closes[order]]

    corner = order[~closes[order]]
    of, at = polygon[~closes[order]], position(walk, places, end)[corner]
    distinct = once(at, of)
    whole = (closed >= 0) & (np.bincount(of[distinct], minlength=len(closed)) > 2)
    kept = distinct & whole[of]
    in_turn = np.argsort(closed[whole])
    rank = np.empty(len(closed), dtype=np.intp)
    rank[np.flatnonzero(whole)[in_turn]] = np.arange(len(in_turn))
    at = at[kept][np.argsort(rank[of[kept]], kind="stable")]
    sizes = np.bincount(rank[of[kept]], minlength=len(in_turn))
    begins = places[order[opens[order]]][whole][in_turn]
    return Polygons(begins, at, np.concatenate(([0], np.cumsum(sizes))))


def levels(opens, closes):
    """(n,) int array: how many braces each place is in, of a pair both its own; 0 for those that nothing has opened."""
    depth = np.cumsum(opens.astype(np.int32) - closes)
    depth -= np.minimum(np.minimum.accumulate(depth), 0) if len(depth) else 0
    return np.where(closes, np.concatenate(([0], depth[:-1])), depth)


def once(at, polygon):
    """(n,) bool array: which vertices are not where the one before is, around their polygon, but for rounding."""
    before = np.arange(-1, len(at) - 1)
    first = np.flatnonzero(np.diff(polygon, prepend=-1))
    before[first] = np.append(first[1:], len(at))[: len(first)] - 1
    return (np.abs(at - at[before]) > ALMOST * np.abs(at).max(initial=0)).any(axis=1)


def organs(walk, end):
    """The organs of a word, by name: each is the module behind a tilde."""
    tildes = np.flatnonzero(walk.chosen(ORGAN))
    places = tildes[tildes + 1 < len(walk.symbols)] + 1
    kinds = [name for name, _ in walk.word.tables.symbols]
    number = {name: k for k, name in enumerate(dict.fromkeys(kinds))}
    which = np.array([number[name] for name in kinds], dtype=np.intp)[walk.symbols[places]]
    at, scale = position(walk, places, end), np.broadcast_to(walk.parameter(places, 1.0), places.shape)
    scale = scale if walk.scale is None else scale * walk.scale[places]
    order = np.argsort(which, kind="stable")
    alike = np.split(order, np.flatnonzero(np.diff(which[order])) + 1) if len(order) else ()
    alike = sorted(alike, key=lambda each: each[0])
    return tuple(Organ(kinds[walk.symbols[places[k[0]]]], places[k], at[k], scale[k]) for k in alike)
