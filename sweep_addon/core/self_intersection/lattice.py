# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The lattice of a sweep: the points of its contours, ring after ring, and which stretches of it may meet.

Most stretches are ruled out without a look at their faces: they are far from each other, or the discs round their
contours are too near along the trajectory to meet.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..grids.grid import Grid
from ..vectors import dot, norms, unit

BANDS = 8  # in the shortest stretches
COARSE = 64  # stretches that the search begins with, at least
SURE = 0.999  # of a turn in which discs would meet: what a mesh's chords leave of it
MANY = 1000  # pairs of stretches: where there are more, every other ring is enough to see how they meet
FEWEST = 128  # rings that are left of it
WIDEST = 0.2  # radians from one ring that is left to the next


@dataclass(frozen=True, eq=False)
class Lattice:
    """The rings of a sweep and how they move; any shape whose faces are a `Grid` has one.

    Parameters
    ----------
    grid : Grid
    at : callable
        From numbers of rings, an int array of any shape, to the points of all columns there: (m, ..., 3) in metres.
        Those of a tip are all the same.
    path : (n, 3) float array
        The trajectory at each ring; a contour across it moves along it.
    middles : (n, 3) float array
        The reference point of each ring, from which a scale moves the others.
    normals : (n, 3) float array
        Unit normals of the rings' planes, all of them forward.
    radii : (n,) float array
        No point of a ring is farther from the trajectory.
    u : (n,) float array
        The trajectory's parameter at each ring.
    rings : (n,) int array
        Their numbers; a closed sweep's first ring stands at its end too, with the number of all.
    leaning : (n,) bool array
        Which of them are not across the path: boxes alone tell what those may meet.
    """

    grid: Grid
    at: Callable
    path: np.ndarray
    middles: np.ndarray
    normals: np.ndarray
    radii: np.ndarray
    u: np.ndarray
    rings: np.ndarray
    leaning: np.ndarray

    @classmethod
    def of(cls, grid, at, path, middles, normals, radii, u, end, leaning=None):
        """The lattice of all rings of a grid, a closed one's first again at the parameter where it ends."""
        rings = np.arange(grid.rings)
        leaning = np.zeros(len(rings), bool) if leaning is None else leaning
        if not grid.closed:
            return cls(grid, at, path, middles, normals, radii, u, rings, leaning)
        seam = np.array(grid.seam, dtype=int) if grid.seam else slice(None)

        def at_again(asked):
            points = at(asked % grid.rings)
            again = asked == grid.rings
            if grid.seam and again.any():
                points[:, again] = points[:, again][seam]
            return points

        again = np.append(rings, 0)
        parts = (part[again] for part in (path, middles, normals, radii))
        return cls(grid, at_again, *parts, np.append(u, end), np.append(rings, grid.rings), leaning[again])

    @classmethod
    def of_vertices(cls, grid, vertices, path, normals, u, end, leaning=None):
        """The lattice of the vertices (v, 3) of a mesh with that grid and no tips."""
        points = np.empty((grid.columns, grid.rings, 3))
        lines = len(grid.lines) * grid.rings
        points[grid.lines] = vertices[:lines].reshape(-1, grid.rings, 3)
        points[list(grid.poles)] = vertices[lines:, None]
        radii = np.sqrt(sum((points[..., axis] - path[:, axis]) ** 2 for axis in range(3)).max(axis=0))
        return cls.of(grid, lambda asked: points[:, asked], path, path, normals, radii, u, end, leaning)

    def points(self, which):
        """The points of rings, by their places in this lattice: (...) int to (m, ..., 3)."""
        return self.at(self.rings[which])

    def scaled(self, factor):
        """The same with all contours scaled about their reference points."""
        middles = np.empty((self.rings[-1] + 1, 3))
        middles[self.rings] = self.middles
        aside = norms(self.middles - self.path)

        def at(asked):
            return middles[asked] + factor * (self.at(asked) - middles[asked])

        return replace(self, at=at, radii=aside + factor * (self.radii + aside))

    def thinned(self):
        """Every other ring of it, with the tips, the ends and those between which it turns much at once."""
        kept = np.arange(len(self.u)) % 2 == 0
        kept[[0, -1]] = True
        kept[np.isin(self.rings, self.grid.tips)] = True
        sharp = np.flatnonzero(self.turns > WIDEST / 2)
        kept[sharp] = kept[sharp + 1] = True
        return self.only(kept)

    def coarser(self, fewest=FEWEST):
        """The same thinned; None where no more rings are left than so many, or few can be left out."""
        thinner = self.thinned() if len(self.u) > fewest else self
        return thinner if len(thinner.u) <= 0.8 * len(self.u) else None

    def numbered(self, rings, count):
        """The same with its rings known by other numbers, (n,), as those of so many that a shape has."""
        rings = np.append(rings, count) if self.closed else rings
        return replace(self, at=lambda asked: self.at(np.searchsorted(rings, asked)), rings=rings)

    def only(self, kept):
        """Some rings of it, as (n,) bools say."""
        parts = (self.path, self.middles, self.normals, self.radii, self.u, self.rings, self.leaning)
        return Lattice(self.grid, self.at, *(part[kept] for part in parts))

    @cached_property
    def size(self):
        """How large it all is in metres, or a little less."""
        return float(np.ptp(self.path, axis=0).max() + 2 * self.radii.max())

    @property
    def bands(self):
        return len(self.u) - 1

    @property
    def closed(self):
        return bool(self.grid.closed)

    @cached_property
    def turns(self):
        """By how many radians the planes turn in each band: (n - 1,)."""
        half = norms(np.diff(self.normals, axis=0)) / 2
        return 2 * np.arcsin(np.minimum(half, 1.0))

    @cached_property
    def turned(self):
        """By how much the planes have turned up to each ring, (n,)."""
        return np.concatenate(([0.0], np.cumsum(self.turns)))

    @cached_property
    def unsure(self):
        """How many bands up to each ring turn so much that discs round their contours might meet: (n,) int."""
        forward = dot(np.diff(self.path, axis=0), self.normals[1:] + self.normals[:-1]) / 2
        leaning = self.leaning[1:] | self.leaning[:-1]
        return np.concatenate(([0], np.cumsum((self.turns * self.radii.max() > SURE * forward) | leaning)))

    def held(self, folded):
        """Whether stretches of rings in which discs cannot meet, or which hold a fold, are near: a `Nearness`."""
        count = np.zeros(len(self.u), int)
        for start, end in folded:
            count += (self.u >= start) & (self.u <= end)
            within = np.searchsorted(self.u, (start + end) / 2).clip(1, len(self.u) - 1)
            count[within - 1 : within + 1] += 1  # a fold may be between two rings
        return Nearness(self.turned, self.unsure, np.concatenate(([0], np.cumsum(count))), self.closed)


