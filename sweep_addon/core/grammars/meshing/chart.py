# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of a figure's mesh: texture coordinates along and round its tubes, and what vertices know of segments."""

from functools import cached_property

import numpy as np

from ...declared.digest import checksum
from ...declared.options import Texture
from ...vectors import norms, product

METRIC, OF_SEGMENTS = ("u", "arc_length", "radius"), ("colour", "birth", "axis", "order")


class Skin:
    """The rings of a figure: where its axes have points, one behind the other, and the segment that each belongs to.

    Parameters
    ----------
    figure : Figure
    ends, starts : (v,) int array and int, optional
        Of edges, which share points: the segments whose ends are points, and how many of the last are starts instead.

    Attributes
    ----------
    order : (n,) int array
        The segments, sorted by axis.
    begins : (n,) bool array
        Which of these begin one.
    lower : (n,) int array
        The ring where each begins; it ends in the next one.
    segment : (r,) int array
        The one whose width a ring has: that begins there, or at the end of an axis the last.
    """

    def __init__(self, figure, ends=None, starts=0):
        self.figure, self.order = figure, figure.by_axis
        self.begins = ~figure.joined[self.order]
        self.lower = np.arange(len(self.order)) + np.cumsum(self.begins) - 1
        self.segment = np.empty(len(self.order) + int(self.begins.sum()), dtype=np.intp)
        self.segment[self.lower + 1], self.segment[self.lower] = self.order, self.order
        self.shared, self.values = None if ends is None else self.ring_of(ends, starts), {}

    def ring_of(self, ends, starts):
        """(v,) int array: the ring at each point of edges."""
        place = np.empty(len(self.order), dtype=np.intp)
        place[self.order] = self.lower
        rings = place[ends]
        rings[: len(ends) - starts] += 1
        return rings

    @property
    def rings(self):
        return len(self.segment)

    @cached_property
    def first(self):
        """(a,) int array: the first ring of each axis."""
        return self.lower.take(self.starts)

    @cached_property
    def starts(self):
        """(a,) int array: the first of the sorted segments of each axis."""
        return np.flatnonzero(self.begins)

    @cached_property
    def final(self):
        """(a,) int array: the last ring of each axis."""
        return np.append(self.first[1:], self.rings)[: len(self.first)] - 1

    @cached_property
    def axis(self):
        """(n,) int array: the axis of each sorted segment."""
        return np.cumsum(self.begins) - 1

    @cached_property
    def points(self):
        """(r, 3) float array: the middle of each ring."""
        found = np.empty((self.rings, 3))
        found[self.lower + 1] = self.figure.end.take(self.order, axis=0)
        found[self.first] = self.figure.start.take(self.order.take(self.starts), axis=0)
        return found

    @cached_property
    def radius(self):
        """(r,) float array: of each ring."""
        found = self.figure.width.take(self.segment) / 2
        if self.figure.walk.cylinders:  # whose curves taper to their end
            last = np.append(self.begins[1:], True)[: len(self.order)]
            found[self.final] = self.figure.tip[self.order[last]] / 2
        return found

    @cached_property
    def arc_length(self):
        """(r,) float array: from where the axis begins."""
        found = np.zeros(self.rings)
        way = norms(self.points[1:] - self.points[:-1]).take(self.lower)
        reached = np.concatenate(([0.0], np.cumsum(way)))
        found[self.lower + 1] = reached[1:] - reached.take(self.starts).take(self.axis)
        return found

    @cached_property
    def u(self):
        """(r,) float array: from 0 to 1 along its axis."""
        length = self.arc_length.take(self.final)
        return self.arc_length / np.where(length > 0, length, 1).take(self.ring_axis)

    @cached_property
    def ring_axis(self):
        """(r,) int array: the axis of each ring."""
        begun = np.zeros(self.rings, dtype=np.intp)
        begun[self.first] = 1
        return np.cumsum(begun) - 1

    def value(self, name):
        """(v,) or (r,) array: a value of each ring, or of each point of edges."""
        if name not in self.values:
            if name == "axis":
                found = self.ring_axis
            elif name in OF_SEGMENTS:
                found = getattr(self.figure, name).take(self.segment)
            else:
                found = getattr(self, name)
            self.values[name] = found if self.shared is None else found.take(self.shared)
        return self.values[name]


