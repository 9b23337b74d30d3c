# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vossler's conversion: an outline of lines and arcs, taken apart by the patterns in it to a list of primitives."""

import numpy as np

from ..declared.frozen import frozen
from ..declared.parameters import require
from .choice import best
from .contacts import cross, meet
from .edges import apex, half_tangent, sagitta
from .kinds import kind_of
from .loop import Loop
from .primitive import Primitive, outline_of
from .tolerance import Tolerance

SIGNS = {"start": 1, "union": 1, "difference": -1}
MOST_HALVINGS = 1000


@frozen
class Step:
    """What was recognised in an outline, and what remains of it

    Parameters
    ----------
    operation : str
        What gives the outline back from what remains: ``union``, ``difference``, or ``start`` of the last primitive,
        of which nothing remains. ``halve`` where no pattern was found: an arc became two.
    primitive : Primitive or None
        What to unite with or to take off; nothing where an arc was halved.
    remaining : Loop or None
        The outline that remains.
    """

    operation: str
    primitive: Primitive | None
    remaining: Loop | None

    @property
    def outline(self):
        """What remains as a contour that can be swept, or nothing."""
        return self.remaining and outline_of(self.remaining)


@frozen
class Decomposition:
    """An outline of lines and arcs as primitives that are united and taken off one after the other

    Parameters
    ----------
    loop : Loop
        The outline, counter-clockwise and without needless vertices.
    steps : tuple of Step
        How it was taken apart, until a primitive was left.

    Examples
    --------
    A slot is a block between two half discs:

    >>> slot = decompose([(0, 0), (3, 0), (3, 1), (0, 1)], [0, 1, 0, 1])
    >>> [(operation, primitive.kind) for operation, primitive in slot.operations]
    [('start', 'block'), ('union', 'minor chorded cylinder'), ('union', 'minor chorded cylinder')]
    """

    loop: Loop
    steps: tuple

    @property
    def operations(self):
        """Operation and primitive in the order that gives the outline back: from the one that was left, backwards."""
        return tuple((step.operation, step.primitive) for step in reversed(self.steps) if step.primitive)

    @property
    def primitives(self):
        """The primitives in the order of `operations`."""
        return tuple(primitive for _, primitive in self.operations)

    def classify(self, points):
        """(n,) bool array: which of the points (n, 2) are inside, by the Boolean operations on the primitives."""
        return classified(self.operations, points)

    def signed_area(self):
        """The areas of the primitives, those that are taken off negative.

        It is the outline's: what is united shares no area with the rest, and what is taken off lies within it.
        """
        return sum(SIGNS[operation] * primitive.area for operation, primitive in self.operations)


def classified(parts, points):
    """Which points (n, 2) are in what parts, pairs of an operation and what classifies, leave one after the other."""
    found = np.zeros(len(points), dtype=bool)
    for operation, part in parts:
        inside = part.classify(points)
        found = found & ~inside if operation == "difference" else found | inside
    return found


def decompose(corners, bulges=None):
    """Take a closed outline of lines and arcs apart into primitives.

    Parameters
    ----------
    corners : (n, 2) float array-like
        Its vertices, in either direction; the outline must not cross or touch itself.
    bulges : (n,) float array-like, optional
        The bulge of the edge after each: the tangent of a quarter of its arc's angle, positive where it turns left.
        By default all edges are lines.

    Returns
    -------
    Decomposition

    Raises
    ------
    ShapeError
        If the outline encloses nothing, or crosses itself so that it cannot be taken apart.

    Source
    ------
    D.L. Vossler: Sweep-to-CSG Conversion Using Pattern Recognition Techniques, IEEE Computer Graphics and Applications
    5(8), 1985, pp. 61-68. Its five steps: search the outline for a simple solid; keep that with its operation; reduce
    the outline by it, an arc to a line or by vertices; end when nothing is enclosed any more; evaluate backwards.
    """
    loop = prepared(corners, bulges)
    tolerance = Tolerance.of(loop)
    fine = tolerance._replace(near=tolerance.least)  # where edges are shorter than what counts as touching
    steps, outline, halvings = [], loop, 0
    while not (kind := kind_of(outline)):
        found = best(outline, tolerance) or best(outline, fine)
        if found:
            steps.append(reduced(outline, found, tolerance))
        else:
            halvings += 1
            possible = any(outline.bulges) and halvings <= MOST_HALVINGS
            require(possible, "must not touch itself", "one that does", "outline")
            steps.append(Step("halve", None, halved(outline)))
        outline = steps[-1].remaining
    steps.append(Step("start", Primitive(kind, outline), None))
    return Decomposition(loop, tuple(steps))


def prepared(corners, bulges):
    """The outline as a loop, counter-clockwise and without needless vertices; refuses what is no outline."""
    corners = np.asarray(corners, dtype=float)
    bulges = np.zeros(len(corners)) if bulges is None else np.asarray(bulges, dtype=float)
    require(corners.ndim == 2 and corners.shape[1] == 2, "must be pairs of numbers", corners.shape, "corners")
    require(bulges.shape == corners.shape[:1], "must be one number a corner", bulges.shape, "bulges")
    require(np.isfinite(corners).all() and np.isfinite(bulges).all(), "must be finite", "others", "corners and bulges")
    require(len(corners) > 1, "must be at least two", len(corners), "corners")
    loop = Loop(tuple(map(tuple, corners.tolist())), tuple((bulges + 0.0).tolist()))
    tolerance = Tolerance.of(loop)
    loop = loop.cleaned(tolerance.least)
    area = loop.area
    require(area != 0 and (len(loop.corners) > 2 or any(loop.bulges)), "must enclose an area", area, "outline")
    require(not crossed(loop, tolerance), "must not cross or touch itself", "one that does", "outline")
    return loop if area > 0 else loop.reversed()


def crossed(loop, tolerance):
    """Whether two edges meet, neighbours elsewhere than at their common end."""
    edges = loop.edges()
    n = len(edges)
    apart = ((i, j) for i in range(n) for j in range(i + 2, n) if j - i < n - 1)
    beside = ((i, (i + 1) % n) for i in range(n if n > 2 else 0))
    return any(meet(edges[i], edges[j], (), 0.0) for i, j in apart) or any(
        cross(edges[i], edges[j], (edges[j][:2],), tolerance.seen) for i, j in beside
    )


def reduced(outline, found, tolerance):
    """The step that removes a pattern from an outline."""
    pattern = found.pattern
    remaining = outline.replaced(pattern.start, pattern.count, pattern.corners, pattern.bulges)
    return Step(found.operation, Primitive(found.kind, found.region), remaining.cleaned(tolerance.least))


def halved(outline):
    """The outline with the arc that is farthest from its chord as two."""
    edges = outline.edges()
    index = max(range(len(edges)), key=lambda i: sagitta(edges[i]))
    bulge = half_tangent(edges[index][4])
    return outline.replaced(index, 1, (edges[index][:2], apex(edges[index])), (bulge, bulge))
