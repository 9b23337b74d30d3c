# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A refusal shows what it got on one line, whatever that was."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweep_addon.core.contours import Circle, Outline, from_dxf, from_svg, offset
from sweep_addon.core.csg import Tree
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.declared.wording import shown
from sweep_addon.core.envelopes.reach import reach
from sweep_addon.core.grammars import LSystem
from sweep_addon.core.shapes.generalized_cylinder import GeneralizedCylinder
from sweep_addon.core.shapes.plant import Plant
from sweep_addon.core.stations.frames import Frenet
from sweep_addon.core.stations.sampling import Tolerance
from sweep_addon.core.trajectories import Line, Polyline, from_csv, from_gpx


def nested(depth):
    inner = []
    for _ in range(depth):
        inner = [inner]
    return inner


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: Circle(points=10**5000), "points: must be at most 1e+12 in size, got 0x"),
        (lambda: Circle(points=np.int64(2)), "points: must be at least 3, got 2"),
        (lambda: Circle(radius=nested(5000)), "radius: must be a number of metres, got "),  # newer Pythons can write it
        (lambda: Circle(radius=[10**5000]), "radius: must be a number of metres, got a list"),
        (lambda: Circle(radius=np.eye(2)), "radius: must be a number of metres, got array([[1., 0.], [0., 1.]])"),
        (lambda: Circle(radius="1\n2"), r"radius: must be a number of metres, got '1\n2'"),
        (lambda: Polyline(nested(5000)), "points: must be a list of 3 numbers each, got "),
        (lambda: Polyline(np.zeros((10**5, 2))), "points: must be a list of 3 numbers each, got array([[0., 0.], "),
        (lambda: Polyline([[0, 0, 0], ["a" * 10**6]]), "points: must be a list of 3 numbers each, got ['aaaaaa"),
        (lambda: Polyline("a" * 10**6), "points: must be a list of 3 numbers each, got 'aaa"),
    ],
)
def test_a_refusal_of_what_cannot_be_written_is_a_sentence(make, sentence):
    with pytest.raises(ShapeError) as refusal:
        make()
    got = str(refusal.value).partition(", got ")[2]
    assert str(refusal.value).startswith(sentence)
    assert "\n" not in got and len(got) <= 60


@pytest.mark.parametrize(
    ("key", "said"),
    [("con\ntour", r"'con\ntour'"), ("\x1b[2J", r"'\x1b[2J'"), ("k" * 10**6, "'" + 56 * "k" + "..."), (2, "2")],
)
def test_an_unknown_key_is_told_on_one_short_line(key, said):
    with pytest.raises(ShapeError) as refusal:
        GeneralizedCylinder(contour={"kind": "circle", key: 1})
    assert str(refusal.value) == f"contour.{said}: is no parameter of Circle, which has radius, points"


PATH = Polyline([(0, 0, z) for z in range(4)], radii=(1, 0, 0, 1))
TRACK = '<gpx><trk><trkseg><trkpt lat="0" lon="0"/><trkpt lat="0" lon="1"/></trkseg></trk></gpx>'
HUGE = GeneralizedCylinder(Circle(1e10), Line(end=(0, 0, 1e10)), Tolerance(1e-9), end="round")


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (
            HUGE.mesh,
            "samples.chord: must be larger: a round end takes 1,756,203,683 contours of 200,000 at most, got 1e-09",
        ),
        (
            GeneralizedCylinder(trajectory=Line(), frame=Frenet("refuse")).mesh,
            "frame.continuation: must be smooth or exact where the curvature vanishes, got refuse near u = 0",
        ),
        (
            GeneralizedCylinder(trajectory=PATH).mesh,
            "trajectory.radii: must not stay 0 along a stretch, got 0 at contour 2",
        ),
        (lambda: GeneralizedCylinder().frames("x"), "most: must be a whole number, at least 2, got 'x'"),
        (
            lambda: offset(Line(), 1.0),
            "contour: must be a contour, got Line(start=(0.0, 0.0, 0.0), end=(0.0, 0.0, 1.0))",
        ),
        (lambda: reach([]), "trajectory: must be a trajectory, got []"),
        (lambda: Line(np.array("x")), "start: must be a list, got array('x', dtype='<U1')"),
        (lambda: Plant(upright=[]), "upright: must be one of automatic, upwards, along-x, got []"),
        (lambda: Plant(seed="x"), "seed: must be a whole number, got 'x'"),
        (
            lambda: Plant("#define ratio 2\naxiom: F", constants={"ratoi": 1, "q": 2}),
            "constants.ratoi: is no constant of the text, which has ratio: did you mean 'ratio'?",
        ),
        (
            lambda: Outline([(0, 0), (1, 0), (1, 1)]),
            "loops: must be a list of lists of 2 numbers each, got [(0, 0), (1, 0), (1, 1)]",
        ),
        (
            lambda: Outline(np.zeros((3, 2))),
            "loops: must be a list of lists of 2 numbers each, got array([[0., 0.], [0., 0.], [0., 0.]])",
        ),
        (
            lambda: Plant(Path("a.l")),
            f"system: must be the text of a grammar, as .read_text() of a path gives, got {Path('a.l')!r}",
        ),
        (lambda: LSystem("axiom: F"), "axiom: must be modules, and a text be told to LSystem.parse, got 'axiom: F'"),
        (
            lambda: GeneralizedCylinder(samples=100),
            "samples: must be one of tolerance, count, got 100: say Count(contours=...) or "
            '{ kind = "count", contours = ... }',
        ),
        (lambda: Tree("blok"), "base: must be a shape, a solid or a tree, got 'blok': did you mean 'block'?"),
        (lambda: Tree("cube"), "base: must be a shape, a solid or a tree, got 'cube': say 'block'"),
        (lambda: GeneralizedCylinder().frames(1), "most: must be a whole number, at least 2, got 1"),
        (lambda: reach(Circle()), "trajectory: must be a trajectory, got Circle(radius=1.0, points=64)"),
    ],
)
def test_a_refusal_names_what_would_have_to_change(make, sentence):
    with pytest.raises(ShapeError) as refusal:
        make()
    assert str(refusal.value) == sentence


def test_an_origin_in_text_is_the_numbers_it_says():
    assert from_gpx(TRACK, origin=("0", "0", "0")) == from_gpx(TRACK, origin=(0, 0, 0))


@given(
    st.recursive(
        st.integers() | st.floats() | st.text() | st.binary() | st.none(),
        lambda inner: st.lists(inner) | st.tuples(inner),
    )
)
def test_any_value_is_shown_on_one_short_line(value):
    assert len(shown(value)) <= 60 and len(shown(value).splitlines()) == 1


@pytest.mark.parametrize("read", [from_svg, from_dxf, from_gpx, from_csv])
def test_a_folder_and_a_device_without_end_are_no_documents(read, tmp_path):
    with pytest.raises(ShapeError, match="^the [A-Z]+ file .* must be a file, got a folder$"):
        read(tmp_path)
    if Path("/dev/zero").exists():
        with pytest.raises(ShapeError, match="^the [A-Z]+ file /dev/zero must have at most [0-9,]+ bytes$"):
            read("/dev/zero")
