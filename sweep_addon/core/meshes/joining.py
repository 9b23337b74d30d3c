# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Several meshes as one: the tubes along the splines of a curve."""

import numpy as np

from ..declared.frozen import individual
from ..kept import kept
from .mesh import Mesh, Topology


@individual
class Charts:
    """The charts of several meshes, one after the other."""

    parts: tuple

    @property
    def keys(self):
        keys = zip(*(chart.keys for chart in self.parts), strict=True)
        return tuple("".join(some).replace(",", "") for some in keys)  # of several, no part is one attribute's

    @property
    def rings(self):
        return sum(chart.rings for chart in self.parts)

    def uv(self, dtype=np.float64, empty=np.empty):
        parts = [chart.uv(dtype) for chart in self.parts]
        return None if parts[0] is None else np.concatenate(parts)

    def along(self, dtype=np.float64, but=(), rooms=None):
        return together([chart.along(dtype, but) for chart in self.parts])

    def across(self, dtype=np.float64):
        return together([chart.across(dtype) for chart in self.parts])


def together(attributes):
    """Values by name of several meshes, one after the other."""
    return {name: np.concatenate([part[name] for part in attributes]) for name in attributes[0]}


def joined(meshes):
    """One mesh of all vertices and faces of several.

    Parameters
    ----------
    meshes : sequence of Mesh
        At least one.

    Returns
    -------
    Mesh

    Examples
    --------
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> tube = GeneralizedCylinder().mesh()
    >>> joined([tube, tube]).euler_characteristic()
    4
    """
    if len(meshes) == 1:
        return meshes[0]
    topology = joined_topology(tuple(m.topology for m in meshes), tuple(len(m.vertices) for m in meshes))
    told = dict.fromkeys(sentence for mesh in meshes for sentence in mesh.told)
    vertices = np.concatenate([mesh.vertices for mesh in meshes])
    return Mesh(vertices, topology, Charts(tuple(mesh.chart for mesh in meshes)), tuple(told))


@kept
def joined_topology(parts, vertices):
    """The topologies of meshes with these numbers of vertices as one."""

    def stacked(name, sizes):
        starts = np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.int32)
        return np.concatenate([getattr(part, name) + start for part, start in zip(parts, starts, strict=True)])

    ends = [part.offsets[1:] for part in parts]
    corners = [len(part.corners) for part in parts]
    starts = np.concatenate(([0], np.cumsum(corners)[:-1]))
    return Topology(
        corners=stacked("corners", vertices),
        offsets=np.concatenate(([0], *(e + s for e, s in zip(ends, starts, strict=True)))).astype(np.int32),
        edges=stacked("edges", vertices),
        corner_edges=stacked("corner_edges", [len(part.edges) for part in parts]),
        sharp=np.concatenate([part.sharp for part in parts]),
        material=np.concatenate([part.material for part in parts]),
    )
