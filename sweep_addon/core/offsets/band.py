# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The narrow band: the cells of a lattice through which the zero of a function passes, found from coarse to fine."""

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import ShapeError

COARSEST = 8  # cells along the longest side that the search begins with, or up to twice as many
MOST_CORNERS = 30_000_000
TO_SPARE = 1.25  # of a block within its offset a tenth more was found than a coarse level tells
LIKE_A_SURFACE = 3  # times as many cells at each level: what grows less is still like a line, or a point
HALF_DIAGONAL = np.sqrt(3) / 2 * (1 + 1e-9)
CORNERS = np.array([(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)])  # of a cell; corner x + 2 y + 4 z
LATTICE = np.array([(x, y, z) for z in (0, 1, 2) for y in (0, 1, 2) for x in (0, 1, 2)])  # of eight cells
WITHIN = (CORNERS[:, None] + CORNERS) @ (1, 3, 9)  # the corners of each of eight cells among those of all


class TooFineError(ShapeError):
    """The band would have too many corners.

    Attributes
    ----------
    step : float
        With which it would not, with some to spare, as corners of finer levels are an estimate; in metres.
    """

    def __init__(self, corners, step):
        super().__init__(f"must leave at most 30 million places to look at, got {corners}")
        self.step = step * np.sqrt(TO_SPARE * corners / MOST_CORNERS)


@individual
class Band:
    """Cells through which a zero passes.

    Parameters
    ----------
    low : (3,) float array
        The corner of the lattice with the lowest coordinates, in metres.
    step : float
        The side of a cell, in metres.
    cells : (n, 3) int array
        Their places on the lattice.
    inside : (n,) int array
        Which of their corners are inside: bit i for corner i, at x + 2 y + 4 z.
    hints : (n, k) float array
        Hints of the field for points in each cell.
    """

    low: np.ndarray
    step: float
    cells: np.ndarray
    inside: np.ndarray
    hints: np.ndarray


def narrow_band(field, low, high, step):
    """The cells of a lattice through which the zero of a field passes.

    Parameters
    ----------
    field : object
        As `any_field` says.
    low, high : (3,) array-likes
        A box that holds the zero, in metres.
    step : float
        The side of a cell, in metres.

    Returns
    -------
    Band

    Raises
    ------
    TooFineError
        Where the band would have more than 30 million corners: four times as many at each finer level.

    No cell is missed that has corners on both sides. What lies between the corners of the lattice is not seen: a part
    of the inside or outside within which no ball of 0.87 of the step fits may be absent.

    Examples
    --------
    >>> from .implicit import Implicit
    >>> ball = Implicit(lambda points: np.linalg.norm(points, axis=1) - 1)
    >>> len(narrow_band(ball, (-1.1, -1.1, -1.1), (1.1, 1.1, 1.1), 0.2).cells)
    416
    """
    low, high = np.asarray(low, float) - 1.5 * step, np.asarray(high, float) + 1.5 * step
    across = np.ceil((high - low) / step)
    depth = max(int(np.ceil(np.log2(across.max() / COARSEST))) - 1, 1)
    shape = np.ceil(across / 2**depth).astype(int)
    cells = np.stack(np.meshgrid(*map(np.arange, shape), indexing="ij"), axis=-1).reshape(-1, 3)
    hints, before = None, np.inf
    for level in range(depth, 0, -1):
        size = step * 2**level
        reach = HALF_DIAGONAL * size
        values, hints = field.evaluate(low + (cells + 0.5) * size, hints, reach)
        kept = np.abs(values) <= reach
        cells, values, hints = cells[kept], values[kept], hints[kept]
        corners = 27 * len(cells) * (4 ** (level - 1) if len(cells) > LIKE_A_SURFACE * before else 1)
        if corners > MOST_CORNERS:
            raise TooFineError(corners, step)
        before = len(cells)
        if level > 1:
            cells = (2 * cells[:, None] + CORNERS).reshape(-1, 3)
            hints = np.repeat(hints, 8, axis=0)
    return crossed(field, low, step, 2 * cells, values, hints, 2 * shape * 2 ** (depth - 1) + 1)


def crossed(field, low, step, blocks, values, hints, shape):
    """The band within blocks of eight cells (n, 3), of whose centres values and hints are known."""
    corners = (blocks[:, None] + LATTICE).reshape(-1, 3)
    keys = (corners[:, 0] * shape[1] + corners[:, 1]) * shape[2] + corners[:, 2]
    _, first, which = np.unique(keys, return_index=True, return_inverse=True)
    which = which.reshape(-1, 27)
    distances = step * np.linalg.norm(LATTICE - 1, axis=1)
    told = np.abs(values)[:, None] > distances * (1 + 1e-9)
    inside, known = (np.zeros(len(first), dtype=bool) for _ in range(2))
    known[which[told]] = True
    inside[which[told & (values < 0)[:, None]]] = True
    asked = np.flatnonzero(~known)
    block = first[asked] // 27
    inside[asked] = field.inside(low + step * corners[first[asked]], hints[block])
    bits = inside[which[:, WITHIN]] @ (1 << np.arange(8))
    block, cell = np.nonzero((bits > 0) & (bits < 255))
    return Band(low, step, blocks[block] + CORNERS[cell], bits[block, cell], hints[block])
