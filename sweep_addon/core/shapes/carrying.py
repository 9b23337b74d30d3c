# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Carrying: from the parameters of a generalized cylinder to its contours where they stand, and its mesh."""

from dataclasses import replace
from functools import lru_cache
from math import cos, radians, tau

import numpy as np

from ..contours import Fit
from ..contours.section import section_of
from ..declared.parameters import at, require
from ..grids.chart import Chart, lengths_around
from ..grids.drawn import affine, drawn
from ..grids.grid import Grid
from ..later import later
from ..meshes.mesh import Mesh, require_few
from ..rings import caps
from ..rings.body import Body, Swept
from ..rings.domes import domes_of, with_domes
from ..rings.ends import Flat, Round, Taper
from ..rings.steps import mitred, told_backward
from ..self_intersection.folds import folds_told, running_backward
from ..stations.coarseness import told_coarse
from ..stations.frames import Frames, RotationMinimizing, axes, require_several
from ..stations.leaps import leaping_steps, leaps
from ..stations.sampling import Count, place
from ..trajectories.arc_length import arc_length
from ..variation.along import Along, tapers, tips
from ..vectors import dot

# What few sweeps need: closed ones, and those with corners, rails or another fit.
closing = later("core.rings.closing")
enclosing, halfway = later("core.rings.enclosing", "enclosing", "halfway")
fanned = later("core.rings.bevels", "fanned")
leaned = later("core.rings.mitres", "leaned")
Rails = later("core.variation.rails", "Rails")
volume_true = later("core.rings.volume_true", "volume_true")

ROUNDING = 1e-12  # of the trajectory's coordinates: rounding leaves nothing of a smaller contour
CREASE = cos(radians(20))  # a mitre that turns more than this has an edge all round


def surface(sweep, dtype, empty):
    """The surface as a mesh; `GeneralizedCylinder.surface` says of what."""
    found = swept(sweep)
    grid = found.chart.grid
    topology = grid.topology()
    vertices = drawn(grid, affine(found.shape), found.rings, dtype, empty)
    return Mesh(vertices, topology, found.chart, found.told)


def swept(sweep, stations=None):
    """All that the mesh is drawn from: a `Swept`, with contours at its own stations or at others."""
    (section, change), closed = moving(sweep), sweep.trajectory.closed
    ends = (Flat(), Flat()) if closed else (sweep.start, sweep.end)
    along, symmetry, reach, told = laid_out(sweep, section, change, ends)
    stations = stations or stand(sweep.samples, along.unchanging(), 0.0 if along.is_constant else reach)
    sectors = closing.sectors(along.rails or sweep.frame, along, symmetry) if closed else 0
    body = carried(sweep, section, along, stations, symmetry, tau * sectors / symmetry)
    true = body.ends if sweep.fit is Fit.INSCRIBED else (section_of(sweep.contour, Fit.INSCRIBED),) * 2
    domes = domes_of(ends, body, true, sweep.samples, sweep.fit)
    vertices = (len(stations.s) + sum(map(len, domes))) * len(section.points)
    require_few(vertices, "samples")
    rings, shape = body.rings, body.section.points
    if sweep.fit is Fit.CIRCUMSCRIBED:
        true = halfway(stations, along.rails or sweep.frame, along, symmetry)
        least = np.where(body.tips, 0.0, np.abs(body.scales).min(axis=1))
        leaping = leaping_steps(along.frame, stations)
        rings, shape = enclosing(stations, rings, true, body.section, least, tau * sectors / symmetry, leaping)
    rings, points, u, s = with_domes(domes, stations, rings, body)
    change, scale = body.change, np.abs(body.scales[~body.tips] if body.tips.any() else body.scales).mean(axis=0)
    if change:
        rings, shape = change.carried(rings, s / stations.total), change.shape
    grid = Grid(
        rings=len(s),
        tips=tuple(np.flatnonzero(points).tolist()),
        closed=closed,
        creases=creases(stations, along, len(domes[0])),
        offsets=tuple(body.section.offsets.tolist()),
        sharp=tuple(np.flatnonzero(change.sharp if change else body.section.sharp).tolist()),
        caps=caps.at_ends(body.ends, ends, (closed or points[0], closed or points[-1])),
        seam=closing.seam(body.section, sectors, symmetry) if closed else (),
        domes=tuple(map(len, domes)),
        gaps=tuple(body.section.gaps.tolist()),
        smooth=change.smooth(s / stations.total) if change else (),
    )
    around = change.around(scale, stations.t) if change else lengths_around(body.section, scale)
    flat = tuple(body.ends[station].points * body.scales[station] for station in (0, -1))
    told += told_coarse(stations, sweep.samples, reach * along.largest) + told_backward(stations) + body.told
    chart = Chart(grid, u, s, stations.total, around, flat, sweep.texture, sweep.attributes)
    return Swept(stations, along, symmetry, body, rings, shape, points, chart, told)


