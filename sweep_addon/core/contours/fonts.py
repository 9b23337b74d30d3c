# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours from text: the glyphs of a font file, side by side."""

import logging
from contextlib import contextmanager
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path

import numpy as np

from ..declared.documents import about, contained
from ..declared.parameters import ShapeError, require
from .flatten import cubics_from_lines, cubics_from_quadratics
from .reading import argument, library, outline

LONGEST = 10_000
LARGEST = 50_000_000  # bytes of a font
COMPRESSED = b"wOF2"  # how a font of web pages begins


def from_text(text, font_path, size=1.0, tolerance=0.0, centred=True):
    """Make an outline of a text in the font of a file.

    Parameters
    ----------
    text : str
        At most 10,000 characters; a line break begins a line below.
    font_path : str or Path
        A TrueType or OpenType file, or a collection, of which the first font is taken.
    size : float
        The font's em in metres: about the distance between lines of a page.
    tolerance : float
        Largest distance of a curve from its chords in metres; 0 is a thousandth of the text's size.
    centred : bool
        Whether the centroid of the area becomes the reference point; otherwise the text begins there, on its baseline.

    Returns
    -------
    Outline
        Straight loops. Where they turn by more than 20 degrees they are sharp; chords of curves turn by at most 15.

    Raises
    ------
    ShapeError
        For a text that shows nothing, a file that is no font, and a character that the font has no glyph for.

    Glyphs stand at the font's advance widths, without kerning and ligatures. Those that overlap are united.

    Examples
    --------
    >>> from_text("", "no.ttf")  # doctest: +IGNORE_EXCEPTION_DETAIL
    Traceback (most recent call last):
    sweep_addon.core.declared.parameters.ShapeError: text: must have a visible character, got ''
    """
    text, size = argument("text", text, str), argument("size", size, above=0.0)
    require(text.strip(), "must have a visible character", text, "text")
    require(len(text) <= LONGEST, f"must have at most {LONGEST} characters", len(text), "text")
    require(isinstance(font_path, (str, Path)), "must be the path of a font's file", font_path, "font_path")
    with about(f"the font {font_path}"), unheard("fontTools"):
        paths = placed_glyphs(text, opened(font_path))
        require(paths, "must draw something for the text", text)
        scaled = [size * path for path in paths]
        return outline(scaled, np.zeros(len(paths), dtype=int), [False], tolerance, centred)


@contextmanager
def unheard(library):
    """What a library logs, of dates in a font say, is for those who ask: else Python writes it on the error stream."""
    log, nobody = logging.getLogger(library), logging.NullHandler()
    log.addHandler(nobody)
    try:
        yield
    finally:
        log.removeHandler(nobody)


def opened(font_path):
    """The first font of a file."""
    ttlib = library("fontTools.ttLib", "fonttools")
    try:
        data = contained(Path(font_path), LARGEST)
        require(not data.startswith(COMPRESSED) or unpacks(), "must be a .ttf or .otf file, not compressed", "WOFF2")
        return ttlib.TTFont(BytesIO(data), fontNumber=0, lazy=True)  # no file stays open
    except ShapeError:
        raise
    except (OSError, ValueError) as error:
        raise ShapeError(f"cannot be read: {getattr(error, 'strerror', None) or error}") from error
    except (ttlib.TTLibError, ImportError, AssertionError) as error:
        raise ShapeError(f"must be a TrueType or OpenType file, got: {error}") from error


def unpacks():
    """Whether fontTools finds what it takes to unpack a font of web pages; without, it says so on the error stream."""
    return any(map(find_spec, ("brotli", "brotlicffi")))


def placed_glyphs(text, font):
    """The closed paths of a text, (n, 4, 2) cubics each, with an em of 1 and the baseline's start at the origin."""
    try:
        glyphs, names = font.getGlyphSet(), font.getBestCmap() or {}
        em, line = font["head"].unitsPerEm, font["hhea"].ascent - font["hhea"].descent + font["hhea"].lineGap
    except Exception as error:  # tables that are missing or broken, in ways of the library's own
        raise ShapeError(f"must have outlines, widths and a character map, got: {error!r}") from error
    known, paths, place, pen = {}, [], np.zeros(2), cubic_pen()
    for character in text.replace("\r\n", "\n"):
        if character == "\n":
            place = np.array([0.0, place[1] - line])
            continue
        shown = f"{character!r} (U+{ord(character):04X})"
        if ord(character) not in names:
            raise ShapeError(f"must have a glyph for every character of the text, got none for {shown}")
        if character not in known:
            known[character] = glyph(glyphs, names[ord(character)], pen(glyphs), shown)
        drawn, advance = known[character]
        paths += [(path + place) / em for path in drawn]
        place = place + (advance, 0)
    return paths


def glyph(glyphs, name, pen, shown):
    """The closed paths of a glyph and its advance width, in the font's units."""
    try:
        glyphs[name].draw(pen)
        return [np.concatenate(path) for path in pen.paths if path], glyphs[name].width
    except Exception as error:  # broken outlines, in ways of the library's own
        raise ShapeError(f"must have a sound glyph for {shown}, got: {error!r}") from error


def cubic_pen():
    """A pen of fontTools that collects closed paths as (1, 4, 2) cubics."""
    base = library("fontTools.pens.basePen", "fonttools")

    class CubicPen(base.BasePen):
        """Components are drawn in their places and splines taken apart by the base, which calls these."""

        def __init__(self, glyphs):
            super().__init__(glyphs)
            self.paths = []

        def _moveTo(self, point):  # noqa: N802
            self.paths.append([])
            self.start = point

        def _lineTo(self, point):  # noqa: N802
            self.paths[-1].append(cubics_from_lines([(self._getCurrentPoint(), point)]))

        def _curveToOne(self, first, second, end):  # noqa: N802
            self.paths[-1].append(np.array([(self._getCurrentPoint(), first, second, end)], dtype=float))

        def _qCurveToOne(self, first, end):  # noqa: N802
            self.paths[-1].append(cubics_from_quadratics([(self._getCurrentPoint(), first, end)]))

        def _closePath(self):  # noqa: N802
            self._lineTo(self.start)

        _endPath = _closePath  # noqa: N815

    return CubicPen
