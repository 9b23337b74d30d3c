# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Translational sweeps against Cavalieri's principle and Steiner's formula, and their refusals."""

import re
from math import atan, cos, pi, radians, sin, tan

import numpy as np
import pytest
from solids import GLYPHS, assert_solid, box, ngon

from sweep_addon.core.contours import Circle, Mixed, Outline, Rectangle, RegularPolygon, Star
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grids.laying import CAP
from sweep_addon.core.rings.draft import mitres, reachable
from sweep_addon.core.shapes.translational_sweep import Reference, TranslationalSweep

CLOSE = dict(rel=1e-12)  # rounding: sums of a few hundred numbers
PLATE = Outline([box((-2, -1), (2, 1)), ngon((-0.8, 0), 0.5, 7), ngon((0.9, 0), 0.6, 24)])


def steiner(section, heights, slopes):
    """The volume of a drafted section between heights, Steiner's formula for each loop integrated over the height.

    Its area, moved inwards by d, is A - P d + d^2 sum tan(turn / 2).
    """
    bends = np.add.reduceat(np.tan(section.turns / 2), section.offsets[:-1])
    whole = 0.0
    for height in heights:
        d = height * np.asarray(slopes)
        whole += height * (section.areas - section.perimeters * d / 2 + bends * d**2 / 3).sum()
    return whole


def assert_caps_cover(mesh, section, heights, slopes):
    """All faces of the caps look out, and together they are as large as the drafted contour: none lies over another."""
    up = mesh.normals[mesh.topology.material == CAP, 2]
    bends = np.add.reduceat(np.tan(section.turns / 2), section.offsets[:-1])
    ends = [heights[0], heights[1] if len(heights) > 1 else 0.0]
    areas = [(section.areas - section.perimeters * h * slopes + bends * (h * slopes) ** 2).sum() for h in ends]
    assert np.abs(up).min() > 0
    assert [up[up > 0].sum(), -up[up < 0].sum()] == pytest.approx(areas, rel=1e-9)


def star(random, centre, reach, points):
    """A random loop that its centre sees all of, (n, 2)."""
    angle = 2 * pi * (np.arange(points) + random.uniform(-0.3, 0.3, points)) / points
    return centre + reach * random.uniform(0.5, 1, (points, 1)) * np.stack((np.cos(angle), np.sin(angle)), axis=1)


def outline(random):
    """A random outline of one or two islands, and the holes of each; coordinates up to about 3."""
    loops, holes = [], []
    for island in range(random.integers(1, 3)):
        middle = np.array([2.5 * island, 0.0])
        loops.append(star(random, middle, 1.0, random.integers(3, 12)))
        holes.append(int(random.integers(0, 3)))
        for hole in range(holes[-1]):
            loops.append(star(random, middle + (0.14 * (2 * hole - 1), 0), 0.1, random.integers(3, 8)))
    if any(len(loop) == 3 for loop in loops[: 1 + holes[0]]) or any(len(loop) < 6 for loop in loops):
        return outline(random)  # few points may leave no room for holes
    return Outline(loops), holes


@pytest.mark.parametrize("direction", [(0, 0, 1), (0, 0, 0.1), (1, 0, 1), (-3, 2, 0.5)])
@pytest.mark.parametrize("glyph", GLYPHS)
def test_prism_has_the_volume_of_its_base_times_its_height_however_oblique(glyph, direction):
    """Cavalieri. Upright, its surface is twice the base and the perimeter times the height."""
    contour, holes = GLYPHS[glyph]
    mesh = TranslationalSweep(contour, 3.0, direction=direction, steps=3).mesh()
    section = contour.section()
    assert mesh.volume() == pytest.approx(3 * section.area, **CLOSE)
    if direction[0] == 0:
        assert mesh.area() == pytest.approx(2 * section.area + 3 * section.perimeters.sum(), **CLOSE)
    assert_solid(mesh, sum(2 - 2 * h for h in holes))
    assert mesh.vertices[:, 2].min() == 0 and mesh.vertices[:, 2].max() == 3


