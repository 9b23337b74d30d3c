# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands beside segments in the mesh of a figure: a face of each polygon, and a point where each organ is."""

import numpy as np

from ...declared.digest import checksum
from ...meshes.mesh import Mesh, Topology, require_few
from ..drawing import turns

NONE = np.zeros(0, dtype=np.int32)
UNTURNED = (1.0, 0.0, 0.0, 0.0)
ALONG_Z = (0.5 + 0.5j, 0.5 + 0.5j)  # turns x to y, y to z and z to x: an organ lies along z, a turtle heads along x


class Held:
    """The chart of vertices that know a few values, and of what they are no part of, 0.

    Parameters
    ----------
    chart : object
        That of the segments, whose values these have too.
    vertices, corners : int
        How many there are.
    values : dict of str to (n,) array
    """

    rings = 0

    def __init__(self, chart, vertices, corners, values):
        self.chart, self.vertices, self.corners, self.values = chart, vertices, corners, values

    @property
    def keys(self):
        told = f"{self.corners}.{checksum(*self.values.values())}"
        return tuple(told if key else "" for key in self.chart.keys)

    def uv(self, dtype=np.float64, empty=np.empty):
        return None if self.chart.uv(dtype) is None else np.zeros((self.corners, 2), dtype)

    def along(self, dtype=np.float64, but=(), rooms=None):
        return {name: np.zeros(self.vertices, dtype) for name in self.chart.along(dtype, but)}

    def across(self, dtype=np.float64):
        none = np.zeros(self.vertices)
        known = {"rotation": np.tile(UNTURNED, (self.vertices, 1))} | self.values
        return {name: known.get(name, none).astype(dtype) for name in self.chart.across(dtype)}


class Numbered:
    """The chart of segments in a figure with organs, of which none is one."""

    def __init__(self, chart, vertices):
        self.chart, self.vertices = chart, vertices

    @property
    def keys(self):
        return self.chart.keys

    @property
    def rings(self):
        return self.chart.rings

    def uv(self, dtype=np.float64, empty=np.empty):
        return self.chart.uv(dtype, empty)

    def along(self, dtype=np.float64, but=(), rooms=None):
        return self.chart.along(dtype, but)

    def across(self, dtype=np.float64):
        found = self.chart.across(dtype)
        none = dict.fromkeys(("organ", "size"), np.zeros(self.vertices, dtype))
        return found | none | {"rotation": np.tile(UNTURNED, (self.vertices, 1)).astype(dtype)} if found else found


MOST_SLOTS, LEAF = 64, 2  # material slots: how many, by the number of the colour; that of polygons without a colour


def slots(colour):
    """(n,) int32 array: the material slot of each colour, which is its number."""
    return np.clip(np.rint(colour), 0, MOST_SLOTS - 1).astype(np.int32)


def polygons(figure, chart, dtype):
    """A mesh of the polygons of a figure, each a face of its own; its chart is like that of the segments."""
    filled = figure.filled
    count, sizes = len(filled.points), np.diff(filled.offsets)
    require_few(count, "")
    corners = np.arange(count, dtype=np.int32)
    ahead = corners + 1
    ahead[filled.offsets[1:] - 1] = filled.offsets[:-1]
    values = attributes(figure)
    topology = Topology(
        corners=corners,
        offsets=filled.offsets.astype(np.int32),
        edges=np.column_stack((corners, ahead)),
        corner_edges=corners,
        sharp=np.zeros(count, dtype=bool),
        material=np.where(slots(values["colour"]) > 0, slots(values["colour"]), np.int32(LEAF)),
    )
    told = {name: np.repeat(value, sizes) for name, value in values.items()}
    return Mesh(filled.points.astype(dtype), topology, Held(chart, count, count, told))


def attributes(figure):
    """Values of each polygon, of the segment that it grows on where it has none of its own."""
    walk, place = figure.walk, figure.filled.place
    segment = walk.branches.before(place, walk.shown)
    values = {name: np.append(getattr(figure, name), -1)[segment] for name in ("axis", "order")}
    return values | {"birth": walk.word.births[place], "colour": figure.colours(place)}


def parts(z, w):
    """(n, 4) float array: quaternions of two complex numbers each, by their parts."""
    return np.stack((z.real, z.imag, w.real, w.imag), axis=1)


def organs(figure, chart, dtype):
    """A mesh of a point at each organ of a figure, which knows its size, how it is turned, and by a number its name.

    A rotation is a quaternion w x y z, which turns z to the turtle's heading, x to its left and y to its up.
    """
    found = figure.organs
    count = sum(len(organ.place) for organ in found)
    vertices = np.concatenate([organ.at for organ in found]).astype(dtype)
    sizes = [len(organ.place) for organ in found]
    values = {
        "organ": np.repeat(np.arange(1, len(found) + 1), sizes),
        "size": np.concatenate([organ.scale for organ in found]),
        "rotation": np.concatenate([parts(*turns.product(pair, ALONG_Z)) for pair in figure.organ_turns]),
        "colour": figure.colours(np.concatenate([organ.place for organ in found])),
    }
    topology = Topology(NONE, np.zeros(1, np.int32), np.zeros((0, 2), np.int32), NONE, np.zeros(0, bool), NONE)
    told = ", ".join(f"{number} = {organ.name} ({len(organ.place):,} of it)" for number, organ in enumerate(found, 1))
    return Mesh(vertices, topology, Held(chart, count, 0, values), (f"Organs are points. Attribute organ: {told}.",))
