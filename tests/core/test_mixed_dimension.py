# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Dimensionally non-homogeneous sweeps: the lecture's six, random ones, and what is left when they are regularized."""

from math import hypot, pi, sin, tau

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from solids import assert_solid, box
from test_translational_sweep import star

from sweep_addon import presets
from sweep_addon.core.contours import Circle, Mixed, Outline, Rectangle
from sweep_addon.core.declared import forms
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.meshes.joining import joined
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.kinds import SHAPES
from sweep_addon.core.shapes.rotational_sweep import RotationalSweep
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.stations.sampling import Count

CLOSE = dict(rel=1e-12)  # rounding: sums of a few hundred numbers
LECTURE = {  # by the lecture's letter: parts of dimension 3 to 0, dangling and connecting edges, singular points, edges
    "dangling_edges": ((0, 1, 2, 0), 2, 0, 0, 0),  # (a)
    "joined_by_an_edge": ((0, 2, 1, 0), 0, 1, 0, 0),  # (b)
    "dangling_faces": ((1, 2, 0, 0), 0, 0, 0, 2),  # (c)
    "every_dimension": ((1, 1, 1, 1), 0, 0, 0, 42),  # (d): one edge for each of 42 steps, where the face hangs
    "singular_point": ((0, 2, 0, 0), 0, 0, 1, 0),  # (e)
    "non_manifold_edge": ((2, 0, 0, 0), 0, 0, 0, 1),  # (f)
}


def preset(name):
    return presets.shape(f"mixed_dimension_{name}")


def length(mesh, edges):
    return float(np.linalg.norm(np.subtract(*mesh.vertices[edges].swapaxes(0, 1)), axis=1).sum())


@pytest.mark.parametrize("name", LECTURE)
def test_sweeps_of_the_lecture_have_their_parts(name):
    mesh = preset(name).mesh()
    found = mesh.dimensions()
    places = found.dangling_edges, found.connecting_edges, found.singular_points, found.non_manifold_edges
    assert (found.parts, *map(len, places)) == LECTURE[name]
    assert mesh.told == (f"Parts: {found}.",)
    assert found.homogeneous == (name in ("singular_point", "non_manifold_edge"))


@pytest.mark.parametrize("name", LECTURE)
def test_mesh_of_mixed_dimension_is_whole(name):
    """Every edge once, those of faces among them; texture coordinates and attributes for all."""
    mesh = preset(name).mesh()
    pairs = mesh.topology.uses()[0]
    known = {tuple(edge) for edge in np.sort(mesh.edges, axis=1).tolist()}
    assert len(known) == len(mesh.edges) and known >= {tuple(edge) for edge in pairs.tolist()}
    ends = np.stack((mesh.corners, mesh.corners[mesh.topology.following]), axis=1)
    assert (np.sort(mesh.edges[mesh.topology.corner_edges], axis=1) == np.sort(ends, axis=1)).all()
    assert mesh.uv.shape == (len(mesh.corners), 2) and np.isfinite(mesh.uv).all()
    assert all(np.isfinite(v).all() and len(v) == len(mesh.vertices) for v in mesh.attributes.values())
    assert len(np.unique(mesh.vertices.round(9), axis=0)) == len(mesh.vertices), "doubled vertices"


def test_curve_in_its_own_plane_sweeps_a_surface_and_two_dangling_edges():
    """(a): Cavalieri: the area is the height of the curve across its way times the way. The curve's flat ends sweep
    edges, of which the surface bounds one way's length."""
    mesh = preset("dangling_edges").mesh()
    assert mesh.area() == pytest.approx(0.9 * 0.7, **CLOSE)
    assert sorted(length(mesh, edge) for edge in mesh.dimensions().dangling_edges) == pytest.approx([0.8, 0.8], **CLOSE)
    assert (mesh.vertices[:, 2] == 0).all() and mesh.normals[:, 2].min() > 0


