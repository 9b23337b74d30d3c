# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Directions in which a part may get out, all told by its form and its place: who turns the assembly turns them too."""

import numpy as np

from ..vectors import cross, norms, unit

ALIKE = 1e-6  # 1 - cosine: directions that differ by less are one
FEW = 12  # normals of the part that count, and of all around, those of the largest faces
CROSSED = 5  # of these, of which each two give a direction across both


def candidates(part, others, contacts):
    """Directions to try, the likeliest first.

    Parameters
    ----------
    part : Body
    others : list of Body
    contacts : Contacts
        Where it touches others or nearly does.

    Returns
    -------
    (n, 3) float array
        Unit vectors.
    """
    normals = main_normals(part)
    some = normals[:CROSSED]
    crossed = unit(cross(*np.broadcast_arrays(some[:, None], some))).reshape(-1, 3)
    lattice = np.stack(np.meshgrid(*3 * ((-1.0, 0.0, 1.0),), indexing="ij"), axis=-1).reshape(-1, 3)
    around = main_normals(*others)
    own = unit(lattice) @ own_axes(part).T
    there = (*contacts.translations(), -contacts.mean_normal(), *normals, *around, *crossed, *own)
    both = np.stack(there)
    return distinct(np.stack((both, -both), axis=1).reshape(-1, 3))


def main_normals(*bodies):
    """The normals of the faces of bodies, those that cover most first: (k, 3) float array, k at most `FEW`."""
    a, b, c = np.concatenate([body.corners for body in bodies]).swapaxes(0, 1)
    areas = cross(b - a, c - a)
    rounded, which = np.unique(unit(areas).round(4) + 0.0, axis=0, return_inverse=True)
    sums = np.stack([np.bincount(which.ravel(), along, len(rounded)) for along in areas.T], axis=1)
    largest = np.argsort(-norms(sums).round(9), kind="stable")[:FEW]
    return distinct(unit(sums[largest]))


def own_axes(part):
    """Axes that turn with the part, as columns: along the longest side of its largest face, across it, out of it."""
    a, b, c = part.corners.swapaxes(0, 1)
    areas = cross(b - a, c - a)
    largest = int(np.argmax(norms(areas) >= (1 - ALIKE) * norms(areas).max()))
    sides = np.stack((b - a, c - b, a - c))[:, largest]
    along, out = unit(sides[np.argmax(norms(sides))]), unit(areas[largest])
    return np.column_stack((along, cross(out, along), out))


def distinct(directions):
    """Directions (n, 3) without zeros and repetitions, in their order."""
    directions = directions[norms(directions) > 0.5]
    alike, kept = directions @ directions.T >= 1 - ALIKE, []
    for number in range(len(directions)):
        if not alike[number, kept].any():
            kept.append(number)
    return directions[kept]
