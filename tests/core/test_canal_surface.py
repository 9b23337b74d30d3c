# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Canal surfaces: every vertex is on its ball and in no other one, and volumes are those of closed forms."""

from dataclasses import replace
from math import atan2, pi, sqrt, tau

import numpy as np
import pytest
from conftest import FULL

from sweep_addon.core.contours import Circle
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.canal_surface import CanalSurface
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.stations.sampling import Count, Tolerance
from sweep_addon.core.trajectories import Arc, Bezier, Formula, Helix, Line, Polyline, TorusKnot
from sweep_addon.core.trajectories.arc_length import arc_length

RING = Arc(2.0, tau)
KNOT = TorusKnot(2, 3, major=2.0, minor=0.8)
WAVES = CanalSurface(Line(end=(0, 0, pi)), "0.3 + 0.25*sin(8*s)")  # |r'| up to 2
PEARL = CanalSurface(Line(), "0.5*sqrt(t*(1 - t))", points=32)  # r' is infinite at both ends
PEARLS = CanalSurface(Line(end=(0, 0, 3)), "0.2*abs(sin(4*pi*t))", points=24)  # r is 0 at both ends and between
CONE = CanalSurface(Line(), "0.2 + 0.25*t")
BEND = Bezier([(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)])
CLEAN = {
    "cone": CONE,
    "ring": CanalSurface(RING, "0.5 + 0.3*cos(u)"),
    "helix": CanalSurface(Helix(1.0, 0.9, 2.0), "0.15 + 0.1*sin(9*t)"),
    "knot": CanalSurface(KNOT, "0.6 + 0.15*cos(4*u)", points=24),
    "pearl": PEARL,
    "pearls": PEARLS,
    "points": CanalSurface(BEND, [(0, 0.1), (0.4, 0.25), (1, 0.05)]),
    "falling kink": CanalSurface(Line(), "0.5 - 0.6*abs(t - 0.5)"),
    "radii": CanalSurface(Polyline([(0, 0, 0), (0, 0, 1), (0, 0, 2)], radii=(1, 3, 0.5)), 0.1),
    "to a point": CanalSurface(Line(), "0.4*t"),
}
ALL = CLEAN | {
    "waves": WAVES,
    "corner": CanalSurface(Polyline([(0, 0, 0), (1, 0, 0), (1, 1, 0)]), "0.1 + 0.1*t"),
    "rising kink": CanalSurface(Line(), "0.3 + 0.5*abs(t - 0.5)"),
    "swallowing ring": CanalSurface(RING, "0.5 + 0.4*sin(12*u)", points=16),
    "one ball": CanalSurface(Line(), "0.1 + 2*t"),
    "peak": CanalSurface(Line(), "1.2 - 2*abs(t - 0.5)"),
    "closed corners": CanalSurface(Polyline([(0, 0, 0), (1, 0, 0), (0, 1, 0)], closed=True), "0.1 + 0.02*sin(tau*t)"),
}
SAMPLINGS = [Tolerance(0.001), Count(40)]


def balls_of(shape, mesh):
    """The middle and the radius of the ball of each vertex, from the trajectory and the formula alone."""
    return balls_at(shape, mesh.attributes["u"])


def many_balls(shape, count=4000):
    return balls_at(shape, np.linspace(*shape.trajectory.domain, count))


def balls_at(shape, u):
    trajectory, s = shape.trajectory, arc_length(shape.trajectory).at(u)
    radius = shape.radius.evaluate(u, s / trajectory.length(), s)
    return trajectory.evaluate(u), radius * trajectory.carried(u)[0]


def depth(points, middles, radii):
    """How deep each point is in the balls that hold it most."""
    found = np.full(len(points), -np.inf)
    for start in range(0, len(middles), 500):
        apart = np.linalg.norm(points[:, None] - middles[None, start : start + 500], axis=2)
        found = np.maximum(found, (radii[start : start + 500] - apart).max(axis=1))
    return found


