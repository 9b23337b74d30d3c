# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The planes of a contour on its way: which of them pass through points, and at what places of the panels."""

from functools import cached_property

import numpy as np

from ...vectors import dot
from .panels import NODES, at_both, derivative, powers, slopes
from .roots import MONOMIALS, all_roots, simple, solved

# Channels: unit vectors and how far the plane is along them; the same of the contour's axes in it, and its scales;
# ways of the corners of the box around it, and of its origin.
NORMAL, X, Y, SCALES, SPACE, MIDDLE = map(slice, (0, 4, 8, 12, 14, 26), (4, 8, 12, 14, 26, 29))
MARGIN = 0.1  # of the steepest slope: what is left of it everywhere
SAME = 1e-9  # of half a panel: roots so far outside are its ends


class Planes:
    """The planes of panels.

    Parameters
    ----------
    panels : Panels
    low, high : (k, 3) float array
        The boxes of what the contour reaches in each.
    outer : (k, 2) bool array
        Which panels begin or end where an open sweep does, in a face of its own.
    rounding : float
        In metres.
    """

    def __init__(self, panels, low, high, outer, rounding):
        self.held = panels.series[:, NORMAL]
        self.space, self.low, self.high, self.outer, self.rounding = panels.series[:, SPACE], low, high, outer, rounding

    @cached_property
    def falling(self):
        """Of each panel, whether the plane passes each place that the contour reaches in it once: (k,) bool."""
        space = np.einsum("kcj,ij->kic", self.space, powers(NODES)).reshape(len(self.held), -1, 3)
        rates = np.einsum("kcj,ij->kic", self.held, slopes(NODES))
        slope = np.einsum("kpj,kij->kpi", space, rates[..., :3]) - rates[:, None, :, 3]
        low, high = slope.min(axis=(1, 2)), slope.max(axis=(1, 2))
        least, most = np.minimum(np.abs(low), np.abs(high)), np.maximum(np.abs(low), np.abs(high))
        return (low * high > 0) & (least > MARGIN * most)

    @cached_property
    def terms(self):
        """The planes as polynomials of powers of x: (k, 4, ORDER)."""
        return np.einsum("ij,kcj->kci", MONOMIALS, self.held)

    @cached_property
    def ends(self):
        """The planes at the start and at the end of each panel: two (k, 4)."""
        return at_both(self.held)

    @cached_property
    def rates(self):
        """How these change there: two (k, 4)."""
        return at_both(derivative(self.held))

    def passing(self, points, point, panel):
        """The planes that pass through points wherever these are, among pairs: points, panels and places in these."""
        places = points[point]
        begin, end = (off(places, planes, panel) for planes in self.ends)
        room = self.rounding
        kept = (np.minimum(begin, end) <= room) & (np.maximum(begin, end) >= -room) | self.turning_back(places, panel)
        point, panel = point[kept], panel[kept]
        series = self.series(places[kept], panel)
        monotone, x = simple(series)
        chosen = np.flatnonzero(monotone & (np.abs(x) <= 1 + SAME))
        which, at = all_roots(series[~monotone], 0.0)
        others = np.flatnonzero(~monotone)[which]
        index = np.concatenate((chosen, others))
        return point[index], panel[index], np.concatenate((np.clip(x[chosen], -1.0, 1.0), at))

    def hits(self, places, panel, tolerance):
        """The planes that pass through places, (n, 3), of a panel each: which of the pairs, and places in panels."""
        begin, end = (off(places, planes, panel) for planes in self.ends)
        kept = (np.minimum(begin, end) <= tolerance) & (np.maximum(begin, end) >= -tolerance)
        if self.falling.all():
            falling = np.flatnonzero(kept)
            return self.once(falling, places, panel, begin, end, tolerance)
        falling = self.falling[panel]
        others = np.flatnonzero(~falling)  # where the planes turn back they may come by twice
        others = others[kept[others] | self.turning_back(places[others], panel[others])]
        found = self.once(np.flatnonzero(kept & falling), places, panel, begin, end, tolerance)
        return tuple(
            np.concatenate(pair) for pair in zip(found, self.several(others, places, panel, tolerance), strict=True)
        )

    def once(self, pair, places, panel, begin, end, tolerance):
        """The hits among pairs of which each has one at most."""
        panel, begin, end = panel[pair], begin[pair], end[pair]
        terms = np.empty((self.terms.shape[2], len(pair)))  # each in one run of memory
        held, place = self.terms[panel], places[pair]
        terms[:] = np.einsum("ni,nij->nj", place, held[:, :3]).T
        terms -= held[:, 3].T
        apart = end - begin
        guess = np.where(apart == 0, 0.0, -(begin + end) / np.where(apart == 0, 1.0, apart))
        x = solved(terms, np.clip(guess, -2.0, 2.0))
        near = np.abs(np.where(x > 0, end, begin)) <= tolerance
        within = np.abs(x) <= 1 + SAME
        some = np.flatnonzero(near & ~within)
        within[some] = self.outer[panel[some], (x[some] > 0).astype(int)]
        return pair[within], np.clip(x[within], -1.0, 1.0)

    def several(self, pair, places, panel, tolerance):
        """The hits among pairs of which some have several."""
        series = self.series(places[pair], panel[pair])
        monotone, x = simple(series)
        begin, end = (np.abs(off(places[pair], planes, panel[pair])) for planes in self.ends)
        side = (x > 0).astype(int)
        within = (np.abs(x) <= 1 + SAME) | (np.choose(side, (begin, end)) <= tolerance) & self.outer[panel[pair], side]
        chosen = np.flatnonzero(monotone & within)
        others = np.flatnonzero(~monotone)
        others = others[self.reached(places[pair[others]], panel[pair[others]], tolerance)]
        which, at = all_roots(series[others], tolerance)
        return np.append(pair[chosen], pair[others[which]]), np.append(np.clip(x[chosen], -1.0, 1.0), at)

    def turning_back(self, places, panel):
        """Whether the distance of places from the plane first grows and then falls, or the other way: (n,) bool."""
        begin, end = (off(places, planes, panel) for planes in self.rates)
        return begin * end <= 0

    def reached(self, places, panel, tolerance):
        """Whether places are in the boxes of panels: (n,) bool."""
        return ((places >= self.low[panel] - tolerance) & (places <= self.high[panel] + tolerance)).all(axis=1)

    def series(self, places, panel):
        """How far places (n, 3) are from the planes of panels, as series: (n, ORDER)."""
        held = self.held[panel]
        made = np.einsum("ni,nij->nj", places, held[:, :3])
        made -= held[:, 3]
        return made


def off(places, planes, panel):
    """How far places (n, 3) are from planes, one of (k, 4) each: (n,)."""
    return dot(places, planes[panel, :3]) - planes[panel, 3]
