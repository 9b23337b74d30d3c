# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Screws: motions that turn, which the contacts of a part allow or its own form suggests."""

import numpy as np

from ..vectors import cross, dot, norms
from .directions import main_normals
from .legs import Leg, Pose
from .slipping import Contacts

NEARS = (0.02, 0.06)  # of the part's size, and touching: of those parts of its surface that are so near, which slide
LEVEL = 0.02  # of the part's size: a screw of less pitch is a rotation
FEW = 3  # axes through the middle of the part, along the normals of its largest faces
MOST = 20 * 2 * np.pi  # of a turn at once
TURNS = (0.2, 0.5, 1.2, 3.0, 6.0)  # radians after which it is looked where a thread has come to
PLAY, HALF = 0.6, 30  # of the rise for a radian it may be off there; and places that are tried on each side
ALIKE = 1e-3  # of the size, and of an angle in radians


def screws(scene, pose, posed, touching):
    """Motions that turn a part, each once and the other way round.

    Parameters
    ----------
    scene : Scene
    pose : Pose
    posed : Body
        The part in that pose.
    touching : Contacts
        Of it there.

    Returns
    -------
    list of Leg
        Of one turn each, or as many as take the part out along the axis.
    """
    levels = [touching, *(Contacts.of(posed, scene.others, near * posed.size) for near in NEARS)]
    found = [screw for contacts in levels for screw in sliding(contacts, posed.size)]
    found = [(axis, point, followed(scene, pose, axis, point, rise)) for axis, point, rise in found]
    middle = centroid(posed)
    found += [(axis, middle, 0.0) for axis in main_normals(posed)[:FEW]]
    legs = [leg(scene, posed, axis, point, sign * rise, sign) for axis, point, rise in found for sign in (1, -1)]
    return distinct([each for each in legs if each is not None], posed)


def sliding(contacts, size):
    """The screws in which contacts slide: for each its unit axis, a point of it, and its rise for a radian."""
    return [screw for speeds, turns in contacts.twists() if len(turns) for screw in axes_of(speeds, turns, size)]


def axes_of(speeds, turns, size):
    """The screws that a set of motions is made of, beside its translations."""
    left, sizes, _ = np.linalg.svd(turns * size)
    rank = int((sizes > ALIKE).sum())
    straight, _ = np.linalg.qr((left[:, rank:].T @ speeds).T)  # translations among them, which are no part of a screw
    found = []
    for column in left[:, :rank].T:
        turn, speed = column @ turns, column @ speeds
        scale = norms(turn)
        axis, speed = turn / scale, speed / scale
        speed = speed - straight @ (straight.T @ speed)
        rise = float(dot(axis, speed))
        found.append((axis, cross(axis, speed), rise if abs(rise) * 2 * np.pi > LEVEL * size else 0.0))
    return found


def followed(scene, pose, axis, point, rise):
    """The rise of a screw, more exactly: flat faces tell it roughly, and in a turn a thread would leave its groove.

    The further the part is turned, the more exactly the middle of the play that it has along the axis there tells it.
    """
    if not rise:
        return 0.0
    start = amid_play(scene, pose, axis, point, 0.0, 0.0, abs(rise))
    for angle in TURNS:
        middle = amid_play(scene, pose, axis, point, angle, rise * angle, PLAY * abs(rise))
        if start is None or middle is None:
            return rise
        rise = (middle - start) / angle
    return rise


def amid_play(scene, pose, axis, point, angle, along, room):
    """The middle of the places along an axis at which a part turned about it is free; None if it is so at no place.

    Parameters
    ----------
    angle : float
        By which it is turned.
    along, room : float
        About which place it is looked for, and how far away, in metres: of several stretches the nearest counts.
    """
    places = along + room * np.linspace(-1, 1, 2 * HALF + 1)
    turned = Leg(np.zeros(3), point, axis, angle).pose(1.0).after(pose)
    free = [not scene.blocked(Pose(turned.matrix, turned.origin + place * axis)) for place in places]
    where = np.flatnonzero(free)
    if not len(where):
        return None
    stretches = np.split(where, np.flatnonzero(np.diff(where) > 1) + 1)
    nearest = min(stretches, key=lambda stretch: abs(stretch - HALF).min())
    return float(places[nearest].mean())


def leg(scene, posed, axis, point, rise, sign):
    """The leg of a screw, as far as it may have to go; the turn is about plus or minus the axis."""
    angle = 2 * np.pi
    if rise:
        way = np.sign(rise) * axis
        travel = (scene.everything @ way).max() - (posed.vertices @ way).min()
        angle = min(max(travel, 0.0) / abs(rise) + 0.1, MOST)
    return Leg(rise * angle * axis, point, sign * axis, angle)


def centroid(body):
    """The middle of what a body holds: (3,) float array."""
    corners = body.corners - body.middle
    volumes = np.linalg.det(corners)
    return body.middle + (volumes[:, None] * corners.sum(axis=1)).sum(axis=0) / (4 * volumes.sum())


def distinct(legs, posed):
    """Legs that take the part elsewhere than those before, as two of its points tell after a tenth of a radian."""
    kept, places = [], []
    for each in legs:
        place = each.pose(min(0.1 / each.angle, 1.0)).of(posed.vertices[[0, len(posed.vertices) // 2]])
        if all(np.abs(place - other).max() > ALIKE * posed.size for other in places):
            kept.append(each)
            places.append(place)
    return kept
