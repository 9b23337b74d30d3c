# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Point membership of many points: threads, progress and a search that ends with the first image change no label."""

import threading
from math import tau

import numpy as np
import pytest
from conftest import FULL

import sweep_addon as sw
from sweep_addon.core.membership import blocks, members
from sweep_addon.core.membership.sets.moving_plane import MovingPlane

HELIX = sw.GeneralizedCylinder(sw.contours.Circle(0.2), sw.trajectories.Helix(1.0, 0.5, 2.0))
RING = sw.RotationalSweep(sw.contours.Outline([[(0.2, -0.5), (0.9, -0.1), (0.5, 0.5)]]))
SPINDLE = sw.GeneralizedCylinder(sw.contours.Circle(0.45), sw.trajectories.Arc(0.3, tau))
KNOT = sw.GeneralizedCylinder(sw.contours.Circle(0.3), sw.trajectories.TorusKnot(2, 3, 0.5, 0.25))
RADIUS, PITCH = 1.0, 0.5


def points_about(shape, count, seed=0):
    low, high = members.member(shape).box
    return np.random.default_rng(seed).uniform(low, high, (count, 3))


@pytest.mark.thorough
@pytest.mark.parametrize("shape", [HELIX, SPINDLE, RING - sw.solids.Ball(0.4)])
def test_labels_are_the_same_for_any_number_of_threads(shape, monkeypatch):
    points = points_about(shape, 250_000 if FULL else 100_000)
    found = []
    for threads in (1, 2, 5):
        monkeypatch.setattr(blocks, "processors", lambda threads=threads: threads)
        found.append(sw.classify(shape, points))
    assert (found[0] == found[1]).all() and (found[0] == found[2]).all()


def test_no_more_threads_are_left_than_there_were():
    before = threading.active_count()
    sw.classify(HELIX, points_about(HELIX, 300_000))
    assert threading.active_count() == before


def test_progress_rises_and_may_end_the_work():
    points, parts = points_about(HELIX, 300_000), []
    sw.classify(HELIX, points, progress=parts.append)
    assert len(parts) > 3 and parts == sorted(parts) and parts[-1] == 1.0

    def stop(part):
        parts.append(part)
        raise KeyboardInterrupt

    del parts[:]
    with pytest.raises(KeyboardInterrupt):
        sw.classify(HELIX, points, progress=stop)
    assert len(parts) == 1


def test_a_refusal_in_a_block_reaches_who_asked():
    def refuse(some):
        raise sw.ShapeError("no")

    with pytest.raises(sw.ShapeError):
        blocks.in_blocks(refuse, np.zeros((300_000, 3)), threads=3)


@pytest.mark.parametrize("shape, clean", [(HELIX, True), (RING, True), (SPINDLE, False), (KNOT, False)])
def test_the_search_ends_with_the_first_image_where_a_sweep_is_known_to_be_clean(shape, clean, monkeypatch):
    """The helix's pitch leaves its turns apart, the ring's triangle is on one side of the axis; the others meet."""
    points, asked = points_about(shape, 60_000), []
    of_first = MovingPlane.first_found
    monkeypatch.setattr(MovingPlane, "first_found", lambda *given: asked.append(len(given[1])) or of_first(*given))
    quick = sw.classify(shape, points)
    assert bool(asked) == clean
    monkeypatch.setattr(MovingPlane, "is_clean", lambda self, tolerance: False)
    assert (quick == sw.classify(shape, points)).all()


@pytest.mark.parametrize("shape", [HELIX, RING])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-3, 0.05])
def test_it_ends_so_for_what_is_on_too(shape, tolerance, monkeypatch):
    vertices = shape.mesh().vertices
    near = np.random.default_rng(1).normal(scale=tolerance, size=(20_000, 3))
    points = vertices[np.arange(20_000) % len(vertices)] + near
    quick = sw.classify(shape, points, tolerance)
    monkeypatch.setattr(MovingPlane, "is_clean", lambda self, tolerance: False)
    assert (quick == sw.classify(shape, points, tolerance)).all()


def test_strands_nearer_than_the_tolerance_are_not_known_to_be_clean():
    """Turns of a helix whose tubes are 9 cm apart: with a tolerance as large a point may be on one and in the other."""
    plane = members.member(HELIX)
    far = 0.001
    distance = PITCH / np.hypot(1, PITCH / (tau * RADIUS)) - 0.4
    assert 2 * far < distance < 0.2
    assert plane.is_clean(far)
    assert not plane.is_clean(distance)
