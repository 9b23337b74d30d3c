# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Assembling: one mesh of what was united and of what was left out of that, with the faces that nothing has cut."""

from dataclasses import replace

import numpy as np

from ..declared.frozen import individual
from ..grids.laying import SIDE
from ..meshes.polyhedron import polyhedron
from ..meshes.welding import Selected
from ..vectors import norms
from .equal_rows import equal_rows
from .sewing import corners_of, sewn
from .uncut import uncut


@individual
class United:
    """What came of uniting some bodies.

    Parameters
    ----------
    vertices : (n, 3) float array
    triangles : (t, 3) int array
    faces : (t,) int array
        The face of the sweep's mesh that each is a part of; -1 for one of a hull, and beyond all faces for a cut.
    """

    vertices: np.ndarray
    triangles: np.ndarray
    faces: np.ndarray

    def only(self, chosen):
        return replace(self, triangles=self.triangles[chosen], faces=self.faces[chosen])


def assembled(rings, left, some, united, number):
    """The mesh of all parts.

    Parameters
    ----------
    rings : Rings
    left : (f,) int array
        The faces of the mesh that were not united, in order.
    some : (k,) int array
        The vertices of those that were.
    united : United
        Without faces of cuts.
    number : (n,) int array
        The vertex of the mesh that each united one is, counted on after these where both are not joined.

    Returns
    -------
    Mesh
    """
    mesh, count = rings.mesh, len(rings.mesh.vertices)
    like = likened(mesh, some, united)
    whole, corners, rest = uncut(mesh, united, like)
    vertices = np.concatenate((number[corners], number[rest.triangles].ravel()))
    used = np.full(count + len(number), False)
    used[mesh.corners[corners_of(mesh.offsets, left)]] = used[vertices] = True
    renumbered = np.cumsum(used) - 1
    sizes = np.concatenate((np.diff(mesh.offsets)[whole], np.full(len(rest.faces), 3)))
    material = np.where(rest.faces < 0, SIDE, mesh.topology.material[rest.faces])
    made = polyhedron(
        np.concatenate((mesh.vertices, united.vertices))[used],
        renumbered[vertices],
        np.concatenate(([0], np.cumsum(sizes))),
        np.concatenate((mesh.topology.material[whole], material)),
        mesh.told,
    )
    was = corners_of(mesh.offsets, whole)
    keep_sharpness(made.topology, mesh.topology, was)
    was = np.concatenate((corners_of(mesh.offsets, left), was, cut_corners(mesh, rest, like)))
    chart = Selected(mesh.chart, np.concatenate((np.arange(count), like))[used], was)
    return replace(made, topology=sewn(mesh.topology, left, renumbered, made.topology), chart=chart)


def joined_at_cuts(rings, untouched, united, cuts):
    """The mesh of what was united between cuts and of all segments that were not.

    Parameters
    ----------
    rings : Rings
    untouched : (segments,) bool array
        Those that were not united, counted as the rings are.
    united : United
    cuts : sequence of Cut
        The faces across, to be left out, at which the two are joined.

    Returns
    -------
    Mesh or None
        None where a cut did not come back as it was.
    """
    mesh = rings.mesh
    number = len(mesh.vertices) + np.arange(len(united.vertices))  # those of the mesh come first
    for cut in cuts:
        here = np.unique(united.triangles[united.faces == cut.number])
        ring = np.unique(rings.vertices([cut.ring]))
        which = equal_rows(united.vertices[here], mesh.vertices[ring])
        if len(here) != len(ring) or (which < 0).any():
            return None
        number[here] = ring[which]
    united = united.only(~np.isin(united.faces, [cut.number for cut in cuts]))
    united = replace(united, faces=np.where(united.faces < len(mesh.offsets) - 1, united.faces, -1))
    some = np.unique(rings.vertices(around(rings, untouched)))
    return assembled(rings, untouched_faces(rings, untouched), some, united, number)


