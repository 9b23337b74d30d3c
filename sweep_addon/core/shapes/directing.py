# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directing: from the parameters of a PD curve sweep to its contours between the limits, and its mesh."""

from dataclasses import replace
from functools import lru_cache
from math import radians

import numpy as np

from ..contours import Fit
from ..contours.section import section_of
from ..declared.parameters import Array, ShapeError, at, require
from ..declared.wording import shown
from ..grids.chart import Chart, lengths_around
from ..grids.drawn import affine, drawn
from ..grids.grid import Grid
from ..meshes.mesh import Mesh, require_few
from ..rings import caps
from ..rings.limits import Open, Plane
from ..rings.steps import told_backward
from ..self_intersection.folds import folds_told, running_backward
from ..stations.bending import Bending, Rings
from ..stations.cells import WIDEST_TURN
from ..stations.coarseness import told_coarse
from ..stations.frames import Frames, require_several, turn
from ..stations.sampling import Count, place
from ..trajectories.arc_length import arc_length
from ..vectors import norms

COARSE, FINEST = 1e-3, 1e-6  # of the contour: how far from the cut the edge of a cap may be where samples do not say
CORNER = radians(1)  # a turn of less leaves the cross-section constant to a 25,000th


def surface(sweep, dtype):
    """The surface that the contour leaves, also where it meets itself: a `Mesh`."""
    section, bending, stations, told = laid_out(sweep)
    rings = rings_of(sweep, section, bending, stations)
    section = rings.section
    grid = Grid(
        rings=len(rings.s),
        tips=(),
        closed=stations.closed,
        creases=(),
        offsets=tuple(section.offsets.tolist()),
        sharp=tuple(np.flatnonzero(section.sharp).tolist()),
        caps=tuple(
            caps.faces(end) if end.closed and not (stations.closed or isinstance(limit, Open)) else None
            for limit, end in zip((sweep.start, sweep.end), rings.ends, strict=True)
        ),
        gaps=tuple(section.gaps.tolist()),
    )
    vertices = drawn(grid, affine(section.points), rings.axes, dtype)
    flat, around = tuple(end.points for end in rings.ends), lengths_around(section, np.ones(2))
    chart = grid, rings.u, rings.s, stations.total, around, flat, sweep.texture, sweep.attributes
    if not any(rings.leaning):
        return Mesh(vertices, grid.topology(), Chart(*chart), told)
    from ..grids.leaning import Leaning, standing  # of a plane

    columns = vertices.reshape(len(section.points), -1, 3)
    for own, which in standing(rings.leaning, len(rings.s)):
        for axis in range(3):  # so NumPy goes along the rings, and not three numbers at a time
            columns[:, which, axis] = rings.lines[:, axis, own]
    return Mesh(vertices, grid.topology(), Leaning(*chart, rings.leaning, rings.heights, rings.lines[:, 3]), told)


def laid_out(sweep):
    """The section, the bending of the axis, its stations, and what is to be told.

    Where the contour is beyond the centre of curvature everywhere, and so runs backward, it is seen in a mirror.
    """
    section, told = section_of(sweep.contour, Fit.INSCRIBED), sweep.trajectory.told
    with at("trajectory"):
        total = arc_length(sweep.trajectory).total
        require_smooth(sweep.trajectory)
    if sweep.trajectory.closed and any(isinstance(limit, Plane) for limit in (sweep.start, sweep.end)):
        told += ("Limits: a closed trajectory has no ends, so no plane cuts anything off.",)
    bending = Bending(sweep.trajectory, sweep.direction, total)
    reach = 0.0 if isinstance(sweep.samples, Count) else float(np.linalg.norm(section.points, axis=1).max())
    with at("direction"):
        stations = stand(sweep.samples, sweep.trajectory, sweep.direction, reach)
        axis = bending.placed(stations)
    rings = bending.axes(stations)
    backward = running_backward(stations, rings, section.centroid, False)
    told += told_coarse(stations, sweep.samples, reach) + told_backward(stations)
    told += folds_told(stations, np.zeros_like(axis.points), axis.e2, axis.e3, section.support)
    told += axis.told
    if backward:
        section, bending = section.mirrored, replace(bending, mirrored=True)
    return section, bending, stations, told


def rings_of(sweep, section, bending, stations):
    """The rings between the limits: `Rings`."""
    limits = sweep.start, sweep.end
    if stations.closed or not any(isinstance(limit, Plane) for limit in limits):
        require_few(len(section.points) * len(stations.s), "samples")
        return Rings(section, stations.u, stations.s, bending.axes(stations), (section, section))
    from ..rings.trimming import trimmed  # most sweeps have no plane

    size = float(np.abs(section.points).max())
    chord = COARSE * size if isinstance(sweep.samples, Count) else sweep.samples.chord
    return trimmed(limits, bending, section, stations, max(chord, FINEST * size))


def bend(sweep, points):
    """Points of a straight model on the curved axis; `PDCurveSweep.bend` says how."""
    try:
        points = Array(points).values
    except (TypeError, ValueError):
        raise ShapeError(f"must be rows of 3 numbers, got {shown(points)}", "points") from None
    require(points.ndim == 2 and points.shape[1] == 3, "must be (n, 3)", points.shape, "points")
    require(np.isfinite(points).all(), "must be finite", points[~np.isfinite(points)][:1].tolist(), "points")
    _, bending, _, _ = laid_out(sweep)
    return replace(bending, mirrored=False).bend(points)


def frames(sweep, most):
    """The frames and contours at some places; `PDCurveSweep.frames` says which."""
    require_several(most)
    section, bending, _, _ = laid_out(sweep)
    steps = bending.total / float(np.linalg.norm(section.points, axis=1).max())
    stations = place(sweep.trajectory, Count(int(np.clip(steps + (not sweep.trajectory.closed), 2, most))))
    axis, rings = bending.placed(stations), bending.axes(stations)
    loops = tuple(np.split(np.einsum("mk,kni->nmi", affine(section.points), rings), section.offsets[1:-1], axis=1))
    return Frames(stations.u, stations.s, axis.points, axis.e1, axis.e2, axis.e3, loops)


@lru_cache(maxsize=16)
def require_smooth(trajectory):
    """Refuse corners that can be seen: handles in single precision are not quite in line."""
    corners = trajectory.corners()
    reached = np.where(corners == trajectory.domain[0], trajectory.domain[1], corners)
    turns = norms(trajectory.tangents(corners) - trajectory.tangents(reached, before=True))
    seen = corners[turns > CORNER]
    if len(seen):
        raise ShapeError(f"must be smooth, or its corners round, got a corner at u = {seen[0]:.6g}")


@lru_cache(maxsize=16)
def stand(samples, trajectory, direction, reach):
    """The stations of a sweep, close enough for the turning of its frame too; the same for contours of one reach."""

    def steps(s, u, chord):
        rate = np.gradient(np.interp(s, *turn(direction, trajectory)), s)
        return np.maximum(np.sqrt(reach * rate**2 / (8 * chord)), np.abs(rate) / WIDEST_TURN)

    return place(trajectory, samples, (), steps)
