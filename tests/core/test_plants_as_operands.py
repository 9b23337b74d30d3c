# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants in sweep-CSG trees: the solid of their tubes, which overlap where branches begin, without their leaves."""

import numpy as np
import pytest

pytest.importorskip("manifold3d")

import sweep_addon as sw

# Octagonal tubes along z: one of 2 m, and a thinner one of 3 m that begins within it and leaves it.
BAR = "axiom: [!(0.2) F(2)] f(0.7) !(0.1) F(3)"
LEAF = " [f(0.3) +(120) { f(0.3) +(120) f(0.3) +(120) f(0.3) }]"
VOLUME = 2 * np.sqrt(2) * (2 * 0.1**2 + 1.7 * 0.05**2)
BLOCK = sw.solids.Block(10.0, 10.0, 10.0)  # around all of it


@pytest.mark.parametrize("text", [BAR, BAR + LEAF])
def test_tubes_count_once_and_leaves_not(text):
    plant = sw.Plant(text, upright=True)
    assert plant.united().mesh().volume() == pytest.approx(VOLUME, rel=1e-9)
    assert (plant & plant).mesh().volume() == pytest.approx(VOLUME, rel=1e-9)
    assert (BLOCK - plant).mesh().volume() == pytest.approx(1000 - VOLUME, rel=1e-9)


def test_points_are_classified_against_a_plant():
    plant = sw.Plant(BAR, upright=True)
    assert sw.classify(plant, np.array([(0, 0, 1.0), (0, 0, 3.0), (0.09, 0, 3.0)])).tolist() == [1, 1, -1]


@pytest.mark.parametrize("output", ["edges", "curves"])
def test_segments_that_are_no_tubes_are_refused_before_anything_is_made(output):
    with pytest.raises(sw.ShapeError, match=f"^operand.output: must be tubes for a solid, got '{output}'$"):
        BLOCK - sw.Plant(BAR, output=output)
    with pytest.raises(sw.ShapeError, match="^base.output: must be tubes"):
        sw.Tree(sw.Plant(BAR, output=output))


def test_a_plant_of_polygons_alone_is_refused_when_it_is_made():
    with pytest.raises(sw.ShapeError, match="^steps.1.operand.output: must have tubes to be a solid"):
        (BLOCK - sw.Plant(f"axiom:{LEAF}")).mesh()


def test_a_tree_keeps_its_plant_as_it_was_told():
    plant = sw.Plant(BAR, upright=True)
    tree = BLOCK - plant.moved(z=1.0)
    assert tree.steps[0].operand.solid == plant and str(tree) == "Block - Plant"
    assert sw.load(sw.dump(tree)) == tree
    assert tree.mesh().volume() == pytest.approx(1000 - VOLUME, rel=1e-9)
    assert sw.classify(tree, np.array([(0, 0, 1.05), (0, 0, 0.95)])).tolist() == [-1, 1]


def test_tubes_that_are_to_be_united_are_one_closed_mesh_that_keeps_its_colours():
    plant = sw.Plant(f"{BAR} ' F(0.5) {LEAF}", upright=True, output={"kind": "tubes", "united": True})
    mesh = plant.mesh()
    coloured = 0.5 * 2 * np.sqrt(2) * 0.05**2
    assert mesh.volume() == pytest.approx(VOLUME + coloured, rel=1e-9)
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0 and mesh.euler_characteristic() == 2
    heights = mesh.vertices[mesh.corners.reshape(-1, 3), 2]
    assert set(mesh.topology.material) == {0, 1}
    assert heights[mesh.topology.material == 1].min() == pytest.approx(3.7)
    assert heights[mesh.topology.material == 0].max() == pytest.approx(3.7)
    assert plant.united().mesh().volume() == pytest.approx(mesh.volume(), rel=1e-12)
    organs = sw.Plant("axiom: F~A", output={"kind": "tubes", "united": True}).mesh()
    assert len(organs.vertices) == 16 and organs.told == ()


@pytest.mark.parametrize(("generations", "waits"), [(4, False), (10, True)])
def test_many_tubes_are_united_while_people_work_on(generations, waits):
    for united in (False, True):
        plant = sw.Plant(generations=generations, output={"kind": "tubes", "united": united})
        assert plant.make_solid == (waits and united)


def test_what_is_no_set_of_points_is_no_operand():
    with pytest.raises(TypeError):
        sw.Plant(BAR) - 1
