# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of constant cross-section solids: between the planes that limit them."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from ..cells import bend
from ..contours import Circle
from ..ends import Flat
from ..generalized_cylinder import GeneralizedCylinder
from ..limits import Plane
from ..vectors import norms
from .cylinders import of_cylinder, support
from .detect import together
from .lattice import Lattice
from .local import Local


@lru_cache(maxsize=16)
def of_solid(shape):
    """The places where a PD curve sweep meets itself: `Places`."""
    limits = (Flat(), Flat()) if shape.trajectory.closed else (shape.start, shape.end)
    planes = [isinstance(limit, Plane) for limit in limits]
    if isinstance(shape.contour, Circle) and not any(planes):  # a round tube, whichever way it is turned
        path = replace(shape.trajectory, radii=(), tilts=()) if shape.trajectory.carries else shape.trajectory
        return of_cylinder(GeneralizedCylinder(shape.contour, path, shape.samples, start=limits[0], end=limits[1]))
    section, bending, stations, _ = shape.laid_out()
    mesh = shape.mesh()
    points = mesh.vertices.reshape(len(section.points), -1, 3)
    heights = mesh.chart.s
    axis = bending.axis(heights)
    normals = axis.e1.copy()
    for side, limit in zip((0, -1), limits, strict=True):
        if isinstance(limit, Plane):  # the face there lies in it
            normals[side] = limit.across * np.sign(limit.across @ axis.e1[side])

    def carried(placed):
        there = bending.placed(placed)
        return bend(placed.trajectory, placed.u), np.zeros_like(there.points), there.e2, there.e3

    radii = norms(points - axis.points).max(axis=0)
    local = Local(stations, carried, support(shape.contour), float(norms(section.points).max()))
    if any(planes):
        low, high = heights[[0, -1]].clip(0.0, stations.total)
        local.grid = np.unique(np.concatenate(([low], local.grid[(local.grid > low) & (local.grid < high)], [high])))
    whole = Lattice.of(
        mesh.chart.grid,
        lambda rings: points[:, rings],
        axis.points,
        axis.points,
        normals,
        radii,
        mesh.chart.u,
        shape.trajectory.domain[1],
    )
    unit = "radius" if isinstance(shape.contour, Circle) else "scale"
    return together(whole, local, None, shape.contour.radius if unit == "radius" else 1.0, unit)
