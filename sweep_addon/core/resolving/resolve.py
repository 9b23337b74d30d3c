# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resolving: of a sweep that may meet itself, the boundary of all points visited."""

import numpy as np

from ..declared.parameters import ShapeError, require
from ..meshes.booleans import arrays, united
from ..vectors import dot, unit
from . import OPEN
from .assembling import United, joined_at_cuts, joined_at_rims
from .conflicts import chunks
from .filling import Fillings
from .pieces import Pieces
from .plan import planned
from .rings import Rings
from .sectors import sectors
from .shells import without_specks
from .tidying import tidied
from .wedges import Wedges

ROUNDING = 1e-9  # of the largest contour: near a tip turns are no more than noise
GROUP = 8  # bodies that are united between two reports of progress: more are no quicker


def resolved(mesh, progress=None, meets=None, breaks=()):
    """Of a mesh on a grid that may meet itself, the boundary of the set of all points visited.

    Parameters
    ----------
    mesh : Mesh
        Of a closed contour, its chart with a grid that has no poles, its ends closed.
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.
    meets : callable, optional
        Tells whether the sweep meets itself, and is asked where contours hardly move: on the inner side of a bevel too.
    breaks : tuple of Break, optional
        Where the sweep is two: the end of one leg and the start of the next.

    Returns
    -------
    Mesh
        Closed and manifold. Faces that nothing has cut are as they were; where nothing meets, it is the same mesh.

    Raises
    ------
    ShapeError
        For an open surface, one whose contour turns too much from ring to ring, or where manifold3d is missing.
    """
    progress = progress or (lambda part: None)
    rings = Rings(closed(mesh), breaks)
    require_turning_little(rings)
    found = chunks(rings)
    plan = planned(found, rings.closed)
    if plan.untouched.all() or (plan.folds and meets and not (breaks or meets())):
        return mesh
    strips = sectors(rings, plan, found)
    made = None if strips is None else of_sectors(Wedges(rings, plan, strips), progress)
    if made is None:
        made = of_plan(rings, plan, progress)
    if made is None:  # something has come near after all
        made = of_plan(rings, planned(found, rings.closed, everything=True), progress)
    return made


def of_sectors(wedges, progress):
    """The mesh of the sectors of tubes; None where what closes them did not come back as it was."""
    return joined_at_rims(wedges, tidily_united(wedges, lambda: wedges.closers, progress))


def of_plan(rings, plan, progress):
    """The mesh of the parts of a plan; None where a cut did not come back as it was."""
    pieces = Pieces(rings, plan, Fillings(rings))
    united = tidily_united(pieces, lambda: [cut.number for cut in pieces.cuts], progress)
    return joined_at_cuts(rings, plan.untouched, united, pieces.cuts)


def tidily_united(pieces, cuts, progress):
    """What comes of uniting all pieces, without specks and slivers; cuts tell which faces are to stay as they are."""
    body = step_by_step(pieces, progress)
    vertices, triangles, faces = arrays(body)
    if len(body.decompose()) > 1:
        large = without_specks(vertices, triangles)
        triangles, faces = triangles[large], faces[large]
    return United(*tidied(vertices, triangles, faces, cuts()))


def step_by_step(pieces, progress):
    """The body of all pieces; neighbours are united first, and every few of them progress is told."""
    done, group, count = [], [], len(pieces)  # which takes as long as finding them
    for number, bodies in enumerate(pieces, 1):
        group += bodies
        if len(group) >= GROUP or number == count:
            done.append(united(group))
            done[-1].status()  # or it would wait until all of them are asked for
            group = []
            progress(number / (count + 1))
    return united(done)


def closed(mesh):
    """The mesh, refused if its surface is not closed, or is none."""
    uses = np.bincount(mesh.topology.corner_edges, minlength=len(mesh.topology.edges))
    points = np.bincount(mesh.corners, minlength=len(mesh.vertices))
    if not (len(uses) and (uses == 2).all() and points.all()):
        raise ShapeError(OPEN)
    return mesh


def require_turning_little(rings):
    """Refuse contours that turn by more than a right angle from one ring to the next: faces there cross each other."""
    along = unit(np.diff(rings.centres, axis=0))  # mitres lean, but not as their leg sees them
    aside = rings.points - rings.centres
    here, ahead = (part - dot(part, along)[..., None] * along for part in (aside[:, :-1], aside[:, 1:]))
    little = dot(here, ahead).sum(axis=0) >= -ROUNDING * rings.radii.max() ** 2
    little[[each.before for each in rings.breaks if 0 <= each.before < each.after]] = True
    require(little.all(), "must be more: the contour turns by more than a right angle between two of them",
            rings.grid.rings, "samples")  # fmt: skip
