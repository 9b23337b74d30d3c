# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies: closed meshes of an assembly, about a common point, and which points are how deep in them."""

from functools import cached_property

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import at, require
from ..distance import PseudoNormals, Tree, nearest
from ..later import later
from ..meshes.components import components
from ..meshes.facets import bent_facets
from ..meshes.mesh import Mesh
from ..shapes.operand import Operand
from ..vectors import norms

closed_mesh = later("core.csg.meshes", "closed_mesh")

FLATTEST = 1e-12  # of the cube of its size: a body of less holds nothing


@individual
class Body:
    """A closed surface of triangles that look outwards.

    Parameters
    ----------
    name : str
        By which people know it.
    vertices : (n, 3) float array
        In metres.
    triangles : (t, 3) int array
        The vertices of each, counter-clockwise from outside.
    """

    name: str
    vertices: np.ndarray
    triangles: np.ndarray

    def about(self, point):
        """The same body, seen from a point (3,)."""
        return Body(self.name, self.vertices - point, self.triangles)

    @cached_property
    def size(self):
        """Twice the distance of its farthest point from the middle, in metres: however it is turned."""
        return 2 * float(norms(self.vertices - self.middle).max())

    @cached_property
    def middle(self):
        """The mean of its vertices: (3,) float array."""
        return self.vertices.mean(axis=0)

    @cached_property
    def corners(self):
        """(t, 3, 3) float array: the corners of its triangles."""
        return self.vertices[self.triangles]

    @cached_property
    def shells(self):
        """(n,) int array: the number of the connected surface of each vertex, its first vertex."""
        edges = np.concatenate((self.triangles[:, :2], self.triangles[:, 1:]))
        return components(len(self.vertices), edges)

    @cached_property
    def model(self):
        """The body in the form of fcl."""
        from .touching import hull_tree

        return hull_tree(self.vertices, self.triangles)

    @cached_property
    def search(self):
        """What tells how far points are, and on which side."""
        return Tree.of(self.corners), PseudoNormals.of(self.vertices, self.triangles)

    def depths(self, points):
        """How deep points (n, 3) are in it, in metres, negative outside: (n,) float array."""
        tree, normals = self.search
        found = nearest(tree, points, normals=normals)
        return np.where(normals.outside_of(tree, points, found), -found.distances, found.distances)

    def shell(self, first):
        """One of its surfaces as a body, turned so that it looks outwards."""
        triangles = self.triangles[self.shells[self.triangles[:, 0]] == first]
        used, triangles = np.unique(triangles, return_inverse=True)
        return outward(self.name, self.vertices[used], triangles.reshape(-1, 3))


def outward(name, vertices, triangles):
    """A body of closed triangles that all look outwards, or all inwards."""
    return Body(name, vertices, triangles if volume(vertices, triangles) > 0 else triangles[:, ::-1])


def volume(vertices, triangles):
    """What closed triangles hold, in cubic metres."""
    return float(np.linalg.det(vertices[triangles] - vertices.mean(axis=0)).sum()) / 6


def taken(value, key):
    """The body of what was given as a part of an assembly, or a refusal.

    Parameters
    ----------
    value : Mesh, or a shape, a solid or a tree
    key : str
        Its name in refusals.
    """
    what = f"must be a mesh, a shape, a solid or a tree{instead(value)}"
    require(isinstance(value, Mesh | Operand), what, value, key)
    with at(key):
        mesh = value if isinstance(value, Mesh) else closed_mesh(value)
    vertices = np.asarray(mesh.vertices, dtype=np.float64)
    require(len(mesh.offsets) > 1, "must have faces", f"{len(vertices)} vertices and no face", key)
    wrong = ~np.isfinite(vertices).all(axis=1)
    require(not wrong.any(), "must have finite vertices", vertices[wrong][:1].tolist(), key)
    open_edges, others = len(mesh.boundary_edges()), len(mesh.non_manifold_edges())
    require(not open_edges, "must be closed, for a surface has no inside", f"{open_edges} open edges", key)
    require(not others, "must be manifold, each edge of two faces", f"{others} other edges", key)
    vertices, triangles = bent_facets(mesh)
    vertices = np.asarray(vertices, dtype=np.float64)
    size, held = float(np.ptp(vertices, axis=0).max()), volume(vertices, triangles)
    require(abs(held) > FLATTEST * size**3, "must hold something", f"a volume of {held:.3g}", key)
    return outward(key, vertices, triangles)


def instead(value):
    """What takes the objects of Blender, as the end of a sentence; nothing for other values."""
    known = hasattr(value, "bl_rna")  # no module of Blender is asked here
    return "; sw.from_object reads that of an object, and Find Removal Path takes any meshes" if known else ""


def assembly(values, key):
    """The bodies of several, a list or a dictionary by name; one alone is a list of one."""
    if isinstance(values, Mesh | Operand):
        values = (values,)
    if isinstance(values, dict):
        return [taken(value, str(name)) for name, value in values.items()]
    listed = f"must be meshes or shapes, in a list or by name{instead(values)}"
    require(isinstance(values, list | tuple), listed, values, key)
    return [taken(value, f"{key}.{number}") for number, value in enumerate(values, 1)]
