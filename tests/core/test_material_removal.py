# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What moves of a tool leave: beside a search at each place, and beside volumes that have formulas."""

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.machining import cells, removal
from sweep_addon.core.machining.lattice import Lattice
from sweep_addon.core.machining.removal import removed

TOOLS = {
    "flat": (sw.machining.FlatEnd(0.02), lambda d: 0.0 * d),
    "ball": (sw.machining.BallNose(0.02), lambda d: 0.01 - np.sqrt(np.maximum(0.01**2 - d**2, 0))),
    "bull": (sw.machining.BullNose(0.02, corner=0.004),
             lambda d: np.where(d < 0.006, 0, 0.004 - np.sqrt(np.maximum(0.004**2 - (d - 0.006) ** 2, 0)))),
    "cone": (sw.machining.Cone(0.02, tip=0.0, angle=np.pi / 2), lambda d: d),
    "blunt": (sw.machining.Cone(0.02, tip=0.006, angle=2 * np.arctan(0.5)), lambda d: 2 * np.maximum(d - 0.003, 0)),
}  # fmt: skip
LATTICE = Lattice.across((-0.03, -0.02), (0.05, 0.04), 0.0021)
TOP = 0.05


def searched(rise, starts, ends):
    """The least height of the tool above each place on each move, by a search that knows nothing but its profile."""
    x, y = (axis.ravel()[:, None] for axis in np.meshgrid(LATTICE.along(0), LATTICE.along(1), indexing="ij"))
    way = ends - starts
    square = np.maximum((way[:, :2] ** 2).sum(axis=1), 1e-300)
    foot = ((x - starts[:, 0]) * way[:, 0] + (y - starts[:, 1]) * way[:, 1]) / square
    beside = np.hypot(x - starts[:, 0] - foot * way[:, 0], y - starts[:, 1] - foot * way[:, 1])
    half = np.sqrt(np.maximum(0.01**2 - beside**2, 0) / square)
    low, high = np.maximum(foot - half, 0), np.minimum(foot + half, 1)
    within = (low <= high) & (beside <= 0.01)

    def height(part):
        away = np.hypot(x - starts[:, 0] - part * way[:, 0], y - starts[:, 1] - part * way[:, 1])
        return starts[:, 2] + part * way[:, 2] + rise(np.minimum(away, 0.01))

    golden = (np.sqrt(5) - 1) / 2
    first, last = low.copy(), high.copy()
    for _ in range(60):  # the height is convex along a move
        one, other = last - golden * (last - first), first + golden * (last - first)
        left = height(one) < height(other)
        first, last = np.where(left, first, one), np.where(left, other, last)
    best = np.minimum(np.minimum(height(low), height(high)), height((first + last) / 2))
    return np.where(within, best, np.inf).min(axis=1).reshape(LATTICE.size)


def random_moves(seed, count=40):
    random = np.random.default_rng(seed)
    starts, ends = (random.uniform((-0.04, -0.03, 0.0), (0.06, 0.05, 0.04), (count, 3)) for _ in range(2))
    ends[::5, 2] = starts[::5, 2]  # level ones
    ends[1::7, :2] = starts[1::7, :2]  # and upright ones
    ends[2::7] = starts[2::7] + random.uniform(-1e-4, 1e-4, ends[2::7].shape)
    return starts, ends


def cut(tool, starts, ends):
    whole = np.full(LATTICE.size, TOP)
    return removed(tool, starts, ends, LATTICE, whole, np.full(LATTICE.size, -1))


@pytest.mark.parametrize("name", TOOLS)
def test_every_place_is_as_low_as_a_search_finds(name):
    tool, rise = TOOLS[name]
    moves = random_moves(1)
    heights, by = cut(tool, *moves)
    expected = np.minimum(searched(rise, *moves), TOP)
    assert np.abs(heights - expected).max() < 1e-9
    assert ((heights < TOP) == (by >= 0)).all() and (expected < TOP).mean() > 0.5


@pytest.mark.parametrize("most", [1, 30])
def test_moves_of_which_few_fit_into_memory_at_once_leave_as_much(most, monkeypatch):
    tool, rise = TOOLS["bull"]
    moves, shared = random_moves(2), []
    monkeypatch.setattr(removal, "shares", lambda counts: shared.append(cells.shares(counts, most)) or shared[-1])
    heights, _ = cut(tool, *moves)
    assert len(shared[0]) > 10 and np.array_equal(np.concatenate(shared[0]), np.unique(np.concatenate(shared[0])))
    assert np.abs(heights - np.minimum(searched(rise, *moves), TOP)).max() < 1e-9


