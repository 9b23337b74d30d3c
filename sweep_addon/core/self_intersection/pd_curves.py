# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of PD curve sweeps: a constant section whose rings lean where a plane cuts them off."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from ..contours import Circle
from ..rings.limits import Flat, Plane
from ..shapes import directing
from ..shapes.generalized_cylinder import GeneralizedCylinder
from ..stations.cells import bend
from ..vectors import cross, norms
from .cylinders import of_cylinder, support
from .detect import together
from .lattice import Lattice
from .local import Local


@lru_cache(maxsize=16)
def of_pd_curve(shape):
    """The places where a PD curve sweep meets itself: `Places`."""
    limits = (Flat(), Flat()) if shape.trajectory.closed else (shape.start, shape.end)
    planes = [isinstance(limit, Plane) for limit in limits]
    tube = isinstance(shape.contour, Circle)
    if tube and not any(planes):  # whichever way it is turned
        path = replace(shape.trajectory, radii=(), tilts=()) if shape.trajectory.carries else shape.trajectory
        return of_cylinder(GeneralizedCylinder(shape.contour, path, shape.samples, start=limits[0], end=limits[1]))
    section, bending, stations, _ = directing.laid_out(shape)
    rings, mesh = directing.rings_of(shape, section, bending, stations), shape.mesh()
    path, e2, e3 = rings.axes
    normals = cross(e2, e3) * (-1 if bending.mirrored else 1)
    for side in np.flatnonzero(planes):  # the face there lies in its plane
        across = limits[side].across
        normals[-side] = across * np.sign(across @ normals[-side])
    leaning = np.pad(np.full(len(path) - sum(rings.leaning), False), rings.leaning, constant_values=True)
    end = stations.trajectory.domain[1]
    lattice = Lattice.of_vertices(mesh.chart.grid, mesh.vertices, path, normals, rings.u, end, leaning)

    def carried(stations):
        axis = bending.placed(stations)
        return bend(stations.trajectory, stations.u), np.zeros_like(axis.points), axis.e2, axis.e3

    local = Local(stations, carried, support(shape.contour), float(norms(section.points).max()))
    if any(planes):  # what they cut off may fold
        first, last = np.clip(mesh.chart.extent, 0.0, stations.total)
        local.grid = np.unique(
            np.concatenate(([first], local.grid[(local.grid > first) & (local.grid < last)], [last]))
        )
    size, unit = (shape.contour.radius, "radius") if tube else (1.0, "scale")
    return together(lattice, local, size=size, unit=unit)
