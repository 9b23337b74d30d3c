# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Frames along a trajectory: the local axes e1 e2 e3 in which a contour is placed.

A frame is one scalar: the angle of e2 about the tangent, measured from the rotation-minimizing normal. Twist, holonomy
and extra turns are all added to it. Round a closed trajectory it grows by whole sectors, the least turns that map the
contour to itself, of which there are ``symmetry`` in a whole one.
"""

from enum import Enum
from functools import lru_cache
from math import tau

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import ShapeError, declared, parameter, require
from ..declared.wording import near
from ..later import later
from ..vectors import cross, unit
from . import sampling

arc_length = later("core.trajectories.arc_length", "arc_length")
rotated, signed_angle = later("core.stations.rotations", "rotated", "signed_angle")
turned, wrapped = later("core.stations.rotations", "turned", "wrapped")
transport = later("core.stations.transport", "transport")
distinct = later("core.stations.spreading", "distinct")

__all__ = ["Continuation", "FixedUp", "Frame", "Frames", "Frenet", "RotationMinimizing"]

PLACES = 2049  # where it is looked at how a frame turns, from each of which to the next it is continued
JUMP = tau / 8  # from one of them to the next: no number of contours would make that smooth
TIE = 1e-6  # radians: where planes of two bends are square to each other, rounding must not choose the side
SHORT = 4  # of them: over a longer stretch without a normal a frame turns evenly,
LONGER = 205  # one that changes its side if it is longer than this, a tenth of the length
STRAIGHT = 1e-6  # curvature times length: a bend of a millionth of a radian along the whole trajectory is none


@individual
class Frames:
    """Frames and contours at places along a sweep.

    Parameters
    ----------
    u, s : (n,) float array
        The trajectory's own parameter and the arc length in metres.
    points : (n, 3) float array
        The trajectory there.
    e1, e2, e3 : (n, 3) float array
        The unit tangent, at a corner the bisector, and the axes of the contour as the twist has turned them.
    contours : tuple of (n, m, 3) float arrays
        For each loop of the contour its points at each place, inscribed; the last leads back to the first.
    """

    u: np.ndarray
    s: np.ndarray
    points: np.ndarray
    e1: np.ndarray
    e2: np.ndarray
    e3: np.ndarray
    contours: tuple


def require_several(most):
    """Refuse what is no number of places at which frames are shown."""
    several = isinstance(most, (int, np.integer)) and most >= 2
    require(several, "must be a whole number, at least 2", most, "most")


class Continuation(Enum):
    SMOOTH = "The normal keeps its side through inflections and turns evenly over straight stretches"
    EXACT = "As defined: the normal changes its side at once at an inflection"
    REFUSE = "A trajectory with a straight place is refused"


@declared
class RotationMinimizing:
    """Without spin about the tangent

    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.trajectories import TorusKnot
    >>> frame = RotationMinimizing(extra_turns=2)
    >>> len(GeneralizedCylinder(trajectory=TorusKnot(), frame=frame).mesh().boundary_edges())
    0
    """

    extra_turns: int = parameter(0, "Whole turns added along the trajectory", minimum=-1000, maximum=1000)
    extra_sectors: int = parameter(
        0, "Least turns added that map the contour to itself: quarters for a square", minimum=-4096, maximum=4096
    )

    def extra(self, symmetry):
        """The angle in radians that is added from the start to the end."""
        return tau * (self.extra_turns + self.extra_sectors / symmetry)

    def grown(self, holonomy, symmetry):
        """The angle of e2 from the rotation-minimizing normal at the end, where it is 0 at the start."""
        return self.extra(symmetry) - wrapped(holonomy, tau / symmetry)

    def angles(self, stations, normals, holonomy, symmetry):
        """The angle of e2 from the rotation-minimizing normals, (n,), and what a person should be told."""
        return self.grown(holonomy, symmetry) * stations.t, ()


class OfItsPlace:
    """What frames share that the place on the trajectory decides: they come back as they began."""

    extra_sectors = 0
    keeps_its_side = True

    def extra(self, symmetry):
        """Nothing is added from the start to the end."""
        return 0.0

    def grown(self, holonomy, symmetry):
        """The angle of e2 from the rotation-minimizing normal when it is back, but for whole turns."""
        return -holonomy


@declared
class Frenet(OfItsPlace):
    """Towards the centre of curvature

    >>> from sweep_addon.core.stations.sampling import Count, place
    >>> from sweep_addon.core.trajectories import Helix
    >>> stations = place(Helix(), Count(9))
    >>> e2, e3, told = axes(Frenet(), stations, np.zeros(9))
    >>> bool(np.allclose(e2[:, :2], -stations.points[:, :2])), told
    (True, ())
    """

    continuation: Continuation = parameter(Continuation.SMOOTH, "What to do where the curvature vanishes")

    def angles(self, stations, normals, holonomy, symmetry):
        """The angle of the principal normal from the rotation-minimizing normals, (n,), and a warning."""
        angles, place = along_path(self, stations, *self.towards(stations, normals))
        if place is None:
            return angles, ()
        if self.continuation is Continuation.REFUSE:
            sentence = f"must be smooth or exact where the curvature vanishes, got refuse near u = {place}"
            raise ShapeError(sentence, "frame.continuation")
        if not continued(self, stations.trajectory)[-1]:
            return angles, ("Frame: the trajectory is straight and has no Frenet frame; the first normal is kept.",)
        return angles, (f"Frame: the curvature vanishes near u = {place}, where the Frenet frame is not defined.",)

    @property
    def keeps_its_side(self):
        """Whether it goes on with the side it has where that of its definition changes."""
        return self.continuation is Continuation.SMOOTH

    def towards(self, stations, normals):
        """The angle of the centre of curvature from the rotation-minimizing normals, and where there is one: (n,)."""
        bend, corners = stations.bend.copy(), stations.corners
        bend[corners] = turned(bend[corners], stations.tangent[corners], stations.leave[corners])
        curved = np.linalg.norm(bend, axis=1) * stations.total > STRAIGHT
        return signed_angle(normals, bend, stations.leave), curved


@declared
class FixedUp(OfItsPlace):
    """As level as the tangent allows: the contour's y axis points up, until the trajectory goes over the vertical

    >>> from sweep_addon.core.stations.sampling import Count, place
    >>> from sweep_addon.core.trajectories import Helix
    >>> e2, e3, told = axes(FixedUp((0, 0, 1)), place(Helix(), Count(9)), np.zeros(9))
    >>> bool(np.allclose(e2[:, 2], 0)), bool((e3[:, 2] > 0.99).all())
    (True, True)
    """

    up: tuple[float, float, float] = parameter((0, 0, 1), "Direction that stays up")

    def check(self):
        """Refuse a direction without length."""
        require(np.linalg.norm(self.up) > 0, "must have a length", list(self.up), "up")

    def angles(self, stations, normals, holonomy, symmetry):
        """The angle of the level normal from the rotation-minimizing normals, (n,), and a warning."""
        found, defined = self.towards(stations, normals)
        angles, told = along_path(self, stations, found, defined)
        if told is None:
            return angles, ()
        return angles, (f"Frame: the trajectory runs along the up direction near u = {told}, where no side is up.",)

    def towards(self, stations, normals):
        """The angle of the level normal from the rotation-minimizing normals, and where there is one: (n,)."""
        level = cross(unit(np.array(self.up)[None]), stations.leave)
        return signed_angle(normals, level, stations.leave), np.linalg.norm(level, axis=1) > 1e-6


Frame = RotationMinimizing | Frenet | FixedUp


def __dir__():
    return __all__  # what a console offers


def axes(frame, stations, twist, symmetry=1):
    """The axes in which the contour is drawn at each station.

    Parameters
    ----------
    frame : RotationMinimizing, Frenet or FixedUp
    stations : Stations
    twist : (n,) float array
        An angle in radians about the tangent, added to the frame's own.
    symmetry : int
        The parts of a whole turn by any of which a closed frame may come back turned.

    Returns
    -------
    e2, e3 : (n, 3) float array
        The contour's x and y axes, orthonormal and across ``stations.tangent``.
    told : tuple of str
        Sentences for people, where the frame is not defined somewhere.
    """
    normals, holonomy = rotation_minimizing(stations)
    angles, told = frame.angles(stations, normals, holonomy, symmetry)
    turned_by, across, corners = angles + twist, binormals(stations), stations.corners
    if turned_by.any():
        cosine, sine = np.cos(turned_by)[:, None], np.sin(turned_by)[:, None]
        e2, e3 = cosine * normals + sine * across, cosine * across - sine * normals
    else:
        e2, e3 = normals.copy("K"), across.copy("K")  # others keep these
    if len(corners):
        e2[corners] = turned(e2[corners], stations.leave[corners], stations.tangent[corners])
        e3[corners] = cross(stations.tangent[corners], e2[corners])
    return e2, e3, told


@lru_cache(maxsize=16)
def turn(frame, trajectory):
    """How a frame turns beside the rotation-minimizing one.

    Parameters
    ----------
    frame : Frenet or FixedUp
    trajectory : Trajectory

    Returns
    -------
    s : (n,) float array
        Arc lengths in metres, evenly spaced from end to end.
    angle : (n,) float array
        What it has turned about the tangent by then, in radians, jumps left out. Opposite sides count as one, as the
        frame goes on with either after an inflection.
    """
    s, placed = evenly(trajectory)
    normals, holonomy = rotation_minimizing(placed)
    angles = frame.angles(placed, normals, holonomy, 1)[0]
    if trajectory.closed:
        angles = np.append(angles, angles[0] - holonomy)
    steps = wrapped(np.diff(angles), tau / 2)
    steps[np.abs(steps) > JUMP] = 0.0
    steps[placed.corners - 1] = 0.0  # of a closed trajectory the last one leads to the first corner
    return s, np.concatenate(([0.0], np.cumsum(steps)))


@lru_cache(maxsize=16)
def evenly(trajectory):
    """Arc lengths from end to end, even but for the corners, (n,), and the stations there, without a closed end."""
    measure = arc_length(trajectory)
    s = np.concatenate((np.linspace(0.0, measure.total, PLACES), measure.at(trajectory.stops())))
    s = distinct(s.clip(0.0, measure.total), sampling.SHORTEST_STEP * measure.total)
    s[-1] = measure.total
    return s, sampling.stations(trajectory, s[:-1] if trajectory.closed else s)


@lru_cache(maxsize=16)
def rotation_minimizing(stations):
    """Normals carried along a trajectory without spin about the tangent.

    Parameters
    ----------
    stations : Stations

    Returns
    -------
    normals : (n, 3) float array
        Unit normals across ``stations.leave``, the first as Blender chooses it.
    holonomy : float
        The angle in radians by which a closed trajectory brings the normal back turned; 0 for an open one.

    At a corner the normal turns with the least rotation that takes one leg to the other, so that a mitred leg keeps its
    cross-section.
    """
    carried = transport(stations.trajectory)
    reference, angle = carried.at(stations.u, stations.leave)
    start = turned(first_normal(stations.tangent[:1]), stations.tangent[:1], stations.leave[:1])
    first = signed_angle(reference[:1], start, stations.leave[:1])
    return rotated(reference, stations.leave, first + angle - angle[0]), carried.holonomy


@lru_cache(maxsize=16)
def binormals(stations):
    """What is across the rotation-minimizing normals and ``stations.leave``: unit vectors, (n, 3)."""
    return cross(stations.leave, rotation_minimizing(stations)[0])


def first_normal(tangent):
    """The normal that Blender's Curve to Mesh starts with: level, or along x where the tangent is vertical."""
    x, y = tangent[0, :2]
    normal = np.array([[y, -x, 0.0]]) if abs(x) + abs(y) >= 1e-4 else np.array([[1.0, 0.0, 0.0]])
    return unit(normal - (normal @ tangent[0]) * tangent)