@pytest.mark.parametrize("contour", [Circle(1, 64), Star(5, 1.0, 0.6), RegularPolygon(7), Rectangle(3, 2, 0.4), PLATE])
@pytest.mark.parametrize("taper", [0.1, -0.2, 0.02])
@pytest.mark.parametrize("steps", [1, 4])
def test_drafted_prism_has_the_volume_of_steiners_formula(contour, taper, steps):
    section = contour.section()
    shape = TranslationalSweep(contour, 0.5, taper=taper, hole_taper=taper / 2, steps=steps)
    slopes = np.where(section.areas > 0, tan(taper), tan(taper / 2))
    assert shape.mesh().volume() == pytest.approx(steiner(section, [0.5], slopes), **CLOSE)


def test_both_directions_draft_from_the_contours_plane():
    both = TranslationalSweep(Circle(1), 0.5, "both", depth=0.8, taper=0.2)
    section = both.contour.section()
    assert both.mesh().volume() == pytest.approx(steiner(section, [0.5, 0.8], [tan(0.2)]), **CLOSE)
    even = TranslationalSweep(Circle(1), 1.0, "symmetric", taper=0.2).mesh()
    assert even.volume() == pytest.approx(2 * steiner(section, [0.5], [tan(0.2)]), **CLOSE)
    assert even.vertices[:, 2].min() == -0.5 and even.vertices[:, 2].max() == 0.5
    assert len(np.unique(even.vertices[:, 2])) == 3, "the parting line is an edge all round"
    assert even.topology.sharp.sum() == 3 * 64


@pytest.mark.parametrize(("depth", "steps"), [(0.05, 3), (float(np.float32(0.05)), 3), (0.2, 6), (0.1, 7)])
def test_contours_plane_is_one_contour_though_a_step_ends_there_but_for_rounding(depth, steps):
    """Of as many contours as steps have ends; one more where no step ends in the plane."""
    shape = TranslationalSweep(Rectangle(1, 1), 0.1, "both", depth=depth, taper=0.3, steps=steps)
    mesh, contours = shape.mesh(), steps + 2 if steps == 7 else steps + 1
    assert len(mesh.vertices) == 4 * contours
    apart = np.diff(np.unique(mesh.vertices[:, 2]))
    assert len(apart) == contours - 1
    assert apart.min() > 0.49 * (0.1 + depth) / steps, "the plane halves the middle one of seven"
    assert mesh.volume() == pytest.approx(steiner(shape.contour.section(), [0.1, depth], [tan(0.3)]), **CLOSE)


def test_thin_depth_is_not_taken_for_rounding():
    shape = TranslationalSweep(Rectangle(1, 1), 0.1, "both", depth=1e-9, taper=0.3)
    assert shape.heights().tolist() == [-1e-9, 0, 0.1]


def test_every_side_of_a_drafted_prism_leans_by_its_angle():
    """The angle between a side and the vertical, loop by loop."""
    tapers = 0.1, -0.05, 0.2
    mesh = TranslationalSweep(PLATE, 0.5, tapers=tapers).mesh()
    sides = np.flatnonzero(mesh.topology.material != CAP)
    normals = mesh.normals[sides] / np.linalg.norm(mesh.normals[sides], axis=1, keepdims=True)
    loop = PLATE.section().loop_of
    assert np.abs(np.arcsin(normals[:, 2]) - np.array(tapers)[loop]).max() < 1e-12


@pytest.mark.parametrize(
    "contour", [RegularPolygon(3), Rectangle(2, 2), Circle(0.7, 100), Outline([[(0, 0), (5, 1), (2, 3)]])]
)
@pytest.mark.parametrize("directions", ["up", "symmetric"])
def test_taper_to_a_point_is_a_pyramid_with_one_tip(contour, directions):
    """A third of base times height. All edges of a triangle vanish at its incentre: area = inradius * perimeter / 2."""
    section, height = contour.section(), 3.0
    inradius = 2 * section.area / section.perimeters[0]
    reach = height / 2 if directions == "symmetric" else height
    mesh = TranslationalSweep(contour, height, directions, taper=atan(inradius / reach)).mesh()
    assert mesh.volume() == pytest.approx(section.area * height / 3, **CLOSE)
    rings = 1
    assert len(mesh.vertices) == rings * len(section.points) + (2 if directions == "symmetric" else 1)
    assert_solid(mesh, 2)


def test_point_is_one_also_of_an_angle_that_blender_keeps():
    """In single precision."""
    angle = float(np.float32(atan(1 / 3)))
    assert len(TranslationalSweep(Rectangle(2, 2), 3.0, taper=angle).mesh().vertices) == 5


