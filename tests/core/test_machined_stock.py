# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Machined stock is a solid, however it is cut through, and what is wrong with what it is told is said."""

import gzip
from pathlib import Path

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.machining import cutting
from sweep_addon.core.machining.lattice import Lattice
from sweep_addon.core.machining.remains import remains

M = sw.machining
PROGRAMS = Path(__file__).resolve().parents[1] / "data" / "gcode"
PLATE = M.Box(low=(-0.02, -0.02, -0.004), high=(0.02, 0.02, 0.0))


def is_solid(mesh):
    return not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())


def column_volume(lattice, heights, bottom):
    """The volume below a height that is bilinear between places."""
    inner = np.maximum(heights - bottom, 0)
    cells = (inner[:-1, :-1] + inner[1:, :-1] + inner[:-1, 1:] + inner[1:, 1:]) / 4
    return cells.sum() * np.prod(lattice.step)


@pytest.mark.parametrize("seed", range(12))
def test_what_is_left_of_random_heights_is_a_manifold_of_their_volume(seed):
    """Every way in which parts can meet: along edges, in corners, at the sides of the block."""
    random = np.random.default_rng(seed)
    lattice = Lattice.across((0.0, 0.0), (7.0, 5.0), 1.0)
    heights = random.uniform(0.0, 2.0, lattice.size) * (random.random(lattice.size) < random.uniform(0.2, 0.9))
    left = remains(lattice, heights, 0.0, 3.0)
    mesh = left.mesh()
    assert is_solid(mesh)
    assert mesh.volume() == pytest.approx(column_volume(lattice, heights, 0.0), rel=1e-12)
    triangles, vertices = mesh.triangles, len(mesh.vertices)
    assert len(np.unique(triangles)) == vertices
    around = [len(np.unique(mesh.edges[(mesh.edges == v).any(axis=1)])) - 1 for v in range(vertices)]
    faces = np.bincount(mesh.corners, minlength=vertices)
    assert (faces == around).all()  # each vertex has one ring of faces


def test_a_hole_through_the_stock_is_a_hole():
    drilled = sw.MachinedStock("F9 G0 X0 Y0 Z5\nG1 Z-9\nG0 Z5", tool=M.FlatEnd(0.0062), stock=PLATE, cell=0.0002)
    mesh = drilled.mesh()
    assert is_solid(mesh) and mesh.euler_characteristic() == 0
    assert mesh.volume() == pytest.approx(0.04 * 0.04 * 0.004 - np.pi * 0.0031**2 * 0.004, rel=2e-4)


def test_stock_that_is_cut_in_two_is_two_solids():
    mesh = sw.MachinedStock("F9 G0 X-30 Y1 Z5\nG1 Z-9\nX30", tool=M.FlatEnd(0.003), stock=PLATE).mesh()
    assert is_solid(mesh) and mesh.euler_characteristic() == 4


def test_a_pocket_keeps_the_bottom():
    mesh = sw.MachinedStock("F9 G0 X0 Y0 Z5\nG1 Z-2\nX9", tool=M.BallNose(0.006), stock=PLATE).mesh()
    assert is_solid(mesh) and mesh.euler_characteristic() == 2
    assert mesh.vertices.min(axis=0).tolist() == [-0.02, -0.02, -0.004]
    assert mesh.vertices[:, 2].max() == 0.0


def test_vertices_know_how_deep_they_are_and_by_which_line():
    """Two slots across each other: the deeper one where they meet."""
    program = "F9 G0 X-9 Y0 Z5\nG1 Z-1\nX9\nG0 Z5\nX0 Y-9\nG1 Z-2\nY9"
    mesh = sw.MachinedStock(program, tool=M.FlatEnd(0.0062), stock=PLATE, cell=0.0004).mesh()
    x, y, z = mesh.vertices.T
    depth, line = (mesh.attributes[name] for name in ("depth", "line"))
    top = z > -0.0039
    assert np.allclose(depth[top], -z[top]) and (depth[~top] == 0).all() and (line[~top] == 0).all()
    assert set(np.unique(line)) <= {0, 2, 3, 6, 7}
    middle = top & (np.hypot(x, y) < 0.001)
    assert (line[middle] == 7).all() and np.allclose(depth[middle], 0.002)
    assert (line[top & (np.abs(y) < 0.001) & (np.abs(x - 0.006) < 0.001)] == 3).all()


