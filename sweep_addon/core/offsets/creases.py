# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vertices on the creases of a level set, where two smooth sheets of it meet."""

import numpy as np

from ..vectors import dot, unit

TURN = 0.25  # of unit normals of neighbours: less is a smooth sheet
OFF = 0.01  # of a cell: a vertex that is farther from the zero after it was moved there is at a crease
STILL_OFF = 0.02  # of a cell: so far from the zero a vertex at a crease may be
NEARLY = 0.1  # of a cell: a crease that is farther from a cell than this is another cell's
STAND_OFF = 0.5  # of a cell: how far from a vertex a ridge is looked for
WEAK = 0.05  # of the largest eigenvalue: along directions of less, planes say nothing of where a vertex belongs


def at_creases(field, vertices, pairs, floor, step):
    """Vertices of which those near creases are moved onto these, each within its cell.

    Parameters
    ----------
    field : object
    vertices : Vertices
        Close to the zero.
    pairs : (e, 2) int array
        Each vertex, and each of its neighbours: the tangent planes of these meet at the crease.
    floor : (n, 3) float array
        The low corner of each vertex's cell.
    step : float
        The side of a cell.

    Returns
    -------
    which : (k,) int array
        Those near creases.
    Vertices
    """
    which, ridge = near_creases(vertices, pairs, step, field.ridges)
    number = np.full(len(vertices.places), -1)
    number[which] = np.arange(len(which))
    ring = np.concatenate((pairs[number[pairs[:, 0]] >= 0], np.stack((which, which), axis=1)))
    own, other = number[ring[:, 0]], ring[:, 1]
    places = meeting_places(vertices.places[which], own, vertices.foot[other], vertices.normals[other])
    vertices, done = placed(field, vertices, which, places, floor, step)
    left = np.flatnonzero(ridge & ~np.isin(which, done))
    if len(left):
        feet = feet_on_ridges(field, vertices, which, own, other, step)[left]
        vertices, _ = placed(field, vertices, which[left], feet, floor, step)
    off = which[np.abs(vertices.values[which]) > STILL_OFF * step]
    return which, placed(field, vertices, off, vertices.foot[off], floor, step, better=True)[0]


def placed(field, vertices, which, places, floor, step, better=False):
    """Vertices of which some are moved to places, those that stay in their cells and are on the zero there, or nearer.

    Returns
    -------
    Vertices
    which : (k,) int array
        Those that were moved.
    """
    low = floor[which]
    here = np.maximum(low - places, places - low - step).max(axis=1, initial=-step) < NEARLY * step
    which, low, places = which[here], low[here], places[here]
    moved = vertices.some(which).at(field, np.clip(places, low, low + step))
    most = np.maximum(np.abs(vertices.values[which]) if better else 0.0, STILL_OFF * step)
    good = np.abs(moved.values) <= most
    return vertices.replaced(which[good], moved.some(good)), which[good]


def near_creases(vertices, pairs, step, ridges):
    """The numbers of vertices with a neighbour whose normal differs, or that are off the zero; and which are convex.

    Without ridges only normals that turn to each other count: of a distance, sheets meet in valleys alone.
    """
    one, other = pairs.T
    turn = vertices.normals[other] - vertices.normals[one]
    bent = dot(turn, turn) > TURN**2
    if not ridges:
        bent &= dot(turn, vertices.places[other] - vertices.places[one]) < 0
    crease = np.abs(vertices.values) > OFF * step
    crease[one[bent]] = True
    apart = np.bincount(one[bent], dot(turn, vertices.places[other] - vertices.places[one])[bent], len(crease))
    which = np.flatnonzero(crease)
    return which, apart[which] > 0


def feet_on_ridges(field, vertices, which, number, other, step):
    """Where the surface is nearest to places that stand off from vertices midway between the normals around them.

    Of a ridge that is on the ridge, which is nearest to all that is between the normals of its sheets.
    """
    outward = unit(np.stack([np.bincount(number, part, len(which)) for part in vertices.normals[other].T], axis=1))
    some = vertices.some(which)
    return some.at(field, some.places + STAND_OFF * step * outward).foot


def meeting_places(places, which, planes, normals):
    """The place nearest to each vertex where planes meet best.

    Parameters
    ----------
    places : (k, 3) float array
        Where vertices are.
    which : (m,) int array
        The vertex that each plane is for.
    planes, normals : (m, 3) float arrays
        A place on each, and its unit normal.

    Returns
    -------
    (k, 3) float array

    Source
    ------
    Ju, Losasso, Schaefer, Warren: Dual contouring of Hermite data, 2002, with the small eigenvalues left out.

    Examples
    --------
    >>> meeting_places(np.zeros((1, 3)), np.array([0, 0]), np.array([(1.0, 5, 0), (0, 2.0, 7)]), np.eye(3)[:2])
    array([[1., 2., 0.]])
    """
    count = len(places)
    away = dot(planes - places[which], normals)
    products = (normals[:, :, None] * normals[:, None, :]).reshape(-1, 9)
    matrix = np.stack([np.bincount(which, part, count) for part in products.T], axis=1).reshape(-1, 3, 3)
    right = np.stack([np.bincount(which, away * part, count) for part in normals.T], axis=1)
    values, vectors = np.linalg.eigh(matrix)
    strong = values > WEAK * values[:, 2:]
    along = np.einsum("nji,nj->ni", vectors, right) * strong / np.where(strong, values, 1)
    return places + np.einsum("nij,nj->ni", vectors, along)