class Chart:
    """Texture coordinates and attributes of columns of rings, and of a cap at each end of a tube."""

    def __init__(self, skin, columns, texture, named):
        self.skin, self.columns, self.texture, self.named = skin, columns, texture, named
        self.rings = len(skin.order)

    @cached_property
    def keys(self):
        plain = self.texture is Texture.NONE
        metric = checksum(*map(self.skin.value, METRIC)) if self.named or not plain else ""
        told = checksum(*map(self.skin.value, OF_SEGMENTS)) if self.named else ""
        return "" if plain else f"{self.texture.name}{metric}", metric if self.named else "", told

    def uv(self, dtype=np.float64, empty=np.empty):
        """Texture coordinates of each corner: (c, 2), or None for none.

        In lengths each tube begins at 0 and is as wide as it is thick there; as a unit it has the whole square. Across
        it is measured from its end, or pictures would be seen in a mirror.
        """
        if self.texture is Texture.NONE:
            return None
        skin, sides = self.skin, self.columns
        lengths = self.texture is Texture.LENGTHS
        along = skin.arc_length if lengths else skin.u
        width = 2 * skin.radius * np.sin(np.pi / sides) if lengths else np.full(skin.rings, 1 / sides)
        count, tubes = len(skin.order), skin.rings - len(skin.order)
        made = empty(8 * sides * count + 4 * sides * tubes, dtype)
        # One product lays the corners of all faces: what all columns have, and so many widths as are left.
        rows = np.zeros((2, count, 4, 2), dtype)
        here, there = ((along.take(ring), width.take(ring)) for ring in (skin.lower, skin.lower + 1))
        for corner, (far, wide), left in ((0, here, False), (1, here, True), (2, there, True), (3, there, False)):
            rows[0, :, corner, 0], rows[1, :, corner, 1] = far, wide
            if left:
                rows[0, :, corner, 1] = -wide
        columns = np.column_stack((np.ones(sides), sides - np.arange(sides))).astype(dtype)
        product(columns, rows.reshape(2, -1), out=made[: 8 * sides * count].reshape(sides, 8 * count))
        self.lay_caps(made[8 * sides * count :].reshape(2, tubes, sides, 2), along, lengths)
        return made.reshape(-1, 2)

    def lay_caps(self, made, along, lengths):
        """Write the caps, which lie flat before the beginning and behind the end of their tube, or over the square."""
        skin, sides = self.skin, self.columns
        angle = 2 * np.pi * np.arange(sides) / sides
        disc = np.column_stack((np.cos(angle), np.sin(angle)))
        for cap, ring, way in zip(made, (skin.first, skin.final), (-1, 1), strict=True):
            size = skin.radius.take(ring) if lengths else np.full(len(ring), 0.5)
            corners = 1 + (disc[::-1] * (-1, 1) if way < 0 else disc)
            cap[:] = np.multiply.outer(size.astype(made.dtype), corners.astype(made.dtype))
            if lengths:
                cap[..., 0] += (-3 * size if way < 0 else along.take(ring) + size)[:, None]

    def along(self, dtype=np.float64, but=(), rooms=None):
        """Values at each vertex in metres, or by metres: u, arc_length, radius and v, round it, but for some."""
        if not self.named:
            return {}
        found = {name: self.spread(self.skin.value(name), dtype) for name in METRIC if name not in but}
        if self.skin.shared is None:
            edge = (2 * self.skin.radius * np.sin(np.pi / self.columns)).astype(dtype)
            found["v"] = np.multiply.outer(np.arange(self.columns).astype(dtype), edge).ravel()
        return found

    def across(self, dtype=np.float64):
        """Values at each vertex of its segment: colour, birth, axis and order."""
        return {name: self.spread(self.skin.value(name), dtype) for name in OF_SEGMENTS} if self.named else {}

    def spread(self, values, dtype):
        """A value at each vertex, from one for each ring."""
        found = np.empty((self.columns, len(values)), dtype)
        found[:] = values
        return found.ravel()
