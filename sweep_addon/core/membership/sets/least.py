# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The least distance of points from what moves along panels, found by bounds.

In each panel it stays within a radius of a chord, and in half a panel no distance from it changes by more than a gap.
So few panels need be looked at, and of points that are far from all of them none: a lower bound tells enough.
"""

import numpy as np

from ...vectors import dot, norms
from ..motion.panels import PLACES

APART = float(np.diff(PLACES).max()) / 2  # no place is farther from the nearest of these
FAIR, EXACT = 0.75, 1.0  # of the distance: a lower bound of more is told as it is, at first and in the end
NEAR = 0.01  # of the size: distances of less are told exactly
CHUNK = 1 << 17  # pairs of points and runs of panels at a time
MOST = 1 << 13  # points at a time


class Along:
    """Chords about which it stays, in runs of neighbours with a ball around each run.

    Parameters
    ----------
    start, chord : (k, 3) float array
    radius : (k,) float array
    whole : (k,) bool array
        Where all of it counts, so that it is no farther from a point than the chord and the radius.
    """

    def __init__(self, start, chord, radius, whole):
        self.start, self.chord, self.radius, self.whole = start, chord, radius, whole
        self.near = NEAR * float(norms(np.ptp(np.concatenate((start, start + chord)), axis=0)) + radius.max())
        squares = dot(chord, chord)
        self.squares = np.where(squares > 0, squares, 1.0)
        size = max(int(np.ceil(np.sqrt(len(start) / 2))), 1)
        self.first = np.arange(0, len(start), size)
        self.counts = np.diff(np.append(self.first, len(start)))
        ends = np.stack((start, start + chord))
        low = np.minimum.reduceat(ends.min(axis=0), self.first)
        self.middles = (low + np.maximum.reduceat(ends.max(axis=0), self.first)) / 2
        reach = norms(ends - np.repeat(self.middles, self.counts, axis=0)).max(axis=0) + radius
        self.reaches = np.maximum.reduceat(reach, self.first)
        self.sure = np.logical_or.reduceat(whole, self.first)

    def least(self, points, near):
        """The least distance of points (n, 3), or less where they are far: (n,).

        Parameters
        ----------
        points : (n, 3) float array
        near : callable
            From the numbers of points that are not far to what tells of pairs, a point among these and a panel each:
            ``middle(point, panel)``, the distances in the middle of panels, and by how much they change in half of one;
            ``pairs(point, panel)``, whose ``grid()`` are the distances at all places, ``kept(index)`` some of the
            pairs, ``refined(place)`` their least distances near a place each, with ``gaps`` and ``is_smooth``.
        """
        found = np.empty(len(points))
        size = min(max(CHUNK // len(self.first), 1), MOST)
        for start in range(0, len(points), size):
            found[start : start + size] = self.of_some(
                points[start : start + size], lambda some, start=start: near(start + some)
            )
        return found

    def of_some(self, points, near):
        """The same of so few points that all pairs fit into memory."""
        point, panel, lower, most = self.candidates(points)
        found = np.full(len(points), np.inf)
        point, kept = self.settled(found, point, lower, most, FAIR)
        if not len(point):
            return found
        panel, lower = panel[kept], lower[kept]
        some, which = np.unique(point, return_inverse=True)
        look, which = near(some), which.ravel()
        value, gaps = look.middle(which, panel)
        np.minimum.at(most, point, value)
        lower = np.maximum(lower, value - gaps)
        point, kept = self.settled(found, point, lower, most, FAIR)
        if not len(point):
            return found
        pairs, lower = look.pairs(which[kept], panel[kept]), lower[kept]
        values = pairs.grid()
        np.minimum.at(most, point, values.min(axis=1))
        lower = np.maximum(lower, values.min(axis=1) - APART * pairs.gaps)
        point, kept = self.settled(found, point, lower, most, EXACT)
        if len(point):
            pair, place = lowest(values[kept], most[point], pairs.gaps[kept], pairs.is_smooth)
            np.minimum.at(most, point[pair], pairs.kept(kept[pair]).refined(place))
            found[point] = most[point]
        return found

    def candidates(self, points):
        """Pairs of points and panels that may be nearest, a lower bound of each, and an upper one of each point."""
        far = norms(points[:, None] - self.middles)
        most = np.where(self.sure, far + self.reaches, np.inf).min(axis=1)
        point, run = np.nonzero(far - self.reaches <= most[:, None])
        counts = self.counts[run]
        within = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
        point, panel = np.repeat(point, counts), np.repeat(self.first[run], counts) + within
        way, chord = points[point] - self.start[panel], self.chord[panel]
        share = np.clip(dot(way, chord) / self.squares[panel], 0.0, 1.0)
        far, radius = norms(way - share[:, None] * chord), self.radius[panel]
        np.minimum.at(most, point, np.where(self.whole[panel], far + radius, np.inf))
        return point, panel, far - radius, most

    def settled(self, found, point, lower, most, fair):
        """Of pairs, points rising, those that are left: their points, and which they are.

        What is found is told where bounds agree: a negative value where it is a fair part of the least that it can be.
        """
        if not len(point):
            return point, np.zeros(0, dtype=int)
        first = np.flatnonzero(np.append(True, point[1:] != point[:-1]))
        which = point[first]
        least, upper = np.minimum.reduceat(lower, first), most[which]
        done = np.where(
            upper < 0, (upper <= fair * least) & (upper < -self.near), (least >= fair * upper) & (least > self.near)
        )
        found[which[done]] = np.where(upper < 0, upper, least)[done]
        open_ = np.ones(len(found), dtype=bool)
        open_[which[done]] = False
        kept = np.flatnonzero(open_[point] & (lower < most[point]))
        return point[kept], kept


def lowest(values, most, gaps, is_smooth):
    """Of places with values (p, i) those from which less than the most may be found: pairs, and places.

    They are lower than their neighbours. Where several parts of a contour may be nearest there may be two lowest places
    between two of these, so their neighbours count too.
    """
    padded = np.pad(values, ((0, 0), (1, 1)), constant_values=np.inf)
    low = (values <= padded[:, :-2]) & (values < padded[:, 2:])
    between = (values[:, 1:] + values[:, :-1] - gaps[:, None] * np.diff(PLACES)) / 2 < most[:, None]
    before, after = (np.pad(between, ((0, 0), side)) for side in ((1, 0), (0, 1)))
    low &= before | after
    if not is_smooth:
        low[:, 1:] |= low[:, :-1] & between
        low[:, :-1] |= low[:, 1:] & between
    return np.nonzero(low)
