# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A changing contour: what stands between the contours of a morph, a blend of them that is a sum of each by its weight.

So all contours of a sweep are still one matrix product: of the points of all its contours with the axes, each times
the weight of its contour there. A smooth blend also has weights for the slopes at each contour.
"""

from functools import cached_property, lru_cache

import numpy as np

from ..contours import Fit, fitted
from ..contours.crossing import crossings
from ..declared.frozen import individual
from ..declared.parameters import ShapeError, at, require, spelled
from ..grids.chart import lengths_around
from ..vectors import norms
from .laws import monotone_slopes
from .matching import matched
from .morph import Blend

CREASE = np.cos(np.radians(20))  # a side that turns more at a contour has an edge there
FASTEST = 1.5  # times its mean, an eased weight rises in its middle, and a smooth one about so


@individual
class Changing:
    """A contour that changes along a trajectory.

    Parameters
    ----------
    sections : tuple of Section
        With common columns, from the start to the end; of a closed trajectory the first is the last again.
    places : (k,) float array
        Where they stand, as parts of the length, from 0 to 1.
    blend : Blend
    closed : bool
        Whether the end is the start again.

    Examples
    --------
    >>> from ..contours import Circle, Rectangle
    >>> from .morph import Match, Morph
    >>> change = changing(Rectangle(2, 2), (Morph(1, Rectangle(4, 4)),), Match.BY_CORNER, Blend.LINEAR, closed=False)
    >>> change.weights(np.array([0.0, 0.25, 1.0])).tolist()
    [[1.0, 0.0], [0.75, 0.25], [0.0, 1.0]]
    """

    sections: tuple
    places: np.ndarray
    blend: Blend
    closed: bool = False

    @property
    def ends(self):
        """The sections at the start and at the end."""
        return self.sections[0], self.sections[-1]

    @cached_property
    def points(self):
        """The points of all sections: (k, m, 2)."""
        return np.stack([section.points for section in self.sections])

    @cached_property
    def slopes(self):
        """How the points move with t as they pass each section, so that none overshoots: (k, m, 2).

        Source: the monotone slopes of `laws.Points`, for each coordinate.
        """
        if not self.closed:
            return monotone_slopes(self.places, self.points)
        places = np.concatenate((self.places[-3:-1] - 1, self.places, self.places[1:3] + 1))
        points = np.concatenate((self.points[-3:-1], self.points, self.points[1:3]))
        return monotone_slopes(places, points)[2:-2]

    @cached_property
    def shape(self):
        """What the weights weigh, of each point its coordinates, and its slopes where these count: (m, 2 k or 4 k)."""
        rows = (self.points, self.slopes) if self.blend is Blend.SMOOTH else (self.points,)
        return np.concatenate([row for rows in rows for row in rows], axis=1)

    @property
    def mirrored(self):
        """The same seen in a mirror along y, the areas on the left again."""
        return Changing(tuple(section.mirrored for section in self.sections), self.places, self.blend, self.closed)

    def weights(self, t):
        """The weights of the sections at parts of the way, and of their slopes: (n,) to (n, k) or (n, 2 k)."""
        piece, step, x = self.pieces(t)
        rising = x if self.blend is Blend.LINEAR else x * x * (3 - 2 * x)
        parts = [(1 - rising, rising)]
        if self.blend is Blend.SMOOTH:
            parts.append((step * x * (1 - x) ** 2, -step * x * x * (1 - x)))
        found, row = np.zeros((len(parts), len(x), len(self.places))), np.arange(len(x))
        for weights, (before, after) in zip(found, parts, strict=True):
            weights[row, piece], weights[row, piece + 1] = before, after
        return np.concatenate(found, axis=1)

    def at(self, t):
        """The contour's points at parts of the way: (n,) to (n, m, 2)."""
        return np.einsum("nk,mki->nmi", self.weights(t), self.shape.reshape(len(self.shape), -1, 2))

    def pieces(self, t):
        """Between which sections parts of the way lie, how far these are apart, and how far on it is: three (n,)."""
        t = np.clip(t, 0.0, 1.0)
        piece = np.searchsorted(self.places, t, side="right").clip(1, len(self.places) - 1) - 1
        step = np.diff(self.places)[piece]
        return piece, step, (t - self.places[piece]) / step

    def carried(self, rings, t):
        """The places of rings, and their axes times each weight: (3, n, 3) to (1 + 2 k, n, 3) or (1 + 4 k, n, 3)."""
        axes = self.weights(t).T[:, None, :, None] * rings[1:]
        return np.concatenate((rings[:1], axes.reshape(-1, *rings.shape[1:])))

    def weighted(self, axis, t):
        """An axis, (n, 3), of each section and of its slopes, by its weight at parts of the way: (n, k or 2 k, 3)."""
        return self.weights(t)[:, :, None] * axis[:, None]

    def support(self, directions):
        """How far the contour reaches from the reference point along directions, times their lengths: (n,).

        Those are (n, k or 2 k, 2), weighted as the sections are; for (n, 2) it is how far any section reaches.
        """
        if directions.ndim == 2:
            return (self.points @ directions.T).max(axis=(0, 1))
        return (directions.reshape(len(directions), -1) @ self.shape.T).max(axis=1)

    def centroids(self, t):
        """Where the centroid is at parts of the way, nearly: (2, n)."""
        piece, _, x = self.pieces(t)
        middles = np.stack([section.centroid for section in self.sections])
        return (middles[piece] + x[:, None] * (middles[piece + 1] - middles[piece])).T

    def around(self, scale, t):
        """The length round the contour at each point, the mean of that at parts of the way: (m + l,) array."""
        count = len(self.sections)
        shares = self.weights(t)[:, :count].mean(axis=0)
        return shares @ np.stack([lengths_around(section, scale) for section in self.sections])

    @cached_property
    def sharp(self):
        """The columns where any section has a corner: (m,) bool array."""
        return np.any([section.sharp for section in self.sections], axis=0)

    def smooth(self, t):
        """From which ring, at parts of the way (n,), to which some columns that have corners have none: for a grid."""
        marks = np.abs(t - self.places[1:-1, None]).argmin(axis=1).tolist()
        marks = [0, *marks, len(t)]
        sharp = np.stack([section.sharp for section in self.sections])
        columns = (tuple(np.flatnonzero(self.sharp & ~row).tolist()) for row in sharp[:-1] | sharp[1:])
        return tuple(piece for piece in zip(marks[:-1], marks[1:], columns, strict=True) if piece[2])

    @cached_property
    def bends(self):
        """The farthest second derivative of a point by t at the start and at the end of each piece: (2, k - 1)."""
        step = np.diff(self.places)[:, None, None]
        rise = np.diff(self.points, axis=0) / step
        if self.blend is Blend.LINEAR:
            return np.zeros((2, len(step)))
        before, after = (self.slopes[:-1], self.slopes[1:]) if self.blend is Blend.SMOOTH else (0.0, 0.0)
        ends = (6 * rise - 4 * before - 2 * after) / step, (2 * before + 4 * after - 6 * rise) / step
        return np.stack([norms(end).max(axis=1) for end in ends])

    @cached_property
    def warps(self):
        """By how far the worst edge turns away from where it was, in each piece, for each unit of t: (k - 1,) metres.

        The face between an edge and a turned one is bent, its middle a quarter of this from its diagonals.
        """
        edges = self.points[:, self.sections[0].following] - self.points
        edges[:, self.sections[0].gaps] = 0.0
        before, after = edges[:-1], edges[1:]
        turned = np.abs(before[..., 0] * after[..., 1] - before[..., 1] * after[..., 0])
        longer = np.maximum(norms(before), norms(after))
        warp = np.divide(turned, longer, out=np.zeros_like(turned), where=longer > 0).max(axis=1)
        return (1.0 if self.blend is Blend.LINEAR else FASTEST) * warp / np.diff(self.places)

    def asked(self, t):
        """By how much the points bend, and edges turn away, by t at parts of the way: two (n,) in metres."""
        piece, _, x = self.pieces(t)
        return self.bends[0, piece] * (1 - x) + self.bends[1, piece] * x, self.warps[piece]

    def creases(self, total, scale):
        """The parts of the way where straight blends meet at an angle, so that there is an edge all round."""
        if self.blend is not Blend.LINEAR:
            return self.places[:0]
        slopes = np.diff(self.points, axis=0) / np.diff(self.places)[:, None, None] * scale / total
        if self.closed:
            slopes = np.concatenate((slopes[-1:], slopes))
        ways = np.concatenate((slopes, np.ones_like(slopes[..., :1])), axis=2)
        cosine = np.einsum("kmi,kmi->km", ways[1:], ways[:-1]) / (norms(ways[1:]) * norms(ways[:-1]))
        places = self.places[: len(cosine)] if self.closed else self.places[1:-1]
        return places[cosine.min(axis=1) < CREASE]

    @cached_property
    def told(self):
        """A sentence about the first blend that crosses itself halfway, or none."""
        for first, last, start, end in zip(
            self.sections[:-1], self.sections[1:], self.places[:-1], self.places[1:], strict=True
        ):
            middle = (first.points + last.points) / 2
            halfway = type(first)(middle, first.offsets, first.sharp, first.closed)
            if first.closed and ((halfway.areas * first.areas <= 0).any() or len(crossings(middle, first.following))):
                return (
                    f"Morph: between t = {start:.6g} and t = {end:.6g} the contour crosses itself: match it otherwise, "
                    "or add a contour between.",
                )
        return ()


