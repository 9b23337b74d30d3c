# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ways of the planar shapes: how each carries its contour."""

from dataclasses import replace
from functools import partial
from math import tau

import numpy as np

from ...contours import Circle, Fit
from ...contours.region import Region
from ...contours.section import section_of
from ...rings.domes import domes_of
from ...rings.ends import Flat, Open, Round
from ...rings.limits import Plane
from ...rings.mitres import cut_back, leans
from ...shapes import directing
from ...shapes.extruding import draft_of
from ...shapes.revolving import rings_of
from ...shapes.translational_sweep import Reference
from ...stations.bending import Bending
from ...stations.frames import RotationMinimizing, axes
from ...stations.sampling import stations
from ...stations.spans import spans
from ...trajectories import Polyline
from ...trajectories.arc_length import arc_length
from ...vectors import dot, norms, unit
from ..plane.drawn import Drawn
from ..plane.regions import Level, Still, region
from ..plane.smooth import Disc
from .leaning import Leaning
from .way import Carried, Corner, Dome, Limit, Way

PARTS = 32  # panels at least, of a whole way
CORNER = 1e-6  # radians: a turn of less is none
LOOKED = 257  # places where it is looked at how far a changing contour reaches
CUT = 1e-3  # of the length between cuts: how closely they are followed
THICKER = 1.001  # times the radius: what is clean but for rounding is not known to be
EVERY = 1.1  # times as far a plane cuts as its cuts of the contour's polygon reach


def of_cylinder(shape):
    """The way of a `GeneralizedCylinder`."""
    (section, change), closed = shape.moving(), bool(shape.trajectory.closed)
    ends = (Flat(), Flat()) if closed else (shape.start, shape.end)
    along, symmetry, reach, _ = shape.laid_out(section, change, ends)
    trajectory, measure = along.trajectory, arc_length(along.trajectory)

    def standing(s):
        placed = stations(trajectory, s)
        scale_x, scale_y, twist, *offset = along.at(placed.s, placed.u)
        e2, e3, _ = axes(along.rails or shape.frame, placed, twist, symmetry=symmetry)
        return placed, np.stack((scale_x, scale_y), axis=1), offset, e2, e3

    def carried(s):
        placed, scales, (x, y), e2, e3 = standing(s)
        return Carried(placed.points + e2 * x[:, None] + e3 * y[:, None], placed.tangent, e2, e3, scales)

    breaks = np.concatenate((measure.at(trajectory.joints()), along.marks()))
    corners = corners_of(trajectory, along.farthest(reach))
    breaks = np.append(breaks, zones(corners, measure.total, closed))
    if leans(along, shape.frame, symmetry):
        known = np.array([corner.parameter for corner in corners])
        leaning = Leaning(standing, known if closed else np.concatenate(((0.0,), known, (measure.total,))), reach)
        carried, corners, breaks = leaning.carried, (), np.append(breaks, leaning.breaks())
    inside = Still(region(shape.contour))
    if change:
        section = change.sections[0]
        looked = np.linspace(0.0, measure.total, LOOKED)
        inside = Drawn(lambda s: change.at(s / measure.total), section.offsets, looked, section.gaps)
        breaks = np.append(breaks, change.places * measure.total)
    places = apart(breaks, measure.total)
    way = Way(carried, places, closed, inside, PARTS, corners, parameter=measure.parameter)
    clean = partial(is_clean_tube, shape) if along.is_constant and not (change or corners) else None
    return way._replace(domes=tuple(domes(shape, ends, way)), faces=faces_of(ends), clean=clean)


def is_clean_tube(shape, distance):
    """Whether a round tube is known to meet itself nowhere, were it so much thicker: by the reach of its trajectory."""
    if not isinstance(shape.contour, Circle) or isinstance(shape.trajectory, Polyline):
        return False
    thicker = Circle(THICKER * shape.contour.radius + distance, shape.contour.points)
    return not replace(shape, contour=thicker, make_solid=False).self_intersections()


def domes(shape, ends, way):
    """The round ends of a generalized cylinder, as its mesh has them."""
    if not any(isinstance(end, Round) for end in ends):
        return
    section, change = replace(shape, fit=Fit.INSCRIBED).moving()
    sections = change.ends if change else (section, section)
    made = domes_of(ends, shape.swept().body, sections, shape.samples, Fit.INSCRIBED)
    onward = -1.0 if runs_backward(way, change.centroids if change else lambda t: section.centroid[:, None]) else 1.0
    at = way.carried(way.breaks[[0, -1]])
    for number, (dome, side) in enumerate(zip(made, (-onward, onward), strict=True)):
        if len(dome):
            here = Carried(*(part[number] for part in at))
            centre, height = sections[number].centroid, float(dome.height.max())
            axes = np.stack((here.x, here.y))
            yield Dome(here.middle, side * here.normal, axes, here.scales, centre, height, way.breaks[-number])


