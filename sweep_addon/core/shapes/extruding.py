# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Extruding: from the parameters of a translational sweep to its contours, drafted to their heights, and its mesh."""

from dataclasses import replace
from functools import lru_cache
from math import atan, degrees, tan

import numpy as np

from ..contours import Mixed, all_fitted
from ..declared.parameters import ShapeError, require
from ..declared.wording import shown
from ..grids.chart import Chart, lengths_around
from ..grids.drawn import affine, drawn
from ..grids.grid import Grid
from ..later import later
from ..meshes.mesh import Mesh, require_few
from ..meshes.welding import finished, welded
from ..progress import Listener
from ..rings import caps, draft
from ..rings.ends import Flat
from ..stations.frames import Frames, require_several
from .translational_sweep import Directions, Reference

roofs, roofing = later("core.rings.roofs"), later("core.shapes.roofing")  # of drafts whose edges vanish
in_plane = later("core.grids.in_plane")  # of sweeps within the contour's plane

MANY = 1000  # points of a contour: the roof of so many takes half a second
PLANE = np.array(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))  # its origin and its axes


def mesh(sweep, dtype):
    """The mesh of a translational sweep; `TranslationalSweep.mesh` says of what."""
    made, mixed = whole(sweep, dtype)
    return finished(made, mixed, sweep.regularize, lambda few: whole(replace(sweep, steps=few))[0])


def whole(sweep, dtype=np.float64):
    """The mesh, solid or not, and whether it may be of mixed dimension."""
    sections, mixed = sections_of(sweep), sweep.within_plane or isinstance(sweep.contour, Mixed)
    if sweep.within_plane:
        sections = in_plane.swept(sections, *(heights_of(sweep)[:, None] * sweep.way[:2]))
    bodies = [body_of(sweep, section, dtype) for section in sections if section]
    return (welded(bodies, [s.points for s in sections if s]), True) if mixed else (bodies[0], False)


def body_of(sweep, section, dtype):
    """The mesh of one section."""
    if sweep.within_plane:
        return in_plane.flat(section, PLANE, sweep.texture, sweep.attributes, dtype)
    heights = heights_of(sweep)
    require_few(len(heights) * len(section.points), "steps")
    parted = roof_of(sweep, section, heights)
    if parted:
        return roofing.mesh(sweep, section, parted, heights, dtype)
    drafted = draft_of(sweep, section, heights)
    moves, points = drafted.moves, drafted.points
    s = (heights - heights[0]) / sweep.upright
    grid = Grid(
        rings=len(heights),
        tips=tuple(station for station, point in zip((0, len(heights) - 1), points, strict=True) if point),
        closed=False,
        creases=tuple(np.flatnonzero(heights == 0).tolist()) if moves.any() and heights[0] < 0 else (),
        offsets=tuple(section.offsets.tolist()),
        sharp=tuple(np.flatnonzero(section.sharp).tolist()),
        caps=caps.at_ends(drafted.ends, (sweep.start, sweep.end), points),
        gaps=tuple(section.gaps.tolist()),
    )
    flat = tuple(end.points for end in drafted.ends)
    around = lengths_around(section, np.ones(2))
    chart = Chart(grid, s / s[-1], s, s[-1], around, flat, sweep.texture, sweep.attributes)
    return Mesh(drawn(grid, *laid(sweep, section, moves, heights), dtype), grid.topology(), chart)


def sections_of(sweep):
    """The sections of the contour as its reference point is at the origin: one, unless it is mixed."""
    return referred(sweep.contour, sweep.fit, sweep.reference, (sweep.reference_x, sweep.reference_y))


def heights_of(sweep):
    """How far contours stand out of their plane, which is among them if they are drafted: (n,) float array."""
    low, high = {
        Directions.UP: (0.0, sweep.height),
        Directions.SYMMETRIC: (-sweep.height / 2, sweep.height / 2),
        Directions.BOTH: (-sweep.depth, sweep.height),
    }[sweep.directions]
    heights = np.linspace(low, high, sweep.steps + 1)
    if not sweep.is_drafted or low == 0:
        return heights
    heights[1:-1][np.abs(heights[1:-1]) <= draft.ALIKE * (high - low)] = 0.0  # but for rounding, also of the depth
    return np.union1d(heights, 0.0)


