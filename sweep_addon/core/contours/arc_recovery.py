# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arcs recovered: chords whose corners lie on one circle, as drawings and curves are flattened, made an arc again."""

from dataclasses import replace

import numpy as np

from ..declared.parameters import require
from .outline import Outline
from .reading import argument

LEAST = 3  # chords: two lie on a circle whatever they are
WIDEST = np.radians(16)  # what a chord of a flattened curve turns at most, with room
FLATTEST = np.radians(0.02)  # what one turns at least: less is a line
UNEVEN = 4.0  # times the shortest chord of an arc is the longest; a side between two short ones lies on a circle too
CLOSE = 1e-5  # of the outline's size: from a circle; single precision and cubics in place of arcs miss it by less


def recover_arcs(outline, tolerance=0.0):
    """Make arcs of the chords of an outline that stand for arcs.

    Parameters
    ----------
    outline : Outline
        Closed; arcs that it has already stay.
    tolerance : float
        How far corners may be from the circle of their arc, in metres; 0 is a hundred-thousandth of the outline's size.

    Returns
    -------
    Outline
        With as few corners as that leaves; a whole circle has two.

    Raises
    ------
    ShapeError
        For an open outline.

    Examples
    --------
    >>> from sweep_addon.core.contours import Circle
    >>> ring = recover_arcs(Outline([Circle(2.0, 64).section().points]))
    >>> [len(loop) for loop in ring.loops], np.array(ring.bulges[0]).round(6).tolist()
    ([2], [1.0, 1.0])
    """
    require(isinstance(outline, Outline) and outline.closed, "must be a closed outline", outline, "outline")
    tolerance = argument("tolerance", tolerance, minimum=0.0)
    corners = np.concatenate([loop.values for loop in outline.loops])
    tolerance = tolerance or CLOSE * float(np.hypot(*np.ptp(corners, axis=0)))
    bulges = outline.bulges or [np.zeros(len(loop)) for loop in outline.loops]
    pairs = [
        recovered(np.array(loop), np.array(bulge), tolerance) for loop, bulge in zip(outline.loops, bulges, strict=True)
    ]
    loops, bulges = zip(*pairs, strict=True)
    return replace(outline, loops=loops, bulges=bulges)


def recovered(points, bulges, tolerance):
    """One loop with arcs: corners (k, 2) and the bulge after each."""
    count, turns, lengths = len(points), turned(points), np.hypot(*(np.roll(points, -1, axis=0) - points).T)
    first = starting(points, bulges, turns, lengths, tolerance)
    kept, made, here = [], [], 0
    while here < count:
        run = longest(points, bulges, turns, lengths, first + here, count - here, tolerance)
        at = (first + here) % count
        if run:
            circle = circle_of(points[np.arange(first + here, first + here + run + 1) % count])
            for corner, bulge in split(points, first + here, run, circle):
                kept.append(corner)
                made.append(bulge)
        else:
            kept.append(points[at])
            made.append(bulges[at])
        here += max(run, 1)
    return np.array(kept), np.array(made)


def turned(points):
    """The angle by which a loop turns at each of its corners, left positive: (n,)."""
    ahead = np.roll(points, -1, axis=0) - points
    before = np.roll(ahead, 1, axis=0)
    return np.arctan2(before[:, 0] * ahead[:, 1] - before[:, 1] * ahead[:, 0], (before * ahead).sum(axis=1))


def starting(points, bulges, turns, lengths, tolerance):
    """A corner within no arc, where the search begins; any on a circle."""
    fits = np.array([bool(longest(points, bulges, turns, lengths, k, LEAST, tolerance)) for k in range(len(points))])
    return int(np.argmin(np.roll(fits, 1) | np.roll(fits, 2)))


def longest(points, bulges, turns, lengths, start, most, tolerance):
    """How many chords from a corner on are of one arc; 0 where there are too few."""
    count, run = len(points), 0
    for size in range(LEAST, most + 1):
        index = np.arange(start, start + size + 1) % count
        inner = turns[index[1:-1]]
        alike = (np.sign(inner) == np.sign(inner[0])).all() and (bulges[index[:-1]] == 0).all()
        if not alike or np.abs(inner[-1]) > WIDEST or np.abs(inner[-1]) < FLATTEST:
            break
        centre, radius = circle_of(points[index])
        off = np.abs(np.hypot(*(points[index] - centre).T) - radius)
        chords = lengths[index[:-1]]
        if off.max() > tolerance or chords.max() > min(2 * radius * np.sin(WIDEST / 2), UNEVEN * chords.min()):
            break
        run = size
    return run


def circle_of(points):
    """The centre and the radius of the circle nearest to points (n, 2), by least squares of their powers.

    Source: Kasa: A circle fitting procedure and its error analysis, IEEE Trans. Instrum. Meas. 25, 1976.
    """
    middle = points.mean(axis=0)
    x = points - middle
    solved = np.linalg.lstsq(np.column_stack((2 * x, np.ones(len(x)))), (x**2).sum(axis=1), rcond=None)[0]
    return middle + solved[:2], float(np.sqrt(max(solved[2] + solved[:2] @ solved[:2], 0.0)))


def split(points, start, run, circle):
    """The corners and bulges of an arc, of one of more than half a turn in two."""
    index = np.arange(start, start + run + 1) % len(points)
    spokes = (points[index] - circle[0]) @ (1, 1j)
    angles = np.angle(spokes[1:] / spokes[:-1])
    parts = [(0, run)] if abs(angles.sum()) <= np.pi * 1.0001 else [(0, run // 2), (run // 2, run)]
    for begin, end in parts:
        yield points[index[begin]], float(np.tan(angles[begin:end].sum() / 4))
