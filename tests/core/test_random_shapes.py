# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random shapes of every kind that is made of balls, offsets, general motion or unions: closed, manifold and outward.

No two vertices are the same in single precision, which Blender keeps. With `--full` there are a thousand of each kind.
"""

from math import pi

import numpy as np
import pytest
from conftest import BRIEF, FULL

from sweep_addon.core.contours import Circle, Ellipse, Rectangle, RegularPolygon, Star, Superellipse
from sweep_addon.core.contours.region import Region
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.meshes.booleans import hull_body, mesh_of
from sweep_addon.core.meshes.facets import facets
from sweep_addon.core.shapes.canal_surface import CanalSurface
from sweep_addon.core.shapes.general_sweep import GeneralSweep
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.offset_surface import OffsetSurface
from sweep_addon.core.solids import Ball, Block, Bracket, Cylinder, DrilledBlock, Triangles
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Bezier, Formula, Helix, Polyline

pytest.importorskip("manifold3d")

DRAWN = 1000 if FULL else 2 if BRIEF else 4
SIDES = "outside", "inside", "shell"
REFUSED = 0.15  # of shapes at most: nothing is left inside, contours turn too much, or cells are too large


def curve(random, flat=False):
    """A closed curve of three harmonics."""
    waves = random.normal(size=(3, 2, 3)) / (1, 2, 3)
    x, y, z = (
        "+".join(f"{a:.4f}*cos({n}*u)+{b:.4f}*sin({n}*u)" for n, (a, b) in enumerate(zip(*part, strict=True), 1))
        for part in waves
    )
    return Formula(x, y, "0" if flat else z, 0.0, 2 * pi)


def path(random):
    kinds = (
        lambda: curve(random),
        lambda: Bezier(random.uniform(-1, 1, (4, 3))),
        lambda: Helix(random.uniform(0.2, 1), random.uniform(0.1, 0.8), random.uniform(0.5, 3)),
        lambda: Polyline(random.uniform(-1, 1, (int(random.integers(2, 6)), 3))),
    )
    return kinds[random.integers(len(kinds))]()


def radius(random):
    """The same everywhere, evenly changing, or a wave, some of which swallow the next ball."""
    low, high = np.sort(random.uniform(0.05, 0.4, 2))
    middle, wave = (low + high) / 2, int(random.integers(1, 6))
    laws = middle, f"{high:.4f} - {high - low:.4f}*t", f"{middle:.4f} + {0.45 * (high - low):.4f}*sin({wave}*2*pi*t)"
    return laws[random.integers(len(laws))]


def contour(random):
    size = random.uniform(0.08, 0.35)
    kinds = (
        Circle(size, points=12),
        Ellipse(size, size / 2, points=12),
        Rectangle(size, size * random.uniform(0.3, 2)),
        RegularPolygon(int(random.integers(3, 7)), size),
        Star(int(random.integers(3, 8)), size, size * random.uniform(0.3, 0.8)),
        Superellipse(size, size * 1.2),
    )
    return kinds[random.integers(len(kinds))]


def hull(random):
    mesh = mesh_of(hull_body(random.normal(size=(int(random.integers(6, 40)), 3)) * 0.3))
    return Triangles(mesh.vertices, facets(mesh)[0])


def solid(random):
    sizes = random.uniform(0.2, 0.8, 3)
    kinds = Block(*sizes), Ball(0.3, 10), Cylinder(0.2, 0.6, 12), Bracket(), DrilledBlock(points=12), hull(random)
    return kinds[random.integers(len(kinds))]


def patch(random):
    """A square surface that is rough."""
    x, y = np.meshgrid(np.linspace(-0.3, 0.3, 5), np.linspace(-0.3, 0.3, 5), indexing="ij")
    number = np.arange(25).reshape(5, 5)
    a, b, c, d = (part.ravel() for part in (number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]))
    places = np.stack((x, y, 0.05 * random.normal(size=x.shape)), axis=-1).reshape(-1, 3)
    return Triangles(places, np.concatenate((np.stack((a, b, c), axis=1), np.stack((a, c, d), axis=1))))


def side(random):
    return SIDES[random.integers(len(SIDES))]


def turns(random, most):
    return {f"turn_{axis}": f"{random.uniform(-most, most):.3f}*t" for axis in "xyz"}


def canal(random):
    return CanalSurface(
        path(random), radius(random), points=int(random.integers(6, 14)), samples=Count(int(random.integers(16, 60)))
    )


def disc(random):
    samples = Count(int(random.integers(32, 90)))
    return CanalSurface(curve(random, flat=True), radius(random), "disc", samples=samples)


def offset(random, engine, body):
    tolerance = 0.005 if engine == "level-set" else 0.0
    return OffsetSurface(body, random.uniform(0.03, 0.15), side(random), tolerance, engine).mesh()


def figure(random):
    return GeneralSweep(
        contour(random), path(random), Count(40), frame="rotation-minimizing", turn_z=f"{random.uniform(-3, 3):.3f}*t"
    )


def breathing(random):
    formula = f"x^2 + {random.uniform(0.5, 2):.3f}*y^2 - ({random.uniform(0.1, 0.2):.3f} + 0.05*cos(2*pi*t))^2"
    return GeneralSweep(Region(formula), path(random), cells=40, frame="rotation-minimizing")


SOLID = {
    "solid of balls": lambda random: canal(random).solid(),
    "solid of a contour": lambda random: GeneralizedCylinder(
        contour(random), path(random), Count(int(random.integers(24, 90)))
    ).solid(),
    "solid of a figure in general motion": lambda random: figure(random).solid(),
    "convex offset": lambda random: offset(random, "convex", hull(random)),
    "offset by rounded faces": lambda random: offset(random, "rounded-faces", solid(random)),
    "offset as a level set": lambda random: offset(random, "level-set", solid(random)),
    "solid in general motion": lambda random: GeneralSweep(
        solid(random), path(random), cells=12, **turns(random, 4)
    ).mesh(),
}
SURFACE = {  # may cross themselves
    "canal surface": lambda random: canal(random).mesh(),
    "figure in general motion": lambda random: figure(random).mesh(),
    "surface in general motion": lambda random: GeneralSweep(
        patch(random), path(random), Count(30), **turns(random, 2)
    ).mesh(),
    "region in general motion": lambda random: breathing(random).mesh(),
}
FLAT = {
    "region of discs": lambda random: disc(random).solid(),
    "offset in the plane": lambda random: OffsetSurface(
        contour(random), random.uniform(0.01, 0.1), side(random)
    ).mesh(),
}


def drawn(make, count=DRAWN):
    """Random meshes of a kind that were not refused."""
    made = 0
    for seed in range(count):
        try:
            yield make(np.random.default_rng(seed))
            made += 1
        except ShapeError:
            continue
    assert made >= (1 - REFUSED) * count - 2


def assert_sound(mesh):
    assert np.isfinite(mesh.vertices).all()
    assert len(mesh.non_manifold_edges()) == 0
    assert len(np.unique(mesh.vertices.astype(np.float32), axis=0)) == len(mesh.vertices), "doubled vertices"
    assert len(np.unique(mesh.corners)) == len(mesh.vertices), "loose vertices"


LONG = {"solid in general motion": pytest.mark.thorough}  # of which test_general_sweep.py draws too


@pytest.mark.parametrize("kind", [pytest.param(kind, marks=LONG.get(kind, ())) for kind in SOLID])
def test_random_solids_are_closed_manifold_and_outward(kind):
    for mesh in drawn(SOLID[kind], DRAWN // 2 if kind in LONG and not FULL else DRAWN):
        assert_sound(mesh)
        assert len(mesh.boundary_edges()) == 0 and mesh.volume() > 0


@pytest.mark.parametrize("kind", SURFACE)
def test_random_surfaces_are_closed_and_manifold(kind):
    for mesh in drawn(SURFACE[kind]):
        assert_sound(mesh)
        assert len(mesh.boundary_edges()) == 0


@pytest.mark.parametrize("kind", FLAT)
def test_random_regions_are_flat_and_of_one_boundary(kind):
    for mesh in drawn(FLAT[kind]):
        assert_sound(mesh)
        assert len(mesh.boundary_edges()) and mesh.area() > 0
        assert np.ptp(mesh.vertices[:, 2]) == 0 and (mesh.normals[:, 2] > 0).all()
