# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reach: how thick a round tube along a trajectory can be before it meets itself.

It is the smaller of the least radius of curvature and half the least distance between two points whose chord is across
the trajectory at both. Such pairs are looked for in a tree of arcs: most pairs of arcs are too far apart, or no chord
between them can be across both, and Newton's method meets few.
"""

from functools import lru_cache

import numpy as np

from ..declared.frozen import frozen, individual
from ..declared.parameters import ShapeError, require
from ..stations.cells import bend, cut
from ..stations.search import highest
from ..trajectories.arc_length import arc_length
from ..trajectories.curve import Trajectory
from ..vectors import dot, norms

COARSE = 64  # arcs at the root of the tree, at least
PEAKS = 32  # cells in which the highest is looked for
ITERATIONS, SETTLED = 16, 1e-12  # a step of so little of the domain is the last
FIRST = 64  # pairs whose distance is found first: it rules out most others
FLAT = 1e-6  # of the larger eigenvalue: along a family of pairs, as a helix has, there is nowhere to go
ACROSS = 1e-7  # cosine between a chord and a tangent: square to it
TOUCHING = 1e-9  # of the length: no distance


@frozen
class Reach:
    """The radius at which a round tube begins to meet itself.

    Attributes
    ----------
    radius : float
        In metres; infinite for a straight line.
    parameters : tuple of float
        Where: one parameter of the trajectory where it bends most, or two whose points come nearest; none if nowhere.
    """

    radius: float
    parameters: tuple = ()


def reach(trajectory):
    """The reach of a smooth trajectory.

    Parameters
    ----------
    trajectory : Trajectory
        Smooth. Of an open one the flat faces at the ends are not looked at.

    Returns
    -------
    Reach
        Its radius is in metres.

    Raises
    ------
    ShapeError
        Where the trajectory has a corner.

    Source
    ------
    Federer: Curvature measures, Trans. Amer. Math. Soc. 93, 1959, defines it; Litherland, Simon, Durumeric, Rawdon:
    Thickness of knots, Topology Appl. 91, 1999, Theorem 1, gives it for closed curves as the smaller of the two.

    Examples
    --------
    >>> from sweep_addon.core.trajectories import TorusKnot
    >>> round(reach(TorusKnot(2, 3, major=2.0, minor=0.8)).radius, 12)
    0.8
    """
    require(isinstance(trajectory, Trajectory), "must be a trajectory", trajectory, "trajectory")
    return known(trajectory)


@lru_cache(maxsize=32)
def known(trajectory):
    """The reach of what is a trajectory; the last are kept."""
    corners = trajectory.corners()
    if len(corners):
        raise ShapeError(f"must be smooth, or it has no reach, got a corner at u = {corners[0]:.6g}", "trajectory")
    bent = most_bent(trajectory)
    if trajectory.straight:
        return bent
    near = nearest(trajectory, 2 * bent.radius)
    return min(bent, near, key=lambda found: found.radius)


def most_bent(trajectory):
    """Where the trajectory bends most: its nodes, and of the highest of them what lies beside them."""
    nodes = arc_length(trajectory).nodes
    low, high = nodes[:-1], nodes[1:]
    ends = np.stack([norms(bend(trajectory, low)), norms(bend(trajectory, high, before=True))])
    if ends.max() * arc_length(trajectory).total < TOUCHING:
        return Reach(np.inf)
    cells = np.argsort(-ends.max(axis=0), kind="stable")[:PEAKS]
    u, most = highest(lambda u: norms(bend(trajectory, u)), low[cells], high[cells])
    top = np.argmax(most)
    side, node = np.unravel_index(np.argmax(ends), ends.shape)
    if ends[side, node] >= most[top]:
        return Reach(1 / float(ends[side, node]), (float((low, high)[side][node]),))
    return Reach(1 / float(most[top]), (float(u[top]),))


@individual
class Arcs:
    """A trajectory in arcs: what is known of all points of each from its middle."""

    u: np.ndarray  # of the middles: (n,)
    points: np.ndarray  # there: (n, 3)
    tangents: np.ndarray  # there: (n, 3)
    radius: np.ndarray  # no point of the arc is farther from its middle: (n,)
    cone: np.ndarray  # no tangent of the arc is farther from that in the middle, in radians: (n,)
    turned: np.ndarray  # from the trajectory's start to that of each arc, in radians: (n + 1,)


def tree(trajectory):
    """The arcs of a trajectory, from few long ones to many short ones, each of which is half of one before."""
    measure = arc_length(trajectory)
    u = cut(measure)
    widths = measure.measure(u[:-1], u[1:])
    curvature = norms(bend(trajectory, u))
    s, turned = (
        np.concatenate(([0.0], np.cumsum(part)))
        for part in (widths, np.maximum(curvature[1:], curvature[:-1]) * widths)
    )
    points, tangents, cells = trajectory.evaluate(u), trajectory.tangents(u), len(widths)
    for halvings in range(int(np.log2(cells / COARSE)), 0, -1):
        start = np.arange(0, cells, 2**halvings)
        end = np.append(start[1:], cells)
        middle = (start + end) // 2
        radius, cone = (np.maximum(x[middle] - x[start], x[end] - x[middle]) for x in (s, turned))
        yield Arcs(u[middle], points[middle], tangents[middle], radius, cone, turned[np.append(start, cells)])


def possible(arcs, i, j, closed, farthest):
    """Which pairs of arcs may hold two points no farther apart than that whose chord is across both: (k,) bool."""
    chord = arcs.points[j] - arcs.points[i]
    distance, spread = norms(chord), arcs.radius[i] + arcs.radius[j]
    between = arcs.turned[j + 1] - arcs.turned[i]  # an arc that turns by less than a right angle has no such chord
    around = arcs.turned[-1] - (arcs.turned[j] - arcs.turned[i + 1]) if closed else between
    kept = (distance - spread < farthest) & (np.minimum(between, around) >= np.pi / 2)
    direction, lean = chord / np.where(distance > 0, distance, 1.0)[:, None], np.full(len(i), np.pi)
    apart = distance > spread
    lean[apart] = np.arcsin(spread[apart] / distance[apart])
    for end in (i, j):
        angle = np.abs(np.arcsin(np.clip(dot(direction, arcs.tangents[end]), -1, 1)))
        kept &= angle <= arcs.cone[end] + lean
    return kept


def nearest(trajectory, farthest):
    """The nearest two points whose chord is across the trajectory at both, if they are no farther apart than that."""
    i = j = None
    for arcs in tree(trajectory):
        if i is None:
            i, j = np.triu_indices(len(arcs.u))
        else:
            i, j = (2 * i + [[0], [0], [1], [1]]).ravel(), (2 * j + [[0], [1], [0], [1]]).ravel()
        known = (i <= j) & (j < len(arcs.u))
        i, j = i[known], j[known]
        kept = possible(arcs, i, j, trajectory.closed, farthest)
        i, j = i[kept], j[kept]
    distance = least_distance(arcs, i, j)
    order, best = np.argsort(distance, kind="stable"), Reach(np.inf)
    for some in (order[:FIRST], order[FIRST:]):
        some = some[distance[some] < min(farthest, 2 * best.radius)]
        if len(some):
            found = critical(trajectory, arcs.u[i[some]], arcs.u[j[some]], np.abs(np.diff(arcs.u)).max(), farthest / 2)
            best = min(best, found, key=lambda found: found.radius)
    return best


def least_distance(arcs, i, j):
    """What points of pairs of arcs are never nearer to each other than: (k,).

    An arc is nowhere farther from the tangent in its middle than its cone times its radius, and along that tangent
    it comes nearer by no more than what of it lies along the chord.
    """
    chord = arcs.points[j] - arcs.points[i]
    distance = norms(chord)
    direction = chord / np.where(distance > 0, distance, 1.0)[:, None]
    return distance - sum(
        arcs.radius[end] * np.minimum(np.abs(dot(direction, arcs.tangents[end])) + arcs.cone[end], 1.0)
        for end in (i, j)
    )


def critical(trajectory, x, y, longest, least):
    """The nearest pair that Newton's method finds from pairs of parameters, on half the square of the distance.

    No step is longer than that along either axis of the square, and no pair is valid whose way along the trajectory is
    less than the least radius of curvature: it turns by no right angle.
    """
    measure, (first, last) = arc_length(trajectory), trajectory.domain

    def inside(u):
        return first + (u - first) % (last - first) if trajectory.closed else np.clip(u, first, last)

    todo = np.arange(len(x))
    for _ in range(ITERATIONS):
        before = np.stack((x[todo], y[todo]))
        step = newton(trajectory, *before, longest)
        after = inside(before + step)
        x[todo], y[todo] = after
        moved = step if trajectory.closed else after - before
        todo = todo[np.abs(moved).max(axis=0) > SETTLED * (last - first)]
        if not len(todo):
            break
    chord = trajectory.evaluate(x) - trajectory.evaluate(y)
    distance = norms(chord)
    leaning = np.maximum(*(np.abs(dot(chord, trajectory.tangents(end))) for end in (x, y)))
    apart = np.abs(measure.at(x) - measure.at(y))
    apart = np.minimum(apart, measure.total - apart) if trajectory.closed else apart
    touching = distance <= TOUCHING * measure.total
    valid = ((leaning <= ACROSS * distance) | touching) & (apart > least)
    if not valid.any():
        return Reach(np.inf)
    pair = np.flatnonzero(valid)[np.argmin(distance[valid])]
    radius = 0.0 if touching[pair] else float(distance[pair]) / 2
    return Reach(radius, tuple(sorted((float(x[pair]), float(y[pair])))))


def newton(trajectory, x, y, longest):
    """The steps (2, n) of Newton's method towards pairs whose chord is across both tangents."""
    points, first, second = (
        values.reshape(2, -1, 3)
        for both in (np.concatenate((x, y)),)
        for values in (trajectory.evaluate(both), trajectory.derivative(both), trajectory.derivative(both, 2))
    )
    chord = points[0] - points[1]
    slope = dot(chord, first)
    own = dot(first, first) + dot(chord, second) * ((1,), (-1,))
    return -solved(own[0], -dot(*first), own[1], slope * ((1,), (-1,)), longest)


def solved(a, b, c, right, longest):
    """The least solutions of symmetric systems [[a, b], [b, c]], flat directions left alone: (2, n).

    Along either of its axes no solution is longer than that. Beside a family of pairs one axis is nearly flat, and
    Newton's method would go far along it; along the other it is right at once.
    """
    middle, radius = (a + c) / 2, np.hypot((a - c) / 2, b)
    angle = np.arctan2(b, (a - c) / 2) / 2
    axes = np.stack(((np.cos(angle), np.sin(angle)), (-np.sin(angle), np.cos(angle))))  # (2, 2, n)
    values = np.stack((middle + radius, middle - radius))
    flat = np.abs(values) < FLAT * np.abs(values).max(axis=0)
    along = (axes * right).sum(axis=1) / np.where(flat, np.inf, values)
    return (axes * along.clip(-longest, longest)[:, None]).sum(axis=0)
