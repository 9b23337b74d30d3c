# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tubes united: those of a figure overlap where branches begin, and together they bound one solid."""

from dataclasses import replace

import numpy as np

from ...declared.parameters import require
from ...meshes import booleans
from ...meshes.facets import facets
from ...meshes.polyhedron import Bare, polyhedron


class Segments(Bare):
    """The chart of a solid that is made of some segments, of which nothing else is left."""

    def __init__(self, count):
        self.rings = count


def united(mesh):
    """The solid of the tubes of a mesh, as triangles that keep their material; polygons and organs are left out."""
    is_open = np.zeros(len(mesh.vertices), bool)
    is_open[mesh.boundary_edges().ravel()] = True  # of polygons, which share no vertex with a tube
    triangles, face = facets(mesh)
    closed = ~is_open[triangles].any(axis=1)
    require(closed.any(), "must have tubes to be a solid", "edges and open polygons alone")
    triangles, material = triangles[closed], mesh.topology.material[face[closed]]
    used, corners = np.unique(triangles, return_inverse=True)
    number = np.arange(len(triangles)) if material.any() else None  # each its own: quads of a bent tube are not flat
    tubes = booleans.body(mesh.vertices[used], corners.reshape(-1, 3), number).decompose()
    vertices, triangles, number = booleans.arrays(booleans.united(tubes))
    slots = material[number] if material.any() else None
    return replace(polyhedron(vertices, triangles, None, slots), chart=Segments(mesh.rings))
