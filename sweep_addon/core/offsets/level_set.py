# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface where a field is zero: a dual surface whose vertices are moved there, and onto its creases."""

import numpy as np

from ..declared.frozen import individual
from ..progress import unheard
from ..vectors import dot
from .band import narrow_band
from .creases import OFF, at_creases, placed
from .cut_creases import mended
from .dual import dual_surface
from .on_edges import where_edges_cross
from .untangling import untangled
from .vertices import Vertices

SHARES = 0.25, 0.45, 0.6, 0.75, 0.85  # of the work done after each step, as measured


@individual
class Surface:
    """A closed surface near the zero of a field.

    Parameters
    ----------
    vertices : Vertices
        With what the field says of them.
    triangles : (t, 3) int array
        Counter-clockwise from outside.
    crossing : (k, 2) int array
        Pairs of triangles that cross each other; none, as a rule.
    """

    vertices: Vertices
    triangles: np.ndarray
    crossing: np.ndarray


def level_set(field, low, high, step, progress=unheard):
    """The surface where a field is zero.

    Parameters
    ----------
    field : object
        As `any_field` says; it is positive outside the box.
    low, high : (3,) array-likes
        A box that holds the surface, in metres.
    step : float
        The side of a cell, in metres: as far as vertices are apart.
    progress : callable, optional
        Is told which part is done, from 0 to 1, after each step; what it raises ends the work.

    Returns
    -------
    Surface or None
        Closed, and manifold at each edge and vertex; None where the field is nowhere negative.

    Each vertex stays within its cell. At creases, where two sheets meet, it goes to where their planes meet; where
    triangles then cross or turn over, their vertices go back to where they were, in at most four rounds. Where ridges
    may be, edges that cut creases off are then flipped, or split at vertices that may be in other cells.

    Examples
    --------
    >>> from .implicit import Implicit
    >>> ball = Implicit(lambda points: np.linalg.norm(points, axis=1) - 1)
    >>> surface = level_set(ball, (-1, -1, -1), (1, 1, 1), 0.1)
    >>> len(surface.vertices.places), len(surface.triangles), bool(abs(surface.vertices.values).max() < 1e-3)
    (1898, 3792, True)
    """
    band = narrow_band(field, low, high, step)
    if not len(band.cells):
        return None
    progress(SHARES[0])
    dual = dual_surface(band)
    floor = band.low + step * band.cells[dual.cell]
    start = Vertices(dual.starts, *field.normals(dual.starts, band.hints[dual.cell]))
    progress(SHARES[1])
    plain = field.at_feet(start, np.clip(start.foot, floor, floor + step))
    progress(SHARES[2])
    pairs = np.concatenate([dual.quads[:, [i, (i + 1) % 4]] for i in range(4)])
    which, creased = at_creases(field, plain, pairs, floor, step)
    progress(SHARES[3])
    if not field.ridges:  # valleys are narrow, and their cells' neighbours know both sides
        which = which[np.abs(creased.values[which]) > OFF * step]
    places, bent = where_edges_cross(field, band, dual, which)
    wanted = bent | (np.abs(creased.values[which]) > OFF * step)
    edged, _ = placed(field, creased, which[wanted], places[wanted], floor, step, better=True)
    progress(SHARES[4])
    triangles = cut(dual.quads, edged)
    corner_cells = np.tile(dual.cell[dual.quads], (2, 1))
    vertices, crossing = untangled((start, plain, creased, edged), triangles, corner_cells, dual.cell)
    if field.ridges:  # of others each triangle is bounded by the cells that it is in
        vertices, triangles = mended(field, vertices, triangles, crossing, step)
    progress(1.0)
    return Surface(vertices, triangles, crossing)


def cut(quads, vertices):
    """Faces (q, 4) cut into triangles (2 q, 3), along the diagonal that is nearer to the zero.

    It is estimated in the middle of each from the tangent planes of the four corners: where these turn to each other
    the field is as low as the lowest of them, and else as high as the highest.
    """
    places, feet, normals = vertices.places[quads], vertices.foot[quads], vertices.normals[quads]
    across = places[:, 2:] - places[:, :2]
    valley = dot(across, normals[:, 2:] - normals[:, :2]).sum(axis=1) < 0

    def off(i, j):
        middle = (places[:, i] + places[:, j]) / 2
        heights = dot(middle[:, None] - feet, normals)
        return np.abs(np.where(valley, heights.min(axis=1), heights.max(axis=1)))

    other = off(1, 3) < off(0, 2)
    quads = np.where(other[:, None], np.roll(quads, -1, axis=1), quads)
    return np.concatenate((quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]))
