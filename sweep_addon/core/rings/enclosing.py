# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Enclosing rings: a coarse mesh that no point of the true sweep leaves."""

import numpy as np

from ..contours.crossing import crossings
from ..contours.fit import Fit
from ..declared.parameters import require, spelled
from ..grids.drawn import affine
from ..stations.frames import axes
from ..stations.sampling import stations as stations_at
from ..vectors import dot
from .bevels import steps_on_bevels
from .steps import STEEPEST, ahead, directions, handed, require_short, spun, to_both

AT_HAND = 2**14  # points of a block
RESERVE = 1.05  # a chord is farthest from its curve near the middle of the step, where it is measured


def enclosing(stations, rings, true, section, scales, turn, leaping):
    """Rings whose mesh contains the true sweep, but for steps that end in a tip.

    Parameters
    ----------
    stations : Stations
    rings : (3, n, 3) float array
        At each station its place and the contour's x and y axes, scaled and mitred.
    true : (3, n - 1, 3) or (3, n, 3) float array
        What these truly are in the middle of each step.
    section : Section
        The circumscribed contour.
    scales : (n,) float array
        The lesser of the two scales at each station, 0 where the contour is a point.
    turn : float
        The angle in radians by which a closed sweep comes back turned: one that maps the contour to itself.
    leaping : (n - 1,) or (n,) bool array
        Which steps are within leaps of the frame, where there is nothing to contain.

    Returns
    -------
    rings : (5, n, 3) float array
        The same, and the axes once more, as long as the clearance of each ring.
    weights : (m, 4) float array
        The points of the section, and how each moves when its edges move out by a metre.

    Raises
    ------
    ShapeError
        Where the contour has no room for its edges to move out.

    Halfway between two rings the true contour is where trajectory, frame and laws put it, the mesh's at the mean of
    both. The rings go half the way there, so that they are as far off to one side as the middle of the step is to the
    other. How far that is for the farthest point, and by how much the faces bend beside it, is the clearance by which
    the edges of the contour move out, parallel to themselves: what is no farther from the mesh's contour is within the
    mesh, whichever way its faces are split into triangles.

    A curve is taken to be farthest from its chord near the middle, so no contour should turn by more than 30 degrees
    from one ring to the next.
    """
    starts, turn = stations.starts, turn * handed(stations, rings[1:])
    middle = (rings[:, starts] + later(stations, rings, turn)) / 2
    true[1] *= np.sign(np.einsum("ij,ij->", true[1], middle[1]))  # the section may be seen in a mirror
    pointed = (scales[starts] == 0) | (scales[stations.onward] == 0)
    exact = pointed | steps_on_bevels(stations) | leaping
    moved = rings + halves(stations, np.where(exact[:, None], 0.0, true - middle), turn)

    after = later(stations, moved, turn)
    step, middle = after - moved[:, starts], (moved[:, starts] + after) / 2
    apart = missed(section, true - middle, step, directions(stations)) / require_short(stations, Fit.CIRCUMSCRIBED)
    apart = np.where(exact, 0.0, apart)
    apart = np.maximum(to_both(stations, apart, apart, np.maximum), farthest_moved(section, moved - rings))
    clearance = RESERVE * apart / np.where(scales > 0, scales, np.inf)
    vectors = out(section)
    require_room(section, vectors, clearance.max())
    return np.concatenate((moved, rings[1:] * clearance[:, None])), np.column_stack((section.points, vectors))


def halfway(stations, frame, along, symmetry):
    """The place and the axes, scaled, of the true contour in the middle of each step: (3, n - 1, 3) or (3, n, 3)."""
    count = len(stations.onward)
    s = np.insert(stations.s, np.arange(1, count + 1), stations.s[:count] + stations.lengths / 2)
    between = stations_at(stations.trajectory, s)
    scale_x, scale_y, twist, *offset = (law[:, None] for law in along.at(s, between.u))
    e2, e3, _ = axes(frame, between, twist[:, 0], symmetry)
    places = between.points + e2 * offset[0] + e3 * offset[1]
    return np.stack((places, e2 * scale_x, e3 * scale_y))[:, 1::2][:, :count]


