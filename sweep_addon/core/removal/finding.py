# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Finding a removal path: the simplest motions first, and nothing is returned that has no certificate."""

from numbers import Integral, Real

import numpy as np

from ..declared.parameters import require
from ..progress import unheard, within
from .bodies import assembly, taken
from .directions import candidates
from .legs import START, Pose
from .lengths import in_units
from .moves import Scene
from .obstacles import refuse_overlap, seal
from .path import RemovalPath
from .several import chains
from .slipping import NEAR, Contacts
from .straight import ways_out
from .trees import grown, shortened

RELATIVE, LARGEST = 1e-3, 0.1  # of the size of the part: the tolerance where none is given, and the largest
BUDGET = 200_000  # poses that are tried
AGAIN = 20_000  # after which trees begin anew: most that arrive do so soon


def removal_path(part, others, tolerance=None, distance=None, seed=0, budget=BUDGET, progress=None):
    """Find a path on which a part gets out of an assembly, and prove that it touches nothing on it.

    Straight ways are tried first, in directions that the forms and the contacts of the parts tell; then two and more
    translations and screws, as far as something opens; and then random poses.

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
    seed : int
        Of the random poses.
    budget : int
        So many poses are tried where straight ways are blocked, ten thousand or more in a second.
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
    require_distance(distance)
    require_whole(seed, "seed")
    require_whole(budget, "budget")
    refuse_overlap(scene)
    why = seal(scene)
    if why:
        return none(scene, f"None: {why}", sealed=True)
    progress(0.0)
    return straight_out(scene, distance) or any_way_out(scene, distance, seed, budget, progress)


def any_way_out(scene, distance, seed, budget, progress):
    """The path of several legs that is found first, or what was tried."""
    half = budget // 2
    return by_motions(scene, distance, half, within(progress, 0.0, 0.5)) or by_chance(
        scene, seed, budget - half, within(progress, 0.5, 1.0)
    )


def straight_out(scene, distance=None):
    """The path of one straight leg, if there is one with a certificate."""
    for leg in ways_out(scene, directions_of(scene), START, distance):
        path = proven(scene, (leg,))
        if path:
            return path
    return None


def by_motions(scene, distance, budget, progress):
    """The path of a few translations and screws, if one is found that has a certificate."""
    for legs in chains(scene, distance, budget, progress):
        path = proven(scene, legs)
        if path:
            return path
    return None


def by_chance(scene, seed, budget, progress):
    """The path that random trees find, if there is a certificate for it, or what was tried."""
    directions, first = directions_of(scene), scene.asked
    while (left := budget - (scene.asked - first)) > 0:
        done = 1 - left / budget
        tries = min(left, AGAIN)
        legs = grown(scene, directions, seed, tries, within(progress, done, done + tries / budget))
        path = legs and proven(scene, shortened(scene, legs, seed))
        if path:
            return path
        seed += 1
    return none(scene, told_of(len(directions), scene.asked))


def told_of(directions, poses):
    """What was tried in vain, for people."""
    tried = "chains of translations and screws and random motions led nowhere"
    return f"None found: {directions} straight ways are blocked, and {tried}, of which {poses:,} poses were tried"


def directions_of(scene):
    """The directions in which the part may get out from where it stands."""
    touching = Contacts.of(scene.part, scene.others, NEAR * scene.tolerance)
    return candidates(scene.part, scene.others, touching)


def proven(scene, legs):
    """The path of some legs, or None: with a certificate of the part as it is, or with the contact tolerance."""
    tolerance, least = 0.0, scene.exact.certified(legs)
    if least <= 0:
        tolerance, least = scene.tolerance, scene.certified(legs)
    if least <= 0:
        return None
    back = Pose(np.eye(3), scene.origin)
    return RemovalPath(assembled(scene), tuple(leg.seen(back) for leg in legs), tolerance, least, described(legs))


def described(legs):
    """Legs in words."""
    if len(legs) == 1 and not legs[0].turns:
        return f"A straight way of {in_units(np.linalg.norm(legs[0].way))}"
    return ", then ".join(map(in_words, legs)).capitalize()


def in_words(leg):
    """What happens on a leg."""
    way, degrees = float(np.linalg.norm(leg.way)), np.degrees(leg.angle)
    if not leg.turns:
        return f"{in_units(way)} straight"
    turned = f"{degrees / 360:.3g} turns" if degrees > 360 else f"{degrees:.3g} degrees"
    return f"a turn of {turned}" + (f" with {in_units(way)}" if way else "")


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
    middle = part.middle
    part = part.about(middle)
    return scene_among(part, [part, *(other.about(middle) for other in others)], middle, tolerance)


def scene_among(part, bodies, origin, tolerance):
    """The `Scene` of one of some bodies that are seen from an origin (3,), the others around it."""
    others = [body for body in bodies if body is not part]
    return Scene(part, others, within_limits(tolerance, part.size), origin)


def within_limits(tolerance, size):
    """A contact tolerance in metres, or a refusal."""
    if tolerance is None:
        return RELATIVE * size
    number = isinstance(tolerance, Real) and not isinstance(tolerance, bool)
    require(number and tolerance > 0, "must be a number of metres, more than 0", tolerance, "tolerance")
    most = LARGEST * size
    require(tolerance <= most, f"must be at most {most:.3g}, a tenth of the part's size", tolerance, "tolerance")
    return float(tolerance)


def require_distance(distance):
    """Refuse a distance that is no length."""
    number = isinstance(distance, Real) and not isinstance(distance, bool) and np.isfinite(distance)
    fits = distance is None or number and distance > 0
    require(fits, "must be a number of metres, more than 0", distance, "distance")


def require_whole(value, key):
    """Refuse what is no whole number from 0 on."""
    whole = isinstance(value, Integral) and not isinstance(value, bool) and value >= 0
    require(whole, "must be a whole number, 0 or more", value, key)
