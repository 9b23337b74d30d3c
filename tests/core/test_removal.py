# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parts get out of assemblies on straight ways that are known, and out of no others."""

from pathlib import Path

import numpy as np
import pytest
from planted_assemblies import caged_ball, dovetail, drawer, overlaps, shelled, turned

import sweep_addon as sw
from sweep_addon.core.csg import Placed
from sweep_addon.core.meshes.polyhedron import polyhedron
from sweep_addon.core.removal.bodies import taken
from sweep_addon.core.removal.directions import candidates
from sweep_addon.core.removal.finding import scene_of
from sweep_addon.core.removal.legs import START
from sweep_addon.core.removal.slipping import NEAR, Contacts
from sweep_addon.core.removal.straight import ways_out
from sweep_addon.core.removal.volumes import translated
from sweep_addon.core.solids import Ball, Block

pytest.importorskip("fcl", reason="removal paths are asked of python-fcl")
pytest.importorskip("manifold3d", reason="the solids of assemblies are made by it")


def directions_out(part, others):
    """All directions in which a part gets out straight at once, in the order in which they were found."""
    scene = scene_of(part, others, None)
    contacts = Contacts.of(scene.part, scene.others, NEAR * scene.tolerance)
    found = [
        leg.way / np.linalg.norm(leg.way)
        for leg in ways_out(scene, candidates(scene.part, scene.others, contacts), START)
        if scene.certified([leg]) > 0
    ]
    return np.array(found)


@pytest.mark.parametrize(
    ("planted", "way"), [(drawer, (0, -0.4004, 0)), (dovetail, (0, 0, 1.001))], ids=["drawer", "dovetail"]
)
def test_a_part_gets_out_in_its_only_direction(planted, way):
    part, others = planted()
    path = sw.removal_path(part, others)
    found = directions_out(part, others)
    assert len(path.legs) == 1
    assert np.allclose(path.legs[0].way, way, atol=2e-3)
    assert np.allclose(found, np.array(way) / np.linalg.norm(way), atol=1e-6) and len(found) == 1
    assert path.tolerance > 0  # for it touches what holds it
    assert overlaps(path, part, others, steps=30) < 1e-9


@pytest.mark.parametrize("tolerance", [None, 1e-6, 4e-5, 1e-4])
def test_a_gear_of_a_centimetre_gets_out_of_its_own_pocket(tolerance):
    """Some of its triangles are a hundredth of a square millimetre."""
    gear = sw.contours.from_svg(Path(__file__).parents[1] / "data" / "svg" / "gear-fill.svg", scale=0.001)
    block = Block(0.03, 0.03, 0.02).moved(x=0.008, y=0.008, z=0.005) - sw.TranslationalSweep(gear, height=0.05)
    path = sw.removal_path(sw.TranslationalSweep(gear, height=0.01), {"B": block}, tolerance=tolerance, budget=0)
    assert path.legs[0].way / np.linalg.norm(path.legs[0].way) == pytest.approx((0, 0, 1), abs=1e-9)


def test_what_does_not_touch_anything_gets_out_without_a_tolerance():
    """A ball of 0.24 m in a window of 0.5 m by 0.5 m is 0.01 m from its sides."""
    part, others = caged_ball(0.24)
    path = sw.removal_path(part, others)
    assert (len(path.legs), path.tolerance) == (1, 0.0)
    assert path.clearance == pytest.approx(0.01, abs=1e-6)
    assert overlaps(path, part, others) == 0.0


def test_a_ball_that_is_larger_than_all_windows_stays_in_its_cage():
    path = sw.removal_path(*caged_ball(0.3), budget=4000)
    assert not path and not path.sealed
    assert "None found" in str(path)


def test_a_part_in_a_closed_shell_is_proven_to_stay():
    path = sw.removal_path(*shelled())
    assert not path and path.sealed
    assert str(path) == "None: shell encloses the part"


def test_a_shell_stays_around_what_is_in_it():
    kernel, others = shelled()
    path = sw.removal_path(others["shell"], {"kernel": kernel})
    assert path.sealed and str(path) == "None: the part encloses kernel"


def pressed(depth):
    """A ball that is so deep in the cup that it is made for, whose other side it does not touch."""
    return Ball(0.1).moved(z=-depth), {"cup": Block(0.4, 0.4, 0.2).moved(z=-0.1) - Ball(0.1)}


@pytest.mark.parametrize("share", [0.6, 0.95])
def test_a_part_less_deep_in_another_than_the_tolerance_gets_out(share):
    path = sw.removal_path(*pressed(share * 1e-3), tolerance=1e-3, budget=0)
    assert path.legs[0].way[2] > 0 and path.tolerance == 1e-3


