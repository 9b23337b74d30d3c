# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh of arrays, and what can be measured on it."""

from dataclasses import replace
from functools import cached_property

import numpy as np

from ..declared.digest import checksum
from ..declared.frozen import individual
from ..declared.parameters import require
from ..vectors import cross
from .runs import following

MOST_VERTICES = 20_000_000
SAMPLE = 64  # of a named topology every so many numbers make its key: enough to tell how another version lays them
MOST = 4096  # of these from a large array, or up to twice as many


@individual
class Topology:
    """Which vertices make which faces and edges, whatever their places.

    Parameters
    ----------
    corners : (c,) int32 array
        The vertex at each corner of each face, one face after the other, counter-clockwise from outside.
    offsets : (f + 1,) int32 array
        Face ``i`` has ``corners[offsets[i]:offsets[i + 1]]``.
    edges : (e, 2) int32 array
        The vertices of each edge.
    corner_edges : (c,) int32 array
        The edge from each corner to the next of its face.
    sharp : (e,) bool array
        Edges that are not to be shaded smooth.
    material : (f,) int32 array
        The material slot of each face.
    name : str
        A short text that differs where what the topology was made from differs, if that is known.
    seam : str
        A short text that differs where faces and edges of the same name join other vertices.
    """

    corners: np.ndarray
    offsets: np.ndarray
    edges: np.ndarray
    corner_edges: np.ndarray
    sharp: np.ndarray
    material: np.ndarray
    name: str = ""
    seam: str = ""

    @cached_property
    def key(self):
        """A short text that differs where topologies differ; of a named one only a sample is looked at."""
        return f"{self.sizes}.{self.seam}{self.looked_at(self.corners, self.edges)}"

    @cached_property
    def sizes(self):
        """How the key begins: the same where faces and edges differ in nothing but the vertices that they join."""
        return self.name + self.looked_at(self.offsets, self.sharp, self.material)

    def looked_at(self, *parts):
        return checksum(*(part[:: max(SAMPLE, len(part) // MOST) if self.name else 1] for part in parts))

    @property
    def nbytes(self):
        """The size of all arrays in bytes."""
        parts = (self.corners, self.offsets, self.edges, self.corner_edges, self.sharp, self.material)
        return sum(part.nbytes for part in parts)

    @cached_property
    def following(self):
        """(c,) int array: the corner that follows each corner in its face."""
        return following(self.offsets)

    @cached_property
    def forward(self):
        """(c,) bool array: whether the face of each corner runs along the edge that starts there as the edge does."""
        return self.edges[self.corner_edges, 0] == self.corners

    def uses(self):
        """Each pair of vertices that faces share, (k, 2), and by how many faces in either direction: two (k,)."""
        start, end = self.corners.astype(np.int64), self.corners[self.following].astype(np.int64)
        low, high = np.minimum(start, end), np.maximum(start, end)
        size = int(self.corners.max(initial=0)) + 1
        keys, which = np.unique(low * size + high, return_inverse=True)
        forward = np.bincount(which.ravel(), weights=start < end, minlength=len(keys)).astype(int)
        total = np.bincount(which.ravel(), minlength=len(keys))
        return np.stack((keys // size, keys % size), axis=1), forward, total - forward


@individual
class Mesh:
    """Vertices and faces, with what is known about them.

    Parameters
    ----------
    vertices : (n, 3) float array
        Places in metres.
    topology : Topology
    chart : object, optional
        The source of texture coordinates and attributes: ``uv()``, ``along()``, ``across()``, ``rings`` and ``keys``.
    told : tuple of str
        Sentences about the shape for people: what was decided where the parameters left it open.

    Examples
    --------
    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
    >>> from sweep_addon.core.trajectories import Line
    >>> box = GeneralizedCylinder(Rectangle(1.0, 2.0), Line(end=(0, 0, 3))).mesh()
    >>> box.vertices.shape, box.corners.shape, box.offsets.tolist()
    ((8, 3), (24,), [0, 4, 8, 12, 16, 20, 24])
    >>> round(box.volume(), 12), round(box.area(), 12), box.euler_characteristic()
    (6.0, 22.0, 2)
    >>> box
    Mesh(8 vertices, 6 faces)
    """

    vertices: np.ndarray
    topology: Topology
    chart: object = None
    told: tuple = ()

    def __repr__(self):
        return f"{type(self).__name__}({len(self.vertices)} vertices, {len(self.offsets) - 1} faces)"

    def astype(self, dtype):
        """The same mesh with vertices of another type, float32 or float64."""
        require_precise(dtype)
        return replace(self, vertices=self.vertices.astype(dtype, copy=False))

    @property
    def corners(self):
        """(c,) int32 array: the vertex at each corner of each face, counter-clockwise from outside.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import Line
        >>> box = GeneralizedCylinder(Rectangle(), Line()).mesh()
        >>> box.vertices[box.corners].reshape(-1, 4, 3).shape
        (6, 4, 3)
        """
        return self.topology.corners

    @property
    def offsets(self):
        """(f + 1,) int32 array: face ``i`` has the corners from ``offsets[i]`` to before ``offsets[i + 1]``.

        Examples
        --------
        >>> from sweep_addon.core.contours import Star
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import Line
        >>> GeneralizedCylinder(Star(3), Line(), start="open", end="open").mesh().offsets.tolist()
        [0, 4, 8, 12, 16, 20, 24]
        """
        return self.topology.offsets

    @property
    def edges(self):
        """(e, 2) int32 array: the vertices of each edge.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import Line
        >>> GeneralizedCylinder(Rectangle(), Line()).mesh().edges.shape
        (12, 2)
        """
        return self.topology.edges

    @cached_property
    def triangles(self):
        """The triangles into which the faces are cut, for programs that know no others: (t, 3) int32 array.

        Counter-clockwise from outside, of the same vertices. Bent faces of four corners are cut along their outer and
        their inner diagonals by turns, so that together they hold about what the faces do. `triangulated` is nearer.

        Examples
        --------
        >>> from sweep_addon.core.solids import Block
        >>> Block().mesh().triangles.shape
        (12, 3)
        """
        from .balancing import balanced_facets

        return balanced_facets(self)

    def triangulated(self):
        """The same mesh of triangles alone, bent faces of four corners cut in four about their middle: a `Mesh`.

        For files of formats that know no other faces: it holds what this mesh does and is as closed as it is. It has
        its material slots, but no texture coordinates and no attributes, and no edges beside its faces.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> bar = GeneralizedCylinder(Rectangle(1.0, 1.0), twist="t").mesh()
        >>> solid = bar.triangulated()
        >>> len(solid.boundary_edges()), abs(solid.volume() - bar.volume()) < 1e-12
        (0, True)
        """
        from .facets import cut
        from .polyhedron import polyhedron

        vertices, triangles, face = cut(self)
        return polyhedron(vertices, triangles, material=self.topology.material[face], told=self.told)

    @property
    def rings(self):
        """How many contours stand along the trajectory."""
        return self.chart.rings

    @cached_property
    def uv(self):
        """(c, 2) float array: texture coordinates of each corner, in metres or from 0 to 1; None where there are none.

        Examples
        --------
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> tube = GeneralizedCylinder(texture="unit").mesh()
        >>> len(tube.uv) == len(tube.corners), tube.uv.min(axis=0).tolist(), tube.uv.max(axis=0).tolist()
        (True, [0.0, 0.0], [1.0, 1.0])
        """
        return self.chart.uv()

    @cached_property
    def attributes(self):
        """Values at each vertex by name: dict of (n,) float arrays; the arc length is in metres.

        Examples
        --------
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import Line
        >>> attributes = GeneralizedCylinder(trajectory=Line(end=(0, 0, 3))).mesh().attributes
        >>> sorted(attributes), round(float(attributes["arc_length"].max()), 12)
        (['arc_length', 'u', 'v'], 3.0)
        """
        return self.chart.along() | self.chart.across()

    def volume(self):
        """The enclosed volume in cubic metres, negative where faces look inwards.

        Source: the divergence theorem. A bent face of four corners counts as the bilinear patch through them, halfway
        between its two pairs of triangles: where all faces bend one way, as on a twisted tube, these differ.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import Line
        >>> round(GeneralizedCylinder(Rectangle(1.0, 2.0), Line(end=(0, 0, 3))).mesh().volume(), 12)
        6.0
        """
        sizes = np.diff(self.offsets)[:, None]
        middles = np.add.reduceat(self.centred[self.corners], self.offsets[:-1], axis=0) / sizes
        return float(np.einsum("ij,ij->", middles, self.normals)) / 3

    def area(self):
        """The area of all faces in square metres; a bent face counts as its shadow on its own plane.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import Line
        >>> round(GeneralizedCylinder(Rectangle(1.0, 2.0), Line(end=(0, 0, 3))).mesh().area(), 12)
        22.0
        """
        return float(np.linalg.norm(self.normals, axis=1).sum())

    @property
    def centred(self):
        """(n, 3) float array: the vertices about their mean, where products round least."""
        return self.vertices - self.vertices.mean(axis=0) if len(self.vertices) else self.vertices

    @cached_property
    def normals(self):
        """(f, 3) float array: the normal of each face, as long as its area in square metres; Newell's method."""
        here = self.centred[self.corners]
        return np.add.reduceat(cross(here, here[self.topology.following]), self.offsets[:-1], axis=0) / 2

    def boundary_edges(self):
        """Edges of one face alone: (k, 2) int array of vertices, empty where the mesh is closed.

        Examples
        --------
        >>> from sweep_addon.core.contours import Circle
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> GeneralizedCylinder(Circle(0.1, points=16), start="open").mesh().boundary_edges().shape
        (16, 2)
        """
        pairs, forward, backward = self.topology.uses()
        return pairs[forward + backward == 1]

    def non_manifold_edges(self):
        """Edges of more than two faces, or of two that look opposite ways: (k, 2) int array of vertices.

        Examples
        --------
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> GeneralizedCylinder().mesh().non_manifold_edges().shape
        (0, 2)
        """
        pairs, forward, backward = self.topology.uses()
        return pairs[(forward > 1) | (backward > 1)]

    def euler_characteristic(self):
        """Vertices - edges + faces: 2 for a ball, 0 for a ring, 2 - 2 g for one closed surface of genus g.

        Examples
        --------
        >>> from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
        >>> from sweep_addon.core.trajectories import TorusKnot
        >>> GeneralizedCylinder(trajectory=TorusKnot()).mesh().euler_characteristic()
        0
        """
        return len(self.vertices) - len(self.edges) + len(self.offsets) - 1

    def dimensions(self):
        """Of which dimension its parts are, and where it is no manifold: `Dimensions`, which prints as a sentence.

        Examples
        --------
        >>> from sweep_addon.core.contours import Outline
        >>> from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
        >>> bend = Outline([[(0, 0), (1, 0), (2, 1)]], closed=False)
        >>> print(TranslationalSweep(bend, direction=(1, 0, 0)).mesh().dimensions())
        1 surface (2D), 1 curve (1D); 1 dangling edge
        """
        from .dimensions import dimensions  # few ask

        return dimensions(self)


def require_few(vertices, key):
    """Refuse a mesh of more vertices than fit into memory, before anything is done for it."""
    require(vertices <= MOST_VERTICES, f"must make at most {MOST_VERTICES:,} vertices", vertices, key)


def require_precise(dtype):
    """Refuse vertices in anything but single or double precision: in whole numbers all would be cut off."""
    try:
        precise = np.dtype(dtype) in (np.float32, np.float64)
    except (TypeError, ValueError):
        precise = False
    require(precise, "must be float32 or float64", dtype, "dtype")
