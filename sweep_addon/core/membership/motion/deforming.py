# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The motion of a planar figure that is deformed on its way, and the way back: from points to places in the figure.

A place (x, y) of the figure is at arc length s in F(x, y, s). The figure's box times the way is cut into cells in which
F is so nearly linear that from a cell's middle Newton's method finds the one place that goes to a point. Where F folds
no cell is so small: those that are left are asked from several places.
"""

from functools import cached_property

import numpy as np

from ...declared.parameters import at, require
from ...formulas.expressions import compile
from ...shapes.general_sweep import PLACES
from ...trajectories.arc_length import arc_length
from ...vectors import norms
from .hash import Boxes
from .linear import solved
from .panels import panels
from .ways import PARTS, apart

SIDE = 4  # cells at first across the figure, in each direction, and along each smooth piece of the way
LINEAR = 0.25  # of a half cell: what F may be off its linear map there, by that map
DEPTH, MOST = 10, 1 << 15  # halvings, and cells
ROOM = 1.5  # for what is off between the places that are looked at
STEP = 1e-6  # of the figure, and of the way: over which slopes are taken
STEPS = 40  # of Newton's method
LEAST_GAIN = 0.1  # of what is missed: a step that gains less is the last
EXACT = 1e-13  # of the size
ROUNDING = 1e-12  # of the figure
ASIDE = 1e-6  # of a half cell: roots so far outside count
SPREAD = np.stack(np.meshgrid(*[(-1, 0, 1)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)  # where a cell is looked at
MIDDLE, BENT = 13, 0.5  # the middle of these; directions that bend so much of the most are halved
STARTS = 0.5 * SPREAD[(SPREAD != 0).all(axis=1)]  # in a cell that is not nearly linear


class Deforming:
    """The map F of a `GeneralSweep` of a planar figure, and its cells.

    Parameters
    ----------
    shape : GeneralSweep
    region : Still or Level
        Of the figure.
    whole : bool
        Whether all of the box around the figure is cut, or only what the figure reaches.

    Attributes
    ----------
    middle, half : (k, 3) float array
        The middles of the cells in x, y and s, and half their sides.
    off : (k,) float array
        How far F is from its linear map in each, in metres.
    linear : (k,) bool array
        Which are so nearly linear that a point has one place in them at most.
    """

    def __init__(self, shape, region, whole=False):
        self.shape, self.motion, self.region, self.whole = shape, shape.motion, region, whole
        self.measure = measure = arc_length(shape.trajectory)
        self.total = measure.total
        self.formulas = [compile(formula, PLACES) for formula in self.motion.formulas]

        def channels(s):
            poses = self.motion.at(np.append(0.0, s))
            return np.column_stack((poses.matrix[1:].reshape(-1, 9), poses.origin[1:], poses.u[1:]))

        looked = channels(np.linspace(0.0, self.total, 65))
        self.breaks = apart(measure.at(shape.trajectory.joints()), self.total)
        self.panels = panels(channels, self.breaks, PARTS, np.abs(looked).max(axis=0) + 1e-3 * np.abs(looked).max())
        self.steps = STEP * np.append(np.ptp(region.box, axis=0), self.total)
        self.cut()
        self.size = float(norms(self.box[1] - self.box[0]))

    @cached_property
    def around(self):
        """The same with all cells of the box around the figure."""
        return Deforming(self.shape, self.region, whole=True)

    def places(self, q):
        """Where places (n, 3) of figure and way are: (n, 3)."""
        s = np.clip(q[:, 2], 0.0, self.total)
        held = self.panels.held(s)
        inside = np.clip(q[:, :2], *self.region.box)  # what rounding brings out is asked where the figure ends
        x, y = np.where(np.abs(q[:, :2] - inside) < ROUNDING * np.ptp(self.region.box), inside, q[:, :2]).T
        known = {"x": x, "y": y, "z": np.zeros(len(q)), "t": s / self.total, "u": held[:, 12], "s": s}
        point = np.empty((len(q), 3))
        for axis, formula in enumerate(self.formulas):
            with at(f"deform_{'xyz'[axis]}"):
                point[:, axis] = formula.evaluate(**known)
        return np.einsum("nij,nj->ni", held[:, :9].reshape(-1, 3, 3), point) + held[:, 9:12]

    def slopes(self, q, here):
        """The derivatives of F at places q (n, 3) that go to here: (n, 3, 3), a column for each of x, y and s."""
        made = np.empty((len(q), 3, 3))
        for axis, step in enumerate(self.steps):
            middle = self.total / 2 if axis == 2 else self.region.box[:, axis].mean()
            steps = np.where(q[:, axis] > middle, -step, step)  # inwards: formulas may end where the figure does
            moved = q.copy()
            moved[:, axis] += steps
            made[:, :, axis] = (self.places(moved) - here) / steps[:, None]
        return made

    def cut(self):
        """Cut figure and way into cells, in halves along the directions in which F bends."""
        edges = [np.linspace(a, b, SIDE + 1) for a, b in self.region.box.T]
        along = zip(self.breaks[:-1], self.breaks[1:], strict=True)
        edges.append(np.append(np.concatenate([np.linspace(a, b, SIDE + 1)[:-1] for a, b in along]), self.total))
        middle, half = (
            np.stack(np.meshgrid(*part, indexing="ij"), axis=-1).reshape(-1, 3)
            for part in ([(side[1:] + side[:-1]) / 2 for side in edges], [np.diff(side) / 2 for side in edges])
        )
        kept, count = [], 0
        for depth in range(DEPTH + 1):
            reached = self.reached(middle, half)
            middle, half = middle[reached], half[reached]
            looked = self.places((middle[:, None] + half[:, None] * SPREAD).reshape(-1, 3)).reshape(-1, *[3] * 4)
            slope, off, bends = bent(looked)
            linear = np.abs(solved(slope[:, None], off)).max(axis=(1, 2)) <= LINEAR / ROOM
            off = ROOM * norms(off).max(axis=1)
            done = linear | (depth == DEPTH) | (count + 8 * len(middle) > MOST)
            reach = np.abs(slope).sum(axis=2) + off[:, None]
            cells = (middle, half, off, linear, looked[:, 1, 1, 1] - reach, looked[:, 1, 1, 1] + reach)
            kept.append([part[done] for part in cells])
            count += done.sum()
            if done.all():
                break
            middle, half = halved(middle[~done], half[~done], bends[~done])
        found = [np.concatenate(part) for part in zip(*kept, strict=True)]
        self.middle, self.half, self.off, self.linear, self.low, self.high = found
        require(len(self.middle), "must bound something", self.motion.formulas[0], "generator")
        self.box = np.stack((self.low.min(axis=0), self.high.max(axis=0)))

    def reached(self, middle, half):
        """Which cells the figure may reach: (k,) bool."""
        if self.whole or not self.region.is_still:
            return np.ones(len(middle), dtype=bool)
        return self.region.depth(middle[:, :2], middle[:, 2]) <= 1.001 * np.hypot(half[:, 0], half[:, 1])

    def boxes(self, tolerance):
        """The lattice of what the cells reach, with room for a tolerance around it."""
        room = max(tolerance, 1e-6 * self.size)
        return Boxes.of(self.low - room, self.high + room)

    def back(self, points, boxes, tolerance):
        """The places of figure and way that go to points, or as near to them as a tolerance.

        Parameters
        ----------
        points : (n, 3) float array
            So few that all pairs with cells fit into memory.
        boxes : Boxes
            The cells', with room for the tolerance.
        tolerance : float

        Returns
        -------
        point, cell : (k,) int array
            The point that each is of, and the cell that it is in.
        q : (k, 3) float array
        missed : (k,) float array
            How far from the point it goes: more than rounding where F folds beside the point, or at an end.
        """
        point, cell = boxes.pairs(boxes.cells(points))
        near = (points[point] >= self.low[cell] - tolerance) & (points[point] <= self.high[cell] + tolerance)
        point, cell = (part[near.all(axis=1)] for part in (point, cell))
        rough = np.flatnonzero(~self.linear[cell])
        begun = np.concatenate((np.zeros((len(cell), 3)), np.tile(STARTS, (len(rough), 1))))
        again = np.concatenate((np.arange(len(cell)), np.repeat(rough, len(STARTS))))
        point, cell = point[again], cell[again]
        q, missed = self.followed(points[point], self.middle[cell] + begun * self.half[cell], cell)
        kept = missed <= tolerance
        return point[kept], cell[kept], q[kept], missed[kept]

    def followed(self, points, q, cell):
        """Newton's method from q towards points, within a cell each: where it ends, and how far from the point."""
        low, high = (self.middle[cell] + side * (1 + ASIDE) * self.half[cell] for side in (-1, 1))
        low[:, 2], high[:, 2] = np.maximum(low[:, 2], 0.0), np.minimum(high[:, 2], self.total)
        best, missed, active = q.copy(), np.full(len(q), np.inf), np.arange(len(q))
        for _ in range(STEPS):
            if not len(active):
                break
            here = self.places(q)
            off = points[active] - here
            far = norms(off)
            better = far < (1 - LEAST_GAIN) * missed[active]
            best[active[better]], missed[active[better]] = q[better], far[better]
            going = better & (far > EXACT * self.size)
            active, q, here, off = active[going], q[going], here[going], off[going]
            q = np.clip(q + solved(self.slopes(q, here), off), low[active], high[active])
        return best, missed