@pytest.mark.parametrize("samples", SAMPLINGS, ids=["tolerance", "count"])
@pytest.mark.parametrize("name", ALL)
def test_every_vertex_is_on_its_ball(name, samples):
    shape = replace(ALL[name], samples=samples)
    mesh = shape.mesh()
    middles, radii = balls_of(shape, mesh)
    error = np.abs(np.linalg.norm(mesh.vertices - middles, axis=1) - radii)
    assert error.max() < 1e-12 if name not in ("pearl", "pearls", "to a point") else error.max() < 1e-7 * radii.max()


@pytest.mark.parametrize("name", CLEAN)
def test_no_vertex_is_within_a_ball(name):
    """The boundary of the union of 4,000 balls."""
    shape = replace(CLEAN[name], points=12)
    mesh = shape.mesh()
    deepest = depth(mesh.vertices, *many_balls(shape)).max()
    assert deepest < 1e-7 and len(mesh.vertices) > 100


@pytest.mark.parametrize("samples", SAMPLINGS, ids=["tolerance", "count"])
@pytest.mark.parametrize("name", ALL)
def test_surface_is_closed_and_outward(name, samples):
    mesh = replace(ALL[name], samples=samples, points=24).mesh()
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0
    assert mesh.volume() > 0
    if name in CLEAN:
        assert len(np.unique(mesh.vertices.round(9), axis=0)) == len(mesh.vertices)


