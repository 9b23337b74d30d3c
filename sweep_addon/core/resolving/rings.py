# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rings: the contours of a sweep, one behind the other, and by which vertices and faces of its mesh they stand."""

from functools import cached_property

import numpy as np

from ..declared.frozen import individual
from ..grids.laying import Layout, kinds
from ..meshes.mesh import Mesh
from ..vectors import cross, dot, norms, unit

TINY = 1e-300  # metres: a tip has no width
STILL = 1e-3  # of the step of a contour: a point of it that moves forward by less does not move forward


@individual
class Rings:
    """The rings of a mesh that is drawn on a closed contour's grid.

    Rings and the segments between them are counted as the grid does. Of a closed sweep they go on beyond both ends, and
    there columns begin elsewhere if the grid has a seam.

    Parameters
    ----------
    mesh : Mesh
        Its chart has a grid without poles and gaps.
    breaks : tuple of Break, optional
        Where the sweep is taken apart, in order.
    """

    mesh: Mesh
    breaks: tuple = ()

    @property
    def grid(self):
        return self.mesh.chart.grid

    @property
    def closed(self):
        return bool(self.grid.closed)

    @property
    def segments(self):
        return self.grid.rings - (not self.closed)

    @cached_property
    def numbers(self):
        """(m, n) int array: the vertex of each column at each ring of the grid."""
        layout = Layout(self.grid)
        return layout.number[:, None] * layout.stride + layout.position

    @cached_property
    def faces(self):
        """(m, segments) int array: the face of each column's strip in each segment of the grid."""
        _, below, above = self.grid.bands()
        faces, start = np.empty((self.grid.columns, self.segments), int), 0
        for bands in kinds(below, above):
            count = self.grid.columns * len(bands)
            faces[:, bands] = start + np.arange(count).reshape(self.grid.columns, -1)
            start += count
        return faces

    @cached_property
    def sides(self):
        """How many faces are between rings; those after them are caps."""
        return self.faces.size

    @property
    def first_cap(self):
        """How many faces close the start."""
        cap = self.grid.caps[0]
        return len(cap[1]) - 1 if cap else 0

    @cached_property
    def turned(self):
        """(segments + 1,) and more: the columns where those of the rings stand that are one way round farther on."""
        return np.array(self.grid.seam, int) if self.grid.seam else np.arange(self.grid.columns)

    def placed(self, which):
        """Of rings or segments: where in the grid they are, and how many times beyond its end, two (k,)."""
        which = np.asarray(which)
        return (which % self.grid.rings, which // self.grid.rings) if self.closed else (which, 0 * which)

    def vertices(self, which):
        """The vertices of rings (k,): (m, k) int array."""
        rings, around = self.placed(which)
        return self.numbers[self.columns(around), rings]

    def standing(self, which):
        """The places of the points of rings (k,): (k, m, 3) float array."""
        return self.mesh.vertices[self.vertices(which)].swapaxes(0, 1)

    def faces_between(self, which):
        """The faces of segments (k,): (m, k) int array."""
        segments, around = self.placed(which)
        return self.faces[self.columns(around), segments]

    def longer(self, first, last):
        """The first ring and the last of a stretch that is a segment longer at both ends, if there are any."""
        if not self.closed:
            return max(first - 1, 0), min(last + 1, self.segments)
        return first - 1, min(last + 1, first + self.segments)

    def columns(self, around):
        """(m, k) int array: the columns of the grid that columns are, so many times beyond its end."""
        columns = np.repeat(np.arange(self.grid.columns)[:, None], len(around), axis=1)
        for step in np.unique(around[around != 0]):
            turn = self.turned if step > 0 else np.argsort(self.turned)
            for _ in range(abs(step)):
                columns[:, around == step] = turn[columns[:, around == step]]
        return columns

    @cached_property
    def points(self):
        """(m, n, 3) float array: the places of the rings of the grid, in metres."""
        if self.grid.tips:
            return self.mesh.vertices[self.numbers]
        return self.mesh.vertices.reshape(self.grid.columns, self.grid.rings, 3)

    @cached_property
    def centres(self):
        """(n, 3) float array: the mean of the points of each ring."""
        return self.points.mean(axis=0)

    @cached_property
    def normals(self):
        """(n, 3) float array: unit normals of the rings' planes, by Newell's method; of a tip that beside it."""
        aside = self.points - self.centres
        areas = cross(aside, aside[self.grid.following]).sum(axis=0)
        tips = list(self.grid.tips)
        if tips:
            others = self.grid.whole
            areas[tips] = areas[others[np.abs(others - np.array(tips)[:, None]).argmin(axis=1)]]
        return unit(areas)

    @cached_property
    def radii(self):
        """(n,) float array: how far the points of each ring are from its centre at most."""
        return norms(self.points - self.centres).max(axis=0)

    @cached_property
    def turns(self):
        """(segments,) float array: by how many radians the rings' planes turn in each segment of the grid."""
        ahead = np.roll(self.normals, -1, axis=0)
        half = norms(ahead - self.normals)[: self.segments] / 2
        return 2 * np.arcsin(np.minimum(half, 1.0))

    @cached_property
    def ahead(self):
        """(m, segments, 3) float array: from each point to where it goes in each segment of the grid."""
        last = self.segments
        ahead = np.empty((self.grid.columns, last, 3))
        ahead[:, : len(self.points[0]) - 1] = self.points[:, 1:]
        if self.closed:
            ahead[:, -1] = self.points[self.turned, 0]
        ahead -= self.points[:, :last]
        return ahead

    @cached_property
    def bends(self):
        """(segments,) float array: by how many radians the ways of points bend in each segment of the grid.

        They are counted as those of a circle as wide as the contour that are as far from their chords. A contour that
        does not turn may go round a corner, and one that turns about its tangent does so in its plane.
        """
        before = np.roll(self.ahead, 1, axis=1)
        if self.closed:
            before[self.turned, 0] = self.ahead[:, -1]
        else:
            before[:, 0] = self.ahead[:, 0]
        turn = norms(unit(self.ahead) - unit(before))
        aside = (turn * np.minimum(norms(self.ahead), norms(before))).max(axis=0)
        rings = np.sqrt(aside / (2 * np.maximum(self.radii[: self.segments], TINY)))
        return np.maximum(rings, np.append(rings[1:], rings[0] if self.closed else 0.0))

    @cached_property
    def slides(self):
        """(segments,) float array: how far points go along the line about which the contour turns in each segment.

        It is counted in widths of the contour along that line.
        """
        line = unit(cross(self.normals, np.roll(self.normals, -1, axis=0)))[: self.segments]
        width = np.ptp(dot(self.points[:, : self.segments], line), axis=0)
        return np.abs(dot(self.ahead, line)).max(axis=0) / np.maximum(width, TINY)

    @cached_property
    def folded(self):
        """(segments,) bool array: in which segments of the grid some point of the contour does not move forward.

        Round a break all are taken for such.
        """
        last = self.segments
        forward = unit(self.normals + np.roll(self.normals, -1, axis=0))[:last]
        step = norms(np.roll(self.centres, -1, axis=0) - self.centres)[:last]
        folded = dot(self.ahead, forward).min(axis=0) <= STILL * step
        for each in self.breaks:
            folded[each.around % last if self.closed else each.around.clip(0, last - 1)] = True
        return folded
