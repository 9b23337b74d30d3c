# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Thickness: the largest radius of a round tube with flat ends, or open ones, that does not meet itself.

The tube is the union of discs across the trajectory, and it is clean while no two of them meet. As the radius grows,
two inner discs meet first at the reach, or one at an end meets another, which is found here: for two discs in space the
radius at which they meet is known in closed form.
"""

from functools import lru_cache, partial

import numpy as np

from ..envelopes.reach import Reach, reach
from ..stations.cells import CELLS
from ..stations.search import highest
from ..trajectories.arc_length import arc_length, subdivided
from ..vectors import dot, norms

LESS = 1 - 1e-9  # beside its neighbours the disc at an end meets at the radius of curvature, but for rounding
DIPS = 12  # of the radius along the trajectory that are looked at closely
PARALLEL = 1e-12  # the sine of the angle between two planes that are one or do not meet


@lru_cache(maxsize=32)
def thickest(trajectory):
    """The radius at which a round tube along a smooth trajectory begins to meet itself, its ends among it.

    Parameters
    ----------
    trajectory : Trajectory

    Returns
    -------
    Reach

    Examples
    --------
    A path that comes back to end one metre from its start, at a right angle to it:

    >>> from sweep_addon.core.rings.corners import Round
    >>> from sweep_addon.core.trajectories import Polyline
    >>> path = [(0, 0, 0), (10, 0, 0), (10, 5, 0), (5, 5, 0), (5, 1, 0)]
    >>> hook = Polyline(path, corner=Round(2.0))
    >>> round(reach(hook).radius, 9), round(thickest(hook).radius, 9)
    (2.0, 1.0)
    """
    best = reach(trajectory)
    if trajectory.closed or trajectory.straight:
        return best
    ends = at_ends(trajectory)
    least = min(ends, key=lambda found: found.radius)
    return least if least.radius < LESS * best.radius else best


def at_ends(trajectory):
    """The least radii at which the discs at the start and at the end meet another: two Reach."""
    measure = arc_length(trajectory)
    grid = subdivided(measure.nodes, -(-CELLS // (len(measure.nodes) - 1)))
    ends = np.array(trajectory.domain)
    places, normals = trajectory.evaluate(ends), trajectory.tangents(ends)
    normals[1:] = trajectory.tangents(ends[1:], before=True)

    def radius(u, end):
        return meeting(places[end], normals[end], trajectory.evaluate(u), trajectory.tangents(u))

    found = [dips(grid[1:], partial(radius, end=0)), dips(grid[:-1], partial(radius, end=1))]
    end = np.repeat((0, 1), [len(u) for u, *_ in found])
    u, values, low, high = (np.concatenate(part) for part in zip(*found, strict=True))
    if len(u):  # in one search: of few places each step takes as long as of twice as many
        closer, least = highest(lambda u: -radius(u, np.tile(end, len(u) // len(end))), low, high)
        u, values, end = np.concatenate((closer, u)), np.concatenate((-least, values)), np.tile(end, 2)
    return [nearest(u[end == side], values[end == side], ends[side]) for side in (0, 1)]


def dips(grid, radius):
    """Where a function of rising places (n,) is least beside its neighbours: places, values, and those beside."""
    values = radius(grid)
    beside = np.pad(values, 1, constant_values=np.inf)
    found = np.flatnonzero((values <= beside[:-2]) & (values <= beside[2:]) & np.isfinite(values))
    found = found[np.argsort(values[found], kind="stable")[:DIPS]]
    low, high = grid[np.maximum(found - 1, 0)], grid[np.minimum(found + 1, len(grid) - 1)]
    return grid[found], values[found], low, high


def nearest(u, radii, end):
    """The least of some radii, at parameters, at which the disc at an end meets another: a Reach."""
    if not len(u):
        return Reach(np.inf)
    least = np.argmin(radii)
    return Reach(float(radii[least]), tuple(sorted((float(end), float(u[least])))))


def meeting(place, normal, places, normals):
    """At which radius a disc meets other discs of the same radius: (n,), infinite where their planes do not meet.

    Parameters
    ----------
    place, normal : (1, 3) or (n, 3) float array
        The centre of the disc, and the unit normal of its plane, or of as many discs.
    places, normals : (n, 3) float array
        Those of the others.

    The planes meet in a line. On it the larger one of the distances from the two centres is least at the foot of one
    of them or where both are the same.

    Examples
    --------
    >>> x, z = np.eye(3)[:1], np.eye(3)[2:]
    >>> meeting(0 * x, z, np.array([[3.0, 0, 4], [5, 0, 0]]), np.array([[1.0, 0, 0], [0, 0, 1]])).tolist()
    [4.0, 2.5]
    """
    normal = np.broadcast_to(normal, normals.shape)
    line, chord = np.cross(normal, normals), places - place
    sine, apart = norms(line), norms(chord)
    parallel = sine < PARALLEL
    sine = np.where(parallel, 1.0, sine)
    first, last = (np.abs(dot(chord, n)) / sine for n in (normals, normal))  # from the centres to the line
    along = np.abs(dot(chord, line)) / sine  # from foot to foot
    equal = (last**2 - first**2 + along**2) / np.where(along > 0, 2 * along, 1.0)
    met = np.hypot(first, equal)
    met = np.where(first >= np.hypot(last, along), first, np.where(last >= np.hypot(first, along), last, met))
    one = np.abs(dot(chord, normal)) <= PARALLEL * apart
    return np.where(parallel, np.where(one, apart / 2, np.inf), met)
