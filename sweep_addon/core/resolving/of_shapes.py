# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solid of a shape: the boundary of the set of all points that its contour visits."""

from dataclasses import replace

from ..meshes.booleans import union
from ..self_intersection.places import Places
from .breaks import breaks
from .resolve import closed, resolved
from .rings import Rings


def along_a_trajectory(shape, progress=None):
    """The solid of a shape whose rings stand along a trajectory."""
    surface = replace(shape, make_solid=False)
    return once(resolved(surface.mesh(), progress, lambda: bool(surface.self_intersections())))


def of_cylinder(shape, progress=None):
    """The solid of a generalized cylinder, which may have corners and leaps of its frame."""
    surface = replace(shape, make_solid=False)
    mesh = closed(surface.mesh())
    found = breaks(surface, Rings(mesh))
    return once(resolved(mesh, progress, lambda: bool(surface.self_intersections()), found))


def about_an_axis(shape, progress=None):
    """The solid of a rotational sweep.

    What turns about an axis without rising meets itself only where something is on both sides of the axis: each side
    makes a body that does not.
    """
    if shape.pitch:
        solids = [resolved(body, progress) for body in shape.bodies()]
        return once(solids[0] if len(solids) == 1 else union(solids))
    sides = replace(shape, crossing="split", regularize=False).bodies() if shape.crossing.name != "REFUSE" else ()
    if len(sides) < 2:
        return closed(shape.surface())
    return union([closed(side) for side in sides])


def once(mesh):
    """A mesh that does not meet itself, and does not say so."""
    return replace(mesh, told=Places(()).in_place_of(mesh.told))
