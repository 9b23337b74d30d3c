# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Booleans of solids: the one place that asks manifold3d, in double precision and only when something is made.

A *body* is manifold3d's own form of a closed mesh. Who makes many and wants one keeps bodies until the end, for going
to and fro costs more than a hull does; who has meshes and wants a mesh asks `union`.
"""

from functools import cache

import numpy as np

from ..declared.parameters import ShapeError, require
from .facets import bent_facets
from .films import without_films
from .polyhedron import polyhedron

MISSING = "needs the library manifold3d, which is missing here: pip install manifold3d"


def library():
    """The module manifold3d, or a refusal that says how to get it."""
    try:
        import manifold3d
    except ImportError as error:
        raise ShapeError(f"A union of solids {MISSING}") from error
    return manifold3d


def is_there():
    """Whether there is manifold3d, without which nothing is united."""
    try:
        library()
    except ShapeError:
        return False
    return True


@cache
def named():
    """The number by which manifold3d knows that the faces of a body have numbers of ours."""
    return library().Manifold.reserve_ids(1)


def body(vertices, triangles, faces=None):
    """The body of a closed mesh of triangles.

    Parameters
    ----------
    vertices : (n, 3) float array
        Places in metres.
    triangles : (t, 3) int array
        Vertices of each triangle, counter-clockwise from outside.
    faces : (t,) int array, optional
        The number of the face that each triangle is a part of. What is left of it keeps that, whatever is done with the
        body: see `arrays`. An edge between faces stays, as far as anything on both sides of it does.

    Raises
    ------
    ShapeError
        For a mesh that is not closed, manifold and oriented.
    """
    manifold3d = library()
    told = {}
    if faces is not None:
        run = np.array([0, 3 * len(triangles)], np.uint64), np.array([named()], np.uint32)
        told = {"face_id": np.asarray(faces, np.uint64), "run_index": run[0], "run_original_id": run[1]}
    vertices = np.array(vertices, np.float64, order="C")  # manifold3d takes no array that is read-only
    made = manifold3d.Manifold(manifold3d.Mesh64(vertices, np.ascontiguousarray(triangles, np.uint64), **told))
    status = made.status()
    require(status == manifold3d.Error.NoError, "A boolean takes closed, manifold, oriented meshes", status.name)
    return made


def body_of(mesh):
    """The body of a `Mesh`."""
    return body(*bent_facets(mesh))


def hull_body(points):
    """The body of the convex hull of points (n, 3); one that holds nothing where they lie in a plane."""
    return library().Manifold.hull_points(np.array(points, np.float64, order="C"))


def united(bodies):
    """The body of everything that is in any of some bodies."""
    manifold3d = library()
    return manifold3d.Manifold.batch_boolean(list(bodies), manifold3d.OpType.Add)


def combined(operation, body, other):
    """The body of a union, an intersection or a difference of two bodies."""
    named = {"union": body.__add__, "intersection": body.__xor__, "difference": body.__sub__}
    return named[operation](other)


def arrays(body):
    """The mesh of a body: vertices (n, 3), triangles (t, 3), and the number of the face of each, -1 for none, (t,)."""
    mesh = body.to_mesh64()
    runs = np.diff(np.asarray(mesh.run_index, int)) // 3
    ours = np.repeat(np.asarray(mesh.run_original_id) == named(), runs)
    faces = np.where(ours, np.asarray(mesh.face_id, int), -1)
    return np.array(mesh.vert_properties[:, :3]), mesh.tri_verts.astype(np.int32), faces


def mesh_of(body):
    """The body as a `Mesh` of triangles, without films between what was united."""
    vertices, triangles, _ = arrays(body)
    used, corners = np.unique(without_films(vertices, triangles), return_inverse=True)
    return polyhedron(vertices[used], corners.reshape(-1, 3))


def union(meshes):
    """Everything that is in any of some solids.

    Parameters
    ----------
    meshes : sequence of Mesh
        Closed, manifold and oriented. None of them may cross itself: what such a one would give is not defined.

    Returns
    -------
    Mesh
        Of triangles, closed and manifold.

    Raises
    ------
    ShapeError
        For a mesh that is not closed, or where manifold3d is missing.

    Examples
    --------
    >>> from sweep_addon.core.contours import Rectangle
    >>> from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
    >>> bar = TranslationalSweep(Rectangle(3.0, 1.0), height=1.0).mesh()
    >>> cross = union([bar, TranslationalSweep(Rectangle(1.0, 3.0), height=1.0).mesh()])
    >>> round(cross.volume(), 12), cross.euler_characteristic()
    (5.0, 2)
    """
    return mesh_of(united(map(body_of, meshes)))