def test_edge_between_two_surfaces_is_as_long_as_the_flat_part_but_for_the_way():
    """(b)"""
    mesh = preset("joined_by_an_edge").mesh()
    (edge,) = mesh.dimensions().connecting_edges
    assert length(mesh, edge) == pytest.approx(1.4 - 0.6, **CLOSE)
    assert mesh.area() == pytest.approx(1.0 * 0.6, **CLOSE)


def test_faces_hang_on_the_solid_by_edges_of_three_faces():
    """(c)"""
    mesh = preset("dangling_faces").mesh()
    pairs, forward, backward = mesh.topology.uses()
    assert sorted((forward + backward)[forward + backward > 2].tolist()) == [3, 3]
    tails = hypot(0.4, 0.1) + hypot(0.3, 0.4) + 0.6
    assert mesh.area() == pytest.approx(2 * 1.2 * 0.8 + 2 * (1.2 + 0.8) * 0.7 + tails * 0.7, **CLOSE)


def test_cones_meet_in_the_singular_point_on_the_axis():
    """(e)"""
    mesh = preset("singular_point").mesh()
    assert np.abs(mesh.vertices[mesh.dimensions().singular_points]).max() == 0
    assert len(mesh.boundary_edges()) == 2 * 64


def test_bodies_that_meet_at_the_axis_do_not_cross_unless_they_turn_through_each_other():
    for name in ("singular_point", "non_manifold_edge"):
        assert not preset(name).self_intersections()
    assert RotationalSweep(Rectangle(2, 1), 4.0, crossing="split").self_intersections()


def test_wedges_meet_in_the_edge_on_the_axis():
    """(f): an edge of four faces, along the whole height."""
    mesh = preset("non_manifold_edge").mesh()
    (edge,) = mesh.vertices[mesh.dimensions().non_manifold_edges]
    assert np.abs(edge[:, [0, 2]]).max() == 0 and sorted(edge[:, 1]) == pytest.approx([-0.6, 0.6])
    pairs, forward, backward = mesh.topology.uses()
    assert (forward.max(), backward.max()) == (2, 2) and not len(mesh.boundary_edges())


V = Outline([[(-1, 1), (0, 0), (1, 1)]], closed=False)
TAILED = Mixed([box((0, 0), (1, 1))], [[(-1, 2), (0, 3), (1, 2)]])
LESS = "^angle: must be less than half a turn, 3.14159, where crossing is meet and the sides then sweep the same places"


BOTH_SIDES = {
    "rectangle": dict(contour=Rectangle(1, 1)),
    "circle": dict(contour=Circle(1, 37), axis_direction=(3, 7)),
    "one side larger": dict(contour=Outline([box((-2, 0), (1, 1))])),
    "curve": dict(contour=V),
    "curve beside an area": dict(contour=TAILED),
}


@pytest.mark.parametrize("angle", [pi, -pi, 3.5, tau, -tau])
@pytest.mark.parametrize("given", BOTH_SIDES.values(), ids=BOTH_SIDES)
def test_sides_that_sweep_the_same_places_meet_in_less_than_half_a_turn(given, angle):
    """Two half cylinders would share the faces at their ends, two whole ones everything."""
    for regularize in (False, True):
        with pytest.raises(ShapeError, match=f"{LESS}, got {angle:.9g}$"):
            RotationalSweep(**given, angle=angle, crossing="meet", regularize=regularize).mesh()


def test_a_little_less_than_half_a_turn_is_two_solids():
    shape = dict(contour=Rectangle(1, 1), angle=pi - 0.001, crossing="meet")
    found = RotationalSweep(**shape).mesh().dimensions()
    assert found.parts == (2, 0, 0, 0) and len(found.non_manifold_edges) == 1
    regular = RotationalSweep(**shape, regularize=True).mesh()
    assert regular.euler_characteristic() == 4 and not len(regular.boundary_edges())
    assert not len(regular.non_manifold_edges())


