# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The body of a generalized cylinder: its contours where they stand, and all that its mesh is drawn from."""

from typing import NamedTuple

import numpy as np

from ..contours import Section
from ..grids.chart import Chart
from ..stations.sampling import Stations
from ..variation.along import Along


class Body(NamedTuple):
    """The contours of a sweep at its stations, what closes it at the ends left out."""

    section: Section  # as it is drawn: a mirrored one where the laws or the way mirror it
    change: object  # the Changing that it begins, mirrored likewise; or None
    rings: np.ndarray  # the middle of each and its two axes, scaled: (3, n, 3)
    scales: np.ndarray  # along e2 and e3: (n, 2)
    tips: np.ndarray  # which are a point: (n,) bool
    backward: bool  # whether the middles run against the trajectory
    told: tuple  # sentences for people

    @property
    def ends(self):
        """The sections at the start and at the end."""
        return self.change.ends if self.change else (self.section, self.section)


class Swept(NamedTuple):
    """A sweep before its vertices are multiplied out."""

    stations: Stations
    along: Along
    symmetry: int  # in how many turns the section is mapped to itself
    body: Body
    rings: np.ndarray  # the middle of each and its axes, those of the domes among them: (3 or more, n, 3)
    shape: np.ndarray  # the weights of the axes, that is the section's points: (m, 2 or more)
    tips: np.ndarray  # which rings are a point: (n,) bool
    chart: Chart
    told: tuple  # sentences for people
