# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The grid that a contour leaves behind: faces and edges of columns and rings, known without a search.

Columns follow the points of the section along the trajectory, rings go round at each station. Vertices lie column by
column, so that all of them come from one matrix product of the section with the axes of the stations. A ring that
has shrunk to nothing is one vertex, a tip, behind all the others, and so is a column that does not move, a pole.
"""

from functools import cached_property, lru_cache

import numpy as np

from ..declared.frozen import frozen
from ..meshes.runs import following
from .laying import build


@frozen
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
    seam : tuple of int
        The column of the first ring that each column of the last one leads to; empty where each leads to itself.
    domes : tuple of two int
        How many of the rings close the start and the end as a cap does.
    gaps : tuple of int
        The columns that no strip of faces joins to the next: the last one of an open loop, and between two poles.
    poles : tuple of int
        The columns that are one vertex, on the axis of a rotation. They have a gap between them, and then no tips.
    smooth : tuple of (int, int, tuple of int)
        From one station to another, the sharp columns that are no edges there.
    """

    rings: int
    tips: tuple
    closed: bool
    creases: tuple
    offsets: tuple
    sharp: tuple
    caps: tuple
    seam: tuple = ()
    domes: tuple = (0, 0)
    gaps: tuple = ()
    poles: tuple = ()
    smooth: tuple = ()

    @property
    def columns(self):
        return self.offsets[-1]

    @cached_property
    def lines(self):
        """The columns that are a line of vertices."""
        return np.delete(np.arange(self.columns), list(self.poles))

    @cached_property
    def strips(self):
        """The columns that a strip of faces joins to the next: from line to line, from a pole to a line, to a pole."""
        pole = np.full(self.columns, False)
        pole[list(self.poles)] = True
        start = np.delete(np.arange(self.columns), list(self.gaps))
        own, ahead = pole[start], pole[self.following[start]]
        return start[~own & ~ahead], start[own], start[ahead]

    @cached_property
    def whole(self):
        """The stations whose ring is a ring."""
        whole = np.full(self.rings, True)
        whole[list(self.tips)] = False
        return np.flatnonzero(whole)

    @cached_property
    def following(self):
        return following(np.array(self.offsets))

    def bands(self):
        """Pairs of neighbouring stations (b, 2), and which bands have a tip below and above; not to be written into."""
        return bands(self)

    def topology(self):
        """The faces and edges, made once for equal grids."""
        return build(self)


@lru_cache(maxsize=8)
def bands(grid):
    """The bands of a grid, made once for equal ones: each change of a slider asks for them again."""
    start = np.arange(grid.rings if grid.closed else grid.rings - 1)
    pairs = np.stack((start, (start + 1) % grid.rings), axis=1)
    tip = np.full(grid.rings, False)
    tip[list(grid.tips)] = True
    pinched = tip[pairs]
    pairs.setflags(write=False)
    pinched.setflags(write=False)
    return pairs, pinched[:, 0], pinched[:, 1]