LARGEST = {  # contour, the inward distance at which edges meet first; at 1 nothing is left
    "a rectangle is a ridge at half its width": (Rectangle(3, 2), 1.0),
    "a neck of a dumbbell closes at half its width": (
        Outline(
            [[(0, 0), (2, 0), (2, 0.8), (4, 0.8), (4, 0), (6, 0), (6, 2), (4, 2), (4, 1.2), (2, 1.2), (2, 2), (0, 2)]]
        ),
        0.2,
    ),
    "a hole meets its outline": (Outline([box((0, 0), (4, 4)), box((1, 1), (2, 2))]), 0.5),
}


@pytest.mark.parametrize("name", LARGEST)
def test_refusal_tells_the_angle_at_which_all_is_gone_at_the_height(name):
    contour, _ = LARGEST[name]
    shape = dict(contour=contour, height=2.0)
    with pytest.raises(ShapeError, match=r"^taper: must be at most .*: nothing is left 0.38878 m") as caught:
        TranslationalSweep(**shape, taper=1.2, hole_taper=1.2).mesh()  # 1 / tan 1.2
    told = float(re.search(r"at most ([\d.]+)", str(caught.value))[1])
    assert told == pytest.approx(atan(1 / 2.0), rel=1e-6)
    roof = TranslationalSweep(**shape, taper=told, hole_taper=told).mesh()
    assert_solid(roof, 2 - 2 * (len(contour.section().areas) - 1))
    assert roof.vertices[:, 2].max() == pytest.approx(2.0, rel=1e-6)


@pytest.mark.parametrize("name", ["a square is a point at half its width", *LARGEST])
def test_a_taper_that_leaves_nothing_of_the_width_is_no_value_at_all(name):
    """It is refused where it is said, and not where it is first drawn."""
    contour = LARGEST[name][0] if name in LARGEST else Rectangle(2, 2)
    wide = np.ptp(contour.section().points, axis=0).min()
    least = atan(wide / 2 / 0.7)
    both, symmetric = dict(directions="both", depth=0.7, height=0.1), dict(directions="symmetric", height=1.4)
    for given in (dict(height=0.7), both, symmetric):
        shape = dict(contour=contour, **given)
        with pytest.raises(ShapeError, match="^taper: must be at most "):
            TranslationalSweep(**shape, taper=least * (1 + 1e-5), hole_taper=0.1)
        TranslationalSweep(**shape, taper=-least, hole_taper=-0.1)


@pytest.mark.parametrize("points", [3, 4, 5, 32])
def test_a_taper_beyond_the_tip_of_a_cone_is_no_value_at_all(points):
    tip = atan(cos(pi / points) / 2)
    with pytest.raises(ShapeError, match="^taper: must be at most "):
        TranslationalSweep(Circle(1.0, points), 2.0, taper=tip * (1 + 1e-5))
    TranslationalSweep(Circle(1.0, points), 2.0, taper=tip * (1 - 1e-5))


def test_a_loop_that_is_left_or_grows_is_no_reason_to_refuse_another():
    two = Outline([box((0, 0), (2, 2)), box((3, 0), (4, 1))])
    TranslationalSweep(two, 1.0, tapers=[0.7, 0.7])
    TranslationalSweep(two, 1.0, tapers=[1.4, -0.1])
    TranslationalSweep(LARGEST["a hole meets its outline"][0], 1.0, taper=0.3, hole_taper=1.5)
    with pytest.raises(ShapeError, match="^tapers: must be at most "):
        TranslationalSweep(two, 1.0, tapers=[0.8, 0.8])


@pytest.mark.parametrize("name", LARGEST)
@pytest.mark.parametrize("short", [0, 1e-15, 1e-12, 1e-9, 5e-7])
def test_edges_that_meet_at_the_height_or_hardly_beyond_meet_there(name, short):
    """Their contour is not doubled there, in single precision either; the volume is still Steiner's."""
    contour, distance = LARGEST[name]
    angle = atan(distance / 2.0) * (1 - short)
    mesh = TranslationalSweep(contour, 2.0, taper=angle, hole_taper=angle).mesh()
    section = contour.section()
    assert_solid(mesh, 2 - 2 * (len(section.areas) - 1))
    assert mesh.volume() == pytest.approx(steiner(section, [2.0], [tan(angle)] * len(section.areas)), rel=1e-5)
    assert len(np.unique(mesh.vertices.astype(np.float32), axis=0)) == len(mesh.vertices)


