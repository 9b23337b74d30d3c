# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slipping: the motions in which the places where a part touches others slide along these, and do not press on them."""

import numpy as np

from ..declared.frozen import individual
from ..distance import nearest
from ..vectors import cross, dot, norms, unit

NEAR = 2  # contact tolerances: as near others touch a part
SAMPLES = 1500  # places of the surface that are looked at, roughly
SMOOTH = np.radians(30)  # between triangles that stand for one smooth surface
SLIPS = 0.05  # of the speed of a motion: less than that along the normals is sliding
GUESSES = 3  # motions that press least
ROUNDS = 4  # in which contacts are left out that a motion presses on
PRESSES, EXACT, MOSTLY = 4.0, 1e-3, 0.5  # times the median, or of the speed, it presses on those; most are to remain


@individual
class Contacts:
    """Places of a part that are near others.

    Parameters
    ----------
    places, normals : (n, 3) float array
        In metres, and the unit normals of the part there, outwards.
    size : float
        Of the part, in metres.
    """

    places: np.ndarray
    normals: np.ndarray
    size: float

    @classmethod
    def of(cls, part, others, near):
        """The contacts of a `Body` with others that are within a distance in metres."""
        places, normals = sampled(part)
        close = np.zeros(len(places), dtype=bool)
        for other in others:
            left = np.flatnonzero(~close)
            close[left] = nearest(other.search[0], places[left], limit=near).faces >= 0
        return cls(places[close], normals[close], part.size)

    def mean_normal(self):
        """Where the part looks at what it touches: a unit vector, or zero."""
        return unit(self.normals.sum(axis=0)) if len(self.normals) else np.zeros(3)

    def translations(self):
        """The directions in which most contacts slide: unit vectors (k, 3)."""
        if not len(self.normals):
            return np.zeros((0, 3))
        values, vectors = np.linalg.eigh(self.normals.T @ self.normals / len(self.normals))
        return vectors.T[values <= SLIPS]

    def twists(self):
        """Sets of motions in which the contacts slide, but for a few that others then move away from.

        Returns
        -------
        list of ((k, 3) float array, (k, 3) float array)
            Of each set the speeds of the origin and the turns about it; all sums of them are such motions too.

        Source
        ------
        Gelfand, Guibas: Shape segmentation using local slippage analysis, SGP 2004.
        """
        if not len(self.normals):
            return []
        middle, half, sets = self.places.mean(axis=0), self.size / 2, []
        rows = np.column_stack((self.normals, cross((self.places - middle) / half, self.normals)))
        for guess in np.linalg.eigh(rows.T @ rows)[1].T[:GUESSES]:
            kept = sliding_on(rows, guess)
            if len(kept) < MOSTLY * len(rows):
                continue
            values, vectors = np.linalg.eigh(kept.T @ kept / len(kept))
            found = vectors.T[values <= SLIPS**2]
            turns = found[:, 3:] / half
            sets.append((found[:, :3] - cross(turns, np.broadcast_to(middle, turns.shape)), turns))
        return sets


def sliding_on(rows, motion):
    """The contacts on which a motion slides; the others are ends, which it leaves or runs into.

    They are told by how much more it presses on them than on most, and the motion is fitted to the rest again.
    """
    for _ in range(ROUNDS):
        pressed = np.abs(rows @ motion)
        kept = rows[pressed <= max(PRESSES * float(np.median(pressed)), EXACT)]
        vectors = np.linalg.eigh(kept.T @ kept)[1].T
        motion = vectors[np.abs(vectors @ motion).argmax()]
    return kept


def sampled(part):
    """Places spread over the surface of a body, about as many as `SAMPLES`, and the normals there: (n, 3) twice."""
    a, b, c = part.corners.swapaxes(0, 1)
    sizes = norms(cross(b - a, c - a))
    cuts = np.sqrt(sizes / sizes.sum() * SAMPLES).round().astype(int).clip(1)
    at_corners, places, normals = corner_normals(part), [], []
    for cut in np.unique(cuts):  # into so many parts along each side: few different ones
        which = cuts == cut
        weights = barycentric(int(cut))
        places.append(np.einsum("kc,tcx->tkx", weights, part.corners[which]).reshape(-1, 3))
        normals.append(unit(np.einsum("kc,tcx->tkx", weights, at_corners[which]).reshape(-1, 3)))
    return np.concatenate(places), np.concatenate(normals)


def corner_normals(part):
    """The normals of the smooth surface for which the triangles stand, at each corner of each: (t, 3, 3) float array.

    Triangles that meet at an angle of less than `SMOOTH` are taken for one smooth surface, as shading does.
    """
    sides = np.roll(part.corners, -1, axis=1) - part.corners
    faces = unit(cross(sides[:, 0], sides[:, 1]))
    back = -np.roll(sides, 1, axis=1)
    angles = np.arctan2(norms(cross(sides, back)), dot(sides, back)).ravel()
    vertex = part.triangles.ravel()
    order = np.argsort(vertex, kind="stable")
    counts = np.bincount(vertex, minlength=len(part.vertices))[vertex[order]]
    first = (np.cumsum(np.bincount(vertex, minlength=len(part.vertices))) - 1)[vertex[order]] - counts + 1
    own = np.repeat(np.arange(len(vertex)), counts)
    step = np.arange(len(own)) - np.repeat(np.cumsum(counts) - counts, counts)
    other = order[np.repeat(first, counts) + step]
    own = order[own]
    alike = dot(faces[own // 3], faces[other // 3]) > np.cos(SMOOTH)
    own, other = own[alike], other[alike]
    weighted = angles[other, None] * faces[other // 3]
    sums = np.stack([np.bincount(own, along, len(vertex)) for along in weighted.T], axis=1)
    return unit(sums).reshape(-1, 3, 3)


def barycentric(cut):
    """The centroids of the triangles into which one is cut, so many along each side: (cut squared, 3) float array."""
    i, j = np.mgrid[:cut, :cut]
    up, down = i + j < cut, i + j < cut - 1
    u = np.concatenate((i[up] + 1 / 3, i[down] + 2 / 3)) / cut
    v = np.concatenate((j[up] + 1 / 3, j[down] + 2 / 3)) / cut
    return np.column_stack((1 - u - v, u, v))
