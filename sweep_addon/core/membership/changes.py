# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What becomes of a solid itself on its way, beside its rigid motion: how fast it changes, and how far points are then.

Seen by the rigid motion a point moves at a known speed, and the surface of the solid at another one at most, so both
together say how long nothing can happen.
"""

from functools import cached_property
from itertools import pairwise

import numpy as np

from ..declared.parameters import require
from ..trajectories.arc_length import arc_length
from ..vectors import norms
from .panels import NODES, derivative, panels, powers
from .ways import PARTS, apart

MORE = 4.0  # times what a solid changes between two poses as a rule: where it is more poses are closer
HALVINGS = 20  # of what is between two poses
FASTER = 1.5  # times its speed about a pose: where a solid changes faster than that it is looked at again
ROOM = 1.1  # for what changes faster between the places that are looked at
LOOKED = 257
FLATTEST = 1e-9  # of the largest scale: what is flatter counts as so thick
APART = 0.5  # of a solid's size: what is farther from its box is as far from the solid, or farther
DIFFERENCE = 1e-6  # of a solid's size: over which slopes are taken
LEAST = 1e-300


class Change:
    """How fast a solid changes.

    Parameters
    ----------
    edges : (k + 1,) float array
        Places of the way in metres, rising, the first 0 and the last its end.
    growth : (k,) float array
        How far points of the solid move at most, the rigid motion aside, in metres for each metre of the way between
        two of these places.
    """

    def __init__(self, edges, growth):
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


class Scaling(Change):
    """A solid that is scaled along its own axes on its way.

    Parameters
    ----------
    motion : Motion
    box : (2, 3) float array
        Around the solid.

    The distance from what is scaled is at least that of the solid itself times the least scale, and exactly so where
    all three are equal. Near its surface it is to first order the distance over the length of its slope.
    """

    def __init__(self, motion, box):
        measure = arc_length(motion.trajectory)
        self.box, self.size = box, float(norms(box[1] - box[0]))

        def scales(s):
            u, t = measure.parameter(s), s / measure.total
            return np.stack([law.evaluate(u, t, s) for law in motion.scales], axis=1)

        looked = np.abs(scales(np.linspace(0.0, measure.total, LOOKED)))
        require(looked.min(axis=1).max() > FLATTEST * looked.max(), "must not be 0 everywhere", 0.0, "scale_x")
        self.largest = float(looked.max())
        self.flattest = FLATTEST * self.largest
        breaks = apart(measure.at(motion.trajectory.joints()), measure.total)
        self.panels = panels(scales, breaks, PARTS, np.full(3, looked.max()))
        half = ((self.panels.end - self.panels.start) / 2)[:, None, None]
        rates = np.einsum("kcj,ij->kic", derivative(self.panels.series) / half, powers(NODES))
        edges = np.append(self.panels.start, self.panels.end[-1])
        super().__init__(edges, ROOM * norms(rates * np.abs(box).max(axis=0)).max(axis=1))

    def scales(self, s):
        """The scales at places of the way, (n,) or one: (n, 3) or (3,) float array, none of them 0."""
        places = np.atleast_1d(s)
        start, end = self.panels.start, self.panels.end
        panel = np.clip(np.searchsorted(start, places, side="right") - 1, 0, len(start) - 1)
        x = np.clip((2 * places - start[panel] - end[panel]) / (end[panel] - start[panel]), -1.0, 1.0)
        found = self.panels.at(panel, x)
        found = np.where(np.abs(found) < self.flattest, np.copysign(self.flattest, found), found)
        return found if np.ndim(s) else found[0]

    def back(self, places, s):
        """Places (n, 3) as the solid itself has them, and the scales there: two (n, 3)."""
        scales = np.broadcast_to(self.scales(s), places.shape)
        return places / scales, scales

    def distance(self, solid, places, s, tolerance):
        """How far places (n, 3) are from the scaled solid, or less, but no less within a tolerance: (n,)."""
        own, scales = self.back(places, s)
        least = np.abs(scales).min(axis=1)
        found = distant(solid, own, self.box, APART * self.size)
        near = np.flatnonzero((least * np.abs(found) <= tolerance) & (least < np.abs(scales).max(axis=1)))
        if len(near):
            steep = norms(slopes(solid, own[near], DIFFERENCE * self.size) / scales[near])
            least[near] = 1 / np.maximum(steep, 1 / np.abs(scales[near]).max(axis=1))
        return least * found


def distant(solid, places, box, far):
    """The distance of places (n, 3) from a solid; of those farther from its box than some way that from the box."""
    beyond = norms(np.maximum(np.maximum(box[0] - places, places - box[1]), 0.0))
    near = np.flatnonzero(beyond <= far)
    beyond[near] = solid.distance(places[near])
    return beyond


def slopes(solid, places, step):
    """The slopes of the distance from a solid at places (n, 3), by differences: (n, 3)."""
    moved = places[:, None, None] + step * np.array([[1.0], [-1.0]])[..., None] * np.eye(3)
    there = solid.distance(moved.reshape(-1, 3)).reshape(len(places), 2, 3)
    return (there[:, 0] - there[:, 1]) / (2 * step)