def moving(sweep):
    """The section that starts the sweep, and what it becomes; `GeneralizedCylinder.moving` says as what."""
    if not sweep.morph:
        return section_of(sweep.contour, sweep.fit), None
    from ..variation.changing import changing, require_inscribed  # most contours stay as they are

    require_inscribed(sweep.fit)
    change = changing(sweep.contour, sweep.morph, sweep.match, sweep.blend, bool(sweep.trajectory.closed))
    return change.sections[0], change


def laid_out(sweep, section, change, ends):
    """The laws of the sweep and what they leave; `GeneralizedCylinder.laid_out` says what."""
    told, reach = sweep.trajectory.told + (change.told if change else ()), farthest(section, change)
    if sweep.rails and sweep.frame != RotationMinimizing():
        told += ("Frame: the rails turn the contour, and no frame.",)
    if sweep.trajectory.closed and any(isinstance(end, (Taper, Round)) for end in (sweep.start, sweep.end)):
        told += ("Ends: a closed trajectory has none, so nothing tapers and nothing is round.",)
    along, symmetry = laws(sweep, section, change, ends)
    along, limit = bevelled(along, reach)
    return along, symmetry, reach, told + limit


def laws(sweep, section, change, ends):
    """The laws of the sweep, and in how many turns the section is mapped to itself as they leave it."""
    with at("trajectory"):
        arc_length(sweep.trajectory)
    changing = (sweep.scale_x, sweep.scale_y, sweep.twist, sweep.offset_x, sweep.offset_y)
    along = Along(sweep.trajectory, *changing, tapers(*ends))
    if sweep.rails:
        rails = Rails(tuple(rail.path for rail in sweep.rails), sweep.guided, section, change)
        return replace(along, frame=rails, change=change, rails=rails), 1
    turns = change is None and (sweep.trajectory.closed or sweep.frame.extra_sectors)
    symmetry = along.symmetry(section) if turns else 1
    frame = None if isinstance(sweep.frame, RotationMinimizing) else sweep.frame
    return replace(along, spin=sweep.frame.extra(symmetry), frame=frame, change=change), symmetry


def bevelled(along, reach):
    """The laws along a path whose mitres beyond their limit are bevelled, and a sentence that says so."""
    if not len(along.trajectory.too_sharp):
        return along, ()
    path, limit = along.trajectory.limited(along.farthest(reach))
    return replace(along, trajectory=path), (limit,)


@lru_cache(maxsize=16)
def stand(samples, along, reach):
    """The stations of a sweep, the same for all contours of one reach."""
    return place(along.trajectory, samples, *along.asks(reach))


@lru_cache(maxsize=16)
def farthest(section, change):
    """How far a section, or any that it becomes, reaches from its reference point, in metres."""
    return float(np.linalg.norm(change.points if change else section.points, axis=-1).max())


