# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which stretches of a sweep come so near to each other that they might meet."""

import numpy as np

from ..declared.frozen import individual
from ..vectors import dot, norms

FINE = 4  # chunks to the radius of a contour
MOST = 1500  # chunks: all pairs of them are looked at


@individual
class Chunks:
    """A sweep cut into short stretches, and which of them might meet.

    Parameters
    ----------
    start : (k + 1,) int array
        The segment that each begins with, and how many there are.
    folded : (k,) bool array
        Where contours fold; elsewhere they move forward everywhere.
    conflict : (k, k) bool array
        Balls round two of them touch, and on every way from one to the other the contours' planes turn by more than a
        right angle: where they turn by less, what moves forward everywhere cannot meet what it has left.
    """

    start: np.ndarray
    folded: np.ndarray
    conflict: np.ndarray


def chunks(rings):
    """The `Chunks` of `Rings`, in the order of the grid."""
    step = norms(np.diff(rings.centres, axis=0, append=rings.centres[:1]))[: rings.segments]
    s = np.concatenate(([0.0], np.cumsum(step)))
    long, folded = max(rings.radii.max() / FINE, s[-1] / MOST), rings.folded
    steady = np.flatnonzero(np.diff(np.floor(s[:-1] / long))) + 1
    change = np.flatnonzero(folded[1:] != folded[:-1]) + 1
    start = np.unique(np.concatenate(([0], steady, change, [rings.segments])))
    return Chunks(start, folded[start[:-1]], touching(*balls(rings, start)) & turning(rings, start))


def balls(rings, start):
    """Balls round chunks: their middles (k, 3) and radii (k,)."""
    first, last = start[:-1], start[1:] % len(rings.centres)
    middle = (rings.centres[first] + rings.centres[last]) / 2
    reach = norms(rings.centres[: start[-1]] - np.repeat(middle, np.diff(start), axis=0))
    reach = np.maximum.reduceat(reach + rings.radii[: start[-1]], first)
    return middle, np.maximum(reach, norms(rings.centres[last] - middle) + rings.radii[last])


def touching(middle, radius):
    """Which balls touch: (k, k) bool array."""
    size = dot(middle, middle)
    squared = size[:, None] + size - 2 * middle @ middle.T
    return squared <= (radius[:, None] + radius) ** 2


def turning(rings, start):
    """Between which chunks, none of them neighbours, the rings' planes turn by more than a right angle: (k, k) bool."""
    turned = np.concatenate(([0.0], np.cumsum(rings.turns)))
    low, high, number = turned[start[:-1]], turned[start[1:]], np.arange(len(start) - 1)
    turn, between = high - low[:, None], np.abs(number - number[:, None])
    if rings.closed:
        turn = np.minimum(turn, turned[-1] - low + high[:, None])
        between = np.minimum(between, len(number) - between)
    turn = np.triu(turn > np.pi / 2)
    return (turn | turn.T) & (between > 1)
