# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Heights: how thin triangles are."""

import numpy as np

OTHER = np.array([1, 2, 0])  # the corner after each


def heights(vertices, triangles):
    """The height of triangles above their longest side, (t,), and the length of the side after each corner, (3, t).

    No side is shorter than that height, so whatever has a short side is thin.

    Examples
    --------
    >>> height, lengths = heights(np.array([(0, 0, 0), (4, 0, 0), (1, 2, 0)]), np.array([(0, 1, 2)]))
    >>> height.tolist(), (lengths**2).round(9).tolist()
    ([2.0], [[16.0], [13.0], [5.0]])
    """
    places = vertices.T[:, triangles.T]  # each number of all corners in one row, which is quickest
    x, y, z = sides = places[:, OTHER] - places
    lengths = np.sqrt(np.einsum("kij,kij->ij", sides, sides))
    area = np.sqrt(sum((a[0] * b[1] - b[0] * a[1]) ** 2 for a, b in ((x, y), (y, z), (z, x))))
    longest = lengths.max(axis=0)
    return area / np.where(longest, longest, 1.0), lengths
