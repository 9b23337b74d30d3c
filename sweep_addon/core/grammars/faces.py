# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The polygons of a figure as faces beside its tubes or edges: leaves, petals, and what else a grammar fills."""

from dataclasses import replace

import numpy as np

from ..mesh import Topology, require_few

FACE = 2  # material slot, behind those of sides and caps


def with_polygons(mesh, figure):
    """A mesh of a figure's segments, and a face with vertices of its own for each of the figure's polygons."""
    filled = figure.filled
    if not len(filled.place):
        return mesh
    require_few(len(mesh.vertices) + len(filled.points), "sides")
    chart, own = mesh.chart, attributes(figure)
    values = {name: np.concatenate((held, own[name])) for name, held in chart.values.items()}
    return replace(
        mesh,
        vertices=np.concatenate((mesh.vertices, filled.points)),
        topology=beside(mesh.topology, len(mesh.vertices), filled.offsets.astype(np.int32)),
        chart=type(chart)(values, chart.rings),
    )


def attributes(figure):
    """Values at each vertex of the polygons, of the segment that they grow on where they have none of their own."""
    walk, filled = figure.walk, figure.filled
    segment = walk.branches.before(filled.place, walk.shown)
    values = {name: np.append(getattr(figure, name), -1)[segment] for name in ("axis", "order")}
    values |= {"radius": np.zeros(len(segment)), "birth": walk.word.births[filled.place]}
    values["colour"] = figure.colours(filled.place)
    sizes = np.diff(filled.offsets)
    return {name: np.repeat(value.astype(np.float64), sizes) for name, value in values.items()}


def beside(topology, first, offsets):
    """A topology with faces beside it, whose vertices stand in a row and begin with a number."""
    count = int(offsets[-1])
    corners = np.arange(first, first + count, dtype=np.int32)
    following = corners + 1
    following[offsets[1:] - 1] = corners[offsets[:-1]]
    faces = len(offsets) - 1
    return Topology(
        np.concatenate((topology.corners, corners)),
        np.concatenate((topology.offsets, topology.offsets[-1] + offsets[1:])),
        np.concatenate((topology.edges, np.column_stack((corners, following)))),
        np.concatenate((topology.corner_edges, np.arange(count, dtype=np.int32) + np.int32(len(topology.edges)))),
        np.concatenate((topology.sharp, np.zeros(count, dtype=bool))),
        np.concatenate((topology.material, np.full(faces, FACE, dtype=np.int32))),
    )
