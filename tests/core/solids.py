# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What makes a mesh a solid, and inputs to make some of."""

import json
from pathlib import Path

import numpy as np

from sweep_addon.core.contours import Outline

DATA = Path(__file__).parents[1] / "data"
CENTRELINES = {line["name"]: line for line in json.loads((DATA / "centrelines.json").read_text())["lines"]}
KNOTS = {knot["name"]: knot for knot in json.loads((DATA / "knots.json").read_text())["knots"]}


def ngon(centre, radius, sides, start=0.3):
    """A regular polygon as an (n, 2) array of points."""
    angle = start + 2 * np.pi * np.arange(sides) / sides
    return np.array(centre) + radius * np.stack((np.cos(angle), np.sin(angle)), axis=1)


def box(low, high):
    (x, y), (z, w) = low, high
    return np.array([(x, y), (z, y), (z, w), (x, w)], dtype=float)


LETTER_B = [box((-0.5, -1), (0.5, 1)), box((-0.3, 0.1), (0.3, 0.8))[::-1], ngon((0, -0.5), 0.3, 17)]
PERCENT = [
    ngon((-0.6, 0.6), 0.35, 20),
    ngon((-0.6, 0.6), 0.2, 16)[::-1],
    np.array([(-0.7, -0.9), (-0.5, -0.9), (0.7, 0.9), (0.5, 0.9)]),
    ngon((0.6, -0.6), 0.35, 20)[::-1],
    ngon((0.6, -0.6), 0.2, 16),
]
AT = [ngon((0, 0), 1, 40), ngon((0, 0), 0.8, 30), ngon((0, 0), 0.6, 20), box((-0.3, -0.3), (0.2, 0.25))]
LETTER_L = [np.array([(0, 0), (1, 0), (1, 0.2), (0.2, 0.2), (0.2, 2), (0, 2)])]
GLYPHS = {  # outline, and the holes of each of its islands
    "B": (Outline(LETTER_B), (2,)),
    "%": (Outline(PERCENT), (1, 0, 1)),
    "@": (Outline(AT), (1, 1)),
    "L": (Outline(LETTER_L), (0,)),
}

TEAPOT_INNER = [  # the handle of Newell's teapot, 1975: the inner and the outer edge of its patches in their plane
    (-1.6, 0, 2.025),
    (-2.3, 0, 2.025),
    (-2.7, 0, 2.025),
    (-2.7, 0, 1.8),
    (-2.7, 0, 1.575),
    (-2.5, 0, 1.125),
    (-2, 0, 0.9),
]
TEAPOT_OUTER = [
    (-1.5, 0, 2.25),
    (-2.5, 0, 2.25),
    (-3, 0, 2.25),
    (-3, 0, 1.8),
    (-3, 0, 1.35),
    (-2.65, 0, 0.9375),
    (-1.9, 0, 0.6),
]


def assert_solid(mesh, euler, boundary=0):
    """A mesh with so many boundary edges and this Euler characteristic, and nothing else that a solid must not have."""
    pairs = mesh.topology.uses()[0]
    lengths = np.linalg.norm(mesh.vertices[pairs[:, 0]] - mesh.vertices[pairs[:, 1]], axis=1)
    areas = np.linalg.norm(mesh.normals, axis=1)
    size = np.ptp(mesh.vertices, axis=0).max()
    assert np.isfinite(mesh.vertices).all()
    assert len(mesh.boundary_edges()) == boundary and len(mesh.non_manifold_edges()) == 0
    assert len(np.unique((mesh.vertices / size).round(11), axis=0)) == len(mesh.vertices), "doubled vertices"
    assert lengths.min() > 1e-11 * size and areas.min() > 1e-15 * size**2, "an edge of no length, a face of no area"
    assert len(np.unique(mesh.corners)) == len(mesh.vertices), "loose vertices"
    assert len(mesh.edges) == len(pairs), "loose or doubled edges"
    assert mesh.euler_characteristic() == euler
    if not boundary:
        assert mesh.volume() > 0, "inside out"