def test_each_tool_of_a_program_cuts_with_its_own_shape():
    program = "F9 T1 M6\nG0 X-10 Y0 Z5\nG1 Z-2\nG0 Z5\nT2 M6\nX10\nG1 Z-2\nG0 Z5"
    one, other = M.BallNose(0.008), M.Cone(0.008, tip=0, angle=np.pi / 2)
    tools = [(1, one), (2, other)]
    mesh = sw.MachinedStock(program, tools=tools, stock=PLATE, cell=0.0002).mesh()
    removed = 0.04 * 0.04 * 0.004 - mesh.volume()
    assert removed * 1e9 == pytest.approx(np.pi * 2**2 * (3 * 4 - 2) / 3 + np.pi * 2**3 / 3, rel=3e-3)
    assert mesh.told == ()
    told = sw.MachinedStock(program, tools=tools[:1], stock=PLATE).mesh().told
    assert told == ("Tool 2 of the program is not among `tools`: the default one is taken for it.",)


def test_inches_and_millimetres_of_one_part_are_one_part():
    metric = sw.MachinedStock("G21 F9 G0 X0 Y0 Z25.4\nG1 Z-2.54\nX25.4", stock=M.Around(floor=0.001), cell=0.001)
    inches = sw.MachinedStock("G20 F9 G0 X0 Y0 Z1\nG1 Z-0.1\nX1", stock=M.Around(floor=0.001), cell=0.001)
    assert np.allclose(metric.mesh().vertices, inches.mesh().vertices, atol=1e-15)
    assert np.ptp(metric.mesh().vertices[:, 0]) == pytest.approx(0.0254 + 2 * 0.003 + 2 * 0.002)


@pytest.mark.parametrize("name", ["fabex_MedialPocket.gcode", "camotics_wave.gcode", "linuxcnc_blur_torus.ngc"])
def test_real_programs_leave_solids(name):
    program = gzip.open(PROGRAMS / f"{name}.gz", "rt").read()
    mesh = sw.MachinedStock(program, tool=M.BallNose(0.003)).mesh()
    assert is_solid(mesh)
    size = np.prod(np.ptp(mesh.vertices, axis=0))
    assert 0.1 * size < mesh.volume() < 0.999 * size


def test_a_rapid_move_from_an_unknown_place_cuts_nothing():
    """The program does not say from where: it might be from the side, through the stock, or from above."""
    safe = sw.MachinedStock("G0 X9 Y0\nZ1\nF9 G1 Z-1", stock=PLATE, tool=M.FlatEnd(0.002), cell=0.0005)
    depth = safe.mesh().attributes["depth"]
    assert depth.max() == pytest.approx(0.001)
    assert np.hypot(*(safe.mesh().vertices[depth > 0, :2] - (0.009, 0)).T).max() < 0.00101


def test_progress_is_told_and_may_end_the_work():
    class StoppedError(Exception):
        pass

    def stop(part):
        raise StoppedError

    text = "F9 G0 X0 Y0 Z5\nG1 Z-1\n" + "\n".join(f"X{i % 17 - 8} Y{i % 13 - 6}" for i in range(300))
    stock = sw.MachinedStock(text, stock=PLATE)
    with pytest.raises(StoppedError):
        stock.solid(stop)
    parts = []
    assert len(stock.solid(parts.append).vertices) and parts == sorted(parts) and parts[-1] == 1.0


def test_comparing_with_a_part_tells_its_progress_and_may_be_ended():
    """It takes the second half; there are rapid moves that cut, and a part that is cut into."""
    text = "F9 G0 X0 Y0 Z5\nG1 Z-1\n" + "\n".join(f"G{i % 2} X{i % 17 - 8} Y{i % 13 - 6}" for i in range(400))
    part = sw.solids.Triangles.of(sw.solids.Block(0.04, 0.04, 0.002).moved(z=-0.0015).mesh())
    stock = sw.MachinedStock(text, stock=PLATE, part=part, cell=0.0003)
    parts = []
    stock.solid(parts.append)
    assert len({part for part in parts if 0.5 < part < 0.75}) > 3 and len({part for part in parts if part > 0.75}) > 3
    assert parts == sorted(parts) and parts[-1] == 1.0

    class StoppedError(Exception):
        pass

    def stop(part):
        if part > 0.8:
            raise StoppedError

    with pytest.raises(StoppedError):
        stock.solid(stop)


