# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances to meshes against closed formulas, whatever triangles the mesh is made of."""

import numpy as np
import pytest

from sweep_addon.core.distance import PseudoNormals, Tree, nearest
from sweep_addon.core.meshes.facets import facets
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.solids import Bracket
from sweep_addon.core.trajectories import TorusKnot

CORNERS = np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
SIDES = np.array([(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def splintered(random, rounds):
    """A box of 2 x 2 x 2 m about the origin, of triangles parted again and again at random: many are slivers."""
    vertices, triangles = list(CORNERS), [*SIDES[:, [0, 1, 2]].tolist(), *SIDES[:, [0, 2, 3]].tolist()]
    for _ in range(rounds):
        a, b, c = triangles.pop(random.integers(len(triangles)))
        weights = random.dirichlet((1, 1, 1))
        vertices.append(weights @ [vertices[a], vertices[b], vertices[c]])
        new = len(vertices) - 1
        triangles += [[a, b, new], [b, c, new], [c, a, new]]
    return np.array(vertices), np.array(triangles)


def box_distance(points, half=1.0):
    """The signed distance to the box, by formula."""
    over = np.abs(points) - half
    return np.linalg.norm(np.maximum(over, 0), axis=1) + np.minimum(over.max(axis=1), 0)


@pytest.mark.parametrize("rounds", [0, 20, 2000])
@pytest.mark.parametrize("largest", [np.inf, 0.1])
def test_signed_distances_to_a_box_are_those_of_the_formula(rounds, largest):
    random = np.random.default_rng(rounds)
    vertices, triangles = splintered(random, rounds)
    points = random.uniform(-2, 2, (3000, 3))
    points[:500, 0] = np.sign(points[:500, 0])  # beside faces and in their planes
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn *= np.linalg.det(turn)

    def moved(places):
        return places @ turn + (300.0, -20.0, 5.0)

    found = nearest(Tree.of(moved(vertices)[triangles], largest), moved(points))
    outside = PseudoNormals.of(moved(vertices), triangles).outside(moved(points), found)

    expected = box_distance(points)
    np.testing.assert_allclose(found.distances, np.abs(expected), atol=1e-12)  # coordinates of 300 m end at 6e-14
    clear = np.abs(expected) > 1e-9
    assert (outside[clear] == (expected[clear] > 0)).all()


def test_a_point_is_where_its_face_and_part_say():
    vertices, triangles = splintered(np.random.default_rng(1), 100)
    points = np.random.default_rng(2).uniform(-2, 2, (2000, 3))
    found = nearest(Tree.of(vertices[triangles]), points)
    np.testing.assert_allclose(np.linalg.norm(points - found.places, axis=1), found.distances, atol=1e-15)
    corners = vertices[triangles[found.faces]]
    at_corner = found.parts >= 4
    assert at_corner.any() and (found.places == corners[np.arange(2000), found.parts % 4 * at_corner])[at_corner].all()
    inside = found.parts == 0
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    across = np.cross(points - found.places, normals) / np.linalg.norm(normals, axis=1, keepdims=True)
    assert inside.any() and np.abs(across[inside]).max() < 1e-9  # of slivers normals are known to less


def test_hints_and_limits_change_nothing_but_the_time():
    mesh = GeneralizedCylinder(trajectory=TorusKnot()).mesh()
    tree = Tree.of(mesh.vertices[facets(mesh)[0]])
    random = np.random.default_rng(3)
    points = mesh.vertices[random.integers(len(mesh.vertices), size=5000)] + random.normal(0, 0.3, (5000, 3))
    plain = nearest(tree, points)
    hinted = nearest(tree, points, hints=mesh.vertices[random.integers(len(mesh.vertices), size=5000)])
    np.testing.assert_array_equal(plain.distances, hinted.distances)
    limited = nearest(tree, points, limit=0.2)
    near = plain.distances <= 0.2
    assert near.any() and not near.all()
    np.testing.assert_array_equal(limited.distances, np.where(near, plain.distances, 0.2))
    np.testing.assert_array_equal(limited.faces == -1, ~near)


def test_around_a_hollow_edge_the_sides_are_told_by_both_faces():
    """An L of two blocks: its outside is that of both, its inside that of either."""
    solid = Bracket()
    mesh = solid.mesh()
    triangles = facets(mesh)[0]
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    points = np.random.default_rng(4).uniform(low - 0.1, high + 0.1, (4000, 3))
    found = nearest(Tree.of(mesh.vertices[triangles]), points)
    inside = ~PseudoNormals.of(mesh.vertices, triangles).outside(points, found)
    winding = solid_angles(points, mesh.vertices[triangles]) / (4 * np.pi)
    np.testing.assert_array_equal(inside, winding > 0.5)


SQUARE = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])


def cells_in_a_row(count):
    """Unit cubes one after the other along x, each open to the next by a square hole in a wall of no thickness.

    Its points are those of a block; of each wall there are two sides, which meet round the hole.
    """
    outer = [np.insert(SQUARE, 0, cell + side, axis=1) for cell in range(count) for side in (0, 1)]
    holes = [np.insert((SQUARE + 1) / 3, 0, cell, axis=1) for cell in range(1, count)]
    vertices = np.concatenate(outer + holes)
    triangles, ahead = [], [1, 2, 3, 0]

    def quads(near, far):
        for i, j in enumerate(ahead):
            triangles.extend([(near[i], near[j], far[j]), (near[i], far[j], far[i])])

    for cell in range(count):
        low, high = (8 * cell + 4 * side + np.arange(4) for side in (0, 1))
        quads(low, high)
        for wall, hole, is_end in ((low[::-1], cell - 1, cell == 0), (high, cell, cell == count - 1)):
            if is_end:
                triangles.extend([wall[:3], wall[[0, 2, 3]]])
            else:
                rim = 8 * count + 4 * hole + np.arange(4)
                quads(wall, rim if wall is high else rim[::-1])
    return vertices, np.array(triangles)


@pytest.mark.parametrize("count", [1, 2, 3, 6])
def test_beside_slits_of_no_thickness_the_side_is_that_of_the_solid(count):
    vertices, triangles = cells_in_a_row(count)
    edges = np.sort(np.concatenate((triangles[:, :2], triangles[:, 1:], triangles[:, ::2])), axis=1)
    assert (np.unique(edges, axis=0, return_counts=True)[1] == 2).all()  # closed, and each edge of two faces
    random = np.random.default_rng(count)
    points = random.uniform(-0.5, (count + 0.5, 1.5, 1.5), (4000, 3))
    points[:1000, 0] = np.round(points[:1000, 0]) + random.normal(size=1000) * 10.0 ** random.uniform(-9, -1, 1000)
    turn, _ = np.linalg.qr(random.normal(size=(3, 3)))
    turn *= np.linalg.det(turn)

    def moved(places):
        return places @ turn + (3.0, -2.0, 0.5)

    corners = moved(vertices)
    tree, normals = Tree.of(corners[triangles]), PseudoNormals.of(corners, triangles)
    found = nearest(tree, moved(points), normals=normals)
    half = np.array((count, 1, 1)) / 2
    depth = (half - np.abs(points - half)).min(axis=1)
    clear = np.abs(depth) > 1e-9
    assert (normals.outside_of(tree, moved(points), found) == (depth < 0))[clear].all()
    assert found.torn.any() == (count > 1)


def solid_angles(points, corners):
    """How much of the view from each point triangles fill: van Oosterom, Strackee, 1983."""
    a, b, c = (corners[None, :, i] - points[:, None] for i in range(3))
    lengths = [np.linalg.norm(part, axis=2) for part in (a, b, c)]
    volume = np.einsum("pti,pti->pt", a, np.cross(b, c))
    rest = lengths[0] * lengths[1] * lengths[2]
    for one, other, length in ((a, b, lengths[2]), (b, c, lengths[0]), (c, a, lengths[1])):
        rest += np.einsum("pti,pti->pt", one, other) * length
    return 2 * np.arctan2(volume, rest).sum(axis=1)


def test_triangles_that_are_segments_or_points_have_distances_too():
    """In one plane, where a flat triangle has no side that could tell inside from outside."""
    random = np.random.default_rng(5)
    start, end = random.uniform(-1, 1, (2, 200, 3)) * (1, 1, 0)
    end[::10] = start[::10]
    points = random.uniform(-2, 2, (500, 3)) * (1, 1, 0)
    found = nearest(Tree.of(np.stack((start, end, end), axis=1)), points)
    way = end - start
    t = np.einsum("nsi,si->ns", points[:, None] - start, way) / np.maximum((way**2).sum(axis=1), 1e-300)
    feet = start + np.clip(t, 0, 1)[:, :, None] * way
    expected = np.linalg.norm(points[:, None] - feet, axis=2).min(axis=1)
    np.testing.assert_allclose(found.distances, expected, atol=1e-14)
