# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Assemblies are taken apart in the orders that are possible, and in no others."""

import pytest
from contour_inputs import OUTLINES, drawn
from planted_assemblies import bayonet, shelled

import sweep_addon as sw
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.solids import Ball, Block, Cylinder

pytest.importorskip("fcl", reason="removal paths are asked of python-fcl")
pytest.importorskip("manifold3d", reason="the solids of assemblies are made by it")


def names(taken):
    return [name for name, _ in taken.order]


def test_a_stack_in_a_box_comes_out_from_above():
    box = Block(1, 1, 1) - Block(0.8, 0.8, 1.0).moved(z=0.1)
    slices = {f"slice {i}": Block(0.8, 0.8, 0.2).moved(z=-0.3 + 0.2 * i) for i in range(4)}
    taken = sw.disassembly({**slices, "box": box})
    assert taken and names(taken) == ["slice 3", "slice 2", "slice 1", "slice 0"]
    assert taken.stays == ("box",)
    assert taken.blocking["slice 0"] == ("slice 1", "box")
    assert all(path.legs[0].way[2] > 0 and len(path.legs) == 1 for _, path in taken.order)


def test_a_pin_that_holds_two_parts_comes_first():
    """Neither plate slides off the other while the pin is in both."""
    hole = Cylinder(0.1, 3.0)
    rail, key = Block(1, 1, 0.4), Block(0.4, 1.2, 0.2)
    outer, inner = rail - key - hole, Block(0.4, 1.0, 0.2) - hole
    taken = sw.disassembly({"outer": outer, "inner": inner, "pin": Cylinder(0.1, 0.5)})
    assert names(taken)[0] == "pin"
    assert taken.blocking["inner"] == ("outer", "pin")


@pytest.mark.thorough
def test_parts_that_do_not_come_apart_are_named():
    part, others = shelled()
    taken = sw.disassembly({"kernel": part, **others, "pebble": Ball(0.1).moved(x=2.0)}, budget=500)
    assert not taken
    assert names(taken) == ["pebble"] and set(taken.stays) == {"kernel", "shell"}
    assert str(taken) == "In this order: pebble; no way out was found for any of kernel, shell"


@pytest.mark.thorough
def test_a_part_that_must_turn_is_taken_out_when_no_other_is_left():
    plug, others = bayonet()
    taken = sw.disassembly({"plug": plug, **others, "cap": Cylinder(0.2, 0.1, points=16).moved(z=0.55)})
    assert taken and names(taken)[0] == "cap"
    assert len(taken.order[1][1].legs) == 2


@pytest.mark.parametrize("number", range(0, len(OUTLINES), len(OUTLINES) // 4))
def test_a_lid_of_a_real_outline_gets_out_of_its_plate_across_it_alone(number):
    """It fills the hole; in the plane it is held all round."""
    outline = drawn(OUTLINES[number], tolerance=0.05)
    lid = TranslationalSweep(outline, height=2.0)
    low, high = lid.mesh().vertices.min(axis=0), lid.mesh().vertices.max(axis=0)
    width, depth, _ = high - low + 4.0
    x, y, _ = (low + high) / 2
    plate = Block(width, depth, 2.0).moved(x=x, y=y, z=1.0) - TranslationalSweep(outline, height=4.0).moved(z=-1.0)
    path = sw.removal_path(lid, {"plate": plate})
    (leg,) = path.legs
    assert abs(leg.way[2]) == pytest.approx(2.0, rel=0.1) and abs(leg.way[:2]).max() < 1e-6


def test_parts_that_overlap_are_refused_by_both_names():
    with pytest.raises(sw.ShapeError, match="^other: overlaps one by 0.2 m as it stands, at "):
        sw.disassembly({"one": Block(), "other": Block().moved(x=0.2, y=0.1)})


def test_one_part_alone_is_no_assembly():
    with pytest.raises(sw.ShapeError, match="^parts: must have two parts or more, got 1"):
        sw.disassembly([Block()])
