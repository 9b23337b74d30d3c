# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ends: what closes a sweep where its trajectory starts and ends."""

from ..declared.parameters import declared, length, parameter

__all__ = ["Cap", "End", "Flat", "Open", "Round", "Taper"]


@declared
class Flat:
    """A flat face, holes left open

    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> len(GeneralizedCylinder(start=Flat(), end="flat").mesh().boundary_edges())
    0
    """


@declared
class Open:
    """No face: the sweep stays a surface

    >>> from sweep_addon.core.contours import Circle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> len(GeneralizedCylinder(Circle(0.1, points=16), end=Open()).mesh().boundary_edges())
    16
    """


@declared
class Taper:
    """The contour shrinks evenly to a point

    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.trajectories import Line
    >>> pyramid = GeneralizedCylinder(Rectangle(1.0, 1.0), Line(end=(0, 0, 3)), end=Taper(3.0))
    >>> round(pyramid.mesh().volume(), 12), len(pyramid.mesh().vertices)
    (1.0, 5)
    """

    length: float = length(0.25, "How much of the trajectory the point takes")


@declared
class Round:
    """A dome beyond the trajectory: of a circle half a ball

    Its height is measured in half breadths of the contour, the distance from its centroid to the nearest side.

    >>> from math import pi
    >>> from sweep_addon.core.contours import Circle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.stations.sampling import Tolerance
    >>> from sweep_addon.core.trajectories import Line
    >>> pill = GeneralizedCylinder(Circle(1.0, 256), Line(), Tolerance(1e-4), start=Round(), end=Round()).mesh()
    >>> round(pill.volume() / (pi + 4 / 3 * pi), 3)
    1.0
    """

    height: float = parameter(
        1.0, "Height in half breadths of the contour; 1 makes half a ball of a circle", above=0.0, soft_maximum=4.0
    )


End = Flat | Open | Taper | Round
Cap = Flat | Open


def __dir__():
    return __all__  # what a console offers