def test_a_part_deeper_in_another_than_the_tolerance_is_refused_with_how_deep_and_where():
    """At the lowest place of the ball."""
    with pytest.raises(
        sw.ShapeError, match=r"^cup: overlaps the part by 1.05 mm as it stands, at \(0, 0, -0.101\d*\) m"
    ):
        sw.removal_path(*pressed(1.05e-3), tolerance=1e-3)


@pytest.mark.parametrize("thickness", [3e-3, 1.5e-3, 5e-4, 1e-4])
def test_a_sheet_thinner_than_the_tolerance_gets_off_what_it_lies_on(thickness):
    """It would be inside out if it were drawn in by all of that."""
    sheet = Block(1.0, 1.0, thickness)
    table, far = Block(1.2, 1.2, 0.1).moved(z=-0.05 - thickness / 2), Block(0.1, 0.1, 0.1).moved(z=1.0)
    path = sw.removal_path(sheet, {"table": table, "far": far}, budget=0)
    assert path and path.legs[0].way[2] >= 0
    with pytest.raises(sw.ShapeError, match="^board: overlaps the part"):
        sw.removal_path(sheet, {"board": Block(1.2, 1.2, 0.1)})


def test_a_block_may_overlap_by_less_along_its_edges_between_square_faces():
    """They are drawn in by 1 / sqrt(3) of the tolerance at its corners."""
    box = {"box": Block(0.2, 0.2, 0.2) - Block(0.1, 0.1, 0.3)}
    block = Block(0.1, 0.1, 0.1).moved(x=0.5e-3)
    assert sw.removal_path(block, box, tolerance=0.88e-3, budget=0)
    with pytest.raises(
        sw.ShapeError, match="by 0.5 mm as it stands, at .* where it is so sharp or thin that only less than"
    ):
        sw.removal_path(block, box, tolerance=0.85e-3)


def test_a_part_inside_another_without_touching_its_surface_is_refused():
    with pytest.raises(sw.ShapeError, match=r"^block: overlaps the part by 0.\d+ m as it stands"):
        sw.removal_path(Ball(0.1), {"block": Block()})
    with pytest.raises(sw.ShapeError, match="^others.1: overlaps the part"):
        sw.removal_path(Block(), Ball(0.1))


def test_a_wall_is_not_stepped_over_however_thin():
    """The part is on one side of a box that is closed but for the other side, and the wall between is a micron."""
    box = Block(1.0, 0.4, 0.4) - Block(0.9, 0.3, 0.3) - Block(1.0, 0.3, 0.3).moved(x=0.4)
    wall = Block(1e-6, 0.3, 0.3)
    part = Block(0.1, 0.3, 0.3).moved(x=-0.2)
    assert sw.removal_path(part, {"box": box})
    path = sw.removal_path(part, {"box": box, "wall": wall}, budget=4000)
    assert not path


def test_turning_the_assembly_turns_the_path():
    matrix, _ = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))
    matrix *= np.sign(np.linalg.det(matrix))
    origin = np.array([3.0, -2.0, 1.0])
    part, others = drawer()
    path = sw.removal_path(part, others)
    moved = {name: turned(other, matrix, origin) for name, other in others.items()}
    elsewhere = sw.removal_path(turned(part, matrix, origin), moved)
    assert np.allclose(elsewhere.legs[0].way, matrix @ path.legs[0].way, atol=1e-9)
    assert elsewhere.clearance == pytest.approx(path.clearance, rel=1e-6)


def test_a_distance_is_how_far_the_part_goes():
    part, others = drawer()
    assert np.allclose(sw.removal_path(part, others, distance=2.0).legs[0].way, (0, -2, 0), atol=1e-6)


@pytest.mark.parametrize("planted", [drawer, dovetail])
def test_what_must_stay_empty_holds_the_part_on_its_whole_way_and_is_a_prism(planted):
    part, others = planted()
    path = sw.removal_path(part, others)
    mesh, own = path.swept().mesh(), part.mesh()
    length = np.linalg.norm(path.legs[0].way)
    across = own.volume() / (0.4 if planted is drawer else 1.0)
    assert mesh.volume() == pytest.approx(own.volume() + across * length, rel=1e-9)
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    points = np.random.default_rng(1).uniform(own.vertices.min(axis=0), own.vertices.max(axis=0), (400, 3))
    inside = points[sw.classify(part, points) > 0]
    assert len(inside) > 100
    for matrix in path.matrices(8):
        assert (sw.classify(path.swept(), inside @ matrix[:3, :3].T + matrix[:3, 3]) >= 0).all()


def ribbed(angle):
    """A rod with ribs, turned about its axis, and its way out."""
    upright = sw.solids.Cylinder(0.2, 1.0, points=16) | Block(0.6, 0.1, 0.1)
    part = Placed(upright, [(np.cos(angle), -np.sin(angle), 0, 0), (np.sin(angle), np.cos(angle), 0, 0), (0, 0, 1, 0)])
    return part, sw.removal_path(part, [Block(0.1, 0.1, 0.1).moved(x=3)], distance=0.8)


