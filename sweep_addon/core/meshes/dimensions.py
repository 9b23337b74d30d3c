# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Of which dimension the parts of a mesh are, and where it is no manifold.

A part is a piece whose inside hangs together: a solid, a surface that bounds none, a curve of loose edges, or a loose
vertex. Pieces that meet in a point or along an edge alone are several parts, and the place is named.
"""

import numpy as np

from ..declared.frozen import individual
from .components import components
from .runs import run_of
from .sheets import in_pairs, partners, shells

NAMES = ("solid", "surface", "curve", "point")
FEW = 4  # contours that show all of a sweep that turns little
PLACES = ("dangling edge", "connecting edge", "singular point", "non-manifold edge")


@individual
class Dimensions:
    """The parts of a mesh by dimension, and its singular places.

    Parameters
    ----------
    solids, surfaces, curves, points : int
        How many parts are of dimension 3, 2, 1 and 0. A closed surface counts as the solid that it bounds.
    dangling_edges : tuple of (k, 2) int arrays
        The edges, as vertices, of each curve that hangs on something with one end, the other end free.
    connecting_edges : tuple of (k, 2) int arrays
        Those of each curve that hangs on something with both ends.
    singular_points : (k,) int array
        The vertices at which faces meet that no edge there joins, as those of a double cone at its tip.
    non_manifold_edges : (k, 2) int array
        The edges of more than two faces, or of two that look opposite ways.

    Examples
    --------
    >>> from ..contours import Outline
    >>> from ..shapes.rotational_sweep import RotationalSweep
    >>> cones = RotationalSweep(Outline([[(-1, -1), (1, 1)]], closed=False), crossing="meet").mesh()
    >>> print(cones.dimensions())
    2 surfaces (2D); 1 singular point
    """

    solids: int
    surfaces: int
    curves: int
    points: int
    dangling_edges: tuple
    connecting_edges: tuple
    singular_points: np.ndarray
    non_manifold_edges: np.ndarray

    @property
    def parts(self):
        """How many parts there are of dimension 3, 2, 1 and 0."""
        return self.solids, self.surfaces, self.curves, self.points

    @property
    def homogeneous(self):
        """Whether all parts are of one dimension."""
        return sum(map(bool, self.parts)) == 1

    @property
    def places(self):
        """How many dangling and connecting edges, singular points and non-manifold edges there are."""
        return tuple(
            map(len, (self.dangling_edges, self.connecting_edges, self.singular_points, self.non_manifold_edges))
        )

    def __str__(self):
        return sentence(self.parts, self.places)


def sentence(parts, places):
    """The parts and places of a mesh, by their numbers, for people."""
    named = zip(NAMES, parts, (3, 2, 1, 0), strict=True)
    said = [", ".join(f"{counted(number, name)} ({dimension}D)" for name, number, dimension in named if number)]
    return "; ".join(said + [counted(number, name) for name, number in zip(PLACES, places, strict=True) if number])


def told(mesh, fewer, turned=0):
    """What is told of the parts of a sweep: counted on two of few contours where it has many.

    Parameters
    ----------
    mesh : Mesh
        Of the sweep.
    fewer : callable
        From a number of contours to the mesh of the same sweep with so many, or some more: these.
    turned : int

    Returns
    -------
    str
        As `Dimensions` prints it.

    From contour to contour all steps are alike: each has the same edges and the same faces round them, whose order is
    that of the edges in the plane halfway. One contour more adds no part, and as many places as any other.
    """
    if mesh.rings <= 2 * (FEW + turned):
        return str(mesh.dimensions())
    few, more = fewer(FEW), fewer(FEW + 1)
    left = (mesh.rings - few.rings) // (more.rings - few.rings)
    few, more = few.dimensions(), more.dimensions()
    return sentence(few.parts, (a + left * (b - a) for a, b in zip(few.places, more.places, strict=True)))


def counted(number, name):
    return f"{number:,} {name}{'s' * (number != 1)}"


def dimensions(mesh):
    """The parts of a mesh by dimension: `Dimensions`."""
    shell, sheet = shells(mesh, partners(mesh))
    curve, free, held = curves(mesh)
    dangling, connecting = (
        tuple(mesh.edges[curve == i] for i in np.flatnonzero((free == loose) & (held == 2 - loose))) for loose in (1, 0)
    )
    edges = mesh.non_manifold_edges()
    return Dimensions(
        solids=solids(mesh, shell, sheet),
        surfaces=surfaces(mesh, sheet),
        curves=len(np.unique(curve[curve >= 0])),
        points=int((~marked(mesh.edges, len(mesh.vertices))).sum()),
        dangling_edges=dangling,
        connecting_edges=connecting,
        singular_points=np.setdiff1d(np.flatnonzero(fans(mesh) > 1), edges),
        non_manifold_edges=edges,
    )


def solids(mesh, shell, sheet):
    """How many shells are the outside of a solid: those of cavities look inwards."""
    face = run_of(mesh.offsets)
    centred = mesh.vertices - mesh.vertices.mean(axis=0)
    middles = np.add.reduceat(centred[mesh.corners], mesh.offsets[:-1], axis=0) / np.bincount(face)[:, None]
    volumes = np.bincount(shell, np.einsum("ij,ij->i", middles, mesh.normals) * ~sheet)
    return int((volumes > 0).sum())


def surfaces(mesh, sheet):
    """How many parts the sheets make: two that meet at an edge of more faces are two."""
    face = run_of(mesh.offsets)
    pairs = face[in_pairs(mesh.topology.corner_edges, np.arange(len(face)))]
    part = components(len(sheet), pairs[sheet[pairs].all(axis=1)])
    return int(marked(part[sheet], len(sheet)).sum())


def curves(mesh):
    """The curve that each edge is of, -1 for those of faces, and how many free and held ends the curves have.

    At a held end are faces, or more than one other curve; a ring has no ends.
    """
    loose = np.flatnonzero(~marked(mesh.topology.corner_edges, len(mesh.edges)))
    ends = mesh.edges[loose]
    degree = np.bincount(ends.ravel(), minlength=len(mesh.vertices))
    held = marked(mesh.corners, len(mesh.vertices))
    order = np.argsort(ends.ravel(), kind="stable")
    inner = order[((degree == 2) & ~held)[ends.ravel()[order]]]
    part = components(len(loose), inner.reshape(-1, 2) // 2)
    curve = np.full(len(mesh.edges), -1)
    curve[loose] = part
    free, held = (degree == 1) & ~held, held | (degree > 2)
    return curve, *(np.bincount(part, at_end[ends].sum(axis=1), minlength=len(loose)) for at_end in (free, held))


def marked(numbers, count):
    """(count,) bool array: which numbers there are."""
    found = np.full(count, False)
    found[numbers] = True
    return found


def fans(mesh):
    """(n,) int array: how many fans of faces meet at each vertex; neighbours in a fan share an edge there."""
    corners, ahead = np.arange(len(mesh.corners)), mesh.topology.following
    edges, ends = mesh.topology.corner_edges, mesh.edges

    def end(edge, vertex):
        return 2 * edge + (ends[edge, 1] == vertex)

    there = mesh.corners[ahead]
    pairs = np.stack((end(edges[corners], there), end(edges[ahead], there)), axis=1)
    fan = components(2 * len(ends), pairs)
    return np.bincount(ends.ravel()[marked(fan[pairs], 2 * len(ends))], minlength=len(mesh.vertices))
