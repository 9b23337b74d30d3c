# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures: what a turtle has drawn, as arrays. What takes looking at the word again is found when it is asked for."""

from functools import cached_property
from numbers import Integral

import numpy as np

from ...declared.options import Texture
from ...declared.parameters import require
from ...vectors import norms
from ..deriving.neighbours import narrow
from . import turns
from .bounding import bounded
from .filling import ORGAN, organs, polygons, position
from .scaling import WIDTH, scaled

ALMOST = 1e-6  # of the sine between a heading and a left that is none
OF_VERTEX = 120  # bytes of all arrays of a mesh while it is made, for each vertex
THINNER = 0.5**0.5  # what a diameter is multiplied by where none is said: two such branches are as thick as one before


class Figure:
    """Segments, polygons and organs that a turtle has left on its way through a word.

    Attributes
    ----------
    start, end : (n, 3) float array
        The ends of each segment, in metres.
    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> figure = LSystem.parse("#step 2\\naxiom: F[+(90)!(0.05)F]F").derive(0).figure()
    >>> figure.start.tolist()
    [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 0.0, 0.0]]
    >>> figure.width.tolist(), figure.parent.tolist(), figure.axis.tolist()
    ([0.1, 0.05, 0.1], [-1, 0, 0], [0, 1, 0])
    """

    def __init__(self, walk, start, end, orientations):
        self.walk, self.orientations = walk, orientations
        self.moves_end = end
        self.start, self.end = (start, end) if walk.whole else (start[self.drawn], end[self.drawn])

    def __len__(self):
        return len(self.start)

    @property
    def drawn(self):
        """(m,) bool array: which moves of the turtle leave a segment."""
        return self.walk.is_drawn

    @cached_property
    def place(self):
        """(n,) int array: the module of each segment in the word that the turtle walks.

        That is the interpreted one, in which a mark of a generalized cylinder stands once for each of its segments.
        """
        return self.walk.moves if self.walk.whole else self.walk.moves[self.drawn]

    @cached_property
    def at(self):
        """(3,) float array: where the turtle is at the end, in metres."""
        return position(self.walk, np.array([len(self.walk.symbols)]), self.moves_end)[0]

    @cached_property
    def axes(self):
        """(n, 3, 3) float array: heading, left and up of the turtle on each segment."""
        axes = turns.axes(*turns.taken(self.orientations(), np.flatnonzero(self.drawn)))
        cylinders = self.walk.cylinders
        return along(axes, self.end - self.start, cylinders.bends[self.place]) if cylinders else axes

    @property
    def headings(self):
        """(n, 3) float array: where each segment leads, its turtle's heading unless that goes backwards."""
        way = self.end - self.start
        size = norms(way)
        if size.all():
            return way / size[:, None]
        heading = self.axes[:, 0]
        return np.where(size[:, None] > 0, way / np.where(size > 0, size, 1)[:, None], heading)

    @cached_property
    def width(self):
        """(n,) float array: the diameter of each segment where it begins, in metres."""
        return self.tapering(0)

    @cached_property
    def tip(self):
        """(n,) float array: the diameter of each segment where it ends, if nothing goes on from it, in metres."""
        return self.tapering(1)

    def tapering(self, end):
        """(n,) float array: the diameter where segments begin or end, of which those of curves taper."""
        found, cylinders = self.widths(self.place), self.walk.cylinders
        if cylinders:
            bends = np.flatnonzero(cylinders.bends[self.place])
            place = self.place[bends]
            first = self.widths(cylinders.before[place])
            found[bends] = first + (found[bends] - first) * (cylinders.ends if end else cylinders.begins)[place]
        return found

    def widths(self, place):
        """(k,) float array: the diameter at modules of the word; 0 where it would be less."""
        return np.maximum(bounded(self.said(place), np.max, "be at most {} m thick"), 0)

    def said(self, place):
        """(k,) float array: the diameter that modules say, at others of the word."""
        sets = self.walk.chosen("!", given=True)
        found = self.changing("!", self.walk.system.width, np.multiply, lambda times: THINNER**times, place)
        found = found if self.walk.scale is None else found * self.walk.scale[place]
        if not self.walk.numbers(WIDTH):
            return found
        last = self.walk.branches.before(place, sets)
        return found * scaled(self.walk, WIDTH, place, np.append(np.flatnonzero(sets), -1)[last])

    @cached_property
    def colour(self):
        """(n,) float array: the number of the colour of each segment."""
        return self.colours(self.place)

    def colours(self, place):
        """(k,) float array: the number of the colour at modules of the word."""
        return self.changing("'", 0.0, np.add, lambda times: times, place)

    @cached_property
    def birth(self):
        """(n,) int array: the step of the derivation that made each segment."""
        return self.walk.word.births[self.place]

    @cached_property
    def parent(self):
        """(n,) int array: the segment that each goes on from, or -1."""
        return self.walk.limbs.branches.previous(self.first)

    @cached_property
    def branch(self):
        """(n,) int array: the branch of each segment, the part of the word within one pair of brackets."""
        return np.repeat(self.walk.limbs.branches.branch, np.diff(self.first))

    @cached_property
    def first(self):
        """(b + 2,) int array: which segment is the first of each stretch of the limbs, and how many there are."""
        first = self.walk.limbs.first
        return first if self.walk.whole else np.append(0, np.cumsum(self.drawn)).take(first)

    @cached_property
    def follows(self):
        """(n,) bool array: whether each segment begins where its parent ends."""
        walk = self.walk
        moved = walk.limbs.branches.previous(walk.limbs.first)[self.drawn]
        found = (moved >= 0) & self.drawn[moved]
        if walk.cylinders:  # whose turtle moves between two curves, and draws nothing
            place = self.place
            of = walk.cylinders.bends[place]
            found |= of & (walk.cylinders.begins[place] == 0) & walk.cylinders.bends[walk.cylinders.before[place]]
        return found

    @cached_property
    def joined(self):
        """(n,) bool array: whether each segment begins where its parent ends, in the same branch."""
        parent = self.parent
        return self.follows & (parent >= 0) & (self.branch[parent] == self.branch)

    @cached_property
    def filled(self):
        """Polygons: the polygons of the figure, one behind the other."""
        return polygons(self.walk, self.moves_end)

    @cached_property
    def polygons(self):
        """Tuple of (k, 3) float array: the vertices of each polygon, in metres."""
        return tuple(np.split(self.filled.points, self.filled.offsets[1:-1])) if len(self.filled.place) else ()

    @cached_property
    def organs(self):
        """Tuple of Organ: organs by name, and where they are."""
        return organs(self.walk, self.moves_end)

    @cached_property
    def organ_turns(self):
        """Tuple of pairs of (k,) complex array: the turtle's orientation at the organs of each name, as quaternions."""
        tildes = self.walk.numbers(ORGAN)
        again = type(self.walk)(*self.walk.asked, stops=tildes)
        stops = np.flatnonzero(np.isin(again.symbols[again.moves], tildes))
        pair = turns.taken(again.figure().orientations(), stops)
        where = (np.searchsorted(again.moves[stops], organ.place - 1) for organ in self.organs)
        return tuple(turns.taken(pair, at) for at in where)

    @property
    def bounds(self):
        """(2, 3) float array: the least and the greatest coordinates of all segments, in metres."""
        if not len(self):
            return np.zeros((2, 3))
        return np.array([np.minimum(self.start, self.end).min(axis=0), np.maximum(self.start, self.end).max(axis=0)])

    @cached_property
    def axis(self):
        """(n,) int array: the poly-line that each segment is part of.

        One goes on from segment to segment of a branch until the turtle moves without drawing; each branch begins its
        own.
        """
        number = np.empty(len(self), dtype=np.intp)
        number[self.by_axis] = np.cumsum(~self.joined[self.by_axis]) - 1
        return number

    @cached_property
    def by_axis(self):
        """(n,) int array: the segments sorted by axis, along each."""
        return np.argsort(narrow(self.branch), kind="stable")

    @cached_property
    def order(self):
        """(n,) int array: of how many others the branch of each segment grows out of another: 0 for the stem."""
        first = np.flatnonzero(~self.joined)
        parent = self.parent[first]
        steps = ((parent >= 0) & (self.branch[first] != self.branch[parent])).astype(np.intp)
        of_axis = np.empty(len(first), dtype=np.intp)
        of_axis[self.axis[first]] = np.arange(len(first))
        above = np.where(parent >= 0, of_axis[self.axis[parent]], -1)
        while (above >= 0).any():
            steps = steps + np.where(above >= 0, steps[above], 0)
            above = np.where(above >= 0, above[above], -1)
        return steps[of_axis[self.axis]]

    def mesh(self, sides=8, texture=Texture.NONE, attributes=True, dtype=np.float64, budget=None, apart=False):
        """A closed tube along each axis, mitred where it turns, or its segments as edges; its polygons as faces.

        Parameters
        ----------
        sides : int
            Of each tube, from 3 to 256; 0 for edges alone. A tube is as thick where a segment begins as that is wide.
        texture : Texture
            How texture coordinates of tubes are measured.
        attributes : bool
            Whether vertices know their segments.
        dtype : numpy dtype
            Of the vertices.
        budget : Budget, optional
            Of the arrays of the mesh.
        apart : bool
            Whether edges of two axes have no vertex in common, as of poly-lines.

        Returns
        -------
        Mesh
            In metres, with the attributes u, from 0 to 1 along an axis, arc_length, along it in metres, v, round it,
            radius, colour, birth, axis and order, and where there are organs their points, with organ and size.

        Raises
        ------
        ShapeError
            For other numbers, and for more than 20 million vertices or than the budget allows.

        Examples
        --------
        >>> from sweep_addon.core.grammars import LSystem
        >>> tree = LSystem.parse("axiom: F[+F]F").derive(0).figure().mesh(sides=6)
        >>> tree, len(tree.boundary_edges()), tree.euler_characteristic()
        (Mesh(30 vertices, 22 faces), 0, 4)
        """
        from ..meshing.tubes import mesh  # figures alone need no mesh

        whole = isinstance(sides, Integral)
        require(
            whole and (sides == 0 or 3 <= sides <= 256), "must be 0 or a whole number from 3 to 256", sides, "sides"
        )
        if budget is not None:
            rings = 2 * len(self) if sides == 0 else len(self) + int(np.count_nonzero(~self.joined))
            budget.of_arrays(rings * max(sides, 1) * OF_VERTEX, "sides" if sides else "")
        return mesh(self, sides, texture, attributes, dtype, apart)

    def changing(self, name, default, combine, change, place):
        """(n,) float array: what modules of a name with a parameter set and others change, at modules of the word."""
        walk, branches = self.walk, self.walk.branches
        value = np.full(len(place), float(default))
        if not walk.named.get(name):
            return value
        sets = walk.chosen(name, given=True)
        last = branches.before(place, sets)
        value[last >= 0] = walk.word.columns[0][np.flatnonzero(sets)[last[last >= 0]]] if sets.any() else 0
        changes = walk.chosen(name, given=False)
        if changes.any():
            counted = branches.counts(changes.astype(np.int8))
            times = counted[place]
            times[last >= 0] -= counted[np.flatnonzero(sets)[last[last >= 0]]]
            value = combine(value, change(times))
        return value


def along(axes, way, which):
    """(n, 3, 3) float array: axes of which some head along their way, with the left that is next to their own."""
    size = np.linalg.norm(way, axis=1)
    which = np.flatnonzero(which & (size > 0))
    heading, left = way[which] / size[which, None], axes[which, 1]
    left = left - np.einsum("ij,ij->i", left, heading)[:, None] * heading
    short = np.linalg.norm(left, axis=1) < ALMOST
    left[short] = np.cross(axes[which[short], 2], heading[short])  # where that heads along its own left
    left /= np.linalg.norm(left, axis=1)[:, None]
    axes[which] = np.stack((heading, left, np.cross(heading, left)), axis=1)
    return axes