@pytest.mark.parametrize("short", [0, 1e-12, 1e-9, 5e-7])
def test_square_is_a_pyramid_also_hardly_below_its_tip(short):
    assert len(TranslationalSweep(Rectangle(2, 2), 3.0, taper=atan(1 / 3) * (1 - short)).mesh().vertices) == 5


@pytest.mark.parametrize("points", [5, 64, 1000])
def test_angle_told_for_a_circle_makes_a_cone_in_radians_and_in_degrees(points):
    """Its sides are those of the polygon of its points, whose distance from the middle is cos(pi / n) of the radius."""
    with pytest.raises(ShapeError, match=r"^taper: must be at most ") as caught:
        TranslationalSweep(Circle(1.0, points), 2.0, taper=1.2).mesh()
    told, shown = map(float, re.search(r"at most ([\d.]+) \(([\d.]+) degrees", str(caught.value)).groups())
    assert told == pytest.approx(atan(cos(pi / points) / 2.0), rel=1e-8)
    for angle in (told, radians(shown), float(np.float32(radians(shown)))):
        mesh = TranslationalSweep(Circle(1.0, points), 2.0, taper=angle).mesh()
        assert len(mesh.vertices) == points + 1
        assert mesh.volume() == pytest.approx(points / 2 * sin(2 * pi / points) * 2 / 3, rel=1e-6)


def test_outward_draft_closes_a_notch():
    """One 1 m wide between sides that both move out is gone where they have moved by half of that."""
    notched = Outline([[(0, 0), (3, 0), (3, 2), (2, 2), (2, 1), (1, 1), (1, 2), (0, 2)]])
    mesh = TranslationalSweep(notched, 1.0, taper=-atan(0.8)).mesh()
    d = np.array([0.0, 0.8])
    whole = np.polynomial.Polynomial([6, 10, 4]).integ()(d)  # (3 + 2 d) (2 + 2 d), without the notch
    assert mesh.volume() == pytest.approx((np.diff(whole)[0] - 0.25) / 0.8, **CLOSE)
    assert_solid(mesh, 2)


def test_reference_point_of_the_contour_moves_from_the_origin():
    contour = Outline([[(3, 4), (5, 4), (3, 7)]])
    for reference, place in ((Reference.CENTROID, (11 / 3, 5)), (Reference.ORIGIN, (0, 0)), (Reference.POINT, (1, 2))):
        shape = TranslationalSweep(contour, reference=reference, reference_x=1.0, reference_y=2.0)
        base = shape.mesh().vertices[:, :2]
        assert np.abs(base[::2] - (contour.section().points - place)).max() < 1e-12
        assert shape.frames().points.tolist() == [[0, 0, 0], [0, 0, 1]]


def test_open_contours_make_surfaces():
    """Of the length of the lines times the height; each line is a sheet, whose Euler characteristic is 1."""
    lines = Outline([[(0, 0), (3, 4), (3, 6)], [(5, 0), (6, 0)]], closed=False)
    mesh = TranslationalSweep(lines, 2.0, steps=4).mesh()
    assert mesh.area() == pytest.approx((5 + 2 + 1) * 2.0, **CLOSE)
    assert_solid(mesh, 2, boundary=2 * (4 + 4) + 2 * (2 + 1))
    assert mesh.uv[:, 1].max() == pytest.approx(5 + 2 + 1, **CLOSE)
    arc = Outline([[(1, 0), (-1, 0)]], bulges=[(1, 1)], tolerance=1e-4, closed=False)
    assert TranslationalSweep(arc, 2.0).mesh().area() == pytest.approx(2 * pi, rel=1e-4)


@pytest.mark.parametrize("fit", ["area-true", "circumscribed"])
def test_fit_is_that_of_the_contour(fit):
    disc = TranslationalSweep(Circle(1, 9), 2.0, fit=fit).mesh().volume()
    assert disc == pytest.approx(2 * pi, **CLOSE) if fit == "area-true" else disc > 2 * pi


