# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A section: what every contour becomes, loops of points in the plane that bound an area, or lines that are open."""

from dataclasses import replace
from functools import cached_property, lru_cache

import numpy as np

from ..declared.frozen import individual
from ..later import later
from ..meshes.runs import following, run_of
from ..vectors import dot
from .fit import fitted
from .loops import joined, require_apart, require_area, without_coincident

nesting = later("core.contours.nesting", "nesting")
symmetry = later("core.contours.symmetry", "symmetry")

SHARP = np.radians(20)  # an edge that turns by more is a corner; flattened curves turn by at most 15 degrees


@individual
class Section:
    """Loops of points, the area on their left: outer loops counter-clockwise, holes clockwise; or open lines.

    Parameters
    ----------
    points : (m, 2) float array
        The points of all loops, one loop after the other, in metres.
    offsets : (k + 1,) int array
        Loop ``i`` is ``points[offsets[i]:offsets[i + 1]]``.
    sharp : (m,) bool array
        Where the outline has a corner, so that the sweep has an edge and not a rounding.
    closed : bool
        Whether the last point of each loop leads back to its first; if not, there is no area.

    Nothing is checked here: `from_loops` makes a section of loops that may be anything.

    Examples
    --------
    >>> section = Section.from_loops([[(0, 0), (1, 0), (0, 1)]])
    >>> section.area
    0.5
    """

    points: np.ndarray
    offsets: np.ndarray
    sharp: np.ndarray
    closed: bool = True

    @classmethod
    def from_loops(cls, loops, sharp=None, closed=True):
        """Check loops and turn them so that the area, by the even-odd rule, lies on their left.

        Parameters
        ----------
        loops : sequence of (n, 2) array-likes
            Points in metres, in either direction; a repeated closing point and coincident neighbours are dropped.
        sharp : sequence of (n,) bool array-likes, optional
            Where each loop has a corner; by default where it turns by more than 20 degrees.
        closed : bool
            Whether the loops are closed; open ones need two points, and bound no area.

        Raises
        ------
        ShapeError
            For a loop of fewer than three points, of no area, or with a number that is none, for more than 200,000
            points, or edges too close beside each other to be checked in a few seconds, and for loops that
            cross or touch themselves or each other. The sentence says which loop and where.

        Examples
        --------
        A hole is turned against its outline, whichever way it came:

        >>> square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
        >>> section = Section.from_loops([3 * square, 1 + square])
        >>> section.areas.tolist(), section.islands
        ([9.0, -1.0], ((0, 1),))
        """
        points, offsets = joined(loops)
        flags = np.zeros(len(points), dtype=bool)
        if sharp is not None:
            flags = np.concatenate([np.asarray(flag, dtype=bool) for flag in sharp])
        section = cls(*without_coincident(points, offsets, flags, closed), closed)
        if closed:
            require_area(section.points, section.offsets)
        require_apart(section.points, section.offsets, closed)
        if closed:
            section = section.reversed((section.depth % 2 == 1) == (section.areas > 0))
        return section if sharp is not None else replace(section, sharp=np.abs(section.turns) > SHARP)

    @cached_property
    def gaps(self):
        """(k,) or (0,) int array: the points that no edge leads on from, the last one of each open loop."""
        return self.offsets[1:][: 0 if self.closed else None] - 1

    @cached_property
    def following(self):
        """(m,) int array: the index of the next point of the same loop, after the last one the first."""
        return following(self.offsets)

    @cached_property
    def loop_of(self):
        """(m,) int array: the number of the loop that each point belongs to."""
        return run_of(self.offsets)

    @cached_property
    def edge_lengths(self):
        """(m,) float array: the distance from each point to the next of its loop, in metres."""
        lengths = np.hypot(*(self.points[self.following] - self.points).T)
        lengths[self.gaps] = 0.0
        return lengths

    @cached_property
    def perimeters(self):
        """(k,) float array: the length of each loop, in metres."""
        return np.add.reduceat(self.edge_lengths, self.offsets[:-1])

    @cached_property
    def areas(self):
        """(k,) float array: what each loop encloses, holes negative, in square metres."""
        if not self.closed:
            return np.zeros(len(self.offsets) - 1)
        x, y = (self.points - self.points[self.offsets[:-1]][self.loop_of]).T
        return np.add.reduceat(x * y[self.following] - y * x[self.following], self.offsets[:-1]) / 2

    @cached_property
    def area(self):
        """The enclosed area, holes taken off, in square metres."""
        return float(self.areas.sum())

    @cached_property
    def centroid(self):
        """(2,) float array: the centroid of the enclosed area, in metres; of open lines, that of the lines."""
        if not self.closed:
            return self.middle
        origin = self.points[0]
        size = np.frexp(np.abs(self.points - origin).max())[1]
        here = np.ldexp(self.points - origin, -size)  # products of very small coordinates would be 0
        there = here[self.following]
        twice = here[:, 0] * there[:, 1] - here[:, 1] * there[:, 0]
        return origin + np.ldexp(twice @ (here + there) / (3 * twice.sum()), size)

    def support(self, directions):
        """How far the section reaches from the reference point along directions (n, 2), times their lengths: (n,)."""
        return (directions @ self.points.T).max(axis=1)

    @cached_property
    def middle(self):
        """(2,) float array: the centroid of the lines themselves, in metres."""
        if not self.edge_lengths.any():
            return self.points.mean(axis=0)  # single points
        return self.edge_lengths @ (self.points + self.points[self.following]) / (2 * self.edge_lengths.sum())

    @cached_property
    def size(self):
        """The diagonal of the box around all points, in metres."""
        return float(np.hypot(*np.ptp(self.points, axis=0)))

    @cached_property
    def turns(self):
        """(m,) float array: the angle in radians by which the outline turns at each point, left is positive."""
        edges = self.points[self.following] - self.points
        turns = np.empty(len(edges))
        before, after = edges, edges[self.following]
        sine = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
        turns[self.following] = np.arctan2(sine, dot(before, after))
        turns[self.gaps] = turns[self.following[self.gaps]] = 0.0
        return turns

    @cached_property
    def nesting(self):
        """(c, 2) int array: all pairs of a loop and one that it lies in; none where they are open."""
        if not self.closed:
            return np.zeros((0, 2), dtype=int)
        return nesting(self.points, self.offsets)

    @cached_property
    def depth(self):
        """(k,) int array: in how many other loops each lies; odd for holes."""
        return np.bincount(self.nesting[:, 0], minlength=len(self.offsets) - 1)

    @cached_property
    def islands(self):
        """Tuple of tuples of loop numbers: each island's outer loop, then its holes."""
        if len(self.offsets) == 2:
            return ((0,),)
        inner, outer = self.nesting[self.depth[self.nesting[:, 1]] == self.depth[self.nesting[:, 0]] - 1].T
        holes = {int(i): [] for i in np.flatnonzero(self.depth % 2 == 0)}
        for i, j in sorted(zip(outer.tolist(), inner.tolist(), strict=True)):
            if i in holes:
                holes[i].append(j)
        return tuple((i, *inside) for i, inside in holes.items())

    @cached_property
    def symmetry(self):
        """In how many turns about the reference point the section is mapped to itself; 1 if by none but a whole one."""
        return symmetry(self) if self.closed else 1

    @cached_property
    def is_round(self):
        """Whether no turn can be seen: smooth loops, each mapped to itself by as many turns as it has points."""
        return self.closed and not self.sharp.any() and bool((np.diff(self.offsets) == self.symmetry).all())

    @cached_property
    def mirrored(self):
        """The section seen in a mirror along y, its area on the left again."""
        flipped = replace(self, points=self.points * (-1, 1))
        return flipped.reversed(np.full(len(self.offsets) - 1, True))

    def divided(self, edges):
        """The section with a further point in the middle of some of its edges, given as (m,) bool array."""
        after = np.flatnonzero(edges) + 1
        middles = (self.points[edges] + self.points[self.following[edges]]) / 2
        offsets = self.offsets + np.searchsorted(after, self.offsets, side="right")
        return replace(
            self,
            points=np.insert(self.points, after, middles, axis=0),
            offsets=offsets,
            sharp=np.insert(self.sharp, after, False),
        )

    def reversed(self, which):
        """The section with the loops where (k,) bools say so run backwards, closed ones from the same first point."""
        first = self.offsets[:-1][self.loop_of]
        place = np.arange(len(self.points)) - first
        size = np.diff(self.offsets)[self.loop_of]
        order = first + np.where(which[self.loop_of], -place % size if self.closed else size - 1 - place, place)
        return replace(self, points=self.points[order], sharp=self.sharp[order])


@lru_cache(maxsize=16)
def section_of(contour, fit):
    """The section of a contour, made once for equal ones, and with it what is known of it."""
    return fitted(contour, fit)
