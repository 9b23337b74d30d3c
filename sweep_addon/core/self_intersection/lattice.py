# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The lattice of a sweep: the points of its contours, ring after ring, and which of them are too near to meet."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..grids.grid import Grid
from ..vectors import dot, norms

SURE = 0.999  # of a turn in which discs would meet: what a mesh's chords leave of it
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
