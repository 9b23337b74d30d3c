# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Folds, the local test: where the generator turns faster than it moves, so that a part of it runs backward.

A point p of a generator across the trajectory, seen from there, moves forward by 1 - k . p for each metre, where k is
the curvature vector: neither twist nor scale nor the frame's spin has a part in it. The sweep folds where that is
negative at one point of the contour and positive at another: where its support towards the centre of curvature reaches
that centre. A generator that keeps its orientation moves forward by the tangent's part along the
normal of its plane.
"""

import numpy as np

from ..declared.options import PREFIX
from ..declared.wording import near
from ..stations.search import highest
from ..vectors import dot, norms

PEAKS = 16
TOLD = 3  # sentences of one kind
ROUNDING = 1e-12  # of the trajectory's length
AROUND = np.array([(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)])
NARROWINGS = 8  # 6e-6 of each interval is left, and a peak is flat
STEPS = 43  # of which the last do not halve: rounding may keep a place from ever being near enough
SMALL = 1e-13  # of the largest of the nearer ends


def intervals(folding, grid):
    """Where a function is not negative.

    Parameters
    ----------
    folding : callable
        From rising places (n,) to values (n,).
    grid : (n,) float array
        Rising places, the first and the last that count among them, close enough to see every peak.

    Returns
    -------
    (k, 2) float array
        Where each interval starts and ends, to rounding.

    Examples
    --------
    >>> intervals(np.sin, np.linspace(0.1, 6.0, 9)).round(9).tolist()
    [[0.1, 3.141592654]]
    """
    values = folding(grid)
    grid, values = with_peaks(folding, grid, values)
    folded = values >= 0
    change = np.flatnonzero(folded[1:] != folded[:-1])
    rising = folded[change + 1]
    edge = roots(folding, grid[change], grid[change + 1], values[change], values[change + 1])
    start, end = grid[:1][folded[:1]], grid[-1:][folded[-1:]]
    return np.stack((np.concatenate((start, edge[rising])), np.concatenate((edge[~rising], end))), axis=1)


def roots(function, low, high, at_low, at_high):
    """Where a function changes its sign between pairs of places, (n,).

    False position with the factor of Anderson and Björck (BIT 13, 1973): an end that stays counts less, by what the
    last step has gained, so that both ends close in. Each fourth step halves what is left if the others have not. Who
    has arrived stays: that step would lead away from a place where the function is 0.

    >>> at_ends = np.array([-1.0, -1.0]), np.array([1.0, 1.0])
    >>> jump = 1 / 3
    >>> roots(lambda x: np.array([x[0], np.copysign(1.0, x[1] - jump)]), *at_ends, *at_ends).round(9).tolist()
    [0.0, 0.333333333]
    """
    width, there = 1e-11 * (high - low), np.zeros(len(low), dtype=bool)
    small = SMALL * np.minimum(np.abs(at_low), np.abs(at_high)).max(initial=0.0)
    for step in range(STEPS if len(low) else 0):
        span = at_high - at_low
        middle = high - at_high * (high - low) / np.where(span, span, 1.0)  # none where both ends have met at the place
        if step % 4 == 3:
            middle = (low + high) / 2
        middle = np.where(there, high, middle)
        found = function(middle)
        none = np.abs(found) <= small
        if none.all():
            return middle
        kept = (found >= 0) == (at_high >= 0)  # the same end moves again
        less = 1 - found / np.where(at_high, at_high, 1.0)
        less = np.where(less > 0, less, 0.5)
        low, at_low = np.where(kept, low, high), np.where(kept, at_low * less, at_high)
        high, at_high = middle, found
        there = none | (np.abs(high - low) <= width)
        if there.all():
            break
    return high


def with_peaks(folding, grid, values):
    """The grid and the values there, with those of peaks between its places that reach 0 where it does not."""
    before, here, after = values[:-2], values[1:-1], values[2:]
    rise = here - np.minimum(before, after)  # eight times what a parabola may rise between places above the highest
    inner = 1 + np.flatnonzero((here >= before) & (here >= after) & (here < 0) & (here + rise >= 0))
    inner = np.sort(inner[np.argsort(-values[inner], kind="stable")[:PEAKS]])
    if not len(inner):
        return grid, values
    place, value = highest(in_order(folding), grid[inner - 1], grid[inner + 1], NARROWINGS)
    reached = value >= 0
    grid, values = np.append(grid, place[reached]), np.append(values, value[reached])
    order = np.argsort(grid, kind="stable")
    return grid[order], values[order]


def in_order(folding):
    """The same function, of places in any order."""

    def asked(places):
        order = np.argsort(places, kind="stable")
        values = np.empty(len(places))
        values[order] = folding(places[order])
        return values

    return asked


def folding(bend, aside, x, y, support):
    """How far the contours fold: not negative where one has points that run forward and points that run backward.

    Parameters
    ----------
    bend : (n, 3) float array
        Curvature vectors in 1/m.
    aside : (n, 3) float array
        From the trajectory to the reference point.
    x, y : (n, 3) or (n, k, 3) float array
        The contour's axes, scaled, or those of the contours that it is a sum of.
    support : callable
        From directions (n, 2) or (n, k, 2) in the contour's plane to how far it reaches that way, in metres, (n,).

    Examples
    --------
    A circle of radius 2 on a circle of radius 1:

    >>> x, y = np.eye(3)[:1], np.eye(3)[1:2]
    >>> folding(x, 0 * x, x, y, lambda direction: 2 * np.hypot(*direction.T)).tolist()
    [1.0]
    """
    middle, towards = dot(bend, aside), seen(bend, x, y)
    return np.minimum(middle + support(towards) - 1, 1 - middle + support(-towards))


def safe_factor(bend, aside, x, y, support):
    """By what factor each contour may be scaled before it folds: (n,), infinite where nothing bends."""
    room, towards = 1 - dot(bend, aside), seen(bend, x, y)
    towards[room < 0] *= -1  # a reference point beyond the centre comes nearer from there
    reached = support(towards)
    return np.divide(np.abs(room), reached, out=np.full(len(room), np.inf), where=reached > 0)


def seen(bend, x, y):
    """Curvature vectors (n, 3) along axes: (n, 2), or (n, k, 2) where there are more of them, (n, k, 3)."""
    return np.stack([np.einsum("ni,n...i->n...", bend, axis) for axis in (x, y)], axis=-1)


def folds_told(stations, aside, x, y, support, longest=None):
    """What is told of folds with every change: sentences, of what the stations show.

    Parameters
    ----------
    stations : Stations
    aside, x, y : (n, 3) or (n, k, 3) float array
        As `folding` takes them; all of them across the tangents.
    support : callable
    longest : float, optional
        How long the axes are at most, where that is known.

    Returns
    -------
    tuple of str
    """
    bend = stations.bend
    if len(stations.corners):
        bend = bend.copy()
        bend[stations.corners] = 0.0  # a corner's bend is no curvature: its mitre is another matter
    longest = longest or max(summed(norms(axis)).max() for axis in (x, y))
    farthest = support(AROUND).max() * np.sqrt(2) * longest + (norms(aside).max() if aside.any() else 0.0)
    if stations.trajectory.axis and norms(bend[:1]) * farthest < 1:
        return ()  # it bends the same everywhere
    bent = np.flatnonzero(norms(bend) * farthest >= 1)
    if not len(bent):
        return ()
    bent = np.unique(np.concatenate((bent, bent - 1, bent + 1)).clip(0, len(bend) - 1))
    values = np.full(len(bend), -1.0)
    values[bent] = folding(*(part[bent] for part in (bend, aside, x, y)), support)
    behind = dot(bend, aside) > 1
    passed = np.flatnonzero(behind[1:] != behind[:-1])  # the centre, from one station to the next
    values[passed] = np.maximum(values[passed], 0.0)
    return stretches_told(stations, values, sentence)


def summed(values):
    """Values (n,) as they are, or the sums of those of each row, (n, k)."""
    return values.sum(axis=1) if values.ndim > 1 else values


def stretches_told(stations, values, sentence):
    """What is told of the stretches where values at stations, (n,), are not negative: sentences."""
    folded = np.flatnonzero(values >= 0)
    runs = np.split(folded, np.flatnonzero(np.diff(folded) > 1) + 1) if len(folded) else ()
    u = stations.u
    ends = ((edge(u, values, run[0], -1), edge(u, values, run[-1], 1)) for run in runs)
    shown = [sentence(a, b, stations.trajectory.domain) for a, b in ends]
    if len(shown) > TOLD:
        shown[TOLD:] = [f"{len(shown) - TOLD} more such places."]
    return tuple(PREFIX + said for said in shown)


def edge(u, values, last, step):
    """Where a function that is not negative at one station reaches 0 on the way to the next, were it straight."""
    beside = np.clip(last + step, 0, len(u) - 1)
    share = values[last] / (values[last] - values[beside]) if beside != last else 0.0
    return u[last] + share * (u[beside] - u[last])


def sentence(a, b, domain):
    """What is said of a fold between two parameters of a domain."""
    return f"from {between(a, b, domain)} the contour reaches the centre of curvature, and the sweep folds."


def between(a, b, domain):
    """Two parameters of a domain for people."""
    return f"u = {near(a, *domain)} to {near(b, *domain)}"


def running_backward(stations, rings, centroid, moved):
    """Whether the middles of all contours, beyond the centres of curvature, run backward.

    The surface is then that of a sweep the other way; where some do and others do not, it folds.
    """
    longest = max(rings[1:].max(), -rings[1:].min())
    if not moved and np.linalg.norm(centroid) * longest <= ROUNDING * stations.total:
        return False
    x, y = np.reshape(centroid, (2, -1, 1))  # one, or one for each station
    middles = rings[0] + x * rings[1] + y * rings[2]
    forward = stations.leave[stations.starts] + stations.ended(stations.arrive)
    return bool((dot(stations.steps(middles), forward) < 0).all())


def turning_back(trajectory, normal, grid):
    """Where a generator that keeps its orientation runs backward, or in its own plane: the tangent is parallel to it.

    Parameters
    ----------
    trajectory : Trajectory
    normal : (3,) array-like
        Of the generator's plane.
    grid : (n,) float array
        Rising parameters of the trajectory, both ends among them.

    Returns
    -------
    (k, 2) float array
        From which parameters to which it runs against the way it runs most.

    Examples
    --------
    >>> from sweep_addon.core.trajectories import Arc
    >>> half = Arc(radius=1.0, angle=3.0)  # from +x up and round, nearly to -x
    >>> turning_back(half, (0, 1, 0), np.linspace(*half.domain, 33)).round(6).tolist()
    [[1.570796, 3.0]]
    """
    normal = np.asarray(normal, dtype=float) / np.linalg.norm(normal)
    along = trajectory.tangents(grid) @ normal
    way = np.sum((along[1:] + along[:-1]) * norms(np.diff(trajectory.evaluate(grid), axis=0)))
    side = -1.0 if way >= 0 else 1.0
    return intervals(lambda u: side * (trajectory.tangents(u) @ normal), grid)


def short_legs(leaving, arriving, lengths):
    """Where legs between mitres are shorter than these need, and by what factor contours may be scaled.

    Parameters
    ----------
    leaving, arriving : (m, k) float array
        How far along its leg each point of the contour is ahead of the corner where the leg starts, and ahead of the
        one where it ends, on their mitres.
    lengths : (k,) float array
        Of the legs.

    Returns
    -------
    needed : (k,) float array
        How long each leg should be.
    factor : float
        Infinite where no mitre needs any length.

    Examples
    --------
    >>> needed, factor = short_legs(np.array([[0.5], [-0.5]]), np.array([[-0.5], [0.5]]), np.array([2.0]))
    >>> needed.tolist(), factor
    ([1.0], 2.0)
    """
    needed = (leaving - arriving).max(axis=0, initial=0.0)
    return needed, float((lengths / np.where(needed > 0, needed, np.nan))[needed > 0].min(initial=np.inf))
