# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""SVG drawings become the outline of what a renderer fills, and hostile ones a sentence."""

import numpy as np
import pytest
from contour_inputs import DATA

from sweep_addon.core.contours import Outline, from_svg
from sweep_addon.core.declared.parameters import ShapeError

pytest.importorskip("svgelements")

# Units covered in librsvg's 320 x 320 picture of the file; such pixels count the edge to about 1e-3 of the area.
RENDERED = {
    "bicycle": 60.61,
    "cookie": 90.61,
    "flower1": 111.76,
    "gear-fill": 132.06,
    "gear-wide-connected": 102.49,
    "infinity": 41.70,
    "puzzle-fill": 129.56,
    "radioactive": 106.94,
    "yin-yang": 124.08,
}


@pytest.mark.parametrize("name", RENDERED)
def test_an_icon_fills_what_a_renderer_fills(name):
    contour = from_svg(DATA / "svg" / f"{name}.svg", tolerance=1e-3)
    assert contour.section().area == pytest.approx(RENDERED[name], rel=2e-3)
    assert contour.section().centroid == pytest.approx([0, 0], abs=1e-6)


def svg(body, attributes=""):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{body}</svg>'


@pytest.mark.parametrize(
    ("body", "area"),
    [
        ('<rect x="1" y="1" width="4" height="2" rx="1"/>', 4 + np.pi),
        ('<circle cx="5" cy="5" r="2"/>', 4 * np.pi),
        ('<ellipse rx="3" ry="2" transform="rotate(30) skewX(20) scale(2 1)"/>', 12 * np.pi),
        ('<path d="M-3 0A3 2 25 0 0 3 0A3 2 25 0 0 -3 0" transform="matrix(1 0 1 1 0 0)"/>', None),
        ('<polygon points="0 0 4 0 4 3"/>', 6),
        ('<path d="M0 0h4v4h-4zM1 1h1v1h-1z"/>', 16),
        ('<path d="M0 0h4v4h-4zM1 1v1h1v-1z"/>', 15),
        ('<path d="M0 0h4v4h-4zM1 1h1v1h-1z" fill-rule="evenodd"/>', 15),
        ('<g style="fill-rule:evenodd"><path d="M0 0h4v4h-4zM1 1h1v1h-1z"/></g>', 15),
        ('<path d="M0 0Q2 4 4 0"/>', 16 / 3),
        ('<path d="M0 0h2v2"/><path d="M9 9h2v2" fill="none" stroke="red"/>', 2),
        ('<g display="none"><rect width="9" height="9"/></g><rect width="1" height="1"/>', 1),
        ('<defs><rect id="a" width="2" height="1"/></defs><use href="#a"/><use href="#a" x="1"/>', 3),
        ('<symbol id="s"><rect width="2" height="1"/></symbol><rect width="1" height="1" x="7"/>', 1),
        ('<rect width="3" height="3"/><rect x="2" y="2" width="3" height="3"/>', 17),
    ],
)
def test_shapes_fill_their_area(body, area):
    section = from_svg(svg(body), tolerance=1e-5).section()
    if area is None:  # an arc that has to be enlarged to reach: sheared it keeps its area
        area = from_svg(svg(body.split("transform")[0] + "/>"), tolerance=1e-5).section().area
    assert section.area == pytest.approx(area, rel=1e-4)


def test_the_drawing_keeps_its_units_and_turns_y_up():
    text = svg('<path d="M10 20h4v2z"/>', 'width="1em" height="3in" viewBox="10 10 50 20"')
    points = from_svg(text, scale=0.5, centred=False).section().points
    assert sorted(map(tuple, points.round(6).tolist())) == [(5, -10), (7, -11), (7, -10)]


def test_a_path_whose_numbers_miss_its_start_by_rounding_has_no_edge_back_to_it():
    square = svg('<path d="M0 0h16v16h-16l.001-16.001z"/>')
    assert len(from_svg(square).section().points) == 4
    assert from_svg(square).section().sharp.all()


def test_a_short_edge_that_closes_a_small_path_of_a_large_drawing_is_one():
    text = svg('<path d="M0 0h1000v1000h-1000z"/><path d="M2000 0h.5v.5l-.4-.1l-.09-.3z"/>')
    assert [len(loop) for loop in from_svg(text).loops] == [4, 5]


@pytest.mark.parametrize("first", range(4))
def test_a_hairline_is_as_wide_whichever_side_closes_it(first):
    """Its short sides are no longer than gaps that rounding leaves in so large a drawing."""
    corners = np.roll([(0, 0), (100, 0), (100, 0.01), (0, 0.01)], first, axis=0)
    text = svg(f'<path d="M{" ".join(map(str, corners.ravel()))}z"/>')
    assert from_svg(text).section().area == pytest.approx(1.0, rel=2e-3)  # of places in single precision


