# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Offsets of solids against Steiner's formula, each engine against the others, and random shapes that must be valid."""

from dataclasses import replace

import numpy as np
import pytest
from brute_force import crossing_faces, distances
from contour_inputs import OUTLINES, drawn

from sweep_addon.core.contours import Circle, Star
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.distance import Tree, nearest
from sweep_addon.core.meshes.booleans import hull_body, mesh_of
from sweep_addon.core.meshes.facets import facets
from sweep_addon.core.meshes.polyhedron import polyhedron
from sweep_addon.core.offsets import rounded_union
from sweep_addon.core.offsets.band import narrow_band
from sweep_addon.core.offsets.convex import is_convex
from sweep_addon.core.offsets.crossings import crossing_pairs
from sweep_addon.core.offsets.implicit import Implicit
from sweep_addon.core.offsets.offset import Engine, Side, offset
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.offset_surface import OffsetSurface
from sweep_addon.core.shapes.translational_sweep import TranslationalSweep
from sweep_addon.core.solids import Block, Bracket, Cylinder, DrilledBlock, Triangles
from sweep_addon.core.stations.sampling import Count
from sweep_addon.core.trajectories import Formula, TorusKnot

pytest.importorskip("manifold3d")


def triangulated(mesh):
    return mesh.vertices, facets(mesh)[0]


def steiner(mesh, radius):
    """The volume within a radius of a convex solid: V + A r + the edges' turns r^2 / 2 + a ball."""
    normals = mesh.normals / np.linalg.norm(mesh.normals, axis=1, keepdims=True)
    sides = np.full((len(mesh.edges), 2), -1)
    face = np.repeat(np.arange(len(normals)), np.diff(mesh.offsets))
    for corner, edge in enumerate(mesh.topology.corner_edges):
        sides[edge, int(sides[edge, 0] >= 0)] = face[corner]
    one, other = normals[sides].swapaxes(0, 1)
    turns = np.arctan2(np.linalg.norm(np.cross(one, other), axis=1), np.einsum("ij,ij->i", one, other))
    lengths = np.linalg.norm(np.diff(mesh.vertices[mesh.edges], axis=1)[:, 0], axis=1)
    return mesh.volume() + mesh.area() * radius + lengths @ turns * radius**2 / 2 + 4 / 3 * np.pi * radius**3


def ellipsoid(count):
    """Random points of an ellipsoid and what they hold."""
    points = np.random.default_rng(count).normal(size=(count, 3))
    return mesh_of(hull_body(points / np.linalg.norm(points, axis=1, keepdims=True) * (1.0, 0.7, 0.5)))


CONVEX = {
    "block": Block(1.0, 0.8, 0.6).mesh(),
    "cylinder": Cylinder().mesh(),
    "few": mesh_of(hull_body(np.random.default_rng(0).normal(size=(26, 3)))),
    "many": ellipsoid(1000),
}
HOLLOW = {"bracket": Bracket().mesh(), "drilled block": DrilledBlock(points=24).mesh()}


def size(mesh):
    return np.ptp(mesh.vertices, axis=0).max()


def assert_valid(found, euler=None):
    mesh = polyhedron(found.vertices, found.triangles)
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    assert mesh.volume() > 0 and not found.crossing
    assert len(np.unique(found.vertices, axis=0)) == len(found.vertices)
    assert euler is None or mesh.euler_characteristic() == euler
    return mesh


@pytest.mark.parametrize("name", CONVEX)
def test_the_volume_around_a_convex_solid_is_that_of_steiner_to_second_order(name):
    solid = CONVEX[name]
    radius = 0.3 * size(solid)
    expected, errors = steiner(solid, radius), []
    for angle in (0.2, 0.1, 0.05):
        found = offset(solid, radius, tolerance=radius * (1 - np.cos(angle / 2)))
        assert found.engine == Engine.CONVEX
        errors.append(1 - assert_valid(found, euler=2).volume() / expected)
    assert 0 < errors[2] < 0.1 * 0.05**2 and errors[0] < 0.1 * 0.2**2
    assert name == "many" or errors[0] / errors[2] > 8  # the faces of many are finer than the first two steps


def test_all_vertices_around_a_convex_solid_are_at_the_radius_and_no_face_is_beyond_its_bounds():
    solid = CONVEX["many"]
    found = offset(solid, 0.2)
    distances = nearest(Tree.of(solid.vertices[facets(solid)[0]]), found.vertices).distances
    np.testing.assert_allclose(distances, 0.2, atol=1e-12)
    assert_between(solid, found)


