# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours from SVG drawings."""

import io
from contextlib import suppress
from xml.etree import ElementTree

import numpy as np

from ..declared.documents import about, content
from ..declared.parameters import ShapeError
from ..declared.wording import shown
from .flatten import cubics_from_lines, cubics_from_quadratics
from .reading import argument, library, outline
from .svg_document import LARGEST, tree

ROUNDED = 1.25e-4  # of a drawing: gaps that three decimals leave in one of 16 units
SMALL = 1e-3, 1e-2  # of a path and of its width: a wider gap may be a side of it
ARC = np.pi / 6  # the part of an ellipse for one cubic, which misses it by 4e-7 of its radius


def from_svg(text_or_path, scale=1.0, tolerance=0.0, centred=True):
    """Make an outline of everything that an SVG drawing fills.

    Parameters
    ----------
    text_or_path : str or Path
        The text of a drawing, or the path of a file of at most 2 MB.
    scale : float
        Metres for one unit of the drawing's coordinates.
    tolerance : float
        Largest distance of a curve from its chords in metres; 0 is a thousandth of the drawing's size.
    centred : bool
        Whether the centroid of the area becomes the reference point; otherwise the drawing's origin is.

    Returns
    -------
    Outline
        Straight loops, y upwards. Where they turn by more than 20 degrees they are sharp; chords of curves turn by at
        most 15.

    Raises
    ------
    ShapeError
        For what is no SVG, a drawing that fills nothing, more than 200,000 points, and a document made to fill memory.

    Paths, rectangles, circles, ellipses, polygons and what uses them are united, each filled by its own rule and with
    its transforms. Style sheets count where their selectors are an element, a class or an id. Strokes, texts, pictures,
    clipping and masks are left out. Overlaps are resolved to single
    precision; areas that touch in a point are drawn apart there by a few millionths of the size. Paths that miss their
    start by no more than rounding are led back to it.

    Examples
    --------
    >>> contour = from_svg('<svg><path d="M0 0h4v4h-4z M1 1v2h2v-2z"/></svg>', scale=0.5)
    >>> contour.section().area, contour.section().islands
    (3.0, ((0, 1),))
    """
    scale = argument("scale", scale, above=0.0)
    data, subject = content(text_or_path, "SVG", "<", LARGEST)
    with about(subject):
        with np.errstate(all="ignore"):
            figures = drawn_figures(*tree(data))
            paths = led_back([path for paths, _ in figures for path in paths])
        paths = [scale * path * (1, -1) for path in paths]
        figure = np.repeat(np.arange(len(figures)), [len(paths) for paths, _ in figures])
        return outline(paths, figure, [rule == "evenodd" for _, rule in figures], tolerance, centred)


def drawn_figures(root, width, height):
    """What a document fills, in its own units: for each shape its paths of (n, 4, 2) cubics, and its fill rule."""
    svgelements = library("svgelements", "svgelements")
    text = io.BytesIO(ElementTree.tostring(root))
    try:
        drawing = svgelements.SVG.parse(text, reify=False, width=height, height=width)  # it swaps them
        shapes = [shape for shape in drawing.elements() if isinstance(shape, svgelements.Shape)]
        shapes = [(shape, paths_of(svgelements, shape)) for shape in shapes]
    except Exception as error:  # the parser meets wrong numbers, units and colours in ways of its own
        refuse_misspelt(svgelements, root)
        raise ShapeError(f"has something that cannot be understood: {error}") from error
    shapes = [(shape, paths) for shape, paths in shapes if paths]
    figures = [(paths, shape.values.get("fill-rule")) for shape, paths in shapes if is_filled(shape)]
    if not figures:
        raise ShapeError(f"must fill at least one path, got {'only unfilled ones' if shapes else 'none'}")
    return figures


def refuse_misspelt(svgelements, root):
    """Refuse the first path data or transform that cannot be read, now that it is known that something cannot."""

    def drawn(text):
        return paths_of(svgelements, svgelements.Path(text))

    for key, what, read in ("d", "path data", drawn), ("transform", "transforms", svgelements.Matrix):
        for text in filter(None, (element.get(key) for element in root.iter())):
            with suppress(Exception):
                read(text)
                continue
            raise ShapeError(f"must have {what} that can be understood, got {shown(text)}")


def is_filled(shape):
    hidden = shape.values.get("visibility") in ("hidden", "collapse")
    clear = any(is_nothing(shape.values.get(key, "1")) for key in ("opacity", "fill-opacity"))
    return not hidden and not clear and shape.values.get("fill") not in ("none", "transparent")


def is_nothing(opacity):
    try:
        return float(opacity.strip().removesuffix("%")) <= 0
    except ValueError:
        return False


def paths_of(svgelements, shape):
    """The closed paths of a shape, (n, 4, 2) cubics each, with its transform."""
    paths, cubics = [], []
    for segment in [*shape.segments(transformed=False), svgelements.Move((0, 0))]:
        if isinstance(segment, (svgelements.Move, svgelements.Close)):
            if cubics:
                closing = cubics_from_lines([(cubics[-1][-1][3], cubics[0][0][0])])
                paths.append(np.concatenate([*cubics, closing]))
            cubics = []
        elif segment.start and segment.end:
            cubics.append(cubics_of(svgelements, segment))
    m = shape.transform
    return [path @ np.array([(m.a, m.b), (m.c, m.d)]) + (m.e, m.f) for path in paths]


def led_back(paths):
    """Closed paths, without the line that closes one where that bridges no more than rounding: the path ends there.

    Coordinates that are rounded and added up do not lead back to where they began. The line from there has any
    direction, also back along the path: a wall of its own as soon as the sides lean, and an edge that is sharp.

    Parameters
    ----------
    paths : list of (n, 4, 2) float arrays
        Cubics, the last one of each a line back to its start.

    Examples
    --------
    >>> corners = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0004, -0.0004), (0.0, 0.0)])
    >>> (square,) = led_back([cubics_from_lines(np.stack((corners[:-1], corners[1:]), axis=1))])
    >>> square[:, 0].tolist(), square[-1, 3].tolist()
    ([[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]], [0.0, 0.0])
    """
    of_path, of_width = SMALL
    most = ROUNDED * size(np.concatenate(paths))
    found = []
    for path in paths:
        gap = float(np.hypot(*(path[-1, 3] - path[-1, 0])))
        if len(path) > 3 and gap <= min(most, of_path * size(path), of_width * width(path)):
            path = path[:-1].copy()
            path[-1, 3] = path[0, 0]
        found.append(path)
    return found


def size(path):
    """The diagonal of the box round where the segments of a path start."""
    return float(np.hypot(*np.ptp(path[:, 0], axis=0)))


def width(path):
    """How wide a path is that goes round a long area: about its area over its size."""
    x, y = (path[:, :3].reshape(-1, 2) - path[0, 0]).T
    return float(abs(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2 / (size(path) or 1.0)


def cubics_of(svgelements, segment):
    """One segment as (n, 4, 2) cubics."""
    if isinstance(segment, svgelements.Arc):
        parts = segment.as_cubic_curves(max(1, int(np.ceil(abs(segment.sweep) / ARC))))
        return np.array([numbers(part.start, part.control1, part.control2, part.end) for part in parts])
    if isinstance(segment, svgelements.CubicBezier):
        return np.array([numbers(segment.start, segment.control1, segment.control2, segment.end)])
    if isinstance(segment, svgelements.QuadraticBezier):
        return cubics_from_quadratics([numbers(segment.start, segment.control, segment.end)])
    return cubics_from_lines([numbers(segment.start, segment.end)])


def numbers(*points):
    return [(point.x, point.y) for point in points]