def test_percentages_are_of_the_drawings_own_size():
    assert from_svg(svg('<rect width="100%" height="50%"/>', 'viewBox="0 0 10 10"')).section().area == pytest.approx(50)


SQUARE = '<rect width="10" height="10"/>'
SYMBOL = f'<symbol id="s" viewBox="0 0 10 10">{SQUARE}</symbol>'
WIDE = 'viewBox="0 0 100 40"'


@pytest.mark.parametrize(
    ("body", "attributes", "low", "high"),
    [
        ('<rect width="100%" height="100%"/>', WIDE, (0, 0), (100, 40)),
        ('<rect x="50%" y="50%" width="10%" height="10%"/>', WIDE, (50, 20), (60, 24)),
        ('<ellipse cx="50%" cy="50%" rx="10%" ry="10%"/>', WIDE, (40, 16), (60, 24)),
        ('<defs><rect id="r" width="1" height="1"/></defs><use href="#r" x="50%"/>', WIDE, (50, 0), (51, 1)),
        ('<rect width="100%" height="100%"/>', 'width="100px" height="40px"', (0, 0), (100, 40)),
        ('<rect width="100%" height="100%"/>', 'width="1in" height="25.4mm"', (0, 0), (96, 96)),
        (f'<svg x="10" y="20" width="10" height="10" viewBox="0 0 10 10">{SQUARE}</svg>', "", (10, 20), (20, 30)),
        (f'<svg x="10" y="20" width="20" height="20" viewBox="0 0 10 10">{SQUARE}</svg>', "", (10, 20), (30, 40)),
        (f'<svg x="10" y="20" width="20" height="20">{SQUARE}</svg>', "", (10, 20), (20, 30)),
        (f'{SYMBOL}<use href="#s" width="20" height="20" x="5" y="1"/>', "", (5, 1), (25, 21)),
        (f'{SYMBOL}<g transform="scale(2)"><use href="#s" width="20" height="30" x="5"/></g>', "", (10, 10), (50, 50)),
        (f'{SYMBOL.replace("0 0 10", "5 5 10")}<use href="#s" width="20" height="20"/>', "", (-10, -10), (10, 10)),
        (
            f'{SYMBOL}<symbol id="t" viewBox="0 0 10 10"><use href="#s" width="5" height="5" x="5"/></symbol>'
            '<use href="#t" width="20" height="20" x="100"/>',
            "",
            (110, 0),
            (120, 10),
        ),
    ],
)
def test_what_is_drawn_is_where_and_as_large_as_the_standard_says(body, attributes, low, high):
    """SVG 2, 7.9 and 8.9: percentages are of the nearest viewport, a viewBox is fitted into the middle of its own."""
    (loop,) = map(np.asarray, from_svg(svg(body, attributes), centred=False).loops)
    assert np.ptp(loop, axis=0) == pytest.approx(np.subtract(high, low), rel=2e-3)
    assert (loop.min(axis=0) + loop.max(axis=0)) / 2 == pytest.approx(np.add(low, high) / 2 * (1, -1), abs=1e-3)


@pytest.mark.parametrize(
    "attributes",
    [
        'style="fill:none !important"',
        'style="fill:none!important;stroke:red"',
        'style="display: none ! important"',
        'fill=" none "',
        'fill-opacity="0"',
        'style="fill-opacity:0.0"',
        'opacity="0%"',
        'class="hidden"',
    ],
)
def test_what_is_not_filled_is_no_part_of_the_outline(attributes):
    style = "<style>.hidden{fill:none !important}</style>"
    seen, unseen = '<rect x="50" width="1" height="1"/>', SQUARE.replace("<rect", f"<rect {attributes}")
    assert from_svg(svg(style + unseen + seen)).section().area == pytest.approx(1)


def test_what_is_inherited_by_name_is_inherited():
    inherits = SQUARE.replace("<rect", '<rect fill="inherit"')
    body = f'<g fill="none">{inherits}</g><rect x="50" width="1" height="1"/>'
    assert from_svg(svg(body)).section().area == pytest.approx(1)


def test_curves_are_smooth_and_corners_sharp():
    circle, half = (from_svg(svg(f'<path d="M-1 0A1 1 0 0 0 1 0{end}"/>')) for end in ("A1 1 0 0 0 -1 0", "z"))
    assert not circle.section().sharp.any()
    assert half.section().sharp.sum() == 2


