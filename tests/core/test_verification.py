# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Verifying programs: what is planted is found, by the lines that do it, and nothing else."""

import gzip
from pathlib import Path

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.machining import cells, gouging
from sweep_addon.core.machining.lattice import Lattice
from sweep_addon.core.machining.part import top_of

M = sw.machining
PROGRAMS = Path(__file__).resolve().parents[1] / "data" / "gcode"
PLATE = M.Box(low=(-0.03, -0.03, -0.012), high=(0.03, 0.03, 0.0))
RASTER = ["F9 G0 X-26 Y-26 Z5", "G1 Z-2"]
for row in range(-26, 27, 2):
    RASTER += [f"Y{row}", f"X{26 if row % 4 else -26}"]
RASTER += ["G0 Z5"]


def stock(lines, **told):
    program = lines if isinstance(lines, str) else "\n".join(lines)
    return sw.MachinedStock(program, **{"tool": M.FlatEnd(0.006), "stock": PLATE, "cell": 0.0006} | told)


def itself(machined):
    """The part that a program makes: what it leaves."""
    return machined.mesh()


def test_a_program_makes_the_part_that_it_leaves():
    found = stock(RASTER).verify(itself(stock(RASTER)))
    assert found.correct and found.gouged_volume == 0 and found.gouge == 0
    assert found.excess_volume == 0 and found.sentences() == ("Nothing is left beside the part.",)
    assert np.abs(found.deviation).max() < 1e-12


@pytest.fixture
def needs_manifold3d():
    """The part is a tree, whose mesh manifold3d makes."""
    pytest.importorskip("manifold3d")


@pytest.mark.parametrize("line", [5, 20, 41])
def test_a_move_that_is_a_tenth_of_a_millimetre_lower_is_found_and_only_that(line):
    part = itself(stock(RASTER))
    lowered = list(RASTER)
    lowered[line - 1] += " Z-2.1"
    lowered[line] += " Z-2"
    found = stock(lowered).verify(part)
    assert not found.correct and found.gouge == pytest.approx(1e-4, abs=1e-9)
    assert min(found.gouging) == line and set(found.gouging) <= {line, line + 1}
    assert found.gouging[line] == pytest.approx(1e-4, abs=1e-9)
    assert found.rapid == {} == found.below and found.outside == 0


@pytest.mark.parametrize(
    "tool", [M.FlatEnd(0.006), M.BallNose(0.006), M.BullNose(0.006, corner=0.001), M.Cone(0.006, tip=0.001)]
)
def test_a_plunge_into_the_part_has_its_depth_and_place(tool):
    part = sw.solids.Block(0.06, 0.06, 0.01).moved(z=-0.007)  # its top at -2 mm
    found = stock([*RASTER, "X9 Y-12", "G1 Z-3.5", "G0 Z5"], tool=tool).verify(part)
    assert list(found.gouging) == [len(RASTER) + 2]
    assert found.gouge == pytest.approx(0.0015, abs=1e-12)
    assert np.hypot(found.where[0] - 0.009, found.where[1] + 0.012) <= 0.003 + 1e-9
    x, y = (
        axis.ravel()
        for axis in np.meshgrid(np.linspace(-0.03, 0.03, 101), np.linspace(-0.03, 0.03, 101), indexing="ij")
    )
    away = np.hypot(x - 0.009, y + 0.012).reshape(found.deviation.shape)
    assert (found.deviation[away < 0.0005] < 0).all() and (found.deviation[away > 0.0031] >= -1e-12).all()


def slot_beside_its_part(raised, **told):
    """A slot 2 mm deep with round ends, whose part has its floor so much higher, at places on the walls themselves."""
    hole = sw.TranslationalSweep(sw.contours.Rectangle(0.026, 0.006, rounding=0.003, corner_points=64), 0.01)
    part = sw.solids.Block(0.06, 0.06, 0.012).moved(z=-0.006) - hole.moved(z=-0.002 + raised)
    return stock(["F9 G0 X-10 Y0 Z5", "G1 Z-2", "X10", "G0 Z5"], cell=0.0005, **told).verify(part)


@pytest.mark.parametrize("raised", [3e-5, 1e-3])
def test_places_on_walls_are_as_deep_as_the_floor_beside_them(raised, needs_manifold3d):
    found = slot_beside_its_part(raised)
    assert found.gouge == pytest.approx(raised, abs=1e-12) and found.deviation.min() == -found.gouge
    assert found.gouged_volume == pytest.approx((0.02 * 0.006 + np.pi * 0.003**2) * raised, rel=0.05)
    assert found.gouging == {line: pytest.approx(raised, abs=1e-12) for line in (2, 3)}
    assert np.abs(slot_beside_its_part(0.0).deviation).max() < 1e-12