@lru_cache(maxsize=16)
def changing(contour, morph, match, blend, closed):
    """A contour that becomes others.

    Parameters
    ----------
    contour : Contour
        Which stands at the start, and on a closed trajectory at the end as well.
    morph : tuple of Morph
    match : Match
    blend : Blend
    closed : bool

    Returns
    -------
    Changing

    Raises
    ------
    ShapeError
        Where two stand in one place, or cannot be matched.
    """
    order = sorted(range(len(morph)), key=lambda number: morph[number].t)
    keys = ["contour", *(f"morph.{number + 1}.contour" for number in order)]
    places = [0.0, *(morph[number].t for number in order)]
    for number, before in zip(order, places, strict=False):
        if morph[number].t == before:
            raise ShapeError(f"must be another t than that of the others, got {before:g}", f"morph.{number + 1}.t")
    if closed:
        last = max(order, key=lambda number: morph[number].t)
        sentence = "must be less than 1 on a closed trajectory, where the first contour stands again"
        require(morph[last].t < 1, sentence, morph[last].t, f"morph.{last + 1}.t")
    sections = []
    for key, each in zip(keys, [contour, *(morph[number].contour for number in order)], strict=True):
        with at(key):
            sections.append(fitted(each, Fit.INSCRIBED))
    try:
        sections = matched(sections, match)
    except ShapeError as refusal:
        raise ShapeError(refusal.sentence, keys[int(refusal.key)]) from None
    if places[-1] < 1:
        places.append(1.0)
        sections = (*sections, sections[0] if closed else sections[-1])
    return Changing(tuple(sections), np.array(places), blend, closed)


def require_inscribed(fit):
    """Refuse a fit that is made for one contour."""
    require(fit is Fit.INSCRIBED, "must be inscribed where the contour changes", spelled(fit), "fit")
