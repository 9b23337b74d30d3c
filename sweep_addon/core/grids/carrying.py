# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From one grid to another: which of the old vertices lies where a new one does, along the path and round the contour.

Lengths are compared as parts of the whole, so the tip of a sweep stays its tip while it grows.
"""

import numpy as np


def sources(along, across, chart):
    """The old vertex that is nearest to each new one, along the path and then round the contour.

    Parameters
    ----------
    along, across : (n,) float array
        The arc length and the length round the contour at each old vertex: `arc_length` and `v` of its chart.
    chart : Chart
        Of the new vertices.

    Returns
    -------
    (m,) int array or None
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
    column = round_loops(columns, chart.columns()[0], grid)
    if not alone or column is None or (table < 0).any():
        return None
    ring = nearest(rings, chart.s, grid.closed)
    lines = table[ring[grid.whole]][:, column[grid.lines]].T
    tips, poles = table[ring[list(grid.tips)], 0], table[ring[0], column[list(grid.poles)]]
    return chart.spread(lines, tips, poles, np.int64)


def fill(table):
    """Put a tip into all columns of its ring, and a pole into all rings of its column."""
    tips = (np.count_nonzero(table >= 0, axis=1) == 1) & (table[:, 0] >= 0)
    table[tips] = table[tips, :1]
    poles = np.count_nonzero(table >= 0, axis=0) == 1
    table[:, poles] = table[:, poles].max(axis=0)


def round_loops(before, after, grid):
    """The old column that is nearest to each new one in its own loop: (m,) int array, or None where a loop is missing.

    The loops lie side by side, so each starts at the same part of the whole as before.
    """
    if len(before) == len(after):
        return np.arange(len(after))
    closed = grid.columns - 1 not in grid.gaps
    starts = np.append(nearest(before, after, closed)[list(grid.offsets[:-1])], len(before))
    if (np.diff(starts) < 1).any():
        return None
    found = [
        start + nearest(before[start:end], after[first:last], last - 1 not in grid.gaps)
        for start, end, first, last in zip(starts, starts[1:], grid.offsets, grid.offsets[1:], strict=False)
    ]
    return np.concatenate(found)


def nearest(before, after, closed):
    """The old one of some places that is nearest to each new one, on a line or on a ring of the same length.

    Parameters
    ----------
    before, after : (n,), (m,) float array
        Lengths, increasing.
    closed : bool
        Whether the last place leads to the first.

    Returns
    -------
    (m,) int array
    """
    known = parts(before, closed)
    known = np.append(known, 1.0) if closed else known
    return np.searchsorted((known[1:] + known[:-1]) / 2, parts(after, closed)) % len(before)


def parts(places, closed):
    """Places as parts of the whole, which ends with the last one, or a step behind one that leads to the first."""
    count, span = len(places), places[-1] - places[0]
    return (places - places[0]) * ((1 - closed / count) / span if span else 0.0)