@pytest.mark.thorough
def test_what_is_cut_by_more_than_the_allowance_is_wrong_and_by_less_is_not(needs_manifold3d):
    more, less = slot_beside_its_part(2.1e-5), slot_beside_its_part(1.9e-5)
    assert not more.correct and more.gouge == pytest.approx(2.1e-5) and set(more.gouging) == {2, 3}
    assert more.sentences()[0].startswith("The program cuts up to 0.021 mm into the part, 3 mm3, deepest at ")
    assert less.correct and less.gouge == less.gouged_volume == 0 and less.gouging == {}
    exact = slot_beside_its_part(0.0, allowance=0.0)
    assert exact.correct and exact.gouge == 0
    assert not slot_beside_its_part(1e-6, allowance=0.0).correct


def test_many_moves_that_each_cut_a_little_deeper_are_told_by_the_whole_depth():
    """One line whose arcs go down by 5 micrometres a chord."""
    part = sw.solids.Block(0.06, 0.06, 0.0115).moved(z=-0.00625)  # its top half a millimetre deep
    helix = ["F9 G0 X0 Y0 Z5", "G1 Z-.5", "G3 X0 Y0 Z-1 I1", "G0 Z5"]
    found = stock(helix, tolerance=1e-7).verify(part)
    assert found.gouge == pytest.approx(0.0005, rel=0.02) and found.gouging == {3: pytest.approx(found.gouge, rel=0.02)}


def test_the_depth_of_a_cut_into_a_slope_is_that_at_the_place():
    """A ball 0.1 mm too low along a roof of 20 degrees."""
    corners = [(x, y, z) for x in (-0.03, 0.03) for y, z in ((-0.03, -0.012), (0.03, -0.012), (0.0, -0.001))]
    faces = [(0, 2, 1), (3, 4, 5), (0, 3, 5), (0, 5, 2), (4, 1, 2), (4, 2, 5), (0, 1, 4), (0, 4, 3)]
    slope = 0.011 / 0.03
    lines = ["F9 G0 X0 Y-20 Z5"] + [
        f"G1 Y-20 Z{1e3 * (-0.012 + 0.01 * slope + 0.003 * (np.hypot(1, slope) - 1)) - 0.1}",
        f"Y-5 Z{1e3 * (-0.012 + 0.025 * slope + 0.003 * (np.hypot(1, slope) - 1)) - 0.1}",
        "G0 Z5",
    ]
    found = stock(lines, tool=M.BallNose(0.006)).verify(sw.solids.Triangles(corners, faces))
    assert found.gouge == pytest.approx(1e-4, rel=1e-6)


def test_volumes_beside_a_part_are_those_of_the_difference():
    """A pocket 1 mm too deep on one half of it, and 0.5 mm too shallow on the other."""
    flat, deep = ["F9 G0 X-20 Y0 Z5", "G1 Z-3", "X0 Z-3", "G0 Z5"], ["X0.0", "G1 Z-1.5", "X20", "G0 Z5"]
    part = sw.solids.Block(0.06, 0.06, 0.010).moved(z=-0.007)
    ball = stock([*flat, *deep], tool=M.FlatEnd(0.0062), cell=0.0002)
    found = ball.verify(part)
    round_slot = 20 * 6.2 + np.pi * 3.1**2 / 2
    assert found.gouged_volume * 1e9 == pytest.approx(1.0 * (round_slot + np.pi * 3.1**2 / 2), rel=5e-3)
    total = 60 * 60 * 2 - 2 * (round_slot + np.pi * 3.1**2 / 2) - 1.5 * (20 * 6.2)
    assert found.excess_volume * 1e9 == pytest.approx(total, rel=2e-3)
    assert found.excess == pytest.approx(0.002) and set(found.gouging) == {2, 3}


def test_rapid_moves_through_what_is_still_there_are_told_and_through_what_is_gone_are_not():
    there = ["F9 G0 X-20 Y0 Z5", "G1 Z-2", "X20"]
    back = stock([*there, "G0 X-20", "Z5"]).verify()
    assert back.correct and back.rapid == {}
    aside = stock([*there, "G0 Y9", "Z5"]).verify()
    assert aside.rapid == {4: pytest.approx(0.002)} and not aside.correct
    before = stock(["F9 G0 X-20 Y0 Z5", "X20 Z-1", "G1 X-20 Z-2"]).verify()
    assert before.rapid == {2: pytest.approx(0.001)}
    sunk = stock(["F9 G0 X0 Y0 Z5", "Z-1", "Z5", "G1 Z-3"]).verify()
    assert sunk.rapid == {2: pytest.approx(0.001)}


