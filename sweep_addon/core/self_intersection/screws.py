# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of rotational sweeps: a contour on both sides of the axis, and a screw whose turns meet."""

import numpy as np

from ..rings.parting import sides
from ..shapes.revolving import body_of, rings_of, turns_of
from ..vectors import dot
from .detect import largest, meetings
from .folds import between
from .lattice import Lattice
from .places import Place, Places


def of_rotation(shape):
    """The places where a rotational sweep meets itself: `Places`."""
    sections = shape.sections()
    if not shape.pitch:
        kept = any(all(sides(section)) for section in sections)
        through = kept or abs(shape.turn) > np.pi and level(sections)  # in half a turn the sides change places
        return Places(
            [both_sides(shape, sections[0])] if through else (), lambda: 0.0 if through else np.inf, at_once=True
        )
    turns = turns_of(shape, sections)
    lattices = [lattice_of(shape, section, turns) for section in sections if section.edge_lengths.any()]
    places = [place for lattice in lattices for place in meetings(lattice, ())]
    return Places(places, lambda: min((largest(lattice, np.inf, not places) for lattice in lattices), default=np.inf))


def level(sections):
    """Whether some sections, each on one side of the axis, are beside others on its other side."""
    left, right = ([section.points[:, 1] for section in sections if sides(section)[side]] for side in (0, 1))
    return bool(left and right) and any(max(a.min(), b.min()) < min(a.max(), b.max()) for a in left for b in right)


def both_sides(shape, section):
    """The place of a contour on both sides of the axis: where it crosses that."""
    stretch = between(0.0, shape.turn, sorted((0.0, shape.turn)))
    place, _, along = rings_of(shape, np.zeros(1))[:, 0]
    x, y = section.points.T
    point = place + y[np.abs(x).argmin()] * along
    said = f"from {stretch} the contour is on both sides of the axis, and passes through it."
    return Place("local", ((0.0, float(shape.turn)),), tuple(point.tolist()), said)


def lattice_of(shape, section, turns):
    """The lattice of a section that turns and rises: its contours lean against their way."""
    mesh = body_of(shape, section, turns, np.float64)
    place, radial, along = rings_of(shape, turns)
    x, y = section.centroid
    path = place + x * radial + y * along
    forward = np.cross(along, radial)
    forward *= np.sign(dot(forward[:-1], np.diff(radial, axis=0)).sum())
    leaning = np.full(len(turns), True)
    return Lattice.of_vertices(mesh.chart.grid, mesh.vertices, path, forward, turns, shape.turn, leaning)
