# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Canal surfaces that do not end in a ball: all characteristic discs, and at a round end the ball.

A point x is in the characteristic disc at s where it is in the ball and f(s) = |x - t|^2 - r^2 is level, and that is
where the plane of the disc passes through it: h(s) = (x - t) . T + r r' is 0. Where the tangent T or r' changes at once
h may change its sign at once, and the discs turn through x on one ball.
"""

from functools import cached_property

import numpy as np

from ...envelopes.balls import Balls
from ...shapes.canal_surface import BallEnd
from ...vectors import dot, norms
from ..labels import IN, ON, OUT, TOUCHED, decided
from ..motion.hash import Boxes
from ..motion.panels import at_both
from ..motion.roots import all_roots, simple
from ..motion.ways import of_canal
from .balls import CHUNK, BallsBody
from .moving_plane import MovingPlane
from .plane_distance import PlaneDistance

PLACE, RADIUS, AXIS, ALONG = slice(0, 3), 3, slice(4, 7), 7  # channels
TURNED = 1e-9  # what counts as a jump of the tangent, and of the largest radius of r r'


class DiscsBody(BallsBody):
    """What the characteristic discs of a `CanalSurface` visit, and the balls of its round ends.

    With an open end it is a sheet: the circles alone, what is left of the ball at a round end, the disc at a flat one.
    """

    def __init__(self, shape):
        super().__init__(shape)
        self.shape = shape
        self.is_circles = not shape.is_plane and BallEnd.OPEN in (shape.start, shape.end)
        self.ends = shape.start, shape.end
        if shape.is_plane:  # a region ends in the line, whether it is a face or none
            self.ends = tuple(BallEnd.ROUND if end is BallEnd.ROUND else BallEnd.FLAT for end in self.ends)
        self.is_sheet = shape.is_plane or self.is_circles
        begun, ended = at_both(self.panels.series)
        self.outer = begun[0], ended[-1]
        jumps = np.abs(begun[1:, AXIS.start :] - ended[:-1, AXIS.start :])
        self.turning = np.append(
            (jumps > TURNED * np.array([1.0, 1.0, 1.0, np.abs(self.box).max()])).any(axis=1), False
        )

    def planes(self, balls, u, s):
        """The channels of the planes in which the discs lie: the axes, and how far along them the middles are."""
        axis, radius, slope = balls.trajectory.tangents(u), balls.radius(u, s), balls.slopes(u, s)[0]
        with np.errstate(invalid="ignore"):
            grown = np.where(radius == 0, 0.0, radius * slope)
        return axis, dot(axis, balls.trajectory.evaluate(u)) - grown

    def distance(self, points):
        """How far points (n, 3) are from the discs and round ends, or less; negative inside, or less deep: (n,)."""
        least = super().distance(points)
        near = np.flatnonzero(least <= self.largest)
        places = points[near]
        labels = decided(self.labels(places, self.rounding), places, self.rounding, self)
        inside = labels == IN
        found = self.discs.unsigned(places, inside)
        found[inside] = np.minimum(found[inside], self.discs.from_faces(places[inside]))
        for at in self.balls:
            far = norms(places - at[PLACE]) - at[RADIUS]
            found = np.minimum(found, np.where(inside, np.abs(far), np.maximum(far, 0.0)))
        least[near] = np.where(inside, -found, found)
        return least

    @cached_property
    def largest(self):
        """The largest radius."""
        return float(np.abs(self.panels.series[:, RADIUS]).sum(axis=1).max())

    @cached_property
    def rounding(self):
        """So near the boundary is on it, where only its side counts."""
        return 1e-9 * float(norms(self.box[1] - self.box[0]))

    @cached_property
    def discs(self):
        """The distance of the planar sweep of the discs."""
        return PlaneDistance(MovingPlane(of_canal(self.shape, Balls(self.shape.trajectory, self.shape.radius))))

    @cached_property
    def balls(self):
        """The balls at round ends and where discs turn at once: what is kept of them and of their spheres."""
        ends = [at for end, at in zip(self.ends, self.outer, strict=True) if end is BallEnd.ROUND]
        return ends + list(at_both(self.panels.series)[1][self.turning])

    def of_balls(self, points, tolerance):
        """IN, ON, OUT, or TOUCHED at a face, for points (n, 3): (n,) int8."""
        boxes = Boxes.of(self.low - tolerance, self.high + tolerance)
        if self.is_circles:
            labels, asked = np.full(len(points), OUT, dtype=np.int8), np.arange(len(points))
        else:
            labels = super().of_balls(points, tolerance)
            asked = np.flatnonzero(self.at_faces(points, tolerance)[0])
        for start in range(0, len(asked), CHUNK):
            some = asked[start : start + CHUNK]
            labels[some] = self.of_discs(points[some], boxes, tolerance)
        return labels

    def at_faces(self, points, tolerance):
        """Which points (n, 3) are in the ball of an end that is not round, behind its face, and which on that face."""
        behind, on = np.zeros((2, len(points)), dtype=bool)
        for end, at, side in zip(self.ends, self.outer, (-1.0, 1.0), strict=True):
            if end is BallEnd.ROUND:
                continue
            ahead = side * (dot(points, at[AXIS]) - at[ALONG])
            near = norms(points - at[PLACE]) <= at[RADIUS] + tolerance
            behind |= near & (ahead >= -tolerance)
            if end is BallEnd.FLAT:
                on |= near & (np.abs(ahead) <= tolerance)
        return behind, on

    def of_discs(self, points, boxes, tolerance):
        """The labels of so few points that all pairs with panels fit into memory."""
        point, depth = self.depths(points, boxes, tolerance)
        on = self.at_faces(points, tolerance)[1]
        if self.is_circles:
            on[point[np.abs(depth) <= tolerance]] = True
            return np.where(on, ON, OUT).astype(np.int8)
        least = np.full(len(points), np.inf)
        np.minimum.at(least, point, depth)
        told = np.where(least < -tolerance, IN, np.where(least <= tolerance, ON, OUT))
        return np.where(on, TOUCHED, told).astype(np.int8)

    def depths(self, points, boxes, tolerance):
        """How far points are from the balls in whose discs they are: of which point, and how far, two (k,)."""
        point, panel = boxes.pairs(boxes.cells(points))
        level = self.level(points[point], panel)
        monotone, x = simple(level)
        chosen = np.flatnonzero(monotone & (np.abs(x) <= 1))
        others = np.flatnonzero(~monotone)
        which, at = all_roots(level[others], 0.0)
        index = np.concatenate((chosen, others[which]))
        x = np.concatenate((x[chosen], at))
        found = [(point[index], self.far(points[point[index]], panel[index], x))]
        arrive = at_both(level)
        for side, end in zip((-1.0, 1.0), arrive, strict=True):
            near = np.flatnonzero(np.abs(end) <= tolerance)
            found.append((point[near], self.far(points[point[near]], panel[near], np.full(len(near), side))))
        turning = np.flatnonzero(self.turning[panel])
        leave = at_both(self.level(points[point[turning]], panel[turning] + 1))[0]
        turning = turning[arrive[1][turning] * leave <= 0]
        found.append((point[turning], self.far(points[point[turning]], panel[turning], np.ones(len(turning)))))
        for end, at, side in zip(self.ends, self.outer, (-1.0, 1.0), strict=True):
            if end is BallEnd.ROUND:
                ahead = np.flatnonzero(side * (dot(points, at[AXIS]) - at[ALONG]) >= -tolerance)
                found.append((ahead, norms(points[ahead] - at[PLACE]) - at[RADIUS]))
        return tuple(np.concatenate(part) for part in zip(*found, strict=True))

    def level(self, places, panel):
        """How far places (n, 3) are from the planes of the discs, as series in panels: (n, ORDER)."""
        series = self.panels.series[panel]
        return np.einsum("ni,nij->nj", places, series[:, AXIS]) - series[:, ALONG]

    def far(self, places, panel, x):
        """How far places (n, 3) are from the balls at places x of panels, negative within: (n,)."""
        at = self.panels.at(panel, x)
        return norms(places - at[:, PLACE]) - at[:, RADIUS]
