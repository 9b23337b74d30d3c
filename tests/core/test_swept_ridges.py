# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How near the sweep of a solid is to what it should be, on faces and on the ridges that its edges leave behind."""

from functools import cache
from math import hypot, pi

import numpy as np
import pytest
from conftest import FULL

from sweep_addon.core.meshes.facets import facets
from sweep_addon.core.shapes.general_sweep import GeneralSweep
from sweep_addon.core.solids import Ball, Block, Cylinder
from sweep_addon.core.trajectories import Arc, Line

pytest.importorskip("manifold3d")


def plate(outer, inner, half):
    """The signed distance from a round plate about z, with a hole where `inner` is more than 0, to its boundary."""

    def distance(points):
        r = np.linalg.norm(points[:, :2], axis=1)
        aside = np.maximum(r - outer, inner - r)
        above = np.abs(points[:, 2]) - half
        beyond = np.hypot(np.maximum(aside, 0), np.maximum(above, 0))
        return beyond + np.minimum(np.maximum(aside, above), 0)

    return distance


def moved_block(sides, way):
    """The signed distance from the sum of a block and a segment, inside; outside that from the plane that is farthest.

    Its faces are those of the block and those that an edge leaves, across the products of the way and the axes.
    """
    half, way = np.asarray(sides) / 2, np.asarray(way)
    normals = np.concatenate((np.eye(3), np.cross(way, np.eye(3))))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    reach = np.abs(normals) @ half + np.abs(normals @ way) / 2

    def distance(points):
        return (np.abs((points - way / 2) @ normals.T) - reach).max(axis=1)

    return distance


def quarter(inner, outer, half):
    """The signed distance from where a cube has been in a quarter of a turn about z, inside.

    Its faces at the ends go on in straight ones, as far as half of it.
    """

    def distance(points):
        r = np.linalg.norm(points[:, :2], axis=1)
        along, aside = points[:, :2].max(axis=1), points[:, :2].min(axis=1)  # from the nearer end
        within = inner - np.where(aside > 0, r, along)
        return np.max([r - outer, within, -half - aside, np.abs(points[:, 2]) - half], axis=0)

    return distance


def torus(points):
    return np.hypot(np.hypot(points[:, 0], points[:, 1]) - 1, points[:, 2]) - 0.25


WAY, CELLS = (1.0, 0.2, 0.1), 48 if FULL else 32
SWEEPS = {
    "a block along a line": (
        GeneralSweep(Block(0.4, 0.2, 0.3), Line(end=WAY), cells=CELLS),
        moved_block((0.4, 0.2, 0.3), WAY),
    ),
    "a block round a circle": (
        GeneralSweep(Block(0.4, 0.3, 0.2), Arc(1.0, 2 * pi), frame="rotation-minimizing", cells=CELLS),
        plate(hypot(1.2, 0.1), 0.8, 0.15),
    ),
    "a cube along an arc": (
        GeneralSweep(Block(0.4, 0.4, 0.4), Arc(1.0, pi / 2), frame="rotation-minimizing", cells=CELLS),
        quarter(0.8, hypot(1.2, 0.2), 0.2),
    ),
    "a rod that turns about its middle": (
        GeneralSweep(Block(0.9, 0.2, 0.2), Line(end=(0, 0, 1e-6)), turn_z="pi*t", cells=CELLS),
        plate(hypot(0.45, 0.1), -1.0, 0.1),
    ),
    "a cylinder across its axis": (
        GeneralSweep(Cylinder(0.2, 0.4, 96), Arc(0.5, 2 * pi), cells=32),
        plate(0.7, 0.3, 0.2),
    ),
    "a ball round a circle": (GeneralSweep(Ball(0.25, 128), Arc(1.0, 2 * pi), cells=CELLS), torus),
}


BRIEFLY = "a block along a line"  # is tried on every host
NAMES = [BRIEFLY, *(pytest.param(n, marks=pytest.mark.thorough) for n in SWEEPS if n != BRIEFLY)]


@cache
def swept(name):
    """The mesh of a sweep, and the side of its cells."""
    mesh = SWEEPS[name][0].mesh()
    return mesh, np.ptp(mesh.vertices, axis=0).max() / SWEEPS[name][0].cells


@pytest.mark.thorough
@pytest.mark.parametrize("name", NAMES)
def test_vertices_are_on_the_boundary_of_what_is_visited(name):
    """To a fourteenth of a cell each, to six thousandths as a rule."""
    mesh, step = swept(name)
    off = np.abs(SWEEPS[name][1](mesh.vertices)) / step
    assert off.max() < 0.07 and np.sqrt((off**2).mean()) < 0.006


@pytest.mark.parametrize("name", NAMES)
def test_ridges_are_not_cut_off(name):
    """Where a ridge passes a cell unseen an edge would cut it off by up to half a cell: such edges are mended."""
    mesh, step = swept(name)
    middles = mesh.vertices[facets(mesh)[0]].mean(axis=1)
    assert np.abs(SWEEPS[name][1](middles)).max() < 0.1 * step
