# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding a removal path: the simplest motions first, and nothing is returned that has no certificate."""

from numbers import Real

import numpy as np

from ..declared.parameters import require
from ..progress import unheard
from .bodies import assembly, taken
from .directions import candidates
from .legs import START, Pose
from .moves import Scene
from .obstacles import refuse_overlap, seal
from .path import RemovalPath
from .slipping import Contacts
from .straight import ways_out

RELATIVE, LARGEST = 1e-3, 0.1  # of the size of the part: the tolerance where none is given, and the largest
NEAR = 2  # tolerances: as near others touch the part


def removal_path(part, others, tolerance=None, distance=None, progress=None):
    """Find a path on which a part gets out of an assembly, and prove that it touches nothing on it.

    Straight ways are tried first, in directions that the forms and the contacts of the parts tell.

    Parameters
    ----------
    part : Mesh, or a shape, a solid or a tree
        What is to be removed.
    others : list or dict of the same
        What stays where it is; a dictionary gives them names.
    tolerance : float, optional
        The contact tolerance in metres: parts that touch each other are a little in each other after rounding, and a
        path on which none is deeper than this in another counts as free. By default a thousandth of the part's size.
    distance : float, optional
        How far the part goes on its last straight way, in metres; by default until a plane across the way lies between
        it and all others.
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    RemovalPath
        It is true if there is a path, and its text says how it was found or what was tried.

    Raises
    ------
    ShapeError
        For what is no closed mesh, for a part that stands in others deeper than the tolerance, and where python-fcl is
        missing.

    Source
    ------
    The lecture's "Maintainability check". Straight ways first: Aguinaga, Borro, Matey: Path-planning techniques for the
    simulation of disassembly tasks, 2007. What is certified, and how: docs/removal.md.

    Examples
    --------
    >>> import sweep_addon as sw
    >>> drawer, box = sw.solids.Block(0.4, 0.4, 0.2), sw.solids.Block(0.5, 0.5, 0.3) - sw.solids.Block(0.4, 0.6, 0.2)
    >>> print(removal_path(drawer, {"box": box}))
    A straight way of 0.451 m
    """
    progress = progress or unheard
    scene = scene_of(part, others, tolerance)
    checked_distance(distance)
    refuse_overlap(scene)
    enclosing = seal(scene)
    if enclosing:
        return none(scene, f"None: {enclosing.name} encloses the part", sealed=True)
    progress(0.05)
    contacts = Contacts.of(scene.part, scene.others, NEAR * scene.tolerance)
    directions = candidates(scene.part, scene.others, contacts)
    for leg in ways_out(scene, directions, START, distance):
        path = proven(scene, (leg,), f"A straight way of {np.linalg.norm(leg.way):.3g} m")
        if path:
            return path
    return none(scene, f"None found: {len(directions)} straight ways are blocked")


def proven(scene, legs, said):
    """The path of some legs, if there is a certificate for it: of the part as it is, or with the contact tolerance."""
    tolerance, least = 0.0, scene.exact().certified(legs)
    if least <= 0:
        tolerance, least = scene.tolerance, scene.certified(legs)
    if least <= 0:
        return none(scene, said)
    back = Pose(np.eye(3), scene.origin)
    return RemovalPath(assembled(scene), tuple(leg.seen(back) for leg in legs), tolerance, least, said)


def none(scene, said, sealed=False):
    """That there is no path, and why."""
    return RemovalPath(assembled(scene), (), said=said, sealed=sealed)


def assembled(scene):
    """The part where it stands in the assembly."""
    return scene.part.about(-scene.origin)


def scene_of(part, others, tolerance):
    """The `Scene` of what was given, about the middle of the part, or a refusal."""
    part, others = taken(part, "part"), assembly(others, "others")
    require(others, "must have at least one", 0, "others")
    tolerance = within_limits(tolerance, part.size)
    middle = part.middle
    return Scene(part.about(middle), [other.about(middle) for other in others], tolerance, middle)


def within_limits(tolerance, size):
    """A contact tolerance in metres, or a refusal."""
    if tolerance is None:
        return RELATIVE * size
    number = isinstance(tolerance, Real) and not isinstance(tolerance, bool)
    require(number and tolerance > 0, "must be a number of metres, more than 0", tolerance, "tolerance")
    most = LARGEST * size
    require(tolerance <= most, f"must be at most {most:.3g}, a tenth of the part's size", tolerance, "tolerance")
    return float(tolerance)


def checked_distance(distance):
    """Refuse a distance that is no length."""
    number = isinstance(distance, Real) and not isinstance(distance, bool) and np.isfinite(distance)
    fits = distance is None or number and distance > 0
    require(fits, "must be a number of metres, more than 0", distance, "distance")
