# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spans: a curved axis in pieces, each of them polynomials of the arc length that are exact to rounding.

Where the axis and its frame are polynomials, so is the line that a point of a contour draws. Where that meets a plane,
and where thousands of vertices lie on it, is then known without a frame for each.
"""

from functools import cached_property, lru_cache
from math import comb
from typing import NamedTuple

import numpy as np

from ..declared.frozen import individual
from ..grids.drawn import affine
from ..trajectories.arc_length import arc_length, subdivided
from .chebyshev import fitting
from .sampling import SHORTEST_STEP, distinct
from .transport import NODES, ORDER

EXACT = 1e-13  # of the size: the last two terms of a span; the next are a hundredth of them
EXACT_U = 1e-9  # of the domain: no place hangs on it
ENOUGH = 32  # spans; what rounding leaves adds up over more of them
MOST_HALVINGS, MOST_SPANS = 24, 512
ROUNDING = 1e-17  # of the largest term: what is left out of a part of a span
PLACES = 128  # at least, at which the whole axis is looked at
ABOUT = 1.25  # of half a span: how far from its middle a fan may reach as it is seen from where that begins
FEW = 24  # spans that vertices are spread over: among more, each with its own frame is sooner placed


class Fan(NamedTuple):
    """Heights of lines on rings that go apart evenly from ring to ring: base + spread * share."""

    base: np.ndarray  # of all lines, or of each: () or (m,)
    spread: np.ndarray  # of each line: (m,)
    share: np.ndarray  # of each ring: (n,)

    @property
    def heights(self):
        """(m, n) float array."""
        found = np.outer(self.spread, self.share)
        found += np.reshape(self.base, (-1, 1))
        return found

    def with_middles(self):
        """The fan with three more lines, each amid all of these."""
        base = widened(self.base) if self.base.ndim else self.base
        return Fan(base, widened(self.spread), self.share)

    def powers(self, radius, terms):
        """Whose products are the powers of (heights - base) / radius, of one base: (m, terms) and (terms, n)."""
        most = np.abs(self.share).max() or 1.0
        both = powers(np.concatenate((self.spread * (most / radius), self.share / most)), terms)
        return both[:, : len(self.spread)].T, both[:, len(self.spread) :]


def widened(values):
    """Values (m,), and three times their mean."""
    return np.concatenate((values, np.full(3, values.mean())))


@individual
class Spans:
    """The axis of a bending, straight on before its start and after its end: the first span, and the last.

    Parameters
    ----------
    bending : Bending
    ends : (k + 1,) float array
        The heights between the spans, the start and the end of the axis among them.
    middle, half : (k + 2,) float array
        A span is a polynomial of (z - middle) / half.
    coefficients : (k + 2, 3, 4, ORDER) float array
        Of its powers from the lowest on: of the axis, then of e2 and e3, each x, y, z and the parameter u.
    exact : (k + 2,) bool array
        Whether it is one. Where not, at a joint of the direction say, each height has its own frame.
    """

    bending: object
    ends: np.ndarray
    middle: np.ndarray
    half: np.ndarray
    coefficients: np.ndarray
    exact: np.ndarray

    @cached_property
    def looked_at(self):
        """Heights from the start to the end, those between spans among them, (g,), the axis, e2 and e3: (g, 3, 3)."""
        z = subdivided(self.ends, max(PLACES // (len(self.ends) - 1), 2))
        return z, stacked(self.bending.axis(z))[..., :3]

    @property
    def outward(self):
        """The directions in which it goes on before the start and after the end: (2, 3)."""
        return self.coefficients[[0, -1], 0, :3, 1] * [[-1], [1]]

    def line(self, points, z):
        """The lines of points (m, 2) in the spans of z, (m,): a function of heights there, (m,) to (m, 3)."""
        span = np.searchsorted(self.ends, z)
        if not self.exact[span].all():
            return lambda z: self.bending.bend(np.column_stack((points, z)))
        carried = self.coefficients[span, :, :3].reshape(len(z), 3, -1)
        return self.summed(span, (affine(points)[:, None] @ carried).reshape(len(z), 3, -1))

    def summed(self, span, terms):
        """A function of heights in spans, (m,), from its terms, the lowest first: (m, ORDER) or (m, 3, ORDER)."""
        middle, half = self.middle[span], self.half[span]
        return lambda z: np.einsum("jm,m...j->m...", powers((z - middle) / half, ORDER), terms)

    def lines(self, weights, z, fan=None, found=None):
        """The lines of points at heights, (m, n): places and the parameter u, (m, 4, n).

        The points are given by what they are made of, (m, 3), as `affine` says. Where the heights are those of a fan,
        one matrix product takes the place of the powers of each. They are written into ``found``, if that is there.
        """
        found = np.empty((len(z), 4, z.shape[1])) if found is None else found
        ends = np.concatenate(([-np.inf], self.ends, [np.inf]))
        if not z.size:
            return found
        low, high = z.min(axis=0), z.max(axis=0)
        first, last = np.searchsorted(self.ends, (low.min(), high.max()))
        many = last - first >= FEW
        own = np.full(z.shape, many)
        for span in range(first, first if many else last + 1):
            touched = np.flatnonzero((low <= ends[span + 1]) & (high > ends[span]))
            if not len(touched):
                continue
            rings = slice(touched[0], touched[-1] + 1)
            inside = (ends[span] < z[:, rings]) & (z[:, rings] <= ends[span + 1])
            if not self.exact[span]:
                own[:, rings] |= inside
                continue
            reach = max(low[rings].min(), ends[span]), min(high[rings].max(), ends[span + 1])
            if span in (0, len(self.exact) - 1):
                values = self.straight(weights, z[:, rings], span)
            elif fan and self.seen_from(fan.base, span, *reach):
                values = self.fanned(weights, fan._replace(share=fan.share[rings]), span, *reach)
            else:
                values = self.apart(weights, z[:, rings], span, *reach)
            np.copyto(found[:, :, rings], values, where=inside[:, None])
        if own.any():
            point, ring = np.nonzero(own)
            there = stacked(self.bending.axis(z[own]))
            found[point, :, ring] = np.einsum("nw,nwc->nc", weights[point], there)
        return found

    def seen_from(self, base, span, start, end):
        """Whether the polynomials of a span lose nothing where they are told of heights from a base on."""
        if base.ndim:
            return False
        farthest = abs(base - self.middle[span]) + max(end - base, base - start)
        return farthest <= ABOUT * self.half[span]

    def straight(self, weights, z, span):
        """The lines of points where the axis goes on straight, before its start or after its end: (m, 4, n)."""
        start, rise = weights @ self.coefficients[span, :, :, :2].transpose(2, 0, 1)
        return start[..., None] + rise[..., None] * (z - self.middle[span])[:, None]

    def fanned(self, weights, fan, span, start, end):
        """The lines of the points of a fan in a span, of which they reach from a height to another: (m, 4, n)."""
        radius = max(end - fan.base, fan.base - start) or 1.0
        part = self.part(span, fan.base, radius)
        spread, share = fan.powers(radius, part.shape[-1])
        lines = (weights @ part.reshape(3, -1)).reshape(len(weights), 4, -1) * spread[:, None]
        return (lines.reshape(-1, part.shape[-1]) @ share).reshape(len(weights), 4, -1)

    def apart(self, weights, z, span, start, end):
        """The same of points at any heights, (m, n)."""
        centre, radius = (start + end) / 2, (end - start) / 2 or 1.0
        part = self.part(span, centre, radius)
        lines = (weights @ part.reshape(3, -1)).reshape(len(weights), 4, -1)
        return lines @ powers((z - centre) / radius, part.shape[-1]).swapaxes(0, 1)

    def part(self, span, centre, radius):
        """A span about one of its heights, as polynomials of (z - centre) / radius.

        The smaller the radius the fewer terms it has that rounding does not outweigh.
        """
        place, scale = (centre - self.middle[span]) / self.half[span], radius / self.half[span]
        places, scales = np.power(((place,), (scale,)), np.arange(ORDER))
        found = self.coefficients[span] @ (BINOMIALS * places[ABOVE] * scales)
        counted = np.abs(found).max(axis=(0, 1)) > ROUNDING * np.abs(found).max()
        return found[..., : np.flatnonzero(counted)[-1] + 1]


@lru_cache(maxsize=16)
def spans(bending):
    """The spans of the axis of a bending, made once for equal ones: `Spans`."""
    total, outer = bending.total, bending.axis(np.array((0.0, bending.total)))
    size = max(total, np.abs(outer.points).max())
    start, middle, half, series, exact = fitted(bending, size)
    coefficients = np.zeros((len(start) + 2, 3, 4, ORDER))
    coefficients[1:-1] = series @ POWERS.T
    coefficients[[0, -1], ..., 0] = stacked(outer)
    coefficients[[0, -1], 0, :3, 1] = outer.e1
    around = (middle, (0.0, total)), (half, 1.0), (exact, True)
    middle, half, exact = (np.pad(part, 1, constant_values=value) for part, value in around)
    return Spans(bending, np.append(start, total), middle, half, coefficients, exact)


def fitted(bending, size):
    """Spans from joint to joint of a trajectory, or halves of that, halved until they are as exact as they get.

    Returns
    -------
    start, middle, half : (k,) float array
        Heights.
    series : (k, 3, 4, ORDER) float array
        Coefficients of Chebyshev's polynomials.
    exact : (k,) bool array
    """
    trajectory, total, halvings, known = bending.trajectory, bending.total, MOST_HALVINGS, []
    ends = distinct(arc_length(trajectory).at(trajectory.joints()), SHORTEST_STEP * total)
    ends[-1] = total
    if len(ends) > MOST_SPANS:
        ends, halvings = ends[[0, -1]], 0
    start, end = ends[:-1], ends[1:]
    allowed = EXACT * np.array([(size, size, size, 0.0), (1, 1, 1, 1), (1, 1, 1, 1)])
    allowed[0, 3] = EXACT_U * np.ptp(trajectory.domain)
    for left in range(halvings, -1, -1):
        middle, half = (start + end) / 2, (end - start) / 2
        values = stacked(bending.axis((middle[:, None] + half[:, None] * NODES).ravel()))
        series = np.tensordot(values.reshape(-1, ORDER, 3, 4), SERIES, (1, 1))
        count = len(start) + sum(len(part[0]) for part in known)
        rest = np.abs(series[..., -2:]).sum(axis=-1)
        exact = (rest <= allowed * max(1.0, count / ENOUGH)).all(axis=(1, 2))
        kept = exact | (not left or count + np.count_nonzero(~exact) > MOST_SPANS)
        known.append((start[kept], middle[kept], half[kept], series[kept], exact[kept]))
        if kept.all():
            break
        start, end = np.append(start[~kept], middle[~kept]), np.append(middle[~kept], end[~kept])
    parts = [np.concatenate(parts) for parts in zip(*known, strict=True)]
    order = np.argsort(parts[0])
    return [part[order] for part in parts]


def stacked(axis):
    """An axis's places with its parameter, and its e2 and e3: (n, 3, 4)."""
    found = np.zeros((len(axis.u), 3, 4))
    found[..., :3] = np.stack((axis.points, axis.e2, axis.e3), axis=1)
    found[:, 0, 3] = axis.u
    return found


def powers(x, terms):
    """The powers of x, (...), from the lowest on: (terms, ...)."""
    found = np.empty((terms, *x.shape))
    found[0] = 1.0
    for degree in range(1, terms):
        np.multiply(found[degree - 1], x, out=found[degree])
    return found


def power_series():
    """The coefficients of the powers in Chebyshev's polynomials, a column for each: (ORDER, ORDER)."""
    columns = np.eye(ORDER)
    for degree in range(2, ORDER):
        columns[:, degree] = 2 * np.roll(columns[:, degree - 1], 1) - columns[:, degree - 2]
    return columns


SERIES = fitting(ORDER)
POWERS = power_series()
ABOVE = np.maximum(np.arange(ORDER)[:, None] - np.arange(ORDER), 0)  # of a power in a shifted polynomial, by how many
BINOMIALS = np.array([[comb(degree, power) for power in range(ORDER)] for degree in range(ORDER)], dtype=float)
