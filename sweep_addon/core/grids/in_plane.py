# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep within the plane of its generator: again a planar set, of areas and, from edges along the way, of edges."""

from dataclasses import replace

import numpy as np

from ..contours.loops import COINCIDENT
from ..meshes.mesh import Mesh
from ..rings import caps
from .chart import Chart, lengths_around
from .drawn import affine, drawn
from .grid import Grid


def swept(sections, low, high):
    """What sections visit together that move along a segment in their plane.

    Parameters
    ----------
    sections : sequence of Section
    low, high : (2,) float arrays
        Where the origin of the plane begins and ends.

    Returns
    -------
    areas, lines : Section or None

    An edge sweeps a parallelogram, or if it runs along the way an edge, and so does a point. An area visits besides
    what it covers at the start and at the end.

    Examples
    --------
    >>> from ..contours import Outline
    >>> step = Outline([[(0, 0), (0, 1), (2, 1)]], closed=False).section()
    >>> areas, lines = swept([step], np.zeros(2), np.array((1.0, 0.0)))
    >>> areas.area, lines.points.tolist()
    (1.0, [[1.0, 1.0], [3.0, 1.0]])
    """
    from ..contours.planar import united  # few sweeps are within their plane

    loops, figures, curves = [], [], []
    size, distance = max(section.size for section in sections), float(np.hypot(*(high - low)))
    x, y = (high - low) / distance
    level = np.array(((x, -y), (y, x)))  # turns the way onto the x axis, where its sides are level with few others
    low, high = low @ level, high @ level
    for section in (replace(section, points=section.points @ level) for section in sections):
        if section.closed:
            for figure, place in enumerate((low, high)):
                loops += np.split(section.points + place, section.offsets[1:-1])
                figures += [figure] * (len(section.offsets) - 1)
        start, end = section.points, section.points[section.following]
        edge = np.ones(len(start), dtype=bool)
        edge[section.gaps] = np.diff(section.offsets)[: len(section.gaps)] == 1  # a point is an edge of no length
        start, end = start[edge], end[edge]
        rise = (end - start)[:, 1]
        along = np.abs(rise) <= COINCIDENT * size
        ends = np.stack((start + low, end + low, end + high, start + high), axis=1)[~along]
        ends[rise[~along] > 0] = ends[rise[~along] > 0, ::-1]
        loops += list(ends)
        figures += [2] * len(ends)
        back = (end[along, 0] < start[along, 0])[:, None]
        first, last = np.where(back, end[along], start[along]), np.where(back, start[along], end[along])
        curves += list(np.stack((first + low, last + high), axis=1))
    found = united(loops, np.array(figures, dtype=int), np.array([True, True, False]), curves, np.zeros((0, 2)))
    return tuple(section and replace(section, points=section.points @ level.T) for section in found)


def flat(section, ring, texture, named, dtype):
    """The mesh of a section that stays where it is: faces where it is closed, else loose edges and vertices.

    Parameters
    ----------
    section : Section
    ring : (3, 3) float array
        The place of its origin, and its two axes.
    texture : Texture
    named : bool
        Whether vertices have named attributes.
    dtype : numpy dtype
    """
    grid = Grid(
        rings=1,
        tips=(),
        closed=False,
        creases=(),
        offsets=tuple(section.offsets.tolist()),
        sharp=(),
        caps=(None, caps.faces(section) if section.closed else None),
        gaps=tuple(section.gaps.tolist()),
    )
    around, ends, here = lengths_around(section, np.ones(2)), (section.points, section.points), np.zeros(1)
    chart = Chart(grid, here, here, 0.0, around, ends, texture, named)
    return Mesh(drawn(grid, affine(section.points), ring[:, None], dtype), grid.topology(), chart)
