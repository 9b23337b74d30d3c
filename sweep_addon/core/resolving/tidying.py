# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tidying: what a boolean has left so small that single precision does not tell it from nothing."""

import numpy as np

from ..meshes.booleans import arrays
from .absorbing import absorbed
from .contracting import contracted
from .drawing_apart import drawn_apart
from .flipping import flipped
from .heights import heights
from .shells import without_specks
from .stars import touching

STEPS = 2.0  # of single precision: corners that are so far apart, and triangles so high, remain when they are rounded
ROUNDS = 20


def tidied(vertices, triangles, faces, cuts):
    """Of a closed surface one without short edges and thin triangles, which is nowhere further from it than rounding.

    Parameters
    ----------
    vertices : (n, 3) float array
    triangles : (t, 3) int array
        A closed manifold.
    faces : (t,) int array
        What each triangle is a part of.
    cuts : sequence of int
        The faces that are to stay as they are, with all their corners.

    Returns
    -------
    vertices : (n, 3) float array
        Where the surface touched itself in a point, there are two now that single precision tells apart.
    triangles : (k, 3) int array
        A closed manifold of the same genus, of some of the vertices.
    faces : (k,) int array

    Examples
    --------
    Four faces of a pyramid whose tip was split in two:

    >>> vertices = np.array([(1, 1, 0), (-1, 1, 0), (-1, -1, 0), (1, -1, 0), (0, 0, 1), (0, 1e-9, 1)])
    >>> sides = [(0, 1, 5), (1, 4, 5), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 5, 4), (0, 2, 1), (0, 3, 2)]
    >>> _, triangles, faces = tidied(vertices, np.array(sides), np.arange(8), ())
    >>> faces.tolist(), len(np.unique(triangles))
    ([0, 2, 3, 4, 6, 7], 5)
    """
    small = STEPS * float(np.spacing(np.float32(np.abs(vertices).max(initial=0.0))))
    fixed = np.full(len(vertices), False)
    fixed[triangles[np.isin(faces, cuts)]] = True
    for _ in range(ROUNDS):
        bad = heights(vertices, triangles)[0] < small
        if not bad.any():
            break
        near = round_about(triangles, triangles[bad], len(vertices))
        rest = triangles[~near], faces[~near]
        made = smoothed(vertices, triangles[near], faces[near], small, fixed)
        if made is None:
            break
        triangles, faces = (np.concatenate(parts) for parts in zip(rest, made, strict=True))
    return drawn_apart(vertices, triangles, small, fixed), triangles, faces


def tidied_arrays(body):
    """The vertices (n, 3) and triangles (t, 3) of a body, tidied and without specks, each vertex of some triangle."""
    vertices, triangles, faces = arrays(body)
    large = without_specks(vertices, triangles)
    vertices, triangles, _ = tidied(vertices, triangles[large], faces[large], ())
    used, triangles = np.unique(triangles, return_inverse=True)
    return vertices[used], triangles.reshape(-1, 3)


def round_about(triangles, vertices, count):
    """Which triangles are at some of so many vertices, or at a neighbour of one: (t,) bool array."""
    near = touching(triangles, vertices, count)
    return touching(triangles, triangles[near], count)


def smoothed(vertices, triangles, faces, small, fixed):
    """A part of a surface with fewer thin triangles, and the face of each; None where nothing could be done."""
    before = triangles
    triangles, kept = contracted(vertices, triangles, small, fixed)
    triangles, faces = flipped(vertices, triangles[kept], faces[kept], small, fixed)
    triangles, kept = absorbed(vertices, triangles, small, fixed)
    triangles, faces = triangles[kept], faces[kept]
    return None if np.array_equal(triangles, before) else (triangles, faces)
