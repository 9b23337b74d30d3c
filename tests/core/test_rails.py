# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rails turn the contour and set its width: it touches both, and its volume is that of the body between them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solids import assert_solid

import sweep_addon as sw
from sweep_addon.core.contours import Aerofoil, Circle, Outline, Rectangle
from sweep_addon.core.declared.forms import python_source
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.frames import Frenet
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Arc, Bezier, Formula, Helix, Line, Polyline

UP = Line(end=(0, 0, 3))
TURN = 2 * np.pi
SPREADING = [Line((1, 0, 0), (2, 0, 3)), Line((-1, 0, 0), (-2, 0, 3))]
TRIANGLE = Outline([[(0.3, -0.2), (0.1, 0.4), (-0.5, 0.1)]])


def test_the_x_axis_points_at_a_rail():
    """A rail that winds once round the trajectory turns a rectangle once: e2 is its direction."""
    frames = GeneralizedCylinder(
        Rectangle(0.2, 0.1), UP, Count(50), rails=[Formula("cos(u)", "sin(u)", f"3*u/{TURN}", end=TURN)]
    ).frames(50)
    angle = TURN * frames.s / 3
    assert frames.e2 == pytest.approx(np.stack((np.cos(angle), np.sin(angle), 0 * angle), axis=1), abs=1e-9)


def test_twist_turns_on_from_the_rail():
    rail = [Line((0, 1, 0), (0, 1, 3))]
    frames = GeneralizedCylinder(Rectangle(0.2, 0.1), UP, rails=rail, twist=np.pi / 2).frames()
    assert frames.e2 == pytest.approx(np.tile((-1.0, 0, 0), (len(frames.e2), 1)), abs=1e-12)


def test_between_two_rails_a_square_is_a_frustum():
    """From 2 x 2 to 4 x 4, and in width alone from 2 x 2 to 4 x 2: Simpson's rule."""
    evenly = GeneralizedCylinder(Rectangle(0.5, 0.5), UP, rails=SPREADING).mesh()
    assert evenly.volume() == pytest.approx(28, rel=1e-12) and len(evenly.vertices) == 8
    widely = GeneralizedCylinder(Rectangle(0.5, 2), UP, rails=SPREADING, guided="in-width").mesh()
    assert widely.volume() == pytest.approx(18, rel=1e-12)


def test_rails_that_meet_close_the_sweep_in_a_point_where_they_do():
    """A cone over a circle of 64 points, oblique: a third of base times height, its tip on the rails."""
    rails = [Line((2, 1, 0), (1, 5, 3)), Line((0, 1, 0), (1, 5, 3))]
    mesh = GeneralizedCylinder(Circle(7), UP, rails=rails).mesh()
    assert mesh.volume() == pytest.approx(Circle(1).section().area, rel=1e-9)
    assert_solid(mesh, 2)
    assert np.linalg.norm(mesh.vertices - (1, 5, 3), axis=1).min() < 1e-12


CURVED = Bezier([(0, 0, 0), (0.3, 0, 1), (-0.5, 0.4, 2), (0, 0, 3)])
WAVES = [
    Formula("0.8 + 0.2*sin(3*u)", "0.1*u", "u", start=-0.5, end=3.5),
    Line((-1, 0, -1), (-0.6, 0.3, 4)),
]


@pytest.mark.parametrize("contour", [Circle(1), Aerofoil(), TRIANGLE, Rectangle(0.2, 0.5)])
@pytest.mark.parametrize("guided", ["evenly", "in-width"])
def test_the_contour_touches_both_rails_in_its_plane(contour, guided):
    """At every station a point of the contour, or the middle of its side, is on each rail, found by another search."""
    shape = GeneralizedCylinder(contour, CURVED, Count(40), rails=WAVES, guided=guided)
    assert_touching(shape.frames(40), WAVES)


def assert_touching(frames, rails):
    places = np.linspace(0, 1, 20001)
    for rail, side in zip(rails, (1, -1), strict=True):
        along = rail.evaluate(rail.domain[0] + places * (rail.domain[1] - rail.domain[0]))
        for middle, e1, e2, ring in zip(frames.points, frames.e1, frames.e2, frames.contours[0], strict=True):
            met = along[np.abs((along - middle) @ e1).argmin()]
            x = side * (ring - middle) @ e2
            touching = ring[x >= x.max() - 1e-9]
            assert (touching.min(axis=0) + touching.max(axis=0)) / 2 == pytest.approx(met, abs=5e-4)


def test_a_changing_contour_touches_both_rails_too():
    shape = GeneralizedCylinder(
        Rectangle(1, 1), UP, Count(30), rails=SPREADING, morph=[(0.5, TRIANGLE), (1, Circle(0.2))]
    )
    assert_touching(shape.frames(30), SPREADING)


def test_of_several_places_on_a_rail_the_nearest_counts():
    """The plane of a ring's contour meets a larger ring on both sides."""
    frames = GeneralizedCylinder(Circle(0.1), Arc(1.0, TURN), rails=[Arc(2.0, TURN)]).frames()
    outward = frames.points / np.linalg.norm(frames.points, axis=1)[:, None]
    assert frames.e2 == pytest.approx(outward, abs=1e-9)


