# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines from DXF drawings, which another program's library writes here, against what they were drawn with."""

from io import StringIO
from math import pi

import numpy as np
import pytest

import sweep_addon as sw
from sweep_addon.core.contours import dxf

ezdxf = pytest.importorskip("ezdxf", reason="drawings are written and read by ezdxf")


def drawing(draw, units=6, version="R2010"):
    """The text of a drawing in a unit: 6 is metres, 4 millimetres."""
    made, text = ezdxf.new(version, units=units), StringIO()
    draw(made.modelspace())
    made.write(text)
    return text.getvalue()


def plate(space):
    space.add_lwpolyline([(0, 0, 0), (4, 0, 1), (4, 2, 0), (0, 2, 0)], format="xyb", close=True)
    space.add_circle((1, 1), 0.5)


@pytest.mark.parametrize("version", ["R12", "R2000", "R2010", "R2018"])
def test_a_plate_with_a_hole_has_its_area(version):
    def draw(space):
        if version == "R12":
            space.add_polyline2d([(0, 0), (4, 0, 0, 0, 1), (4, 2), (0, 2)], format="xyseb", close=True)
            space.add_circle((1, 1), 0.5)
        else:
            plate(space)

    outline = sw.contours.from_dxf(drawing(draw, version=version))
    assert outline.area == pytest.approx(8 + pi / 2 - pi / 4, rel=1e-12)


def test_the_unit_of_the_drawing_counts():
    assert sw.contours.from_dxf(drawing(plate, units=4)).area == pytest.approx((8 + pi / 4) * 1e-6, rel=1e-9)
    assert sw.contours.from_dxf(drawing(plate, units=4), scale=1.0).area == pytest.approx(8 + pi / 4, rel=1e-12)


def test_lines_and_arcs_that_meet_are_joined_whichever_way_they_were_drawn():
    def draw(space):
        space.add_line((0, 1), (3, 1))
        space.add_arc((0, 0), 1, 90, 270)
        space.add_line((3, -1), (0, -1))
        space.add_arc((3, 0), 1, 270, 90)
        space.add_line((9, 9), (9, 8))  # open: no outline

    outline = sw.contours.from_dxf(drawing(draw))
    assert [len(loop) for loop in outline.loops] == [4]
    assert outline.area == pytest.approx(6 + pi, rel=1e-12)


def test_what_is_drawn_from_below_and_in_blocks_is_seen_from_above():
    def draw(space):
        block = space.doc.blocks.new("part")
        block.add_lwpolyline([(0, 0, 1), (2, 0, 1)], format="xyb", close=True)
        space.add_blockref("part", (5, 5), dxfattribs={"xscale": 2, "yscale": 2})
        space.add_lwpolyline([(0, 0, 0.5), (1, 0, 0), (1, 1, 0), (0, 1, 0)], format="xyb", close=True,
                             dxfattribs={"extrusion": (0, 0, -1)})  # fmt: skip

    outline = sw.contours.from_dxf(drawing(draw))
    r = 1.25 / 2
    segment = r**2 / 2 * (4 * np.arctan(0.5) - np.sin(4 * np.arctan(0.5)))
    assert outline.area == pytest.approx(4 * pi + 1 + segment, rel=1e-9)


def test_curves_are_flattened_to_a_thousandth():
    outline = sw.contours.from_dxf(drawing(lambda space: space.add_ellipse((0, 0), (2, 0), 0.5)))
    assert outline.area == pytest.approx(2 * pi, rel=5e-3)


def test_a_layer_may_be_chosen():
    def draw(space):
        space.add_circle((0, 0), 1, dxfattribs={"layer": "CUT"})
        space.add_circle((9, 0), 2, dxfattribs={"layer": "TEXT"})

    assert sw.contours.from_dxf(drawing(draw), layer="CUT").area == pytest.approx(pi, rel=1e-12)
    sentence = "layer: must be one of the layers that have something drawn, 'CUT', 'TEXT', got 'nope'"
    with pytest.raises(sw.ShapeError, match=sentence):
        sw.contours.from_dxf(drawing(draw), layer="nope")