def test_the_outline_is_a_plain_value():
    contour = from_svg(svg('<circle r="1"/>'))
    assert contour == Outline(loops=[loop.values.tolist() for loop in contour.loops])


LAUGHS = "".join(f'<!ENTITY l{i} "{f"&l{i - 1};" * 10}">' for i in range(1, 12))
BOMB = "".join(f'<g id="a{i + 1}">{f"""<use href="#a{i}"/>""" * 10}</g>' for i in range(12))
CHAIN = "".join(f'<use id="a{i + 1}" href="#a{i}"/>' for i in range(3000))


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "svg: must be SVG text or a path, got ''"),
        (None, "svg: must be SVG text or a path, got None"),
        ("no/such.svg", "the SVG file no/such.svg cannot be read: No such file or directory"),
        (svg(""), "the SVG text must fill at least one path, got none"),
        (svg("<text>hello</text>"), "the SVG text must fill at least one path, got none"),
        (svg('<path d="M0 0h1v1" fill="none"/>'), "the SVG text must fill at least one path, got only unfilled ones"),
        (svg('<path d="M0 0h9"/>'), "the SVG text must fill an area, got 0"),
        (svg('<path d="M0 0h1e999v1z"/>'), "the SVG text must have finite numbers up to 1e+12 in size, got "),
        (svg('<path d="hello"/>'), "the SVG text must have path data that can be understood, got 'hello'"),
        (
            svg('<path d="M0 0h1v1z"/><path d="hello world"/>'),
            "the SVG text must have path data that can be understood, got 'hello world'",
        ),
        (
            svg('<path d="M0 0h1v1z" transform="matrix(1)"/>'),
            "the SVG text must have transforms that can be understood",
        ),
        ("<svg><path</svg>", "the SVG text must be XML, got an error: not well-formed"),
        ("<html/>", "the SVG text must have an svg element at its root, got 'html'"),
        (
            f'<!DOCTYPE svg [<!ENTITY l0 "lol">{LAUGHS}]><svg>&l11;</svg>',
            "the SVG text must have no entity declarations",
        ),
        ('<!DOCTYPE svg [<!ENTITY x SYSTEM "file:///etc/passwd">]><svg>&x;</svg>', "the SVG text must have no entity"),
        ("<svg>" + "<g>" * 50_000 + "</g>" * 50_000 + "</svg>", "the SVG text must have elements nested at most 100"),
        (svg('<g id="a"><use href="#a"/></g>'), "the SVG text must have no use of an element within itself, got 'a'"),
        (svg('<g id="a0"><path d="M0 0h1v1z"/></g>' + BOMB), "the SVG text must have at most 2000000 characters with"),
        (
            svg('<g id="a0"><path d="M0 0h1v1z"/></g>' + CHAIN),
            "the SVG text must have elements and uses nested at most",
        ),
        (svg(" " * 2_000_001), "the SVG text must have at most 2000000 characters, got"),
        (
            svg('<rect width="1" height="1"/>' * 3000),
            "the SVG text must overlap at no more than 1000000 pairs of edges",
        ),
    ],
    ids=range(21),
)
def test_what_fills_nothing_or_would_fill_memory_is_refused_in_one_sentence(text, sentence):
    with pytest.raises(ShapeError) as refusal:
        from_svg(text)
    assert str(refusal.value).startswith(sentence)


def test_a_document_type_without_entities_is_harmless():
    doctype = '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">'
    assert from_svg(doctype + svg('<path d="M0 0h1v1z"/>')).section().area == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("argument", "sentence"),
    [
        ({"scale": "1 mm"}, "scale: must be a number, got '1 mm'"),
        ({"scale": None}, "scale: must be a number, got None"),
        ({"scale": np.nan}, "scale: must be a number, got nan"),
        ({"scale": [1, 2]}, "scale: must be a number, got [1, 2]"),
        ({"tolerance": "fine"}, "tolerance: must be a number, got 'fine'"),
        ({"tolerance": np.nan}, "tolerance: must be a number, got nan"),
        ({"centred": "no"}, "centred: must be true or false, got 'no'"),
    ],
)
def test_arguments_of_another_type_are_named(argument, sentence):
    with pytest.raises(ShapeError) as refusal:
        from_svg(svg('<circle r="1"/>'), **argument)
    assert str(refusal.value) == sentence


def test_parameters_out_of_range_are_named():
    with pytest.raises(ShapeError, match="^scale: must be more than 0, got 0$"):
        from_svg(svg('<circle r="1"/>'), scale=0.0)
    with pytest.raises(ShapeError, match="^tolerance: must be at least 0, got -1$"):
        from_svg(svg('<circle r="1"/>'), tolerance=-1.0)
