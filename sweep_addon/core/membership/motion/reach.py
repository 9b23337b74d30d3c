# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a contour gets from chords of its way, and how fast it moves."""

import numpy as np

from ...vectors import dot, norms
from .panels import ORDER, PLACES, at_both, derivative, powers
from .planes import SPACE

STRETCHED = 1.02  # for what is stretched more between these
LEAST = 1e-300


def chords(pieces, region):
    """Chords about which a contour with a region stays in panels: their starts, ways, and how far it gets from them.

    The box around the contour turns and stretches by what its sides do, and its middle leaves the chord by no more
    than what is not straight in its series.
    """
    space = pieces.series[:, SPACE].reshape(-1, 4, 3, ORDER)
    middle, (width, height) = space.mean(axis=1), np.ptp(region.box, axis=0)
    sides = np.einsum("kscj,ij->ksic", space[:, [1, 3]] - space[:, :1], powers(PLACES))
    u, v = sides[:, 0] / max(width, LEAST), sides[:, 1] / max(height, LEAST)
    uu, vv, uv = dot(u, u), dot(v, v), dot(u, v)
    stretch = np.sqrt((uu + vv + np.sqrt((uu - vv) ** 2 + 4 * uv**2)) / 2).max(axis=1)
    bent = 2 * norms(middle[..., 2:].swapaxes(1, 2)).sum(axis=1)
    start, end = at_both(middle)
    return start, end - start, STRETCHED * stretch * region.radius + bent


def speeds(pieces):
    """How far the box around the contour moves at most in half of each panel, but for what is between places: (k,)."""
    space = derivative(pieces.series[:, SPACE]) @ powers(PLACES).T
    return norms(space.reshape(len(space), 4, 3, -1).swapaxes(2, 3)).max(axis=(1, 2))
