# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From one grid to another: between which of the old vertices a new one lies, along the path and round the contour.

Lengths are compared as parts of the whole, so the tip of a sweep stays its tip while it grows. What the nearest vertex
had would not do: a slider takes one step after another, and the middle would drift by half a step with each.
"""

from typing import NamedTuple

import numpy as np

EXACT = 1e-4  # of a step: so near to an old ring or column a new one is at it, for lengths are kept in single precision


class Between(NamedTuple):
    """Between which old things each new one lies.

    Parameters
    ----------
    around : (2, 2, n) int array
        The old ones before and behind it along the path, each before and behind it round the contour.
    along, across : (n,) float array
        Which part of the way it is from those before to those behind it, along the path and round the contour.
    """

    around: np.ndarray
    along: np.ndarray
    across: np.ndarray

    def of(self, which):
        """The same of some of them, or of others that have it from them: (k,) int array to `Between`."""
        return Between(self.around[..., which], self.along[which], self.across[which])

    @property
    def nearest(self):
        """The nearest old one: (n,) int array."""
        number = np.arange(len(self.along))
        return self.around[(self.along > 0.5).astype(int), (self.across > 0.5).astype(int), number]

    def blended(self, values):
        """Values of the old ones, (m,) or (m, k), at the new ones, linear in both ways."""
        before = mixed(values, *self.around[0], self.across)
        if not self.along.any():
            return before
        behind = mixed(values, *self.around[1], self.across)
        return before + (behind - before) * sided(self.along, values)


def mixed(values, low, high, part):
    """Values between those of two, which are the first where the part is 0."""
    first = values[low]
    return first + (values[high] - first) * sided(part, values) if part.any() else first


def sided(part, values):
    """Parts as they multiply rows of such values."""
    return part.astype(values.dtype).reshape(-1, *(1,) * (values.ndim - 1))


def sources(along, across, chart):
    """Between which old vertices each new one lies, along the path and round the contour.

    Parameters
    ----------
    along, across : (n,) float array
        The arc length and the length round the contour at each old vertex: `arc_length` and `v` of its chart.
    chart : Chart
        Of the new vertices.

    Returns
    -------
    Between or None
        None where the old vertices are not those of one grid, or it had fewer loops.
    """
    rings, ring = np.unique(along, return_inverse=True)
    columns, column = np.unique(across, return_inverse=True)
    if len(rings) * len(columns) > 2 * len(along) + 1:
        return None
    table = np.full((len(rings), len(columns)), -1)
    table[ring, column] = np.arange(len(along))
    alone = np.count_nonzero(table >= 0) == len(along)
    fill(table)
    grid = chart.grid
    round_contour = round_loops(columns, chart.columns()[0], grid)
    if not alone or round_contour is None or (table < 0).any():
        return None
    *rings, along = between(rings, chart.s, grid.closed)
    *columns, across = round_contour
    whole, tips, lines, poles = grid.whole, list(grid.tips), grid.lines, list(grid.poles)

    def vertices(ring, column):
        tip, pole = table[ring[tips], 0], table[ring[0], column[poles]]
        return chart.spread(table[ring[whole]][:, column[lines]].T, tip, pole, np.int64)

    around = np.array([[vertices(ring, column) for column in columns] for ring in rings])
    along = chart.spread(along[whole], along[tips], along[0], float)
    return Between(around, along, chart.spread(across[lines, None], 0.0, across[poles], float))


def fill(table):
    """Put a tip into all columns of its ring, and a pole into all rings of its column."""
    tips = (np.count_nonzero(table >= 0, axis=1) == 1) & (table[:, 0] >= 0)
    table[tips] = table[tips, :1]
    poles = np.count_nonzero(table >= 0, axis=0) == 1
    table[:, poles] = table[:, poles].max(axis=0)


def round_loops(before, after, grid):
    """Between which old columns of its own loop each new one lies: as `between`, or None where a loop is missing.

    The loops lie side by side, so each starts at the same part of the whole as before.
    """
    if len(before) == len(after):
        return np.arange(len(after)), np.arange(len(after)), np.zeros(len(after))
    low, high, part = between(before, after, grid.columns - 1 not in grid.gaps)
    starts = np.append(np.where(part > 0.5, high, low)[list(grid.offsets[:-1])], len(before))
    if (np.diff(starts) < 1).any():
        return None
    found = []
    for start, end, first, last in zip(starts, starts[1:], grid.offsets, grid.offsets[1:], strict=False):
        low, high, part = between(before[start:end], after[first:last], last - 1 not in grid.gaps)
        found.append((start + low, start + high, part))
    return tuple(map(np.concatenate, zip(*found, strict=True)))


def between(before, after, closed):
    """Between which old places each new one lies, on a line or on a ring of the same length.

    Parameters
    ----------
    before, after : (n,), (m,) float array
        Lengths, increasing.
    closed : bool
        Whether the last place leads to the first.

    Returns
    -------
    low, high : (m,) int array
    part : (m,) float array
        Which part of the way it is from the low one to the high one.
    """
    known, wanted = parts(before, closed), parts(after, closed)
    known = np.append(known, 1.0) if closed else known
    low = np.searchsorted(known, wanted, side="right") - 1
    high = np.minimum(low + 1, len(known) - 1)
    gap = known[high] - known[low]
    part = (wanted - known[low]) / np.where(gap > 0, gap, 1.0)
    low = np.where(part > 1 - EXACT, high, low)
    part[(part < EXACT) | (part > 1 - EXACT)] = 0.0
    return low % len(before), high % len(before), part


def parts(places, closed):
    """Places as parts of the whole, which ends with the last one, or a step behind one that leads to the first."""
    whole = places[-1] - places[0]
    if closed and len(places) > 1:
        whole += np.median(np.diff(places))
    return (places - places[0]) / (whole or 1.0)