def assert_between(solid, found, per_face=2):
    """Places on the faces of an offset are as far from the solid as it says, by a search of all triangles."""
    random = np.random.default_rng(0)
    which = np.tile(random.permutation(len(found.triangles))[:1500], per_face)
    weights = random.dirichlet((0.7, 0.7, 0.7), len(which))
    places = np.einsum("ni,nij->nj", weights, found.vertices[found.triangles[which]])
    distances = nearest(Tree.of(solid.vertices[facets(solid)[0]]), places).distances
    rounding = 1e-9 * size(solid)
    assert (distances >= found.lower[which] - rounding).all()
    assert (distances <= found.upper[which] + rounding).all()


def test_a_block_shrinks_to_a_block():
    found = offset(Block(1.0, 0.8, 0.6).mesh(), 0.1, Side.INSIDE)
    assert len(found.triangles) == 12 and (found.lower == found.upper).all()
    assert assert_valid(found, euler=2).volume() == pytest.approx(0.8 * 0.6 * 0.4, rel=1e-12)
    shell = offset(Block(1.0, 0.8, 0.6).mesh(), 0.1, Side.SHELL)
    outer = offset(Block(1.0, 0.8, 0.6).mesh(), 0.1)
    whole = assert_valid(outer).volume() - 0.8 * 0.6 * 0.4
    assert assert_valid(shell, euler=4).volume() == pytest.approx(whole, rel=1e-12)


@pytest.mark.thorough
@pytest.mark.parametrize("name", CONVEX)
def test_a_level_set_around_a_convex_solid_has_steiners_volume_to_second_order(name):
    solid = CONVEX[name]
    radius = 0.2 * size(solid)
    expected, errors = steiner(solid, radius), []
    for step in (0.1, 0.05, 0.025):
        found = offset(solid, radius, tolerance=(step * size(solid)) ** 2 / (2 * radius), engine=Engine.LEVEL_SET)
        errors.append(1 - assert_valid(found, euler=2).volume() / expected)
        assert_between(solid, found)
    assert 0 < errors[2] < 1.5e-3 and errors[0] / errors[2] > 10


@pytest.mark.parametrize("points", [16, 48])
def test_triangles_of_rounded_faces_are_as_far_as_is_told(points):
    """Of these blocks a union puts four triangles across others, up to 6 mm too far out, or leaves a piece out."""
    solid = DrilledBlock(points=points).mesh()
    found = offset(solid, 0.025)
    assert found.engine == Engine.ROUNDED_FACES
    vertices, triangles = triangulated(solid)
    far = distances(found.vertices[found.triangles].mean(axis=1), vertices[triangles])
    assert (far > found.lower - 1e-9).all() and (far < found.upper + 1e-9).all()
    assert (found.lower > 0.024).all() and (found.upper <= 0.025).all()


@pytest.mark.thorough
@pytest.mark.parametrize("side", Side)  # of all of which the union is the same
@pytest.mark.parametrize("name", HOLLOW)
def test_rounded_faces_and_level_sets_agree(name, side):
    """Two ways to the same set, one from inside, one with chords on both sides: as near as their tolerances."""
    solid = HOLLOW[name]
    radius = 0.05 * size(solid)
    exact = offset(solid, radius, side, tolerance=radius / 20)
    field = offset(solid, radius, side, tolerance=radius / 20, engine=Engine.LEVEL_SET)
    assert exact.engine == Engine.ROUNDED_FACES and field.engine == Engine.LEVEL_SET
    meshes = [assert_valid(found) for found in (exact, field)]
    assert meshes[0].euler_characteristic() == meshes[1].euler_characteristic()
    assert meshes[0].volume() == pytest.approx(meshes[1].volume(), rel=1e-2)
    for found in (exact, field):
        assert_between(solid, found)


@pytest.mark.thorough
def test_a_ball_larger_than_a_hole_closes_it():
    solid = HOLLOW["drilled block"]
    for engine in (Engine.ROUNDED_FACES, Engine.LEVEL_SET):
        assert_valid(offset(solid, 0.5 * size(solid), engine=engine), euler=2)
        assert_valid(offset(solid, 0.05 * size(solid), engine=engine), euler=solid.euler_characteristic())


