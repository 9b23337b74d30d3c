# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A turtle that reads a word from left to right with a stack: what the one by arrays is compared with.

It turns the vectors H, L and U as the book says: + left, - right, & down, ^ up, \\ and / roll left and right, | about,
$ and @v roll until L is level; after each segment it bends towards the tropism by e |H x T|.
"""

import numpy as np

TURNS = {"+": ("HL", 1), "-": ("HL", -1), "&": ("HU", -1), "^": ("HU", 1), "\\": ("LU", -1), "/": ("LU", 1)}
UP = np.array([0.0, 0.0, 1.0])
ALMOST = 1e-12  # of the sine between heading and up, below which $ does nothing


def turned(axes, plane, angle):
    """The axes with the first of a plane turned towards the second."""
    a, b = axes[plane[0]], axes[plane[1]]
    cos, sin = np.cos(angle), np.sin(angle)
    return axes | {plane[0]: cos * a + sin * b, plane[1]: cos * b - sin * a}


def level(axes):
    side = np.cross(UP, axes["H"])
    size = np.linalg.norm(side)
    if size < ALMOST:
        return axes, 1.0
    return axes | {"L": side / size, "U": np.cross(axes["H"], side / size)}, size


def bent(axes, tropism):
    direction, e = np.array(tropism[:3]) / np.linalg.norm(tropism[:3]), tropism[3]
    axis = np.cross(axes["H"], direction)
    size = np.linalg.norm(axis)
    if size == 0:
        return axes
    axis, angle = axis / size, e * size
    cos, sin = np.cos(angle), np.sin(angle)
    return {n: cos * v + sin * np.cross(axis, v) + (1 - cos) * (axis @ v) * axis for n, v in axes.items()}


def walk(modules, axes, angle=90.0, step=1.0, width=0.1, tropism=None, asked=None):
    """Walk a word, given as (name, parameters); where queries stand, note their places and states in a list.

    Returns
    -------
    list of dict
        For each segment: start, end, axes, width, colour, place in the word, and the product of the sines that each $
        on its path divides errors by.
    numpy array
        Where the turtle is at the end.
    """
    state = {"at": np.zeros(3), "axes": axes, "width": width, "colour": 0.0, "loss": 1.0}
    stack, segments = [], []
    for place, (name, parameters) in enumerate(modules):
        first = parameters[0] if parameters else None
        if name in TURNS:
            plane, sign = TURNS[name]
            state["axes"] = turned(state["axes"], plane, sign * np.radians(angle if first is None else first))
        elif name == "|":
            state["axes"] = turned(state["axes"], "HL", np.pi)
        elif name in ("$", "@v"):
            state["axes"], size = level(state["axes"])
            state["loss"] *= size
        elif name == "!":
            state["width"] = state["width"] * 0.5**0.5 if first is None else first
        elif name == "'":
            state["colour"] = state["colour"] + 1 if first is None else first
        elif name in ("F", "G", "f"):
            end = state["at"] + (step if first is None else first) * state["axes"]["H"]
            if name != "f":
                segments.append({**state, "start": state["at"], "end": end, "place": place})
            state["at"] = end
            if tropism and name != "f":
                state["axes"] = bent(state["axes"], tropism)
        elif name[0] == "?" and asked is not None:
            asked.append((place, state["at"], state["axes"]))
        elif name == "[":
            stack.append(dict(state))
        elif name == "]":
            state = stack.pop()
    return segments, state["at"]


def left_beside(modules, segments_of):
    """What a turtle leaves beside its segments: polygons in the order in which they end, and organs.

    Parameters
    ----------
    modules : list of (name, parameters)
    segments_of : callable
        Walks a word, as `walk`: where the turtle is at a place is where it is at the end of the word up to there.

    Returns
    -------
    list of list of (3,) float array
    list of (name, position, scale)
    """
    open_, polygons, organs = [], [], []
    for place, (name, parameters) in enumerate(modules):
        at = segments_of(modules[: place + 1])[1]
        if name == "{":
            open_.append([at])
        elif name == "}" and open_:
            corners = open_.pop()
            distinct = [b for a, b in zip([corners[-1], *corners[:-1]], corners, strict=True) if (a != b).any()]
            polygons += [distinct] if len(distinct) > 2 else []
        elif name in ("F", "f", ".") and open_:
            open_[-1].append(at)
        if place and modules[place - 1][0] == "~":
            organs.append((name, at, parameters[0] if parameters else 1.0))
    return polygons, organs