@pytest.mark.parametrize(
    ("program", "cell", "waits"),
    [
        ("F9 G0 X9 Y0 Z0\nG3 I-9 Z-1 P9", 0.001, False),
        ("F9 G0 X9 Y0 Z0\nG3 I-9 Z-1 P9000", 0.001, True),  # with more than ten chords a turn
        ("F9 G0 X9 Y0 Z0\nG3 I-9 Z-1 P9", 0.00007, True),
        ("F9 G0 X9 Y0 Z0\nG3 I-9 Z-1 P9\n" + "(aside)\n" * 20_000, 0.001, True),
    ],
)
def test_a_person_need_not_wait_for_what_takes_long(program, cell, waits):
    assert sw.MachinedStock(program, stock=PLATE, cell=cell).make_solid == waits


@pytest.mark.parametrize(
    ("told", "sentence"),
    [
        ({"program": "G0 X1\nG9.9"}, "program: line 2 has G9.9, which is not known"),
        ({"program": 5}, "program: must be the text of a program, got 5"),
        ({"program": Path("part.nc")}, "program: must be the text of a program, as .read_text() of a path gives, got"),
        ({"program": ""}, "program: must move a tool from a place that is known to another, got a text that does not"),
        ({"program": "G0 X1"}, "program: must move a tool from a place that is known to another, got a text that does"),
        ({"program": "F9 G1 Z1\nX9"}, "stock.top: must be above 0, the lowest Z of the program in metres, got 0"),
        ({"program": "G0 X0 Y0 Z5\nX9 Z1"}, "stock.top: must be above 0.001, the lowest Z of the program in"),
        ({"stock": M.Around(floor=0.001), "cell": 1e-6}, "cell: must make at most 4,000,000 places, got "),
        ({"tolerance": 0}, "tolerance: must be more than 0, got 0"),
        ({"tool": {"kind": "ball-nose", "diameter": 0}}, "tool.diameter: must be more than 0, got 0"),
        ({"tool": {"kind": "bull-nose", "corner": 1}}, "tool.corner: must be at most 0.003, half the diameter, got 1"),
        ({"tool": {"kind": "cone", "tip": 1}}, "tool.tip: must be less than 0.006, the diameter, got 1"),
        ({"tool": "saw"}, "tool: must be one of "),
        ({"tools": [(1, "cone"), (1, "flat-end")]}, "tools.2.number: must be of one tool alone, got 1 again"),
        ({"stock": {"kind": "box", "low": (0, 0, 0), "high": (1, 1, 0)}},
         "stock.high: must be above the lowest corner along each axis, got [1.0, 1.0, 0.0]"),
        ({"program": "F9 G0 X-40 Y0 Z5\nG1 Z-9\nX40", "tool": {"kind": "flat-end", "diameter": 0.2}, "stock": PLATE},
         "program: must leave something of the stock, all of which is cut away"),
    ],
)  # fmt: skip
def test_what_will_not_do_is_refused_in_one_sentence(told, sentence):
    with pytest.raises(sw.ShapeError) as refusal:
        sw.MachinedStock(**told).mesh()
    assert str(refusal.value).startswith(sentence) and "\n" not in str(refusal.value)


def test_a_program_that_is_refused_is_read_once(monkeypatch):
    """It may take seconds, and shapes are made whenever something changes."""
    asked, program = [], "G0 X1\n(of this test alone)\nG9.9"
    monkeypatch.setattr(cutting, "read", lambda text, diameter: asked.append(text) or M.read(text, diameter))
    for _ in range(3):
        with pytest.raises(sw.ShapeError, match=r"^program: line 3 has G9\.9, which is not known$"):
            sw.MachinedStock(program)
    assert asked == [program]


def test_a_job_brings_machined_stock_back():
    shape = sw.MachinedStock(
        "F9 G0 X0 Y0 Z5\n(\"quoted\" 'twice')\nG1 Z-1\n",
        tool=M.BullNose(0.004, corner=0.001),
        tools=[(3, M.Cone())],
        stock=PLATE,
        part=sw.solids.Triangles.of(sw.solids.Block().mesh()),
    )
    assert sw.load(sw.dump(shape)) == shape


def test_stock_is_an_operand_of_trees():
    cut = sw.MachinedStock("F9 G0 X0 Y0 Z5\nG1 Z-2\nX9", stock=PLATE, cell=0.001)
    inside, outside = sw.classify(cut, [(-0.01, 0.01, -0.001), (0.005, 0.0, -0.001)])
    assert (inside, outside) == (1, -1)
