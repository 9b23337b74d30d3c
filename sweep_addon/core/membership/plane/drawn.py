# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions that change on the way: polygons whose points move, as those of morphs and of drafts do."""

import numpy as np

from ...meshes.runs import following
from ...vectors import dot, norms, unit
from .loops import Loops
from .one_by_one import nearest_of_each
from .regions import Still
from .strands import Strands

CHUNK = 1 << 18  # pairs of points and edges at a time
STEP = 1e-6  # of the way: over which growth is taken
ROOM = 1.1  # for what moves faster between the places that are looked at


class Drawn:
    """A polygon that depends on a parameter.

    Parameters
    ----------
    at : callable
        From parameters (n,) to its points (n, m, 2), loops one after the other, the region on their left; or lines.
    offsets : (k + 1,) int array
        Where each loop begins.
    ends : (2,) float array
        The least and the greatest parameter.
    looked : (p,) float array
        Parameters between which no point leaves the box of those there.
    gaps : (g,) int array
        Points that no edge leads on from, of lines that are open, which have no inside.
    """

    def __init__(self, at, offsets, looked, gaps=()):
        self.at, self.offsets, self.ahead, self.ends = at, offsets, following(offsets), looked[[0, -1]]
        self.is_open, self.is_round = len(gaps) > 0, False
        self.ahead[list(gaps)] = gaps  # an edge without length
        points = at(looked).reshape(-1, 2)
        self.box = np.stack((points.min(axis=0), points.max(axis=0)))
        self.radius = float(np.hypot(*(self.box[1] - self.box[0]))) / 2

    def depth(self, points, parameters):
        """How far points (n, 2) are from the boundary, negative inside: (n,)."""
        return self.exact(points, parameters)[0]

    def exact(self, points, parameters):
        """The same, and unit vectors away from the boundary: (n,), (n, 2)."""
        depth, outward = np.empty(len(points)), np.empty((len(points), 2))
        size = max(CHUNK // len(self.ahead), 1)
        for start in range(0, len(points), size):
            some = slice(start, start + size)
            depth[some], outward[some] = nearest(points[some], self.at(parameters[some]), self.ahead)
        return (np.abs(depth), outward * np.where(depth < 0, -1, 1)[:, None]) if self.is_open else (depth, outward)

    def distance(self, points, parameters):
        """The same as the depth: (n,)."""
        return self.mapped(points, parameters)

    def mapped(self, points, parameters, maps=None):
        """The same where maps (n, 2, 2) of the plane take all: (n,)."""
        found, size = np.empty(len(points)), max(CHUNK // len(self.ahead), 1)
        for start in range(0, len(points), size):
            some = slice(start, start + size)
            maps_of = None if maps is None else maps[some]
            found[some] = nearest_of_each(self.at(parameters[some]), self.ahead, points[some], maps_of)
        return np.abs(found) if self.is_open else found

    def change(self, parameter, count, places):
        """By how much the distance changes at most in half of each panel as the points move: (count,)."""
        looked = parameter(np.repeat(np.arange(count), len(places)), np.tile(places, count))
        points = self.at(looked).reshape(count, len(places), -1, 2)
        return ROOM * (norms(np.diff(points, axis=1)).max(axis=2) / np.diff(places)).max(axis=1)

    def standing(self, parameter):
        """The region as it is at a parameter."""
        points = self.at(np.array([parameter]))[0]
        if self.is_open:
            return Still(Strands(points, points[self.ahead], np.zeros(len(points))))
        return Still(Loops.of(points, self.offsets, np.zeros(len(points))))

    def growth(self, points, parameters):
        """How fast the distance grows as the parameter does, where points stay: (n,)."""
        step = STEP * (self.ends[1] - self.ends[0])
        before, after = (np.clip(parameters + side * step, *self.ends) for side in (-1, 1))
        return (self.depth(points, after) - self.depth(points, before)) / (after - before)


def nearest(points, corners, ahead):
    """How far points (n, 2) are from a polygon each, (n, m, 2), negative inside, and the way from it: (n,), (n, 2).

    Inside is where a ray along x crosses an odd number of edges.
    """
    start, end = corners, corners[:, ahead]
    along, way = end - start, points[:, None] - start
    squares = dot(along, along)
    share = np.clip(dot(way, along) / np.where(squares > 0, squares, 1.0), 0.0, 1.0)
    off = way - share[..., None] * along
    far = np.where(squares > 0, dot(off, off), np.inf)
    edge = far.argmin(axis=1)
    row = np.arange(len(points))
    above, below = way[..., 1] < 0, points[:, None, 1] < end[..., 1]  # the start is above, the end is
    left = along[..., 0] * way[..., 1] - along[..., 1] * way[..., 0] > 0
    inside = ((above != below) & (left == below)).sum(axis=1) % 2 == 1
    off, least = off[row, edge], np.sqrt(far[row, edge])
    normal = along[row, edge][:, ::-1] * (1, -1)
    side = np.where(inside, -1.0, 1.0)
    outward = np.where((least > 1e-12 * norms(along[row, edge]))[:, None], off * side[:, None], normal)
    return side * least, unit(outward)
