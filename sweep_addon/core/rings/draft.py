# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draft: the edges of a section moved inwards, each parallel to itself, as the sides of a casting lean."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from ..declared.frozen import individual
from ..later import later

crossings = later("core.contours.crossing", "crossings")

ALIKE = 1e-6  # of a height: single precision, which Blender keeps, tells no less apart
LOOKED_AT = 64  # edges of a loop, across which its width is measured
HALVINGS = 32  # of the way to a height at which edges meet


@individual
class Draft:
    """A section drafted to two heights, those of its ends.

    Parameters
    ----------
    moves : (m, 2) float array
        How far each point goes in a metre of height.
    ends : tuple of two Section
        The section at the ends.
    reached : tuple of two float
        The heights up to which it stays one, on the way to each end.
    points : tuple of two bool
        Whether it is a point there.
    """

    moves: np.ndarray
    ends: tuple
    reached: tuple
    points: tuple


@lru_cache(maxsize=16)
def draft(section, slopes, heights):
    """A section drafted to two heights by the tangent of the angle of each loop: a `Draft`, kept for equal ones."""
    slopes = np.array(slopes)
    if not slopes.any():
        return Draft(np.zeros_like(section.points), (section, section), (np.inf, np.inf), (False, False))
    moves = mitres(section) * slopes[section.loop_of, None]
    reached, points = zip(*(reachable(section, moves, height) for height in heights), strict=True)
    return Draft(moves, tuple(drafted(section, moves, height) for height in heights), reached, points)


def room(points):
    """At most how far the edges of a loop can all move inwards, in metres: less where it is narrower than it shows.

    That is half its width across any of its edges, of which some are looked at; of a convex one also twice its area
    over its length, which is exact where all edges touch one circle.

    Parameters
    ----------
    points : (n, 2) float array
        Counter-clockwise.

    Examples
    --------
    >>> from ..contours import Rectangle, RegularPolygon
    >>> room(Rectangle(2, 3).section().points)
    1.0
    >>> round(room(RegularPolygon(sides=3, radius=1.0).section().points), 12)
    0.5
    """
    edges = np.roll(points, -1, axis=0) - points
    lengths = np.hypot(*edges.T)
    some = slice(None, None, -(-len(points) // LOOKED_AT))
    across = (edges[some] / lengths[some, None])[:, ::-1] * (-1, 1)
    widths = np.ptp((points - points[0]) @ across.T, axis=0)
    x, y = edges.T
    if (x * np.roll(y, -1) < y * np.roll(x, -1)).any():
        return float(widths.min()) / 2
    here = points - points[0]
    twice = here[:, 0] @ np.roll(here[:, 1], -1) - here[:, 1] @ np.roll(here[:, 0], -1)
    return float(min(widths.min() / 2, twice / lengths.sum()))


def mitres(section):
    """(m, 2) float array: where each point goes while all edges move by one metre into the area on their left.

    A point stays on both its edges: it moves on the bisector of their normals, by 1 / cos(half the turn).

    Examples
    --------
    >>> from ..contours import Rectangle
    >>> mitres(Rectangle(2, 2).section()).round(12).tolist()
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
    """
    edges = section.points[section.following] - section.points
    after = edges[:, ::-1] * (-1, 1) / section.edge_lengths[:, None]
    before = np.empty_like(after)
    before[section.following] = after
    across = before + after
    return 2 * across / np.einsum("ij,ij->i", across, across)[:, None]


def drafted(section, moves, height):
    """The section at a height, its points gone so far (m, 2) in each metre of it."""
    return replace(section, points=section.points + height * moves)


def reachable(section, moves, height):
    """How high a section stays one, and whether it is a point there.

    Up to the height it must stay one with room to spare: contours whose edges all but meet have points that single
    precision does not tell apart, and a cap of no area.

    Parameters
    ----------
    section : Section
    moves : (m, 2) float array
        How far each point goes in a metre of height.
    height : float
        As high as is asked for.

    Returns
    -------
    height : float
        Where the contour is a point, or just below where the first edge has no length left or edges meet; infinite
        where none does up to the height.
    point : bool
        Whether all edges of one loop vanish at once, and there.

    Examples
    --------
    The edges of a square meet where it is a point, those of a rectangle in a ridge:

    >>> from ..contours import Rectangle
    >>> for width in (2, 3):
    ...     section = Rectangle(width, 2).section()
    ...     print(reachable(section, mitres(section), 1.0))
    (1.0, True)
    (0.999999, False)
    """
    edges = section.points[section.following] - section.points
    shrinks = -np.einsum("ij,ij->i", moves[section.following] - moves, edges) / section.edge_lengths
    vanish = np.full(len(edges), np.inf)
    np.divide(section.edge_lengths, shrinks, out=vanish, where=shrinks > 0)
    first = float(vanish.min())
    beyond = height * (1 + ALIKE)
    if len(section.offsets) == 2 and vanish.max() <= first * (1 + ALIKE) and beyond >= first * (1 - ALIKE):
        return first, True
    if beyond < first and alike(section, drafted(section, moves, beyond)):
        return np.inf, False
    low, high = 0.0, min(beyond, first)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        clear = alike(section, drafted(section, moves, middle))
        low, high = (middle, high) if clear else (low, middle)
    return high * (1 - ALIKE), False


def alike(section, other):
    """Whether another section of as many points is one too: no edges meet, and the loops lie in each other as here."""
    apart = not len(crossings(other.points, other.following))
    return apart and np.array_equal(other.nesting, section.nesting) and bool((other.areas * section.areas > 0).all())
