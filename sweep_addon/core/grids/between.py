# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From one grid to another: between which of the old vertices a new one lies, along the path and round the contour.

Lengths are compared as parts of the whole, so the tip of a sweep stays its tip while it grows. What the nearest vertex
had would not do: a slider takes one step after another, and the middle would drift by half a step with each.
"""

from typing import NamedTuple

import numpy as np

EXACT = 1e-4  # of a step: so near to an old ring or column a new one is at it, for lengths are kept in single precision
EVEN, ROUGHLY = 1e-3, 0.1  # of a step: how far even steps are apart, and by how much chords may be wrong


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


def sources(along, across, places, edges, chart):
    """Between which old vertices each new one lies, along the path and round the contour.

    Parameters
    ----------
    along, across : (n,) float array
        The arc length and the length round the contour at each old vertex: `arc_length` and `v` of its chart.
    places : (n, 3) float array
        The old vertices, which tell how far it is from the last ring or column to the first.
    edges : (e, 2) int array
        The old edges, which tell whether there is such a step.
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
    pole = np.count_nonzero(table >= 0, axis=0) == 1
    fill(table)
    if not alone or (table < 0).any():
        return None
    grid, spots, level = chart.grid, places[table], ring[edges[:, 0]] == ring[edges[:, 1]]
    round_contour = round_loops(columns, spots.swapaxes(0, 1), column[edges[level]], chart)
    if round_contour is None:
        return None
    lines = edges[~pole[column[edges]].any(axis=1)]  # a pole is at all rings, though it is counted with the first
    _, step = closing(rings, spots.mean(axis=1, keepdims=True), ring[lines], chart.total)
    *rings, along = between(rings, chart.s, step, chart.total - np.ptp(chart.s) if grid.closed else None)
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


def round_loops(before, spots, edges, chart):
    """Between which old columns of its own loop each new one lies: as `between`, or None where a loop is missing.

    The loops lie side by side, so each starts at the same part of the whole as before, and ends where the next one
    starts: only the closing step of the last is to be measured.
    """
    (after, ends), offsets = chart.columns(), chart.grid.offsets
    if len(before) == len(after):
        return np.arange(len(after)), np.arange(len(after)), np.zeros(len(after))
    steps = [None if last - 1 in chart.grid.gaps else ends[last - 1] - after[last - 1] for last in offsets[1:]]
    final, measured = closing(before, spots, edges, ends[-1] - after[offsets[-2]])
    low, high, part = between(before, after, measured, steps[-1])
    starts = np.where(part > 0.5, high, low)[list(offsets[:-1])]
    starts[-1] = starts[-1] if measured is None else final
    bounds = np.append(starts, len(before))
    if (np.diff(bounds) < 1).any():
        return None
    found = []
    for start, end, first, last, new in zip(bounds, bounds[1:], offsets, offsets[1:], steps, strict=False):
        old = before[end] - before[end - 1] if end < len(before) else measured
        low, high, part = between(before[start:end], after[first:last], old, new)
        found.append((start + low, start + high, part))
    return tuple(map(np.concatenate, zip(*found, strict=True)))


def closing(lengths, spots, edges, whole):
    """To which place the last leads, and how long that step is, as lengths are measured; 0 and None where to none.

    Parameters
    ----------
    lengths : (n,) float array
    spots : (n, k, 3) float array
        Where the places are in space, on k lines. The step is to the others as it is there, so scale does not matter.
    edges : (e, 2) int array
        Which places edges join. Most often those round a loop, and at ends perhaps those inside a cap.
    whole : float
        How long the new line is. Chords in space tell the step roughly: it is just what the even steps before are, or
        what is left of a line that is as long as the new one, where that is about the same.
    """
    last = len(lengths) - 1
    joined = edges[(edges == last).any(axis=1)].min(axis=1)
    counts = np.bincount(joined[joined < last - 1], minlength=1)
    if not counts.any():
        return 0, None
    first = int(np.flatnonzero(counts == counts.max())[-1])
    apart = np.linalg.norm(np.diff(spots[first:], axis=0, append=spots[first : first + 1]), axis=-1).sum(axis=1)
    span, steps = lengths[last] - lengths[first], np.diff(lengths[first:])
    known = apart[:-1].sum()
    found = span * apart[-1] / known if known > 0 else 0.0
    likely = ([np.median(steps)] if np.ptp(steps) < EVEN * steps.max() else []) + [whole - span]
    return first, next((step for step in likely if abs(step - found) < ROUGHLY * found), found)


def between(before, after, old, new):
    """Between which old places each new one lies, on a line or on a ring of the same length.

    Parameters
    ----------
    before, after : (n,), (m,) float array
        Lengths, increasing.
    old, new : float or None
        How long the step is that leads from the last place to the first, before and after; None where none does. A
        line that is bent to a ring meets itself: its last place is the first as well.

    Returns
    -------
    low, high : (m,) int array
    part : (m,) float array
        Which part of the way it is from the low one to the high one.
    """
    known, wanted = parts(before, old), parts(after, new)
    known = np.append(known, 1.0) if old is not None else known
    low = np.searchsorted(known, wanted, side="right") - 1
    high = np.minimum(low + 1, len(known) - 1)
    gap = known[high] - known[low]
    part = (wanted - known[low]) / np.where(gap > 0, gap, 1.0)
    low = np.where(part > 1 - EXACT, high, low)
    part[(part < EXACT) | (part > 1 - EXACT)] = 0.0
    return low % len(before), high % len(before), part


def parts(places, step):
    """Places as parts of the whole, which ends with the last one, or a step behind one that leads to the first."""
    whole = places[-1] - places[0] + (step or 0.0)
    return (places - places[0]) / (whole or 1.0)
