# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Cubics: chains of parametric cubic segments, told in any of three bases and kept in that of Bezier."""

from enum import Enum

import numpy as np

from ..declared.parameters import require

TO_BEZIER = {  # the four Bezier points of a segment from the four rows that it is told by
    "BEZIER": ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)),
    "HERMITE": ((1, 0, 0, 0), (1, 1 / 3, 0, 0), (0, 0, 1, -1 / 3), (0, 0, 1, 0)),
    "B_SPLINE": ((1 / 6, 4 / 6, 1 / 6, 0), (0, 4 / 6, 2 / 6, 0), (0, 2 / 6, 4 / 6, 0), (0, 1 / 6, 4 / 6, 1 / 6)),
}
STEP = {"BEZIER": 3, "HERMITE": 2, "B_SPLINE": 1}  # rows from the start of a segment to that of the next


class Basis(Enum):
    BEZIER = "Knot, handle, handle, knot, and so on: 1 more than a multiple of 3"
    HERMITE = "Knot and its derivative by the parameter, which counts segments, and so on: an even number"
    B_SPLINE = "Control values of a uniform cubic B-spline: 4 or more"

    def require_segments(self, rows, key):
        """Refuse a number of rows that makes no whole number of segments."""
        name = self.name.lower().replace("_", "-")
        require(rows >= 4, "must have at least 4 rows", rows, key)
        whole = (rows - 4) % STEP[self.name] == 0
        form = "an even number" if self is Basis.HERMITE else "1 more than a multiple of 3"
        require(whole, f"must be {form} in the basis {name}", rows, key)

    def segments(self, rows):
        """The Bezier points of each segment: (n, c) to (k, 4, c).

        >>> Basis.HERMITE.segments(np.array([[0.0], [3.0], [1.0], [0.0]])).ravel().tolist()
        [0.0, 1.0, 1.0, 1.0]
        """
        first = np.arange(0, len(rows) - 3, STEP[self.name])
        return np.array(TO_BEZIER[self.name]) @ rows[first[:, None] + np.arange(4)]
