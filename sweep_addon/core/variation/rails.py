# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rails: curves beside a trajectory that guide the contour. One turns it, two also say how wide it is and where.

Of a rail counts the point where it meets the plane of the contour, of several the one nearest to the trajectory. That
depends on the plane alone: round a closed trajectory rails lead to where they began, whether they are closed or not.
"""

from functools import lru_cache

import numpy as np

from ..declared.frozen import frozen
from ..declared.parameters import ShapeError
from ..declared.wording import near
from ..later import later
from ..stations.continuing import flipping
from ..stations.frames import OfItsPlace
from ..vectors import dot, norms, unit
from .rail import Guided

signed_angle, turned = later("core.stations.rotations", "signed_angle", "turned")
roots = later("core.self_intersection.folds", "roots")
arc_length, subdivided = later("core.trajectories.arc_length", "arc_length", "subdivided")

CELLS = 128  # at least, of a rail, in each of which it meets a plane once
AT_HAND = 2**17  # distances of nodes from planes that are found at once
NOTHING = 1e-7  # of the trajectory's length: a rail that is no farther off points nowhere
NUDGE = 1e-4  # of the trajectory's domain
MISSED = 1e-3  # of the trajectory's length: a plane that a rail misses by more is told
TOUCHING, LEAST = 1e-6, 1e-30  # of the rail's coordinates, and in metres
LEVEL = 1e-9  # of the contour's size: points of one side
TOGETHER = 2**20  # points of changing contours that are looked at together


@frozen
class Rails(OfItsPlace):
    """How rails guide a contour: a frame whose x axis points at the first of them, or from the second to the first.

    Parameters
    ----------
    paths : tuple of one or two Trajectory
    guided : Guided
    section : Section
    change : Changing or None
        How the section changes.
    """

    paths: tuple
    guided: Guided
    section: object
    change: object = None

    def seen(self, trajectory, u):
        """From the trajectory to the rails in the planes of the contours, (r, n, 3), and how far off these are, (r, n).

        At a corner the plane is the bisector; what the mitre will stretch there is taken back.
        """
        before, after = legs(trajectory, u)
        half = (norms(before + after) / 2)[:, None]
        normals, aside, points = (before + after) / (2 * half), unit(after - before), trajectory.evaluate(u)
        found, missed = zip(*(meeting(path, points, normals) for path in self.paths), strict=True)
        away = np.stack(found) - points
        away -= dot(away, normals)[..., None] * normals
        return away - (1 - half) * dot(away, aside)[..., None] * aside, np.stack(missed)

    def pointing(self, trajectory, u, away):
        """Where the contour's x axis would point if its sides were level: unit vectors, (n, 3).

        Where the rails meet, or one meets the trajectory, they point as they do a little way on.
        """
        total, (first, last) = arc_length(trajectory).total, trajectory.domain
        towards = away[0] - away[1] if len(away) > 1 else away[0]
        lost = norms(towards) <= NOTHING * total
        if lost.any():
            on = u[lost] + NUDGE * (last - first) * np.where(u[lost] < (first + last) / 2, 1.0, -1.0)
            beside, _ = self.seen(trajectory, on)
            normals = plane(trajectory, u[lost])
            towards[lost] = beside[0] - beside[1] if len(beside) > 1 else beside[0]
            towards[lost] -= dot(towards[lost], normals)[:, None] * normals
            if not towards[lost].any(axis=1).all():
                raise ShapeError(
                    "must not lie on the trajectory or on one another, got a stretch where they do", "rails"
                )
        return unit(towards)

    def angles(self, stations, normals, holonomy, symmetry):
        """The angle of e2 from the rotation-minimizing normals, (n,), and what a person should be told."""
        trajectory, corners = stations.trajectory, stations.corners
        away, missed = self.seen(trajectory, stations.u)
        towards = self.pointing(trajectory, stations.u, away)
        towards[corners] = turned(towards[corners], stations.tangent[corners], stations.leave[corners])
        angles = signed_angle(normals, towards, stations.leave)
        if len(away) > 1:
            angles -= self.lean(norms(away[0] - away[1]), stations.t)
        return angles, self.told(stations, flipping(angles, stations, holonomy), missed)

    def told(self, stations, flips, missed):
        """Sentences about planes that a rail does not meet, and about rails that change their sides."""
        domain, said = stations.trajectory.domain, []
        for number, lacks in enumerate(missed > MISSED * stations.total, 1):
            if lacks.any():
                place = near(stations.u[np.argmax(lacks)], *domain)
                said.append(f"Rails: rail {number} misses the plane at u = {place}, and what is nearest to it counts.")
        if flips.any():
            place = near(stations.u[np.argmax(flips)], *domain)
            said.append(f"Rails: near u = {place} they turn the contour by more than a quarter turn at once.")
        return tuple(said)

    def lean(self, width, t):
        """By which angle the contour's right side is higher than its left, between rails so far apart: (n,)."""
        (dx, dy), scale = self.breadth(t), self.scales(width, t)
        return np.arctan2(dy * scale[1], dx * scale[0])

    def breadth(self, t):
        """From the contour's left side to its right: x and y, two (n,)."""
        right, left = self.sides(t)
        return (right - left).T

    def sides(self, t):
        """The points of the contour that are farthest right and left, of a straight side its middle: two (n, 2)."""
        if self.change is None:
            return iter([np.tile(side, (len(t), 1)) for side in sides(self.section.points[None])])
        block = max(TOGETHER // len(self.section.points), 1)
        parts = [sides(self.change.at(t[start : start + block])) for start in range(0, len(t), block)]
        return (np.concatenate(part) for part in zip(*parts, strict=True))

    def scales(self, width, t):
        """The scales along x and y of contours between rails so far apart: two (n,)."""
        dx, dy = self.breadth(t)
        if self.guided is Guided.EVENLY:
            scale = width / np.hypot(dx, dy)
            return scale, scale
        if (width <= NOTHING * width.max()).any():
            raise ShapeError("must be evenly where the rails meet, got in-width", "guided")
        steep = width < np.abs(dy)
        if steep.any():
            got = f"{width[steep][0]:.4g} m at t = {t[steep][0]:.4g}"
            raise ShapeError(f"must be as far apart as the contour's sides differ in height, got {got}", "rails")
        return np.sqrt(width**2 - dy**2) / dx, np.ones_like(width)

    def laws(self, trajectory, u, t):
        """The scales and offsets of the contour that the rails ask for: four (n,), or None of one rail."""
        if len(self.paths) == 1:
            return None
        away, _ = self.seen(trajectory, u)
        width = norms(away[0] - away[1])
        scales, lean = self.scales(width, t), self.lean(width, t)
        x = self.pointing(trajectory, u, away)
        y = np.cross(plane(trajectory, u), x)
        along, across = dot(away[0], x), dot(away[0], y)
        (right_x, right_y), cosine, sine = next(self.sides(t)).T, np.cos(lean), np.sin(lean)
        offset_x = cosine * along - sine * across - scales[0] * right_x
        offset_y = sine * along + cosine * across - scales[1] * right_y
        return *scales, offset_x, offset_y


def plane(trajectory, u):
    """Unit normals of the planes of contours, at a corner the bisector: (n, 3)."""
    before, after = legs(trajectory, u)
    return unit(before + after)


def legs(trajectory, u):
    """The unit tangents before and after places, round a closed trajectory of its end and its start: two (n, 3)."""
    first, last = trajectory.domain
    start, end = (u <= first, u >= last)
    if not trajectory.closed:
        before, after = trajectory.tangents(u, before=True), trajectory.tangents(u)
        before[start], after[end] = after[start], before[end]
        return before, after
    return trajectory.tangents(np.where(start, last, u), before=True), trajectory.tangents(np.where(end, first, u))


def sides(points):
    """The rightmost and the leftmost of points (n, m, 2), the middle of those that are: two (n, 2)."""
    x, y = points[..., 0], points[..., 1]
    level, found = LEVEL * np.ptp(x, axis=1, keepdims=True), []
    for side in (1, -1):
        most = side * x >= (side * x).max(axis=1, keepdims=True) - level
        low, high = np.where(most, y, np.inf).min(axis=1), np.where(most, y, -np.inf).max(axis=1)
        found.append(np.stack((side * (side * x).max(axis=1), (low + high) / 2), axis=1))
    return found


@lru_cache(maxsize=16)
def nodes_of(path):
    """Parameters of a rail, close together, and its points there: (k,) and (k, 3)."""
    nodes = arc_length(path).nodes
    u = subdivided(nodes, -(-CELLS // (len(nodes) - 1)))
    return u, path.evaluate(u)


def meeting(path, points, normals):
    """Where a rail meets planes.

    Parameters
    ----------
    path : Trajectory
        The rail.
    points, normals : (n, 3) float array
        Of the planes.

    Returns
    -------
    (n, 3) float array
        Of the points where the rail meets a plane the nearest to the plane's own; of a rail that does not meet it the
        node that is nearest to it.
    (n,) float array
        How far that is from the plane.

    Examples
    --------
    >>> from sweep_addon.core.trajectories import Line
    >>> places, missed = meeting(Line((2, 0, 0), (2, 0, 4)), np.array([[0.0, 0, 1], [0, 0, 5]]), np.eye(3)[[2, 2]])
    >>> places.tolist(), missed.tolist()
    ([[2.0, 0.0, 1.0], [2.0, 0.0, 4.0]], [0.0, 1.0])
    """
    u, along = nodes_of(path)
    found, missed = np.empty_like(points), np.empty(len(points))
    block = max(AT_HAND // len(u), 1)
    for start in range(0, len(points), block):
        some = slice(start, start + block)
        found[some], missed[some] = met(path, u, along, points[some], normals[some])
    return found, missed


def met(path, u, along, points, normals):
    """The same for so few planes that the heights of all nodes over all of them are at hand."""
    heights = along @ normals.T - dot(points, normals)
    for end, beside in ((0, 1), (-1, -2)):  # a rail that ends on a plane meets it there, whatever rounding says
        touching = np.abs(heights[end]) <= TOUCHING * np.abs(along).max()
        heights[end, touching] = -np.copysign(LEAST, heights[beside, touching])
    heights[heights == 0] = -LEAST
    above = heights > 0
    cell, plane = np.nonzero(above[1:] != above[:-1])
    low, high = heights[cell, plane], heights[cell + 1, plane]
    share = (low / (low - high))[:, None]
    apart = norms(along[cell] + share * (along[cell + 1] - along[cell]) - points[plane])
    order = np.lexsort((apart, plane))
    plane, first = np.unique(plane[order], return_index=True)
    cell, low, high = (part[order[first]] for part in (cell, low, high))

    def height(v):
        return dot(path.evaluate(v) - points[plane], normals[plane])

    found, missed = np.empty_like(points), np.zeros(len(points))
    found[plane] = path.evaluate(roots(height, u[cell], u[cell + 1], low, high))
    lost = np.setdiff1d(np.arange(len(points)), plane)
    off = np.abs(heights[:, lost])
    node = (off + TOUCHING * norms(along[:, None] - points[lost])).argmin(axis=0)  # of those as near to the plane
    found[lost], missed[lost] = along[node], off[node, np.arange(len(lost))]
    return found, missed