@dataclass(frozen=True, eq=False)
class Nearness:
    """What tells of two rings that the stretch between them is too short, or too little bent, for them to meet.

    Two discs of radius r across a curve cannot meet where it turns by less than a right angle between them and bends
    nowhere as r does: f(w) = (x - p(w)) . t(w) of a common point x would vanish at both, falling, so that x is farther
    than r away in between, and that takes a greater turn. Where it bends more, and the contour folds, they meet as its
    local test has told.
    """

    turned: np.ndarray
    unsure: np.ndarray
    folds: np.ndarray
    closed: bool

    def near(self, first, last):
        """Of rings (k,) and later ones (k,), whether all between is so, one way round or the other: (k,) bool."""
        unsure = self.unsure[last] - self.unsure[first]
        folds = self.folds[last + 1] - self.folds[first]
        near = (self.turned[last] - self.turned[first] < np.pi / 2) & ((unsure == 0) | (folds > 0))
        return near | self.all_folded(first, last, folds)

    def around(self, first, last):
        """The same the other way round, from later rings to the first ones through the start: (k,) bool."""
        if not self.closed:
            return np.zeros(len(first), bool)
        unsure = self.unsure[-1] - self.unsure[last] + self.unsure[first]
        folds = self.folds[-1] - self.folds[last] + self.folds[first + 1]
        turn = self.turned[-1] - self.turned[last] + self.turned[first]
        rings = len(self.turned) - last + first + 1
        return (turn < np.pi / 2) & ((unsure == 0) | (folds > 0)) | (folds >= rings)

    def all_folded(self, first, last, folds):
        return folds >= last - first + 1


def stretches(bands, size):
    """The first ring and the last of stretches of so many bands: two (k,)."""
    start = np.arange(0, bands, size)
    return start, np.minimum(start + size, bands)


