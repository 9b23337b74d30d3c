# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools of milling machines: solids of revolution about the z axis, which stand on their tips.

Each knows how high its surface is above the tip at a distance from the axis, a convex function, and where along a
straight move it leaves the least above a place. Above its tip a tool is as wide as its flutes, without end.
"""

import numpy as np

from ..declared.parameters import angle, declared, length, parameter, require

STEPS = 60  # of the search for the lowest place of a bull nose, each of which halves where it may be
EXACT = 1e-15


class Cutter:
    """A tool. A kind gives ``radius``, ``rise(distance)`` and ``ahead(across, slope)``."""

    @property
    def radius(self):
        return self.diameter / 2

    def reach(self, across):
        """How far from the foot of a place on a move the tool still covers that place.

        Parameters
        ----------
        across : array
            Distances of places from the line of the move, seen from above, in metres.

        Returns
        -------
        array of the same shape
            In metres; 0 where it is out of reach.
        """
        return np.sqrt(np.maximum(self.radius**2 - across**2, 0.0))


@declared
class FlatEnd(Cutter):
    """A flat end mill: a cylinder

    >>> FlatEnd(diameter=0.01).rise(np.array([0.0, 0.005])).tolist()
    [0.0, 0.0]
    """

    diameter: float = length(0.006, "Of the tool")

    def rise(self, distance):
        """How high the surface is above the tip at a distance from the axis: the same shape, in metres."""
        return np.zeros_like(distance)

    def ahead(self, across, slope):
        """Where the tool is lowest above a place, from its foot on along the move: that end that leads down."""
        return -np.sign(slope) * self.reach(across)


@declared
class BallNose(Cutter):
    """A ball nose: a half ball at the end of a cylinder

    >>> BallNose(diameter=2.0).rise(np.array([0.0, 0.6, 1.0])).round(12).tolist()
    [0.0, 0.2, 1.0]
    """

    diameter: float = length(0.006, "Of the tool")

    def rise(self, distance):
        return self.radius - self.reach(distance)

    def ahead(self, across, slope):
        """Where the normal of the ball is across the move."""
        return -slope * self.reach(across) / np.sqrt(1 + slope**2)


@declared
class BullNose(Cutter):
    """A bull nose: a flat end mill whose edge is rounded

    >>> BullNose(diameter=2.0, corner=0.5).rise(np.array([0.5, 0.8, 1.0])).round(12).tolist()
    [0.0, 0.1, 0.5]
    """

    diameter: float = length(0.006, "Of the tool")
    corner: float = length(0.001, "Radius of the rounded edge")

    def check(self):
        """Refuse an edge that is rounder than a ball nose."""
        most = self.diameter / 2
        require(self.corner <= most, f"must be at most {most:g}, half the diameter", self.corner, "corner")

    def rise(self, distance):
        beyond = np.clip(distance - (self.radius - self.corner), 0.0, self.corner)
        return self.corner - np.sqrt(self.corner**2 - beyond**2)

    def ahead(self, across, slope):
        """Where the slope of the tool's surface along the move is the move's own, by halving: it rises all the way."""
        steep = np.abs(slope)
        far = self.reach(across)
        near = np.sqrt(np.maximum((self.radius - self.corner) ** 2 - across**2, 0.0))
        near, far = np.broadcast_arrays(np.where(steep > 0, near, 0.0), np.where(steep > 0, far, 0.0))
        for _ in range(STEPS if steep.any() else 0):
            middle = (near + far) / 2
            distance = np.sqrt(across**2 + middle**2)
            beyond = np.minimum(distance - (self.radius - self.corner), self.corner)
            left = np.sqrt(np.maximum(self.corner**2 - beyond**2, 0.0))
            low = beyond * middle < steep * distance * left
            near, far = np.where(low, middle, near), np.where(low, far, middle)
        return -np.sign(slope) * far


@declared
class Cone(Cutter):
    """A cone: a V-bit, an engraver, or a drill, pointed or with a flat tip

    >>> Cone(diameter=0.02, tip=0.0, angle=np.pi / 2).rise(np.array([0.0, 0.004, 0.01])).round(12).tolist()
    [0.0, 0.004, 0.01]
    """

    diameter: float = length(0.006, "Where the cone ends")
    tip: float = parameter(0.0, "Diameter of the flat tip", unit="length", minimum=0.0)
    angle: float = angle(np.pi / 3, "Between opposite sides", minimum=0.01, maximum=3.14)

    def check(self):
        """Refuse a tip that is no less wide than the cone."""
        require(self.tip < self.diameter, f"must be less than {self.diameter:g}, the diameter", self.tip, "tip")

    @property
    def steepness(self):
        return 1 / np.tan(self.angle / 2)

    def rise(self, distance):
        return self.steepness * np.maximum(distance - self.tip / 2, 0.0)

    def ahead(self, across, slope):
        """Where the side of the cone is as steep along the move as that, or the edge of the tip if it is farther."""
        steep = np.abs(slope)
        with np.errstate(divide="ignore", invalid="ignore"):
            side = steep * across / np.sqrt(np.maximum(self.steepness**2 - steep**2, 0.0))
        side = np.where(steep < self.steepness, side, np.inf)
        edge = np.sqrt(np.maximum((self.tip / 2) ** 2 - across**2, 0.0))
        return -np.sign(slope) * np.minimum(np.maximum(side, edge), self.reach(across))


Tool = FlatEnd | BallNose | BullNose | Cone


@declared
class Numbered:
    """The tool that a program calls by a number

    >>> Numbered(3, "ball-nose").tool.diameter
    0.006
    """

    number: int = parameter(1, "By which T calls it", minimum=0, maximum=2**31 - 1)
    tool: Tool = parameter(FlatEnd(), "What it is")
