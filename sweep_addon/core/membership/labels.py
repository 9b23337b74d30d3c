# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The labels of points against a set: in, on or out, and one for those that their neighbourhood decides."""

import numpy as np

IN, ON, OUT = 1, 0, -1
TOUCHED = 2  # on more than one boundary at once, or on a fold: what is around the point decides

DIRECTIONS, FEW = 96, 8
RADIUS = 1.0  # tolerances: how far the neighbours are; a boundary that is farther does not count
FINER = 1e-3  # of the tolerance: what counts as on, of a neighbour
GOLDEN = np.pi * (3 - np.sqrt(5))


def around(count=DIRECTIONS):
    """Unit vectors spread evenly over the sphere, on a spiral of the golden angle: (count, 3)."""
    z = 1 - (2 * np.arange(count) + 1) / count
    angle = GOLDEN * np.arange(count) + 0.1
    across = np.sqrt(1 - z**2)
    return np.stack((across * np.cos(angle), across * np.sin(angle), z), axis=1)


def decided(labels, points, tolerance, member):
    """Labels in which those that a neighbourhood decides are decided: in if all around is in, out if all is out.

    A few directions tell of nearly all that are on; only where these agree all are asked. Of what is thinner than
    these, as the tip of a spike, a member may know by itself: ``is_thin(points, tolerance)``.
    """
    asked, labels = np.flatnonzero(labels == TOUCHED), labels.copy()
    some_in, some_out = np.zeros((2, len(labels)), dtype=bool)
    directions = around()
    for part in (directions[:: DIRECTIONS // FEW], directions):
        places = points[asked][:, None] + RADIUS * tolerance * part
        found = member.labels(places.reshape(-1, 3), FINER * tolerance).reshape(len(asked), len(part))
        some_in[asked] |= (found == IN).any(axis=1)
        some_out[asked] |= (found == OUT).any(axis=1)
        asked = asked[~(some_in & some_out)[asked]]
    left = labels == TOUCHED
    labels[left] = np.where(some_in & some_out, ON, np.where(some_out, OUT, IN))[left]
    if hasattr(member, "is_thin"):
        thin = np.flatnonzero(left & (labels == OUT))
        labels[thin[member.is_thin(points[thin], tolerance)]] = ON
    return labels


def joined(labels, others):
    """The labels of points against a union."""
    sure = (labels == IN) | (others == IN)
    both = (labels == ON) & (others == ON) | (labels == TOUCHED) | (others == TOUCHED)
    return np.where(sure, IN, np.where(both, TOUCHED, np.maximum(labels, others))).astype(np.int8)


def negated(labels):
    """The labels of points against what is left of space."""
    return np.where(labels == TOUCHED, TOUCHED, -labels).astype(np.int8)
