# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Revolving: from the parameters of a rotational sweep to the sections that turn about its axis, and its mesh."""

from dataclasses import replace
from functools import lru_cache
from math import ceil, copysign, pi, sin, sqrt, tau

import numpy as np

from ..contours import Fit, Mixed, all_fitted
from ..declared.options import PREFIX
from ..declared.parameters import ShapeError, at, require, spelled
from ..grids.chart import Chart, lengths_around
from ..grids.drawn import affine, drawn
from ..grids.grid import Grid
from ..later import later
from ..meshes.joining import joined
from ..meshes.mesh import Mesh, require_few
from ..meshes.welding import finished, welded
from ..rings import caps, parting
from ..stations.cells import WIDEST_BEND, chord_angle
from ..stations.frames import Frames, require_several
from ..stations.sampling import MOST_STATIONS, Count
from .rotational_sweep import WHOLE, Crossing

in_plane = later("core.grids.in_plane")  # of contours on the axis

LESS = f"must be less than half a turn, {pi:.6g}, where crossing is meet and the sides then sweep the same places"
OVERLAP = f"{PREFIX}beyond half a turn both sides of the contour sweep the same places, and their bodies overlap."


def surface(sweep, dtype):
    """The surface that the contour leaves, its parts by dimension told: a `Mesh`."""
    mesh, mixed = whole(sweep, dtype)
    least = ceil(abs(sweep.turn) / WIDEST_BEND)
    return finished(
        mesh, mixed, sweep.regularize, lambda few: whole(replace(sweep, samples=Count(least + few)))[0], least
    )


def whole(sweep, dtype=np.float64):
    """The mesh, solid or not, and whether it may be of mixed dimension."""
    sections, bodies = sections_of(sweep), bodies_of(sweep, dtype)
    mixed = isinstance(sweep.contour, Mixed) or sweep.crossing is Crossing.MEET and len(sections) > 1
    drawn_as = (outward(sweep, section) for section in sections)
    mesh = welded(bodies, [section.points * (side, 1) for section, side in drawn_as]) if mixed else joined(bodies)
    if sweep.crossing is Crossing.SPLIT and abs(sweep.angle) > pi * (1 + WHOLE) and sides_overlap(sweep, sections):
        mesh = replace(mesh, told=(*mesh.told, OVERLAP))
    return mesh, mixed


def bodies_of(sweep, dtype=np.float64):
    """The meshes of the sections that turn, each on its own."""
    sections = sections_of(sweep)
    turns = turns_of(sweep, sections)
    require_few(len(turns) * sum(len(section.points) for section in sections), "samples")
    return [body_of(sweep, section, turns, dtype) for section in sections]


def sections_of(sweep):
    """The sections that turn, x across the axis and y along it: one unless the contour is mixed or is split."""
    across = (sweep.axis_point, sweep.axis_direction)
    sections = about_axis(sweep.contour, sweep.fit, *across, sweep.crossing, bool(sweep.pitch))
    for section in sections:
        solid = section.closed or isinstance(sweep.contour, Mixed)  # an open outline may run along the axis
        along = solid and sweep.pitch and len(between_poles(section))
        cut = sweep.crossing in (Crossing.SPLIT, Crossing.MEET) and across_axis(sections)
        kept = "must be keep where there is a pitch, by which the cut along the axis would slide in itself"
        require(not (along and cut), kept, spelled(sweep.crossing), "crossing")
        require(not along, "must be 0 for a contour with an edge along the axis", sweep.pitch, "pitch")
    apart = sweep.crossing is not Crossing.MEET or abs(sweep.angle) < pi * (1 - WHOLE)
    require(apart or not sides_overlap(sweep, sections), LESS, sweep.angle, "angle")
    return sections


def sides_overlap(sweep, sections):
    """Whether what is on both sides of the axis sweeps the same places, from half a turn on."""
    with at("contour"):
        return not sweep.pitch and parting.overlapping(sections)


def body_of(sweep, section, turns, dtype):
    """The mesh of one section that turns so far."""
    (section, side), rings, told = outward(sweep, section), rings_of(sweep, turns), ()
    if not (sweep.pitch or section.points[:, 0].any()):
        return in_plane.flat(section, rings[:, 0], sweep.texture, sweep.attributes, dtype)
    if all(parting.sides(section)):
        told = (f"{PREFIX}the contour crosses the axis, and the sweep passes through itself there.",)
    rings[1] *= side * wider(sweep, len(turns) - (not sweep.closed))
    poles = () if sweep.pitch else np.flatnonzero(section.points[:, 0] == 0).tolist()
    grid = Grid(
        rings=len(turns),
        tips=(),
        closed=sweep.closed,
        creases=(),
        offsets=tuple(section.offsets.tolist()),
        sharp=tuple(np.flatnonzero(section.sharp).tolist()),
        caps=caps.at_ends((section, section), (sweep.start, sweep.end), (sweep.closed, sweep.closed), tuple(poles)),
        gaps=tuple(np.union1d(between_poles(section), section.gaps).tolist()),
        poles=tuple(poles),
    )
    middles = (section.points + section.points[section.following])[:, 0] / 2
    weights = section.edge_lengths if section.edge_lengths.any() else np.ones(len(middles))  # of single points
    radius = weights @ np.abs(middles) / weights.sum()
    way = sqrt(radius**2 + (sweep.pitch / tau) ** 2)  # in a radian, of the contour's mean
    around = lengths_around(section, np.ones(2))
    flat = (section.points, section.points)
    s, total = np.abs(turns) * way, abs(sweep.turn) * way
    chart = Chart(grid, turns, s, total, around, flat, sweep.texture, sweep.attributes)
    return Mesh(drawn(grid, affine(section.points), rings, dtype), grid.topology(), chart, told)


