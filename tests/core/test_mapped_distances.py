# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances from contours that stand scaled or leaning: never more than that from any place of the curve."""

import numpy as np
import pytest

from sweep_addon import contours
from sweep_addon.core.membership.plane.figures import mapped
from sweep_addon.core.membership.plane.loops import Loops
from sweep_addon.core.membership.plane.regions import Level
from sweep_addon.core.membership.plane.smooth import Superdisc
from sweep_addon.core.membership.plane.strands import Strands
from sweep_addon.core.membership.plane.swathes import Swathe

MAPS = {
    "as it is": ((1, 0), (0, 1)),
    "flat": ((1, 0), (0, 0.1)),
    "narrow": ((0.1, 0), (0, 1)),
    "leaning": ((0.3, 0.9), (0, 0.8)),
}
# points and the bulges after them
WASHER = np.array([(-1.2, 0, 1), (1.2, 0, 1), (1, 0, -1), (-1, 0, -1)])
NOTCH = np.array([(-1, 0, 0), (-1, -1.5, 0), (1, -1.5, 0), (1, 0, -1)])
KEYHOLE = np.array([(-0.2, -1, 0), (0.2, -1, 0), (0.2, 0, 2.5), (-0.2, 0, 0)])
FIGURES = {
    "washer": Loops.of(WASHER[:, :2], np.array([0, 2, 4]), WASHER[:, 2]),
    "notch": Loops.of(NOTCH[:, :2], np.array([0, 4]), NOTCH[:, 2]),
    "keyhole": Loops.of(KEYHOLE[:, :2], np.array([0, 4]), KEYHOLE[:, 2]),
    "arc": Strands(np.array([(1.0, 0.0)]), np.array([(0.0, 1.0)]), np.array([0.4])),
    "two lines": Strands(np.array([(0.0, 0.0), (1.0, -0.6)]), np.array([(0.0, 1.0), (1.0, 0.6)]), np.zeros(2)),
}


def along(start, end, bulge, count=1001):
    """Places of a line, or of the arc in which all see its ends under one angle: (count, 2)."""
    share = np.linspace(0, 1, count)
    quarter = np.arctan(bulge)
    first, last = complex(*start), complex(*end)
    if not bulge:
        found = first + share * (last - first)
    else:
        middle = (first + last) / 2 + 1j * (last - first) / 2 / np.tan(2 * quarter)
        found = middle + (first - middle) * np.exp(4j * quarter * share)
    return np.stack((found.real, found.imag), axis=1)


def superellipse(half, exponent, count=2001):
    angle = np.linspace(0, np.pi / 2, count)
    with np.errstate(divide="ignore"):
        logs = np.log(np.abs(np.stack((np.cos(angle), np.sin(angle)))))
    ratio = (np.exp(exponent * logs)).sum(axis=0) ** (-1 / exponent)
    quarter = (ratio * np.exp(logs)).T * half
    signs = np.array([(1, 1), (-1, 1), (1, -1), (-1, -1)])
    return (signs[:, None] * quarter).reshape(-1, 2)


def told(region, matrix, points):
    return mapped(region, points, np.zeros(len(points)), np.tile(np.array(matrix, dtype=float), (len(points), 1, 1)))


def away(places, matrix, points):
    """The least distance from some places where a matrix takes all: (n,)."""
    space, curve = points @ np.transpose(matrix), places @ np.transpose(matrix)
    return np.array([np.hypot(*(curve - point).T).min() for point in space])


@pytest.mark.parametrize("how", MAPS)
@pytest.mark.parametrize("name", FIGURES)
def test_no_distance_from_mapped_lines_and_arcs_is_more_than_that_from_any_of_their_places(name, how):
    figure, matrix = FIGURES[name], MAPS[how]
    edges = getattr(figure, "edges", figure)
    places = np.concatenate([along(*edge) for edge in zip(edges.start, edges.end, edges.bulges, strict=True)])
    points = np.random.default_rng(6).uniform(-2, 2, (300, 2))
    far = np.abs(told(figure, matrix, points))
    least = away(places, matrix, points)
    assert (far <= least + 1e-12).all() and (far > 1e-3 * least).all()


@pytest.mark.parametrize("how", MAPS)
@pytest.mark.parametrize("side", [-1, 1])
def test_the_distance_from_a_mapped_arc_is_to_first_order_on_both_of_its_sides(how, side):
    """Of an ellipse, by how its equation x . x = 1 of the circle grows."""
    matrix, figure = np.array(MAPS[how], dtype=float), FIGURES["arc"]
    angle = np.linspace(0.1, 1.4, 50)
    middle = along(*(part[0] for part in (figure.edges.start, figure.edges.end, figure.edges.bulges)), 3)[1]
    turn = 4 * np.arctan(0.4)
    radius = np.sqrt(0.5) / np.sin(turn / 2)
    spokes = np.stack((np.cos(np.pi / 4 + turn * (angle / 1.5 - 0.5)), np.sin(np.pi / 4 + turn * (angle / 1.5 - 0.5))))
    centre = middle - radius * np.sqrt(0.5)
    outward = np.linalg.inv(matrix).T @ spokes
    outward /= np.hypot(*outward)
    points = centre + radius * spokes.T + side * 1e-5 * (np.linalg.inv(matrix) @ outward).T
    assert np.abs(told(figure, matrix, points) - 1e-5).max() < 1e-8


@pytest.mark.parametrize("exponent", [1.0, 1.05, 1.3, 1.9, 2.0, 3.0, 60.0])
@pytest.mark.parametrize("how", MAPS)
def test_no_distance_from_a_superellipse_is_more_than_that_from_any_of_its_places(exponent, how):
    matrix, half = MAPS[how], (1.0, 0.6)
    disc, places = Superdisc(half, exponent), superellipse(half, exponent)
    random = np.random.default_rng(7).uniform(-1.3, 1.3, (150, 2)) * half
    points = np.concatenate((random, random * (1e-4, 1), random * (1, 1e-4)))
    far, least = np.abs(told(disc, matrix, points)), away(places, matrix, points)
    assert (far <= least + 1e-12).all() and (far > 0.05 * least).all()
    fair = np.abs(disc.fair(*points.T))
    assert (fair <= away(places, np.eye(2), points) + 1e-12).all()


def test_a_formula_that_stands_still_somewhere_is_told_without_an_overflow():
    """In the middle of the slit the formula has no slope."""
    formula = contours.Region("max(max(abs(x) - 0.3, abs(y) - 0.3), 4*(0.0025 - y^2))", 1.0)
    region, points = Level(formula, 1.0), np.array([(0.0, 0.0), (0.1, 0.0), (0.0, 0.1)])
    with np.errstate(over="raise", invalid="raise"):
        far = region.distance(points, np.zeros(3))
        flat = told(region, MAPS["flat"], points)
    assert (far[:2] > 0).all() and (far[:2] <= 0.05).all() and -0.05 <= far[2] < 0
    assert (np.abs(flat) <= 0.1 * np.array((0.05, 0.05, 0.05)) + 1e-12).all() and flat[2] < 0


def test_a_lattice_is_that_of_the_level_that_is_asked_for():
    """Of one tolerance there may be several levels."""
    line = Loops(np.array([(0.0, 0.0)]), np.array([(0.0, 1.0)]), np.zeros(1), np.zeros(1, dtype=int))
    swathe = Swathe(line, None, np.zeros(2), np.zeros(2))
    point = np.array([(3.0, 0.5)])
    near, far = (swathe.lattice(level, 0.25) for level in (0.0, 3.0))
    assert near.least(swathe.apart, point) == np.inf and far.least(swathe.apart, point) == 3.0
