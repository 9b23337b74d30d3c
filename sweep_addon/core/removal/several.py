# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Several legs: translations and screws one after the other, each as far as something opens or nothing goes on."""

from collections import deque

import numpy as np

from ..declared.frozen import individual
from .bodies import Body
from .directions import candidates
from .legs import START, Leg
from .screws import screws
from .slipping import NEAR, Contacts
from .stops import stops
from .straight import ways_out

DEEPEST = 3  # motions before the last straight way
MOVES = 24  # of these directions the first so many, where another motion follows
SAME = 0.005  # of the part's size: a place so near to another one is that


@individual
class Place:
    """A pose that motions lead to.

    Parameters
    ----------
    pose : Pose
    legs : tuple of Leg
        That lead there.
    posed : Body
        The part there.
    touching : Contacts
        Of it.
    directions : (n, 3) float array
        In which it may get on.
    """

    pose: object
    legs: tuple
    posed: object
    touching: object
    directions: np.ndarray

    @classmethod
    def of(cls, scene, pose, legs):
        """The place of a pose."""
        posed = Body(scene.part.name, pose.of(scene.part.vertices), scene.part.triangles)
        touching = Contacts.of(posed, scene.others, NEAR * scene.tolerance)
        return cls(pose, legs, posed, touching, candidates(posed, scene.others, touching))

    def motions(self, scene):
        """Translations and screws from here, as far as they may have to go: a list of Leg."""
        some = self.directions[:MOVES]
        straight = [Leg(way * far) for way, far in zip(some, scene.travels(some, self.pose), strict=True)]
        turning = screws(scene, self.pose, self.posed, self.touching)
        return [*straight[: len(turning)], *turning, *straight[len(turning) :]]


def chains(scene, distance, budget, progress):
    """Chains of legs by which a part seems to get out, by samples, the shortest chains first.

    Parameters
    ----------
    scene : Scene
    distance : float, optional
        How far the last straight way goes, in metres.
    budget : int
        So many poses are tried, roughly.
    progress : callable
        Is told which part of them.

    Yields
    ------
    tuple of Leg
    """
    places, seen, first = deque([Place.of(scene, START, ())]), [corners(scene, START)], scene.asked
    while places:
        place = places.popleft()
        for leg in place.motions(scene):
            if scene.asked - first >= budget:
                return
            progress((scene.asked - first) / budget)
            if leg.turns and leg.carried and is_out(scene, place.directions, leg.pose(1.0).after(place.pose)):
                if scene.is_free(leg, place.pose):
                    yield (*place.legs, leg)
            for part in stops(scene, leg, place.pose, place.directions):
                there = leg.pose(part).after(place.pose)
                marks = corners(scene, there)
                if any(np.abs(marks - other).max() <= SAME * scene.part.size for other in seen):
                    continue
                seen.append(marks)
                found = Place.of(scene, there, (*place.legs, leg.until(part)))
                if leg.turns and is_out(scene, found.directions, there):
                    yield found.legs
                for last in ways_out(scene, found.directions, there, distance):
                    yield (*found.legs, last)
                if len(found.legs) < DEEPEST:
                    places.append(found)


def corners(scene, pose):
    """Four points of the part's space where it is: they tell poses apart."""
    return pose.of(scene.part.size / 2 * np.concatenate((np.zeros((1, 3)), np.eye(3))))


def is_out(scene, directions, pose):
    """Whether a plane across one of directions (n, 3) parts the part from all around."""
    own, others = pose.of(scene.part.vertices) @ directions.T, scene.everything @ directions.T
    return bool((own.min(axis=0) > others.max(axis=0)).any())
