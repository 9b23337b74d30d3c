# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The PD curve: six components (px, py, pz, dx, dy, dz), position and direction, of one parametric cubic."""

import numpy as np

from ..declared.parameters import Array, declared, parameter
from ..trajectories import Bezier
from .cubics import Basis
from .directions import Cubic

DEFAULT = ((0, 0, 0, 1, 0, 0), (0, 0, 0.5, 1, 0, 0), (0, 0.5, 1, 0, 0, 1), (0, 1, 1, 0, 0, 1))


@declared
class PDCurve:
    """Position and direction as one parametric cubic, (p(t), d(t))

    Source
    ------
    The lecture's "Constant cross-section objects with PD curves": "a six-component curve, usually a parametric cubic".

    Examples
    --------
    A straight way, on which the direction turns by a right angle and begins and ends to do so evenly:

    >>> from sweep_addon.core.shapes.pd_curve_sweep import PDCurveSweep
    >>> curve = PDCurve(
    ...     [(0, 0, 0, 1, 0, 0), (0, 0, 2, 0, 1, 0), (0, 0, 2, 0, 1, 0), (0, 0, 2, -1, 0, 0)], basis="hermite"
    ... )
    >>> curve.evaluate([0.0, 1.0]).tolist()
    [[0.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0, 1.0, 0.0]]
    >>> solid = PDCurveSweep(trajectory=curve.position, direction=curve.direction)
    >>> len(solid.mesh().boundary_edges())
    0
    """

    rows: Array = parameter(DEFAULT, "Control values of px, py, pz in metres, and dx, dy, dz", columns=6, most=200_000)
    basis: Basis = parameter(Basis.BEZIER, "What the control values are")

    def check(self):
        """Refuse a number of rows that makes no segments."""
        self.basis.require_segments(len(self.rows), "rows")

    @property
    def position(self):
        """The trajectory p(t): a `Bezier`, whose parameter counts the segments."""
        return Bezier(joined(self.basis.segments(self.rows[:, :3])))

    @property
    def direction(self):
        """The direction d(t): a `Cubic`."""
        return Cubic(joined(self.basis.segments(self.rows[:, 3:])))

    def evaluate(self, t):
        """Position and direction at parameters.

        Parameters
        ----------
        t : (n,) array
            They count the segments.

        Returns
        -------
        (n, 6) float array
            Positions in metres, and directions as long as their cubic makes them.

        Examples
        --------
        >>> PDCurve([(0, 0, 0, 1, 0, 0)] * 2 + [(0, 0, 2, 0, 1, 0)] * 2).evaluate([0.5]).tolist()
        [[0.0, 0.0, 1.0, 0.5, 0.5, 0.0]]
        """
        position, direction = self.position, self.direction
        return np.concatenate((position.evaluate(t), direction.vectors(position, t)), axis=1)


def joined(segments):
    """Knot, handle, handle, knot, and so on, from the Bezier points of segments that follow each other: (n, c)."""
    return np.concatenate((segments[:, :3].reshape(-1, segments.shape[2]), segments[-1:, 3]))