@pytest.mark.parametrize("hide", ["off", "freeze"])
def test_layers_that_are_not_seen_count_only_where_they_are_named(hide):
    def draw(space):
        getattr(space.doc.layers.add("PLAN"), hide)()
        space.add_circle((0, 0), 1)
        space.add_circle((9, 0), 2, dxfattribs={"layer": "PLAN"})
        space.add_circle((99, 0), 3, dxfattribs={"invisible": 1})

    assert sw.contours.from_dxf(drawing(draw)).area == pytest.approx(pi, rel=1e-12)
    assert sw.contours.from_dxf(drawing(draw), layer="PLAN").area == pytest.approx(4 * pi, rel=1e-12)


def test_a_job_may_name_a_drawing(tmp_path):
    (tmp_path / "plate.dxf").write_text(drawing(plate, units=4))
    for scale, size in ((1.0, 1e-3), (2.0, 2.0), (0.001, 1e-3)):
        job = f'kind = "translational-sweep"\ncontour = {{file = "plate.dxf", scale = {scale}}}\n'
        (tmp_path / "job.toml").write_text(job)
        assert sw.load(tmp_path / "job.toml").contour.area == pytest.approx(size**2 * (8 + pi / 4), rel=1e-9)


@pytest.mark.parametrize(
    "text, sentence",
    [
        ("0\nSECTION\nnothing", "the DXF text must "),
        (drawing(lambda space: space.add_line((0, 0), (1, 1))), "the DXF text must have a closed loop, got none"),
        (drawing(lambda space: None), "the DXF text must have a closed loop, got none"),
    ],
)
def test_what_holds_no_outline_is_refused(text, sentence):
    with pytest.raises(sw.ShapeError) as refused:
        sw.contours.from_dxf(text)
    assert str(refused.value).startswith(sentence)


def test_an_arc_all_round_is_a_circle():
    assert sw.contours.from_dxf(drawing(lambda space: space.add_arc((0, 0), 2, 0, 360))).area == pytest.approx(4 * pi)


def test_meshes_of_faces_are_left_out():
    def draw(space):
        plate(space)
        space.add_polymesh((3, 3))
        space.add_polyface().append_face([(0, 0, 0), (1, 0, 0), (1, 1, 0)])

    assert sw.contours.from_dxf(drawing(draw)).area == pytest.approx(8 + pi / 4, rel=1e-12)


@pytest.mark.thorough
def test_blocks_in_blocks_are_not_drawn_for_ever(monkeypatch):
    """Each level draws the one below ten times: a hundred thousand circles of a file of a few kilobytes."""
    monkeypatch.setattr(dxf, "MOST", 5_000)

    def draw(space):
        below = None
        for level in range(5):
            block = space.doc.blocks.new(f"level {level}")
            for _ in range(10):
                block.add_circle((0, 0), 1) if below is None else block.add_blockref(below, (0, 0))
            below = block.name
        space.add_blockref(below, (0, 0))

    with pytest.raises(sw.ShapeError, match="must have at most 5,000 entities"):
        sw.contours.from_dxf(drawing(draw))


@pytest.mark.thorough
def test_thousands_of_lines_in_any_order_are_joined():
    """Shuffled and turned round, the sides of a circle of 2,000 corners."""
    angle = 2 * pi * np.arange(2000) / 2000
    points = np.stack((np.cos(angle), np.sin(angle)), axis=1)
    random = np.random.default_rng(0)

    def draw(space):
        for k in random.permutation(2000):
            space.add_line(*(points[[k, (k + 1) % 2000]][:: random.choice((1, -1))]))

    outline = sw.contours.from_dxf(drawing(draw))
    assert [len(loop) for loop in outline.loops] == [2000]
    assert outline.area == pytest.approx(pi, rel=1e-5)


@pytest.mark.parametrize("seed", range(20))
def test_torn_files_are_refused_or_read(seed):
    """Whatever bytes are lost or changed, the answer is an outline or one sentence."""
    random, text = np.random.default_rng(seed), bytearray(drawing(plate).encode())
    for place in random.integers(0, len(text), 40):
        text[place] = random.integers(32, 127)
    text = text[: random.integers(len(text) // 2, len(text))].decode("latin1")
    try:
        assert sw.contours.from_dxf("SECTION\n" + text).area > 0
    except sw.ShapeError as refused:
        assert "\n" not in str(refused)