def later(stations, rings, turn):
    """The rings at the end of each step: (3, n, 3) to (3, n - 1, 3) or (3, n, 3)."""
    return np.concatenate((rings[:1, stations.onward], ahead(stations, rings[1:], turn)))


def halves(stations, short, turn):
    """By how much rings must move, in their planes, for the means of two to lack half of what they do: (3, n, 3)."""
    legs = directions(stations)
    short = (short - np.einsum("aij,ij->ai", short, legs)[..., None] * legs) / 4
    ends = short.copy()
    if turn:
        ends[1:, -1] = spun(short[1:, -1], -turn)
    move = to_both(stations, short.swapaxes(0, 1), ends.swapaxes(0, 1), np.add).swapaxes(0, 1)
    if not stations.closed:
        move[:, [0, -1]] *= 2
    return move - np.einsum("aij,ij->ai", move, stations.tangent)[..., None] * stations.tangent


def missed(section, short, step, legs):
    """How far the mesh misses the true contour in the middle of each step: (n,) lengths.

    Parameters
    ----------
    section : Section
    short, step : (3, n, 3) float array
        What the mesh's contour there lacks of the true place and axes, and by how much these change in the step.
    legs : (n, 3) float array
        Unit vectors along the steps.

    A face between two columns bends by a quarter of the difference of both.
    """
    points, lengths = affine(section.points), np.empty(len(legs))
    edges = points[section.following] - points
    for some in blocks(len(points), len(legs)):
        columns, leg = summed(points, step[:, some]), legs[some].T
        chord = farthest(summed(points, short[:, some]), columns, leg)
        lengths[some] = chord + farthest(summed(edges, step[:, some]), columns, leg) / 4
    return lengths


def farthest_moved(section, moves):
    """How far the farthest point of a section moves with its place and axes, (3, n, 3): (n,) lengths."""
    points, lengths = affine(section.points), np.empty(moves.shape[1])
    for some in blocks(len(points), len(lengths)):
        vectors = summed(points, moves[:, some])
        lengths[some] = np.sqrt(inner(vectors, vectors).max(axis=0))
    return lengths


def blocks(points, steps):
    """Slices of so few steps that what is computed of all points there stays at the processor's hand."""
    width = max(AT_HAND // points, 1)
    return (slice(start, start + width) for start in range(0, steps, width))


def summed(weights, vectors):
    """The sums of vectors (3, n, 3) with each of the weights (m, 3), the axes of space first: (3, m, n)."""
    return weights @ vectors.transpose(2, 0, 1)


def farthest(vectors, columns, legs):
    """The longest of vectors (3, m, n) seen along the columns, on planes across the legs (3, n): (n,) lengths.

    What a point lacks along its column is no lack: the mesh goes on there.
    """
    forward = inner(columns, legs[:, None])
    least = STEEPEST * np.sqrt(inner(columns, columns))
    forward = np.where(np.abs(forward) < least, least, forward)  # before a mitre that is longer, a step runs back
    ahead = inner(vectors, legs[:, None]) / np.where(forward, forward, 1.0)
    aside = vectors - ahead * columns
    return np.sqrt(np.minimum(inner(aside, aside), inner(vectors, vectors)).max(axis=0))


def inner(a, b):
    """The products of vectors with one another, (3, ...) twice to (...)."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def out(section):
    """How the points of a section move, (m, 2), when all edges move out by one metre: on the bisector of both."""
    normals = (section.points[section.following] - section.points)[:, ::-1] * (1, -1) / section.edge_lengths[:, None]
    double = normals.copy()
    double[section.following] += normals
    return 2 * double / dot(double, double)[:, None]


def require_room(section, vectors, clearance):
    """Refuse a contour whose holes close or whose edges meet when they move out."""
    moved = section.points + clearance * vectors
    before, after = (points[section.following] - points for points in (section.points, moved))
    room = (dot(before, after) > 0).all() and not len(crossings(moved, section.following))
    sentence = f"must not be circumscribed where a hole or a gap has no room for clearances of {clearance:.3g}"
    require(room, f"{sentence}, or samples must be finer", spelled(Fit.CIRCUMSCRIBED), "fit")
