# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Slipping: the motions in which the places where a part touches others slide along these, and do not press on them."""

import numpy as np

from ..declared.frozen import individual
from ..distance import nearest
from ..vectors import cross, dot, norms, unit

SAMPLES = 4000  # places of the surface that are looked at, roughly
SLIPS = 0.05  # of the normal speed of a random motion: what presses less than that slides


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
        """The motions in which all contacts slide: the speed of the origin, and the turn about it, (k, 3) twice.

        Source
        ------
        Gelfand, Guibas: Shape segmentation using local slippage analysis, SGP 2004.
        """
        if not len(self.normals):
            return np.zeros((0, 3)), np.zeros((0, 3))
        middle, half = self.places.mean(axis=0), self.size / 2
        rows = np.column_stack((self.normals, cross((self.places - middle) / half, self.normals)))
        values, vectors = np.linalg.eigh(rows.T @ rows / len(rows))
        found = vectors.T[values <= SLIPS**2]
        turns = found[:, 3:] / half
        return found[:, :3] - cross(turns, np.broadcast_to(middle, turns.shape)), turns


def sampled(part):
    """Places spread over the surface of a body, about as many as `SAMPLES`, and the normals there: (n, 3) twice."""
    a, b, c = part.corners.swapaxes(0, 1)
    areas = cross(b - a, c - a)
    sizes = norms(areas)
    cuts = np.ceil(np.sqrt(sizes / sizes.sum() * SAMPLES)).astype(int).clip(1)
    places, normals = [], []
    for cut in np.unique(cuts):  # into so many parts along each side: few different ones
        which = cuts == cut
        weights = barycentric(int(cut))
        places.append(np.einsum("kc,tcx->tkx", weights, part.corners[which]).reshape(-1, 3))
        normals.append(np.repeat(unit(areas[which]), len(weights), axis=0))
    return np.concatenate(places), np.concatenate(normals)


def barycentric(cut):
    """The centroids of the triangles into which one is cut, so many along each side: (cut squared, 3) float array."""
    i, j = np.mgrid[:cut, :cut]
    up, down = i + j < cut, i + j < cut - 1
    u = np.concatenate((i[up] + 1 / 3, i[down] + 2 / 3)) / cut
    v = np.concatenate((j[up] + 1 / 3, j[down] + 2 / 3)) / cut
    return np.column_stack((1 - u - v, u, v))


def across(direction, normals):
    """How much a direction presses at most on what has these normals outwards: the largest cosine."""
    return float(dot(normals, np.broadcast_to(direction, normals.shape)).max(initial=-1.0))
