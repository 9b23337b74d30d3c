# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directions: the vector d that a trajectory carries beside its position, and the frame that both make.

The tangent e1 and d span the direction plane. In it, across e1 and on the side of d, lies e2; e3 is across both.
"""

from enum import Enum
from functools import lru_cache
from math import pi

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import Array, ShapeError, declared, parameter, points, require
from ..later import later
from ..trajectories.chain import corner_cutting
from ..variation.laws import hermite, monotone_slopes
from ..vectors import dot, norms, unit
from .cubics import Basis
from .frames import OfItsPlace, RotationMinimizing
from .sampling import distinct

fill = later("core.stations.continuing", "fill")
signed_angle = later("core.stations.rotations", "signed_angle")
highest = later("core.stations.search", "highest")
arc_length, subdivided = later("core.trajectories.arc_length", "arc_length", "subdivided")

__all__ = ["Arrows", "Basis", "Cubic", "Direction", "Guide", "Parallel", "Tilt"]

PARALLEL = 1e-6  # the sine of the angle between d and the tangent: single precision cannot tell a smaller one from none
CELLS = 2048  # at least, in which it is looked for
NEAR = 0.5  # a sine that is larger than this at a node is not 0 beside it
CLOSES = 1e-6  # radians, within which a direction round a closed trajectory has come back


class Parallel(Enum):
    CONTINUE = "The frame goes on through it as if the direction pointed to the other side from there on"
    REFUSE = "A direction that anywhere runs along the trajectory is refused"


ALONG = "What to do where the direction runs along the trajectory"
parallel = parameter(Parallel.CONTINUE, ALONG)


@individual
class Meetings:
    """Where a direction runs along the trajectory."""

    u: np.ndarray  # all places: (k,)
    flips: np.ndarray  # those from which on it points to the other side: (j,)


class Pointing(OfItsPlace):
    """A direction given as a vector at every place. A kind gives `vectors` and `parallel`."""

    def across(self, trajectory, u, before=False):
        """The part of the unit vector of d across the tangent, at parameters u: (n, 3)."""
        along, tangents = unit(self.vectors(trajectory, u)), trajectory.tangents(u, before)
        return along - dot(along, tangents)[:, None] * tangents

    def angles(self, stations, normals, holonomy, symmetry):
        """The angle of e2 from the rotation-minimizing normals, (n,), and what a person should be told."""
        trajectory = stations.trajectory
        met = meetings(self, trajectory)
        across = self.across(trajectory, stations.u)
        found = signed_angle(normals, across, stations.leave)
        if trajectory.closed:
            self.require_back(trajectory, len(met.flips))
        if not len(met.u):
            return found, ()
        place = f"u = {met.u[0]:.6g}"
        if self.parallel is Parallel.REFUSE:
            sentence = "must be continue where the direction runs along the trajectory or is 0"
            raise ShapeError(f"{sentence}, got refuse at {place}", "parallel")
        defined = norms(across) > PARALLEL
        if not defined.any():
            raise ShapeError("must not run along the whole trajectory, got one that says no side anywhere")
        found += pi * np.searchsorted(met.flips, stations.u, side="right")
        told = f"Direction: at {place} it runs along the trajectory or is 0, and says no side; the frame goes on."
        return fill(stations, found, defined, holonomy), (told,)

    def require_back(self, trajectory, flips):
        """Refuse a direction that does not come back to the side where it began on a closed trajectory."""
        first, last = np.array(trajectory.domain)[:, None]
        start, end = unit(self.across(trajectory, first)), unit(self.across(trajectory, last, before=True))
        turn = abs(float(signed_angle(start, end * (-1) ** flips, trajectory.tangents(first))[0]))
        if turn > CLOSES:
            sentence = "must come back to where it began on a closed trajectory"
            raise ShapeError(f"{sentence}, got it turned by {np.degrees(turn):.4g} degrees")


@declared
class Cubic(Pointing):
    """The direction part d(t) of a PD curve: a parametric cubic

    t is the trajectory's own parameter: as the trajectory goes from its start to its end, so does d. Where both have as
    many segments, as those of `pd_curve` have, each segment of one belongs to one of the other.

    >>> from sweep_addon.core.trajectories import Line
    >>> quarter = Cubic([(1, 0, 0), (1, 0, 0), (0, 1, 0), (0, 1, 0)])
    >>> quarter.vectors(Line(), np.array([0.0, 0.5, 1.0])).tolist()
    [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.0, 1.0, 0.0]]
    """

    values: Array = parameter(((1, 0, 0), (1, 0, 0), (0, 0, 1), (0, 0, 1)), "Control vectors", columns=3, most=200_000)
    basis: Basis = parameter(Basis.BEZIER, "What the control vectors are")
    parallel: Parallel = parallel

    def check(self):
        """Refuse a number of vectors that makes no segments."""
        self.basis.require_segments(len(self.values), "values")

    def vectors(self, trajectory, u):
        """The vectors d at parameters of a trajectory: (n,) to (n, 3)."""
        return chained(self.basis.segments(self.values.values), trajectory, u)


@declared
class Guide(Pointing):
    """Towards the point of a second curve that has the same parameter

    >>> from sweep_addon.core.trajectories import Line
    >>> Guide([(1, 0, 0), (1, 0, 0), (1, 0, 1), (1, 0, 1)]).vectors(Line(), np.array([0.0, 0.5])).tolist()
    [[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
    """

    points: Array = points(((1, 0, 0), (1, 0, 0.5), (0, 0.5, 2), (0, 1, 2)), "Control points of the second curve")
    basis: Basis = parameter(Basis.BEZIER, "What the control points are")
    parallel: Parallel = parameter(Parallel.CONTINUE, ALONG, splines=("POLY", "BEZIER", "NURBS"))

    def check(self):
        """Refuse a number of points that makes no segments."""
        self.basis.require_segments(len(self.points), "points")

    def vectors(self, trajectory, u):
        """The vectors d at parameters of a trajectory: (n,) to (n, 3)."""
        return chained(self.basis.segments(self.points.values), trajectory, u) - trajectory.evaluate(u)


@declared
class Arrows(Pointing):
    """Arrows along the trajectory, each a direction at a part of its length, smoothly from one to the next

    >>> from sweep_addon.core.trajectories import Line
    >>> Arrows([(0, 1, 0, 0), (1, 0, 1, 0)]).vectors(Line(), np.array([0.5])).tolist()
    [[0.5, 0.5, 0.0]]
    """

    rows: Array = parameter(((0, 1, 0, 0),), "Part of the length from 0 to 1, and a vector", columns=4, most=200_000)
    parallel: Parallel = parallel

    def check(self):
        """Refuse no arrows, arrows in one place or out of their order, and arrows without length."""
        require(len(self.rows) > 0, "must have at least 1 row", 0, "rows")
        t, vectors = self.rows.values[:, 0], self.rows.values[:, 1:]
        rising = (np.diff(t) > 0).all() and t[0] >= 0 and t[-1] <= 1
        require(rising, "must have parts rising from row to row, from 0 to 1", t.tolist(), "rows")
        short = norms(vectors) == 0
        require(not short.any(), "must have vectors with a length", f"0 in row {np.argmax(short) + 1}", "rows")

    @classmethod
    def at_points(cls, trajectory, points, vectors):
        """Arrows that stand where a trajectory comes nearest to points, (n, 3), with these vectors, (n, 3)."""
        u = np.linspace(*trajectory.domain, CELLS + 1)
        apart = norms(trajectory.evaluate(u) - points[:, None])
        node = apart.argmin(axis=1)
        ends = u[np.maximum(node - 1, 0)], u[np.minimum(node + 1, CELLS)]
        found, _ = highest(lambda u: -norms(trajectory.evaluate(u) - np.resize(points, (len(u), 3))), *ends)
        measure = arc_length(trajectory)
        t = np.clip(measure.at(found) / measure.total, 0.0, 1.0)
        order = np.argsort(t, kind="stable")
        return cls(np.column_stack((t, vectors))[order])

    def vectors(self, trajectory, u):
        """The vectors d at parameters of a trajectory: (n,) to (n, 3)."""
        parts, vectors = self.rows.values[:, 0], unit(self.rows.values[:, 1:])
        if len(parts) == 1:
            return np.tile(vectors, (len(u), 1))
        measure = arc_length(trajectory)
        t = np.clip(measure.at(u) / measure.total, parts[0], parts[-1])
        return np.stack([hermite(parts, row, monotone_slopes(parts, row), t) for row in vectors.T], axis=1)


@declared
class Tilt(OfItsPlace):
    """As the trajectory's own tilt turns it, from the normal that turns least

    >>> from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
    >>> from sweep_addon.core.trajectories import Polyline
    >>> turning = Polyline([(0, 0, 0), (0, 0, 1)], tilts=[0, 1])
    >>> frames = PDCurveSweep(trajectory=turning, direction=Tilt()).frames()
    >>> round(float(frames.e2[0] @ frames.e2[-1]), 12) == round(float(np.cos(1)), 12)
    True
    """

    def angles(self, stations, normals, holonomy, symmetry):
        """The angle of e2 from the rotation-minimizing normals, (n,), and nothing to be told."""
        least, told = RotationMinimizing().angles(stations, normals, holonomy, symmetry)
        return least + stations.trajectory.carried(stations.u)[1], told


Direction = Cubic | Guide | Arrows | Tilt


def __dir__():
    return __all__  # what a console offers


def chained(segments, trajectory, u):
    """A chain of segments that goes from its start to its end as a trajectory does: (n, 3)."""
    first, last = trajectory.domain
    return corner_cutting((np.asarray(u) - first) / (last - first) * len(segments), segments)


@lru_cache(maxsize=16)
def meetings(direction, trajectory):
    """Where a direction runs along a trajectory, found between nodes and then as exactly as rounding lets it be.

    Parameters
    ----------
    direction : Cubic, Guide or Arrows
    trajectory : Trajectory

    Returns
    -------
    Meetings
    """
    nodes = arc_length(trajectory).nodes
    u = subdivided(nodes, -(-CELLS // (len(nodes) - 1)))

    def nearness(u):
        return -norms(direction.across(trajectory, u))

    near, last = nearness(u), len(u) - 1
    here = np.arange(len(u))
    low, high = np.maximum(here - 1, 0), np.minimum(here + 1, last)
    peak = np.flatnonzero((near >= near[low]) & (near >= near[high]) & (near > -NEAR))
    place, found = highest(nearness, u[low[peak]], u[high[peak]])
    place = np.where(near[peak] >= found, u[peak], place)
    place = place[np.maximum(near[peak], found) >= -PARALLEL]
    place = distinct(place, np.diff(u).min() / 2) if len(place) else place
    defined = np.flatnonzero(near < -PARALLEL)
    if not len(place) or not len(defined):
        return Meetings(place, place[:0])
    sides = direction.across(trajectory, u[defined])
    turned = np.flatnonzero(dot(sides[1:], sides[:-1]) < 0)
    after = np.searchsorted(place, u[defined[turned]], side="left").clip(0, len(place) - 1)
    between = (place[after] >= u[defined[turned]]) & (place[after] <= u[defined[turned + 1]])
    return Meetings(place, place[after[between]])
