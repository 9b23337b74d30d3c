# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is refused is refused in the same sentence, whoever asks: a script, a job, the sidebar, an operator."""

import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import sweep

import sweep_addon as sw
from sweep_addon.core.declared import forms
from sweep_addon.core.declared.parameters import ShapeError

# Each refused in one sentence: what a job says, what the properties say, and the sentence.
REFUSED = [
    (
        {"contour": {"kind": "circle", "radius": 0}},
        {"contour": "CIRCLE", "contour_circle_radius": 0},
        "contour.radius: must be more than 0, got 0",
    ),
    (
        {"contour": {"kind": "rectangle", "width": 1.0, "height": 2.0, "rounding": 0.75}},
        {
            "contour_rectangle_width": 1,
            "contour_rectangle_height": 2,
            "contour_rectangle_rounding": 0.75,
            "contour": "RECTANGLE",
        },
        "contour.rounding: must be at most",
    ),
    (
        {"contour": {"kind": "outline", "loops": [[[0, 0], [1, 1], [1, 0], [0, 1]]]}},
        {"contour_outline_loops": "[[[0, 0], [1, 1], [1, 0], [0, 1]]]", "contour": "OUTLINE"},
        "contour.loops",
    ),
    (
        {"trajectory": {"kind": "polyline", "points": [[0, 0, 0], [1, 0, 0], [0, 0, 0]]}},
        {"trajectory_polyline_points": "[[0, 0, 0], [1, 0, 0], [0, 0, 0]]", "trajectory": "POLYLINE"},
        "trajectory.points: must not turn back on itself",
    ),
    (
        {"trajectory": {"kind": "torus-knot", "p": 2, "q": 4}},
        {"trajectory_torus_knot_p": 2, "trajectory_torus_knot_q": 4, "trajectory": "TORUS_KNOT"},
        "trajectory.q: must share no factor with p, which is 2, got 4",
    ),
    (
        {"frame": {"kind": "fixed-up", "up": [0, 0, 0]}},
        {"frame_fixed_up_up": (0, 0, 0), "frame": "FIXED_UP"},
        "frame.up: must have a length, got [0.0, 0.0, 0.0]",
    ),
    ({"scale_x": "1 +"}, {"scale_x_formula_text": "1 +", "scale_x": "FORMULA"}, "scale_x: "),
    (
        {"twist": "__import__('os')"},
        {"twist_formula_text": "__import__('os')", "twist": "FORMULA"},
        "twist: ",
    ),
    ({"scale_y": [[1, 1], [0, 1]]}, {"scale_y_points_points": "[[1, 1], [0, 1]]", "scale_y": "POINTS"}, "scale_y: "),
]


@pytest.mark.parametrize(("table", "flat", "sentence"), REFUSED)
def test_the_same_refusal_whoever_asks(scene, table, flat, sentence):
    with pytest.raises(ShapeError) as by_constructor:
        sw.GeneralizedCylinder(**table)
    with pytest.raises(ShapeError) as by_job:
        sw.load(forms.toml({"kind": "generalized-cylinder", **table}))

    mesh = sweep().data
    mesh.sweep.paused = True
    for name, value in flat.items():
        setattr(mesh.sweep.generalized_cylinder, name, value)
    mesh.sweep.paused = False

    with pytest.raises(RuntimeError) as by_operator:
        bpy.ops.mesh.generalized_cylinder_add(**flat)

    said = str(by_constructor.value)
    assert said.startswith(sentence) and "\n" not in said
    assert [str(by_job.value), mesh.sweep.error] == [said, said]
    assert str(by_operator.value).strip() == f"Error: {said}"


@pytest.mark.parametrize("text", ["", "7", "{}", "[[", "null", '"a"', "[[1]]", "[" * 5000, '[["a", "b"]]'])
def test_a_hidden_list_that_somebody_spoilt_is_refused(scene, text):
    mesh = sweep().data
    mesh.sweep.generalized_cylinder.contour_outline_loops = text
    mesh.sweep.generalized_cylinder.contour = "OUTLINE"
    assert mesh.sweep.error.startswith("contour.loops: must") and len(mesh.sweep.error) < 200


@pytest.mark.parametrize(
    ("act", "wrong", "got"), [("to_object", 3, "3"), ("from_object", None, "None"), ("from_object", "Cube", "'Cube'")]
)
def test_what_is_no_shape_and_no_sweep_is_refused_and_leaves_nothing(scene, act, wrong, got):
    before = set(bpy.data.meshes)
    with pytest.raises(sw.ShapeError, match=f"must be a s.*, got {got}"):
        getattr(sw, act)(wrong)
    assert set(bpy.data.meshes) == before
