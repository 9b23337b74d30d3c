# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The offset of a plane region: what a disc visits that moves along its boundary, between lines and true arcs."""

from dataclasses import replace

import numpy as np

from ..contours.offsetting import boundary
from ..declared.options import Side, Texture
from ..declared.parameters import require
from ..grids.in_plane import flat

AXES = np.eye(4, 3, k=-1)[:3]  # the origin, and the axes of the plane


def outline(contour, radius, side=Side.OUTSIDE, tolerance=0.0):
    """The boundary of the offset of a contour.

    Parameters
    ----------
    contour : Contour
        Closed.
    radius : float
        Of the disc, in metres.
    side : Side
    tolerance : float
        How far arcs may be from their chords, in metres; 0 is by the size of the outline.

    Returns
    -------
    Outline

    Raises
    ------
    ShapeError
        For an open contour, inside where nothing is left, or where manifold3d is missing.

    Examples
    --------
    >>> from ..contours import Rectangle
    >>> rounded = outline(Rectangle(2.0, 1.0), 0.5)
    >>> round(rounded.area - (2 + 6 * 0.5 + np.pi * 0.5**2), 9)
    0.0
    """
    require_closed(contour)
    amounts = {Side.OUTSIDE: (radius,), Side.INSIDE: (-radius,), Side.SHELL: (radius, -radius)}[side]
    found = boundary(contour, amounts)
    require(found, "must leave something of the area inside", radius, "radius")
    return replace(found, tolerance=tolerance)


def require_closed(contour):
    """Refuse an open contour, which bounds no area."""
    require(contour.section().closed, "must be closed, a solid or the boundary of an area", "an open one", "body")


def mesh(outline, dtype=np.float64):
    """The area within an outline as a `Mesh` of plane faces, which tells of how many lines and arcs its boundary is."""
    made = flat(outline.section(), AXES, Texture.LENGTHS, False, dtype)
    return replace(made, told=(said(outline),))


def said(outline):
    bulges = outline.edges()[2]
    arcs = np.count_nonzero(bulges)
    return f"Offset in the plane by a disc: its boundary is {len(bulges) - arcs} lines and {arcs} true arcs."