def joined_at_rims(wedges, united):
    """The mesh of united wedges and of all faces that are in none.

    Parameters
    ----------
    wedges : Wedges
    united : United

    Returns
    -------
    Mesh or None
        None where a wall or a fan did not come back as it was.
    """
    mesh, rings = wedges.rings.mesh, wedges.rings
    closing = united.faces >= wedges.first_wall
    if not np.array_equal(np.sort(united.faces[closing]), wedges.closers):
        return None
    here = np.unique(united.triangles[closing])
    places = np.concatenate((mesh.vertices, rings.centres))
    which = equal_rows(united.vertices[here], places)
    if (which < 0).any():
        return None
    number = len(mesh.vertices) + np.arange(len(united.vertices))
    rim = which < len(mesh.vertices)
    number[here[rim]] = which[rim]
    faces = np.full(len(mesh.offsets) - 1, False)
    faces[rings.faces[wedges.strips]] = True
    some = np.unique(mesh.corners[corners_of(mesh.offsets, np.flatnonzero(faces))])
    return assembled(rings, np.flatnonzero(~faces), some, united.only(~closing), number)


def around(rings, untouched):
    """The rings that were united."""
    segments = np.flatnonzero(~untouched)
    return np.union1d(segments, segments + 1)


def untouched_faces(rings, untouched):
    """The faces of the mesh that were not united: those between rings, and caps beside them."""
    segments = np.flatnonzero(untouched)
    faces = [rings.faces_between(segments).ravel()]
    if not rings.closed:
        sides, first, last = rings.sides, rings.first_cap, len(rings.mesh.offsets) - 1
        faces += [np.arange(sides, sides + first)] if untouched[0] else []
        faces += [np.arange(sides + first, last)] if untouched[-1] else []
    return np.sort(np.concatenate(faces))


def likened(mesh, some, united):
    """The vertex of the mesh, one of some, that each of the united is, or is near: (n,) int array."""
    like = equal_rows(united.vertices, mesh.vertices[some])
    like = np.where(like < 0, like, some[like])
    of_face = np.flatnonzero(united.faces >= 0)
    new = united.triangles[of_face]
    at, corner = np.nonzero(like[new] < 0)
    vertex = new[at, corner]
    like[vertex] = mesh.corners[nearest_corner(mesh, united.faces[of_face[at]], united.vertices[vertex])]
    spread(like, united.triangles)
    return like.clip(0)


def spread(like, triangles):
    """Give those that are like none, where hulls cross each other, what a neighbour is like: in place."""
    while True:
        found = like[triangles]
        partly = (found < 0).any(axis=1) & (found >= 0).any(axis=1)
        if not partly.any():
            return
        some = found[partly]
        like[triangles[partly]] = np.where(some < 0, some.max(axis=1, keepdims=True), some)


def nearest_corner(mesh, faces, points):
    """Of faces (k,) the corner that is nearest to points (k, 3), looked for among the first four: (k,) int array."""
    first, size = mesh.offsets[faces], np.diff(mesh.offsets)[faces]
    corners = first[:, None] + np.arange(4) % size[:, None]
    return corners[np.arange(len(faces)), norms(mesh.vertices[mesh.corners[corners]] - points[:, None]).argmin(axis=1)]


def keep_sharpness(topology, before, corners):
    """Leave edges between faces that nothing has cut as sharp as they were; those faces come first.

    Parameters
    ----------
    topology : Topology
        Its ``sharp`` is set.
    before : Topology
    corners : (c,) int array
        The corner there that each of the first corners was.
    """
    edges = topology.corner_edges[: len(corners)]
    uses = np.bincount(edges, minlength=len(topology.edges))
    was = np.bincount(edges, before.sharp[before.corner_edges[corners]], len(topology.edges)) > 0
    topology.sharp[:] = np.where(uses == 2, was, topology.sharp | was)


def cut_corners(mesh, rest, like):
    """The corner of the mesh that each corner of triangles is near: (3 t,) int array."""
    corners = np.empty(len(mesh.vertices), int)
    corners[mesh.corners] = np.arange(len(mesh.corners))
    found = corners[like[rest.triangles]]
    known = np.flatnonzero(rest.faces >= 0)
    faces = np.repeat(rest.faces[known], 3)
    found[known] = nearest_corner(mesh, faces, rest.vertices[rest.triangles[known].ravel()]).reshape(-1, 3)
    return found.ravel()
