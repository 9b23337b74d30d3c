# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Legs: the stretches of a sweep between breaks, each a body that the planes of its mitres cut off."""

import numpy as np

from ..declared.frozen import individual
from ..later import later
from ..meshes.booleans import body_of, united
from ..meshes.polyhedron import polyhedron
from ..vectors import dot
from .tidying import tidied_arrays

resolved = later("core.resolving.resolve", "resolved")  # which unites legs
solid_of_rings = later("core.resolving.of_rings", "solid_of_rings")  # which takes sweeps apart itself

OVERLAP = 4.0  # steps of single precision: how far a leg goes on beyond its mitre, so that it meets the next


def divided(rings, first, last):
    """The legs of a stretch of rings that folds; there are none where no break is in it.

    Both ends of the stretch are a segment farther out, if there is one.

    Yields
    ------
    first, last : int
        The rings of a leg.
    breaks : (Break or None, Break or None)
        At which it begins and ends.
    """
    count, begun, whole = rings.grid.rings, None, rings.closed and last - first >= rings.segments
    if not rings.breaks:
        return
    if whole:
        begun, *others = rings.breaks
        first, stops = begun.after, [(each, 0) for each in others] + [(begun, count)]
    else:
        first, last = rings.longer(first, last)
        laps = (-count, 0, count) if rings.closed else (0,)
        stops = [(each, lap) for lap in laps for each in rings.breaks]
        stops = [(each, lap) for each, lap in stops if first <= each.before + lap and each.after + lap <= last]
    for each, lap in stops:
        if each.before + lap > first:
            yield first, each.before + lap, (begun, each)
        first, begun = each.after + lap, each
    if begun and not whole and first < last:
        yield first, last, (begun, None)


def of_leg(rings, first, last, breaks):
    """The bodies of what the contours visit between two rings, a little beyond those at breaks.

    Rings that reach through the plane of a mitre are put across the trajectory again if they lean, the leg goes on
    straight from the corner to that plane, and is cut off there: beyond it is the other leg. Only these rings are cut
    off, for farther along the leg may pass that plane.
    """
    places, offsets = rings.standing(np.arange(first, last + 1)), rings.grid.offsets
    start, end = (Stop.of(rings, places, each, side) for each, side in zip(breaks, (-1, 1), strict=True))
    places[: start.cuts] = upright(places[: start.cuts], start.standing)
    backward = places[::-1]
    backward[: end.cuts] = upright(backward[: end.cuts], end.standing)
    low, high = start.cuts, len(places) - 1 - end.cuts
    if low + 1 >= high:
        return [cut_off(places, start, end, offsets)]
    parts = [cut_off(places[low : high + 1], NONE if low else start, NONE if end.cuts else end, offsets)]
    if low:
        parts.append(cut_off(places[: low + 2], start, NONE, offsets))
    if end.cuts:
        parts.append(cut_off(places[high - 1 :], NONE, end, offsets))
    return parts


def together(meshes, progress=None):
    """What is in any of some legs, each of which may meet itself: a `Mesh`."""
    meshes = list(meshes)
    bodies = []
    for number, mesh in enumerate(meshes, 1):
        bodies.append(body_of(resolved(mesh)))
        if progress:
            progress(number / (len(meshes) + 1))
    told = dict.fromkeys(sentence for mesh in meshes for sentence in mesh.told)
    return polyhedron(*tidied_arrays(united(bodies)), told=tuple(told))


@individual
class Stop:
    """How a leg ends.

    Parameters
    ----------
    outward : (3,) float array
        Across the plane that it ends in.
    height : float
        How far this is from the origin, in metres.
    way : (3,) float array or None
        In which direction it goes on to there; None where it does not.
    standing : (k, 2, 3) float array
        Of the rings that are cut off, from the last on, the places on the trajectory and its tangents.
    """

    outward: np.ndarray
    height: float
    way: np.ndarray
    standing: np.ndarray

    @property
    def cuts(self):
        """How many rings are cut off."""
        return len(self.standing)

    @classmethod
    def of(cls, rings, places, each, side):
        """That of a leg with rings in these places at a break, on this side of the leg."""
        if not each:
            return NONE
        count = rings.grid.rings
        here, there = (each.before, each.after) if side > 0 else (each.after, each.before)
        outward, point = side * rings.normals[here % count], rings.centres[there % count]
        standing = (each.behind if side > 0 else each.ahead)[: len(places) - 1]  # the other end leans as it is cut off
        way = side * standing[0, 1] if len(standing) else outward
        over = 0.0
        if here == there or each.plane is not None:
            outward, point = (outward, point) if each.plane is None else (side * each.plane[1], each.plane[0])
            over = OVERLAP * float(np.spacing(np.float32(np.abs(places).max())))
        return cls(outward, float(outward @ point) + over, way, standing)


NONE = Stop(np.zeros(3), 0.0, None, np.zeros((0, 2, 3)))


def upright(places, standing):
    """Rings (k, m, 3) moved along the trajectory into the planes across it, where they stand."""
    point, tangent = standing.swapaxes(0, 1)[:, :, None]
    return places - dot(places - point, tangent)[..., None] * tangent


def cut_off(places, start, end, offsets):
    """The body of what contours visit from ring to ring, (n, m, 3), and on between two stops, which cut it off."""
    for stop, at in ((start, 0), (end, len(places))):
        if stop.way is not None:
            last = places[min(at, len(places) - 1)]
            far = ((stop.height - last @ stop.outward) / (stop.way @ stop.outward)).max()
            places = np.insert(places, at, last + far * stop.way, axis=0)
    made = body_of(solid_of_rings(places, offsets=offsets))
    for stop in (start, end):
        if stop.cuts:
            made = made.trim_by_plane((-stop.outward).tolist(), -stop.height)
    return made
