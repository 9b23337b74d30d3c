# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Drafts whose edges vanish, part and join, against roofs in closed form and offsets by Clipper2.

Clipper2 comes with manifold3d. It works in steps of 1e-8 of a unit, so areas of outlines of size 1 are known to about
1e-7. It lets a corner that grows outwards run through an edge that it meets, where a draft ends it: the outlines that
have such corners, seen in pictures, are named.
"""

import json
import re
import tracemalloc
from dataclasses import replace
from math import atan, tan

import numpy as np
import pytest
from contour_inputs import DATA, drawn, star
from hypothesis import given
from hypothesis import strategies as st
from solids import assert_solid, box

import sweep_addon as sw
from sweep_addon.core.contours import Circle, Outline, Rectangle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.grids.laying import CAP
from sweep_addon.core.rings.wavefront import Wavefront
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep

REAL = json.loads((DATA / "real_outlines.json").read_text())["outlines"]
RUN_THROUGH = "dxf2gcode-016 ezdxf-003 mdi-svg-044 simple-icons-024 simple-icons-038 simple-icons-058".split()
TOUCHING = ("bootstrap-icons-030", 0.1, -1)  # two corners meet at this height itself
GAUSS = (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5)  # exact for the square functions that areas are between events
SAME = 1e-6  # of a volume or an area: vertices that single precision does not tell apart are one

LETTER_L = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]
PLUS = [(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)]
RING = [box((0, 0), (4, 4)), box((1, 1), (3, 3))]


def comb(teeth):
    """A back 0.5 m thick and teeth 1 m wide, 1 m apart and 2.5 m long."""
    points = [(0, 0), (2 * teeth - 1, 0)]
    for x in range(2 * teeth - 2, -1, -2):
        points += [(x + 1, 0.5), (x + 1, 3), (x, 3), (x, 0.5)]
    return [*points[:2], *points[3:-1]]


def by_parts(*parts):
    """The integral of polynomials of a distance, each from where the one before ends: pairs of end and coefficients."""
    whole, start = 0.0, 0.0
    for end, coefficients in parts:
        whole += np.diff(np.polynomial.Polynomial(coefficients).integ()(np.array([start, end])))[0]
        start = end
    return whole


# loops, distance, area moved inwards as polynomials of the distance, Euler characteristic, vertices of the roof alone
ROOFS = {
    "hip roof of a rectangle": ([box((0, 0), (3, 2))], 1.0, [(1.0, [6, -10, 4])], 2, 2),
    "an L, whose valley ends where its ridges meet": ([LETTER_L], 0.5, [(0.5, [3, -8, 4])], 2, 3),
    "a plus, four arms that meet in a point": ([PLUS], 0.5, [(0.5, [5, -12, 4])], 2, 5),
    "a ring, whose walls meet all round": (RING, 0.5, [(0.5, [12, -24])], 0, 4),
    "a comb in four pieces": ([comb(4)], 0.4, [(0.25, [13.5, -35, 4]), (0.4, [12, -32, 16])], 2, None),
    "a comb of ten to its ridges": ([comb(10)], 0.5, [(0.25, [34.5, -89, 4]), (0.5, [30, -80, 40])], 2, None),
}


def roofed(loops, distance, **more):
    """A sweep drafted at 45 degrees, so that its edges have moved by its height."""
    return TranslationalSweep(Outline(loops), distance, taper=atan(1.0), hole_taper=atan(1.0), **more)


@pytest.mark.parametrize("name", ROOFS)
def test_roof_has_the_volume_of_its_closed_form(name):
    loops, distance, areas, euler, added = ROOFS[name]
    mesh = roofed(loops, distance).mesh()
    assert_solid(mesh, euler)
    assert mesh.volume() == pytest.approx(by_parts(*areas), rel=1e-9)
    assert added is None or len(mesh.vertices) == sum(map(len, loops)) + added


def test_sides_of_a_roof_are_as_many_as_edges_and_lean_by_the_taper():
    mesh = roofed([PLUS], 0.5).mesh()
    sides = mesh.topology.material != CAP
    normals = mesh.normals[sides] / np.linalg.norm(mesh.normals[sides], axis=1, keepdims=True)
    assert sides.sum() == len(PLUS)
    assert np.abs(normals[:, 2] - 0.5**0.5).max() < 1e-12


def test_slopes_move_events_up_and_down_but_not_the_contour():
    """A taper half as steep reaches the same at twice the height; obliquely the volume stays (Cavalieri)."""
    steep, gentle = roofed([comb(4)], 0.4).mesh(), TranslationalSweep(Outline([comb(4)]), 0.8, taper=atan(0.5)).mesh()
    oblique = roofed([comb(4)], 0.4, direction=(1, -2, 0.7)).mesh()
    assert gentle.volume() == pytest.approx(2 * steep.volume(), rel=1e-9)
    assert np.allclose(np.sort(gentle.vertices[:, 2]), 2 * np.sort(steep.vertices[:, 2]), rtol=0, atol=1e-12)
    assert oblique.volume() == pytest.approx(steep.volume(), rel=1e-9)
    assert_solid(oblique, 2)


def test_both_directions_have_the_plane_of_the_contour_between():
    """One way past what happens, the other not as far as that."""
    both = roofed([LETTER_L], 0.45, directions="both", depth=0.5).mesh()
    assert both.volume() == pytest.approx(by_parts((0.45, [3, -8, 4])) + by_parts((0.5, [3, -8, 4])), rel=1e-9)
    even = roofed([LETTER_L], 1.0, directions="symmetric").mesh()
    assert even.volume() == pytest.approx(2 * by_parts((0.5, [3, -8, 4])), rel=1e-9)
    for mesh in (both, even):
        assert_solid(mesh, 2)
        parting = (mesh.vertices[mesh.edges][:, :, 2] == 0).all(axis=1)
        assert parting.sum() == 6 and mesh.topology.sharp[parting].all()


def test_steps_cut_faces_at_their_heights():
    whole, cut = roofed([comb(3)], 0.4).mesh(), roofed([comb(3)], 0.4, steps=4).mesh()
    assert_solid(cut, 2)
    assert cut.volume() == pytest.approx(whole.volume(), rel=1e-9)
    assert set(cut.vertices[:, 2].round(9).tolist()) == {0, 0.1, 0.2, 0.25, 0.3, 0.4}
    z = cut.vertices[cut.corners, 2]
    tall = np.maximum.reduceat(z, cut.offsets[:-1]) - np.minimum.reduceat(z, cut.offsets[:-1])
    assert tall.max() < 0.1 + 1e-9, "no face goes past a step"


def test_steps_of_more_than_a_million_places_are_refused():
    with pytest.raises(ShapeError, match="^steps: must be at most 83333 where edges of the contour vanish or meet"):
        roofed([comb(3)], 0.4, steps=83_334).mesh()


def test_contours_of_frames_are_those_of_the_heights():
    """A comb parts in as many loops as it has teeth."""
    frames = roofed([comb(3)], 0.4, steps=4).frames()
    heights = [float(loop[0, 0, 2]) for loop in frames.contours]
    assert heights == pytest.approx([0, 0.1, 0.2, 0.3, 0.3, 0.3, 0.4, 0.4, 0.4])


def test_open_ends_leave_out_their_caps():
    mesh = roofed([comb(3)], 0.4, start="open", end="open").mesh()
    assert (mesh.topology.material != CAP).all() and len(mesh.non_manifold_edges()) == 0
    assert len(mesh.boundary_edges()) == 12 + 3 * 4


def test_texture_is_in_true_lengths_and_never_mirrored():
    mesh = roofed([comb(3)], 0.4).mesh()
    ahead = mesh.topology.following
    apart = np.linalg.norm(mesh.vertices[mesh.corners] - mesh.vertices[mesh.corners[ahead]], axis=1)
    assert np.abs(np.linalg.norm(mesh.uv - mesh.uv[ahead], axis=1) - apart).max() < 1e-12
    beside = roofed([comb(3)], 0.2).mesh()  # on which nothing happens
    for made in (mesh, beside, roofed([comb(3)], 0.4, texture="unit").mesh()):
        (x, y), on = made.uv.T, made.topology.following
        areas = np.add.reduceat(x * y[on] - y * x[on], made.offsets[:-1])
        assert np.ptp(np.sign(areas)) == 0 and areas[0] * beside.uv.size > 0
    unit_square = roofed([comb(3)], 0.4, texture="unit").mesh().uv
    assert unit_square.min() >= 0 and unit_square.max() <= 1 + 1e-12
    assert roofed([comb(3)], 0.4, texture="none").mesh().uv is None


def test_smooth_contours_are_smooth_and_ridges_are_sharp():
    """Edges of a flattened arc turn little, those of a ridge, a cap and the contour's plane much."""
    mesh = TranslationalSweep(Rectangle(4, 2, 0.5), 0.9, taper=atan(1.0)).mesh()
    z = mesh.vertices[mesh.edges][:, :, 2]
    assert mesh.topology.sharp[z[:, 0] == z[:, 1]].all()
    assert not mesh.topology.sharp[(z.min(axis=1) == 0) & (z.max(axis=1) > 0)].any()