def runs_backward(way, centroids):
    """Whether a contour's middles, beyond the centres of curvature, run backward all the way.

    Its round ends are then on the other sides. The middles are at ``centroids``, of parts of the way (n,) to (2, n).
    """
    t = np.linspace(0.0, 1.0, LOOKED)
    at = way.carried(way.breaks[0] + t * (way.breaks[-1] - way.breaks[0]))
    x, y = (centroids(t) * at.scales.T)[..., None]
    steps = np.diff(at.middle + x * at.x + y * at.y, axis=0)
    return bool((dot(steps, at.normal[1:] + at.normal[:-1]) < 0).all())


def of_translation(shape):
    """The way of a `TranslationalSweep`: its parameter is the height."""
    heights, sections = shape.heights(), [section for section in shape.sections() if section and section.closed]
    drafts = [draft_of(shape, section, heights) for section in sections]
    moves = np.concatenate([draft.moves for draft in drafts]) if drafts else np.zeros(1)
    breaks, aside = heights[[0, -1]], np.zeros(3)
    if moves.any():
        points = np.concatenate([section.points for section in sections])
        sizes = np.concatenate([np.diff(section.offsets) for section in sections])
        inside = Drawn(lambda z: points + np.abs(z)[:, None, None] * moves, np.append(0, np.cumsum(sizes)), heights)
        breaks = heights if heights[0] < 0 else breaks
    else:
        inside = Still(region(shape.contour))
        aside[:2] = -np.array(reference_of(shape))

    def carried(z):
        x, y, up = (np.tile(axis, (len(z), 1)) for axis in np.eye(3))
        return Carried(z[:, None] * shape.way + aside, up, x, y, np.ones((len(z), 2)))

    return Way(
        carried,
        np.array(breaks),
        False,
        inside,
        1,
        faces=faces_of((shape.start, shape.end)),
        clean=lambda distance: True,
    )  # each height comes once


def reference_of(shape):
    """The contour's point that moves from the origin: (2,) in metres."""
    if shape.reference is Reference.CENTROID:
        from ...contours import all_fitted

        return all_fitted(shape.contour, shape.fit)[0].centroid
    return (0.0, 0.0) if shape.reference is Reference.ORIGIN else (shape.reference_x, shape.reference_y)


def of_rotation(shape):
    """The way of a `RotationalSweep`: its parameter is the angle, however it turns."""
    shape.sections()  # refuses what the mesh would
    (x, y), sense = unit(np.array([shape.axis_direction]))[0], np.sign(shape.turn)
    left, up = -np.array(shape.axis_point)
    aside = left * y - up * x, left * x + up * y  # where the contour's origin is, as the axis sees it

    def carried(angle):
        place, radial, along = rings_of(shape, sense * angle)
        middle = place + aside[0] * radial + aside[1] * along
        ahead = np.cross(along, radial) * sense
        return Carried(middle, ahead, y * radial + x * along, y * along - x * radial, np.ones((len(angle), 2)))

    inside = Still(region(shape.contour))
    corners = np.stack(np.meshgrid(*inside.box.T, indexing="ij"), axis=-1).reshape(-1, 2)
    across = (corners - shape.axis_point) @ (y, -x)  # how far the box around the contour is from the axis

    def clean(distance):
        one_side = np.abs(across).min() > distance and np.ptp(np.sign(across)) == 0
        return one_side and not shape.pitch and abs(shape.turn) <= tau

    parts = max(int(np.ceil(PARTS * abs(shape.turn) / tau)), 1)
    return Way(carried, np.array([0.0, abs(shape.turn)]), shape.closed, inside, parts, clean=clean,
               parameter=lambda angle: sense * angle, faces=faces_of((shape.start, shape.end)))  # fmt: skip


def of_pd_curve(shape):
    """The way of a `PDCurveSweep`; limiting planes cut off what goes on straight beyond its ends."""
    limits = (shape.start, shape.end)
    closed = bool(shape.trajectory.closed)
    section, bending, _, _ = directing.laid_out(shape)
    bending = Bending(bending.trajectory, bending.frame, bending.total)
    measure = arc_length(shape.trajectory)

    def carried(s):
        axis = bending.placed(stations(shape.trajectory, s))
        return Carried(axis.points, axis.e1, axis.e2, axis.e3, np.ones((len(s), 2)))

    breaks = apart(measure.at(shape.trajectory.joints()), measure.total)
    way = Way(carried, breaks, closed, Still(region(shape.contour)), PARTS, parameter=measure.parameter,
              faces=faces_of(limits))  # fmt: skip
    if closed or not any(isinstance(limit, Plane) for limit in limits):
        return way
    return way._replace(**cut(limits, bending, section_of(shape.contour, Fit.INSCRIBED), measure.total))


