# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts that do not get out straight do by the motions that are known of them, each certified."""

import numpy as np
import pytest
from planted_assemblies import Z, bayonet, bent_rod, curved_tube, key_in_a_slot, overlaps, turned

import sweep_addon as sw
from sweep_addon.core.removal.finding import scene_of
from sweep_addon.core.removal.legs import Pose, turn
from sweep_addon.core.removal.slipping import Contacts
from sweep_addon.core.removal.trees import Draws, between
from sweep_addon.core.solids import Block

pytest.importorskip("fcl", reason="removal paths are asked of python-fcl")
pytest.importorskip("manifold3d", reason="the solids of assemblies are made by it")


def is_free(path, part, others):
    """Whether a path keeps a clearance, and manifold3d finds no overlap at many places of it."""
    return path.tolerance == 0 and path.clearance > 0 and overlaps(path, part, others, steps=12) < 1e-12


@pytest.fixture(scope="module")
def unlocked():
    """The plug of a bayonet, what it stands in, and its path, which takes seconds to find."""
    part, others = bayonet()
    return part, others, sw.removal_path(part, others)


def test_a_key_goes_along_its_slot_to_the_mouth_and_out():
    part, others = key_in_a_slot()
    path = sw.removal_path(part, others)
    assert is_free(path, part, others)
    assert [leg.turns for leg in path.legs] == [False, False]
    assert path.legs[0].way == pytest.approx([0.595, 0, 0], abs=0.012)  # the play in the mouth is 0.01 m
    assert path.legs[1].way[2] > 0.35 and abs(path.legs[1].way[:2]).max() < 1e-9


@pytest.mark.thorough
def test_a_bayonet_turns_to_its_slots_and_gets_out(unlocked):
    part, others, path = unlocked
    assert is_free(path, part, others)
    first, last = path.legs
    assert abs(first.axis @ Z) == pytest.approx(1.0, abs=1e-9)
    angle = first.angle * np.sign(first.axis @ Z)
    assert min(abs(angle - 1.2), abs(angle - 1.2 + np.pi)) < 0.034  # as far as the lugs have play in the slots
    assert not last.turns and last.way[2] > 0.5


@pytest.mark.thorough
def test_a_curved_tube_turns_about_the_axis_of_its_arc():
    """Which the contacts tell, and neither the tube's own axes nor its middle."""
    part, others = curved_tube()
    path = sw.removal_path(part, others)
    assert is_free(path, part, others)
    leg = path.legs[0]
    assert abs(leg.axis @ Z) > 0.999
    assert np.abs(leg.pivot[:2]).max() < 0.02


@pytest.mark.thorough
def test_a_bent_rod_gets_out_by_chance_and_the_same_with_the_same_seed():
    part, others = bent_rod()
    path, again = (sw.removal_path(part, others, seed=2, budget=40_000) for _ in range(2))
    assert is_free(path, part, others)
    assert np.array_equal(path.matrices(), again.matrices())


def test_turning_the_assembly_turns_a_path_of_several_legs():
    matrix, origin = turn(np.array([0.6, 0.0, 0.8]), 0.7), np.array([3.0, -2.0, 1.0])
    part, others = key_in_a_slot()
    path = sw.removal_path(part, others)
    elsewhere = sw.removal_path(
        turned(part, matrix, origin), {name: turned(other, matrix, origin) for name, other in others.items()}
    )
    assert np.allclose([leg.way for leg in elsewhere.legs], [matrix @ leg.way for leg in path.legs], atol=1e-6)


@pytest.mark.thorough
def test_what_must_stay_empty_holds_the_part_on_legs_that_turn(unlocked):
    part, _, path = unlocked
    own = part.mesh()
    points = np.random.default_rng(1).uniform(own.vertices.min(axis=0), own.vertices.max(axis=0), (300, 3))
    inside = points[sw.classify(sw.solids.Triangles.of(own), points) > 0]  # the polyhedron, which is what moves
    assert len(inside) > 50
    swept = path.swept()
    for matrix in path.matrices(3):
        assert (sw.classify(swept, inside @ matrix[:3, :3].T + matrix[:3, 3], tolerance=1e-6) >= 0).all()
    assert sw.classify(swept, [(0.45, 0.0, 0.0), (0, 0, -0.6)]).tolist() == [-1, -1]


def test_the_contacts_of_a_pin_in_a_hole_let_it_slide_and_turn():
    """Lower pair, cylindrical: a translation along the axis and a rotation about it, and no other motion."""
    hole = sw.solids.DrilledBlock(radius=0.101, points=48)
    scene = scene_of(sw.solids.Cylinder(0.1, 0.6, points=48), [hole], None)
    contacts = Contacts.of(scene.part, scene.others, 0.01)
    ((speeds, turns), *_) = contacts.twists()
    assert len(turns) == 2
    assert np.abs(np.column_stack((speeds, turns))[:, [0, 1, 3, 4]]).max() < 1e-3
    assert np.abs(contacts.translations() @ Z) == pytest.approx([1.0], abs=1e-6)


@pytest.mark.parametrize("angle", [0.0, 1e-12, 0.4, 3.0, np.pi - 1e-8, np.pi])
def test_a_leg_between_two_poses_leads_from_one_to_the_other(angle):
    draws = Draws(5)
    one = Pose(turn(draws.direction(3), 0.7), draws.even(3))
    other = Pose(turn(draws.direction(3), angle) @ one.matrix, draws.even(3))
    there = between(one, other).pose(1.0).after(one)
    assert np.allclose(there.matrix, other.matrix, atol=1e-7) and np.allclose(there.origin, other.origin)


def test_random_numbers_are_even():
    numbers = Draws(3).even(10_000)
    assert abs(numbers.mean() - 0.5) < 0.02 and 0 <= numbers.min() and numbers.max() < 1
    assert np.abs(np.histogram(numbers, 10, (0, 1))[0] - 1000).max() < 150
    assert not np.array_equal(Draws(4).even(5), Draws(3).even(5))


@pytest.mark.parametrize(
    ("named", "got"), [({"seed": -1}, "seed"), ({"budget": 0.5}, "budget"), ({"seed": None}, "seed")]
)
def test_a_seed_and_a_budget_that_are_no_counts_are_refused(named, got):
    with pytest.raises(sw.ShapeError, match=f"^{got}: must be a whole number"):
        sw.removal_path(Block(), [Block().moved(x=2)], **named)
