# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges that know nothing of sweeps: all pairs of triangles of a mesh, counted volume, distances from triangles."""

import numpy as np


def triangles(mesh):
    """The faces of a mesh as fans of triangles: (t, 3) vertices and (t,) faces."""
    sizes = np.diff(mesh.offsets)
    corners, faces = [], []
    for size in np.unique(sizes):
        which = np.flatnonzero(sizes == size)
        polygon = mesh.corners[mesh.offsets[which][:, None] + np.arange(size)]
        for k in range(1, size - 1):
            corners.append(polygon[:, [0, k, k + 1]])
            faces.append(which)
    return np.concatenate(corners), np.concatenate(faces)


def crossing_faces(mesh, least=1e-9):
    """Faces that go through others with which they share no vertex: sorted (k,) int array.

    Source: Moeller, Trumbore: Fast, minimum storage ray/triangle intersection, J. Graphics Tools 2, 1997, of all edges
    and all triangles.
    """
    corners, faces = triangles(mesh)
    sides = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    owner = np.tile(faces, 3)
    a, b, c = (mesh.vertices[corners[:, k]] for k in range(3))
    found = set()
    for start in range(0, len(sides), 256):
        part = sides[start : start + 256]
        p, way = mesh.vertices[part[:, 0]], mesh.vertices[part[:, 1]] - mesh.vertices[part[:, 0]]
        h = np.cross(way[:, None], (c - a)[None])
        scale = np.einsum("tk,stk->st", b - a, h)
        with np.errstate(divide="ignore", invalid="ignore"):
            q = p[:, None] - a
            u = np.einsum("stk,stk->st", q, h) / scale
            r = np.cross(q, (b - a)[None])
            v = np.einsum("sk,stk->st", way, r) / scale
            t = np.einsum("tk,stk->st", c - a, r) / scale
            hit = np.abs(scale) > least * np.linalg.norm(h, axis=2) * np.linalg.norm(b - a, axis=1)  # not in its plane
            hit &= (u > least) & (v > least) & (u + v < 1 - least) & (t > least) & (t < 1 - least)
        hit &= ~(part[:, None, :, None] == corners[None, :, None, :]).any(axis=(2, 3))
        one, other = np.nonzero(hit)
        pairs = np.stack((owner[start + one], faces[other]), axis=1)
        alien = [not np.isin(polygon(mesh, i), polygon(mesh, j)).any() for i, j in pairs]
        found.update(pairs[alien].ravel().tolist())
    return np.array(sorted(found), dtype=int)


def polygon(mesh, face):
    return mesh.corners[mesh.offsets[face] : mesh.offsets[face + 1]]


def tube_volume(trajectory, radius, random, points=40_000, samples=1_000):
    """The volume of all points within a radius of a closed trajectory, and its standard error, by counting."""
    u = np.linspace(*trajectory.domain, samples, endpoint=False)
    path = trajectory.evaluate(u)
    low, high = path.min(axis=0) - radius, path.max(axis=0) + radius
    places, inside = random.uniform(low, high, (points, 3)), 0
    for start in range(0, points, 4_000):
        part = places[start : start + 4_000]
        squared = (part**2).sum(axis=1)[:, None] - 2 * part @ path.T + (path**2).sum(axis=1)
        inside += np.count_nonzero(squared.min(axis=1) < radius**2)
    share, box = inside / points, np.prod(high - low)
    return box * share, box * np.sqrt(share * (1 - share) / points)


def distances(points, corners):
    """How far points (n, 3) are from the nearest of some triangles (f, 3, 3): above its middle, or beside an edge."""
    least = np.full(len(points), np.inf)
    for triangle in corners:
        start, sides = triangle[0], triangle[1:] - triangle[0]
        along = np.linalg.lstsq(sides.T, (points - start).T, rcond=None)[0]
        above = (along >= 0).all(axis=0) & (along.sum(axis=0) <= 1)
        height = np.linalg.norm(points - start - along.T @ sides, axis=1)
        least = np.where(above, np.minimum(least, height), least)
        for one, other in zip(triangle, np.roll(triangle, -1, axis=0), strict=True):
            share = ((points - one) @ (other - one) / ((other - one) @ (other - one))).clip(0, 1)
            least = np.minimum(least, np.linalg.norm(points - one - share[:, None] * (other - one), axis=1))
    return least