BESIDE = Outline([box((-3, 0), (-2, 1)), box((0, 0), (1, 1))])  # a ring round a cylinder
ABOVE = Outline([box((-1, 2), (0, 3)), box((0, 0), (1, 1))])
TOUCHING = Outline([box((-2, 0), (-1, 1)), box((0, 0), (1, 1))])


@pytest.mark.parametrize("angle", [pi, 4.0, tau])
@pytest.mark.parametrize(("contour", "moment"), [(BESIDE, 2.5 + 0.5), (ABOVE, 0.5 + 0.5), (TOUCHING, 1.5 + 0.5)])
def test_sides_that_never_come_to_the_same_places_may_turn_as_far_as_they_like(contour, moment, angle):
    mesh = RotationalSweep(contour, angle, samples=Count(25), crossing="meet").mesh()
    steps = 25 if angle == tau else 24
    assert mesh.dimensions().parts == (2, 0, 0, 0)
    assert mesh.volume() == pytest.approx(moment * steps * sin(angle / steps), rel=1e-12)


SOLID = {  # volume: area times height, or Pappus with the sectors of a turn in so many chords
    "dangling_faces": 1.2 * 0.8 * 0.7,
    "every_dimension": 0.24 * 0.7 * 4.2 * sin(4.2 / 42) / (4.2 / 42),
    "non_manifold_edge": 2 * (1.2 * 0.5 * 1.2 * sin(1.2 / 16) / (1.2 / 16)),
}


@pytest.mark.parametrize("name", LECTURE)
def test_regularized_only_the_solid_is_left_closed_and_manifold(name):
    table = forms.plain(preset(name)) | {"regularize": True}
    shape = forms.shape_of(SHAPES, table)
    if name not in SOLID:
        sentence = "must be off where no part is solid"
        with pytest.raises(ShapeError, match=f"^regularize: {sentence}, got '.* surfaces? "):
            shape.mesh()
        return
    mesh = shape.mesh()
    assert mesh.volume() == pytest.approx(SOLID[name], **CLOSE) and mesh.told == ()
    assert str(mesh.dimensions()) == ("2 solids (3D)" if name == "non_manifold_edge" else "1 solid (3D)")
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    assert mesh.euler_characteristic() == 2 * mesh.dimensions().solids
    assert mesh.uv.shape == (len(mesh.corners), 2)


def test_regularized_solids_do_not_meet_in_a_point_either():
    """A horn torus: its pole becomes two vertices, and the surface that of a ball."""
    shape = RotationalSweep(Outline([[(0, 0), (1, -1), (2, 0), (1, 1)]]), samples=Count(12))
    pinched = shape.mesh()
    assert len(pinched.dimensions().singular_points) == 1
    mesh = RotationalSweep(shape.contour, samples=Count(12), regularize=True).mesh()
    assert len(mesh.vertices) == len(pinched.vertices) + 1 and mesh.volume() == pytest.approx(pinched.volume(), **CLOSE)
    assert str(mesh.dimensions()) == "1 solid (3D)" and mesh.euler_characteristic() == 2


def test_ordinary_shape_is_one_solid_and_stays_as_it_is_when_regularized():
    for shape in (
        TranslationalSweep(),
        RotationalSweep(),
        TranslationalSweep(Outline([box((0, 0), (3, 3)), box((1, 1), (2, 2))])),
    ):
        mesh = shape.mesh()
        assert str(mesh.dimensions()) == "1 solid (3D)"
        again = type(shape)(shape.contour, regularize=True).mesh()
        assert again.volume() == pytest.approx(mesh.volume(), **CLOSE)
        assert_solid(again, mesh.euler_characteristic())


def test_cavity_is_no_solid_of_its_own_and_an_open_end_leaves_a_surface():
    ring = RotationalSweep(Outline([box((1, 0), (4, 3)), box((2, 1), (3, 2))]), samples=Count(12)).mesh()
    assert ring.dimensions().parts == (1, 0, 0, 0)
    assert TranslationalSweep(end="open").mesh().dimensions().parts == (0, 1, 0, 0)