@lru_cache(maxsize=16)
def continued(frame, trajectory):
    """How a frame goes on along a trajectory, however few contours stand there.

    Parameters
    ----------
    frame : Frenet or FixedUp
    trajectory : Trajectory

    Returns
    -------
    s : (n,) float array
        Arc lengths in metres, rising from end to end; twice where a leap ends.
    angles : (n,) float array
        From the rotation-minimizing normals, in radians; 0 where the frame is defined nowhere.
    period : float
        By multiples of which an angle may be off that by definition: half a turn if the frame keeps its side.
    place : str or None
        Where it is first not defined, or turns by more than a right angle at once, as people read it.
    defined : bool
        Whether it is defined anywhere.
    """
    s, placed = evenly(trajectory)
    normals, holonomy = rotation_minimizing(placed)
    found, defined = frame.towards(placed, normals)
    if not defined.any():
        return s, np.zeros(len(s)), tau, lost(placed, defined, None), False
    flips = flipping(fill(placed, found, defined, holonomy), placed, holonomy)
    angles = fill(placed, found, defined, holonomy, half=frame.keeps_its_side)
    period = tau / 2 if np.cos(angles - found)[defined].min() < 0 else tau  # round a closed path it may not keep it
    if placed.closed:
        angles = np.append(angles, angles[-1] + nearest(angles[0] - holonomy - angles[-1], period))
    s, angles = leaping_at_once(s, angles, defined, frame, placed.closed)
    return s, angles, period, None if defined.all() and not flips.any() else lost(placed, defined, flips), True


