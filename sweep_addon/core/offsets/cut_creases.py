# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Edges of a surface that cut a crease off, which passes a cell between the corners of the lattice, unseen.

The middle of such an edge is below the tangent planes at both its ends, or above both in a valley. It is flipped, so
that it joins two places on the crease, or split where these planes meet.
"""

import numpy as np

from ..vectors import dot, norms, unit
from .edge_changes import changed, edges_of, flipped, independent, joining, sheets, split, without_crossings
from .untangling import facing

ROUNDS = 3
TURN = 0.5  # of unit normals at the ends of an edge, about 30 degrees: those of a smooth sheet turn less
DEEP = 0.03  # of a cell: so far are both tangent planes from the middle of an edge that cuts a crease off
AWAY = 0.75  # of an edge's length: as far from its middle its new vertex may be
CLEAR = 0.2  # of an edge's length: as near to the corners of its triangles its new vertex may be
ON = 0.05  # of a cell: as far from the zero it may be
SIDEWAYS = 0.3  # of the way to the ends of an edge: where tangent planes are taken anew
PARALLEL = 0.05  # of the square of the sine between two planes: those that turn less are taken to turn so much
WORTH = 0.02  # of a cell: what brings the surface less near to the zero is left
UPRIGHT = 0.2  # the least cosine between a new triangle and the mean of the normals at its corners


def mended(field, vertices, triangles, crossing, step):
    """A surface of which edges that cut creases off are flipped or split.

    Parameters
    ----------
    field : object
        Of whose zero convex edges are edges too.
    vertices : Vertices
        On the zero.
    triangles : (t, 3) int array
        Closed, and manifold at each edge and vertex.
    crossing : (k, 2) int array
        Pairs of triangles that cross; these stay as they are, so that their numbers tell them still.
    step : float
        The side of a cell, in metres.

    Returns
    -------
    vertices : Vertices
        The same, and then those that are new.
    triangles : (t', 3) int array
        As closed and manifold, and of the same Euler characteristic; no more of them cross.

    Source
    ------
    Kobbelt, Botsch, Schwanecke, Seidel: Feature sensitive surface extraction from volume data, SIGGRAPH 2001, where
    vertices are put into cells that creases pass, and edges flipped to join them. Here edges are asked, not cells,
    and each change must bring the middles of its triangles nearer to the zero.

    Examples
    --------
    A polyhedron of five vertices on a cube of side 2 is mended where it cuts off edges and corners of the cube.

    >>> from .implicit import Implicit
    >>> from .vertices import Vertices
    >>> cube = Implicit(lambda points: np.abs(points).max(axis=1) - 1)
    >>> places = np.array([(1, 0, 0), (0, 1, 0), (0.5, 0.5, 1), (0.5, 0.5, -1), (-1, -1, 0)], dtype=float)
    >>> vertices = Vertices(places, *cube.normals(places))
    >>> triangles = np.array([(0, 1, 2), (1, 0, 3), (1, 4, 2), (4, 0, 2), (4, 1, 3), (0, 4, 3)])
    >>> vertices, triangles = mended(cube, vertices, triangles, np.zeros((0, 2), dtype=int), 1.0)
    >>> vertices.places[5:].round(6)
    array([[ 1.,  1.,  0.],
           [-1., -1.,  1.],
           [-1., -1., -1.],
           [ 1.,  1.,  1.],
           [ 1.,  1., -1.]])
    """
    asked = np.ones(len(triangles), dtype=bool)
    for _ in range(ROUNDS):
        edges = cutting(vertices, edges_of(triangles), step)
        edges = edges[asked[edges[:, 4:]].any(axis=1) & ~np.isin(edges[:, 4:], crossing).any(axis=1)]
        before = off(field, vertices, edges[:, :2], *sheets(edges))
        asked = np.zeros(len(triangles), dtype=bool)  # what is refused now is as it was the next time
        for change in (flips, splits):
            which, made, new = change(field, vertices, triangles, edges, step)
            more = vertices.and_then(new)
            across = [edges[which, 2:4]] if change is flips else []
            gain = before[which] - off(field, more, *made, *across)
            good = np.flatnonzero(gain > WORTH * step)
            good = good[independent(edges[which[good]], gain[good])]
            tried = edges[which[good], 4:]
            good = good[without_crossings(more.places, triangles, edges[which[good]], made[:, good])]
            vertices, triangles = more, changed(triangles, edges[which[good]], made[:, good])
            asked = np.append(asked, np.ones(len(triangles) - len(asked), dtype=bool))
            asked[tried] = True  # also what crossed something that came about at the same time
            left = ~asked[edges[:, 4:]].any(axis=1)
            edges, before = edges[left], before[left]
    return used(vertices, triangles)


def cutting(vertices, edges, step):
    """Those of edges (e, 6) that cut a crease off: their middles are on one side of the tangent planes at both ends."""
    one, other = vertices.normals[edges[:, 0]], vertices.normals[edges[:, 1]]
    edges = edges[dot(other - one, other - one) > TURN**2]
    heights = above(vertices, edges, edges[:, :2])
    return edges[(heights.max(axis=1) < -DEEP * step) | (heights.min(axis=1) > DEEP * step)]


def above(vertices, edges, pairs):
    """How far the middles of pairs of vertices (k, 2) are above the tangent planes at both ends of edges: (k, 2)."""
    middles, ends = vertices.places[pairs].mean(axis=1), edges[:, :2]
    return dot(middles[:, None] - vertices.foot[ends], vertices.normals[ends])


def flips(field, vertices, triangles, edges, step):
    """Which edges may be flipped, and their triangles then: (2, k, 3) int array; no new vertices."""
    here, there = (above(vertices, edges, pairs) for pairs in (edges[:, :2], edges[:, 2:4]))
    ridge = here[:, 0] < 0
    left = np.abs(np.where(ridge, there.max(axis=1), there.min(axis=1)))
    nearer = left < np.abs(here).min(axis=1)  # as planes tell
    which = np.flatnonzero(nearer & joining(triangles, edges[:, 2:4]))
    made = flipped(edges[which])
    good = upright(vertices, made)
    return which[good], made[:, good], vertices.some(np.zeros(0, dtype=int))


def splits(field, vertices, triangles, edges, step):
    """Which edges may be split, their triangles then, (4, k, 3) int array, and the new vertices."""
    new, which = on_creases(field, vertices, edges, step)
    made = split(edges[which], len(vertices.places) + np.arange(len(which)))
    good = upright(vertices.and_then(new), made)
    return which[good], made[:, good], new


def off(field, vertices, *groups):
    """How far the middles of edges or triangles, some (k, 2) or (k, 3) of vertices, are off the zero at most: (k,)."""
    places = np.concatenate([vertices.places[group].mean(axis=1) for group in groups])
    hints = np.concatenate([vertices.hints[group[:, 0]] for group in groups])
    return np.abs(field.normals(places, hints)[0]).reshape(len(groups), -1).max(axis=0)


def upright(vertices, made):
    """Of which changes all triangles (m, k, 3) look where the field does at their corners: (k,) bool."""
    normals = unit(facing(vertices.places, made.reshape(-1, 3)))
    told = unit(vertices.normals[made.reshape(-1, 3)].sum(axis=1))
    return (dot(normals, told) > UPRIGHT).reshape(made.shape[:2]).all(axis=0)


def on_creases(field, vertices, edges, step):
    """Vertices where the tangent planes at the ends of edges (k, 6) meet, and which edges have one on the zero."""
    ends = edges[:, :2]
    places = meeting(vertices.places[ends].mean(axis=1), vertices.foot[ends], vertices.normals[ends])
    which = np.flatnonzero(amid(vertices, edges, places))
    ends, places = ends[which].T, places[which]
    beside = places + SIDEWAYS * (vertices.places[ends] - places)  # of curved sheets the planes there are truer
    beside = vertices.some(ends.ravel()).at(field, beside.reshape(-1, 3))
    pairs = np.arange(ends.size).reshape(2, -1).T
    places = meeting(places, beside.foot[pairs], beside.normals[pairs])
    good = amid(vertices, edges[which], places)
    which, places = which[good], places[good]
    new = vertices.some(edges[which, 0]).at(field, places)
    on = np.abs(new.values) < ON * step
    return new.some(on), which[on]


def amid(vertices, edges, places):
    """Whether places (k, 3) are near the middles of edges (k, 6), and apart from the corners of their triangles."""
    corners = vertices.places[edges[:, :4]]
    length = norms(corners[:, 1] - corners[:, 0])
    near = norms(corners[:, :2].mean(axis=1) - places) < AWAY * length
    return near & (norms(corners - places[:, None]).min(axis=1) > CLEAR * length)


def meeting(places, feet, normals):
    """The place nearest to each of some (k, 3) that is on two planes, through feet (k, 2, 3) across unit normals."""
    heights = dot(feet - places[:, None], normals)
    cosine = dot(normals[:, 0], normals[:, 1])
    along = (heights - cosine[:, None] * heights[:, ::-1]) / np.maximum(1 - cosine**2, PARALLEL)[:, None]
    return places + (along[:, :, None] * normals).sum(axis=1)


def used(vertices, triangles):
    """The surface without vertices of no triangle."""
    kept, numbers = np.unique(triangles, return_inverse=True)
    return vertices.some(kept), numbers.reshape(-1, 3)
