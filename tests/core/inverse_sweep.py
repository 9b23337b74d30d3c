# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A judge of swept solids that makes no mesh: whether a place was visited, asked of the place.

A contour goes through a place where its plane does. Along the trajectory the place's distance from the plane changes
its sign there; it is within the solid if, at one of these changes, it is within the contour by the even-odd rule.
"""

import numpy as np

AT_ONCE = 2000


def estimate(shape, count, seed=0, room=0.01):
    """The volume of the set that a generalized cylinder visits, and its standard error, by places drawn in a box.

    Between its stations contours change evenly: the judge looks at the very sweep that the mesh is drawn from.
    """
    section, rings = shape.swept().body.section, shape.swept().body.rings
    contours = np.einsum("mk,kni->nmi", np.column_stack((np.ones(len(section.points)), section.points)), rings)
    loops = np.split(contours, section.offsets[1:-1], axis=1)
    low, high = contours.min(axis=(0, 1)) - room, contours.max(axis=(0, 1)) + room
    places = np.random.default_rng(seed).uniform(low, high, (count, 3))
    parts = np.array_split(places, -(-count // AT_ONCE))
    hit = np.concatenate([visited(some, *rings, loops, bool(shape.trajectory.closed)) for some in parts]).mean()
    box = np.prod(high - low)
    return box * hit, box * np.sqrt(hit * (1 - hit) / count)


def visited(places, points, x, y, loops, closed):
    """Which places contours visit.

    Parameters
    ----------
    places : (k, 3) float array
    points, x, y : (n, 3) float arrays
        A point of each contour's plane, and two directions in it.
    loops : list of (n, m, 3) float arrays
    closed : bool
        Whether the last contour leads to the first.

    Returns
    -------
    (k,) bool array
    """
    normals = np.cross(x, y)
    reach = max(np.linalg.norm(loop - points[:, None], axis=2).max() for loop in loops)
    height = places @ normals.T - np.einsum("ni,ni->n", points, normals)
    crosses = (height > 0) != (np.roll(height, -1, axis=1) > 0)
    crosses[:, -1] &= closed
    place, step = np.nonzero(crosses)
    near = np.linalg.norm(places[place] - points[step], axis=1) < 2 * reach
    place, step = place[near], step[near]
    after = (step + 1) % len(points)
    share = height[place, step] / (height[place, step] - height[place, after])

    def between(values):
        part = share.reshape(-1, *[1] * (values.ndim - 1))
        return (1 - part) * values[step] + part * values[after]

    across = between(x), between(y)
    inside = np.zeros(len(place), bool)
    for loop in loops:
        aside = between(loop) - places[place][:, None]
        inside ^= odd(*(np.einsum("pmi,pi->pm", aside, axis) for axis in across))
    return np.bincount(place[inside], minlength=len(places)) > 0


def odd(x, y):
    """Round which polygons, (p, m) twice, the origin is inside by the even-odd rule: (p,) bool array."""
    u, v = np.roll(x, -1, axis=1), np.roll(y, -1, axis=1)
    spans = (y > 0) != (v > 0)
    to_the_right = x - y * (u - x) / np.where(spans, v - y, 1.0) > 0
    return (spans & to_the_right).sum(axis=1) % 2 == 1
