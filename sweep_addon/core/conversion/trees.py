# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep-CSG tree of an extrusion: each primitive extruded as far."""

from dataclasses import replace

import numpy as np

from ..contours import Mixed, Outline
from ..contours.arcs import apexes
from ..contours.offsetting import edges
from ..contours.outline import size
from ..csg import Tree
from ..declared.parameters import require
from ..meshes.runs import following
from ..rings.ends import Flat, Open
from ..shapes.translational_sweep import FLATTEST, Reference, TranslationalSweep
from .areas import convert
from .decomposition import prepared
from .edges import sagitta
from .kinds import kind_of
from .seams import seamed
from .tolerance import Tolerance


def sweep_to_csg(shape):
    """Convert an extruded outline of lines and arcs to a sweep-CSG tree of blocks, wedges, cylinders and the like.

    Parameters
    ----------
    shape : TranslationalSweep
        Out of the plane of its closed contour, straight or obliquely, and without taper.

    Returns
    -------
    Tree
        Its operands are translational sweeps of primitives, in metres and where the sweep is; holes and islands are
        trees of their own. `kind` tells what a primitive is called.

    Raises
    ------
    ShapeError
        For other shapes, open contours, tapers, and sweeps within the plane.

    Source
    ------
    D.L. Vossler: Sweep-to-CSG Conversion Using Pattern Recognition Techniques, IEEE Computer Graphics and Applications
    5(8), 1985, pp. 61-68.

    Examples
    --------
    >>> from sweep_addon.core.contours import Rectangle
    >>> plate = TranslationalSweep(Rectangle(4.0, 2.0, rounding=0.5), 0.1)
    >>> tree = sweep_to_csg(plate)
    >>> kind(tree.base), [kind(step.operand) for step in tree.steps]
    ('block', ['fillet', 'fillet', 'fillet', 'fillet'])
    """
    require(isinstance(shape, TranslationalSweep), "must be a translational sweep", type(shape).__name__, "shape")
    require(not (shape.taper or shape.hole_taper or len(shape.tapers)), "must be 0", "a draft", "taper")
    out = abs(shape.direction[2]) / max(np.linalg.norm(shape.direction), np.finfo(float).tiny)
    require(out > FLATTEST, "must lead out of the contour's plane", shape.direction, "direction")
    require(not isinstance(shape.contour, Mixed), "must be an area", "Mixed", "contour")
    for key in ("start", "end"):
        require(not isinstance(getattr(shape, key), Open), "must not be open: a tree is of solids", "open", key)
    sweep, tolerance = extruded(shape), chord_error(shape.contour)
    parts = [(operation, tree_of(part, sweep, tolerance)) for operation, part in convert(shape.contour).parts]
    base = parts[0][1]
    return Tree(base.base, (*base.steps, *parts[1:]))


def extruded(shape):
    """The sweep with nothing but its way: its reference point is the same for every contour, its ends are closed."""
    if shape.reference is Reference.CENTROID:
        x, y = shape.contour.section().centroid.tolist()
        shape = replace(shape, reference=Reference.POINT, reference_x=x, reference_y=y)
    return replace(shape, start=Flat(), end=Flat(), regularize=False)


def chord_error(contour):
    """The distance within which the arcs of a contour become chords."""
    corners, offsets, bulges = edges(contour)
    middles = apexes(corners, corners[following(offsets)], bulges)
    return getattr(contour, "tolerance", 0.0) or size(np.concatenate([corners, middles])) / 1000


def tree_of(part, sweep, tolerance):
    """The tree of one loop's decomposition."""
    operations, primitives = zip(*part.operations, strict=True)
    loops = seamed([primitive.loop for primitive in primitives], Tolerance.of(part.loop).near)
    solids = [replace(sweep, contour=drawn(loop, tolerance)) for loop in loops]
    return Tree(solids[0], tuple(zip(operations[1:], solids[1:], strict=True)))


def drawn(loop, tolerance):
    """A primitive as a contour, its arcs with the chords that they have in the outline, but never with a single one."""
    rises = [sagitta(edge) for edge in loop.edges() if edge[4]]
    return Outline([loop.corners], [loop.bulges], min([tolerance, *(rise / 2 for rise in rises)]))


def kind(operand):
    """What a primitive of a tree is called; nothing where it is none.

    Parameters
    ----------
    operand : TranslationalSweep
        Of an `Outline` of one loop.

    Returns
    -------
    str or None
        One of `KINDS`.
    """
    contour = getattr(operand, "contour", None)
    if not isinstance(contour, Outline) or len(contour.loops) != 1 or not contour.closed:
        return None
    corners, _, bulges = contour.edges()
    loop = prepared(corners, bulges)
    return kind_of(loop.cleaned(Tolerance.of(loop).near))
