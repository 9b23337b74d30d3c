# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A part among what stands around it: what the search for a path asks, quickly; certificates come after it."""

from functools import cached_property

import numpy as np

from .certificate import clearance
from .legs import START, Leg, poses
from .shrinking import drawn_in
from .touching import Moving, Surroundings

FINEST, COARSEST = 1e-3, 0.02  # of the part's size its fastest point goes from sample to sample, at first and later
CLEAR = 1e-3  # of the size of the part it is beyond what it was to get out of
HALVINGS = 12  # by which the place where something blocks the way is closed in on


class Scene:
    """A part, drawn in by the contact tolerance, and the bodies around it, all about one origin.

    Parameters
    ----------
    part : Body
        As it is.
    others : list of Body
    tolerance : float
        In metres; 0 for the part as it is.
    origin : (3,) float array
        Where that origin is in the space of the assembly.
    """

    def __init__(self, part, others, tolerance, origin):
        self.part, self.others, self.tolerance, self.origin = part, others, tolerance, origin
        self.asked = 0  # poses
        self.proofs = {}  # the clearance on each leg that was looked at

    @cached_property
    def core(self):
        """The part drawn in, as a `Body`."""
        return drawn_in(self.part, self.tolerance)

    @cached_property
    def moving(self):
        return Moving(self.core.vertices, self.core.triangles)

    @cached_property
    def around(self):
        return Surroundings(self.others)

    @cached_property
    def everything(self):
        """All vertices around: (n, 3) float array."""
        return np.concatenate([other.vertices for other in self.others])

    def blocked(self, pose):
        """Whether the part touches anything in a `Pose`."""
        self.asked += 1
        return self.around.touched(self.moving.at(pose))

    def free_part(self, leg, pose):
        """Roughly which part of a leg from a pose is free, from 0 to 1, by samples."""
        size = self.part.size
        parts = samples(leg.speed(pose.of(self.core.vertices)) / size)
        before = 0.0
        for part in parts:
            if self.blocked(leg.pose(part).after(pose)):
                return self.closed_in(leg, pose, before, part)
            before = part
        return 1.0

    def closed_in(self, leg, pose, free, blocked):
        """The end of what is free of a leg, between a part at which it is and one at which it is not."""
        for _ in range(HALVINGS):
            middle = (free + blocked) / 2
            free, blocked = (free, middle) if self.blocked(leg.pose(middle).after(pose)) else (middle, blocked)
        return free

    def is_free(self, leg, pose):
        """Whether all samples of a leg are free."""
        parts = samples(leg.speed(pose.of(self.core.vertices)) / self.part.size)
        return not any(self.blocked(leg.pose(part).after(pose)) for part in parts)

    def run_into(self, directions):
        """The names of those around that the part runs into first in directions (n, 3) from where it stands."""
        found = set()
        for direction, far in zip(directions, self.travels(directions, START), strict=True):
            leg = Leg(far * direction)
            for part in samples(far / self.part.size):
                if self.blocked(leg.pose(part)):
                    found |= self.around.touching(self.moving.at(leg.pose(part)))
                    break
        return tuple(other.name for number, other in enumerate(self.others) if number in found)

    def certified(self, legs):
        """How far the part is proven to stay from all around on some legs, in metres; 0 if it may touch something."""
        least = np.inf
        for leg, pose in zip(legs, poses(legs)[:-1], strict=True):
            if leg not in self.proofs:  # chains share the legs that they begin with
                self.proofs[leg] = clearance(self.moving, self.around, leg, pose)
            least = min(least, self.proofs[leg])
            if least <= 0:
                return 0.0
        return float(least)

    @cached_property
    def exact(self):
        """The same scene with the part as it is."""
        return Scene(self.part, self.others, 0.0, self.origin)

    def travels(self, directions, pose):
        """How far the part goes in directions (n, 3) until a plane across parts it from all around: (n,) array."""
        own = pose.of(self.part.vertices) @ directions.T
        return np.maximum((self.everything @ directions.T).max(axis=0) - own.min(axis=0), 0.0) + CLEAR * self.part.size


def samples(length):
    """Parts of a leg at which it is looked, from near its beginning to 1, for a way of so many sizes of the part."""
    count = max(int(np.ceil(length / COARSEST)), 1)
    even = np.linspace(0.0, 1.0, count + 1)[1:]
    early = FINEST * 2.0 ** np.arange(5) / max(length, FINEST)
    return np.concatenate((early[early < even[0]], even)).tolist()
