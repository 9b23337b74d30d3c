# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The grid that a contour leaves behind: faces, edges and texture of columns and rings, known without a search.

Columns follow the points of the section along the trajectory, rings go round at each station. Vertices lie column by
column, so that all of them come from one matrix product of the section with the axes of the stations. A ring that
has shrunk to nothing is one vertex, a tip, behind all the others.
"""

import zlib
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from .mesh import Topology

SIDE, CAP = 0, 1  # material slots


@dataclass(frozen=True)
class Grid:
    """What decides the topology of a sweep; equal grids share their arrays.

    Parameters
    ----------
    rings : int
        Number of stations.
    tips : tuple of int
        The stations where the contour has shrunk to a point.
    closed : bool
        Whether the last ring leads to the first.
    creases : tuple of int
        The stations where the surface has an edge all round, as at a mitre.
    offsets : tuple of int
        Where each loop of the section starts, and their end.
    sharp : tuple of int
        The columns that are edges.
    caps : tuple of two ((tuple of int, tuple of int) or None)
        The faces that close the start and the end: point numbers of the section, and where each face starts.
    """

    rings: int
    tips: tuple
    closed: bool
    creases: tuple
    offsets: tuple
    sharp: tuple
    caps: tuple

    @property
    def columns(self):
        return self.offsets[-1]

    @property
    def whole(self):
        """The stations whose ring is a ring."""
        return np.setdiff1d(np.arange(self.rings), self.tips)

    @property
    def following(self):
        following = np.arange(1, self.columns + 1)
        following[np.array(self.offsets[1:]) - 1] = self.offsets[:-1]
        return following

    def bands(self):
        """Pairs of neighbouring stations (b, 2), and which bands have a tip below and above."""
        start = np.arange(self.rings if self.closed else self.rings - 1)
        pairs = np.stack((start, (start + 1) % self.rings), axis=1)
        pinched = np.isin(pairs, self.tips)
        return pairs, pinched[:, 0], pinched[:, 1]

    def topology(self):
        """The faces and edges, made once for equal grids."""
        return build(self)


@lru_cache(maxsize=4)
def build(grid):
    columns, following = grid.columns, grid.following.astype(np.int32)
    whole, column = grid.whole, np.arange(grid.columns, dtype=np.int32)
    rings, pairs = len(whole), grid.bands()[0]
    position = np.zeros(grid.rings, np.int32)
    position[whole] = np.arange(rings)
    position[list(grid.tips)] = columns * rings + np.arange(len(grid.tips))
    stride = np.full(grid.rings, rings, np.int32)
    stride[list(grid.tips)] = 0

    def vertex(columns, stations):
        return columns[:, None] * stride[stations] + position[stations]

    bands = len(pairs)
    along = column[:, None] * np.int32(bands) + np.arange(bands, dtype=np.int32)
    around = np.int32(columns * bands) + column[:, None] * np.int32(rings) + np.arange(rings, dtype=np.int32)
    edges = np.empty((columns * (bands + rings), 2), np.int32)
    edges[: columns * bands].reshape(columns, bands, 2)[...] = np.stack(
        (vertex(column, pairs[:, 0]), vertex(column, pairs[:, 1])), axis=-1
    )
    edges[columns * bands :].reshape(columns, rings, 2)[...] = np.stack(
        (vertex(column, whole), vertex(following, whole)), axis=-1
    )
    sides = list(side_faces(grid, vertex, along, around, following))
    caps, inner = cap_faces(grid, vertex, around, len(edges))
    faces = sides + caps
    sizes = np.concatenate(
        [np.full(len(corners) // size, size) if np.isscalar(size) else size for corners, _, size in faces]
    )
    material = np.full(len(sizes), SIDE, np.int32)
    material[sum(len(corners) // size for corners, _, size in sides) :] = CAP
    return Topology(
        corners=np.concatenate([corners for corners, _, _ in faces]),
        offsets=np.concatenate(([0], np.cumsum(sizes))).astype(np.int32),
        edges=np.concatenate((edges, inner)),
        corner_edges=np.concatenate([used for _, used, _ in faces]),
        sharp=sharp_edges(grid, along, around, len(edges) + len(inner)),
        material=material,
    )


def side_faces(grid, vertex, along, around, following):
    """The corners of the faces between rings, the edge that starts at each corner, and how many a face has."""
    column = np.arange(grid.columns, dtype=np.int32)
    pairs, below, above = grid.bands()
    ring = np.full(grid.rings, -1)
    ring[grid.whole] = np.arange(len(grid.whole))

    def faces(bands, *corners):
        """Corners given as (which column, which end of the band, the edge that starts there)."""
        low, high = pairs[bands].T
        stations = (low, high)
        shape = (grid.columns, len(bands), len(corners))
        points, used = np.empty(shape, np.int32), np.empty(shape, np.int32)
        for i, (columns, end, edge) in enumerate(corners):
            points[..., i] = vertex(columns, stations[end])
            used[..., i] = {
                "low": lambda: around[:, ring[low]],
                "up": lambda: along[following][:, bands],
                "high": lambda: around[:, ring[high]],
                "down": lambda: along[:, bands],
            }[edge]()
        return points.ravel(), used.ravel(), len(corners)

    quads, cones, funnels = (np.flatnonzero(chosen) for chosen in (~below & ~above, above & ~below, below & ~above))
    yield faces(quads, (column, 0, "low"), (following, 0, "up"), (following, 1, "high"), (column, 1, "down"))
    if len(cones):
        yield faces(cones, (column, 0, "low"), (following, 0, "up"), (column, 1, "down"))
    if len(funnels):
        yield faces(funnels, (column, 0, "up"), (following, 1, "high"), (column, 1, "down"))


def cap_faces(grid, vertex, around, first_inner):
    """The faces at the ends, and the edges inside them."""
    faces, inner = [], [np.empty((0, 2), np.int32)]
    following = grid.following
    for cap, station, turn in zip(grid.caps, (0, grid.rings - 1), (-1, 1), strict=True):
        if cap is None:
            continue
        points, offsets = (np.array(part) for part in cap)
        face = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
        if turn < 0:  # the same faces seen from the other side
            points = points[offsets[face] + offsets[face + 1] - 1 - np.arange(len(points))]
        last = np.arange(len(points)) == offsets[face + 1] - 1
        ahead = points[np.where(last, offsets[face], np.arange(1, len(points) + 1))]
        ring = 0 if station == 0 else around.shape[1] - 1
        used = np.where(following[points] == ahead, around[points, ring], around[ahead, ring])
        crossing = (following[points] != ahead) & (following[ahead] != points)
        ends = np.sort(np.stack((points, ahead), axis=1)[crossing], axis=1)
        unique, which = np.unique(ends, axis=0, return_inverse=True)
        used[crossing] = first_inner + sum(map(len, inner)) + which.ravel()
        inner.append(vertex(unique.ravel(), np.array([station])).reshape(-1, 2).astype(np.int32))
        corners = vertex(points, np.array([station])).ravel().astype(np.int32)
        faces.append((corners, used.astype(np.int32), np.diff(offsets)))
    return faces, np.concatenate(inner)


def sharp_edges(grid, along, around, count):
    """Edges along the corners of the contour, round the mitres and round the caps."""
    sharp = np.zeros(count, bool)
    sharp[along[list(grid.sharp)]] = True
    rims = [station for station, cap in zip((0, grid.rings - 1), grid.caps, strict=True) if cap is not None]
    sharp[around[:, np.isin(grid.whole, [*grid.creases, *rims])]] = True
    return sharp


@dataclass(frozen=True, eq=False)
class Chart:
    """Where on a sweep its vertices and corners lie: the source of texture coordinates and named attributes.

    Parameters
    ----------
    grid : Grid
    u : (n,) float array
        The trajectory's parameter at each station.
    s : (n,) float array
        The arc length at each station, in metres.
    total : float
        The arc length of the whole trajectory, where a closed one meets itself again.
    around : (m + k,) float array
        The length round the contour at each point, loop after loop, each loop with its end.
    ends : tuple of two (m, 2) float arrays
        The section as it stands at the start and at the end, in metres.
    """

    grid: Grid
    u: np.ndarray
    s: np.ndarray
    total: float
    around: np.ndarray
    ends: tuple

    @property
    def keys(self):
        """Two short texts that differ where what is known along the trajectory or round the contour differs."""
        return short_text(self.u, self.s), short_text(self.around, *self.ends)

    @property
    def rings(self):
        """How many contours stand along the trajectory."""
        return self.grid.rings

    def columns(self):
        """The length round the contour where each column's face starts and where it ends: two (m,)."""
        offsets = np.array(self.grid.offsets)
        loop = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
        start = np.arange(self.grid.columns) + loop
        return self.around[start], self.around[start + 1]

    def uv(self, dtype=np.float64):
        """Texture coordinates (c, 2) of each corner in metres: along the trajectory, round the contour."""
        grid = self.grid
        pairs, below, above = grid.bands()
        low, high = self.s[pairs].T
        high = np.where(high > low, high, self.total)
        left, right = (side[:, None] for side in self.columns())
        parts = []
        for chosen, corners in (
            (~below & ~above, ((low, left), (low, right), (high, right), (high, left))),
            (above & ~below, ((low, left), (low, right), (high, (left + right) / 2))),
            (below & ~above, ((low, (left + right) / 2), (high, right), (high, left))),
        ):
            along = np.stack([along[chosen] for along, _ in corners], axis=-1)
            part = np.empty((grid.columns, *along.shape, 2), dtype)
            part[..., 0] = along
            for i, (_, across) in enumerate(corners):
                part[:, :, i, 1] = across
            parts.append(part.reshape(-1, 2))
        return np.concatenate((*parts, *self.cap_uv(dtype)))

    def cap_uv(self, dtype):
        """The caps lie flat beside the strip, before its start and after its end."""
        margin = 0.05 * self.total
        for cap, section, end in zip(self.grid.caps, self.ends, (0, 1), strict=True):
            if cap is None:
                continue
            points, offsets = (np.array(part) for part in cap)
            flat = section - section.min(axis=0)
            if end == 0:
                face = np.repeat(np.arange(len(offsets) - 1), np.diff(offsets))
                points = points[offsets[face] + offsets[face + 1] - 1 - np.arange(len(points))]
                flat = flat * (-1, 1) - (margin, 0)
            else:
                flat = flat + (self.total + margin, 0)
            yield flat[points].astype(dtype)

    def along(self, dtype=np.float64):
        """Values at each vertex that depend on its station: u and arc_length."""
        whole, tips = self.grid.whole, list(self.grid.tips)

        def by_ring(values):
            values = values.astype(dtype)
            return np.concatenate((np.tile(values[whole], self.grid.columns), values[tips]))

        return {"u": by_ring(self.u), "arc_length": by_ring(self.s)}

    def across(self, dtype=np.float64):
        """Values at each vertex that depend on its place on the contour: v, the length round it."""
        start, _ = self.columns()
        v = np.repeat(start.astype(dtype), len(self.grid.whole))
        return {"v": np.concatenate((v, np.zeros(len(self.grid.tips), dtype)))}


def short_text(*arrays):
    """A few digits that differ where arrays differ."""
    return "".join(f"{zlib.crc32(np.ascontiguousarray(array).data):08x}" for array in arrays)


def lengths_around(section, scale):
    """The length round a section at each point, loop after loop, each loop with its end: (m + k,) float array.

    The loops lie side by side, none over another; scale, (2,), stretches the section's axes.
    """
    edges = np.linalg.norm((section.points[section.following] - section.points) * scale, axis=1)
    reached = np.concatenate(([0.0], np.cumsum(edges)))
    parts = [reached[start : end + 1] for start, end in zip(section.offsets[:-1], section.offsets[1:], strict=True)]
    return np.concatenate(parts)