@pytest.mark.parametrize("contour", [Circle(1), Rectangle(1, 2), TRIANGLE])
def test_round_a_closed_trajectory_rails_close_the_sweep(contour):
    rails = [Formula(f"{r}*cos(u)", f"{r}*sin(u)", "0.1*sin(3*u)") for r in (1.2, 0.7)]
    mesh = GeneralizedCylinder(contour, Arc(1.0, TURN), rails=rails).mesh()
    assert_solid(mesh, 0)
    assert mesh.told == ()


def test_rings_between_rings_have_pappus_volume():
    """A circle between rings of 0.7 and 1.3 m stands at a radius of 1 m whatever the trajectory's is."""
    mesh = GeneralizedCylinder(
        Circle(5, points=256), Arc(0.9, TURN), Count(256), rails=[Arc(1.3, TURN), Arc(0.7, TURN)]
    )
    assert mesh.mesh().volume() == pytest.approx(np.pi * 0.09 * TURN, rel=1e-3)


def test_round_a_corner_a_sweep_between_offset_rails_is_mitred():
    """Both legs keep the breadth of 0.4 and the height of 0.2: area times the length of the middle."""
    middle = [(0, 0, 0), (1, 0, 0), (1, 1, 0)]
    rails = [Polyline([(0, -0.2, 0), (1.2, -0.2, 0), (1.2, 1, 0)]), Polyline([(0, 0.2, 0), (0.8, 0.2, 0), (0.8, 1, 0)])]
    mesh = GeneralizedCylinder(Rectangle(2, 1), Polyline(middle), rails=rails).mesh()
    assert mesh.volume() == pytest.approx(0.4 * 0.2 * 2, rel=1e-12)
    assert len(mesh.vertices) == 12


@st.composite
def shapes(draw):
    trajectory = draw(st.sampled_from([UP, CURVED, Helix(turns=1.0), Polyline([(0, 0, 0), (0, 0.1, 1), (0.2, 0, 3)])]))
    numbers = st.floats(-0.3, 0.3)
    rails = []
    for side in (0.6, -0.7)[: draw(st.integers(1, 2))]:
        u = np.linspace(*trajectory.domain, 24)
        away = np.array([side + draw(numbers), draw(numbers), 0.0])
        rails.append(Polyline((trajectory.evaluate(u) + away).tolist()))
    contour = draw(st.sampled_from([Circle(0.1, points=12), Rectangle(0.2, 0.1), TRIANGLE]))
    return GeneralizedCylinder(contour, trajectory, draw(st.sampled_from([Count(12), Count(50)])), rails=rails)


@given(shapes())
def test_every_sweep_between_rails_is_closed(shape):
    mesh = shape.mesh()
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0
    assert mesh.euler_characteristic() == 2


def test_what_rails_leave_open_is_told():
    short = GeneralizedCylinder(Circle(0.1), UP, rails=[Line((1, 0, 0), (1, 0, 2))], frame=Frenet()).mesh()
    assert short.told[0] == "Frame: the rails turn the contour, and no frame."
    assert short.told[1].startswith("Rails: rail 1 misses the plane at u = ")


def test_rails_are_the_same_after_they_were_text():
    shape = GeneralizedCylinder(rails=[Line((1, 0, 0), (1, 0, 2)), Helix()], guided="in-width")
    assert sw.load(sw.dump(shape)) == shape
    assert eval(python_source(shape), {"sw": sw}) == shape  # written by the program itself


@pytest.mark.parametrize(
    ("given", "sentence"),
    [
        ({"rails": [UP, UP, UP]}, "rails: must have at most 2 items, got 3"),
        ({"rails": ["straight"]}, "rails.1.path: must be one of line, arc,"),
        ({"rails": [{"path": "line", "side": 1}]}, "rails.1.side: is no parameter of Rail, which has path"),
        ({"rails": [UP], "trajectory": UP}, "rails: must not lie on the trajectory or on one another"),
        ({"rails": [UP, UP], "trajectory": Helix()}, "rails: must not lie on the trajectory or on one another"),
        (
            {
                "rails": [Line((1, 0, 0), (0, 0, 3)), Line((-1, 0, 0), (0, 0, 3))],
                "trajectory": UP,
                "guided": "in-width",
            },
            "guided: must be evenly where the rails meet",
        ),
        (
            {
                "rails": SPREADING,
                "trajectory": UP,
                "guided": "in-width",
                "contour": Outline([[(0, 0), (1, 9), (0, 5)]]),
            },
            "rails: must be as far apart as the contour's sides differ in height",
        ),
    ],
)
def test_what_guides_nothing_is_refused_in_one_sentence(given, sentence):
    with pytest.raises(ShapeError) as refusal:
        GeneralizedCylinder(**given).mesh()
    assert str(refusal.value).startswith(sentence)


def test_a_sweep_between_rails_is_asked_where_it_meets_itself():
    """Between rings of 0.2 and 1.8 m a tube of 0.8 m about a circle of 1 m is clean; of 1.2 m about it, it folds."""
    clean = GeneralizedCylinder(Circle(1), Arc(1.0, 3.0), rails=[Arc(1.8, 3.0), Arc(0.2, 3.0)])
    assert not len(clean.self_intersections())
    folded = GeneralizedCylinder(Circle(1), Arc(1.0, 3.0), rails=[Arc(2.2, 3.0), Line((-0.2, 0, 0), (0.2, 0, 0))])
    assert len(folded.self_intersections())
