# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Uncut faces: those of a mesh that came back from a boolean with all their corners, if in triangles."""

import numpy as np

SMALL = 4  # corners of a face: of those the triangles are compared with all faces at once


def uncut(mesh, united, like):
    """The faces that nothing has cut, and what remains.

    Parameters
    ----------
    mesh : Mesh
    united : United
    like : (n,) int array
        The vertex of the mesh that each united one is or is near.

    Returns
    -------
    faces : (f,) int array
        Numbers of the mesh's faces.
    corners : (c,) int array
        Their corners, as united vertices.
    rest : United
        The triangles that are of none of them.
    """
    sizes = np.diff(mesh.offsets)
    ours = np.flatnonzero(united.faces >= 0)
    whole = np.bincount(united.faces[ours], minlength=len(sizes)) == sizes - 2
    ours = ours[whole[united.faces[ours]]]
    ours = ours[np.argsort(united.faces[ours], kind="stable")]
    same = (mesh.vertices[like] == united.vertices).all(axis=1)
    faces, corners = [], []
    for size in np.unique(sizes[united.faces[ours]]):
        some = ours[sizes[united.faces[ours]] == size].reshape(-1, size - 2)
        number, vertex = united.faces[some[:, 0]], united.triangles[some].reshape(len(some), -1)
        wanted = mesh.corners[mesh.offsets[number][:, None] + np.arange(size)]
        found, good = (matched if size <= SMALL else one_by_one)(
            np.where(same[vertex], like[vertex], -1), vertex, wanted
        )
        faces.append(number[good])
        corners.append(found[good].ravel())
    faces = np.concatenate([np.zeros(0, int), *faces])
    kept = np.full(len(sizes) + 1, True)  # the last one for triangles of no face
    kept[faces] = False
    return faces, np.concatenate([np.zeros(0, int), *corners]), united.only(kept[united.faces])


def matched(like, vertex, wanted):
    """At each corner of faces the vertex that is like what is wanted there, and of which faces all are, and no more.

    Parameters
    ----------
    like, vertex : (f, t) int arrays
        The vertices at the corners of each face's triangles, and what they are like.
    wanted : (f, k) int array

    Returns
    -------
    (f, k) int array, (f,) bool array
    """
    pairs = like[:, :, None] == wanted[:, None]
    found = np.take_along_axis(vertex, pairs.argmax(axis=1), axis=1)
    again = np.take_along_axis(found, pairs.argmax(axis=2), axis=1)
    return found, pairs.any(axis=1).all(axis=1) & (again == vertex).all(axis=1)


def one_by_one(like, vertex, wanted):
    """The same for few faces of many corners."""
    found, good = np.zeros_like(wanted), np.zeros(len(wanted), bool)
    for face, (alike, here, asked) in enumerate(zip(like, vertex, wanted, strict=True)):
        known, first = np.unique(alike, return_index=True)
        order = np.argsort(asked)
        if np.array_equal(known, asked[order]) and len(np.unique(here)) == len(asked):
            found[face, order], good[face] = here[first], True
    return found, good
