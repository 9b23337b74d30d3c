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
from ..later import later
from ..vectors import cross, unit

rotated, signed_angle = later("core.stations.rotations", "rotated", "signed_angle")
turned, wrapped = later("core.stations.rotations", "turned", "wrapped")
transport = later("core.stations.transport", "transport")
along_path, closely, continued = later("core.stations.continuing", "along_path", "closely", "continued")

__all__ = ["Continuation", "FixedUp", "Frame", "Frames", "Frenet", "Parallel", "RotationMinimizing"]

TOO_FAST = tau / 8  # radians: where a frame turns by more from place to place no number of contours makes it smooth
UPRIGHT = 1e-6  # radians: a path that is no farther from the up direction has no side that is up
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
        For each loop of the contour its points at each place, inscribed; the last leads back to the first. Of a draft
        whose edges vanish or part, each loop at each place alone.
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
        if not continued(self, stations.trajectory).defined:
            return angles, ("Frame: the trajectory is straight and has no Frenet frame; the first normal is kept.",)
        return angles, (f"Frame: the curvature vanishes near u = {place}, where the Frenet frame is not defined.",)

    @property
    def keeps_its_side(self):
        """Whether it goes on with the side it has where that of its definition changes."""
        return self.continuation is Continuation.SMOOTH

    def towards(self, stations, normals):
        """The angle of the centre of curvature from the rotation-minimizing normals, and where there is one: (n,)."""
        bend, corners = stations.bend.copy(), stations.corners
        at_corners = turned(bend[corners], stations.tangent[corners], stations.leave[corners])
        goes_on = np.linalg.norm(stations.going_on, axis=1, keepdims=True) * stations.total > STRAIGHT
        bend[corners] = np.where(goes_on, stations.going_on, at_corners)
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
        return signed_angle(normals, level, stations.leave), np.linalg.norm(level, axis=1) > UPRIGHT


@declared
class Parallel:
    """The generator's axes stay those of space

    >>> from sweep_addon.core.shapes.general_sweep import GeneralSweep
    >>> from sweep_addon.core.contours import Rectangle
    >>> mesh = GeneralSweep(Rectangle(1.0, 1.0), frame="parallel").mesh()
    >>> bool(abs(mesh.vertices[:, 2]).max() < 1e-12)  # along an arc in its own plane
    True
    """

    extra_sectors = 0


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
        if (turned_by == turned_by[0]).all():  # as nearly always
            turned_by = turned_by[:1]
        cosine, sine = np.cos(turned_by)[:, None], np.sin(turned_by)[:, None]
        e2, e3 = cosine * normals + sine * across, cosine * across - sine * normals
    else:
        e2, e3 = normals, across
    if len(corners):
        e2, e3 = np.array(e2), np.array(e3)  # others keep what turns least
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
        Arc lengths in metres from end to end, closer to each other where the frame turns fast.
    angle : (n,) float array
        What it has turned about the tangent by then, in radians, jumps left out. Opposite sides count as one, as the
        frame goes on with either after an inflection.
    """
    s, placed = closely(frame, trajectory)
    normals, holonomy = rotation_minimizing(placed)
    angles = frame.angles(placed, normals, holonomy, 1)[0]
    if trajectory.closed:
        angles = np.append(angles, angles[0] - holonomy)
    steps = wrapped(np.diff(angles), tau / 2)
    steps[np.abs(steps) > TOO_FAST] = 0.0
    steps[placed.corners - 1] = 0.0  # of a closed trajectory the last one leads to the first corner
    return s, np.concatenate(([0.0], np.cumsum(steps)))


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
    start = first_normal(stations.tangent[:1])
    if len(stations.corners):  # a closed trajectory may start with one
        start = turned(start, stations.tangent[:1], stations.leave[:1])
    first = signed_angle(reference[:1], start, stations.leave[:1])
    normals = rotated(reference, stations.leave, first + angle - angle[0])
    normals.flags.writeable = False
    return normals, carried.holonomy


@lru_cache(maxsize=16)
def binormals(stations):
    """What is across the rotation-minimizing normals and ``stations.leave``: unit vectors, (n, 3)."""
    across = cross(stations.leave, rotation_minimizing(stations)[0])
    across.flags.writeable = False
    return across


def first_normal(tangent):
    """The normal that Blender's Curve to Mesh starts with: level, or along x where the tangent is vertical."""
    x, y = tangent[0, :2]
    normal = np.array([[y, -x, 0.0]]) if abs(x) + abs(y) >= 1e-4 else np.array([[1.0, 0.0, 0.0]])
    return unit(normal - (normal @ tangent[0]) * tangent)