def carried(sweep, section, along, stations, symmetry, turn):
    """The section carried by the frame to every station: a `Body`; it meets itself turned by that angle."""
    scale_x, scale_y, twist, *offset = along.at(stations.s, stations.u)
    points, mirrored = tips(scale_x, scale_y, along.largest, stations.closed, along.scaled_by)
    e2, e3, told = axes(along.rails or sweep.frame, stations, twist, symmetry)
    rings = across(offset, e2, e3), e2 * scale_x[:, None], e3 * scale_y[:, None]
    change, centroid = along.change, section.centroid
    if change:
        centroid = change.centroids(stations.t)
        weighted = (change.weighted(axis, stations.t) for axis in rings[1:])
        told += folds_told(stations, rings[0], *weighted, change.support)
    else:
        longest = np.abs((scale_x, scale_y)).max()
        told += folds_told(stations, *rings, getattr(sweep.contour, "support", section.support), longest)
    if sweep.fit is Fit.AREA_TRUE:
        rings = volume_true(stations, rings, along, section.centroid, turn, farthest(section, change))
    else:
        # enclosing what a law changes over a lean would make the mesh bulge there
        leaning = farthest(section, change) if along.keeps_legs or sweep.fit is Fit.INSCRIBED else 0.0
        rings = placed(stations, leaning, *rings)
    reach = farthest(section, change) * along.largest
    least = ROUNDING * np.abs(rings[0]).max()
    require(reach >= least, f"must reach {least:.3g} m or more on this trajectory", reach, "contour")
    backward = running_backward(stations, rings, centroid, any(map(np.any, offset)))
    if mirrored != backward:
        scale_x, rings[1] = -scale_x, -rings[1]
        change = change and change.mirrored
        section = change.sections[0] if change else section.mirrored
    return Body(section, change, rings, np.stack((scale_x, scale_y)).T, points, backward, told)


def placed(stations, reach, aside, x, y):
    """The middle of each contour and its axes as they are drawn, mitred at the corners: (3, n, 3).

    A contour that reaches so far leans where it stands close to a mitre; 0 leaves it perpendicular.
    """
    rings = np.stack((aside, x, y))
    corners = stations.corners
    if len(corners):
        bevels, fans = fanned(stations, rings)
        rings = leaned(stations, rings, reach) if reach else rings
        rings[:, corners] = mitred(rings[:, corners], stations.arrive[corners], stations.leave[corners])
        rings[:, bevels] = fans
    rings[0] += stations.points
    return rings


def across(offset, e2, e3):
    """The way of each contour off the trajectory: (n, 3)."""
    x, y = offset
    return e2 * x[:, None] + e3 * y[:, None] if x.any() or y.any() else np.zeros_like(e2)


def creases(stations, along, before):
    """The rings where a mitre, morph or frame turns so much that it is an edge; some stand before the first station."""
    turn = dot(stations.arrive[stations.corners], stations.leave[stations.corners])
    edges = stations.corners[turn < CREASE]
    leaping = leaps(along.frame, along.trajectory)
    if len(leaping):
        edges = np.union1d(edges, np.abs(stations.s - leaping.reshape(-1, 1)).argmin(axis=1))
    if along.change:
        met = along.change.creases(stations.total, along.largest)
        edges = np.union1d(edges, np.abs(stations.t - met[:, None]).argmin(axis=1))
    return tuple((before + edges).tolist())


def frames(sweep, most):
    """The frames and contours at some places; `GeneralizedCylinder.frames` says which."""
    (section, change), closed = moving(replace(sweep, fit=Fit.INSCRIBED)), sweep.trajectory.closed
    require_several(most)
    ends = (Flat(), Flat()) if closed else (sweep.start, sweep.end)
    along, symmetry, reach, _ = laid_out(sweep, section, change, ends)
    steps = arc_length(along.trajectory).total / max(reach * along.largest, ROUNDING)
    stations = place(along.trajectory, Count(int(np.clip(steps + (not closed), 2, most))))
    scale_x, scale_y, twist, *offset = along.at(stations.s, stations.u)
    e2, e3, _ = axes(along.rails or sweep.frame, stations, twist, symmetry)
    rings = placed(stations, reach, across(offset, e2, e3), e2 * scale_x[:, None], e3 * scale_y[:, None])
    shown = np.unique(np.linspace(0, len(stations.s) - 1, min(most, len(stations.s))).round().astype(int))
    rings, shape = rings[:, shown], section.points
    if change:
        rings, shape = change.carried(rings, stations.t[shown]), change.shape
    points = np.einsum("mk,kni->nmi", affine(shape), rings)
    loops = tuple(np.split(points, section.offsets[1:-1], axis=1))
    held = (stations.u, stations.s, stations.points, stations.tangent, e2, e3)
    return Frames(*(values[shown] for values in held), loops)