@pytest.mark.parametrize("name", TOOLS)
def test_the_move_that_is_told_is_one_that_leaves_that_height(name):
    tool, _ = TOOLS[name]
    starts, ends = random_moves(3)
    heights, by = cut(tool, starts, ends)
    for move in np.unique(by[by >= 0]):
        alone, _ = cut(tool, starts[[move]], ends[[move]])
        assert np.abs(alone - heights)[by == move].max() < 1e-15


@pytest.mark.parametrize("name", TOOLS)
def test_the_order_of_moves_does_not_matter(name):
    tool, _ = TOOLS[name]
    starts, ends = random_moves(4)
    other = np.random.default_rng(5).permutation(len(starts))
    assert (cut(tool, starts, ends)[0] == cut(tool, starts[other], ends[other])[0]).all()


@pytest.mark.parametrize("name", TOOLS)
def test_splitting_moves_does_not_matter(name):
    tool, _ = TOOLS[name]
    starts, ends = random_moves(6)
    middle = starts + (ends - starts) * np.random.default_rng(7).uniform(0.1, 0.9, (len(starts), 1))
    split = np.concatenate((starts, middle)), np.concatenate((middle, ends))
    assert np.abs(cut(tool, starts, ends)[0] - cut(tool, *split)[0]).max() < 1e-12


@pytest.mark.parametrize("name", TOOLS)
def test_moves_backwards_leave_the_same(name):
    tool, _ = TOOLS[name]
    starts, ends = random_moves(8)
    assert np.abs(cut(tool, starts, ends)[0] - cut(tool, ends, starts)[0]).max() < 1e-12


def removed_by(program, tool, cell=0.0002, tolerance=1e-6):
    """The volume that a program removes, in cubic millimetres."""
    stock = sw.machining.Box(low=(-0.02, -0.02, -0.01), high=(0.03, 0.02, 0.0))
    machined = sw.MachinedStock(program, tool=tool, stock=stock, cell=cell, tolerance=tolerance, attributes=False)
    return 50 * 40 * 10 - machined.mesh().volume() * 1e9


BALL, FLAT = sw.machining.BallNose(0.01), sw.machining.FlatEnd(0.0061)  # whose walls are midway between places
CAP = np.pi * 2**2 * (3 * 5 - 2) / 3  # of a ball of radius 5, 2 high
SEGMENT = 5**2 * np.arccos(3 / 5) - 3 * 4  # of its section


@pytest.mark.parametrize(
    ("program", "tool", "expected", "error"),
    [
        ("F9 G0 X0 Y0 Z5\nG1 Z-2\nG0 Z5", BALL, CAP, 1e-3),
        ("F9 G0 X0 Y0 Z5\nG1 Z-2\nX12\nG0 Z5", BALL, CAP + 12 * SEGMENT, 1e-3),
        ("F9 G0 X0 Y0 Z5\nG1 Z-2\nX9 Y12\nG0 Z5", BALL, CAP + 15 * SEGMENT, 1e-3),
        ("F9 G0 X0 Y0 Z0\nG1 X12 Z-4\nG0 Z5", FLAT, 4 * 12 * 3.05 + np.pi * 3.05**2 * 4, 5e-3),
        ("F9 G0 X0 Y0 Z0\nG1 X0.0001 Z-4\nG0 Z5", FLAT, np.pi * 3.05**2 * 4, 5e-3),
        ("F9 G0 X3 Y0 Z1\nG1 Z-3\nX-9\nG0 Z5", sw.machining.Cone(0.02, tip=0, angle=np.pi / 2),
         np.pi * 3**3 / 3 + 12 * 3**2, 1e-3),
    ],
)  # fmt: skip
def test_what_is_removed_has_the_volume_of_its_formula(program, tool, expected, error):
    assert removed_by(program, tool, 0.0001 if tool is FLAT else 0.0002) == pytest.approx(expected, rel=error)


def test_a_groove_along_an_arc_has_the_volume_of_pappus():
    """A section's area times the way of its centroid, which is the groove's own: full circle, and a half with caps."""
    full = removed_by("F9 G0 X10 Y0 Z5\nG1 Z-2\nG3 I-10\nG0 Z5", BALL)
    assert full == pytest.approx(2 * np.pi * 10 * SEGMENT, rel=1e-3)
    half = removed_by("F9 G0 X10 Y0 Z5\nG1 Z-2\nG2 X-10 R10\nG0 Z5", BALL)
    assert half == pytest.approx(np.pi * 10 * SEGMENT + CAP, rel=1e-3)


def test_finer_chords_of_an_arc_lead_to_the_volume_as_their_tolerance():
    full = 2 * np.pi * 10 * SEGMENT
    errors = [
        abs(removed_by("F9 G0 X10 Y0 Z5\nG1 Z-2\nG3 I-10\nG0 Z5", BALL, tolerance=tolerance) - full) / full
        for tolerance in (1e-3, 1e-4)
    ]
    assert errors[0] > 3 * errors[1]
