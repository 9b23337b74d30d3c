# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solid of a shape: the boundary of the set of all points that its contour visits."""

from dataclasses import replace

from ..booleans import union
from .resolve import require_closed, resolved


def along_a_trajectory(shape, progress=None):
    """The solid of a shape whose rings stand along a trajectory."""
    return resolved(shape.surface(), progress, lambda: bool(shape.self_intersections()))


def about_an_axis(shape, progress=None):
    """The solid of a rotational sweep.

    What turns about an axis without rising meets itself only where something is on both sides of the axis: each side
    makes a body that does not.
    """
    if shape.pitch:
        solids = [resolved(body, progress) for body in shape.bodies()]
        return solids[0] if len(solids) == 1 else union(solids)
    sides = replace(shape, crossing="split", regularize=False).bodies() if shape.crossing.name != "REFUSE" else ()
    if len(sides) < 2:
        return as_it_is(shape)
    for side in sides:
        require_closed(side)
    return replace(union(sides), told=shape.surface().told)


def as_it_is(shape):
    """The solid of a shape that does not meet itself."""
    mesh = shape.surface()
    require_closed(mesh)
    return mesh