def coarse(lattice, folded):
    """The lattice, of few enough rings to look closely at all that may meet, and the stretches that may.

    Parameters
    ----------
    lattice : Lattice
    folded : sequence of (float, float)
        Parameters between which it folds, as the local test has told.

    Returns
    -------
    lattice : Lattice
    pairs : (k, 2) int array
        Numbers of stretches of `BANDS` bands, the first no larger than the second.
    """
    while True:
        found = far_pairs(lattice, folded)
        if len(found) <= 2 * MANY:
            found = found[boxes_meet(lattice, *found.T)]
        thinner = lattice.coarser() if len(found) > MANY else None
        if not thinner:
            return lattice, found
        lattice = thinner


def far_pairs(lattice, folded):
    """Stretches of bands whose balls meet, and between which there is enough way for them to: (k, 2) int array."""
    nearness = lattice.held(folded)
    halvings = max(int(np.log2(max(lattice.bands / (BANDS * COARSE), 1))), 0)
    first, last = np.triu_indices(-(-lattice.bands // (BANDS << halvings)))
    for size in (BANDS << level for level in range(halvings, -1, -1)):
        start, end = stretches(lattice.bands, size)
        if size < BANDS << halvings:
            first, last = children(first, last, len(start))
        middle, radius = balls(lattice, start, end)
        kept = norms(middle[first] - middle[last]) <= radius[first] + radius[last]
        first, last = first[kept], last[kept]
        kept = ~(nearness.near(start[first], end[last]) | nearness.around(end[first], start[last]))
        first, last = first[kept], last[kept]
    return np.stack((first, last), axis=1)


def children(first, last, count):
    """Of pairs of stretches those of their halves: each pair once."""
    pairs = np.stack((np.repeat(2 * first, 4), np.repeat(2 * last, 4)))
    pairs += np.tile([[0, 0, 1, 1], [0, 1, 0, 1]], len(first))
    return pairs[:, (pairs[0] <= pairs[1]) & (pairs[1] < count)]


def balls(lattice, start, end):
    """Balls round stretches: their middles (k, 3) and radii (k,)."""
    middle = (lattice.path[start] + lattice.path[end]) / 2
    size = int((end - start).max())
    rings = np.minimum(start[:, None] + np.arange(size + 1), end[:, None])
    return middle, (norms(lattice.path[rings] - middle[:, None]) + lattice.radii[rings]).max(axis=1)


def boxes_meet(lattice, first, last):
    """Whether boxes round stretches meet, along the axes of both and between their directions: (k,) bool."""
    if not len(first):
        return np.zeros(0, bool)
    used, which = np.unique(np.concatenate((first, last)), return_inverse=True)
    i, j = which.reshape(2, -1)
    middle, axes, half = boxes(lattice, *(part[used] for part in stretches(lattice.bands, BANDS)))
    chord = middle[j] - middle[i]
    meet = np.full(len(i), True)
    between = unit(axes[i, 0] + axes[j, 0])
    for direction in (between, unit(chord), *(axes[side, k] for side in (i, j) for k in range(3))):
        reach = sum(
            (half[side] * np.abs(np.einsum("pak,pk->pa", axes[side], direction))).sum(axis=1) for side in (i, j)
        )
        meet &= np.abs(dot(chord, direction)) <= reach
    return meet


def boxes(lattice, start, end):
    """Boxes round stretches: their middles (k, 3), axes (k, 3, 3), the first one forward, and half their edges."""
    rings = np.minimum(start[:, None] + np.arange(BANDS + 1), end[:, None])
    origin = lattice.path[start]
    points = lattice.points(rings).transpose(1, 3, 0, 2).reshape(len(rings), 3, -1)
    points -= origin[:, :, None]
    forward = unit(lattice.normals[rings].sum(axis=1))
    aside = points[:, :, :: BANDS + 1]
    longest = aside[np.arange(len(aside)), :, (aside * aside).sum(axis=1).argmax(axis=1)]
    wide = longest - dot(longest, forward)[:, None] * forward
    none = norms(wide) < 1e-12
    wide[none] = np.cross(forward[none], np.eye(3)[np.abs(forward[none]).argmin(axis=1)])
    wide = unit(wide)
    axes = np.stack((forward, wide, np.cross(forward, wide)), axis=1)
    along = axes @ points
    low, high = along.min(axis=2), along.max(axis=2)
    return origin + np.einsum("pa,pak->pk", (low + high) / 2, axes), axes, (high - low) / 2