@pytest.mark.thorough
def test_random_prisms_are_solids(draws):
    """Of each island with h holes a body of genus h. The draft is up to the largest, either way."""
    random = np.random.default_rng(5)
    for _ in range(draws):
        contour, holes = outline(random)
        section = contour.section()
        direction = (*random.uniform(-2, 2, 2), random.uniform(0.2, 2))
        signs = random.choice([-1.0, 0.0, 1.0], len(section.areas))
        most, _ = reachable(section, mitres(section) * signs[section.loop_of, None], 10.0)
        slopes = signs * min(most, 10.0) * random.uniform(0.1, 0.97)
        steps, directions = int(random.integers(1, 5)), str(random.choice(["up", "symmetric", "both"]))
        mesh = TranslationalSweep(
            contour, 1.0, directions, 0.7, direction, steps, tapers=np.arctan(slopes), reference="centroid"
        ).mesh()
        assert_solid(mesh, sum(2 - 2 * h for h in holes))
        heights = {"up": [1.0], "symmetric": [0.5, 0.5], "both": [1.0, 0.7]}[directions]
        assert_caps_cover(mesh, section, heights, slopes)
        assert mesh.volume() == pytest.approx(steiner(section, heights, slopes), rel=1e-10)


@pytest.mark.parametrize(
    ("sentence", "given"),
    {
        "height: must be more than 0, got 0": dict(height=0),
        "height: must be a number of metres, got '1 m'": dict(height="1 m"),
        "depth: must be more than 0, got -1": dict(depth=-1),
        "directions: must be one of up, symmetric, both, got 'down'": dict(directions="down"),
        "direction: must point up, out of the contour's plane, or lie within it, got [1.0, 0.0, 1e-07]": dict(
            direction=(1, 0, 1e-7)
        ),
        "direction: must point up, out of the contour's plane, or lie within it, got [0.0, 0.0, -1.0]": dict(
            direction=(0, 0, -1)
        ),
        "direction: must point up, out of the contour's plane, or lie within it, got [0.0, 0.0, 0.0]": dict(
            direction=(0, 0, 0)
        ),
        "steps: must be 1 where the direction lies in the plane, got 2": dict(direction=(1, 0, 0), steps=2),
        "taper: must be 0 where the direction lies in the plane, got -0.1": dict(direction=(1, 0, 0), hole_taper=-0.1),
        "direction: must be a list of 3, got [1, 2]": dict(direction=[1, 2]),
        "steps: must be at least 1, got 0": dict(steps=0),
        "steps: must make at most 20,000,000 vertices, got 25600256": dict(steps=100_000, contour=Circle(1, 256)),
        "taper: must be at most 1.55334, got 1.6": dict(taper=1.6),
        "hole_taper: must be at least -1.55334, got -2": dict(hole_taper=-2.0),
        "tapers: must be at most 1.553 in size, got 3": dict(tapers=[0.1, 3]),
        "tapers: must have one angle a loop, 1, got 2": dict(tapers=[0.1, 0.2]),
        "taper: must be 0 where the contour has open curves or points, which have no inside, got 0.1": dict(
            taper=0.1, contour=Outline([[(0, 0), (1, 0)]], closed=False)
        ),
        "taper: must be 0 where the contour has open curves or points, which have no inside, got -0.1": dict(
            taper=-0.1, contour=Mixed()
        ),
        "tapers: must be 0 where the contour has open curves or points, which have no inside, got 0.1": dict(
            tapers=[0, 0.1], contour=Outline([[(0, 0), (1, 0)], [(0, 1), (1, 2), (1, 3)]], closed=False)
        ),
        "fit: must be inscribed where the contour is open, got 'area-true'": dict(
            fit="area-true", contour=Outline([[(0, 0), (1, 0)]], closed=False)
        ),
        "reference: must be one of origin, centroid, point, got 'middle'": dict(reference="middle"),
        "end: must be one of flat, open, got 'round'": dict(end="round"),
    }.items(),
)
def test_what_will_not_do_is_refused_in_one_sentence(sentence, given):
    with pytest.raises(ShapeError) as caught:
        TranslationalSweep(**given)
    assert str(caught.value) == sentence


def test_steepest_angle_is_89_degrees():
    assert TranslationalSweep(Rectangle(1, 1), 1e-3, taper=radians(89)).mesh().volume() > 0