def require_possible(sweep):
    """Refuse what the contour shows to have no mesh: see `TranslationalSweep.check`.

    Whether a draft leaves anything of a contour that is wide enough is known once its edges have moved, and which angle
    would do for one of many points too, which takes seconds: those meshes are refused.
    """
    heights = heights_of(sweep)
    for section in filter(None, sections_of(sweep)):
        require_few(len(heights) * len(section.points), "steps")
        slopes = drafted_slopes(sweep, section)
        outer = section.areas >= 0
        if not (slopes[outer] > 0).all():
            continue
        loops = zip(np.split(section.points, section.offsets[1:-1]), slopes.tolist(), outer, strict=True)
        gone = max(draft.room(points) / slope for points, slope, whole in loops if whole)
        if gone < np.abs(heights).max() * (1 - draft.ALIKE) and len(section.points) <= MANY:
            if not roof_of(sweep, section, heights):
                draft_of(sweep, section, heights)  # one of them refuses it, and tells which angle will do


def draft_of(sweep, section, heights):
    """The section drafted to its ends: a `Draft`; refused where it does not reach them."""
    slopes, found = known_draft(sweep, section, heights)
    for height, reached, point in zip(np.abs(heights[[0, -1]]).tolist(), found.reached, found.points, strict=True):
        if falls_short(height, reached, point):
            raise refusal(sweep, slopes, height, reached, point)
    return found


def known_draft(sweep, section, heights):
    """The slopes of a section's loops, and the `Draft`, whether or not it reaches its ends."""
    slopes, ends = drafted_slopes(sweep, section), np.abs(heights[[0, -1]]).tolist()
    return slopes, draft.draft(section, tuple(slopes.tolist()), tuple(ends))


def falls_short(height, reached, point):
    """Whether a section drafted so far does not reach a height."""
    return height > reached * (1 + draft.ALIKE if point else 1)


def is_parted(sweep):
    """Whether edges of a sweep's contour vanish, part or join on the way."""
    heights = heights_of(sweep)
    return any(section and section.closed and roof_of(sweep, section, heights) for section in sections_of(sweep))


def becomes_roof(sweep, section, heights):
    """Whether edges of a section vanish, part or join below the heights, and not all at once."""
    _, found = known_draft(sweep, section, heights)
    ends = np.abs(heights[[0, -1]]).tolist()
    short = [falls_short(*each) for each in zip(ends, found.reached, found.points, strict=True)]
    if not any(short) or any(one and point for one, point in zip(short, found.points, strict=True)):
        return False
    return not isinstance(sweep.contour, Mixed) and len(section.points) <= roofs.MOST


def takes_long(sweep):
    """Whether a person would wait for the mesh: for the roof of a closed contour of many points."""
    if not sweep.is_drafted:
        return False
    heights, many = heights_of(sweep), [s for s in sections_of(sweep) if s and s.closed and len(s.points) > MANY]
    return any(becomes_roof(sweep, section, heights) for section in many)


def follow(sweep, progress):
    """Make what takes long of a mesh, which is kept for it, and tell how far that is."""
    heights = heights_of(sweep)
    for section in filter(None, sections_of(sweep)):
        if section.closed and sweep.is_drafted:
            roof_of(sweep, section, heights, progress)


def roof_of(sweep, section, heights, progress=None):
    """What edges leave that vanish, part or join below the heights: a `Roof`; None where none do, or all at once."""
    if not becomes_roof(sweep, section, heights):
        return None
    slopes, ends = drafted_slopes(sweep, section), np.abs(heights[[0, -1]]).tolist()
    most = roofs.MOST_NODES // len(section.points)
    sentence = f"must be at most {most} where edges of the contour vanish or meet"
    require(sweep.steps <= most, sentence, sweep.steps, "steps")
    closed = tuple(isinstance(end, Flat) for end in (sweep.start, sweep.end))
    try:
        made = roofs.roof(section, tuple(slopes.tolist()), tuple(heights.tolist()), closed, Listener(progress))
    except ShapeError as error:
        key, angle = steepest(sweep, slopes)
        raise ShapeError(f"{error}, got {shown(angle)}", key) from None
    for height, gone in zip(ends, made.gone, strict=True):
        if gone < height * (1 - draft.ALIKE):
            raise refusal(sweep, slopes, height, gone, True, "nothing is left")
    return made


