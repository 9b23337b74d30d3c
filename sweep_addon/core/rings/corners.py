# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Corners: what becomes of the places where straight legs of a trajectory meet.

A kind says how much of both legs it cuts off at a corner; what is put there instead is a short straight leg, or an arc.
"""

import numpy as np

from ..declared.parameters import declared, length, parameter

__all__ = ["Bevel", "Corner", "Mitre", "Round"]

UNLIMITED = 20_000.0  # widths: at the sharpest turn there is, of 179.99 degrees, a mitre is 11,459 widths long


@declared
class Mitre:
    """One ring in the bisector plane: both legs keep their cross-section

    The length of a mitre, from the inner edge of the corner to the outer, is the contour's width over the sine of half
    the angle between the legs, as in SVG, and so is what becomes of a corner beyond the limit: a bevel from where the
    outer side of one leg ends, square to the corner, to where that of the other begins. The inner sides meet as those
    of a mitre do, if both legs are three times as long as the bevel takes of them.

    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.trajectories import Polyline
    >>> hairpin = Polyline([(0, 0, 0), (2, 0, 0), (0, 0.2, 0)], corner=Mitre(limit=4))
    >>> GeneralizedCylinder(trajectory=hairpin).mesh().told
    ('Corner: the mitre at point 2 would be 20.1 widths long, and the limit is 4; it is bevelled.',)
    """

    limit: float = parameter(
        UNLIMITED,
        "Longest mitre, in widths of the contour; a corner that needs a longer one is bevelled",
        minimum=1.0,
        soft_maximum=20.0,
    )


@declared
class Round:
    """A circular arc that touches both legs

    >>> from sweep_addon.core.trajectories import Polyline
    >>> path = Polyline([(0, 0, 0), (2, 0, 0), (2, 2, 0)], corner=Round(0.5))
    >>> round(path.length() - (1.5 + 1.5 + 0.5 * np.pi / 2), 12)
    0.0
    """

    radius: float = length(0.1, "Radius of the arc, which the centre of the contour follows")

    def setbacks(self, turns):
        """What each corner of these turns in radians takes from both its legs, in metres: (n,) to (n,)."""
        return self.radius * np.tan(turns / 2)


@declared
class Bevel:
    """A short straight leg across the corner, with two mitres of half the turn

    >>> from sweep_addon.core.trajectories import Polyline
    >>> path = Polyline([(0, 0, 0), (4, 0, 0), (4, 4, 0)], corner=Bevel(3.0))
    >>> round(path.length() - (1 + 3 * 2**0.5 + 1), 12)
    0.0
    """

    # A length along the legs, as a chamfer on a drawing: what is cut off does not depend on the contour, so the
    # trajectory stays a curve of its own. The length of the cut itself would take ever more of the legs the less
    # they turn.
    setback: float = length(0.1, "Where each leg is cut, measured from the corner")

    def setbacks(self, turns):
        """The same from every leg: (n,) to (n,)."""
        return np.full_like(turns, self.setback)


Corner = Mitre | Round | Bevel


def __dir__():
    return __all__  # what a console offers
