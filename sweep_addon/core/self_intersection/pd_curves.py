# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-intersection of PD curve sweeps: a constant section whose rings lean where a plane cuts them off."""

import numpy as np

from ..cells import bend
from ..limits import Flat
from ..vectors import norms
from .detect import together
from .lattice import Lattice
from .local import Local


def of_pd_curve(shape):
    """The places where a PD curve sweep meets itself: `Places`."""
    section, bending, stations, _ = shape.laid_out()
    limits = (Flat(), Flat()) if stations.closed else (shape.start, shape.end)
    heights, leaning, axis = shape.rings(section, bending, stations, limits)
    mesh = shape.mesh()
    end = stations.trajectory.domain[1]
    lattice = Lattice.of_vertices(mesh.chart.grid, mesh.vertices, axis.points, axis.e1, axis.u, end, leaning)

    def carried(stations):
        axis = bending.placed(stations)
        return bend(stations.trajectory, stations.u), np.zeros_like(axis.points), axis.e2, axis.e3

    local = Local(stations, carried, section.support, float(norms(section.points).max()))
    return together(lattice, local)