def drafted_slopes(sweep, section):
    """The tangent of the taper of each loop, (k,) float array; refused where the loops have no inside to lean to."""
    slopes = slopes_of(sweep, section)
    if not section.closed:
        key, angle = steepest(sweep, slopes)
        require(not angle, "must be 0 where the contour has open curves or points, which have no inside", angle, key)
    return slopes


def slopes_of(sweep, section):
    """The tangent of the taper of each loop: (k,) float array."""
    if len(sweep.tapers):
        loops = len(section.areas)
        require(len(sweep.tapers) == loops, f"must have one angle a loop, {loops}", len(sweep.tapers), "tapers")
        return np.tan(sweep.tapers.values)
    return np.where(section.areas >= 0, tan(sweep.taper), tan(sweep.hole_taper))


def refusal(sweep, slopes, height, reached, point, said="edges meet"):
    """What is said of a taper whose edges meet before the height: the largest angle, that of a point if all do."""
    key, angle = steepest(sweep, slopes)
    most = atan(tan(abs(angle)) * reached / height)
    most = f"must be {'at most' if point else 'less than'} {most:.9g} ({degrees(most):.9g} degrees) in size"
    return ShapeError(f"{most}: {said} {reached:.6g} m from their plane, got {shown(angle)}", key)


def steepest(sweep, slopes):
    """The parameter that the steepest slope is of, and its angle."""
    slope = max(slopes.tolist(), key=abs)
    key = "tapers" if len(sweep.tapers) else "taper" if abs(tan(sweep.taper)) == abs(slope) else "hole_taper"
    return key, atan(slope)


def laid(sweep, section, moves, heights):
    """The weights of the section's points, (m, k), and the rings that they are of, (k, n, 3)."""
    axes = np.zeros((3, len(heights), 3))
    axes[0] = heights[:, None] * sweep.way
    axes[1, :, 0] = axes[2, :, 1] = 1.0
    weights = affine(section.points)
    if not moves.any():
        return weights, axes
    return np.column_stack((weights, moves)), np.concatenate((axes, axes[1:] * np.abs(heights)[:, None]))


def frames(sweep, most):
    """The frames and contours at some stations; `TranslationalSweep.frames` says at which."""
    require_several(most)
    sections, every, loops = sections_of(sweep), heights_of(sweep), []
    heights = every[np.unique(np.linspace(0, len(every) - 1, min(most, len(every))).round().astype(int))]
    for section in sections:
        if parted := roof_of(sweep, section, every):
            loops += [
                placed(sweep, loop, height) for height in heights.tolist() for loop in parted.levels.get(height, ())
            ]
            continue
        moves = draft_of(sweep, section, heights).moves
        weights, rings = laid(sweep, section, moves, heights)
        loops += np.split(np.einsum("mk,kni->nmi", weights, rings), section.offsets[1:-1], axis=1)
    s = (heights - heights[0]) / sweep.upright
    middles, (x, y) = heights[:, None] * sweep.way, np.eye(3)[:2]
    ways, x, y = (
        np.tile(axis, (len(heights), 1)) for axis in (sweep.direction / np.linalg.norm(sweep.direction), x, y)
    )
    return Frames(s / s[-1], s, middles, ways, x, y, tuple(loops))


def placed(sweep, loop, height):
    """A loop of the plane, (k, 2), at a height: (1, k, 3) float array."""
    return (np.column_stack((loop, np.zeros(len(loop)))) + height * sweep.way)[None]


@lru_cache(maxsize=16)
def referred(contour, fit, reference, point):
    """The sections of a contour with a point of its plane at the origin, made once for equal ones."""
    sections = all_fitted(contour, fit)
    if reference is Reference.ORIGIN:
        return sections
    origin = sections[0].centroid if reference is Reference.CENTROID else point
    return tuple(replace(section, points=section.points - origin) for section in sections)
