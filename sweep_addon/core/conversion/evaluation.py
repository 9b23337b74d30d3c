# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The way back: a tree of extrusions that are extruded alike is one extrusion, of the outline of its base face."""

from dataclasses import replace

import numpy as np

from ..contours import Outline
from ..contours.arc_recovery import recover_arcs
from ..csg import Tree
from ..declared.parameters import require
from ..meshes.facets import facets
from ..shapes.translational_sweep import TranslationalSweep

FLAT = 1e-9  # of the height: how far a vertex of the base face may be from its plane
STRAIGHT = 1e-6  # radians: a smaller turn is none
NEAR = 1e-7  # of the size: vertices that are closer are one


def csg_to_sweep(tree):
    """The one translational sweep that a tree of extrusions is.

    Parameters
    ----------
    tree : Tree
        All leaves are translational sweeps that differ in their contours alone, as `sweep_to_csg` leaves them.

    Returns
    -------
    TranslationalSweep
        Of an outline in metres, whose chords that lie on a circle are arcs again.

    Raises
    ------
    ShapeError
        For leaves that are no extrusions, or are extruded otherwise, and where nothing is left.

    Examples
    --------
    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.conversion import sweep_to_csg
    >>> plate = TranslationalSweep(Rectangle(4.0, 2.0, rounding=0.5), 0.1)
    >>> back = csg_to_sweep(sweep_to_csg(plate))
    >>> len(back.contour.loops[0]), back.height
    (8, 0.1)
    """
    first, *others = leaves(tree)
    for leaf in (first, *others):
        require(isinstance(leaf, TranslationalSweep), "must be translational sweeps", type(leaf).__name__, "leaves")
        require(replace(leaf, contour=first.contour) == first, "must be extruded alike", "different ways", "leaves")
    require(not first.is_drafted, "must be without a taper", "a draft", "leaves")
    mesh = tree.mesh()
    require(len(mesh.offsets) > 1, "must leave something", "nothing", "tree")
    loops = [points + shift(first, mesh) for points in base_loops(mesh)]
    tolerance = max(getattr(leaf.contour, "tolerance", 0.0) for leaf in (first, *others))
    outline = Outline(loops, tolerance=tolerance)
    return replace(first, contour=recover_arcs(outline) if any(map(is_curved, (first, *others))) else outline)


def is_curved(leaf):
    """Whether the contour of a leaf has arcs or other curves."""
    bulges = getattr(leaf.contour, "bulges", None)
    if bulges is not None:
        return any(np.any(bulge.values) for bulge in bulges)
    return getattr(leaf.contour, "apexes", lambda: None)() is not None


def leaves(tree):
    """The leaves of a tree of trees, from left to right."""
    if not isinstance(tree, Tree):
        return [tree]
    return [leaf for operand in (tree.base, *(step.operand for step in tree.steps)) for leaf in leaves(operand)]


def shift(sweep, mesh):
    """From the base face of a sweep's mesh to its contour: its reference point, and what an oblique way adds."""
    x, y, z = sweep.direction
    return np.array([sweep.reference_x, sweep.reference_y]) - mesh.vertices[:, 2].min() * np.array([x, y]) / z


def base_loops(mesh):
    """The loops round the lowest faces of a mesh, seen from above: a list of (n, 2) float arrays."""
    low, high = mesh.vertices[:, 2].min(), mesh.vertices[:, 2].max()
    triangles, _ = facets(mesh)
    base = triangles[(mesh.vertices[triangles, 2] < low + FLAT * (high - low)).all(axis=1)]
    edges = np.concatenate([base[:, [1, 0]], base[:, [2, 1]], base[:, [0, 2]]])  # they are seen from below
    inner = {(b, a) for a, b in edges.tolist()}
    after = {a: b for a, b in edges.tolist() if (a, b) not in inner}
    near = NEAR * float(np.ptp(mesh.vertices[:, :2], axis=0).max())
    found = []
    while after:
        loop = [next(iter(after))]
        while loop[-1] in after:
            loop.append(after.pop(loop[-1]))
        found.append(corners(mesh.vertices[loop[:-1], :2], near))
    return [loop for loop in found if len(loop) >= 3]


def corners(points, near):
    """The points of a loop at which it turns."""
    points = points[np.hypot(*(points - np.roll(points, 1, axis=0)).T) > near]
    before, ahead = points - np.roll(points, 1, axis=0), np.roll(points, -1, axis=0) - points
    turn = np.arctan2(before[:, 0] * ahead[:, 1] - before[:, 1] * ahead[:, 0], (before * ahead).sum(axis=1))
    return points[np.abs(turn) > STRAIGHT]
