# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ends: what closes a sweep where its trajectory starts and ends."""

from .parameters import declared, length


@declared
class Flat:
    """A flat face, holes left open

    >>> from sweep_addon.core.generalized_cylinder import GeneralizedCylinder
    >>> len(GeneralizedCylinder(start=Flat(), end="flat").mesh().boundary_edges())
    0
    """


@declared
class Open:
    """No face: the sweep stays a surface

    >>> from sweep_addon.core.contours import Circle
    >>> from sweep_addon.core.generalized_cylinder import GeneralizedCylinder
    >>> len(GeneralizedCylinder(Circle(0.1, points=16), end=Open()).mesh().boundary_edges())
    16
    """


@declared
class Taper:
    """The contour shrinks evenly to a point

    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.trajectories import Line
    >>> pyramid = GeneralizedCylinder(Rectangle(1.0, 1.0), Line(end=(0, 0, 3)), end=Taper(3.0))
    >>> round(pyramid.mesh().volume(), 12), len(pyramid.mesh().vertices)
    (1.0, 5)
    """

    length: float = length(0.25, "How much of the trajectory the point takes")


End = Flat | Open | Taper