def leaping_at_once(s, angles, defined, frame, closed):
    """Places and angles (n,) with each leap in one place, so that what has no angle itself is not found halfway round.

    That is where the next angle is or, where there are places without one before that, in the middle of these.
    """
    at = np.flatnonzero(defined)
    known, lap = angles[at], len(angles) - 1
    if closed:
        grown = angles[-1] - angles[0]
        at, known = (
            np.concatenate((each[-1:] - once, each, each[:1] + once)) for each, once in ((at, lap), (known, grown))
        )
    place, steps = once_round(s, at), np.diff(at)
    leap = np.append((np.abs(np.diff(known)) > JUMP) & (np.diff(place) <= s[-1] * shortly(frame) / PLACES), False)
    there = np.append(np.where(steps > 1, amid(s, at[:-1], at[1:]), place[1:]), np.inf)
    before = np.maximum(np.searchsorted(at, np.arange(lap + 1), side="right") - 1, 0)
    after = np.minimum(before + 1, len(at) - 1)
    within = leap[before] & (place[before] < s)
    angles = np.where(within, np.where(s < there[before], known[before], known[after]), angles)
    here = np.flatnonzero(leap & (there >= 0) & (there <= s[-1]))
    index = np.repeat(np.searchsorted(s, there[here]), 2)
    both = np.stack((known[here], known[here + 1]), axis=1).ravel()
    return np.insert(s, index, np.repeat(there[here], 2)), np.insert(angles, index, both)


