# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of rotational sweeps: a contour on both sides of the axis, and a screw whose turns meet."""

import numpy as np

from ..parting import sides
from ..vectors import dot
from .detect import largest, meetings
from .folds import between
from .lattice import Lattice
from .places import Place, Places


def of_rotation(shape):
    """The places where a rotational sweep meets itself: `Places`."""
    sections = shape.sections()
    axis = np.append(shape.axis_point, 0.0)
    across = [both_sides(shape.turn, axis) for section in sections if all(sides(section))]
    if not shape.pitch:
        return Places(across, lambda: 0.0 if across else np.inf)
    turns = shape.turns(sections)
    lattices = [lattice_of(shape, section, turns) for section in sections if section.edge_lengths.any()]
    places = [*across, *(place for lattice in lattices for place in meetings(lattice, ()))]
    return Places(places, lambda: min((largest(lattice, np.inf, not places) for lattice in lattices), default=np.inf))


def both_sides(turn, point):
    """The place of a contour that crosses the axis."""
    stretch = between(0.0, turn, sorted((0.0, turn)))
    said = f"from {stretch} the contour is on both sides of the axis, and passes through it."
    return Place("local", ((0.0, float(turn)),), tuple(point.tolist()), said)


def lattice_of(shape, section, turns):
    """The lattice of a section that turns and rises: its contours lean against their way."""
    mesh = shape.body(section, turns, np.float64)
    place, radial, along = shape.rings(turns)
    x, y = section.centroid
    path = place + x * radial + y * along
    forward = np.cross(along, radial)
    forward *= np.sign(dot(forward[:-1], np.diff(radial, axis=0)).sum())
    leaning = np.full(len(turns), True)
    return Lattice.of_vertices(mesh.chart.grid, mesh.vertices, path, forward, turns, shape.turn, leaning)