def test_fin_round_a_cylinder_divides_its_side_and_not_the_solid():
    """The circle where it hangs has three faces everywhere: no way round it from the lower side to the upper one."""
    contour = Mixed([box((0, -1), (1, 1))], [[(1, 0), (2, 0)]])
    found = RotationalSweep(contour, samples=Count(20)).mesh().dimensions()
    assert found.parts == (1, 1, 0, 0) and len(found.non_manifold_edges) == 20
    solid = RotationalSweep(contour, samples=Count(20), regularize=True).mesh()
    assert solid.volume() == pytest.approx(20 / 2 * sin(tau / 20) * 2, **CLOSE)


def test_disc_between_two_rings_has_no_free_edge_and_is_a_surface_still():
    contour = Mixed([box((1, -1), (2, 1)), box((3, -1), (4, 1))], [[(2, 0), (3, 0)]])
    found = RotationalSweep(contour, samples=Count(20)).mesh().dimensions()
    assert found.parts == (2, 1, 0, 0)


def test_areas_that_touch_in_a_point_share_an_edge():
    found = TranslationalSweep(Mixed([box((0, 0), (1, 1)), box((1, 1), (2, 2))], [])).mesh().dimensions()
    assert found.parts == (2, 0, 0, 0) and len(found.non_manifold_edges) == 1


def test_overlapping_ways_are_united():
    """Within the plane: two upright edges closer than the way cover a rectangle once; farther apart, two."""
    for apart, surfaces, area in ((0.5, 1, 1.5), (1.5, 2, 2.0)):
        contour = Mixed([], [[(0, 0), (0, 1)], [(apart, 0), (apart, 1)]])
        mesh = TranslationalSweep(contour, 1.0, direction=(1, 0, 0)).mesh()
        assert mesh.dimensions().parts == (0, surfaces, 0, 0) and mesh.area() == pytest.approx(area, **CLOSE)


def test_area_in_its_own_plane_sweeps_its_area_and_its_breadth_times_the_way():
    """A disc sweeps a slot; a disc with a hole too, if the way is longer than the hole is wide."""
    disc = Circle(0.5, 256)
    slot = disc.section().area + 1.0 * 2.0
    mesh = TranslationalSweep(disc, 2.0, direction=(0, 3, 0)).mesh()
    assert mesh.area() == pytest.approx(slot, rel=1e-6)  # the grid of the union: a four-millionth of the size
    assert mesh.dimensions().parts == (0, 1, 0, 0)
    washer = Outline([disc.section().points, 0.5 * disc.section().points])
    assert TranslationalSweep(washer, 2.0, direction=(0, 1, 0)).mesh().area() == pytest.approx(slot, rel=1e-6)
    short = TranslationalSweep(washer, 0.2, direction=(0, 1, 0)).mesh()
    both = 2 * 0.25**2 * np.arccos(0.2 / 0.5) - 0.2 / 2 * np.sqrt(4 * 0.25**2 - 0.2**2)
    assert short.area() == pytest.approx(pi / 4 + 0.2 - both, rel=1e-3)


def test_closed_axis_of_a_contour_stays_an_edge_and_a_point_on_it_a_point():
    contour = Mixed([], [[(0, 0), (0, 1), (1, 1)]], [(0, 2), (1, 3)])
    mesh = RotationalSweep(contour, samples=Count(8)).mesh()
    assert str(mesh.dimensions()) == "1 surface (2D), 2 curves (1D), 1 point (0D); 1 dangling edge"
    with pytest.raises(ShapeError, match="^pitch: must be 0 for a contour with an edge along the axis, got 1"):
        RotationalSweep(contour, pitch=1).mesh()


