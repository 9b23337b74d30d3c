# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The aerofoils of the NACA four-digit series, as contours."""

import re
from enum import Enum

import numpy as np

from ..declared.parameters import count, declared, length, parameter, require
from ..later import later

Section = later("core.contours.section", "Section")

ROOT, FIRST, SECOND, THIRD = 0.2969, -0.126, -0.3516, 0.2843  # of the square root of x and of its powers
OPEN, CLOSED = -0.1015, -0.1036  # of the fourth power
NODES = 32  # of the quadrature for the area, before and behind the highest camber


class TrailingEdge(Enum):
    CLOSED = "The two sides meet in one sharp edge: the last coefficient is 0.1036"
    OPEN = "As published, 0.0021 of the thickness apart: the last coefficient is 0.1015"


@declared
class Aerofoil:
    """A wing section of the NACA four-digit series

    The chord lies along x, which is e2 of the frame, the nose towards -x, the upper side towards +y. The reference
    point is on the chord, by default a quarter from the nose: the aerodynamic centre, about which wings are laid out
    and twisted. Points are spaced by the cosine, closest at the nose and the trailing edge, which is sharp.

    Source
    ------
    Jacobs, Ward, Pinkerton: The characteristics of 78 related airfoil sections from tests in the variable-density wind
    tunnel, NACA Report 460, 1933: thickness and mean line, of which the thickness is laid off at right angles. The
    last coefficient 0.1036, which closes the trailing edge, is a later custom.

    Examples
    --------
    >>> section = Aerofoil(code="0012", reference=0.0, side_points=5).section()
    >>> section.points.round(4).tolist()[1:3]
    [[0.8536, 0.0194], [0.5, 0.0529]]
    """

    code: str = parameter(
        "2412", "Four digits: camber in hundredths of the chord, its place in tenths, thickness in hundredths"
    )
    chord: float = length(1.0, "Distance from the nose to the trailing edge")
    reference: float = parameter(
        0.25, "Where on the chord the reference point is, 0 the nose, 1 the trailing edge", minimum=0.0, maximum=1.0
    )
    trailing_edge: TrailingEdge = parameter(TrailingEdge.CLOSED, "Whether the two sides meet behind")
    side_points: int = count(
        33, "Points along each side, nose and trailing edge among them", minimum=3, maximum=512, soft_maximum=65
    )

    def check(self):
        """Refuse a code that is not four digits, has one of camber and place without the other, or no thickness."""
        named = re.fullmatch("[0-9]{4}", self.code)
        require(named, "must be the four digits of a NACA aerofoil, such as 2412", self.code, "code")
        camber, place = (digit == "0" for digit in self.code[:2])
        require(camber == place, "must have a camber and its place, or 00 for neither", self.code, "code")
        require(self.code[2:] != "00", "must have a thickness, its last two digits", self.code, "code")

    @property
    def area(self):
        """What the curve encloses, in square metres: the thickness, integrated along the mean line."""
        nodes, weights = np.polynomial.legendre.leggauss(NODES)
        place = np.sqrt(self.mean_line[1])
        total = 0.0
        for start, end in ((0.0, place), (place, 1.0)):  # in the square root of x, of which all is smooth
            root = start + (end - start) * (nodes + 1) / 2
            along = 2 * root * np.hypot(1, self.mean(root**2)[1])
            total += (end - start) * (weights @ (self.half_thickness(root**2) * along))
        return float(total) * self.chord**2

    def section(self):
        """The polygon as a `Section` of one loop: from the trailing edge over the upper side to the nose and back."""
        upper, lower = self.sides(np.linspace(0, np.pi, self.side_points))
        last = None if self.trailing_edge is TrailingEdge.OPEN else -1
        points = np.concatenate([upper, lower[-2::-1][:last]])
        sharp = np.zeros(len(points), dtype=bool)
        sharp[[0, -1] if self.trailing_edge is TrailingEdge.OPEN else 0] = True
        return Section(points, np.array([0, len(points)]), sharp)

    def apexes(self):
        """(m, 2) float array: a point of the curve about farthest from each edge."""
        steps = self.side_points - 1
        upper, lower = self.sides(np.pi * (np.arange(steps) + 0.5) / steps)
        behind = sum(self.sides(np.zeros(1))) / 2
        return np.concatenate([upper, lower[::-1], *([behind] if self.trailing_edge is TrailingEdge.OPEN else ())])

    def sides(self, angles):
        """Points of the upper and of the lower side, (k, 2) float arrays, at angles from 0 behind to pi at the nose."""
        x = (1 + np.cos(angles)) / 2
        height, slope = self.mean(x)
        line = np.stack([x - self.reference, height], axis=1)
        across = np.stack([-slope, np.ones_like(x)], axis=1) * (self.half_thickness(x) / np.hypot(1, slope))[:, None]
        return self.chord * (line + across), self.chord * (line - across)

    @property
    def mean_line(self):
        """The highest camber and its place, in chords; without camber any place will do."""
        return int(self.code[0]) / 100, int(self.code[1]) / 10 or 0.5

    def mean(self, x):
        """Height and slope of the mean line, two parabolas that meet at the highest camber, at (k,) places."""
        camber, place = self.mean_line
        reach = np.where(x < place, place, 1 - place)
        return camber * (1 - ((x - place) / reach) ** 2), 2 * camber * (place - x) / reach**2

    def half_thickness(self, x):
        """Half the thickness, in chords, at (k,) places."""
        last = CLOSED if self.trailing_edge is TrailingEdge.CLOSED else OPEN
        half = ROOT * np.sqrt(x) + x * (FIRST + x * (SECOND + x * (THIRD + x * last)))
        return int(self.code[2:]) / 100 / 0.2 * half
