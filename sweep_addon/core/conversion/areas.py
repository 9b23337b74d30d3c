# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours of several loops: holes are taken off, islands united."""

import numpy as np

from ..contours.offsetting import edges
from ..declared.frozen import frozen
from ..declared.parameters import require
from .decomposition import SIGNS, classified, decompose


@frozen
class Conversion:
    """A contour as decompositions of its loops, one after the other

    Parameters
    ----------
    parts : tuple of (str, Decomposition)
        Each loop after those it lies in: ``start`` the first, ``union`` an outline or an island, ``difference`` a hole.
    """

    parts: tuple

    @property
    def primitives(self):
        """All primitives."""
        return tuple(primitive for _, part in self.parts for primitive in part.primitives)

    def classify(self, points):
        """(n,) bool array: which of the points (n, 2) are inside, by the Boolean operations on the primitives."""
        return classified(self.parts, points)

    def signed_area(self):
        """The areas of all primitives, those that are taken off negative, those taken off a hole positive again."""
        return sum(SIGNS[operation] * part.signed_area() for operation, part in self.parts)


def convert(contour):
    """Take a contour apart into primitives, loop by loop.

    Parameters
    ----------
    contour : Contour
        Closed. Arcs of outlines are taken for arcs, and a circle for a circle and not for its polygon.

    Returns
    -------
    Conversion

    Raises
    ------
    ShapeError
        For open contours.

    Examples
    --------
    >>> from sweep_addon.core.contours import Outline
    >>> square = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> [(operation, part.primitives[0].kind) for operation, part in convert(Outline([square, 4 * square - 1])).parts]
    [('start', 'block'), ('difference', 'block')]
    """
    section = contour.section()
    require(section.closed, "must be closed", "an open one", "contour")
    corners, offsets, bulges = edges(contour)
    parts, cuts = [], offsets[1:-1]
    loops = list(zip(np.split(corners, cuts), np.split(bulges, cuts), strict=True))
    for i in np.argsort(section.depth, kind="stable"):
        operation = "difference" if section.depth[i] % 2 else "union" if parts else "start"
        parts.append((operation, decompose(*loops[i])))
    return Conversion(tuple(parts))