def test_moves_of_which_few_fit_into_memory_at_once_are_told_by_the_same_lines(monkeypatch):
    """The second tool comes back fast through what the first has cut, and goes aside through what stands."""
    monkeypatch.setattr(gouging, "shares", lambda counts: cells.shares(counts, 10))
    there = ["F9 T1 M6", "G0 X0 Y-20 Z5", "G1 Z-2", "Y20", "T2 M6", "G0 Y-20", "X9", "Z5"]
    found = stock(there, tools=[(1, M.FlatEnd(0.006)), (2, M.FlatEnd(0.005))]).verify(
        sw.solids.Block(0.06, 0.06, 0.0105).moved(z=-0.00675)
    )
    assert found.rapid == {7: pytest.approx(0.002)}
    assert found.gouging == {line: pytest.approx(0.0005) for line in (3, 4, 7)}


def test_a_part_may_be_cut_into_by_as_much_as_the_stock_says():
    part = sw.solids.Block(0.06, 0.06, 0.0105).moved(z=-0.00675)  # its top half a millimetre above what is cut
    lines = ["F9 G0 X0 Y-19 Z5", "G1 Z-2", "Y20", "G0 Z5"]
    assert list(stock(lines).verify(part).gouging) == [2, 3]
    assert M.verify(stock(lines, allowance=0.0006), part).correct
    assert not M.verify(stock(lines, allowance=0.0006), part, allowance=0.0004).correct


def test_rapid_moves_along_walls_that_are_cut_already_do_not_cut():
    """A pocket by a circle, left and entered again at the speed of rapid moves, beside its wall."""
    pocket = ["F9 G0 X0 Y0 Z5", "G1 Z-2", "G1 X10", "G3 I-10", "G0 Z5", "X0 Y10", "Z-2", "G3 I0 J-10 F9", "G0 Z5"]
    pocket[7] = "G1 X0 Y10"
    assert stock(pocket, tolerance=1e-6).verify().rapid == {}


def test_each_tool_is_verified_with_its_own_shape():
    program = ["F9 T1 M6", "G0 X-10 Y0 Z5", "G1 Z-2", "G0 Z5", "T2 M6", "X10", "G0 Z-2", "Z5"]
    tools = [(1, M.BallNose(0.008)), (2, M.Cone(0.008, tip=0, angle=np.pi / 2))]
    assert stock(program, tools=tools).verify().rapid == {
        7: pytest.approx(0.002, abs=3e-4)
    }  # at the place next to the tip
    again = [*program[:5], "X-10", "G0 Z-2", "Z5"]
    assert stock(again, tools=[tools[0], (2, M.BallNose(0.006))]).verify().rapid == {}  # within what the first has cut


def test_a_move_below_the_stock_is_told_where_it_is_above_or_in_it_alone():
    found = stock(["F9 G0 X0 Y0 Z5", "G1 Z-13", "G0 Z5", "X60", "G1 Z-20", "G0 Z5"], tool=M.FlatEnd(0.002)).verify()
    assert found.below == {2: pytest.approx(0.001), 3: pytest.approx(0.001)} and not found.correct


def test_a_part_that_reaches_out_of_the_stock_is_told():
    found = stock(RASTER).verify(sw.solids.Block(0.07, 0.02, 0.004).moved(z=-0.01))
    assert found.outside == pytest.approx(0.005) and not found.correct
    assert found.sentences()[0] == "The part reaches 5 mm out of the stock."