@pytest.mark.parametrize("angle", [0.0, 0.3, 2.0, *np.linspace(0.05, 3.1, 25)])
def test_what_must_stay_empty_has_no_films_or_slits_within(angle):
    """The prisms of faces that lead meet the part and each other: of a part with ribs, nothing is left between them."""
    assert ribbed(angle)[1].swept().mesh().euler_characteristic() == 2


@pytest.mark.parametrize("seed", range(6))
def test_what_must_stay_empty_is_as_large_however_it_lies(seed):
    """Prisms as thin as rounding once cost a twentieth of it."""
    part, path = ribbed(0.05 + 0.5 * seed)
    lies, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    lies *= np.linalg.det(lies)
    body, leg = taken(part, "part"), path.legs[0]
    volume = path.swept().mesh().volume()
    lying = translated(body.vertices @ lies.T, body.triangles, lies @ leg.way)
    assert lying.volume() == pytest.approx(volume, rel=1e-12) and lying.euler_characteristic() == 2
    points = np.random.default_rng(seed).uniform(lying.vertices.min(axis=0), lying.vertices.max(axis=0), (2000, 3))
    back = points @ lies - np.linspace(0, 1, 201)[:, None, None] * leg.way  # where they would have come from
    facetted = sw.solids.Triangles.of(part.mesh())
    visited = (sw.classify(facetted, back.reshape(-1, 3)).reshape(201, -1) > 0).any(axis=0)
    assert visited.sum() > 200
    assert (sw.classify(sw.solids.Triangles.of(lying), points)[visited] >= 0).all()


@pytest.mark.parametrize("angle", [0.0, 0.3, 2.0, *np.linspace(0.05, 3.1, 25)[[1, 9, 13, 15, 23, 24]]])
def test_what_must_stay_empty_holds_the_part_beside_slits_too(angle):
    """Where the prisms meet but for rounding, slits of no thickness may lead into what is united of them."""
    part, path = ribbed(angle)
    own = part.mesh()
    points = np.random.default_rng(2).uniform(own.vertices.min(axis=0), own.vertices.max(axis=0), (4000, 3))
    inside = points[sw.classify(sw.solids.Triangles.of(own), points) > 0]
    assert len(inside) > 500
    for matrix in path.matrices(3):
        assert (sw.classify(path.swept(), inside @ matrix[:3, :3].T + matrix[:3, 3]) >= 0).all()


def test_what_must_stay_empty_of_no_path_is_refused():
    with pytest.raises(sw.ShapeError, match="must have a path"):
        sw.removal_path(*shelled()).swept()


def test_work_can_be_ended_by_what_is_told_its_progress():
    told = []

    def stop(part):
        told.append(part)
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        sw.removal_path(*drawer(), progress=stop)
    assert 0 <= told[0] <= 1


def nothing():
    return polyhedron(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int32))


def not_a_number():
    mesh = Block().mesh()
    return polyhedron(mesh.vertices * np.nan, mesh.corners, mesh.offsets)


@pytest.mark.parametrize(
    ("part", "others", "named", "sentence"),
    [
        (sw.GeneralizedCylinder(start="open").mesh(), [Block()], {}, "^part: must be closed"),
        (nothing(), [Block()], {}, "^part: must have faces"),
        (not_a_number(), [Block()], {}, "^part: must have finite vertices"),
        (None, [Block()], {}, "^part: must be a mesh, a shape, a solid or a tree, got None"),
        (Block(), [], {}, "^others: must have at least one"),
        (Block(), 3, {}, "^others: must be meshes or shapes"),
        (Block(), {"lid": "lid"}, {}, "^lid: must be a mesh"),
        (Block(), [Block().moved(x=2)], {"tolerance": 0}, "^tolerance: must be a number of metres, more than 0"),
        (Block(), [Block().moved(x=2)], {"tolerance": float("nan")}, "^tolerance: must be a number of metres"),
        (Block(), [Block().moved(x=2)], {"tolerance": 1.0}, "^tolerance: must be at most"),
        (Block(), [Block().moved(x=2)], {"distance": -1.0}, "^distance: must be a number of metres, more than 0"),
        (Block(), [Block().moved(x=2)], {"distance": float("inf")}, "^distance: must be a number of metres"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(part, others, named, sentence):
    with pytest.raises(sw.ShapeError, match=sentence):
        sw.removal_path(part, others, **named)


def test_where_the_library_is_missing_it_is_said_how_to_get_it(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "fcl", None)
    with pytest.raises(sw.ShapeError, match="pip install python-fcl"):
        sw.removal_path(*drawer())
