# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Roofing: the mesh of a drafted sweep whose edges vanish, part or join, and what is told of its vertices."""

from functools import cached_property

import numpy as np

from ..declared.digest import checksum
from ..declared.frozen import individual
from ..declared.options import Texture
from ..grids.chart import lengths_around
from ..meshes.mesh import Mesh

BESIDE = 0.05  # of the height: how far from the sides the caps lie in the texture


def mesh(sweep, section, roof, heights, dtype):
    """The mesh of a roof that stands on the plane of a sweep, as high and as oblique as that."""
    place = np.column_stack((roof.nodes[:, :2], np.zeros(len(roof.nodes)))) + roof.nodes[:, 2:] * sweep.way
    return Mesh(place.astype(dtype, copy=False), roof.topology, Laid(section, roof, heights, place, sweep))


@individual
class Laid:
    """Texture coordinates and attributes of a roof: each face lies flat, in true lengths, along its own edge.

    Parameters
    ----------
    section : Section
        At the contour's plane.
    roof : Roof
    heights : (n,) float array
        Where the contours of its steps stand.
    place : (v, 3) float array
        Its vertices.
    sweep : TranslationalSweep
    """

    section: object
    roof: object
    heights: np.ndarray
    place: np.ndarray
    sweep: object

    @property
    def rings(self):
        """How many contours stand along the way."""
        return len(self.heights)

    @cached_property
    def keys(self):
        """Three short texts that differ where the texture, and attributes along and across, do; empty for none."""
        texture, named = self.sweep.texture, self.sweep.attributes
        along = f"{checksum(self.u.astype(np.float32))},{checksum(self.u * self.total)}"
        across = checksum(self.v)
        told = "" if texture is Texture.NONE else texture.name + checksum(self.coordinates)
        return (told, along, across) if named else (told, "", "")

    @property
    def total(self):
        """The length of the way."""
        return float(self.heights[-1] - self.heights[0]) / self.sweep.upright

    @cached_property
    def u(self):
        """(v,) float array: which part of the way each vertex is at."""
        return (self.roof.nodes[:, 2] - self.heights[0]) / (self.heights[-1] - self.heights[0])

    @cached_property
    def source(self):
        """(c,) int array: the edge that the face of each corner is of, negative in caps."""
        return np.repeat(self.roof.source, np.diff(self.roof.topology.offsets))

    @cached_property
    def reached(self):
        """(c,) float array: where each corner of a side is along its edge, from the start of its loop round it."""
        edge = np.maximum(self.source, 0)
        section, corners = self.section, self.roof.topology.corners
        way = (section.points[section.following] - section.points) / section.edge_lengths[:, None]
        off = self.place[corners, :2] - section.points[edge]
        return self.around[edge] + np.einsum("ij,ij->i", off, way[edge])

    @cached_property
    def around(self):
        """(m,) float array: the length round the contour at each of its points."""
        loop = self.section.loop_of
        return lengths_around(self.section, np.ones(2))[np.arange(len(loop)) + loop]

    @cached_property
    def v(self):
        """(v,) float array: the length round the contour that each vertex stands over, of one of its sides."""
        found, side = np.zeros(len(self.place)), np.flatnonzero(self.source >= 0)[::-1]
        edge, corners = self.source[side], self.roof.topology.corners
        start = self.around[edge]
        found[corners[side]] = np.clip(self.reached[side], start, start + self.section.edge_lengths[edge])
        return found

    @cached_property
    def coordinates(self):
        """(c, 2) float array: texture coordinates."""
        section, edge, corners = self.section, np.maximum(self.source, 0), self.roof.topology.corners
        off = self.place[corners] - np.column_stack((section.points, np.zeros(len(section.points))))[edge]
        along = self.reached - self.around[edge]
        height = self.roof.nodes[corners, 2]
        slant = np.sqrt(np.maximum(np.einsum("ij,ij->i", off, off) - along**2, 0.0)) * np.sign(height)
        loop, perimeters = section.loop_of[edge], section.perimeters
        start = np.cumsum(perimeters) - perimeters
        left = start[loop] + perimeters[loop] - self.reached
        if self.sweep.texture is Texture.LENGTHS:
            flat = np.stack((slant - self.heights[0] / self.sweep.upright, start[loop] + left), axis=1)
        else:
            flat = np.stack((self.u[corners], left / perimeters[loop]), axis=1)
        self.lay_caps(flat)
        return flat

    def lay_caps(self, flat):
        """Lay the caps beside the sides, before their start and after their end; as a unit each has one of its own."""
        lengths, side, gap = self.sweep.texture is Texture.LENGTHS, self.source >= 0, BESIDE * self.total
        low, high = flat[side, 0].min() - gap, flat[side, 0].max() + gap
        for source, mirror, aside in ((-1, -1.0, low if lengths else 1.0), (-2, 1.0, high if lengths else 0.0)):
            some = self.source == source
            if not some.any():
                continue
            points = self.roof.nodes[self.roof.topology.corners[some], :2]
            points = points - points.min(axis=0)
            flat[some] = (points if lengths else points / points.max()) * (mirror, 1) + (aside, 0)

    def uv(self, dtype=np.float64, empty=np.empty):
        """Texture coordinates of each corner: (c, 2), or None for none; written into what ``empty`` gives."""
        if self.sweep.texture is Texture.NONE:
            return None
        found = empty(self.coordinates.size, dtype)
        found[:] = self.coordinates.ravel()
        return found.reshape(-1, 2)

    def along(self, dtype=np.float64, but=(), rooms=None):
        """Values at each vertex that depend on its height, u and arc_length, but for what is named."""
        if not self.sweep.attributes:
            return {}
        found = {}
        for name, values in (("u", self.u), ("arc_length", self.u * self.total)):
            if name not in but:
                found[name] = (rooms or {}).get(name, np.empty)(len(values), dtype)
                found[name][:] = values
        return found

    def across(self, dtype=np.float64):
        """Values at each vertex that depend on its place on the contour: v, the length round it."""
        return {"v": self.v.astype(dtype)} if self.sweep.attributes else {}
