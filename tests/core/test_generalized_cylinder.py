# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The generalized cylinder is a solid whatever its parameters, and has the volume that theorems give it."""

from typing import get_args

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from solids import CENTRELINES, GLYPHS, KNOTS, assert_solid, box, ngon

from sweep_addon.core.contours import Circle, Contour, Fit, Outline, Rectangle, ScrewThread
from sweep_addon.core.declared.names import spelled
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.formulas.expressions import compile
from sweep_addon.core.rings.ends import Flat, Open, Taper
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.cells import bend
from sweep_addon.core.stations.frames import Continuation, FixedUp, Frenet, RotationMinimizing
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Bezier, Helix, Line, Nurbs, Polyline, TorusKnot

SIZE = 0.05  # of the contours below, small against the trajectories, so that no bend turns the solid inside out
LAWS = {  # of scale, and how many points they make on a closed and on an open trajectory, the ends among them
    "1": (0, 0),
    "-0.3": (0, 0),
    "2 + sin(2*pi*t)": (0, 0),
    "sin(pi*t)": (1, 2),
    "sin(2*pi*t)": (2, 3),
    "abs(1 - 2*t)": (1, 1),
    "1 - t": (None, 1),
    "3*t^2": (None, 1),
    "1 - 2*t": (None, 1),
    "exp(-3*t)": (None, 0),
}
TWISTS = {"0.5": True, "2*pi*t": True, "-6*pi*t": True, "sin(2*pi*t)": True, "5*t^2": False}


def numbers(low, high):
    return st.floats(low, high, allow_nan=False)


@st.composite
def outlines(draw):
    """An outline in the unit disc with holes, with an island in the first of them, its loops in either direction."""
    holes = draw(st.integers(0, 3))
    places = 0.55 * np.exp(2j * np.pi * (np.arange(holes) + draw(numbers(0, 1))) / 3)
    loops = [ngon((0, 0), 1.0, draw(st.integers(7, 30)), draw(numbers(0, 6)))]
    for place in places:
        loops.append(ngon((place.real, place.imag), draw(numbers(0.1, 0.3)), draw(st.integers(3, 12))))
    island = holes and draw(st.booleans())
    if island:
        loops.append(loops[1].mean(axis=0) + 0.3 * (loops[1] - loops[1].mean(axis=0)))
    loops = [loop[::-1] if draw(st.booleans()) else loop for loop in loops]
    return Outline([SIZE * loop for loop in loops]), 1 - holes + bool(island)


@st.composite
def contours(draw):
    """A contour, and the sum over its islands of 1 - holes."""
    width, height = draw(numbers(0.2, 1)), draw(numbers(0.2, 1))
    rounding = draw(numbers(0.01, 0.5)) * min(width, height) if draw(st.booleans()) else 0.0
    return draw(
        st.one_of(
            st.builds(Circle, numbers(0.1 * SIZE, SIZE), st.integers(3, 40)).map(lambda circle: (circle, 1)),
            st.just((Rectangle(SIZE * width, SIZE * height, SIZE * rounding, draw(st.integers(2, 9))), 1)),
            outlines(),
        )
    )


