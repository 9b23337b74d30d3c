# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What becomes of a solid itself on its way, beside its rigid motion: how fast it changes, and how far points are then.

Seen by the rigid motion a point moves at a known speed, and the surface of the solid at another one at most, so both
together say how long nothing can happen.
"""

from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ...declared.parameters import require
from ...trajectories.arc_length import arc_length
from ...vectors import norms, unit
from .boxes import APART, corners, from_box
from .linear import LEAST, solved
from .panels import NODES, derivative, panels, powers
from .ways import PARTS, apart

MORE = 4.0  # times what a solid changes between two poses as a rule: where it is more poses are closer
HALVINGS = 20  # of what is between two poses
FASTER = 1.5  # times its speed about a pose: where a solid changes faster than that it is looked at again
ROOM = 1.1  # for what changes faster between the places that are looked at
LOOKED = 257
FLATTEST = 1e-9  # of the largest scale: what is flatter counts as so thick, and has no inside
FLAT = 1 + 1e-6  # times that, for rounding
AFTER = 1e-6  # of the way: what is flat so much before and after, too, stays so
BEYOND = 1.001  # tolerances: so far at least is what is not on
AROUND = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1) if x or y or z], dtype=float)
AROUND = AROUND / norms(AROUND)[:, None]  # directions in which is looked for what is outside
FALLS = 4  # times it is looked for where the depth falls fastest
DIFFERENCE = 1e-6  # of a solid's size: over which slopes are taken
ASIDE = 1e-6  # of the size of a map: what is added where it is flat


class Own(NamedTuple):
    """Places as a solid has them itself, before it is changed."""

    places: np.ndarray  # (n, 3)
    least: np.ndarray  # what a length about them becomes at least: (n,)
    most: np.ndarray  # and at most: (n,)
    away: np.ndarray  # how far they are from what the solid may become at least, 0 where they have a place in it: (n,)
    missed: np.ndarray  # how far they are from what these places become: (n,)


class Change:
    """What becomes of a solid, which has the methods ``back`` and ``maps``.

    The distance from what is changed is at least that of the solid itself times the least that a length becomes, and
    exactly so where all become the same. Near its surface it is to first order the distance over the length of its
    slope.

    Parameters
    ----------
    box : (2, 3) float array
        Around the solid itself.
    edges : (k + 1,) float array
        Places of the way in metres, rising, the first 0 and the last its end.
    growth : (k,) float array
        How far points of the solid move at most, the rigid motion aside, in metres for each metre of the way between
        two of these places.
    places : (p, 3) float array, optional
        In the solid's box, that tell where it gets: its corners, if no others are given.

    Attributes
    ----------
    is_unique : bool
        Whether points have one place in the solid also where it is flat.
    """

    is_unique = True

    def __init__(self, box, edges, growth, places=None):
        self.box, self.size = box, float(norms(box[1] - box[0]))
        self.places = corners(box) if places is None else places
        self.edges, self.growth = edges, growth

    @cached_property
    def moved(self):
        """How far points of the solid have moved at most when it comes to the edges: (k + 1,)."""
        return np.append(0.0, np.cumsum(self.growth * np.diff(self.edges)))

    def between(self, low, high):
        """The most of the speeds between two places of the way."""
        first = int(np.searchsorted(self.edges, low, side="right")) - 1
        last = int(np.searchsorted(self.edges, high, side="left"))
        first = min(max(first, 0), len(self.growth) - 1)
        return float(self.growth[first : max(last, first + 1)].max())

    def spread(self, s):
        """Places of the way, rising, and more between those between which the solid changes most."""
        whole = float(s[-1] - s[0])
        most = MORE * max(float(np.diff(np.interp(s[[0, -1]], self.edges, self.moved))[0]), LEAST) / (len(s) - 1)

        def cut(low, high, left):
            if not left or self.between(low, high) * (high - low) <= most or high - low <= whole * 0.5**HALVINGS:
                return [high]
            middle = (low + high) / 2
            return cut(low, middle, left - 1) + cut(middle, high, left - 1)

        return np.array([s[0], *(place for low, high in pairwise(s) for place in cut(low, high, HALVINGS))])

    def most(self, s):
        """How far points of the solid move at most between one of some rising places of the way and the next."""
        return float(np.diff(np.interp(s, self.edges, self.moved)).max())

    def around(self, before, after):
        """How fast the solid changes about a pose at most, and how far on it changes no faster."""
        fast = FASTER * self.between(before, after)
        faster = np.flatnonzero((self.growth > fast) & (self.edges[:-1] >= after))
        return fast, float(self.edges[faster[0]]) if len(faster) else np.inf

    def distance(self, solid, places, s, tolerance):
        """How far places (n, 3) are from a changed solid, or less, but no less within a tolerance: (n,).

        Parameters
        ----------
        solid : member
        places : (n, 3) float array
            As seen by the rigid motion.
        s : float or (n,) float array
            How far it has come.
        tolerance : float
        """
        own = self.back(places, s)
        found = distant(solid, own.places, self.box, APART * self.size)
        value = own.least * found
        value = np.where(own.away > 0, own.away + np.maximum(value, 0.0), value)
        near = np.abs(value) <= max(tolerance, self.flattest * self.size)
        near = np.flatnonzero(near & ((own.least < own.most) | (own.least <= self.flattest)))
        if len(near):
            s = s if np.ndim(s) == 0 else s[near]
            value[near] = self.nearly(solid, Own(*(part[near] for part in own)), found[near], s, tolerance)
        return value

    def nearly(self, solid, own, found, s, tolerance):
        """How far places are from a changed solid where they are within a tolerance, or perhaps deeper: (n,).

        To first order, but no deeper than the tolerance where what is so far away is outside. What is flat has no
        inside, and where it stays so it is nothing.
        """
        maps = np.nan_to_num(self.maps(own.places, s))
        steep = norms(solved(maps.swapaxes(1, 2), slopes(solid, own.places, DIFFERENCE * self.size), ASIDE))
        value = found / np.clip(steep, 1 / own.most, 1 / own.least)
        value = np.where(own.away > 0, np.hypot(np.maximum(value, 0.0), own.missed), value)
        axes, stretches, _ = np.linalg.svd(maps)
        flat = stretches[:, 2] <= FLAT * self.flattest
        value[flat] = np.maximum(value[flat], 0.0)
        deep = np.flatnonzero(value < -tolerance)
        if tolerance and len(deep):
            value[deep[self.pierced(solid, own.places[deep], maps[deep], axes[deep], tolerance)]] = -tolerance
        which = np.flatnonzero(flat)
        nothing = self.stays_flat(own.places[which], s if np.ndim(s) == 0 else s[which])
        nothing |= (not self.is_unique) & (found[which] > 0)  # another place of the same may be nearer, or inside
        value[which[nothing]] = np.maximum(value[which[nothing]], BEYOND * tolerance)
        return value

    def stays_flat(self, places, s):
        """About which places (n, 3) of a solid that is flat it is so before and after, too: (n,) bool."""
        total, found = self.edges[-1], np.ones(len(places), dtype=bool)
        for step in (-AFTER * total, AFTER * total):
            maps = np.nan_to_num(self.maps(places, np.clip(s + step, 0.0, total)))
            found &= np.linalg.svd(maps, compute_uv=False)[:, 2] <= FLAT * self.flattest
        return found

    def pierced(self, solid, places, maps, axes, tolerance):
        """Which places (n, 3) of a solid have what is outside within a tolerance, as maps have it: (n,) bool.

        Asked are places in some directions, and from the one that is least deep on where the depth falls fastest.
        """
        ways = np.einsum("nij,pj->npi", axes, AROUND)
        moved = solved(np.repeat(maps, len(AROUND), axis=0), tolerance * ways.reshape(-1, 3), ASIDE)
        moved = places[:, None] + moved.reshape(ways.shape)
        there = distant(solid, moved.reshape(-1, 3), self.box, APART * self.size).reshape(ways.shape[:2])
        best = there.argmax(axis=1)
        rows = np.arange(len(places))
        moved, found = moved[rows, best], there[rows, best] > 0
        for _ in range(FALLS):
            left = np.flatnonzero(~found)
            if not len(left):
                break
            fall = solved(maps[left].swapaxes(1, 2), slopes(solid, moved[left], DIFFERENCE * self.size), ASIDE)
            moved[left] = places[left] + solved(maps[left], tolerance * unit(fall), ASIDE)
            found[left] = distant(solid, moved[left], self.box, APART * self.size) > 0
        return found


class Scaling(Change):
    """A solid that is scaled along its own axes on its way.

    Parameters
    ----------
    motion : Motion
    box : (2, 3) float array
        Around the solid itself.
    """

    def __init__(self, motion, box):
        measure = arc_length(motion.trajectory)

        def scales(s):
            u, t = measure.parameter(s), s / measure.total
            return np.stack([law.evaluate(u, t, s) for law in motion.scales], axis=1)

        looked = np.abs(scales(np.linspace(0.0, measure.total, LOOKED)))
        require(looked.min(axis=1).max() > FLATTEST * looked.max(), "must not be 0 everywhere", 0.0, "scale_x")
        self.flattest = FLATTEST * looked.max()
        breaks = apart(measure.at(motion.trajectory.joints()), measure.total)
        self.panels = panels(scales, breaks, PARTS, np.full(3, looked.max()))
        super().__init__(box, *speeds(self.panels, np.abs(box).max(axis=0)))

    def scales(self, s):
        """The scales at places of the way, (n,) or one: (n, 3) or (3,) float array, none of them 0."""
        found = self.panels.held(np.atleast_1d(s))
        found = np.where(np.abs(found) < self.flattest, np.copysign(self.flattest, found), found)
        return found if np.ndim(s) else found[0]

    def back(self, places, s):
        """Places (n, 3) as the solid itself has them."""
        scales = self.scales(s)
        size, shape = np.abs(scales), len(places)
        ends = (np.broadcast_to(end, shape) for end in (size.min(axis=-1), size.max(axis=-1)))
        return Own(places / scales, *ends, *np.zeros((2, shape)))

    def maps(self, places, s):
        """The matrices that take directions of the solid itself at places (n, 3) to those of what it becomes."""
        return np.broadcast_to(self.scales(s), places.shape)[:, None] * np.eye(3)


def speeds(changed, factors):
    """Edges, and how fast points of a solid move at most between them.

    Parameters
    ----------
    changed : Panels
        Of channels, three for each point.
    factors : float or (3,) float array
        By which they are multiplied.
    """
    half = ((changed.end - changed.start) / 2)[:, None, None]
    rates = np.einsum("kcj,ij->kic", derivative(changed.series) / half, powers(NODES))
    moved = norms(rates.reshape(*rates.shape[:2], -1, 3) * factors)
    return np.append(changed.start, changed.end[-1]), ROOM * moved.max(axis=(1, 2))


def distant(solid, places, box, far):
    """The distance of places (n, 3) from a solid; of those farther from its box than some way that from the box."""
    beyond = from_box(places, *box)
    near = np.flatnonzero(beyond <= far)
    beyond[near] = solid.distance(places[near])
    return beyond


def slopes(solid, places, step):
    """The slopes of the distance from a solid at places (n, 3), by differences: (n, 3)."""
    moved = places[:, None, None] + step * np.array([[1.0], [-1.0]])[..., None] * np.eye(3)
    there = solid.distance(moved.reshape(-1, 3)).reshape(len(places), 2, 3)
    return (there[:, 0] - there[:, 1]) / (2 * step)
