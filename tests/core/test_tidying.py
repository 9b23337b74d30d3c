# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed surfaces without short edges and thin triangles: what is left is the same surface."""

import numpy as np
import pytest

from sweep_addon.core.meshes.polyhedron import polyhedron
from sweep_addon.core.resolving.absorbing import absorbed
from sweep_addon.core.resolving.contracting import contracted
from sweep_addon.core.resolving.drawing_apart import drawn_apart
from sweep_addon.core.resolving.equal_rows import equal_rows
from sweep_addon.core.resolving.flipping import flipped
from sweep_addon.core.resolving.tidying import tidied

SMALL, TINY = 1e-6, 1e-9
ROUND, ACROSS = 24, 12


def torus(shuffled=0):
    """Vertices and triangles of a ring round the z axis, each triangle beginning with any of its corners."""
    u, v = (a.ravel() for a in np.meshgrid(np.arange(ROUND), np.arange(ACROSS), indexing="ij"))
    a, b = 2 * np.pi * u / ROUND, 2 * np.pi * v / ACROSS
    vertices = np.stack(((2 + np.cos(b)) * np.cos(a), (2 + np.cos(b)) * np.sin(a), np.sin(b)), axis=1)

    def at(i, j):
        return (u + i) % ROUND * ACROSS + (v + j) % ACROSS

    low, high = (at(0, 0), at(1, 0), at(1, 1)), (at(0, 0), at(1, 1), at(0, 1))
    triangles = np.concatenate((np.stack(low, axis=1), np.stack(high, axis=1)))
    return vertices, np.array([np.roll(t, k) for t, k in zip(triangles, turns(len(triangles), shuffled), strict=True)])


def turns(count, seed):
    return np.random.default_rng(seed).integers(0, 3, count)


def free(vertices):
    return np.full(len(vertices), False)


def lengths(vertices, triangles):
    return np.linalg.norm(vertices[triangles] - vertices[np.roll(triangles, -1, axis=1)], axis=2)


def height(vertices, triangles):
    a, b, c = vertices[triangles].swapaxes(0, 1)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / lengths(vertices, triangles).max(axis=1)


def assert_same_surface(vertices, triangles, before, euler=0):
    """Closed and manifold, of the same Euler characteristic and volume."""
    used, corners = np.unique(triangles, return_inverse=True)
    mesh = polyhedron(vertices[used], corners.reshape(-1, 3))
    assert not len(mesh.boundary_edges()) and not len(mesh.non_manifold_edges())
    assert not len(mesh.dimensions().singular_points)
    assert mesh.euler_characteristic() == euler
    assert mesh.volume() == pytest.approx(polyhedron(vertices, before).volume(), abs=100 * SMALL)