def amid(s, before, after):
    """The middle of the places between some and others: (k,)."""
    return (once_round(s, before + 1) + once_round(s, after - 1)) / 2


def once_round(s, which):
    """Arc lengths of places, of which those beyond the ends are as far beyond once round: (k,)."""
    lap = len(s) - 1
    return np.where(which == lap, s[-1], s[which % lap] + which // lap * s[-1])


def shortly(frame):
    """How many places a path may be straight where a frame leaps, and does not turn evenly."""
    return SHORT if frame.keeps_its_side else LONGER


def along_path(frame, stations, found, defined):
    """The angles of a frame at stations, (n,), by those of its definition and where there are any, and the place where
    it is `continued` beyond that, or None.
    """
    s, angles, period, place, _ = continued(frame, stations.trajectory)
    near_by = np.interp(stations.s, s, angles)
    return np.where(defined, near_by + nearest(found - near_by, period), near_by), place


def fill(stations, angles, known, holonomy, half=False):
    """Angles made continuous over the stations, those not known taken evenly between their neighbours.

    With `half`, an angle and the one opposite are the same, so that an inflection does not turn the frame round.
    """
    period = tau / 2 if half else tau
    at, found = stations.s[known], angles[known].copy()
    steps = np.diff(found)
    found[1:] += period * np.cumsum(np.round((nearest(steps, period) - steps) / period))
    if stations.closed:  # once round, the same frame stands at an angle that has grown by minus the holonomy
        again = found[0] - holonomy
        again = found[-1] + nearest(again - found[-1], period)
        if abs(wrapped(again - found[0] + holonomy)) > tau / 4:  # the sides changed an odd number of times
            return fill(stations, angles, known, holonomy)
        at, found = np.append(at, at[0] + stations.total), np.append(found, again)
        at, found = np.insert(at, 0, at[-2] - stations.total), np.insert(found, 0, found[-2] - (again - found[0]))
    return np.interp(stations.s, at, found)


def nearest(steps, period):
    """Steps to the nearest of angles that are the same, and forward where one back is as near but for rounding."""
    return wrapped(steps - TIE, period) + TIE


def lost(stations, defined, flips):
    """The first place where a frame is not defined, or amid the first step in which it flips, as people read it."""
    domain = stations.trajectory.domain
    if not defined.all():
        return near(stations.u[np.argmin(defined)], *domain)
    step = np.argmax(flips)
    return near((stations.u[step] + np.append(stations.u, domain[1])[step + 1]) / 2, *domain)


def flipping(angles, stations, holonomy):
    """Where the angle jumps by more than a quarter turn from one station to the next: (n - 1,) or (n,) bool."""
    step = stations.steps(angles)
    if stations.closed:
        step[-1] -= holonomy
    return np.abs(wrapped(step)) > tau / 4
