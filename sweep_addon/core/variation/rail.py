# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The rail, a curve that guides a contour, as it is declared; `rails` is what becomes of it."""

from enum import Enum

import numpy as np

from ..declared.parameters import declared, parameter
from ..trajectories import Line, Trajectory

__all__ = ["Guided", "Rail"]


class Guided(Enum):
    EVENLY = "The contour keeps its proportions between two rails"
    IN_WIDTH = "The contour keeps its height, and its width alone follows two rails"


@declared
class Rail:
    """A curve beside the trajectory that guides the contour

    >>> Rail(Line((1, 0, 0), (1, 0, 1))).path.length()
    1.0
    """

    path: Trajectory = parameter(Line((0.3, 0, 0), (0.3, 0, 1)), "Where the rail runs", accepts=("CURVE",))

    @classmethod
    def after(cls, shape):
        """One more for a shape: along its trajectory, to either side."""
        along, side = shape.trajectory, -0.3 if shape.rails else 0.3
        ends = along.evaluate(np.array(along.domain)) + (side, 0.0, 0.0)
        return cls(Line(*ends.tolist()))
