# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Generalized cylinders of a turtle: Hermite curves through control points, and tubes along them."""

import tracemalloc

import numpy as np
import pytest

from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grammars import Budget, LSystem


def figure(axiom, head=""):
    return LSystem.parse(f"{head}\naxiom: {axiom}").derive(0).figure()


def hermite(one, other, leaving, coming, t):
    """In the basis of Hermite, as textbooks have it: Foley, van Dam et al. section 11.2.1."""
    basis = np.array([[2, -2, 1, 1], [-3, 3, -2, -1], [0, 0, 1, 0], [1, 0, 0, 0]])
    return np.array([[u**3, u**2, u, 1] for u in t]) @ basis @ np.array([one, other, leaving, coming])


def test_an_axis_is_the_hermite_curve_through_control_points_along_the_headings():
    """cpfg's tutorial, Generalized Cylinders: tangents are 1.2 times as long as the points are apart."""
    found = figure("@Gs f(3) +(90) f(4) @Ge(10)")
    wanted = hermite((0, 0, 0), (3, 4, 0), (1.2 * 5, 0, 0), (0, 1.2 * 5, 0), np.linspace(0, 1, 11))
    assert len(found) == 10
    assert found.start == pytest.approx(wanted[:-1], abs=1e-14) and found.end == pytest.approx(wanted[1:], abs=1e-14)
    assert (found.axis == 0).all() and (found.order == 0).all()
    assert found.at.tolist() == [3, 4, 0]


def test_tangents_are_as_long_as_they_are_told():
    """``@Gt(in, out)``: the first at points where a curve arrives, the second where one leaves; one number is both."""
    found = figure("@Gt(0.5) @Gs f(2) +(90) @Gt(2, 3) f(2) @Gc(4) F(1) @Ge(1)")
    apart = 8**0.5
    wanted = hermite((0, 0, 0), (2, 2, 0), (0.5 * apart, 0, 0), (0, 2 * apart, 0), [0, 0.25, 0.5, 0.75, 1])
    assert found.end[:4] == pytest.approx(wanted[1:], abs=1e-14)
    assert found.end[4].tolist() == [2, 3, 0] and len(found) == 5


def test_lines_within_a_cylinder_are_drawn_by_its_curves_alone():
    found = figure("F @Gs F F @Gc(2) +(90) F @Ge(3) F")
    assert len(found) == 1 + 2 + 3 + 1
    assert found.end[[0, 2, 5, 6]].tolist() == [[1, 0, 0], [3, 0, 0], [3, 1, 0], [3, 2, 0]]
    assert found.axis.tolist() == [0, 1, 1, 1, 1, 1, 1]  # the cylinder is an axis of its own, and what follows goes on
    assert found.parent.tolist() == [-1, 0, 1, 2, 3, 4, 5]


def test_branches_go_on_from_the_last_control_point_before_them():
    found = figure("@Gs F @Gc(1) [+(90) F @Ge(2)] F @Ge(1)")
    assert found.start[[0, 1, 3]].tolist() == [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
    assert found.end[[0, 2, 3]].tolist() == [[1, 0, 0], [1, 1, 0], [2, 0, 0]]
    assert found.axis.tolist() == [0, 1, 1, 0] and found.order.tolist() == [0, 1, 1, 0]


def test_curves_taper_evenly_from_one_control_point_to_the_next():
    found = figure("!(1) @Gs F !(0.5) @Gc(4) F !(0.1) @Ge(2)")
    assert found.width == pytest.approx([1, 0.875, 0.75, 0.625, 0.5, 0.3], rel=1e-14)
    assert found.tip[-1] == pytest.approx(0.1)
    radius = found.mesh(sides=6).attributes["radius"]
    assert (radius.max(), radius.min()) == pytest.approx((0.5, 0.05))


def test_a_tube_along_a_curve_is_closed_and_as_large_as_its_axis_is_long():
    """Pappus, Weyl: a tube's volume is its section's area times the length of its axis, to the order of its chords."""
    volumes = []
    for count in (20, 40):
        mesh = figure(f"!(0.2) @Gs f(3) +(90) &(30) f(4) @Ge({count})").mesh(sides=32)
        assert (
            not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges()) and mesh.euler_characteristic() == 2
        )
        volumes.append(mesh.volume())
    t = np.linspace(0, 1, 20_001)
    heading = np.array([0, np.cos(np.pi / 6), -np.sin(np.pi / 6)])
    start = figure("f(3) +(90) &(30) f(4)").at
    apart = np.linalg.norm(start)
    axis = hermite((0, 0, 0), start, (1.2 * apart, 0, 0), 1.2 * apart * heading, t)
    length = np.linalg.norm(np.diff(axis, axis=0), axis=1).sum()
    area = 16 * 0.1**2 * np.sin(2 * np.pi / 32)
    error = [abs(volume / (area * length) - 1) for volume in volumes]
    assert error[1] < 2e-3 and error[1] < error[0] / 3


def test_a_straight_cylinder_is_straight():
    found = figure("@Gs F F F @Ge(5)", "#angle 30")
    assert found.end[:, 1:].tolist() == [[0, 0]] * 5 and found.end[-1, 0] == 3 and (np.diff(found.end[:, 0]) > 0).all()


def test_marks_without_beginning_begin_where_they_stand():
    found = figure("F @Ge(3) F @Gc F @Ge(2)")
    assert len(found) == 2 + 2 and found.end[-1].tolist() == [3, 0, 0]


def test_a_control_point_on_the_last_one_adds_nothing():
    mesh = figure("@Gs @Gc(2) F @Ge(3)").mesh(sides=5)
    assert np.isfinite(mesh.vertices).all() and mesh.euler_characteristic() == 2


@pytest.mark.parametrize("count", ["0", "0.5", "1001", "-3"])
def test_counts_of_segments_have_limits(count):
    with pytest.raises(ShapeError, match="must ask for 1 to 1000 segments"):
        figure(f"@Gs F @Ge({count})")


def test_births_and_homomorphisms_reach_the_segments_of_a_curve():
    system = LSystem.parse("axiom: @Gs A\nA -> IA\nhomomorphism:\nI -> f @Gc(2)")
    found = system.derive(3).figure()
    assert found.birth.tolist() == [3] * 6  # those of the homomorphism, which the last step makes
    assert found.end[1::2, 0].tolist() == [1, 2, 3]


def test_segments_are_weighed_before_they_are_made():
    word = LSystem.parse("axiom: @Gs " + "f(1)@Gc(1000)" * 500).derive(0)
    tracemalloc.start()
    with pytest.raises(ShapeError, match="^figure: must take at most 1,000,000 bytes, but needs about 1"):
        word.figure(budget=Budget(bytes=1_000_000))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 1_000_000
