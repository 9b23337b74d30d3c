# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The chart of a sweep: texture coordinates and named attributes, from a few numbers for each ring and column."""

from functools import cached_property

import numpy as np

from ..declared.digest import checksum
from ..declared.frozen import individual
from ..declared.options import Texture
from ..meshes.runs import backward, run_of
from ..vectors import added
from .grid import Grid


@individual
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
    texture : Texture
    named : bool
        Whether vertices have named attributes.
    """

    grid: Grid
    u: np.ndarray
    s: np.ndarray
    total: float
    around: np.ndarray
    ends: tuple
    texture: Texture = Texture.LENGTHS
    named: bool = True

    @cached_property
    def keys(self):
        """Three short texts that differ where the texture, and attributes along and across, do; empty for none.

        That of the attributes along has a part for each of them, so that one may stay where the other changes.
        """
        if self.texture is Texture.NONE and not self.named:
            return "", "", ""
        u = checksum(self.u.astype(np.float32))  # as Blender keeps it: where lengths change, rounding alone changes u
        along, across = f"{u},{checksum(self.s)}", checksum(self.around, *self.ends)
        texture = "" if self.texture is Texture.NONE else self.texture.name + along + across
        return (texture, along, across) if self.named else (texture, "", "")

    @property
    def rings(self):
        """How many contours stand along the trajectory."""
        return self.grid.rings

    @property
    def extent(self):
        """From which arc length the texture goes to which, with a dome beyond the path: two floats."""
        return self.s[0], max(self.total, self.s[-1])

    def columns(self):
        """The length round the contour where each column's face starts and where it ends: two (m,)."""
        offsets = np.array(self.grid.offsets)
        loop = run_of(offsets)
        start = np.arange(self.grid.columns) + loop
        return self.around[start], self.around[start + 1]

    def uv(self, dtype=np.float64, empty=np.empty):
        """Texture coordinates of each corner, along the trajectory and round the contour: (c, 2), or None for none.

        They are written into what ``empty`` gives for a number of elements and a dtype.
        """
        if self.texture is Texture.NONE:
            return None
        _, below, above = self.grid.bands()
        low, high, left, right = self.strip()
        sides = np.stack((left, right), axis=1).astype(dtype)
        sides = [np.ascontiguousarray(sides[columns]) for columns in self.grid.strips]
        middle, every = (low + high) / 2, np.full(len(low), True)
        kinds = (
            (sides[0], ~below & ~above, (low, low, high, high), (0, 1, 1, 0)),
            (sides[0], above & ~below, (low, low, high), (0, 1, 0.5)),
            (sides[0], below & ~above, (low, high, high), (0.5, 1, 0)),
            (sides[1], every, (middle, low, high), (0, 1, 1)),
            (sides[2], every, (low, middle, high), (0, 1, 0)),
        )
        kinds = [(*kind, np.count_nonzero(kind[1])) for kind in kinds if len(kind[0])]
        caps = list(self.cap_uv(dtype))
        corners = sum(2 * len(sides) * len(shares) * bands for sides, *_, shares, bands in kinds)
        uv = empty(corners + sum(cap.size for cap in caps), dtype)
        start = 0
        for sides, chosen, along, shares, bands in kinds:
            rows, across = np.zeros((bands, len(shares), 2), dtype), np.zeros((2, len(shares), 2), dtype)
            for corner, end in enumerate(along):
                rows[:, corner, 0] = end if bands == len(end) else end[chosen]
            across[..., 1] = 1 - np.array(shares), shares
            width = 2 * len(shares)
            part = uv[start : start + len(sides) * bands * width].reshape(len(sides), bands, width)
            added(sides, across.reshape(2, width), rows.reshape(bands, width), part)
            start += part.size
        uv[start:] = np.concatenate([np.empty(0, dtype), *(cap.ravel() for cap in caps)])
        return uv.reshape(-1, 2)

    def strip(self):
        """Where each band starts and ends along the texture, two (b,), and each column's face across it, two (m,).

        Across it a loop is measured from its end, or pictures would be seen in a mirror.
        """
        low, high = self.s[self.grid.bands()[0]].T
        high = np.where(high > low, high, self.total)
        offsets = np.array(self.grid.offsets)
        loop = run_of(offsets)
        start, end = self.around[offsets[loop] + loop], self.around[offsets[loop + 1] + loop]
        left, right = (end - side for side in self.columns())
        if self.texture is Texture.LENGTHS:
            return low, high, start + left, start + right
        first, last = self.extent
        low, high = (low - first) / (last - first), (high - first) / (last - first)
        return low, high, left / (end - start), right / (end - start)

    def cap_uv(self, dtype):
        """The caps lie flat beside the strip, before its start and after its end; as a unit each has one of its own."""
        lengths = self.texture is Texture.LENGTHS
        gap, (first, last) = 0.05 * self.total, self.extent
        before, after = (min(first, 0.0) - gap, max(last, self.total) + gap) if lengths else (1.0, 0.0)
        for cap, section, end in zip(self.grid.caps, self.ends, (0, 1), strict=True):
            if cap is None:
                continue
            points, offsets = (np.array(part) for part in cap)
            flat = section - section.min(axis=0)
            flat = flat if lengths else flat / flat.max()
            if end == 0:
                points = points[backward(offsets)]
                flat = flat * (-1, 1) + (before, 0)
            else:
                flat = flat + (after, 0)
            yield flat[points].astype(dtype)

    def along(self, dtype=np.float64, but=(), rooms=None):
        """Values at each vertex that depend on its station: u and arc_length, but for what is named.

        They are written into what ``rooms`` has for their names, which takes a number of elements and a dtype.
        """
        if not self.named:
            return {}
        whole, tips = self.grid.whole, list(self.grid.tips)
        return {
            name: self.spread(values[whole], values[tips], values[0], dtype, (rooms or {}).get(name, np.empty))
            for name, values in (("u", self.u), ("arc_length", self.s))
            if name not in but
        }

    def across(self, dtype=np.float64):
        """Values at each vertex that depend on its place on the contour: v, the length round it."""
        if not self.named:
            return {}
        start, _ = self.columns()
        return {"v": self.spread(start[self.grid.lines, None], 0.0, start[list(self.grid.poles)], dtype)}

    def spread(self, lines, tips, poles, dtype, empty=np.empty):
        """A value at each vertex, from one for each ring or each column of lines, one at tips and one at poles."""
        shape = len(self.grid.lines), len(self.grid.whole)
        parts = np.cumsum((shape[0] * shape[1], len(self.grid.tips), len(self.grid.poles)))
        values = empty(parts[-1], dtype)
        values[: parts[0]].reshape(shape)[:] = lines
        values[parts[0] : parts[1]], values[parts[1] :] = tips, poles
        return values


def lengths_around(section, scale):
    """The length round a section at each point, loop after loop, each loop with its end: (m + k,) float array.

    The loops lie side by side, none over another; scale, (2,), stretches the section's axes.
    """
    edges = np.linalg.norm((section.points[section.following] - section.points) * scale, axis=1)
    edges[section.gaps] = 0.0
    reached = np.concatenate(([0.0], np.cumsum(edges)))
    parts = [reached[start : end + 1] for start, end in zip(section.offsets[:-1], section.offsets[1:], strict=True)]
    return np.concatenate(parts)
