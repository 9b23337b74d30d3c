# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contracting: short edges of a closed surface become points, where that leaves it the closed surface that it was."""

import numpy as np

from ..vectors import norms
from .stars import Stars, rim


def contracted(vertices, triangles, short, fixed):
    """Contract edges that are shorter than something, the shortest first, until none is left that may be.

    Parameters
    ----------
    vertices : (n, 3) float array
        They stay where they are: of the two ends of an edge that one is left at which more triangles meet.
    triangles : (t, 3) int array
        A closed manifold, or a part of one, at whose boundary nothing changes.
    short : float
        In metres.
    fixed : (n,) bool array
        The vertices that are to stay.

    Returns
    -------
    triangles : (t, 3) int array
        With the vertices that are left; the same array where nothing could be done.
    kept : (t,) bool array
        Which triangles are still some: of each edge that is gone two are not.

    Source
    ------
    Dey, Edelsbrunner, Guha, Nekhayev: Topology preserving edge contraction, Publications de l'Institut
    Mathematique 66, 1999: an edge may go where the links of its ends have no more in common than the two vertices that
    it faces. Of all closed surfaces only a tetrahedron has edges that pass this count and may not.

    Edges whose neighbourhoods have no vertex in common do not know of each other: all of these are contracted at once.

    Examples
    --------
    Four faces of a pyramid whose tip was split in two:

    >>> vertices = np.array([(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0), (0, 0, 1), (0, 1e-9, 1)])
    >>> sides = [(0, 1, 5), (1, 4, 5), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 5, 4), (0, 2, 1), (0, 3, 2)]
    >>> triangles, kept = contracted(vertices, np.array(sides), 1e-6, np.full(6, False))
    >>> int(kept.sum()), len(np.unique(triangles[kept]))
    (6, 5)
    """
    kept, outer = np.full(len(triangles), True), rim(triangles, len(vertices))
    while True:
        going, staying = short_edges(vertices, triangles[kept], short, fixed, outer)
        chosen = together(triangles[kept], going, staying, len(vertices))
        if not len(chosen):
            return triangles, kept
        triangles, kept = drawn_in(triangles, going[chosen], staying[chosen], len(vertices))


def short_edges(vertices, triangles, short, fixed, outer):
    """The edges that are shorter than something, the shortest first: the end of each that may go, and the other."""
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    once = start < end  # it has two triangles, one of which names it this way round
    once &= ~(outer[start] | outer[end] | fixed[start] & fixed[end])
    start, end = start[once], end[once]
    lengths = norms(vertices[start] - vertices[end])
    order = np.argsort(lengths, kind="stable")
    order = order[lengths[order] < short]
    start, end = start[order], end[order]
    worth = np.bincount(triangles.ravel(), minlength=len(vertices)) + np.where(fixed, len(triangles), 0)
    more = worth[start] >= worth[end]
    return np.where(more, end, start), np.where(more, start, end)


def together(triangles, going, staying, count):
    """Which edges, from a vertex that goes to one that stays, may be contracted all at once: (k,) int array.

    Parameters
    ----------
    triangles : (t, 3) int array
        All those at the ends of the edges are among them.
    going, staying : (e,) int arrays
        The edges that are more wanted come first.
    count : int
        Of vertices.
    """
    if not len(going):
        return going
    stars, ends = Stars(triangles, count), np.stack((going, staying), axis=1)
    may = np.flatnonzero((stars.common(ends) == 2) & (stars.sizes[ends].max(axis=1) > 3))
    number, around = stars.around(ends[may])
    first = np.full(count, len(may))
    np.minimum.at(first, around, number)
    return may[np.bincount(number, first[around] < number, len(may)) == 0]


def drawn_in(triangles, going, staying, count):
    """Triangles with other vertices in place of some of so many, and which of them still have three."""
    becomes = np.arange(count, dtype=triangles.dtype)
    becomes[going] = staying
    triangles = becomes[triangles]
    return triangles, (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
