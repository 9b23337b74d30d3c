# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The region of the plane that a contour bounds: its true curves where they have an equation, else its polygon."""

from functools import lru_cache

import numpy as np

from ...contours import Circle, Ellipse, Fit, Outline, Superellipse, all_fitted
from ...later import later
from ...meshes.runs import run_of
from .loops import Loops
from .maps import narrowest, slopes
from .smooth import Disc, Superdisc
from .strands import Strands

edges = later("core.contours.offsetting", "edges")

SLOPED = 33  # places along each side where it is looked at how steep a formula is
ROOM = 1.25  # for what is steeper between them
DIFFERENCE = 1e-6  # of the size, and of the way: over which slopes are taken
NEARLY = 0.05  # of the size: so near the boundary a formula is a distance to first order
LEAST = 1e-300


@lru_cache(maxsize=64)
def region(contour):
    """The region of a contour about its reference point; of an open one its lines and arcs, which have no inside.

    Parameters
    ----------
    contour : Contour or Mixed
        Of a mixed one what is of two dimensions, and the rest only where there is nothing of two.

    Returns
    -------
    Disc, Superdisc, Loops or Strands

    Examples
    --------
    >>> from ...contours import Rectangle
    >>> round(float(region(Rectangle(2.0, 2.0, rounding=0.5)).exact(np.array([(1.0, 1.0)]))[0][0]), 6)
    0.207107
    """
    if isinstance(contour, Circle):
        return Disc(contour.radius)
    if isinstance(contour, Ellipse):
        return Superdisc((contour.radius_x, contour.radius_y), 2.0)
    if isinstance(contour, Superellipse) and contour.exponent >= 1:
        return Superdisc(contour.half, contour.exponent)
    if isinstance(contour, Outline) and contour.closed and contour.edges()[2].any():
        return of_arcs(contour)
    if getattr(contour, "rounding", 0.0):
        return of_corners(*contour.corners())
    if isinstance(contour, Outline) and not contour.closed:
        contour.section()  # refuses what the mesh would
        return Strands.of_outline(contour)
    sections = [section for section in all_fitted(contour, Fit.INSCRIBED) if section]
    bounding = [section for section in sections if section.closed]
    return of_sections(bounding) if bounding else Strands.of_sections(sections)


@lru_cache(maxsize=64)
def curved(contour):
    """The region of a closed contour, with an arc over each chord of its polygon where that stands for a curve."""
    found, tops = region(contour), getattr(contour, "apexes", lambda: None)
    if not isinstance(found, Loops) or found.arcs.any() or tops() is None:
        return found
    return Loops.of(*edges(contour))


def of_sections(sections):
    """The region of some `Section`s that do not overlap."""
    points = np.concatenate([section.points for section in sections])
    sizes = np.concatenate([np.diff(section.offsets) for section in sections])
    return Loops.of(points, np.append(0, np.cumsum(sizes)), np.zeros(len(points)))


def of_arcs(outline):
    """The region of an outline's own lines and arcs, outer loops counter-clockwise and holes clockwise."""
    corners, offsets, bulges = outline.edges()
    areas = outline.signed_areas()
    turned = (areas > 0) != (outline.section().depth % 2 == 0)
    first, loop = offsets[:-1][run_of(offsets)], run_of(offsets)
    place, size = np.arange(len(corners)) - first, np.diff(offsets)[loop]
    back = first + (-place) % size
    before = first + (-place - 1) % size
    points = np.where(turned[loop][:, None], corners[back], corners)
    return Loops.of(points, offsets, np.where(turned[loop], -bulges[before], bulges))


def of_corners(centres, radius, first, turn, points):
    """The region of a convex figure with round corners, as `contours.rounding` has them."""
    angles = np.stack((first, first + turn), axis=1)
    ends = centres[:, None] + radius * np.stack((np.cos(angles), np.sin(angles)), axis=2)
    bulges = np.tile((np.tan(turn / 4), 0.0), len(centres))
    ends = ends.reshape(-1, 2)
    kept = np.hypot(*(np.roll(ends, -1, axis=0) - ends).T) > 1e-12 * radius  # sides that the arcs leave nothing of
    return Loops.of(ends[kept], np.array([0, kept.sum()]), bulges[kept])


def half_diagonal(box):
    """How far a region gets from the middle of the box around it at most."""
    return float(np.hypot(*(box[1] - box[0]))) / 2