def cut(limits, bending, section, total):
    """How planes limit a way, and how far it goes on beyond its ends."""
    from ...rings.cutting import followed

    _, cuts = followed(limits, spans(bending), section, CUT * total)
    planes, beyond = [], [0.0, 0.0]
    for side, (limit, heights) in enumerate(zip(limits, cuts, strict=True)):
        if not isinstance(limit, Plane):
            continue
        low, high = float(heights.min()), float(heights.max())
        room = EVERY * (high - low) + 1e-6 * total
        sign = 1.0 if side else -1.0
        normal = unit(np.array([limit.across]))[0]
        axis = bending.axis(np.array([(low + high) / 2])).e1[0]
        normal = normal * np.sign(normal @ axis) * sign
        interval = (min(low, total) - room, np.inf) if side else (-np.inf, max(high, 0.0) + room)
        planes.append(Limit(np.array(limit.point), normal, *interval))
        beyond[side] = max(high - total, 0.0) + room if side else max(-low, 0.0) + room
    return {"limits": tuple(planes), "beyond": tuple(beyond)}


def of_planar(shape):
    """The way of a planar figure in general motion that is not deformed."""
    motion, measure = shape.motion, arc_length(shape.trajectory)
    inside, closed = figure(shape)

    def carried(s):
        poses = motion.at(s)
        x, y = poses.matrix[..., 0], poses.matrix[..., 1]
        scales = np.stack((norms(x), norms(y)), axis=1)
        x, y = unit(x), unit(y)
        return Carried(poses.origin, unit(np.cross(x, y)), x, y, scales)

    breaks = apart(measure.at(shape.trajectory.joints()), measure.total)
    return Way(carried, breaks, closed, inside, PARTS, parameter=measure.parameter,
               faces=faces_of((shape.start, shape.end)))  # fmt: skip


def of_canal(shape, balls):
    """The way of the discs in which a `CanalSurface` touches the balls, or is a tip where a ball lies in the next."""
    measure = balls.measure

    def carried(s):
        placed = stations(shape.trajectory, s)
        e2, e3, _ = axes(RotationMinimizing(), placed, np.zeros(len(s)))
        radius, slope = balls.radius(placed.u, s), np.clip(balls.slopes(placed.u, s)[0], -1.0, 1.0)
        middle = placed.points - (radius * slope)[:, None] * placed.tangent
        return Carried(middle, placed.tangent, e2, e3, np.tile((radius * np.sqrt(1 - slope**2))[:, None], 2))

    breaks = measure.at(np.concatenate((shape.trajectory.joints(), balls.kinks.ravel())))
    return Way(carried, apart(breaks, measure.total), bool(shape.trajectory.closed), Still(Disc(1.0)), PARTS)


def figure(shape):
    """The region of a planar figure in general motion, and whether it comes back to where it began."""
    if isinstance(shape.generator, Region):
        return Level(shape.generator, arc_length(shape.trajectory).total), shape.swept().comes_back
    points = section_of(shape.generator, Fit.INSCRIBED).points
    closed = shape.motion.comes_back(np.column_stack((points, np.zeros(len(points)))))
    return Still(region(shape.generator)), closed


def faces_of(ends):
    """Whether there is a face at each of two ends."""
    return tuple(not isinstance(end, Open) for end in ends)


def apart(breaks, total):
    """Breaks in order, the ends among them, none next to another."""
    breaks = np.unique(np.concatenate((breaks, (0.0, total))).clip(0.0, total))
    breaks = breaks[np.append(True, np.diff(breaks) > 1e-12 * total)]
    breaks[-1] = total
    return breaks


def corners_of(trajectory, reach):
    """The corners of a trajectory, from which a contour reaches so far: its joints where the tangent turns at once."""
    joints = trajectory.joints()
    inner = joints[:-1] if trajectory.closed else joints[1:-1]
    if not len(inner):
        return ()
    entered = np.where(inner == joints[0], joints[-1], inner)
    arrive, leave = trajectory.tangents(entered, before=True), trajectory.tangents(inner)
    places, lengths = trajectory.evaluate(inner), arc_length(trajectory).at(inner)
    turned = norms(leave - arrive) > CORNER
    found = (part[turned] for part in (lengths, places, arrive, leave, cut_back(arrive, leave, reach)))
    return tuple(Corner(*each) for each in zip(*found, strict=True))


def zones(corners, total, closed):
    """The arc lengths at which corners begin to cut off legs, or cease to, where legs are longer than that: (k,)."""
    places = np.array([corner.parameter for corner in corners])
    far = np.array([corner.zone for corner in corners])
    if closed:
        return np.concatenate((places - far, places + far))[np.tile(far < total, 2)] % total
    return np.concatenate((places - far, places + far))