def outward(sweep, section):
    """The section as it is drawn, and 1, or -1 where it is mirrored as it turns to the back of its plane."""
    back = (section.centroid[0] > 0) == (sweep.angle > 0)
    return (section.mirrored, -1) if back else (section, 1)


def turns_of(sweep, sections):
    """The angles at which contours stand: (n,) float array; a whole turn is not among them where it closes."""
    size = abs(sweep.turn)
    if isinstance(sweep.samples, Count):
        steps = sweep.samples.contours - (not sweep.closed)
    else:
        radius = max(float(np.abs(section.points[:, 0]).max()) for section in sections)
        wanted = size / min(chord_angle(sweep.samples.chord, radius), WIDEST_BEND)
        most = f"must be larger: this turn takes {wanted:,.0f} contours of {MOST_STATIONS:,} at most"
        require(wanted <= MOST_STATIONS, most, sweep.samples.chord, "samples.chord")
        steps = max(ceil(wanted - WHOLE), 1)
    return np.linspace(0, sweep.turn, steps + 1)[: steps if sweep.closed else None]


def rings_of(sweep, turns):
    """The place of the axis' point at each turn, and the axes across and along it: (3, n, 3) float array."""
    along = np.append(sweep.axis_direction, 0.0) / np.hypot(*sweep.axis_direction)
    across, down = np.array((along[1], -along[0], 0.0)), np.array((0.0, 0.0, -1.0))
    radial = np.cos(turns)[:, None] * across + np.sin(turns)[:, None] * down
    place = np.append(sweep.axis_point, 0.0) + (sweep.pitch / tau * turns)[:, None] * along
    rings = np.stack((place, radial, np.broadcast_to(along, place.shape)))
    return rings[..., [0, 2, 1]] * (1, -1, 1) if sweep.upright else rings


def wider(sweep, steps):
    """By what the contour's distance from the axis grows so that sectors are as large as those of a circle."""
    step = abs(sweep.turn) / steps
    return sqrt(step / sin(step)) if sweep.fit is Fit.AREA_TRUE else 1.0


def frames(sweep, most):
    """The frames and contours at some stations; `RotationalSweep.frames` says at which."""
    require_several(most)
    sections = sections_of(sweep)
    turns = turns_of(sweep, sections)
    turns = turns[np.unique(np.linspace(0, len(turns) - 1, min(most, len(turns))).round().astype(int))]
    rings = rings_of(sweep, turns)
    contours = (np.einsum("mk,kni->nmi", affine(each.points), rings) for each in sections)
    loops = (np.split(c, each.offsets[1:-1], axis=1) for c, each in zip(contours, sections, strict=True))
    x, y = sections[0].centroid
    sense = copysign(1.0, sweep.angle)
    onward = np.cross(rings[2], rings[1]) * x + sweep.pitch / tau * rings[2]
    length = float(np.linalg.norm(onward[0]))
    points = rings[0] + x * rings[1] + y * rings[2]
    tangents = sense * (onward / length if length else np.cross(rings[2], rings[1]))
    return Frames(turns, np.abs(turns) * length, points, tangents, rings[1], rings[2], tuple(sum(loops, [])))


def between_poles(section):
    """The points of a section from which an edge runs along the axis."""
    here = section.points[:, 0] == 0
    along = here & here[section.following]
    along[section.gaps] = False
    return np.flatnonzero(along)


@lru_cache(maxsize=16)
def about_axis(contour, fit, point, direction, crossing, screw):
    """The sections of a contour as an axis sees it, x across it to its right and y along it, made once for equal ones.

    Raises
    ------
    ShapeError
        Where the contour is on both sides of the axis and that is refused, or where nothing of it is off the axis.
    """
    x, y = np.array(direction) / np.hypot(*direction)
    sections = [turned(section, np.array(point), x, y) for section in all_fitted(contour, fit)]
    sections = parting.on_axis(sections, isinstance(contour, Mixed), screw)
    across = np.concatenate([section.points[:, 0] for section in sections])
    if not across.any():
        raise ShapeError("must not lie on the axis, got only points on it", "contour")
    if crossing is Crossing.KEEP or not across_axis(sections):
        return tuple(sections if screw else map(parting.with_crossings, sections))
    if crossing is Crossing.REFUSE:
        if fit is not Fit.INSCRIBED:
            kept = about_axis(contour, Fit.INSCRIBED, point, direction, Crossing.KEEP, screw)
            beside = "must be inscribed for a contour that touches the axis with a curve, whose edges else cross it"
            require(across_axis(kept), beside, spelled(fit), "fit")
        low, high = float(across.min()), float(across.max())
        one_side = "must be on one side of the axis, or crossing be keep, split or meet"
        raise ShapeError(f"{one_side}, got one from {low:.6g} to {high:.6g} m across it", "contour")
    return tuple(part for section in sections for part in parting.parted(section))


def across_axis(sections):
    """Whether sections that an axis sees are on both sides of it."""
    across = [section.points[:, 0] for section in sections]
    return min(side.min() for side in across) < 0 < max(side.max() for side in across)


def turned(section, origin, x, y):
    """A section as an axis through a point sees it that runs along (x, y); equal points stay equal, to the bit."""
    right, up = (section.points - origin).T
    return replace(section, points=np.stack((right * y - up * x, right * x + up * y), axis=1))