class Still:
    """A region that is the same all along the way."""

    is_still = True

    def __init__(self, region):
        self.region, self.box, self.radius = region, region.box, half_diagonal(region.box)
        self.is_open, self.is_round = isinstance(region, Strands), isinstance(region, Disc)
        self.radius = region.radius if self.is_round else self.radius

    def depth(self, points, parameters):
        """How far points (n, 2) are from the boundary, negative inside, away from it at least: (n,)."""
        return self.region.depth(points)

    def exact(self, points, parameters):
        """The distance from the boundary, and the unit vectors away from it: (n,), (n, 2)."""
        return self.region.exact(points)

    def distance(self, points, parameters):
        """How far points (n, 2) are from the boundary, or a fair part of that, negative inside: (n,)."""
        return getattr(self.region, "fair", self.region.distance)(*points.T)

    def growth(self, points, parameters):
        """How fast the distance grows as the contour changes: it does not."""
        return 0.0

    def change(self, parameter, count, places):
        """By how much the distance changes at most in half of each panel as the contour does: it does not."""
        return 0.0

    def standing(self, parameter):
        """The region as it is at a parameter."""
        return self


class Level:
    """Where the formula of a `Region` is negative, as it changes on the way."""

    is_open = is_still = is_round = False

    def __init__(self, region, total):
        self.region, self.total = region, total
        half = region.size / 2
        self.box = np.array([[-half, -half], [half, half]])
        self.radius = half_diagonal(self.box)
        self.step = DIFFERENCE * region.size
        side, way = np.linspace(-half, half, SLOPED), np.linspace(0.0, 1.0, SLOPED)
        values = region.evaluate(*np.meshgrid(side, side, way, indexing="ij"))
        self.steepest = ROOM * float(np.hypot(*np.gradient(values, side, side, way)[:2]).max())

    def depth(self, points, parameters):
        """The formula over the most that it rises, in the square that is looked at; outside positive: (n,)."""
        beyond = (np.abs(points) - self.box[1]).max(axis=1)
        held = np.clip(points, *self.box)
        value = self.region.evaluate(*held.T, parameters / self.total) / self.steepest
        return np.where(beyond > 0, np.maximum(beyond, value), value)

    def exact(self, points, parameters):
        """The distance near the boundary to first order, and unit vectors away: (n,), (n, 2)."""
        slope = self.slopes(points, parameters)
        steep = np.maximum(np.hypot(*slope.T), LEAST)
        return self.region.evaluate(*points.T, parameters / self.total) / steep, slope / steep[:, None]

    def distance(self, points, parameters):
        """How far points (n, 2) are from the boundary, to first order near it, and else less, negative inside: (n,)."""
        return self.mapped(points, parameters)

    def mapped(self, points, parameters, maps=None):
        """The same where maps (n, 2, 2) of the plane take all: (n,)."""
        least, slope = self.depth(points, parameters), self.slopes(points, parameters)
        steep, narrow = np.hypot(*slope.T), 1.0
        if maps is not None:
            least, steep, narrow = least * narrowest(maps), slopes(slope, maps), narrowest(maps)
        most = NEARLY * self.radius * narrow
        value = np.abs(self.region.evaluate(*points.T, parameters / self.total))
        first = np.minimum(value, most * steep) / np.maximum(steep, LEAST)  # so that no square overflows
        near = first * (1 - first / most)
        within = (np.abs(points) <= self.box[1]).all(axis=1)
        return np.where(within, np.sign(least) * np.maximum(np.abs(least), near), least)

    def growth(self, points, parameters):
        """How fast the distance grows as the formula changes: (n,)."""
        ends = [np.clip(parameters / self.total + side * DIFFERENCE, 0.0, 1.0) for side in (-1, 1)]
        before, after = (self.region.evaluate(*points.T, t) for t in ends)
        steep = np.maximum(np.hypot(*self.slopes(points, parameters).T), LEAST)
        return (after - before) / (ends[1] - ends[0]) / self.total / steep

    def change(self, parameter, count, places):
        """By how much the distance changes at most in half of each panel: it is not known."""
        return np.inf

    def slopes(self, points, parameters):
        """How the formula rises along x and y: (n, 2)."""
        (x, y), t, step = points.T, parameters / self.total, self.step
        ask = self.region.evaluate
        rises = ask(x + step, y, t) - ask(x - step, y, t), ask(x, y + step, t) - ask(x, y - step, t)
        return np.stack(rises, axis=1) / (2 * step)