def test_mixed_contour_across_the_axis_is_refused_or_meets_itself():
    contour = Mixed([Rectangle(2, 1).section().points], [[(1, 0), (2, 0)], [(-1, 0), (-2, 0)]], [(0, 3)])
    with pytest.raises(
        ShapeError, match="^contour: must be on one side of the axis, or crossing be keep, split or meet"
    ):
        RotationalSweep(contour, 1.0).mesh()
    found = RotationalSweep(contour, 1.0, samples=Count(5), crossing="meet").mesh().dimensions()
    assert found.parts == (2, 2, 0, 1) and len(found.non_manifold_edges) == 1 + 2 * 4


KINDS = "area", "area with a tail", "curve", "point", "edge along", "point on the axis"


def generator(kinds, seed):
    """Figures above each other, x from 0.5 to 3.5 or on the axis, x = 0; and the area of all, and its moment."""
    random, loops, curves, points, area, moment = np.random.default_rng(seed), [], [], [], 0.0, 0.0
    for row, kind in enumerate(kinds):
        middle = np.array((2.0, 3.0 * row))
        if kind.startswith("area"):
            loops.append(star(random, middle, 0.8, int(random.integers(4, 9))))
            section = Outline([loops[-1]]).section()
            area, moment = area + section.area, moment + section.area * section.centroid[0]
            corner = loops[-1][random.integers(len(loops[-1]))]
            curves += [[corner, middle + 1.2 * (corner - middle) / np.linalg.norm(corner - middle)]] * ("tail" in kind)
        elif kind == "curve":
            y = np.linspace(-1, 1, int(random.integers(2, 6)))
            curves.append(middle + np.stack((random.uniform(-1, 1, len(y)), y), axis=1))
        elif kind == "edge along":
            curves.append([(0, 3.0 * row), (0, 3.0 * row + 1)])
        else:
            points.append((0 if "axis" in kind else 2, 3.0 * row))
    return Mixed(loops, curves, points), area, moment


@given(st.lists(st.sampled_from(KINDS), min_size=1, max_size=6), st.integers(0, 2**32), st.floats(0.3, 6.0))
def test_sweep_raises_the_dimension_of_each_part_by_one_unless_it_moves_along_itself(kinds, seed, angle):
    contour, area, moment = generator(kinds, seed)
    count = {kind: kinds.count(kind) for kind in KINDS}
    areas, tails = count["area"] + count["area with a tail"], count["area with a tail"]
    lines, dots = count["curve"] + count["edge along"], count["point"] + count["point on the axis"]

    upright = TranslationalSweep(contour, 2.0, steps=2).mesh()
    assert upright.dimensions().parts == (areas, tails + lines, dots, 0)

    within = TranslationalSweep(contour, 0.5, direction=(0, 1, 0)).mesh()
    flat = within.dimensions()
    assert (flat.solids, flat.points) == (0, 0) and flat.surfaces == areas + count["curve"]
    assert flat.curves >= dots + count["edge along"]  # a tail may run along the way

    if areas + tails + count["curve"] + count["point"]:
        turned = RotationalSweep(contour, angle, samples=Count(25)).mesh()
        expected = areas, tails + count["curve"], count["point"] + count["edge along"], count["point on the axis"]
        assert turned.dimensions().parts == expected

    if areas:
        solid = TranslationalSweep(contour, 2.0, steps=2, regularize=True).mesh()
        assert_solid(solid, 2 * areas)
        assert solid.volume() == pytest.approx(2 * area, rel=1e-9)
        ring = RotationalSweep(contour, angle, samples=Count(25), regularize=True).mesh()
        assert_solid(ring, 2 * areas)
        assert ring.volume() == pytest.approx(moment * 24 * sin(angle / 24), rel=1e-9)


@given(
    st.lists(st.sampled_from(KINDS), min_size=1, max_size=4),
    st.integers(0, 2**32),
    st.floats(0.3, 7),
    st.integers(30, 60),
)
def test_what_is_told_of_many_contours_is_what_counting_all_of_them_gives(kinds, seed, angle, contours):
    """It is counted on a few: each further one adds the same."""
    contour = generator(["area", *kinds], seed)[0]
    meshes = [
        TranslationalSweep(contour, 2.0, steps=contours).mesh(),
        RotationalSweep(contour, min(angle, tau), samples=Count(contours)).mesh(),
    ]
    if set(kinds) <= {"area", "curve", "point"}:  # on both sides of the axis, which goes through the areas
        through = RotationalSweep(contour, 1.0, samples=Count(contours), axis_point=(2.0, 0.0), crossing="meet")
        meshes.append(through.mesh())
    for mesh in meshes:
        assert mesh.rings >= contours and mesh.told == (f"Parts: {mesh.dimensions()}.",)


