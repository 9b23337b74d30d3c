# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Extrusions as sweep-CSG trees of primitives: their meshes are those of the extrusions."""

import json
from collections import Counter
from functools import cache

import numpy as np
import pytest
from contour_inputs import DATA
from line_arc_outlines import inside_by_rays, turn

import sweep_addon as sw
from sweep_addon.core.conversion import KINDS, kind
from sweep_addon.core.conversion.loop import Loop
from sweep_addon.core.conversion.seams import seamed
from sweep_addon.core.declared.parameters import ShapeError

REAL = json.loads((DATA / "real_outlines.json").read_text())["outlines"]
PLATE = sw.contours.Rectangle(4.0, 2.0, rounding=0.5)
WASHER = sw.contours.Outline([[(-2, 0), (2, 0)], [(-1, 0), (1, 0)]], [[1, 1], [1, 1]])


def operands(tree):
    """The sweeps of a tree."""
    if not isinstance(tree, sw.Tree):
        return [tree]
    return [sweep for node in (tree.base, *(step.operand for step in tree.steps)) for sweep in operands(node)]


def extruded(outline, **given):
    x, y, bulge = np.array(outline["vertices"]).T
    return sw.TranslationalSweep(sw.contours.Outline([np.stack([x, y], axis=1)], [bulge]), 3.0, **given)


@cache
def converted(number):
    """The tree of a real outline's extrusion, which is asked in several ways."""
    return sw.sweep_to_csg(extruded(REAL[number]))


def test_a_plate_with_round_corners_is_a_block_less_four_fillets():
    tree = sw.sweep_to_csg(sw.TranslationalSweep(PLATE, 0.1))
    assert kind(tree.base) == "block"
    assert [(step.operation.name, kind(step.operand)) for step in tree.steps] == [("DIFFERENCE", "fillet")] * 4


def test_a_washer_is_a_cylinder_less_a_cylinder():
    tree = sw.sweep_to_csg(sw.TranslationalSweep(WASHER, 0.1))
    assert [kind(operand) for operand in operands(tree)] == ["cylinder", "cylinder"]
    assert [step.operation.name for step in tree.steps] == ["DIFFERENCE"]


@pytest.mark.thorough
@pytest.mark.parametrize("every", [12, pytest.param(1, marks=pytest.mark.large)])
def test_the_mesh_of_a_tree_is_one_closed_surface_with_the_volume_of_the_sweep(every):
    """A solid without holes and voids has Euler characteristic 2: a gap between primitives would be a second surface.

    Arcs that are a single chord in the sweep are two in its primitives, which changes its volume by less than chords.
    """
    pytest.importorskip("manifold3d", reason="meshes of trees are asked of manifold3d")
    for number in range(0, len(REAL), every):
        outline, mesh = REAL[number], converted(number).mesh()
        assert mesh.volume() == pytest.approx(extruded(outline).mesh().volume(), rel=1e-3)
        assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
        assert mesh.euler_characteristic() == 2, outline["id"]


def test_a_fillet_on_a_corner_that_lies_on_a_longer_line_is_joined_to_it():
    """The solver alone drops such a corner: the fillet misses the line by a last digit and is a surface of its own."""
    pytest.importorskip("manifold3d", reason="meshes of trees are asked of manifold3d")
    sweep = extruded(next(outline for outline in REAL if outline["id"] == "prusa3-003"))
    mesh = sw.sweep_to_csg(sweep).mesh()
    assert mesh.euler_characteristic() == 2
    assert mesh.volume() == pytest.approx(sweep.mesh().volume(), rel=1e-3)


@pytest.mark.thorough
@pytest.mark.parametrize("every, samples", [(12, 1_000), pytest.param(1, 20_000, marks=pytest.mark.large)])
def test_membership_of_a_tree_is_that_of_the_outline(every, samples):
    rng = np.random.default_rng(7)
    for outline in REAL[::every]:
        vertices = np.array(outline["vertices"])
        vertices[:, :2] = vertices[:, :2] @ turn(rng.uniform(0, 6))
        low, high = vertices[:, :2].min(axis=0), vertices[:, :2].max(axis=0)
        points = np.column_stack([rng.uniform(low, high, (samples, 2)), rng.uniform(0.1, 2.9, samples)])
        found = sw.classify(sw.sweep_to_csg(extruded({"vertices": vertices})), points)
        np.testing.assert_array_equal(found, np.where(inside_by_rays(vertices, points[:, :2]), 1, -1))


def test_every_operand_of_a_tree_is_a_primitive():
    for number in range(0, len(REAL), 12):
        assert {kind(operand) for operand in operands(converted(number))} <= set(KINDS)


@pytest.mark.parametrize(
    "given",
    [
        {"direction": (0.5, 0.25, 1.0)},
        {"directions": "both", "depth": 0.5},
        {"reference": "centroid"},
        {"reference": "point", "reference_x": 1.0, "reference_y": -2.0},
        {"steps": 3},
    ],
)
def test_primitives_go_the_way_of_the_sweep(given):
    pytest.importorskip("manifold3d", reason="meshes of trees are asked of manifold3d")
    corners = [(0, 0), (3, 0), (3, 1), (2, 1), (2, 2), (0, 2)]
    sweep = sw.TranslationalSweep(sw.contours.Outline([corners], [[0, 0.5, 0, 0, 0, 0]]), 2.0, **given)
    mesh, expected = sw.sweep_to_csg(sweep).mesh(), sweep.mesh()
    assert mesh.volume() == pytest.approx(expected.volume(), rel=1e-9)
    np.testing.assert_allclose(np.ptp(mesh.vertices, axis=0), np.ptp(expected.vertices, axis=0), atol=1e-9)
    np.testing.assert_allclose(mesh.vertices.min(axis=0), expected.vertices.min(axis=0), atol=1e-9)


def test_a_tree_is_kept_by_a_job():
    tree = sw.sweep_to_csg(sw.TranslationalSweep(PLATE, 0.1))
    assert sw.load(sw.dump(tree)) == tree
    assert Counter(map(kind, operands(sw.load(sw.dump(tree))))) == {"block": 1, "fillet": 4}


def test_corners_on_a_line_of_another_primitive_become_its_own():
    triangle = Loop(((0.0, 0.0), (3.0, 0.0), (0.0, 3.0)), (0.0, 0.0, 0.4))
    other = Loop(((2.0, 0.0), (1.0, 1e-12), (1.0, -1.0), (2.0, -1.0)), (0.0,) * 4)
    found, unchanged = seamed([triangle, other], 1e-9)
    assert found.corners == ((0.0, 0.0), (1.0, 1e-12), (2.0, 0.0), (3.0, 0.0), (0.0, 3.0))
    assert found.bulges == (0.0, 0.0, 0.0, 0.0, 0.4)
    assert unchanged == other


@pytest.mark.parametrize(
    "shape, sentence",
    [
        (sw.GeneralizedCylinder(), "shape: must be a translational sweep, got 'GeneralizedCylinder'"),
        (sw.TranslationalSweep(taper=0.1), "taper: must be 0"),
        (sw.TranslationalSweep(direction=(1.0, 0.0, 0.0)), "direction: must lead out of the contour's plane"),
        (sw.TranslationalSweep(sw.contours.Outline(closed=False)), "contour: must be closed"),
        (sw.TranslationalSweep(sw.contours.Mixed()), "contour: must be an area"),
    ],
)
def test_what_cannot_be_converted_is_refused_in_a_sentence(shape, sentence):
    with pytest.raises(ShapeError, match=sentence):
        sw.sweep_to_csg(shape)
