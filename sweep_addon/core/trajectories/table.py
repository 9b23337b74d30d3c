# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trajectories from tables: points in lines of text."""

from collections.abc import Iterable
from math import isfinite, nan

import numpy as np

from ..contours.reading import argument
from ..declared.documents import about, content
from ..declared.parameters import ShapeError, require
from .sampled import Sampled

LARGEST_FILE = 50_000_000  # bytes


def from_csv(text_or_path, columns=None, closed=None, scale=1.0, radius=None):
    """Make a smooth trajectory through the points of a table.

    Parameters
    ----------
    text_or_path : str or Path
        Lines of numbers, or the path of a file of at most 50 MB. Commas, semicolons, tabs or spaces part
        them; between semicolons a comma is a decimal point. A first line of names and lines that begin with # are not
        points.
    columns : sequence of str or int, optional
        The two or three columns that are x, y and z, by their names in the first line or counted from 1. Without it
        those called x, y and z, or else the first ones that are no radius. Where there are two, z is 0.
    closed : bool, optional
        Whether the last point leads back to the first; without it, where they are the same.
    scale : float
        Of the points, to metres: 0.001 of a table in millimetres.
    radius : str or int, optional
        The column of the ``radii``, by which the contour is scaled at each point; without it that called radius, if
        there is one. Of a contour of radius 1 they are metres, and of one of 0.001 millimetres.

    Returns
    -------
    Sampled
        Points that repeat the one before them count once.

    Raises
    ------
    ShapeError
        For text among the numbers, with its line; for what is no number; for fewer than two points.

    Examples
    --------
    >>> from_csv("x,y,z\\n0,0,0\\n0,0,3\\n").length()
    3.0
    >>> from_csv("x,y,z,radius\\n0,0,0,2\\n0,0,3,1.5\\n").radii.values.tolist()
    [2.0, 1.5]
    """
    scale = argument("scale", scale, above=0.0)
    data, subject = content(text_or_path, "CSV", "\n", LARGEST_FILE)
    with about(subject):
        try:
            lines = data.decode("utf-8-sig").splitlines()
        except UnicodeDecodeError as error:
            raise ShapeError(f"must be UTF-8, got the byte 0x{data[error.start]:02x}") from error
        rows = [(n, cells) for n, cells in enumerate(rows_of(lines), 1) if any(cells) and not cells[0].startswith("#")]
        require(rows, "must have lines of numbers", "none")
        names = rows.pop(0)[1] if all(number(cell) is None for cell in rows[0][1]) else []
        require(rows, "must have lines of numbers after the first", "none")
        names, width = [name.lower() for name in names], len(rows[0][1])
        if radius is None:
            radius = "radius" if "radius" in names else None
        scaling = [] if radius is None else [numbered(radius, names, width, "radius")]
        chosen = chosen_columns(columns, names, width, scaling)
        table = np.array([point(line, cells, chosen + scaling) for line, cells in rows])
        points = np.pad(scale * table[:, : len(chosen)], ((0, 0), (0, 3 - len(chosen))))
        return through(points, closed, table[:, len(chosen) :].ravel())


def through(points, closed, radii=()):
    """A trajectory through points that is closed where it comes back, unless that is known."""
    if closed is None:
        closed = len(points) > 3 and bool((points[0] == points[-1]).all())
    try:
        return Sampled(points, closed, radii)
    except ShapeError as refusal:
        raise ShapeError(refusal.sentence, "" if refusal.key == "points" else refusal.key) from None


def rows_of(lines):
    """The cells of each line."""
    first = next((line for line in lines if line.strip() and not line.lstrip().startswith("#")), "")
    parting = next((mark for mark in "\t;," if mark in first), None)
    if parting is None:
        return [line.split() for line in lines]
    rows = [[cell.strip(' \t"') for cell in line.split(parting)] if line.strip() else [] for line in lines]
    return [[cell.replace(",", ".") for cell in cells] for cells in rows] if parting == ";" else rows


def chosen_columns(columns, names, width, others):
    """The numbers of the columns that are x, y and z, from 0; by themselves none of the others is."""
    if columns is None:
        if {"x", "y"} <= set(names):
            columns = [name for name in ("x", "y", "z") if name in names]
        else:
            columns = [1 + place for place in range(width) if place not in others][:3]
            require(len(columns) >= 2, "must have two or three columns of numbers", len(columns))
    listed = isinstance(columns, Iterable) and not isinstance(columns, str) and getattr(columns, "ndim", 1)
    given = list(columns) if listed else []
    require(len(given) in (2, 3), "must be the two or three columns that are x, y and z", columns, "columns")
    return [numbered(column, names, width, "columns") for column in given]


def numbered(column, names, width, key):
    """The number of a column from 0, by its name or its number from 1."""
    place = column
    if isinstance(column, str) and column.lower() in names:
        place = 1 + names.index(column.lower())
    counted = isinstance(place, (int, np.integer)) and not isinstance(place, bool)
    known = f"names of the first line, {', '.join(names)}, or " if names else ""
    require(counted and 1 <= place <= width, f"must be {known}numbers from 1 to {width}", column, key)
    return int(place) - 1


def point(line, cells, chosen):
    """The numbers of one line, or a refusal that says which it is."""
    require(len(cells) > max(chosen), f"must have {max(chosen) + 1} numbers in line {line}", len(cells))
    for column in chosen:
        if number(cells[column]) is None:
            raise ShapeError(f"must have numbers only, got {cells[column][:40]!r} in line {line}")
    return [number(cells[column]) for column in chosen]


def number(cell):
    """The finite number that is written in a cell, or None."""
    try:
        value = float(cell) if "_" not in cell else nan  # Python's own digit groups are no table's
    except ValueError:
        return None
    return value if isfinite(value) else None