@pytest.mark.parametrize("seed", range(6))
def test_short_edges_are_contracted_whichever_corner_their_triangles_begin_with(seed):
    """Clusters of vertices are next to each other; one that no hole is in becomes one vertex."""
    vertices, triangles = torus(seed)
    dice = np.random.default_rng(seed)
    grid = np.arange(len(vertices)).reshape(ROUND, ACROSS)
    for ring in range(0, ROUND, 6):  # patches of 3 x 3, apart from each other
        patch = np.roll(grid, dice.integers(ACROSS), axis=1)[ring : ring + 3, :3].ravel()
        vertices[patch] = vertices[patch[4]] + TINY * dice.normal(size=(9, 3))
    made, kept = contracted(vertices, triangles, SMALL, free(vertices))
    assert_same_surface(vertices, made[kept], triangles)
    assert lengths(vertices, made[kept]).min() > SMALL
    assert len(triangles) - kept.sum() == 2 * 8 * (ROUND // 6)


def test_contracting_closes_no_tube():
    """A ring of vertices round a tube is drawn to a point: three must stay, or the torus would be a pinched ball."""
    vertices, triangles = torus()
    vertices[:ACROSS] = vertices[:ACROSS].mean(axis=0) + TINY * np.random.default_rng(0).normal(size=(ACROSS, 3))
    made, kept = contracted(vertices, triangles, SMALL, free(vertices))
    assert_same_surface(vertices, made[kept], triangles)
    assert np.isin(np.arange(ACROSS), made[kept]).sum() == 3


def test_a_tetrahedron_stays_however_small():
    vertices, triangles = TINY * np.eye(4, 3), np.array([(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)])
    made, kept = contracted(vertices, triangles, SMALL, free(vertices))
    assert kept.all() and np.array_equal(made, triangles)


def test_of_an_edge_a_fixed_vertex_stays_and_two_keep_it():
    vertices, triangles = torus()
    vertices[1] = vertices[0] + TINY
    for end in (0, 1):
        fixed = free(vertices)
        fixed[end] = True
        made, kept = contracted(vertices, triangles, SMALL, fixed)
        assert end in made[kept] and 1 - end not in made[kept]
    fixed[:2] = True
    made, kept = contracted(vertices, triangles, SMALL, fixed)
    assert kept.all() and np.array_equal(made, triangles)


def test_at_the_boundary_of_a_part_nothing_changes():
    """It cannot be seen there whether an edge may go: on the whole surface this one must not."""
    vertices, triangles = torus()
    vertices[:3] = vertices[0] + TINY * np.eye(3)
    part = triangles[(triangles == 1).any(axis=1)]
    made, kept = contracted(vertices, part, SMALL, free(vertices))
    assert kept.all() and np.array_equal(made, part)


def with_corners(vertices, triangles, chosen, share, low):
    """A surface some of whose triangles have one vertex more, so low above their first side."""
    a, b, c = vertices[triangles[chosen]].swapaxes(0, 1)
    foot = a + np.asarray(share)[:, None] * (b - a)
    above = c - foot
    new = foot + np.reshape(low, (-1, 1)) * above / np.linalg.norm(above, axis=1, keepdims=True)
    number = len(vertices) + np.arange(len(chosen))
    x, y, z = triangles[chosen].T
    rest = np.delete(triangles, chosen, axis=0)
    parts = [np.stack(part, axis=1) for part in ((x, y, number), (y, z, number), (z, x, number))]
    return np.concatenate((vertices, new)), np.concatenate((rest, *parts))


def apart(triangles, count, seed):
    """Triangles of which none touch each other, chosen at random."""
    chosen, taken = [], set()
    for number in np.random.default_rng(seed).permutation(len(triangles)):
        if not taken & set(triangles[number].tolist()):
            chosen.append(number)
            taken |= set(triangles[number].tolist())
    return np.array(chosen[:count])


@pytest.mark.parametrize("seed", range(6))
def test_thin_triangles_are_flipped_away(seed):
    plain, triangles = torus(seed)
    chosen = apart(triangles, 20, seed)
    share = np.random.default_rng(seed).uniform(0.2, 0.8, len(chosen))
    vertices, before = with_corners(plain, triangles, chosen, share, TINY)
    faces = np.arange(len(before))
    assert (height(vertices, before) < SMALL).sum() == len(chosen)
    made, of = flipped(vertices, before, faces, SMALL, free(vertices))
    assert_same_surface(vertices, made, before)
    assert height(vertices, made).min() > SMALL
    assert len(np.unique(made)) == len(vertices) and len(made) == len(before)
    assert not np.isin(of, faces[height(vertices, before) < SMALL]).any()


def test_flipping_makes_no_edge_that_there_is():
    """A spike without thickness on a face: at its longest side the other diagonal is a side of that face."""
    vertices, triangles = torus()
    b, c, d = triangles[0]
    spike = 2 * vertices[c] - vertices[b]
    vertices = np.concatenate((vertices, [spike]))
    a = len(vertices) - 1
    triangles = np.concatenate((triangles[1:], [(a, b, c), (a, c, d), (a, d, b)]))
    assert (height(vertices, triangles) < SMALL).sum() == 1
    made, _ = flipped(vertices, triangles, np.arange(len(triangles)), SMALL, free(vertices))
    assert np.array_equal(made, triangles)


@pytest.mark.parametrize("seed", range(6))
def test_a_vertex_that_only_halves_an_edge_is_absorbed(seed):
    """Of two triangles on either side of an edge, whose new vertex is hardly above it: the edge is whole again."""
    plain, triangles = torus(seed)
    chosen = apart(triangles, 20, seed)
    vertices, before = with_corners(plain, triangles, chosen, np.full(len(chosen), 0.4), TINY)
    made, kept = absorbed(vertices, before, SMALL, free(vertices))
    assert_same_surface(vertices, made[kept], before)
    assert height(vertices, made[kept]).min() > SMALL
    assert np.array_equal(np.unique(made[kept]), np.arange(len(plain)))


def test_absorbing_levels_no_tip():
    """The tip of a narrow pyramid is far from the planes of its sides' neighbours, and stays."""
    vertices = np.array([(-TINY, -1, 0), (TINY, -1, 0), (TINY, 1, 0), (-TINY, 1, 0), (0, 0, 1.0)])
    triangles = np.array([(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 2, 1), (0, 3, 2)])
    made, kept = absorbed(vertices, triangles, SMALL, free(vertices))
    assert 4 in made[kept]


def test_sides_that_touch_in_a_point_are_told_apart_without_crossing():
    """Two bodies tip to tip, and a body with two cavities tip to tip: each tip goes back into its own."""
    tip, sides = np.concatenate((np.eye(3), np.zeros((1, 3)))), np.array([(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)])
    for inside_out in (False, True):
        one, other = sides, 4 + sides[:, ::-1]
        if inside_out:
            one, other = one[:, ::-1], other[:, ::-1]
        vertices, triangles = np.concatenate((tip, -tip)), np.concatenate((one, other))
        moved = drawn_apart(vertices, triangles, SMALL, free(vertices))
        first, second = moved[3], moved[7]
        assert len(np.unique(moved.astype(np.float32), axis=0)) == len(moved)
        assert np.abs(moved - vertices).max() <= SMALL
        assert (first >= 0).all() and (second <= 0).all() and (first != second).any()


@pytest.mark.parametrize("seed", range(12))
def test_tidied_surfaces_keep_their_cuts_and_have_nothing_small(seed):
    plain, triangles = torus(seed)
    dice = np.random.default_rng(seed)
    chosen = apart(triangles, 60, seed)
    low = 10.0 ** dice.uniform(-12, -2, len(chosen))
    share = np.where(dice.random(len(chosen)) < 0.3, low, dice.uniform(0, 1, len(chosen)))  # some next to a corner too
    vertices, before = with_corners(plain, triangles, chosen, share, low)
    faces, cuts = np.arange(len(before)), (0, 1, 2)
    moved, made, of = tidied(vertices, before, faces, cuts)
    assert_same_surface(moved, made, before)
    assert {tuple(made[of == cut][0].tolist()) for cut in cuts} == set(map(tuple, before[:3].tolist()))
    corners = np.unique(made)
    single = moved.astype(np.float32)
    assert len(np.unique(single[corners], axis=0)) == len(corners)
    assert height(single.astype(np.float64), made).min() > 0
    assert height(moved, made).min() > 2 * np.spacing(np.float32(3.0))


def test_equal_rows_are_found_among_all_of_their_mirror_images():
    signs = np.array(np.meshgrid((1, -1), (1, -1), (1, -1))).reshape(3, -1).T
    rows = np.concatenate([signs * place for place in np.random.default_rng(0).uniform(1, 2, (50, 3))])
    others = np.random.default_rng(1).permutation(len(rows))
    assert np.array_equal(others[equal_rows(rows, rows[others])], np.arange(len(rows)))
