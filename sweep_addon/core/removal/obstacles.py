# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What forbids any path at once: a part that stands in another one, or that a closed surface encloses."""

import numpy as np

from ..declared.parameters import ShapeError
from .legs import START
from .slipping import sampled


def refuse_overlap(scene):
    """Refuse a part that is deeper in another one than the tolerance as it stands, with how deep and in which."""
    crossed = scene.around.touching(scene.moving.at(START))
    for number, other in enumerate(scene.others):
        if number in crossed or contains(other, scene.core) or contains(scene.core, other):
            depth = max(deepest(scene.part, other), deepest(other, scene.part))
            told = f"by {depth:.3g} m" if depth > scene.tolerance else "where their edges cross"
            raise ShapeError(
                f"overlaps the part {told} as it stands, and at most the tolerance of {scene.tolerance:.3g} m would do",
                other.name,
            )


def deepest(body, other):
    """How deep places of a body's surface are in another one at most, or its middle in both, in metres."""
    places, middle = np.concatenate((body.vertices, sampled(body)[0])), body.middle[None]
    amid = min(float(body.depths(middle)[0]), float(other.depths(middle)[0]))  # surfaces may lie on each other
    return max(float(other.depths(places).max()), amid)


def contains(body, other):
    """Whether a body holds a surface of another one that it does not cross."""
    points = other.vertices[np.unique(other.shells)]
    return bool((body.depths(points) > 0).any())


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
