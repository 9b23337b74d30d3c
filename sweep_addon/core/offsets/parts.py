# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a solid: one that looks inwards is a cavity, and must be within another."""

import numpy as np

from ..meshes.components import components
from ..vectors import cross, dot, norms, unit
from .convex import shared_edges

NEAR = 1e-6  # of the size of a triangle: how far from it the inside of its part is looked at


def inward_part(vertices, triangles):
    """The number, from 1, of a part that looks inwards and is no cavity of another; 0 where there is none.

    Parameters
    ----------
    vertices : (n, 3) float array
        In metres.
    triangles : (f, 3) int array
        Of a closed mesh.

    Examples
    --------
    >>> from ..meshes.facets import facets
    >>> from ..solids import Block
    >>> mesh = Block(1.0, 1.0, 1.0).mesh()
    >>> corners, faces = mesh.vertices, facets(mesh)[0]
    >>> apart = np.concatenate((faces, faces[:, ::-1] + 8))
    >>> inward_part(np.concatenate((corners, corners + 2)), apart)
    2
    >>> inward_part(np.concatenate((corners, corners / 2)), apart)
    0
    """
    _, part = np.unique(components(len(triangles), shared_edges(triangles)[:, 2:]), return_inverse=True)
    count = int(part.max()) + 1
    if count == 1:
        return 0
    corners = vertices[triangles] - vertices.mean(axis=0)
    low, high = np.full((count, 3), np.inf), np.full((count, 3), -np.inf)
    np.minimum.at(low, part, corners.min(axis=1))
    np.maximum.at(high, part, corners.max(axis=1))
    areas = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    volumes = np.bincount(part, dot(corners[:, 0], areas))
    largest = np.lexsort((norms(areas), part))[np.cumsum(np.bincount(part)) - 1]
    places = corners[largest].mean(axis=1) + NEAR * np.sqrt(norms(areas[largest]))[:, None] * unit(areas[largest])
    for cavity in np.flatnonzero(volumes < 0):
        around = ((low < places[cavity]) & (places[cavity] < high)).all(axis=1)
        around[cavity] = False
        if round(winding(corners[around[part]] - places[cavity])) != 1:
            return int(cavity) + 1
    return 0


def winding(corners):
    """How many times triangles (f, 3, 3) are around the origin.

    Source: van Oosterom, Strackee: The solid angle of a plane triangle, IEEE TBME 30(2), 1983.
    """
    a, b, c = corners.swapaxes(0, 1)
    one, two, three = norms(a), norms(b), norms(c)
    below = one * two * three + dot(a, b) * three + dot(b, c) * one + dot(c, a) * two
    return float(np.arctan2(dot(a, cross(b, c)), below).sum() / (2 * np.pi))
