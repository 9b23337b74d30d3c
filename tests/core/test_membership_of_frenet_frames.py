# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Points of sweeps whose Frenet frame turns fast: on a knot it does so by half where the curvature is least."""

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.membership.members import member
from sweep_addon.core.membership.sets.bodies import MeshBody

KNOT = sw.trajectories.TorusKnot(2, 3, 0.5, 0.25)
WEDGE = sw.contours.Outline([[(-0.05, -0.05), (0.25, 0), (-0.05, 0.05)]])  # of which half a turn makes another one


@pytest.mark.thorough
@pytest.mark.parametrize("kind", [sw.GeneralizedCylinder, sw.GeneralSweep])
def test_a_figure_on_a_knot_is_where_its_mesh_is(kind):
    body = MeshBody(kind(WEDGE, KNOT, frame="frenet", samples=sw.sampling.Count(2000)).mesh())
    points = np.random.default_rng(0).uniform(-0.9, 0.9, (20_000, 3)) * (1, 1, 0.5)
    far = body.distance(points)
    clear = np.abs(far) > 2e-3  # chords of the fastest turns
    assert (sw.classify(kind(WEDGE, KNOT, frame="frenet"), points) == np.sign(-far))[clear].all()
    assert (far < -2e-3).sum() > 500


def test_a_solid_on_a_knot_is_where_the_frames_put_it():
    """Its inner points, in 2,001 poses, have been visited."""
    sweep = sw.GeneralSweep(sw.solids.Triangles(), KNOT, frame="frenet")
    places = sweep.motion.posed(np.array([(0.2, 0.0, -0.08)]), sweep.motion.at(np.linspace(0, KNOT.length(), 2001)))[
        :, 0
    ]
    assert (sw.classify(sweep, places[::4], 1e-6) == 1).all()
    low, high = member(sweep).box
    assert (places > low).all() and (places < high).all()
