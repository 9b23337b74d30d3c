# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Raw loops: points as they come from people and files, checked before they become a section."""

import numpy as np

from ..declared.parameters import LARGEST, ShapeError, require
from ..later import later
from ..meshes.runs import following, run_of
from .outline import MOST_POINTS

crossings = later("core.contours.crossing", "crossings")

COINCIDENT = 1e-7  # of the size of all loops: what Blender's single precision cannot tell apart


def joined(loops):
    """All points of loops that may be anything as an (m, 2) float array, and the (k + 1,) offsets between them."""
    arrays = [checked_numbers(loop, spoken(i, len(loops))) for i, loop in enumerate(loops)]
    require(arrays, "must have at least one loop", arrays)
    offsets = np.cumsum([0, *(len(array) for array in arrays)])
    require(offsets[-1] <= MOST_POINTS, f"must have at most {MOST_POINTS} points", int(offsets[-1]))
    return np.concatenate(arrays), offsets


def checked_numbers(loop, which):
    """One loop as an (n, 2) float array of sensible numbers."""
    try:
        points = np.asarray(loop, dtype=np.float64)
    except (TypeError, ValueError):
        points = np.empty(0)
    require(points.size and points.ndim == 2 and points.shape[1] == 2, f"{which}must be a list of 2 numbers each", loop)
    bad = ~(np.abs(points) <= LARGEST).all(axis=1)
    if bad.any():
        i = int(bad.argmax())
        x, y = points[i]
        raise ShapeError(f"{which}must have finite numbers up to {LARGEST:g}, got ({x:g}, {y:g}) at point {i}")
    return points


def apart(points, offsets, closed=True):
    """(m,) bool array: whether each point does not coincide with the next of its loop."""
    step = np.hypot(*(points[following(offsets)] - points).T)
    if not closed:
        step[offsets[1:] - 1] = np.inf
    return step > COINCIDENT * np.hypot(*np.ptp(points, axis=0))


def without_coincident(points, offsets, sharp, closed=True):
    """The points that do not coincide with the next of their loop, which inherits their sharpness; refuses too few."""
    kept = np.flatnonzero(apart(points, offsets, closed))
    kept_offsets, least = np.searchsorted(kept, offsets), 3 if closed else 2
    for i, n in enumerate(np.diff(kept_offsets).tolist()):
        require(n >= least, f"{spoken(i, len(offsets) - 1)}must have at least {least} different points", n)
    flagged = np.flatnonzero(sharp)
    loop = run_of(offsets)[flagged]
    heir = np.searchsorted(kept, flagged)
    flags = np.zeros(len(kept), dtype=bool)
    flags[np.where(heir < kept_offsets[loop + 1], heir, kept_offsets[loop])] = True
    return points[kept], kept_offsets, flags


def require_area(points, offsets):
    """Refuse a loop whose points all lie on one line."""
    firsts, loop = offsets[:-1], run_of(offsets)
    x, y = (points - points[firsts][loop]).T
    farthest = np.lexsort((np.hypot(x, y), loop))[offsets[1:] - 1][loop]
    width = np.maximum.reduceat(np.abs(x * y[farthest] - y * x[farthest]), firsts)
    length = np.maximum.reduceat(x * x + y * y, firsts)
    for i in np.flatnonzero(width <= COINCIDENT * length):
        n = int(offsets[i + 1] - offsets[i])
        raise ShapeError(f"{spoken(i, len(firsts))}must enclose an area, got {n} points on one line")


def require_apart(points, offsets, closed=True):
    """Refuse loops that cross or touch themselves or each other."""
    after = following(offsets)
    if not closed:
        after[offsets[1:] - 1] = offsets[1:] - 1  # an edge of no length
    for i, j in crossings(points, after)[:1]:
        x, y = meeting_point(points[i], points[after[i]], points[j], points[after[j]])
        first, second = sorted(run_of(offsets)[[i, j]].tolist())
        which = f"loops {first} and {second} must not cross or touch each other"
        if first == second:
            which = f"{spoken(first, len(offsets) - 1)}must not cross or touch itself"
        raise ShapeError(f"{which}, got a crossing near ({x:.6g}, {y:.6g})")


def meeting_point(a, b, c, d):
    """Where the edges from a to b and from c to d cross; c, if they are parallel."""
    (ux, uy), (vx, vy), (wx, wy) = b - a, d - c, c - a
    across = ux * vy - uy * vx
    return c if across == 0 else a + (b - a) * ((wx * vy - wy * vx) / across)


def spoken(i, many):
    """How a refusal begins: with the number of the loop, if there are several."""
    return f"loop {i} " if many > 1 else ""
