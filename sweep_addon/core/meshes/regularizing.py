# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Regularizing: of a mesh of mixed dimension the solid part alone, as closed surfaces without a singular place."""

import numpy as np

from ..declared.parameters import require
from .components import components
from .mesh import Mesh, Topology
from .runs import run_of
from .sheets import partners
from .welding import Selected


def regularized(mesh):
    """The faces that bound solids, each vertex and edge once for every fan of them.

    Parameters
    ----------
    mesh : Mesh

    Returns
    -------
    Mesh
        Closed and manifold: solids that met in a point or along an edge meet there no longer, but have each their own.

    Raises
    ------
    ShapeError
        Where nothing is solid.

    Examples
    --------
    >>> from ..contours import Mixed
    >>> from ..shapes.translational_sweep import TranslationalSweep
    >>> mesh = regularized(TranslationalSweep(Mixed()).mesh())
    >>> mesh.volume(), str(mesh.dimensions())
    (1.0, '1 solid (3D)')
    """
    topology, partner = mesh.topology, partners(mesh)
    kept = np.flatnonzero(partner >= 0)
    require(len(kept), "must be off where no part is solid", str(mesh.dimensions()), "regularize")
    number = np.empty(len(partner), dtype=int)
    number[kept] = np.arange(len(kept))
    other, ahead = number[partner[kept]], number[topology.following[kept]]
    fan = components(len(kept), np.stack((np.arange(len(kept)), ahead[other]), axis=1))
    _, first, vertex = np.unique(fan, return_index=True, return_inverse=True)
    vertex = vertex.ravel().astype(np.int32)
    start = np.minimum(np.arange(len(kept)), other)
    _, edge, edge_of = np.unique(start, return_index=True, return_inverse=True)
    face = run_of(mesh.offsets)[kept]
    firsts = np.flatnonzero(np.append(True, face[1:] != face[:-1]))
    return Mesh(
        mesh.vertices[mesh.corners[kept[first]]],
        Topology(
            corners=vertex,
            offsets=np.append(firsts, len(kept)).astype(np.int32),
            edges=np.stack((vertex[edge], vertex[ahead[edge]]), axis=1),
            corner_edges=edge_of.ravel().astype(np.int32),
            sharp=topology.sharp[topology.corner_edges[kept[edge]]],
            material=topology.material[face[firsts]],
        ),
        Selected(mesh.chart, mesh.corners[kept[first]], kept),
        mesh.told,
    )
