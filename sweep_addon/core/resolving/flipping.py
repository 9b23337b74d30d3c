# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flipping: thin triangles of a closed surface go where they and their neighbours share out their space otherwise."""

import numpy as np

from ..vectors import norms
from .heights import OTHER, heights
from .stars import rim


def flipped(vertices, triangles, faces, thin, fixed):
    """Give the two triangles at the longest side of a thin one the other diagonal, where neither is thin then.

    Parameters
    ----------
    vertices : (n, 3) float array
        They stay where they are.
    triangles : (t, 3) int array
        A closed manifold, or a part of one, at whose boundary nothing changes.
    faces : (t,) int array
        What each triangle is a part of.
    thin : float
        Triangles that are less high above their longest side are thin, in metres: so far the surface may move.
    fixed : (n,) bool array
        The vertices that are to stay: triangles of which all are, too.

    Returns
    -------
    triangles : (t, 3) int array
        The same array where nothing could be done.
    faces : (t,) int array
        Both new triangles are of the face that was not thin.

    The corner across a longest side is above that side, so the surface moves by no more than the height. Where both are
    thin the shorter of the two diagonals serves, whatever comes of it: their sides become shorter with each turn until
    one may be contracted, or its neighbour is not thin. No edge is made that there is, or its triangles would be four.

    Examples
    --------
    A corner of this tetrahedron is cut off so low that a face is next to nothing:

    >>> vertices = np.array([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2), (1, -1e-9, 0)])
    >>> sides = np.array([(0, 2, 1), (0, 3, 2), (1, 2, 3), (0, 1, 4), (0, 4, 3), (4, 1, 3)])
    >>> triangles, _ = flipped(vertices, sides, np.arange(6), 1e-6, np.full(5, False))
    >>> triangles[[0, 3]].tolist()
    [[2, 1, 4], [4, 0, 2]]
    """
    outer = rim(triangles, len(vertices))
    while True:
        stay = fixed[triangles].all(axis=1)
        one, other, new, instead = exchanges(vertices, triangles, thin, stay | outer[triangles].any(axis=1), stay)
        if not len(one):
            return triangles, faces
        triangles, faces = triangles.copy(), faces.copy()
        triangles[one], triangles[other] = new, instead
        faces[one] = faces[other]


def exchanges(vertices, triangles, thin, barred, stay):
    """Diagonals that may be exchanged all at once.

    Parameters
    ----------
    vertices, triangles : arrays
    thin : float
    barred, stay : (t,) bool arrays
        Which triangles are not to go because they are thin, and which are not to go as the neighbour of a thin one.

    Returns
    -------
    one, other : (k,) int arrays
        The thin triangle and its neighbour.
    new, instead : (k, 3) int arrays
        What they become.
    """
    low, lengths = heights(vertices, triangles)
    one = np.flatnonzero((low < thin) & ~barred)
    side = lengths[:, one].argmax(axis=0)
    a, b, c = (triangles[one, corner] for corner in (side, OTHER[side], OTHER[OTHER[side]]))
    longest = lengths[side, one]

    wide = np.int64(len(vertices))
    keys = triangles.ravel() * wide + triangles[:, OTHER].ravel()
    order = np.argsort(keys)
    keys = keys[order]
    back = order[np.searchsorted(keys, b * wide + a)]
    other, d = back // 3, triangles[back // 3, OTHER[OTHER[back % 3]]]

    made = np.minimum(c, d) * wide + np.maximum(c, d)
    there = keys[np.searchsorted(keys, made).clip(0, len(keys) - 1)] == made
    new, instead = np.stack((c, a, d), axis=1), np.stack((d, b, c), axis=1)
    high = np.minimum(heights(vertices, new)[0], heights(vertices, instead)[0]) >= thin
    shorter = norms(vertices[c] - vertices[d]) < longest
    good = np.flatnonzero(~there & ~stay[other] & (high | (low[other] < thin) & shorter))
    good = good[independent(len(triangles), one[good], other[good], made[good])]
    return one[good], other[good], new[good], instead[good]


def independent(count, one, other, made):
    """Of pairs of triangles, each of which makes an edge, those that share none with an earlier one: (k,) int array."""
    number = np.arange(len(one))
    first = np.full(count, len(one))
    np.minimum.at(first, one, number)
    np.minimum.at(first, other, number)
    alone = np.flatnonzero((first[one] == number) & (first[other] == number))
    return alone[np.unique(made[alone], return_index=True)[1]]
