# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mending: loops that cross and touch a little, as those of drawings do, become loops that do not."""

import numpy as np

from ..meshes.runs import following, run_of
from .filling import filled
from .nesting import nesting

SLIP = 1e-3  # of the square of the size: less area than that may count twice, or not at all; real icons slip so far


def mended(loops):
    """Loops around what loops fill, even-odd, if they do not meet but for slips of the hand.

    Parameters
    ----------
    loops : sequence of (n, 2) float arrays
        Closed loops.

    Returns
    -------
    list of (n, 2) float arrays
        Loops that do not meet. Empty where the given ones fill nothing, or where what they fill differs from what they
        enclose by more than a thousandth of the square of their size: those mean to cross.

    Examples
    --------
    A corner with a spike, and an hourglass:

    >>> spike = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 1.2), (1.0, 1.0), (0.0, 1.0)])
    >>> hourglass = np.array([(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)])
    >>> [len(loop) for loop in mended([spike])], mended([hourglass])
    ([4], [])
    """
    made = filled(loops, np.zeros(len(loops), dtype=int), np.array([True]))
    given = np.concatenate(loops)
    missed = abs(enclosed(loops) - enclosed(made)) if made else np.inf
    return made if missed <= SLIP * np.ptp(given, axis=0).max() ** 2 else []


def enclosed(loops):
    """The area in loops, that of holes taken off."""
    points, offsets = laid(loops)
    x, y = (points - points[offsets[:-1]][run_of(offsets)]).T
    after = following(offsets)
    areas = np.abs(np.add.reduceat(x * y[after] - y * x[after], offsets[:-1])) / 2
    return float(areas @ np.where(depths(loops) % 2, -1, 1))


def depths(loops):
    """(k,) int array: how many loops each lies in, by two of three of its points, as one may be where it slips."""
    turned = ([np.roll(loop, -(len(loop) * third // 3), axis=0) for loop in loops] for third in range(3))
    votes = np.concatenate([nesting(*laid(each)) for each in turned])
    pairs, count = np.unique(votes @ (len(loops), 1), return_counts=True)
    return np.bincount(pairs[count > 1] // len(loops), minlength=len(loops))


def laid(loops):
    return np.concatenate(loops), np.cumsum([0, *map(len, loops)])
