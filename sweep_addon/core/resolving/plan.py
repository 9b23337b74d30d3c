# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a sweep is taken apart: into tubes that do not cross themselves, folds, and what nothing comes near."""

import numpy as np

from ..declared.frozen import individual

ROOM = 2  # chunks beside those that come near something, which are given to the boolean too
NONE = -2  # no chunk, and not the one before the first either


@individual
class Plan:
    """The parts of a sweep.

    Parameters
    ----------
    tubes : tuple of (int, int)
        The first and the last ring of each tube. One that follows another begins a segment before that ends: tubes that
        share a ring and no more leave specks between them.
    folds : tuple of (int, int)
        The first and the last ring of each stretch in which contours fold.
    untouched : (segments,) bool array
        The segments that are in none of them.
    """

    tubes: tuple
    folds: tuple
    untouched: np.ndarray


def planned(chunks, closed, everything=False):
    """The `Plan` of a sweep by its `Chunks`.

    Long runs of chunks give few tubes: each ends only where the next chunk might meet one of its own. What nothing
    comes near is left out unless ``everything`` is asked for.
    """
    count = len(chunks.folded)
    busy = near(chunks.conflict.any(axis=1) | chunks.folded, closed) | everything
    origin = beginning(busy, chunks.folded) if closed else 0
    order = (np.arange(count) + origin) % count
    busy, folded, conflict = busy[order], chunks.folded[order], chunks.conflict[np.ix_(order, order)]
    ring = chunks.start[origin] + np.concatenate(([0], np.cumsum(np.diff(chunks.start)[order])))
    kind = np.where(folded, 2, busy)
    change = np.flatnonzero(np.diff(kind)) + 1
    tubes, folds = [], []
    for a, b in zip([0, *change], [*change, count], strict=True):
        if kind[a] == 2:
            folds.append((int(ring[a]), int(ring[b])))
        elif kind[a] == 1:
            round_all = closed and b - a == count
            tubes += [(int(ring[i] - lap), int(ring[j])) for i, j, lap in cut(conflict, a, b, round_all)]
    untouched = np.roll(np.repeat(kind == 0, np.diff(ring)), chunks.start[origin])
    return Plan(tuple(tubes), tuple(folds), untouched)


def near(busy, closed):
    """Chunks and those beside them: (k,) bool array."""
    wide = busy.copy()
    for step in range(1, ROOM + 1):
        for shift in (-step, step):
            beside = np.roll(busy, shift)
            if not closed:
                beside[: max(shift, 0)] = beside[len(busy) + min(shift, 0) :] = False
            wide |= beside
    return wide


def beginning(busy, folded):
    """The chunk that a closed sweep is best counted from: one that nothing comes near, else one where a fold begins."""
    for good in (~busy, folded & ~np.roll(folded, 1)):
        if good.any():
            return int(good.argmax())
    return 0


def cut(conflict, start, end, round_all):
    """Cut chunks that do not fold into runs that do not meet themselves.

    Parameters
    ----------
    conflict : (k, k) bool array
    start, end : int
        From which chunk to before which.
    round_all : bool
        Whether the last is followed by the first, so that the first run too begins in what is before it.

    Yields
    ------
    first, end, lap : int
        Of each run; with a lap of 1 a run holds the last segment of the chunk before it.
    """
    number = np.arange(len(conflict))
    latest = np.where(np.tril(conflict, -1), number, NONE).max(axis=1)  # the last one before each that it might meet
    first, lap = start, int(round_all)
    while first < end:
        meets = latest[first + 1 : end] >= first - lap
        if lap and not first:
            meets |= conflict[first + 1 : end, -1]
        stop = first + 1 + int(meets.argmax()) if meets.any() else end
        yield first, stop, lap
        first, lap = stop, 1