@pytest.mark.thorough
def test_a_tube_grows_by_the_radius():
    """A knot of radius 0.3 m becomes one of 0.5 m while that is less than its reach: Weyl's formula for both."""

    def tube(radius):
        return GeneralizedCylinder(Circle(radius, points=32), TorusKnot(2, 3, major=2.0, minor=0.8), Count(150)).mesh()

    solid = tube(0.3)
    assert not is_convex(*triangulated(solid))
    found = offset(solid, 0.2)
    assert found.engine == Engine.LEVEL_SET
    assert assert_valid(found, euler=0).volume() == pytest.approx(tube(0.5).volume(), rel=4e-3)
    inner = offset(solid, 0.1, Side.INSIDE, tolerance=0.004)
    assert assert_valid(inner, euler=0).volume() == pytest.approx(tube(0.2).volume(), rel=1e-2)


def boxed(vertices, triangles):
    """The cells of a lattice, as large as the largest triangle, that the corners of each one's box are in: (t, 8)."""
    corners = vertices[triangles]
    low, high = corners.min(axis=1), corners.max(axis=1)
    places = np.stack([np.where(np.array(pick), high, low) for pick in np.ndindex(2, 2, 2)], axis=1)
    cells = np.floor((places - low.min(axis=0)) / (high - low).max()).astype(int)
    return cells @ (1, 1 << 20, 1 << 40)


@pytest.mark.thorough
@pytest.mark.parametrize("radius", [0.2, 1.5])
def test_no_faces_cross_where_creases_run_into_each_other(radius):
    """A knot of a star: valleys between its arms, and beyond its reach where strands meet. All near pairs are asked."""
    solid = GeneralizedCylinder(Star(5, 0.5, 0.3), TorusKnot(2, 3, major=2.0, minor=0.8), Count(120)).mesh()
    found = offset(solid, radius)
    assert_valid(found)
    assert not len(crossing_pairs(found.vertices, found.triangles, boxed(found.vertices, found.triangles)))


def test_crossing_pairs_are_those_that_comparing_all_finds():
    thick = GeneralizedCylinder(Circle(1.1, points=10), TorusKnot(2, 3, major=2.0, minor=0.8), Count(60)).mesh()
    vertices, triangles = triangulated(thick)
    mesh = polyhedron(vertices, triangles)
    pairs = crossing_pairs(vertices, triangles, boxed(vertices, triangles))
    alien = [not np.isin(triangles[one], triangles[other]).any() for one, other in pairs]
    assert np.unique(pairs[alien]).tolist() == crossing_faces(mesh).tolist() and len(pairs)


def fourier_tube(random):
    """A closed tube along a random curve, round or a star, thin enough not to meet itself in most cases."""
    parts = [
        " + ".join(f"{a:.3f}*cos({k}*u) + {b:.3f}*sin({k}*u)" for k, (a, b) in enumerate(pairs, 1))
        for pairs in random.normal(size=(3, 3, 2)) / np.arange(1, 4)[:, None]
    ]
    curve = Formula(*parts, start=0.0, end=2 * np.pi)
    contour = random.choice([Circle(1.0, points=12), Star(5, 1.0, 0.6)])
    shape = GeneralizedCylinder(contour, curve, Count(int(random.integers(60, 160))))
    places = shape.self_intersections()
    factor = 0.9 * min(places.largest_safe_size or 0.3, 0.3)
    return GeneralizedCylinder(contour, curve, shape.samples, scale_x=factor, scale_y=factor).mesh()


def random_solid(random):
    """A tube that does not cross itself, or a plate of a real outline."""
    if random.random() < 0.5:
        tube = fourier_tube(random)
        vertices, triangles = triangulated(tube)
        crosses = len(crossing_pairs(vertices, triangles, boxed(vertices, triangles)))
        return random_solid(random) if crosses else tube
    outline = drawn(OUTLINES[random.integers(len(OUTLINES))])
    height = random.uniform(0.1, 1.0) * outline.section().size
    return TranslationalSweep(outline, height=height).mesh()