def test_attributes_tell_heights():
    mesh = roofed([comb(3)], 0.8, directions="symmetric").mesh()
    attributes = mesh.attributes
    assert np.abs(attributes["arc_length"] - (mesh.vertices[:, 2] + 0.4)).max() < 1e-12
    assert np.abs(attributes["u"] * 0.8 - attributes["arc_length"]).max() < 1e-12
    assert attributes["v"].min() == 0 and attributes["v"].max() <= 5 + 2 * 3 + 3 + 2 + 4 * 2.5


def test_loops_of_different_slopes_meet():
    """A square hole that widens twice as fast as the outside shrinks: walls of 1 m meet at a third of that."""
    mesh = TranslationalSweep(Outline(RING), 1 / 3, tapers=(atan(1.0), atan(2.0))).mesh()
    assert_solid(mesh, 0)
    assert mesh.volume() == pytest.approx(by_parts((1 / 3, [16 - 4, -16 - 16, 4 - 16])), rel=1e-9)


def test_a_drawing_of_twelve_petals_is_drafted_in_twelve_ways_alike():
    """Its petals are holes that do not move. One of them is closed in the file by an edge of a thousandth of a unit
    that leads backward, which would be a wall in the way of the outside for ever."""
    pytest.importorskip("svgelements")
    flower = sw.contours.from_svg(DATA / "svg" / "flower1.svg")
    height = 4 / tan(1.5)
    loops = [loop for (loop,) in TranslationalSweep(flower, height, taper=1.5).frames().contours]
    x, y = zip(*(loop[:, :2].T for loop in loops if loop[0, 2] == height), strict=True)
    areas = [(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2 for x, y in zip(x, y, strict=True)]
    assert len(areas) == 12 and np.ptp(areas) < 0.02 * np.mean(areas)
    angles = np.sort([np.arctan2(y.mean(), x.mean()) for x, y in zip(x, y, strict=True)])
    assert np.abs(np.diff(angles) - np.pi / 6).max() < 0.05  # of means of corners
    with pytest.raises(ShapeError, match="^taper: must be at most .* nothing is left"):
        TranslationalSweep(flower, 5 / tan(1.5), taper=1.5).mesh()


def test_edges_of_different_slopes_that_meet_in_line_are_refused():
    """Blocks that grow meet 1 m up, and their tops are there on one line, which would go on at two speeds."""
    blocks = Outline([box((0, 0), (2, 1)), box((3.3, 0.1), (5, 0.5))])
    with pytest.raises(ShapeError) as caught:
        TranslationalSweep(blocks, 1.5, tapers=(-atan(0.4), -atan(0.9))).mesh()
    assert str(caught.value).startswith("tapers: must be equal for loops whose edges meet in parallel, got ")
    assert_solid(TranslationalSweep(blocks, 1.2, tapers=(-atan(0.4), -atan(0.8))).mesh(), 2)


def test_holes_that_touch_at_the_height_itself_are_refused():
    """Two jaws grow until their corners touch there, and close off a hole; hardly beyond, that is a tunnel."""
    jaws = Outline([[(0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (5, 4), (5, 2), (6, 2), (6, 5), (0, 5)]])
    with pytest.raises(
        ShapeError, match=r"^taper: must not end just where a hole touches: a little more or less will do"
    ):
        TranslationalSweep(jaws, 0.5, taper=-atan(1.0)).mesh()
    for height, euler in ((0.4999, 2), (0.5001, 0)):
        assert_solid(TranslationalSweep(jaws, height, taper=-atan(1.0)).mesh(), euler)


def test_a_corner_may_reach_the_opposite_edge_at_the_height_itself():
    """Of a notch half way down: its corner moves by the square root of 2, and the contour parts at the end."""
    notched = [(0, 0), (4, 0), (4, 2), (3, 2), (2, 1), (1, 2), (0, 2)]
    height = 1 / (1 + 2**0.5)
    mesh = roofed([notched], height).mesh()
    assert_solid(mesh, 2)
    turns = [1, 1, 1, np.tan(np.pi / 8), -1, np.tan(np.pi / 8), 1]  # of the tangents of half the turns
    area = [7, -(4 + 2 + 1 + 2 * 2**0.5 + 1 + 2), sum(turns)]
    assert mesh.volume() == pytest.approx(by_parts((height, area)), rel=1e-9)
    assert (mesh.normals[mesh.topology.material == CAP, 2] > 0).sum() == 2


def test_trees_and_solids_take_them():
    pytest.importorskip("manifold3d")
    roof = roofed([LETTER_L], 0.5)
    assert len(roof.self_intersections()) == 0
    assert roof.solid().volume() == pytest.approx(roof.mesh().volume(), rel=1e-12)
    rest = (sw.solids.Block(8, 8, 8) - roof).mesh()
    assert rest.volume() == pytest.approx(512 - by_parts((0.5, [3, -8, 4])), rel=1e-9)


def test_planes_pass_through_points_as_without_a_draft():
    points = [(1.0, 0.5, 0.25), (0.5, 1.5, 0.4)]
    found = sw.inverse_sweep(roofed([LETTER_L], 0.5, direction=(1, 0, 1)), points)
    assert found.u.tolist() == pytest.approx([0.25, 0.4])
    assert np.abs(found.images - [(0.75, 0.5), (0.1, 1.5)]).max() < 1e-9


# Beside the other program


def offset(section, distance):
    """The section moved inwards, by Clipper2: a `manifold3d.CrossSection`."""
    m3 = pytest.importorskip("manifold3d")
    loops = np.split(section.points, section.offsets[1:-1])
    return m3.CrossSection(loops, m3.FillRule.EvenOdd).offset(-distance, m3.JoinType.Miter, 1e6)


def assert_sound(mesh):
    """Closed, manifold, outward, of plane faces that have an area, each vertex once also in single precision."""
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges()) and mesh.volume() > 0
    size = np.abs(mesh.vertices).max()
    areas = np.linalg.norm(mesh.normals, axis=1)
    assert areas.min() > 1e-10 * size**2
    face = np.repeat(np.arange(len(areas)), np.diff(mesh.offsets))
    middles = np.add.reduceat(mesh.vertices[mesh.corners], mesh.offsets[:-1]) / np.diff(mesh.offsets)[:, None]
    off = np.einsum("ij,ij->i", mesh.vertices[mesh.corners] - middles[face], (mesh.normals / areas[:, None])[face])
    assert np.abs(off).max() < SAME * size
    assert len(np.unique((mesh.vertices / size).astype(np.float32), axis=0)) == len(mesh.vertices)


def unit(outline):
    """A real outline as the contour that has size 1, as it is drawn in straight edges."""
    section = drawn(outline).section()
    return Outline(np.split(section.points / section.size, section.offsets[1:-1]))


def volume_by_offsets(section, heights, slope):
    """The integral of the area of offsets over the height; between the heights it is a square function of it."""
    heights = np.unique(heights.round(7))
    whole = 0.0
    for low, high in zip(heights[:-1], heights[1:], strict=True):
        areas = [offset(section, slope * (low + part * (high - low))).area() for part in GAUSS]
        whole += (high - low) * sum(areas) / 2
    return whole


def compare_with_offsets(outline, share, slope):
    """A real outline drafted to a share of its size, and its volume beside that of its offsets."""
    contour = unit(outline)
    try:
        mesh = TranslationalSweep(contour, share, taper=atan(slope)).mesh()
    except ShapeError as error:
        told = str(error)
        assert "nothing is left" in told or (outline["id"], share, slope) == TOUCHING
        if slope > 0:
            gone = float(told.split("nothing is left ")[1].split()[0])
            assert gone < share
            assert offset(contour.section(), 0.99 * gone).area() > 0
            assert offset(contour.section(), 1.001 * gone).area() == pytest.approx(0, abs=1e-7)
        return
    assert_sound(mesh)
    if slope > 0 or outline["id"] not in RUN_THROUGH:
        whole = volume_by_offsets(contour.section(), np.append(mesh.vertices[:, 2], (0, share)), slope)
        assert mesh.volume() == pytest.approx(whole, rel=SAME)


@pytest.mark.parametrize("slope", [1, -1])
@pytest.mark.parametrize("share", [0.01, 0.03, 0.1])
def test_real_outlines_are_as_large_as_their_offsets(share, slope):
    for outline in REAL[::40]:
        compare_with_offsets(outline, share, slope)


@pytest.mark.large
@pytest.mark.parametrize("slope", [1, -1])
@pytest.mark.parametrize("share", [0.01, 0.03, 0.1])
def test_all_real_outlines_are_as_large_as_their_offsets(share, slope):
    for outline in REAL:
        compare_with_offsets(outline, share, slope)


@st.composite
def outlines(draw):
    """Random simple outlines: stars, some with holes, and columns of cells, where much happens at once."""
    random = np.random.default_rng(draw(st.integers(0, 2**32)))
    kind = draw(st.sampled_from(["star", "holes", "cells"]))
    if kind == "star":
        return Outline([star(random, int(random.integers(3, 30)), 0.8)])
    if kind == "holes":
        holes = [0.1 * star(random, int(random.integers(5, 8))) + (x, 0) for x in (-0.45, 0.4)]
        return Outline([star(random, int(random.integers(12, 20)), 1.3), *holes])
    columns = int(random.integers(2, 7))
    heights, floors = random.integers(1, 4, columns), -random.integers(0, 3, columns)
    top = [(x + side, y) for x, y in reversed(list(enumerate(heights.tolist()))) for side in (1, 0)]
    return Outline([[(x + side, y) for x, y in enumerate(floors.tolist()) for side in (0, 1)] + top])


def crossed(mesh, height):
    """The area of a mesh at a height, by manifold3d."""
    m3 = pytest.importorskip("manifold3d")
    triangles = np.asarray(mesh.triangles, dtype=np.uint64)
    return m3.Manifold(m3.Mesh64(np.ascontiguousarray(mesh.vertices), triangles)).slice(height).area()


def same_area(section, distance, area):
    """Whether Clipper2 finds the area, in one step or in several in which no hollow corner runs through an edge."""
    m3 = pytest.importorskip("manifold3d")
    for steps, limit in ((1, 1e6), (8, 1e6), (64, 10)):
        made = offset(section, 0.0)
        for _ in range(steps):
            made = made.offset(-distance / steps, m3.JoinType.Miter, limit).simplify(1e-6)
        if abs(made.area() - area) < 1e-5 * section.size**2:
            return True
    return False


@given(outlines(), st.floats(0.05, 1.0))
def test_random_drafts_are_solids_whose_sections_are_offsets(contour, height):
    """Inwards as far as there is anything, and outwards, or a little less where loops touch at the height itself."""
    section = contour.section()
    for slope in (1.0, -1.0):
        low = height
        while True:
            try:
                mesh = TranslationalSweep(contour, low, taper=atan(slope), hole_taper=atan(slope)).mesh()
                break
            except ShapeError as error:
                told = re.search(r"(?:nothing is left|edges meet) ([\d.e-]+) m|hole touches", str(error))
                low = float(told[1]) * 0.999 if told[1] else 0.97 * low
        assert_sound(mesh)
        for part in (0.31, 0.73, 0.97) if slope > 0 else ():
            assert same_area(section, part * low, crossed(mesh, part * low))


def inside(points, loops):
    """Whether a ray from each point (n, 2) along x crosses edges of loops an odd number of times: (n,) bool."""
    found = np.zeros(len(points), dtype=bool)
    for loop in loops:
        a, b = loop[:, None], np.roll(loop, -1, axis=0)[:, None]
        spans = (a[..., 1] <= points[:, 1]) != (b[..., 1] <= points[:, 1])
        rise = np.where(spans, b[..., 1] - a[..., 1], 1.0)
        x = a[..., 0] + (points[:, 1] - a[..., 1]) / rise * (b[..., 0] - a[..., 0])
        found ^= ((x > points[:, 0]) & spans).sum(axis=0) % 2 == 1
    return found


@pytest.mark.parametrize("name", ROOFS)
@pytest.mark.parametrize("directions", ["up", "symmetric"])
def test_membership_is_that_of_the_offset_at_the_height_of_each_point(name, directions):
    """Points within 1e-6 m of the surface are left out: Clipper2 works in steps of 1e-8."""
    loops, distance, *_ = ROOFS[name]
    shape = roofed(loops, distance if directions == "up" else 2 * distance, directions=directions,
                   direction=(0.3, 0.2, 1))  # fmt: skip
    random, corners = np.random.default_rng(3), np.concatenate(loops)
    section = shape.contour.section()
    for z in random.uniform(0.0 if directions == "up" else -distance, distance, 12):
        points = random.uniform(corners.min(axis=0) - 0.1, corners.max(axis=0) + 0.1, (300, 2))
        polygons = [np.array(loop) for loop in offset(section, abs(z)).to_polygons()]
        around = points + 1e-6 * np.array([(1, 1), (1, -1), (-1, 1), (-1, -1)])[:, None]
        told = np.array([inside(points, polygons), *(inside(some, polygons) for some in around)])
        clear = (told == told[0]).all(axis=0)
        placed = np.column_stack((points + z * shape.way[:2], np.full(len(points), z)))
        assert clear.sum() > 290
        assert (sw.classify(shape, placed, tolerance=1e-9)[clear] == np.where(told[0], 1, -1)[clear]).all()


def test_vertices_are_on():
    shape = roofed([comb(4)], 0.4)
    assert (sw.classify(shape, shape.mesh().vertices) == 0).all()


def test_drafts_on_which_nothing_happens_are_the_grids_they_were():
    """As many vertices as both ends have, in the order of a grid."""
    mesh = roofed([LETTER_L], 0.49).mesh()
    assert mesh.rings == 2 and len(mesh.vertices) == 12 and mesh.chart.grid.columns == 6
    many = TranslationalSweep(Circle(1.0, 64), 0.9, taper=atan(1.0)).mesh()
    assert len(many.vertices) == 128 and many.chart.grid.columns == 64


def wavy(points):
    turns = 2 * np.pi * np.arange(points) / points
    radius = 1 + 0.1 * np.sin(40 * turns)
    return Outline([np.stack((radius * np.cos(turns), radius * np.sin(turns)), axis=1)])


def test_what_vertices_come_to_takes_few_bytes():
    """Of 1,000 points each 24 bytes for up to 1,000 lines; as tuples of numbers, 4,000 points took a gigabyte."""
    section = wavy(1000).section()
    tracemalloc.start()
    try:
        Wavefront(section, np.ones(1000), 1.0)
        assert tracemalloc.get_traced_memory()[1] < 1e7
    finally:
        tracemalloc.stop()


@pytest.mark.parametrize("directions", ["up", "symmetric"])
def test_a_roof_tells_how_far_it_is_and_is_kept(directions):
    parts, again = [], []
    shape = TranslationalSweep(wavy(400), 0.5, directions, taper=atan(0.5), steps=2)
    solid = shape.solid(parts.append)
    assert parts == sorted(parts) and parts[0] < 0.01 and parts[-1] == 1.0 and len(parts) > 400
    assert shape.solid(again.append).topology is solid.topology and again == []


def test_a_roof_is_ended_by_whom_it_tells_and_made_for_who_asks_again():
    shape, parts = TranslationalSweep(wavy(401), 0.5, taper=atan(0.5)), []

    def enough(part):
        parts.append(part)
        if part > 0.6:
            raise InterruptedError

    with pytest.raises(InterruptedError):
        shape.solid(enough)
    assert parts[-2] <= 0.6 < parts[-1] < 0.9
    assert_solid(shape.solid(), 2)


def test_only_roofs_of_many_points_are_waited_for():
    many = TranslationalSweep(wavy(1200), 0.2, taper=atan(0.5))
    assert many.make_solid and many.surface() is None
    assert not replace(many, contour=wavy(900)).make_solid
    assert replace(many, end="open").make_solid  # it has a mesh, though no solid
    assert not replace(many, height=1e-4).make_solid  # no edge vanishes
    assert not replace(many, taper=0.0).make_solid


def test_a_change_of_direction_keeps_the_faces():
    """What is found of a contour is kept: the arrays of its faces are the same."""
    roof = roofed([comb(4)], 0.4)
    assert replace(roof, direction=(1.0, 0.0, 1.0)).mesh().topology is roof.mesh().topology
