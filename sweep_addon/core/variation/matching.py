# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Matching: contours of any points brought to common columns, which keep every point of each.

A loop is a row of complex numbers, and each of its points has a place from 0 to 1: its part of the way round. Places
of different loops that mean the same are made equal. The columns are all places there are: each loop is read there.
"""

from typing import NamedTuple

import numpy as np

from ..contours import Section
from ..declared.parameters import require, spelled
from .morph import Match

LOOKED_AT = 1024  # places round a loop at which it is compared with another
ALIKE = 1e-9  # of the best likeness: as good
WELDED = 1e-4  # of the way round: points so close become one column


class Loop(NamedTuple):
    """One loop of one contour."""

    points: np.ndarray  # (m,) complex
    sharp: np.ndarray  # (m,) bool
    places: np.ndarray  # (m,) float, from 0 to 1 by arc length

    @property
    def corners(self):
        """The places of the corners: (c,)."""
        return self.places[self.sharp]


def matched(sections, match):
    """The same sections with points that belong together.

    Parameters
    ----------
    sections : sequence of Section
    match : Match

    Returns
    -------
    tuple of Section
        With common offsets, and each sharp where it was.

    Raises
    ------
    ShapeError
        Where they have not as many outlines and holes, corners or points; its key is the number of the section.

    Examples
    --------
    >>> from ..contours import Circle, Rectangle
    >>> square, disc = matched([Rectangle(2, 2).section(), Circle(1, points=6).section()], Match.BY_ARC_LENGTH)
    >>> len(square.points), len(disc.points), round(square.area, 12), int(square.sharp.sum())
    (10, 10, 4.0, 4)
    """
    first = sections[0]
    for number, section in enumerate(sections):
        wanted, got = described(first), described(section)
        require(wanted == got, f"must have {wanted} as the first contour has", got, f"{number}")
    found = []
    for loops in zip(*map(loops_of, sections), strict=True):
        placed = by_index(loops) if match is Match.BY_INDEX else by_way(loops, first.closed, match)
        columns = np.unique(np.concatenate([loop.places for loop in placed]))
        sharp = [np.isin(columns, loop.corners) for loop in placed]
        found.append((read(placed, columns, first.closed), np.stack(sharp)))
    points, sharp = (np.concatenate(part, axis=1) for part in zip(*found, strict=True))
    offsets = np.concatenate(([0], np.cumsum([rows.shape[1] for rows, _ in found])))
    places = np.stack((points.real, points.imag), axis=2)
    return tuple(Section(*each, first.closed) for each in zip(places, [offsets] * len(sharp), sharp, strict=True))


def described(section):
    """The outlines of a section and their holes, in words."""
    if not section.closed:
        return counted(len(section.offsets) - 1, "open line")
    holes = [len(island) - 1 for island in section.islands]
    said = counted(len(holes), "outline")
    if len(holes) > 1 and any(holes):
        return f"{said} with {', '.join(map(str, holes))} holes"
    return f"{said} with {counted(holes[0], 'hole')}" if holes[0] else said


def counted(number, noun):
    return f"{number} {noun}{'' if number == 1 else 's'}"


def loops_of(section):
    """The loops of a section, each outline before its holes."""
    order = [loop for island in section.islands for loop in island]
    for loop in order if section.closed else range(len(section.offsets) - 1):
        part = slice(*section.offsets[loop : loop + 2])
        reached = np.concatenate(([0.0], np.cumsum(section.edge_lengths[part])))
        whole = reached[-1]
        yield Loop(section.points[part] @ (1, 1j), section.sharp[part], reached[:-1] / whole)


def by_index(loops):
    """The loops with places that are their points' numbers."""
    count = len(loops[0].points)
    for number, loop in enumerate(loops):
        sentence = f"must have {counted(count, 'point')} as the first contour where the match is by-index"
        require(len(loop.points) == count, sentence, len(loop.points), f"{number}")
    return [loop._replace(places=np.arange(count) / count) for loop in loops]


def by_way(loops, closed, match):
    """The loops with places that mean the same in each, by the way round and where it is asked for by corners."""
    placed, corners = [loops[0]], loops[0].corners
    for number, loop in enumerate(loops[1:], 1):
        if match is Match.BY_CORNER and len(loop.corners) and len(corners):
            sentence = f"must have {counted(len(corners), 'corner')} as those before it or none where the match is "
            alike = len(loop.corners) == len(corners)
            require(alike, sentence + spelled(match), len(loop.corners), f"{number}")
            loop = cornered(loop, corners, placed[-1], closed)
        elif closed:
            loop = loop._replace(places=loop.places + least_turn(*read((placed[-1], loop), EVEN, closed)))
        loop = welded(loop, np.unique(np.concatenate([each.places for each in placed])), closed)
        corners = corners if len(corners) else np.sort(loop.corners)
        placed.append(loop)
    return placed


EVEN = np.arange(LOOKED_AT) / LOOKED_AT


def cornered(loop, corners, last, closed):
    """A loop with its corners at some places, those of the loop before it."""
    own = loop.corners
    if not closed:
        return loop._replace(places=np.interp(loop.places, [0, *own, 1], [0, *corners, 1]))
    own_points, wanted = loop.points[loop.sharp], read((last,), corners, closed)[0]
    turn = round(least_turn(wanted, own_points) * len(own))
    first = own[-turn % len(own)]
    along = np.append((np.roll(own, turn) - first) % 1, 1.0)
    onto = np.append(corners - corners[0], 1.0)
    return loop._replace(places=np.interp((loop.places - first) % 1, along, onto) + corners[0])


def least_turn(last, loop):
    """By what part of the way round a loop must begin earlier to lie as near to the last one as it can.

    Both are (n,) complex, at as many places. The squares of all distances are least where the loops correlate most,
    wherever their centres are; a parabola through the best turn and its neighbours finds it between places.
    """
    likeness = np.fft.fft(np.conj(np.fft.fft(last)) * np.fft.fft(loop)).real
    count = len(likeness)
    turns = (np.arange(count) + count // 2) % count - count // 2
    best = np.flatnonzero(likeness >= likeness.max() - ALIKE * np.abs(likeness).max())
    best = best[np.abs(turns[best]).argmin()]
    before, here, after = likeness[[best - 1, best, (best + 1) % count]]
    bend = before - 2 * here + after
    between = (before - after) / (2 * bend) if bend < 0 else 0.0
    return (turns[best] + between) / count


def welded(loop, columns, closed):
    """A loop with places in 0 to 1, those that are nearly a column made one if none of its points is nearer to it."""
    places = loop.places % 1 if closed else loop.places
    onto = nearest(places, columns, closed)
    apart = np.abs(places - columns[onto])
    apart = np.minimum(apart, 1 - apart) if closed else apart
    mutual = nearest(columns, places, closed)[onto] == np.arange(len(places))
    return loop._replace(places=np.where(mutual & (apart < WELDED), columns[onto], places))


def nearest(places, among, closed):
    """The number of the nearest among some other places to each: (n,) int array."""
    order = np.argsort(among, kind="stable")
    around = np.concatenate([among[order] + turn for turn in ((-1, 0, 1) if closed else (0,))])
    after = np.searchsorted(around, places).clip(1, max(len(around) - 1, 1))
    after = after.clip(0, len(around) - 1)
    before = np.maximum(after - 1, 0)
    found = np.where(places - around[before] <= around[after] - places, before, after)
    return order[found % len(among)]


def read(loops, places, closed):
    """The points of loops at places: (k, n) complex array."""
    period = 1.0 if closed else None
    return np.stack([np.interp(places, loop.places, loop.points, period=period) for loop in loops])