@pytest.mark.parametrize(
    "count", [pytest.param(5, marks=pytest.mark.thorough), pytest.param(1000, marks=pytest.mark.large)]
)
def test_random_offsets_are_valid(count):
    random = np.random.default_rng(20)
    for _ in range(count):
        solid = random_solid(random)
        radius, side = size(solid) * 10 ** random.uniform(-2, -0.3), random.choice(list(Side))
        try:
            found = offset(solid, radius, side, engine=random.choice([Engine.AUTOMATIC, Engine.LEVEL_SET]))
        except ShapeError as refusal:
            assert side == Side.INSIDE and "must leave something" in str(refusal)
            continue
        assert_valid(found)


def test_refusals():
    tube = GeneralizedCylinder(start="open").mesh()
    with pytest.raises(ShapeError, match="body: must be closed"):
        offset(tube, 0.1)
    block = Block(1.0, 1.0, 1.0).mesh()
    with pytest.raises(ShapeError, match="radius: must leave something of the solid inside, got 0.6"):
        offset(block, 0.6, Side.INSIDE)
    with pytest.raises(ShapeError, match="radius: must leave something"):
        offset(block, 0.5 * (1 - 1e-9), Side.INSIDE)
    with pytest.raises(ShapeError, match="engine: must be another for a solid that is not convex, got 'convex'"):
        offset(HOLLOW["bracket"], 0.1, engine=Engine.CONVEX)
    flipped = polyhedron(block.vertices, triangulated(block)[1][:, ::-1])
    with pytest.raises(ShapeError, match="must look outwards"):
        offset(flipped, 0.1)
    with pytest.raises(ShapeError, match="radius: must leave something of the solid inside, got 0.3"):
        offset(Bracket().mesh(), 0.3, Side.INSIDE, engine=Engine.ROUNDED_FACES)


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["block", *HOLLOW])
def test_a_radius_is_at_least_a_ten_millionth_of_the_size(name):
    solid = (CONVEX | HOLLOW)[name]
    with pytest.raises(ShapeError, match="radius: must be at least .*, 1e-07 of the size of the body"):
        offset(solid, 0.9e-7 * size(solid))
    found = offset(solid, 1.1e-7 * size(solid), engine=Engine.ROUNDED_FACES)
    assert_valid(found, euler=solid.euler_characteristic())


@pytest.mark.parametrize("engine", [Engine.CONVEX, Engine.LEVEL_SET])
@pytest.mark.parametrize("tolerance", [1e-17, 1e-12, 1e-9])
def test_a_tolerance_that_takes_too_much_is_refused_before_anything_is_made(engine, tolerance):
    """At 1e-9 m each would take more than 25 s and at 1e-12 m terabytes; what is told to do is near the limit."""
    with pytest.raises(ShapeError, match="tolerance: must be at least .*e-0[67] for this radius") as refusal:
        offset(Block(0.5, 0.5, 0.5).mesh(), 0.5, tolerance=tolerance, engine=engine)
    assert float(refusal.value.sentence.split()[4]) > 1e-7


def test_a_rod_is_not_taken_for_a_surface():
    """From afar it is a line of cells, of which there are twice and not four times as many at each finer level."""

    def rod(points):
        return np.linalg.norm(points - np.clip(points, (0, 0, 0), (400, 0, 0)), axis=1) - 0.1

    band = narrow_band(Implicit(rod), (-0.1, -0.1, -0.1), (400.1, 0.1, 0.1), 0.05)
    assert 400 * 2 * np.pi * 0.1 / 0.05**2 < len(band.cells) < 2 * 400 * 2 * np.pi * 0.1 / 0.05**2


@pytest.mark.thorough
def test_a_tolerance_that_a_ball_of_64_meridians_does_not_keep_is_kept_by_the_level_set_or_told():
    """A ball of 64 is cos(sqrt(2) pi / 64) of the radius within: 2.4e-3 of it off."""
    solid, radius = HOLLOW["bracket"], 0.3
    assert offset(solid, radius, tolerance=2.5e-3 * radius).engine == Engine.ROUNDED_FACES
    assert offset(solid, radius, tolerance=2.3e-3 * radius).engine == Engine.LEVEL_SET
    told = list(offset(solid, radius, tolerance=1e-6, engine=Engine.ROUNDED_FACES).told(radius))
    assert told[1].startswith("The tolerance is not kept: arcs are up to 0.00072")


def test_of_a_convex_offset_no_cells_are_told():
    (_, told) = offset(CONVEX["block"], 0.5, tolerance=0.4).told(0.5)
    assert told == "The tolerance is large beside the radius: a smaller tolerance makes the offset nearer."


