# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two parts that know nothing of each other agree: membership, told from the motion, has vertices of meshes on.

Chords leave out what is between vertices, but not these. The random sweeps are clean or not, and of few contours or
many; with `--full` there are forty times as many, twenty of each kind, and more places of each.
"""

from dataclasses import replace

import numpy as np
import pytest
from conftest import FULL
from random_sweeps import FRAMES, OTHERS, TRAJECTORIES, cylinder

import sweep_addon as sw
from sweep_addon.core.stations.sampling import Count

pytestmark = pytest.mark.thorough

DRAWN, MORE = (20 if FULL else 1), 6  # of each trajectory with each frame, and times as many of each other kind
PLACES = 300 if FULL else 120  # of a mesh at most
TRIED = 20  # for each that is made: some are refused
EXACT = 1e-9  # of the size: a hundred times what the motion is known to
FOLDED = 1e-7  # where contours run backward what passes through a point does so at an angle that may be small
MANY = Count(401)
NO_SHAPE = (
    "it takes more contours",  # whose domes are where the chords lead
    "misses the plane",  # of a rail
    "its own plane",  # no volume
)


def drawn(make, count, *which):
    """Sweeps that are not refused, and their meshes."""
    made = 0
    for seed in range(TRIED * count):
        try:
            shape = make(np.random.default_rng([seed, *which]))
            mesh = shape.mesh()
        except sw.ShapeError:
            continue
        if any(words in told for told in mesh.told for words in NO_SHAPE):
            continue
        yield seed, shape, mesh
        made += 1
        if made == count:
            return
    assert made > count / 2


def turns_between_mitres(shape):
    """Whether a contour leans towards mitres while it turns, which may carry some of its points back there."""
    if not isinstance(shape, sw.GeneralizedCylinder) or not isinstance(shape.trajectory, sw.trajectories.Polyline):
        return False
    along, *_ = shape.laid_out(*shape.moving(), (shape.start, shape.end))
    return not (shape.trajectory.rounded or along.is_constant)


def assert_on(seed, shape, mesh):
    places = mesh.vertices[:: -(-len(mesh.vertices) // PLACES)]
    size = np.linalg.norm(np.ptp(mesh.vertices, axis=0))
    labels = sw.classify(shape, places, EXACT * size)
    if (labels == 0).all():
        return
    said = f"seed {seed}: out, on and in are {np.bincount(labels + 1, minlength=3)} of {shape}"
    swept = shape.solid if isinstance(shape, sw.Placed) else shape
    met = replace(swept, samples=MANY).self_intersections()
    assert met or turns_between_mitres(swept), said
    if not any(place.kind == "corner" for place in met):  # else contours stand beyond the mitre at the other end
        assert (sw.classify(shape, places[labels == -1], FOLDED * size) >= 0).all(), said


def combined():
    """The names of trajectories and frames and their numbers, in every third of which there are cases for each run."""
    for i, trajectory in enumerate(TRAJECTORIES):
        for j, frame in enumerate(FRAMES):
            usual = pytest.mark.large if (i + j) % 3 else ()
            yield pytest.param(trajectory, frame, (i, j), id=f"{trajectory}-{frame}", marks=usual)


@pytest.mark.parametrize("trajectory, frame, which", list(combined()))
def test_vertices_of_cylinders_are_on_them(trajectory, frame, which):
    for case in drawn(lambda random: cylinder(random, trajectory, frame), DRAWN, *which):
        assert_on(*case)


@pytest.mark.parametrize("kind", OTHERS)
def test_vertices_of_other_sweeps_are_on_them(kind):
    if kind == "offset":
        pytest.importorskip("manifold3d", reason="its rounded bodies are united")
    for case in drawn(OTHERS[kind], MORE * DRAWN):
        assert_on(*case)
