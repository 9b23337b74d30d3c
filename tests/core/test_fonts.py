# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Text becomes the outline of its glyphs, with their holes, at their places."""

import gc
import logging
import sys
import warnings
from contextlib import suppress

import numpy as np
import pytest
from contour_inputs import FONT

from sweep_addon.core.contours import from_text
from sweep_addon.core.declared.parameters import ShapeError

pytest.importorskip("fontTools")

# What everybody can see: the islands of a glyph, and the holes in each.
SEEN = {"&": [1], "@": [1], "g": [1], "B": [2], "8": [2], "%": [0, 1, 1], "§": [1], "0": [1], "i": [0, 0], "é": [0, 1]}


@pytest.mark.parametrize("character", SEEN)
def test_a_glyph_has_the_islands_and_holes_that_are_seen(character):
    section = from_text(character, FONT).section()
    assert sorted(len(island) - 1 for island in section.islands) == SEEN[character]
    assert section.centroid == pytest.approx([0, 0], abs=1e-6)


def built(folder, name, advance, contours, curve):
    """A font of one glyph, "A", made here: contours of corners or of cubic segments, 1000 units to the em."""
    from fontTools.fontBuilder import FontBuilder
    from fontTools.pens.t2CharStringPen import T2CharStringPen
    from fontTools.pens.ttGlyphPen import TTGlyphPen

    pens = {".notdef": None, "A": None}
    for glyph in pens:
        pens[glyph] = T2CharStringPen(advance, None) if curve else TTGlyphPen(None)
    for start, *rest in contours:
        pens["A"].moveTo(start)
        for points in rest:
            pens["A"].curveTo(*points) if curve else pens["A"].lineTo(points)
        pens["A"].closePath()
    font = FontBuilder(1000, isTTF=not curve)
    font.setupGlyphOrder(list(pens))
    font.setupCharacterMap({ord("A"): "A"})
    if curve:
        font.setupCFF("Made", {}, {glyph: pen.getCharString() for glyph, pen in pens.items()}, {})
    else:
        font.setupGlyf({glyph: pen.glyph() for glyph, pen in pens.items()})
    left = min(start[0] for start, *_ in contours)
    font.setupHorizontalMetrics({glyph: (advance, left if glyph == "A" else 0) for glyph in pens})
    font.setupHorizontalHeader(ascent=800, descent=-200)
    font.setupPost()
    font.save(folder / name)
    return folder / name


def box(x, y, width, height):
    return [(x, y), (x, y + height), (x + width, y + height), (x + width, y)]


def test_glyphs_that_overlap_themselves_are_united(tmp_path):
    """A plus sign of two bars, as variable fonts draw it."""
    font = built(tmp_path, "plus.ttf", 1000, [box(0, 200, 500, 100), box(200, 0, 100, 500)], curve=False)
    section = from_text("A", font, size=10.0).section()
    assert section.islands == ((0,),)
    assert section.area == pytest.approx(2 * 5 * 1 - 1 * 1, rel=1e-5)


def test_cubic_outlines_are_round(tmp_path):
    k = 4 / 3 * np.tan(np.pi / 8) * 400
    quarter = [(400, 0), (400, k), (k, 400), (0, 400)]
    quarters = [[(round(x), round(y)) for x, y in np.array(quarter) @ m] for m in turns()]
    circle = [quarters[0][0], *(points[1:] for points in quarters)]
    section = from_text("A", built(tmp_path, "disc.otf", 900, [circle], curve=True), tolerance=1e-5).section()
    assert section.area == pytest.approx(np.pi * 0.16, rel=1e-3)
    assert not section.sharp.any()


def turns():
    quarter = np.array([(0, 1), (-1, 0)])
    return [np.linalg.matrix_power(quarter, i) for i in range(4)]


def test_letters_stand_at_their_advance_and_lines_below_each_other(tmp_path):
    font = built(tmp_path, "box.ttf", 700, [box(100, 0, 500, 500)], curve=False)
    section = from_text("AA\nA", font, size=2.0, centred=False).section()
    corners = [tuple(section.points[section.loop_of == i].min(axis=0).round(5)) for i in range(3)]
    assert sorted(corners) == [(0.2, -2.0), (0.2, 0.0), (1.6, 0.0)]


