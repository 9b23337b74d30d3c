# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pairs of points and panels of a planar sweep, and how far the points are from the contour as it stands there."""

import numpy as np

from ...vectors import dot, norms
from ..motion.panels import ORDER, PLACES, derivative, powers
from ..motion.planes import NORMAL, SCALES, X, Y
from ..plane.figures import mapped, stretch

STEP = 1e-6  # of half a panel, over which slopes are taken
STEPS = 7
TIP = 1e-9  # of the widest scale: less is told as that
AS_IT_IS, ALIKE, SCALED, LEANING = range(4)  # how the contour stands


class Look:
    """Points of which it is known whether the distance from the contour is asked for, or that from the figure."""

    def __init__(self, distance, points, inside):
        self.distance, self.points, self.inside = distance, points, inside

    def middle(self, point, panel):
        """The distances in the middle of panels, and by how much they change in half of one: two (p,)."""
        frames = self.distance.frames[panel]
        terms = np.einsum("pi,pcij->jcp", self.points[point], frames[:, :12].reshape(-1, 3, 4, 1)[:, :, :3])[0]
        terms -= frames[:, 3:12:4].T
        terms = np.concatenate((terms, frames[:, 12:].T))
        pairs = Pairs(self.distance, self.inside[point], panel, None, self.points[point])
        return pairs.told(terms, np.arange(len(panel)), np.zeros(len(panel))), pairs.gaps

    def pairs(self, point, panel):
        """The same as `Pairs`."""
        return Pairs.of(self.distance, self.points[point], self.inside[point], panel)


class Pairs:
    """Points and a panel each.

    Parameters
    ----------
    distance : PlaneDistance
    inside : (p,) bool array
        Of which points the distance from the contour is asked for, not that from the figure.
    panel : (p,) int array
    terms : (p, 3 or 5, ORDER) float array
        How far the point is over the plane, and along both axes, and the scales, as series.
    places : (p, 3) float array
    """

    def __init__(self, distance, inside, panel, terms, places):
        self.distance, self.inside, self.panel, self.terms, self.places = distance, inside, panel, terms, places
        self.is_smooth = distance.region.is_round
        self.gaps = np.where(inside, *(gaps[panel] for gaps in distance.gaps[::-1]))

    @classmethod
    def of(cls, distance, places, inside, panel):
        """The pairs of places (p, 3) and panels."""
        held = distance.series[panel, : SCALES.stop if distance.kind else SCALES.start]
        axes = held[:, : SCALES.start].reshape(len(panel), 3, 4, ORDER)
        terms = np.einsum("pi,pcij->pcj", places, axes[:, :, :3])
        terms -= axes[:, :, 3]
        if distance.kind:
            terms = np.concatenate((terms, held[:, SCALES]), axis=1)
        return cls(distance, inside, panel, terms, places)

    def kept(self, index):
        """Some of the pairs."""
        return Pairs(self.distance, *(part[index] for part in (self.inside, self.panel, self.terms, self.places)))

    def grid(self):
        """The distance at some places of the panels: (p, i)."""
        terms = self.terms @ powers(PLACES).T
        flat = terms.swapaxes(1, 2).reshape(-1, terms.shape[1]).T
        pair = np.repeat(np.arange(len(self.panel)), len(PLACES))
        return self.told(flat, pair, np.tile(PLACES, len(self.panel))).reshape(-1, len(PLACES))

    def at(self, x):
        """The distance at a place of each panel: (p,)."""
        return self.told(np.einsum("pcj,pj->cp", self.terms, powers(x)), np.arange(len(x)), x)

    def told(self, terms, pair, x):
        """The distance at places x of pairs with terms (c, p): (p,)."""
        return np.maximum(np.hypot(*self.off(terms, pair, x)), self.cut(pair, x))

    def cut(self, pair, x):
        """How far points are beyond the planes that cut off their panel or the sweep, or nothing: (p,)."""
        distance, beyond = self.distance, 0.0
        places = self.places[pair] if distance.is_cut else None
        for plane in distance.cuts[self.panel[pair]].swapaxes(0, 1) if distance.is_cut else ():
            beyond = np.maximum(beyond, dot(places, plane[:, :3]) - plane[:, 3])
        if distance.plane.way.limits:
            parameter = distance.panels.parameter(self.panel[pair], x)
            beyond = np.maximum(beyond, distance.plane.faces.beyond_limits(self.places[pair], parameter))
        return beyond

    def off(self, terms, pair, x):
        """How far points are from planes, and from the figures or contours in them: two (p,)."""
        distance, inside = self.distance, self.inside[pair]
        aside = distance_in_plane(distance, distance.region, terms, self.panel[pair], x)
        within = np.abs(aside)
        some = np.flatnonzero(inside) if distance.skin else ()
        if len(some):
            where = self.panel[pair[some]], x[some]
            within[some] = np.abs(distance_in_plane(distance, distance.skin, terms[:, some], *where))
        folds = np.flatnonzero(inside & distance.folding[self.panel[pair]]) if distance.is_folded else ()
        if len(folds):
            line = self.fold(pair[folds], x[folds])
            within[folds] = np.minimum(within[folds], np.maximum(line, aside[folds]))
        return terms[0], np.where(inside, within, np.maximum(aside, 0.0))

    def fold(self, pair, x):
        """How far points are in a plane from the line about which it turns: (p,)."""
        held = derivative(self.distance.series[self.panel[pair], NORMAL])
        rate = np.einsum("pcj,pj->pc", held, powers(x))
        return np.abs(dot(self.places[pair], rate[:, :3]) - rate[:, 3]) / np.maximum(norms(rate[:, :3]), 1e-300)

    def refined(self, best):
        """The least distance near the best of the places, by the method of Gauss and Newton in narrowing brackets."""
        x, low, high = (PLACES[np.clip(best + side, 0, len(PLACES) - 1)] for side in (0, -1, 1))
        pair, least = np.arange(len(best)), np.full(len(best), np.inf)
        for _ in range(STEPS):
            aside = x + np.where(x > 0, -STEP, STEP)
            here, beside = (
                np.stack(self.off(np.einsum("pcj,pj->cp", self.terms, powers(at)), pair, at)) for at in (x, aside)
            )
            least = np.minimum(least, np.hypot(*here))
            rate = (beside - here) / (aside - x)
            slope, bend = (here * rate).sum(axis=0), (rate * rate).sum(axis=0)
            low, high = np.where(slope <= 0, x, low), np.where(slope >= 0, x, high)
            after = x - slope / np.where(bend > 0, bend, np.inf)
            x = np.where((after >= low) & (after <= high), after, (low + high) / 2)
        return np.maximum(least, self.cut(pair, x))


def distance_in_plane(distance, region, terms, panel, x):
    """How far points are in planes from the contours there, negative within: (p,)."""
    plane = distance.plane
    parameter = distance.panels.parameter(panel, x)
    if distance.kind == AS_IT_IS:
        return region.distance(terms[1:3].T, parameter)
    scales = terms[3:5]
    scales = np.where(np.abs(scales) < TIP * plane.widest, TIP * plane.widest, scales)
    images = (terms[1:3] / scales).T
    if distance.kind == ALIKE:
        return np.abs(scales[0]) * region.distance(images, parameter)
    if distance.kind == SCALED:
        return mapped(region, images, parameter, stretch(np.abs(scales)))
    axes = np.einsum("pcj,pj->pc", distance.series[panel, X.start : Y.stop], powers(x))
    return mapped(region, images, parameter, stretch(np.abs(scales), axes[:, :3], axes[:, 4:7]))
