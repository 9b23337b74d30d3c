# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Real contours along real paths, in random combinations of frames, ends, corners, fits and laws.

A contour is refused with a sentence or makes a sound mesh: closed and manifold, of the volume that Pappus and Weyl tell
where it does not meet itself, and the same from its job and its Python. With `--full` there are hundreds of each kind.
"""

import json
import re
import warnings

import numpy as np
import pytest
from conftest import BRIEF, FULL
from contour_inputs import DATA, FONT, OUTLINES, drawn

import sweep_addon as sw
from sweep_addon.core.declared.forms import python_source
from sweep_addon.core.meshes.booleans import is_there

REAL = json.loads((DATA / "real_outlines.json").read_text())["outlines"]
ICONS = sorted((DATA / "svg").glob("*.svg"))
AEROFOILS = sorted((DATA / "naca").glob("*.dat"))
LINES = json.loads((DATA / "centrelines.json").read_text())["lines"]
KNOTS = json.loads((DATA / "knots.json").read_text())["knots"]
LETTERS = "&@gB8%"
DRAWN = 300 if FULL else 2 if BRIEF else 4
REFUSED = 0.5  # of the combinations at most: round ends of holes, and holes without room for a circumscribed fit
LARGEST, MEETING = 100_000, 8_000  # vertices: meshes and solids of more are left to other tests
VOLUME = {"inscribed": 0.03, "area-true": 0.01, "circumscribed": 0.6}  # off by: a chord of a hundredth of the contour
SCALES = {"1": 1.0, "1-0.5*t": 7 / 12, "1+0.4*sin(2*pi*t)": 1.08}  # the mean of each squared


def one_of(random, choices):
    return choices[random.integers(len(choices))]


def aerofoil(path):
    rows = [line.split() for line in path.read_text().splitlines()[1:]]
    return sw.contours.Outline([np.array([row for row in rows if len(row) == 2], dtype=float)])


def contour(random):
    """A real one, its centroid at the origin, as far as a metre from it."""
    kind = random.integers(5)
    if kind == 0:
        made = sw.contours.from_svg(one_of(random, ICONS))
    elif kind == 1:
        pytest.importorskip("fontTools")
        made = sw.contours.from_text(one_of(random, LETTERS), FONT)
    elif kind == 2:
        made = aerofoil(one_of(random, AEROFOILS))
    else:
        made = drawn(one_of(random, REAL if kind == 3 else OUTLINES))
    return placed(made, 1 / np.linalg.norm(made.section().points - made.section().centroid, axis=1).max())


def placed(outline, factor):
    """An outline scaled about its centroid, which comes to the origin."""
    loops = [factor * (np.array(loop) - outline.section().centroid) for loop in outline.loops]
    return sw.contours.Outline(loops, outline.bulges, factor * outline.tolerance)


def cornered(random, points, closed):
    """A polyline with one kind of corners."""
    legs = np.linalg.norm(np.diff(points, axis=0, append=points[:1] if closed else points[-1:]), axis=1)
    size = random.uniform(0.02, 0.2) * legs[legs > 0].min()
    corner = one_of(random, (sw.corners.Mitre(), sw.corners.Round(size), sw.corners.Bevel(size)))
    return sw.trajectories.Polyline(points, closed, corner)


def recorded(random):
    points = np.array(one_of(random, LINES)["points"])
    count = int(random.integers(4, min(40, len(points)) + 1))
    first = random.integers(len(points) - count + 1)
    points = points[first : first + count] - points[first]
    kinds = sw.trajectories.Sampled, sw.trajectories.Nurbs, lambda points: cornered(random, points, False)
    return one_of(random, kinds)(points)


def knotted(random):
    knot = one_of(random, KNOTS)
    formulas = (re.sub(r"\bt\b", "u", knot[axis]) for axis in "xyz")
    return sw.trajectories.Formula(*formulas, *knot["t"])


def outlined(random):
    section = contour(random).section()
    points = section.points[: section.offsets[1]]
    points = np.column_stack((points, points @ random.normal(size=2) * random.integers(2)))
    return cornered(random, points, bool(random.integers(2)))


PATHS = {"recorded": recorded, "knotted": knotted, "outlined": outlined}
FRAMES = (
    sw.frames.RotationMinimizing(),
    sw.frames.RotationMinimizing(1),
    sw.frames.Frenet(),
    sw.frames.Frenet("exact"),
    sw.frames.FixedUp(),
    sw.frames.FixedUp((0.3, 1, 0.2)),
)


def combination(random, kind):
    """A sweep, and by how much its scales change its volume; None where Pappus does not tell that."""
    path = PATHS[kind](random)
    box = np.ptp(path.evaluate(np.linspace(*path.domain, 50)), axis=0)
    size = random.uniform(0.005, 0.03) * min(path.length(), box.max())
    scale = one_of(random, [law for law in ("1", *SCALES) if not (path.closed and "-" in law)])
    twist = one_of(random, (0.0, 0.0, 0.7, "2*pi*t", "sin(2*pi*t)"))
    aside = one_of(random, (0.0, 0.0, 0.0, size / 2))
    ends = [one_of(random, ("flat", "flat", "open", "round", sw.ends.Taper(path.length() / 5))) for _ in range(2)]
    sweep = sw.GeneralizedCylinder(
        placed(contour(random), size), path, sw.sampling.Tolerance(size / 100), one_of(random, FRAMES),
        scale_x=scale, scale_y=scale, twist=twist, offset_x=aside, start=ends[0], end=ends[1],
        fit=one_of(random, ("inscribed", "inscribed", "area-true", "circumscribed")),
    )  # fmt: skip
    known = not aside and (path.closed or ends == ["flat", "flat"])
    return sweep, SCALES[scale] if known else None


def assert_sound(mesh, closed):
    assert np.isfinite(mesh.vertices).all() and len(np.unique(mesh.corners)) == len(mesh.vertices)
    assert len(mesh.non_manifold_edges()) == 0
    assert not closed or (len(mesh.boundary_edges()) == 0 and mesh.volume() > 0)


def check(sweep, scaled):
    """What holds of every sweep that is not refused."""
    mesh = sweep.mesh()
    if len(mesh.vertices) > LARGEST:
        return
    closed = bool(sweep.trajectory.closed) or sw.ends.Open() not in (sweep.start, sweep.end)
    assert_sound(mesh, closed)
    assert len(np.unique(mesh.vertices, axis=0)) == len(mesh.vertices), "doubled vertices"
    assert sw.load(sw.dump(sweep)) == sweep
    assert eval(python_source(sweep), {"sw": sw}) == sweep  # written by the program itself
    meets = bool(sweep.self_intersections())
    if scaled and closed and not meets:
        true = scaled * sweep.contour.section().area * sweep.trajectory.length()
        fit = sweep.fit.name.lower().replace("_", "-")
        less = 1e-6 if fit == "circumscribed" else VOLUME[fit]  # which encloses the true shape
        assert true * (1 - less) <= mesh.volume() <= true * (1 + VOLUME[fit])
    if closed and meets and is_there() and len(mesh.vertices) < MEETING:
        assert_sound(sweep.solid(), True)


@pytest.mark.parametrize("more", [1, pytest.param(4 if FULL else 2, marks=pytest.mark.thorough)])
@pytest.mark.parametrize("kind", PATHS)
def test_real_contours_along_real_paths_are_sound_or_refused_in_a_sentence(kind, more):
    refused = 0
    with warnings.catch_warnings(), np.errstate(divide="raise", over="raise", invalid="raise"):
        warnings.simplefilter("error")
        for seed in range(more * DRAWN, 2 * more * DRAWN):
            try:
                check(*combination(np.random.default_rng(seed), kind))
            except sw.ShapeError as error:
                refused += 1
                assert len(str(error).splitlines()) == 1
    assert refused <= REFUSED * more * DRAWN + 2