def test_a_rough_one_stands_until_a_fine_one_is_made():
    block = Block(1.0, 1.0, 1.0)
    assert not OffsetSurface(block).make_solid
    assert OffsetSurface(block, tolerance=1e-3).make_solid and OffsetSurface(block, engine="level-set").make_solid


@pytest.mark.parametrize("engine", [Engine.AUTOMATIC, Engine.LEVEL_SET])
def test_a_part_that_looks_inwards_is_a_cavity_or_refused(engine):
    """The volume of both is positive, but a cube of 0.5 m turned inside out beside one of 1 m holds nothing."""
    block = Block(1.0, 1.0, 1.0).mesh()
    faces = triangulated(block)[1]
    faces = np.concatenate((faces, faces[:, ::-1] + len(block.vertices)))
    apart, within = (np.concatenate((block.vertices, 0.5 * block.vertices + place)) for place in ((3, 0, 0), (0, 0, 0)))
    with pytest.raises(ShapeError, match="body: must look outwards where it is not a cavity of another, got 'part 2'"):
        offset(polyhedron(apart, faces), 0.1, engine=engine)
    found = offset(polyhedron(within, faces), 0.1, tolerance=0.005, engine=engine)
    assert assert_valid(found, euler=4).volume() == pytest.approx(steiner(block, 0.1) - 0.3**3, rel=2e-3)


def test_a_solid_that_crosses_itself_is_refused():
    thick = GeneralizedCylinder(Circle(1.1, points=32), TorusKnot(2, 3, major=2.0, minor=0.8), Count(60)).mesh()
    with pytest.raises(ShapeError, match="body: must not cross itself"):
        offset(thick, 0.3, engine=Engine.LEVEL_SET)


def test_the_engine_and_its_bounds_are_told():
    (told,) = offset(CONVEX["block"], 0.1).mesh(0.1).told
    assert "convex" in told


@pytest.mark.thorough
def test_a_radius_that_is_small_beside_the_cells_is_told_to_be():
    tube = GeneralizedCylinder(Circle(0.3, points=24), TorusKnot(2, 3, major=2.0, minor=0.8), Count(100)).mesh()
    found = offset(tube, 0.01, engine=Engine.LEVEL_SET)
    assert_valid(found, euler=0)
    assert "smaller tolerance" in found.mesh(0.01).told[1]
    assert_between(tube, found)


def test_a_solid_of_given_triangles_is_offset_too():
    """Their numbers are read-only."""
    solid = Triangles.of(CONVEX["block"])
    for side in Side:
        assert_valid(offset(solid.mesh(), 0.05, side))
    assert_valid(offset(Triangles.of(HOLLOW["bracket"]).mesh(), 0.01))


@pytest.mark.thorough
def test_the_sides_of_an_offset_are_made_of_one_union(monkeypatch):
    asked, united = [], rounded_union.hulls_united
    monkeypatch.setattr(rounded_union, "KEPT", {})
    monkeypatch.setattr(rounded_union, "hulls_united", lambda *told: asked.append(told) or united(*told))
    shapes = [OffsetSurface(DrilledBlock(points=12), 0.05, side) for side in Side]
    kept = [shape.mesh() for shape in shapes]
    assert len(asked) == 1
    for shape, mesh in zip(shapes, kept, strict=True):
        rounded_union.KEPT.clear()
        assert (shape.mesh().vertices == mesh.vertices).all()
    replace(shape, radius=0.04).mesh()
    assert len(asked) == 5


@pytest.mark.thorough
@pytest.mark.parametrize("engine", [Engine.ROUNDED_FACES, Engine.LEVEL_SET])
def test_progress_rises_step_by_step_and_what_it_raises_ends_the_work(engine):
    told = []
    shape = OffsetSurface(DrilledBlock(points=24), 0.03, tolerance=0.003, engine=engine)
    made = shape.solid(progress=told.append)
    assert told == sorted(told) and told[0] == 0 and told[-1] == 1 and len(told) >= 6
    assert np.diff(told).max() < 0.4
    assert (made.vertices == shape.mesh().vertices).all()

    def cancel(part):
        told.append(part)
        if part > 0:
            raise InterruptedError

    told.clear()
    with pytest.raises(InterruptedError):
        replace(shape, radius=0.02).solid(progress=cancel)  # another, as what was united last is kept
    assert len(told) == 2 and told[1] < 0.5
