# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parting: a section at an axis of rotation, the line x = 0: where they meet, and what is on either side."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from ..contours import Section
from ..contours.loops import COINCIDENT

WIDTH = 1e-6  # of the size: sides that overlap in a strip of less mean width touch, on a grid of 4,194,304 cells


def on_axis(sections, mixed, screw):
    """The sections with the points that cannot be told from the axis moved onto it, so that x is 0.

    Of those in the middle of a stretch along the axis, and of such a stretch at the end of an open line, a rotation
    leaves nothing: they are dropped. In a mixed contour what lies on the axis is a part of its own, which stays there.
    """
    points = np.concatenate([section.points for section in sections])
    points[np.abs(points[:, 0]) <= COINCIDENT * np.hypot(*np.ptp(points, axis=0)), 0] = 0.0
    split = np.split(points, np.cumsum([len(section.points) for section in sections])[:-1])
    found = []
    for section, moved in zip(sections, split, strict=True):
        section = replace(section, points=moved)
        found += held(section, screw) if mixed and not section.closed else [without_stretches(section)]
    return found


def held(section, screw):
    """What of open lines is off the axis, and what lies along it: as many sections. A point on a screw's axis moves."""
    here = section.points[:, 0] == 0
    along = here & here[section.following]
    lines = {False: [], True: []}
    for start, end in zip(section.offsets[:-1].tolist(), section.offsets[1:].tolist(), strict=True):
        stays = along[start : max(end - 1, start + 1)] & (end - start > 1 or not screw)
        cuts = [0, *(np.flatnonzero(stays[1:] != stays[:-1]) + 1).tolist(), len(stays)]
        for first, past in zip(cuts[:-1], cuts[1:], strict=True):
            lines[bool(stays[first])].append(np.arange(start + first, min(start + past + 1, end)))
    return [chosen(section, runs) for runs in lines.values() if runs]


def chosen(section, runs):
    """The section of runs of a section's points."""
    order = np.concatenate(runs)
    offsets = np.cumsum([0, *map(len, runs)])
    return Section(section.points[order], offsets, section.sharp[order], section.closed)


def without_stretches(section):
    """The section without the points to which and from which it runs along the axis."""
    here = section.points[:, 0] == 0
    ahead, before = here[section.following], np.empty_like(here)
    before[section.following] = here
    if not section.closed:
        before[section.offsets[:-1]] = ahead[section.gaps] = True
    return kept(section, ~(here & ahead & before))


def kept(section, which):
    """The section with those of its points that (m,) bools say, and the loops of two of them at least."""
    counts = np.add.reduceat(which, section.offsets[:-1])
    which = which & (counts > 1)[section.loop_of]
    offsets = np.concatenate(([0], np.cumsum(counts[counts > 1])))
    return replace(section, points=section.points[which], sharp=section.sharp[which], offsets=offsets)


def sides(section):
    """Whether the section reaches to the left and to the right of the axis."""
    x = section.points[:, 0]
    return bool((x < 0).any()), bool((x > 0).any())


def with_crossings(section):
    """The section with a point wherever an edge crosses the axis."""
    start, end = section.points, section.points[section.following]
    edges = np.flatnonzero(start[:, 0] * end[:, 0] < 0)
    edges = edges[~np.isin(edges, section.gaps)]
    (x, y), (across, along) = start[edges].T, (end - start)[edges].T
    crossings = np.stack((np.zeros(len(edges)), y - x * along / across), axis=1)
    return replace(
        section,
        points=np.insert(start, edges + 1, crossings, axis=0),
        sharp=np.insert(section.sharp, edges + 1, False),
        offsets=section.offsets + np.searchsorted(edges, section.offsets),
    )


def parted(section):
    """The parts of a section on either side of the axis, each closed along the axis where the section is: sections.

    Examples
    --------
    >>> from ..contours import Rectangle
    >>> left, right = parted(Rectangle(2, 2).section())
    >>> left.areas.tolist(), right.points.tolist()
    ([2.0], [[0.0, -1.0], [1.0, -1.0], [1.0, 1.0], [0.0, 1.0]])
    """
    section = with_crossings(section)
    parts = tuple(part(section, side) for side, there in zip((-1, 1), sides(section), strict=True) if there)
    return parts or (section,)


