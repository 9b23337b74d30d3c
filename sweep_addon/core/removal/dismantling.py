# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Taking an assembly apart: an order in which all parts get out one after the other, each on a path of its own."""

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import require
from ..progress import unheard, within
from .bodies import assembly
from .finding import BUDGET, any_way_out, directions_of, require_whole, scene_among, straight_out
from .obstacles import refuse_overlap


@individual
class Disassembly:
    """An order in which the parts of an assembly get out; it is true if all but the last one do.

    Parameters
    ----------
    order : tuple of (str, RemovalPath)
        The name of each part and its path, past those that are still there then; the last part stays.
    stays : tuple of str
        The names of the parts that are left: one, or those of which none was found to get out.
    blocking : dict of str to tuple of str
        For each part that did not get out straight at first, the names of those it then ran into.
    """

    order: tuple
    stays: tuple
    blocking: dict

    def __bool__(self):
        return len(self.stays) <= 1

    def __repr__(self):
        return f"Disassembly({len(self.order)} parts out, {len(self.stays)} left)"

    def __str__(self):
        names = ", ".join(name for name, _ in self.order) or "none"
        left = f"; no way out was found for any of {', '.join(self.stays)}" if len(self.stays) > 1 else ""
        return f"In this order: {names}{left}"


def disassembly(parts, tolerance=None, seed=0, budget=BUDGET, progress=None):
    """Find an order in which the parts of an assembly get out one after the other, each on a certified path.

    Of the parts that are still there those that get out straight are taken out first; where none does, those that do by
    translations and screws, or by chance.

    Parameters
    ----------
    parts : list or dict of Mesh, or of shapes, solids and trees
        A dictionary gives them names; those of a list are ``parts.1`` and so on.
    tolerance : float, optional
        The contact tolerance in metres, by default a thousandth of each part's size: see `removal_path`.
    seed, budget : int
        Of the random poses: see `removal_path`.
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    Disassembly

    Raises
    ------
    ShapeError
        For what is no closed mesh, for parts that are deeper in each other than the tolerance, and where python-fcl is
        missing.

    Source
    ------
    Wilson, Latombe: Geometric reasoning about mechanical assembly, Artificial Intelligence 71, 1994: which part blocks
    which one, and where nothing does.

    Examples
    --------
    >>> import sweep_addon as sw
    >>> Block = sw.solids.Block
    >>> box = Block(1, 1, 1) - Block(0.8, 0.8, 0.8).moved(z=0.1)
    >>> filling, lid = Block(0.8, 0.8, 0.7).moved(z=0.05), Block(0.8, 0.8, 0.1).moved(z=0.45)
    >>> taken = disassembly({"filling": filling, "lid": lid, "box": box})
    >>> print(taken)
    In this order: lid, filling
    >>> taken.blocking["filling"]
    ('lid', 'box')
    """
    progress = progress or unheard
    require_whole(seed, "seed")
    require_whole(budget, "budget")
    bodies = assembly(parts, "parts")
    require(len(bodies) > 1, "must have two parts or more", len(bodies), "parts")
    middle = np.mean([body.middle for body in bodies], axis=0)
    left = [body.about(middle) for body in bodies]
    order, blocking, waiting, count = [], {}, {}, len(left) - 1
    while len(left) > 1:
        found = straight_one(left, middle, tolerance, waiting)
        blocking = waiting | blocking  # what was noted first
        if not found:
            found = hard_one(left, middle, tolerance, seed, budget, within(progress, len(order) / count, 1.0))
        if not found:
            break
        part, path = found
        left.remove(part)
        order.append((part.name, path))
        progress(len(order) / count)
    return Disassembly(tuple(order), tuple(body.name for body in left), blocking)


def straight_one(left, middle, tolerance, waiting):
    """The first part that gets out straight and its path, or None.

    What those before it run into is noted in ``waiting``: they are not tried again while all of that is there.
    """
    there = {body.name for body in left}
    for part in left:
        first = part.name not in waiting
        if not first and there.issuperset(waiting[part.name]):
            continue
        scene = scene_among(part, left, middle, tolerance)
        if first:
            refuse_overlap(scene, part.name)
        path = straight_out(scene)
        if path:
            return part, path
        waiting[part.name] = scene.run_into(directions_of(scene))
    return None


def hard_one(left, middle, tolerance, seed, budget, progress):
    """The first part that gets out in several legs and its path, or None."""
    for number, part in enumerate(left):
        own = part.middle
        bodies = [body.about(own) for body in left]
        scene = scene_among(bodies[number], bodies, middle + own, tolerance)
        share = within(progress, number / len(left), (number + 1) / len(left))
        path = any_way_out(scene, None, seed, budget, share)
        if path:
            return part, path
    return None
