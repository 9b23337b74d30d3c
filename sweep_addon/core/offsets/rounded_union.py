# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is within a radius of a surface, as a union: of the hull of each flat face and a ball around it."""

import numpy as np

from ..declared.frozen import individual
from ..meshes.booleans import arrays, body, hull_body, library, united
from ..meshes.components import components
from ..progress import unheard
from ..vectors import dot, norms, unit
from .convex import shared_edges
from .sphere import globe

GROUP = 16  # bodies that are united between two reports of progress
UNITED = 0.75  # of the work: the groups; the rest is to unite these
FLAT = 1e-9  # of a unit normal: faces that differ by less are one
KEPT = {}  # what was united last, by what it was made from: of all sides of an offset it is the same


@individual
class Rounded:
    """What is within a radius of a surface.

    Parameters
    ----------
    body : manifold3d.Manifold
    pieces : int
        Of how many hulls it is the union.
    inscribed : float
        The radius of the largest ball in the ball of facets that was used, as a part of its own.
    """

    body: object
    pieces: int
    inscribed: float


def rounded(vertices, triangles, radius, sides, progress=unheard):
    """All that is within a radius of a surface of triangles.

    Parameters
    ----------
    vertices : (n, 3) float array
        In metres.
    triangles : (f, 3) int array
    radius : float
        In metres.
    sides : int
        Meridians of the ball, a multiple of four.
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    Rounded

    A face moves by the whole radius however coarse the ball is: its own corners moved along its normal are in its hull.
    """
    question = vertices.tobytes(), triangles.tobytes(), radius, sides
    found = KEPT.get(question)
    if found is None:
        found = hulls_united(vertices, triangles, radius, sides, progress)
        KEPT.clear()
        KEPT[question] = found
    progress(1.0)
    return found


def hulls_united(vertices, triangles, radius, sides, progress):
    """What `rounded` says, made anew."""
    ball = globe(sides)
    facets = hull_body(ball)
    corners, faces, _ = arrays(facets)
    planes = unit(np.cross(*(corners[faces[:, i]] - corners[faces[:, 0]] for i in (1, 2))))
    inscribed = float(dot(planes, corners[faces[:, 0]]).min())
    flat, done, group = list(flat_faces(vertices, triangles)), [], []
    for number, (normal, polygon) in enumerate(flat, 1):
        moved = np.concatenate((radius * ball, [radius * normal, -radius * normal]))
        group.append(hull_body((vertices[polygon][:, None] + moved).reshape(-1, 3)))
        if len(group) == GROUP or number == len(flat):
            done.append(united(group))
            done[-1].status()  # or it would wait until all of them are asked for
            group = []
            progress(UNITED * number / len(flat))
    whole = united(done)
    whole.status()
    return Rounded(whole, len(flat), inscribed)


def flat_faces(vertices, triangles):
    """Yield the normal and the vertices of each flat face: triangles in a plane that are convex together, or one."""
    normals, group = coplanar(vertices, triangles)
    order = np.argsort(group, kind="stable")
    for members in np.split(order, np.flatnonzero(np.diff(group[order])) + 1):
        normal = normals[members[0]]
        if len(members) == 1 or turns_left(vertices, triangles[members], normal):
            yield normal, np.unique(triangles[members])
        else:
            yield from ((normal, triangle) for triangle in triangles[members])


def few_faces(vertices, triangles, most):
    """Whether a solid has at most so many flat faces."""
    _, group = coplanar(vertices, triangles)
    if len(np.unique(group)) > most:
        return False
    return sum(1 for _ in flat_faces(vertices, triangles)) <= most


def coplanar(vertices, triangles):
    """The normals of triangles, (f, 3), and the same number for those that lie in a plane and hang together, (f,)."""
    corners = vertices[triangles]
    normals = unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
    edges = shared_edges(triangles)
    left, right = edges[:, 2:].T
    opposite = vertices[triangles[right].sum(axis=1) - edges[:, 0] - edges[:, 1]]
    height = np.abs(dot(opposite - vertices[edges[:, 0]], normals[left]))
    flat = (norms(normals[left] - normals[right]) <= FLAT) & (height <= FLAT * np.ptp(vertices, axis=0).max())
    return normals, components(len(triangles), edges[flat, 2:])


def turns_left(vertices, triangles, normal):
    """Whether triangles in a plane are convex together: none of their corners is right of an edge of one alone."""
    start, end = triangles.ravel(), np.roll(triangles, -1, axis=1).ravel()
    size = int(triangles.max()) + 1
    outer = ~np.isin(start * size + end, end * size + start)
    a, b = vertices[start[outer]], vertices[end[outer]]
    across = np.cross(normal, b - a)
    corners = vertices[np.unique(triangles)]
    height = (corners[None] - a[:, None]) @ across[:, :, None]
    return bool((height >= -FLAT * norms(across)[:, None, None] * np.ptp(corners, axis=0).max()).all())


def offset_bodies(vertices, triangles, rounded):
    """A solid with what is within a radius of its surface, and without it."""
    manifold3d = library()
    solid = body(vertices, triangles)
    both = [solid, rounded]
    return (manifold3d.Manifold.batch_boolean(both, how) for how in (manifold3d.OpType.Add, manifold3d.OpType.Subtract))