@st.composite
def trajectories(draw):
    """One of every kind, of about a metre and more, without sharp reversals."""
    steps = draw(st.lists(st.tuples(numbers(0.3, 1), numbers(-1, 1), numbers(-1, 1)), min_size=4, max_size=12))
    chain = np.cumsum(steps, axis=0)
    ring = np.array(steps)[:, 1:]
    angle = 2 * np.pi * np.arange(len(steps)) / len(steps)
    ring = np.column_stack(((2 + 0.4 * ring[:, 0]) * np.cos(angle), (2 + 0.4 * ring[:, 0]) * np.sin(angle), ring[:, 1]))
    whole = len(steps) // 3 * 3
    return draw(
        st.one_of(
            st.builds(Line, end=st.tuples(numbers(-2, 2), numbers(-2, 2), numbers(0.5, 2))),
            st.builds(Helix, numbers(0.2, 2), numbers(-2, 2), numbers(0.1, 0.9)),
            st.builds(Helix, numbers(0.2, 2), numbers(0.3, 2) | numbers(-2, -0.3), numbers(1, 5)),
            st.sampled_from([TorusKnot(), TorusKnot(3, 2, 1.0, 0.5), TorusKnot(1, 1), TorusKnot(5, 2, 2.0, 0.3)]),
            st.sampled_from(
                [Polyline(chain), Polyline(ring, closed=True), Bezier(chain[: (len(steps) - 1) // 3 * 3 + 1])]
            ),
            st.sampled_from([Bezier(3 * ring[:whole], closed=True), Nurbs(chain), Nurbs(ring, order=3, closed=True)]),
            st.builds(Nurbs, st.just(chain), st.just(np.linspace(0.5, 2, len(steps))), order=st.integers(2, 4)),
        )
    )


FRAMES = st.sampled_from([RotationMinimizing(), RotationMinimizing(2, -1), Frenet(), FixedUp(), FixedUp((1, 2, 3))])
ENDS = st.one_of(st.just(Flat()), st.just(Open()), st.builds(Taper, numbers(0.05, 0.2)))
SAMPLES = st.one_of(st.builds(Tolerance, numbers(1e-3, 0.1)), st.builds(Count, st.integers(60, 150)))


@given(
    contours(), trajectories(), SAMPLES, FRAMES, st.sampled_from(list(LAWS)), st.sampled_from(list(TWISTS)), ENDS, ENDS,
    st.sampled_from(Fit),
)  # fmt: skip
def test_every_sweep_is_a_solid(contour, trajectory, samples, frame, scale, twist, start, end, fit):
    """Each cap adds 1 - holes of each of its islands to the Euler characteristic, each tip 1, walls nothing."""
    contour, islands = contour
    closed, total = trajectory.closed, trajectory.length()
    assume(total > 0.45)
    assume(not closed or (LAWS[scale][0] is not None and TWISTS[twist]))
    sweep = GeneralizedCylinder(contour, trajectory, samples, frame, scale, scale, twist, start=start, end=end, fit=fit)
    try:
        mesh = sweep.mesh()
    except ShapeError as refusal:
        assert fit is not Fit.INSCRIBED and refusal.key in ("fit", "samples")
        return

    if closed:
        assert_solid(mesh, euler=LAWS[scale][0])
        return
    value = [compile(scale, ["t"]).evaluate(t=np.array([t]))[0] for t in (0.0, 1.0)]
    pointed = [abs(v) < 1e-9 for v in value]
    tips = LAWS[scale][1] + sum(isinstance(e, Taper) and not p for e, p in zip((start, end), pointed, strict=True))
    flat, left = (
        sum(isinstance(e, kind) and not p for e, p in zip((start, end), pointed, strict=True)) for kind in (Flat, Open)
    )
    assert_solid(mesh, euler=flat * islands + tips, boundary=left * len(contour.section().points))


@pytest.mark.parametrize("glyph", GLYPHS)
@pytest.mark.parametrize("frame", [RotationMinimizing(), Frenet(Continuation.EXACT), FixedUp()])
def test_a_glyph_swept_has_the_genus_it_gives(glyph, frame):
    """Open, each island with h holes is a body of genus h; round a knot, each loop is a torus of its own."""
    outline, holes = GLYPHS[glyph]
    knot = TorusKnot(2, 3, 20.0, 8.0)
    assert_solid(GeneralizedCylinder(outline, knot, Tolerance(0.01), frame).mesh(), euler=0)
    assert_solid(
        GeneralizedCylinder(outline, Helix(20.0, 9.0, 2.0), frame=frame).mesh(), euler=sum(2 - 2 * h for h in holes)
    )


@pytest.mark.parametrize("tolerance", [1e-2, 1e-3, 1e-4])
@pytest.mark.parametrize("contour", [Circle(0.3, points=16), Rectangle(0.3, 0.5), Rectangle(0.2, 0.6, 0.1)])
@pytest.mark.parametrize("trajectory", [TorusKnot(2, 3, 2.0, 0.8), Helix(2.0, 3.0, 2.0)])
def test_volume_is_the_area_of_the_contour_times_the_length_of_the_trajectory(trajectory, contour, tolerance):
    """Weyl 1939, if the contour's centroid is on the trajectory. With steps h over curvature k the chords lack a 24th
    of (k h)^2 of the length, and contours across the tangent, k h / 2 aslant to them, an 8th of it of the area: a 6th
    together, where the sampling holds k h^2 to 8 tolerances or, at a turn of 30 degrees, k h to pi / 6."""
    mesh = GeneralizedCylinder(contour, trajectory, Tolerance(tolerance)).mesh()
    sharpest = np.linalg.norm(bend(trajectory, np.linspace(*trajectory.domain, 10_001)), axis=1).max()
    lacking = 1 - mesh.volume() / (contour.section().area * trajectory.length())
    assert 0 < lacking < min(8 * tolerance * sharpest, (np.pi / 6) ** 2) / 6 * 1.1


@pytest.mark.parametrize("scale", ["1 + t", "2 - 3*t + 2*t^2", "exp(-t)"])
def test_a_straight_sweep_has_the_volume_of_its_section_along_it(scale):
    """Cavalieri; between contours a scale is straight, off by the tolerance over the reach at most."""
    mesh = GeneralizedCylinder(Circle(0.5), Line(end=(0, 0, 2)), Tolerance(1e-6), scale_x=scale, scale_y=scale).mesh()
    t = np.linspace(0, 1, 20_001)
    squared = compile(scale, ["t"]).evaluate(t=t) ** 2
    expected = Circle(0.5).section().area * 2 * ((squared[1:] + squared[:-1]) / 2).mean()
    assert mesh.volume() == pytest.approx(expected, rel=2 * 1e-6 / 0.5 / np.sqrt(squared.min()))


@pytest.mark.parametrize("degrees", [5, 20, 60, 90, 120, 150, 170, 175])
@pytest.mark.parametrize("contour", [Circle(0.1, points=9), Rectangle(0.2, 0.1), GLYPHS["%"][0]])
def test_a_mitred_corner_keeps_the_volume_of_its_legs(contour, degrees):
    """The wedge that the mitre takes from one side it gives to the other, if the centroid is on the trajectory."""
    turn = np.radians(degrees)
    section = contour.section()
    if section.size > 1:
        contour = Outline([0.1 * (np.array(loop) - section.centroid) for loop in contour.loops])
    corners = np.cumsum([(0, 0, 0), (5, 0, 0), (5 * np.cos(turn), 3 * np.sin(turn), 4 * np.sin(turn))], axis=0)
    mesh = GeneralizedCylinder(contour, Polyline(corners)).mesh()
    assert mesh.volume() == pytest.approx(contour.section().area * 10, rel=1e-12)


def test_legs_keep_their_cross_section():
    """Each column of a polyline's vertices runs along its legs."""
    corners = np.random.default_rng(8).normal(size=(30, 3)).cumsum(axis=0)
    mesh = GeneralizedCylinder(Outline([box((-0.01, 0), (0.02, 0.01))]), Polyline(corners)).mesh()
    steps = np.diff(mesh.vertices.reshape(4, 30, 3), axis=1)
    assert np.abs(np.cross(steps, np.diff(corners, axis=0))).max() < 1e-13


@pytest.mark.parametrize("name", CENTRELINES)
def test_recorded_paths_and_backbones_become_tubes_of_their_length(name):
    points = CENTRELINES[name]["points"]
    tube = GeneralizedCylinder(Circle(0.2, points=12), Polyline(points))
    mesh = tube.mesh()
    assert_solid(mesh, euler=2)
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    assert mesh.volume() == pytest.approx(Circle(0.2, points=12).section().area * length, rel=1e-11)


@pytest.mark.parametrize("name", KNOTS)
def test_knots_become_closed_tubes_of_their_length(name):
    """A leg twisted by its share of the holonomy, half a turn at most, lacks a sixth of the square of that angle."""
    first, last = KNOTS[name]["t"]
    closed = KNOTS[name]["kind"] == "closed"
    t = np.linspace(first, last, 301)[: -1 if closed else None]
    points = np.stack([compile(KNOTS[name][axis], ["t"]).evaluate(t=t) for axis in "xyz"], axis=1)
    trajectory = Polyline(points, closed)
    legs = np.linalg.norm(trajectory.legs, axis=1)
    contour = Circle(legs.sum() / 5000, points=12)
    mesh = GeneralizedCylinder(contour, trajectory).mesh()
    assert_solid(mesh, euler=0 if closed else 2)
    lacking = 1 - mesh.volume() / (contour.section().area * legs.sum())
    assert -1e-11 < lacking < (np.pi * legs.max() / legs.sum()) ** 2 / 6 + 1e-11


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1e3, 1e6])
def test_a_shape_of_any_size_is_the_same_shape(size):
    def knot(size):
        return GeneralizedCylinder(
            Circle(0.1 * size, 12), TorusKnot(2, 3, size, 0.4 * size), Tolerance(1e-3 * size)
        ).mesh()

    assert np.abs(knot(size).vertices / size - knot(1.0).vertices).max() < 1e-12
    assert_solid(knot(size), euler=0)


@pytest.mark.parametrize("far", [1e3, 1e6])
def test_far_from_the_origin_only_rounding_is_lost(far):
    chain = np.array([(0, 0, 0), (0, 0, 0.5), (0, 0.5, 1), (0, 1, 1)])
    near, away = (GeneralizedCylinder(Circle(0.1, 12), Bezier(chain + offset)).mesh() for offset in (0.0, far))
    assert np.abs(away.vertices - far - near.vertices).max() < 100 * np.finfo(float).eps * far


@pytest.mark.large
def test_ten_thousand_turns_are_a_solid():
    assert_solid(GeneralizedCylinder(Circle(0.1, 8), Helix(turns=10_000.0), Tolerance(0.1)).mesh(), euler=2)


@pytest.mark.parametrize("law", ["abs(1 - 3*t)", "(1 - 3*t)^2", "abs(0.37 - t)", "abs(cos(3*pi*t))"])
def test_scale_that_touches_zero_closes_in_one_vertex_there(law):
    mesh = GeneralizedCylinder(scale_x=law, scale_y=law, trajectory=Line()).mesh()
    zeros = {"abs(1 - 3*t)": [1 / 3], "(1 - 3*t)^2": [1 / 3], "abs(0.37 - t)": [0.37]}.get(law, [1 / 6, 1 / 2, 5 / 6])
    axis = np.hypot(*mesh.vertices[:, :2].T) < 1e-9
    assert np.sort(mesh.vertices[axis, 2]) == pytest.approx(zeros, abs=1e-7)


@pytest.mark.parametrize("kind", get_args(Contour), ids=spelled)
def test_a_contour_chosen_by_its_name_passes_between_the_turns_of_the_default_helix(kind):
    """Turns of a helix are its pitch times the cosine of its slope apart; a thread has a standard's size instead."""
    shape = GeneralizedCylinder(contour=spelled(kind))
    radius, pitch = shape.trajectory.radius, shape.trajectory.pitch
    apart = pitch * np.cos(np.arctan(pitch / (2 * np.pi * radius)))
    reach = np.linalg.norm(shape.contour.section().points, axis=1).max()
    assert reach < apart / 2
    assert reach > apart / 6 or kind is ScrewThread


@pytest.mark.parametrize("turns", [2, 3, 4])
def test_contours_too_few_to_follow_the_path_are_told(turns):
    """Half a turn between contours is the border: from there a chord runs against the helix where it leaves it."""
    for contours in range(3, 5 * turns):
        mesh = GeneralizedCylinder(Circle(0.05), Helix(turns=turns), Count(contours)).mesh()
        if turns / (contours - 1) < 0.5:
            assert mesh.volume() > 0 and mesh.told == ()
        elif 0.55 < turns / (contours - 1) < 0.95:  # the helix also rises
            assert mesh.volume() < 0 and mesh.told[0].startswith("Samples: from u = ")