@pytest.mark.parametrize(
    ("sentence", "make"),
    {
        "loops: must have an area, or curves or points be given, got 'none'": lambda: Mixed([], [], []),
        "loops: must have at least 3 points each, got 2": lambda: Mixed([[(0, 0), (1, 1)]]),
        "curves: must have at least 2 points each, got 1": lambda: Mixed(curves=[[(0, 0)]]),
        "points: must be a list of 2 numbers each, got [1, 2]": lambda: Mixed(points=[1, 2]),
        "loops: must enclose an area or have a length, got [3]": lambda: Mixed([[(0, 0), (1, 1), (2, 2)]], []),
        "fit: must be inscribed for a mixed contour, which has no curves, got 'area-true'": lambda: TranslationalSweep(
            Mixed(), fit="area-true"
        ).mesh(),
        "taper: must be 0 where the contour has open curves or points, which have no inside, got 0.1": lambda: (
            TranslationalSweep(Mixed(), taper=0.1).mesh()
        ),
        "contour: must not lie on the axis, got only points on it": lambda: RotationalSweep(
            Mixed([], [[(0, 0), (0, 1)]])
        ).mesh(),
    }.items(),
)
def test_what_will_not_do_is_refused_in_one_sentence(sentence, make):
    with pytest.raises(ShapeError) as caught:
        make()
    assert str(caught.value) == sentence


def test_generalized_cylinder_takes_no_mixed_contour():
    with pytest.raises(ShapeError, match="^contour: must be one of circle, .*, outline, got Mixed"):
        GeneralizedCylinder(Mixed())


@pytest.mark.parametrize(
    ("given", "parts", "area"),
    [
        (dict(curves=[[(0, 0), (3, 0)], [(0, 0), (0, 4)]]), (0, 1, 0, 0), 7 * 2.0),  # sheets: length times height
        (dict(points=[(0, 0), (1, 0)]), (0, 0, 2, 0), 0.0),
        (dict(loops=[box((0, 0), (3, 4))]), (1, 0, 0, 0), 2 * 12.0 + 14 * 2.0),  # a prism
    ],
    ids=["curves", "points", "loops"],
)
def test_parts_that_are_not_given_are_none(given, parts, area):
    """In Python and in a job: nobody who draws one curve expects the default's area beside it."""
    mesh = TranslationalSweep(Mixed(**given), 2.0).mesh()
    assert mesh.dimensions().parts == parts and mesh.area() == pytest.approx(area)
    table = {name: [np.asarray(part).tolist() for part in given[name]] for name in given}
    assert TranslationalSweep({"kind": "mixed", **table}).contour == Mixed(**given)


@pytest.mark.parametrize("name", LECTURE)
def test_job_holds_all_of_it(name):
    shape = preset(name)
    assert forms.load(SHAPES, forms.dump(shape)) == shape
    meshes = joined([shape.mesh(), shape.mesh()])
    assert meshes.dimensions().parts == tuple(2 * n for n in LECTURE[name][0])


def test_screw_of_a_mixed_contour_is_looked_at_for_crossings_too():
    contour = Mixed([box((1, 0), (2, 0.5))], [[(2, 0.25), (3, 0.25)]], [(4, 0)])
    for pitch, meets in ((0.6, False), (0.4, True)):
        screw = RotationalSweep(contour, 2 * tau, pitch, Count(60))
        assert bool(screw.self_intersections()) == meets
        assert screw.mesh().dimensions().parts == (1, 1, 1, 0)
