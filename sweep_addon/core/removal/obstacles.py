# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What forbids any path at once: a part that stands in another one, or that a closed surface encloses."""

from operator import itemgetter

import numpy as np

from ..declared.parameters import ShapeError
from ..offsets.parts import winding
from .legs import START
from .lengths import in_units, place
from .slipping import sampled


def refuse_overlap(scene, name="the part"):
    """Refuse a part that is deeper in another one than the tolerance as it stands; the sentence has its name."""
    crossed = scene.around.touching(scene.moving.at(START))
    for number, other in enumerate(scene.others):
        if number in crossed or contains(other, scene.core) or contains(scene.core, other):
            raise ShapeError(overlap(scene, other, name), other.name)


def overlap(scene, other, name):
    """How deep a part is in another one, and where, as the sentence of a refusal.

    One that is less deep than the tolerance is refused too where its edges are so sharp that it is drawn in by less.
    """
    depth, where = max(deepest(scene.part, other), deepest(other, scene.part), key=itemgetter(0))
    told = f"overlaps {name} by {in_units(max(depth, 0.0))} as it stands, at {place(where + scene.origin)}"
    most = f"the tolerance of {in_units(scene.tolerance)} would do"
    if depth > scene.tolerance:
        return f"{told}, and at most {most}"
    return f"{told}, where it is so sharp or thin that only less than {most}"


def deepest(body, other):
    """How deep places of a body's surface are in another one at most, or its middle in both, and where, in metres."""
    places, middle = np.concatenate((body.vertices, sampled(body)[0])), body.middle
    depths = other.depths(places)
    # surfaces may lie on each other
    amid = min(float(body.depths(middle[None])[0]), float(other.depths(middle[None])[0]))
    worst = int(depths.argmax())
    return (amid, middle) if amid > depths[worst] else (float(depths[worst]), places[worst])


def contains(body, other):
    """Whether a body holds a surface of another one that it does not cross; what is inside out holds nothing."""
    points = other.vertices[np.unique(other.shells)]
    return any(winding(body.corners - point) > 0.5 for point in points)


def seal(scene):
    """Why the part never gets out, for people, where a closed surface parts it from outside; None where none does.

    A surface that is closed and connected parts space in two, and one of both would have to cross it.
    """
    for other in scene.others:
        if encloses(other, scene.core):
            return f"{other.name} encloses the part"
        if encloses(scene.core, other):
            return f"the part encloses {other.name}"
    return None


def encloses(body, other):
    """Whether a surface of a body lies around another one, none of whose surfaces it crosses."""
    place, shells = other.vertices[:1], np.unique(body.shells)
    return any(body.shell(first).depths(place)[0] > 0 for first in shells.tolist())