@pytest.mark.parametrize("low, high", [(0.2, 0.45), (0.5, 0.1), (0.3, 0.9)])
def test_cone_and_two_balls_have_the_volume_and_area_of_their_parts(low, high):
    """A frustum and two caps; the error falls with the square of the step."""
    slope = high - low
    cosine = sqrt(1 - slope**2)
    heights = low * (1 - slope), high * (1 + slope)
    volume = pi / 3 * cosine**4 * (low**2 + low * high + high**2)
    volume += sum(pi / 3 * h**2 * (3 * r - h) for h, r in zip(heights, (low, high), strict=True))
    area = pi * (low + high) * cosine**2 + sum(tau * r * h for h, r in zip(heights, (low, high), strict=True))
    errors = []
    for points in (64, 128, 256):
        mesh = CanalSurface(Line(), f"{low} + {slope}*t", points=points, samples=Count(points // 4)).mesh()
        errors.append((1 - mesh.volume() / volume, 1 - mesh.area() / area))
    assert np.all(np.array(errors) > 0) and max(errors[2]) < 3e-4
    ratio = np.array(errors[:-1]) / np.array(errors[1:])
    assert np.all((3.8 < ratio) & (ratio < 4.2))


def test_ring_of_changing_balls_has_the_volume_of_its_discs():
    """Discs of area A that move by v across their planes sweep the integral of A v: here by quadrature of formulas."""
    a, b, major = 0.5, 0.3, 2.0
    u = np.linspace(0, tau, 20_000, endpoint=False)
    r, slope, change = a + b * np.cos(u), -b * np.sin(u) / major, -b * np.cos(u) / major**2
    volume = major * tau * np.mean(pi * r**2 * (1 - slope**2) * (1 - slope**2 - r * change))
    errors = []
    for points in (64, 128):
        mesh = CanalSurface(RING, "0.5 + 0.3*cos(u)", points=points, samples=Count(4 * points)).mesh()
        assert mesh.euler_characteristic() == 0
        errors.append(1 - mesh.volume() / volume)
    assert 0 < errors[1] < 6e-4 and 3.7 < errors[0] / errors[1] < 4.3


@pytest.mark.parametrize("trajectory", [KNOT, RING, BEND, Helix()], ids=["knot", "ring", "bezier", "helix"])
@pytest.mark.parametrize("samples", SAMPLINGS, ids=["tolerance", "count"])
def test_balls_of_one_size_make_a_round_tube(trajectory, samples):
    canal = CanalSurface(trajectory, 0.1, samples=samples, start="flat", end="flat").mesh()
    tube = GeneralizedCylinder(Circle(0.1), trajectory, samples).mesh()
    assert np.abs(canal.vertices - tube.vertices).max() < 1e-12
    assert (canal.corners == tube.corners).all() and np.abs(canal.uv - tube.uv).max() < 1e-9


def test_a_pill_is_as_a_round_ended_tube():
    canal = CanalSurface(Line(), 0.2, samples=Count(8)).mesh()
    tube = GeneralizedCylinder(Circle(0.2), Line(), Count(8), start="round", end="round").mesh()
    assert abs(canal.volume() / tube.volume() - 1) < 2e-3


def test_waves_are_in_eight_parts_and_a_ball_and_say_so():
    """dr/ds = 2 cos 8s is beyond 1 in size but for eight stretches, and at the end the last ball is left."""
    mesh = WAVES.mesh()
    assert mesh.euler_characteristic() == 2 * (8 + 1)
    assert mesh.told[0].startswith("Radius: from u = 0 to 0.042 it changes faster than the path goes on")
    assert any(said == "Radius: 6 more such places." for said in mesh.told)
    u = np.unique(mesh.attributes["u"]) * pi
    for limit in (np.pi / 3 + np.arange(8) * np.pi) / 8:
        assert np.abs(u - limit).min() < 1e-9  # a circle where it is a point


def test_chords_keep_the_tolerance_where_circles_become_points_too():
    """The profile of a straight one is s - r sin(lean), r cos(lean), and its tangent turns as the lean does."""
    shape = CanalSurface(Line(end=(0, 0, pi)), "0.3 + 0.25*sin(8*s)", samples=Tolerance(1e-4))
    s = np.unique(shape.mesh().attributes["u"]) * pi
    dense = s[:-1, None] + np.linspace(0, 1, 65) * np.diff(s)[:, None]
    r, slope = 0.3 + 0.25 * np.sin(8 * dense), 2 * np.cos(8 * dense)
    circles = (np.abs(slope[:, 1:-1]) < 1).all(axis=1)
    profile = np.stack((dense - r * slope, r * np.sqrt(np.maximum(1 - slope**2, 0))))[:, circles]
    x, y = profile - profile[:, :, :1]
    away = np.abs(x * y[:, -1:] - y * x[:, -1:]) / np.hypot(x[:, -1:], y[:, -1:])
    assert 0.5e-4 < away.max() < 1.1e-4


@pytest.mark.parametrize("kind, edges, faces", [("round", 0, 0), ("flat", 0, 2), ("open", 32, 0)])
def test_ends(kind, edges, faces):
    mesh = replace(CONE, points=16, start=kind, end=kind).mesh()
    assert len(mesh.boundary_edges()) == edges
    assert np.count_nonzero(np.diff(mesh.offsets) == 16) == faces


def test_a_radius_of_nothing_at_an_end_is_one_vertex():
    mesh = CanalSurface(Line(), "0.4*t", points=16).mesh()
    assert np.count_nonzero(np.linalg.norm(mesh.vertices, axis=1) < 1e-12) == 1
    assert mesh.euler_characteristic() == 2


def test_a_string_of_pearls_is_joined_in_single_vertices():
    mesh = PEARLS.mesh()
    assert mesh.euler_characteristic() == 4 * 2 - 3
    assert [np.count_nonzero(np.linalg.norm(mesh.vertices - (0, 0, z), axis=1) < 1e-9) for z in (0.75, 1.5, 2.25)] == [
        1, 1, 1]  # fmt: skip


def test_one_ball_swallows_all_others():
    """r' = 2: what is left is the last ball."""
    mesh = replace(ALL["one ball"], samples=Tolerance(1e-4), points=256).mesh()
    assert mesh.volume() == pytest.approx(4 / 3 * pi * 2.1**3, rel=5e-4)
    with pytest.raises(
        ShapeError, match="^radius: must change more slowly than the path goes on, or the ends be round"
    ):
        replace(ALL["one ball"], start="open", end="open").mesh()


def test_discs_of_the_radius_are_too_thin_where_it_changes():
    """At slope 0.5 the true surface is 2 / sqrt(3) as wide across the path as a disc of that radius."""
    canal = CanalSurface(Line(), "0.2 + 0.5*t", samples=Count(200), points=64).mesh()
    disc = GeneralizedCylinder(Circle(1.0), Line(), scale_x="0.2 + 0.5*t", scale_y="0.2 + 0.5*t").mesh()

    def width(mesh, z):
        return np.interp(z, *np.unique(np.stack((mesh.vertices[:, 2], np.hypot(*mesh.vertices[:, :2].T))), axis=1))

    assert width(disc, 0.5) / width(canal, 0.5) == pytest.approx(sqrt(3) / 2, abs=1e-3)


def test_texture_is_in_true_lengths_on_the_balls_too():
    """On a pill every face is as long on the texture as on the ball or along the path."""
    pill = CanalSurface(Line(), 0.2, points=256, samples=Tolerance(1e-5)).mesh()
    along = pill.uv[:, 0]
    assert along.min() == pytest.approx(-0.2 * pi / 2, rel=1e-9) and along.max() == pytest.approx(1 + 0.2 * pi / 2)
    cone = CanalSurface(Line(), "0.2 + 0.25*t").mesh()
    slant = sqrt(1 - 0.25**2)
    angle = pi / 2 - np.arcsin(0.25)
    wanted = slant * 1 + 0.2 * angle + 0.45 * (pi - angle)
    assert np.ptp(cone.uv[:, 0]) == pytest.approx(wanted, rel=1e-9)


def test_discs_on_a_circle_make_a_ring_from_4_to_6():
    """The lecture's: (x - 5)^2 + y^2 = 1 round x^2 + y^2 = 5^2 is x^2 + y^2 = 4^2 and 6^2."""
    ring = CanalSurface(Arc(5.0, tau), 1.0, "disc", samples=Count(4096)).mesh()
    edge = np.hypot(*ring.vertices[np.unique(ring.boundary_edges()), :2].T)
    assert np.abs(np.abs(edge - 5) - 1).max() < 1e-12
    assert ring.area() == pytest.approx(20 * pi, rel=1e-6) and ring.euler_characteristic() == 0
    assert (ring.normals[:, 2] > 0).all() and np.abs(ring.vertices[:, 2]).max() == 0


@pytest.mark.parametrize("plane", [(1, 0, 0), (0, 1, 0), (0.6, 0, 0.8)])
def test_discs_move_in_the_plane_of_their_path(plane):
    normal = np.array(plane) / np.linalg.norm(plane)
    x = np.cross(normal, (0.3, 0.5, 0.7))
    x /= np.linalg.norm(x)
    y = np.cross(normal, x)
    points = [tuple(a * x + b * y) for a, b in ((0, 0), (1, 0), (1, 1), (2, 1))]
    mesh = CanalSurface(Bezier(points), "0.1 + 0.05*t", "disc").mesh()
    assert np.abs(mesh.vertices @ normal).max() < 1e-12
    assert (mesh.normals @ normal > 0).all() or (mesh.normals @ normal < 0).all()


def test_discs_that_shrink_end_as_a_pair_of_tangents():
    """The region of two discs and their tangents: a trapezium and two sectors."""
    low, high = 0.2, 0.45
    slope = high - low
    cosine = sqrt(1 - slope**2)
    lean = atan2(slope, cosine)
    area = cosine * (low + high) + (pi / 2 - lean) * low**2 + (pi / 2 + lean) * high**2
    mesh = CanalSurface(Line(), "0.2 + 0.25*t", "disc", samples=Tolerance(1e-6)).mesh()
    assert mesh.area() == pytest.approx(area, rel=1e-5)


def test_a_jump_is_refused_and_a_kink_is_not():
    kink = CanalSurface(Line(), "0.2 + max(0, t - 0.371)*0.5", points=16)
    assert any(np.abs(kink.mesh().attributes["u"] - 0.371) < 1e-9)
    with pytest.raises(ShapeError, match="^radius: must not jump, got a jump near u = 0.371$"):
        CanalSurface(Line(), "0.2 + 0.1*(t > 0.371)").mesh()


def test_trajectory_by_formulas_that_stands_still_and_laws_of_u():
    path = Formula("u^3", "0", "0", start=-1.0, end=1.0)
    mesh = CanalSurface(path, "0.1 + 0.01*u^2", points=16).mesh()
    assert len(mesh.boundary_edges()) == 0 and mesh.volume() > 0


def test_single_precision_is_the_same_surface():
    double, single = CONE.mesh(), CONE.mesh(dtype=np.float32)
    assert single.vertices.dtype == np.float32 and np.abs(double.vertices - single.vertices).max() < 1e-6


@pytest.mark.thorough
@pytest.mark.parametrize("seed", range(30 if FULL else 8))
def test_random_canal_surfaces_are_closed_and_on_their_balls(seed):
    random = np.random.default_rng(seed)
    waves = random.normal(size=(3, 4, 2)) / (1 + np.arange(4))[:, None]
    texts = ("+".join(f"{a:.4f}*cos({k + 1}*u)+{b:.4f}*sin({k + 1}*u)" for k, (a, b) in enumerate(w)) for w in waves)
    path = Formula(*texts, end=tau if seed % 2 else 5.0)
    law = f"{random.uniform(0.1, 0.5):.3f}*(1.1 + sin({random.integers(1, 30)}*u))"
    shape = CanalSurface(path, law, points=12, samples=SAMPLINGS[seed % 3 == 0])
    mesh = shape.mesh()
    assert len(mesh.boundary_edges()) == len(mesh.non_manifold_edges()) == 0
    middles, radii = balls_of(shape, mesh)
    assert np.abs(np.linalg.norm(mesh.vertices - middles, axis=1) - radii).max() < 1e-11


REFUSED = {
    "radius: must be more than 0, got 0": {"radius": 0},
    "radius: must be more than 0, got -1": {"radius": -1},
    "radius: must nowhere be less than 0, got -0.1 at u = 0": {"radius": "t - 0.1"},
    "radius: must somewhere be more than 0, got 0": {"radius": "0*t"},
    "radius: must be at most 1e+12 in size, got 1e+13": {"radius": "1e13*t"},
    "radius: must be finite everywhere, got inf at u = 0, t = 0, s = 0": {"radius": "1/t"},
    "radius: must be a number of metres or an expression of u, t, s: an operator is missing": {"radius": "2 m"},
    "radius: must have t rising from point to point": {"radius": [(0, 1), (0, 2)]},
    "generator: must be one of ball, disc, got 'sphere'": {"generator": "sphere"},
    "points: must be at least 3, got 2": {"points": 2},
    "points: must be a whole number, got 3.5": {"points": 3.5},
    "samples: must be one of tolerance, count": {"samples": "many"},
    "start: must be one of round, flat, open, got 'taper'": {"start": "taper"},
    "end: must be one of round, flat, open, got 1": {"end": 1},
    "texture: must be one of lengths, unit, none, got 'all'": {"texture": "all"},
    "attributes: must be true or false, got 1": {"attributes": 1},
    "trajectory: must lie in a plane for discs, got points ": {"trajectory": Helix(), "generator": "disc"},
    "samples.chord: must be larger: balls take 3,": {"samples": Tolerance(1e-9), "radius": 1e4},
}


@pytest.mark.parametrize("sentence", REFUSED)
def test_bad_input_is_refused_in_one_sentence(sentence):
    with pytest.raises(ShapeError) as refusal:
        CanalSurface(**{"trajectory": Line()} | REFUSED[sentence]).mesh()
    assert str(refusal.value).startswith(sentence) and "\n" not in str(refusal.value)