def test_without_centring_text_begins_on_its_baseline():
    points = from_text("AV", FONT, centred=False).section().points
    assert points.min(axis=0) == pytest.approx([0, 0], abs=0.02)
    assert np.ptp(points, axis=0) == pytest.approx([1.36, 0.73], abs=0.02)


@pytest.mark.parametrize(
    ("text", "font", "sentence"),
    [
        ("", FONT, "text: must have a visible character, got ''"),
        ("  \n", FONT, "text: must have a visible character"),
        (7, FONT, "text: must be text, got 7"),
        ("A" * 10_001, FONT, "text: must have at most 10000 characters, got 10001"),
        ("A\u4e00", FONT, f"the font {FONT} must have a glyph for every character of the text, got none for"),
        ("A", "no/such.ttf", "the font no/such.ttf cannot be read: No such file or directory"),
        ("A", __file__, f"the font {__file__} must be a TrueType or OpenType file"),
        ("A", None, "font_path: must be the path of a font's file, got None"),
    ],
    ids=range(8),
)
def test_what_cannot_be_shown_is_refused_in_one_sentence(text, font, sentence):
    with pytest.raises(ShapeError) as refusal:
        from_text(text, font)
    assert str(refusal.value).startswith(sentence)


@pytest.mark.parametrize(
    ("argument", "sentence"),
    [
        ({"size": "big"}, "size: must be a number, got 'big'"),
        ({"size": 0}, "size: must be more than 0, got 0"),
        ({"tolerance": "fine"}, "tolerance: must be a number, got 'fine'"),
        ({"centred": None}, "centred: must be true or false, got None"),
    ],
)
def test_arguments_of_another_type_are_named(argument, sentence):
    with pytest.raises(ShapeError) as refusal:
        from_text("A", FONT, **argument)
    assert str(refusal.value) == sentence


@pytest.mark.parametrize(("text", "font"), [("A", FONT), ("A\u4e00", FONT), ("A", __file__)], ids=range(3))
def test_the_file_of_the_font_is_closed(text, font):
    """Also where the text is refused, or the file."""
    gc.collect()  # what other tests left
    with warnings.catch_warnings(record=True) as told, suppress(ShapeError):
        warnings.simplefilter("always")
        from_text(text, font)
    with warnings.catch_warnings(record=True) as told_later:
        warnings.simplefilter("always")
        gc.collect()
    assert not [warning for warning in told + told_later if warning.category is ResourceWarning]


def test_a_font_of_web_pages_is_refused_where_nothing_unpacks_it(tmp_path, monkeypatch, capfd):
    """In one sentence that says what would do: the library writes one of its own, of a package that is not here."""
    pages = tmp_path / "font.woff2"
    pages.write_bytes(b"wOF2" + bytes(44))
    for package in ("brotli", "brotlicffi"):
        monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ShapeError, match=r"font.woff2 must be a .ttf or .otf file, not compressed, got 'WOFF2'$"):
        from_text("A", pages)
    assert not capfd.readouterr().err


def test_a_font_with_an_odd_date_is_read_without_a_word(tmp_path, monkeypatch, capsys):
    """Many fonts have one, of which the library tells; what is no result and no refusal stays off the error stream."""
    from fontTools.ttLib import TTFont

    odd = TTFont(FONT)
    odd["head"].created = 1  # in the year 1904
    odd.save(tmp_path / "odd.ttf")
    monkeypatch.setattr(logging.getLogger("fontTools"), "propagate", False)  # to where the tests collect it
    assert len(from_text("B", tmp_path / "odd.ttf").loops) == 3
    assert not capsys.readouterr().err


def test_a_missing_glyph_is_named():
    with pytest.raises(ShapeError, match="got none for '\u4e00' \\(U\\+4E00\\)$"):
        from_text("A\u4e00", FONT)