def part(section, side):
    """What is on the left (-1) or on the right (1) of the axis, of a section with a point at each crossing."""
    whole, chains = runs(section, np.sign(section.points[:, 0]) == side)
    return chosen(section, [*whole, *(closed_up(section.points, chains) if section.closed else chains)])


def runs(section, there):
    """The loops that are there as a whole, and the chains of points that are, each with its ends on the axis."""
    whole, chains = [], []
    for start, end in zip(section.offsets[:-1].tolist(), section.offsets[1:].tolist(), strict=True):
        flags, points = there[start:end], np.arange(start, end)
        if flags.all():
            whole.append(points)
            continue
        if section.closed:  # begin with one that is not there
            points = np.roll(points, -int(np.argmin(flags)))
            points = np.append(points, points[0])
        flags = np.concatenate(([False], there[points], [False]))
        first, past = np.flatnonzero(~flags[:-1] & flags[1:]), np.flatnonzero(flags[:-1] & ~flags[1:])
        chains += [points[max(i - 1, 0) : j + 1] for i, j in zip(first.tolist(), past.tolist(), strict=True)]
    return whole, chains


def closed_up(points, chains):
    """Loops of chains joined along the axis: beside it what is inside lies between every other two of their ends.

    Ends in one place are ordered by the directions in which their chains leave the axis.
    """
    heads = [(*leaving(points, chain), i, False) for i, chain in enumerate(chains)]
    tails = [(*leaving(points, chain[::-1]), i, True) for i, chain in enumerate(chains)]
    ordered = sorted(heads + tails)
    following = {}
    for one, other in zip(ordered[::2], ordered[1::2], strict=True):
        (*_, tail, _), (*_, head, _) = sorted((one, other), key=lambda end: not end[-1])
        following[tail] = head
    while following:
        first, after = following.popitem()
        loop = [chains[first]]
        while after != first:
            loop.append(chains[after])
            after = following.pop(after)
        ring = np.concatenate(loop)
        yield ring[ring != np.roll(ring, -1)]


def leaving(points, chain):
    """Where on the axis a chain begins, and its slope there."""
    (_, y), (x, up) = points[chain[0]], points[chain[1]]
    return y, (up - y) / abs(x)


@lru_cache(maxsize=16)
def overlapping(sections):
    """Whether sections on both sides of the axis overlap when the plane is folded along it, as half a turn folds it.

    Areas do where they cover the same place, curves where they have an edge in common.

    Examples
    --------
    >>> from ..contours import Outline, Rectangle
    >>> overlapping(parted(Rectangle(2, 2).section()))
    True
    >>> overlapping(parted(Outline([[(-1, -1), (1, 1)]], closed=False).section()))
    False
    """
    left, right = ([folded(section) for section in sections if sides(section)[side]] for side in (0, 1))
    both = bool(left and right)
    return both and (areas_overlap(left + right) or not edges_of_curves(left).isdisjoint(edges_of_curves(right)))


def folded(section):
    """The section as it is to the right of the axis."""
    return replace(section, points=np.abs(section.points) * (1, 0) + section.points * (0, 1))


def areas_overlap(sections):
    """Whether areas cover a place twice: where what is covered an odd number of times is less than all of them."""
    from ..contours.filling import filled  # few turn so far

    areas = [section for section in sections if section.closed]
    loops = [loop for section in areas for loop in np.split(section.points, section.offsets[1:-1])]
    once = filled(loops, np.zeros(len(loops), dtype=int), np.array([True]))
    covered = sum(enclosed(*loop.T) for loop in once)
    twice = sum(abs(section.area) for section in areas) - covered
    size = np.ptp(np.concatenate([section.points for section in sections]), axis=0).max()
    return bool(twice > WIDTH * size * sum(section.edge_lengths.sum() for section in areas))


def enclosed(x, y):
    """The area that a loop encloses, to its left positive."""
    x, y = x - x[0], y - y[0]
    return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def edges_of_curves(sections):
    """The edges of the open ones of some sections off the axis, whichever way they run: a set of pairs of points."""
    curves = [section for section in sections if not section.closed]
    ends = [np.stack((section.points, section.points[section.following]), axis=1) for section in curves]
    rows = [np.delete(pairs, section.gaps, axis=0) for pairs, section in zip(ends, curves, strict=True)]
    return {tuple(sorted(map(tuple, pair))) for pairs in rows for pair in pairs.tolist()}