def bent(looked):
    """The linear maps of cells of which places are looked at, and what is off them.

    Parameters
    ----------
    looked : (k, 3, 3, 3, 3) float array
        Where the 27 places of each go.

    Returns
    -------
    slope : (k, 3, 3) float array
        A column for each of the half sides.
    off : (k, 27, 3) float array
    bends : (k, 3) float array
        How much each cell bends along each direction.
    """
    axes = [np.moveaxis(looked, 1 + axis, 1) for axis in range(3)]
    rises = [(part[:, 2] - part[:, 0]) / 2 for part in axes]
    slope = np.stack([rise[:, 1, 1] for rise in rises], axis=2)
    off = looked.reshape(len(looked), 27, 3) - looked[:, 1, 1, 1][:, None] - np.einsum("pi,kji->kpj", SPREAD, slope)
    bends = []
    for part, rise in zip(axes, rises, strict=True):
        own, others = norms(part[:, 2] + part[:, 0] - 2 * part[:, 1]) / 2, norms(rise - rise[:, 1:2, 1:2])
        bends.append(own.max(axis=(1, 2)) + others.max(axis=(1, 2)))
    return slope, off, np.stack(bends, axis=1)


def halved(middle, half, bends):
    """Cells cut in two along each direction in which they bend nearly as much as in any."""
    for axis in range(3):
        cut = bends[:, axis] >= BENT * bends.max(axis=1)
        counts = np.where(cut, 2, 1)
        middle, half, bends = (np.repeat(part, counts, axis=0) for part in (middle, half, bends))
        second = np.arange(len(middle)) - np.repeat(np.cumsum(counts) - counts, counts) > 0
        cut = np.repeat(cut, counts)
        half[cut, axis] /= 2
        middle[cut, axis] += np.where(second[cut], 1, -1) * half[cut, axis]
    return middle, half