def test_the_part_of_the_shape_itself_is_told_and_kept_at_each_vertex():
    told = stock([*RASTER, "X9 Y-12", "G1 Z-3.5", "G0 Z5"], part=sw.solids.Triangles.of(itself(stock(RASTER))))
    mesh = told.mesh()
    assert mesh.told[0].startswith("The program cuts up to 1.5 mm into the part, ") and ", by line 59." in mesh.told[0]
    deviation = mesh.attributes["deviation"]
    assert deviation.min() == pytest.approx(-0.0015) and (deviation == 0).sum() < len(deviation)
    assert np.hypot(*(mesh.vertices[deviation < -1e-4, :2] - (0.009, -0.012)).T).max() < 0.0031


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["fabex_MedialPocket.gcode", "camotics_wave.gcode"])
def test_a_real_program_with_one_lowered_line_is_found_by_that_line(name):
    lines = gzip.open(PROGRAMS / f"{name}.gz", "rt").read().splitlines()
    told = {"tool": M.BallNose(0.003), "stock": M.Around(floor=0.004), "cell": 0.0}
    right = sw.MachinedStock("\n".join(lines), **told)
    path = M.read(right.program)
    deep = [move for move in range(len(path)) if path.kinds[move] == 1 and path.points[move, 2] < -5e-4]
    line = int(path.lines[deep[len(deep) // 2]])
    place = path.points[deep[len(deep) // 2]] * 1e3
    plunge = [f"G91 G1 Z-1 F9 (deeper than {place[2]:.3f})", "Z1", "G90"]
    wrong = sw.MachinedStock("\n".join([*lines[:line], *plunge, *lines[line:]]), **told)
    found = wrong.verify(right.mesh())
    assert set(found.gouging) <= {line + 1, line + 2} and found.gouging
    assert np.hypot(found.where[0] - place[0] / 1e3, found.where[1] - place[1] / 1e3) < 0.0016


def test_the_height_of_a_part_is_that_of_its_highest_face():
    """A ball and a block under it, seen from above, beside their formulas."""
    lattice = Lattice.across((-1.0, -1.0), (1.0, 1.0), 0.05)
    ball = sw.solids.Ball(0.5, points=512).mesh()
    x, y = np.meshgrid(lattice.along(0), lattice.along(1), indexing="ij")
    away = np.hypot(x, y)
    height = top_of(ball.vertices, ball.triangles, lattice)
    assert np.isneginf(height[away > 0.5001]).all()
    inner = away < 0.49
    assert np.abs(height - np.sqrt(np.maximum(0.25 - away**2, 0)))[inner].max() < 2e-4
    block = sw.solids.Block(1.0, 2.0, 0.4).mesh()
    height = top_of(block.vertices, block.triangles, lattice)
    assert (height[np.abs(x) < 0.5 + 1e-12] == 0.2).all() and np.isneginf(height[np.abs(x) > 0.5001]).all()


def test_a_part_that_is_inside_out_or_open_is_the_same_part():
    block = sw.solids.Triangles.of(sw.solids.Block(0.04, 0.04, 0.008).mesh())
    corners = block.vertices.values + (0, 0, -0.006)
    outward = stock(RASTER).verify(sw.solids.Triangles(corners, block.faces))
    inward = stock(RASTER).verify(sw.solids.Triangles(corners, block.faces.values[:, ::-1]))
    top = block.faces.values[(corners[block.faces.values.astype(int), 2] > -0.003).all(axis=1)]
    sheet = stock(RASTER).verify(sw.solids.Triangles(corners, top))
    assert np.array_equal(outward.deviation, inward.deviation) and np.array_equal(outward.deviation, sheet.deviation)
    assert (
        len(top) == 2 and outward.correct and outward.excess == pytest.approx(0.012)
    )  # all of the plate, beside the part


@pytest.mark.parametrize(
    ("part", "sentence"),
    [
        (5, "part: must be a mesh, a shape, a solid or a tree, got 5"),
        (sw.Plant("axiom: f", output="edges"), "part: must have faces, got none"),
    ],
)
def test_what_is_no_part_is_refused(part, sentence):
    with pytest.raises(sw.ShapeError, match=f"^{sentence}$"):
        stock(RASTER).verify(part)


NO_PART = "There was no part to compare with."


@pytest.mark.parametrize(
    ("program", "told", "sentences"),
    [
        ("F9 G0 X0 Y0 Z5\nX9 Z1\nG1 Y9", {}, (NO_PART, "Nothing of the stock is cut: no move comes into it.")),
        ("F9 G0 X0 Y0 Z5\nG1 Z-1", {}, (NO_PART,)),
        ("F9 T4 M6\nG0 X0 Y0 Z5\nG1 Z-1", {}, (NO_PART,)),
        ("F9 T4 M6\nG0 X0 Y0 Z5\nG1 Z-1", {"tools": [(1, M.FlatEnd())]},
         (NO_PART, "Tool 4 of the program is not among `tools`: the default one is taken for it.")),
        ("F9 G0 X0 Y0 Z5\nG1 Z-1", {"tool": M.FlatEnd(3)},
         (NO_PART, "A tool is 3 m wide, the stock 0.06 m: lengths are in metres.")),
        ("F9 G0 X0 Y0 Z5\nG1 Z-1", {"tool": M.FlatEnd(3), "stock": M.Around(), "cell": 0},
         (NO_PART, "A tool is 3 m wide, no mill is as wide: lengths are in metres.")),
    ],
)  # fmt: skip
def test_what_may_not_be_meant_is_told_beside_what_is_right(program, told, sentences):
    machined = stock(program, **told)
    found = machined.verify()
    assert found.correct and found.sentences() == sentences
    assert machined.mesh().told == sentences[1:]


@pytest.mark.parametrize("part", [sw.solids.Block(), sw.solids.Block().mesh(), "block", {"kind": "block"}])
def test_a_shape_as_the_part_of_the_stock_is_told_what_can_be_said_instead(part):
    with pytest.raises(sw.ShapeError) as refusal:
        stock(RASTER, part=part)
    said = str(refusal.value)
    assert "must be one of unknown, triangles, got " in said and "\n" not in said
    assert all(way in said for way in (".verify(part)", "--part", "Triangles.of(part.mesh())", '{ file = "part.blend"'))


def test_what_is_no_stock_is_refused():
    with pytest.raises(sw.ShapeError, match="^stock: must be machined stock, got Block"):
        M.verify(sw.solids.Block())
