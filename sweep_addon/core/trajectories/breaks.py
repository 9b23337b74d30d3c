# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks: where a curve given by formulas has a corner, found by what integrals of its derivatives miss."""

import numpy as np

from ..declared.parameters import ShapeError
from ..vectors import dot, unit
from .arc_length import NODES, WEIGHTS, subdivided

CELLS, MOST_CELLS = 509, 1 << 13  # a prime number: no simple fraction of the domain is an end of a cell
HALVINGS = 34  # until a cell is a millionth of a millionth of the domain
MISSED = 1e-7  # radians, by which a smooth curve may turn unnoticed
TORN = 1e-9  # of the size: a jump, not a corner


def breaks(evaluate, derivative, domain):
    """The ends of the smallest cells in which a curve turns at once: (k, 2).

    In a cell where a curve is smooth, the rate at which its direction changes adds up to the change between the ends.
    Cells where it does not are halved, and again: where the curve only bends quickly none is left.

    Parameters
    ----------
    evaluate, derivative : callables
        From parameters (n,) to points, and from parameters and an order of 1 or 2 to derivatives, (n, 3).
    domain : (float, float)

    Raises
    ------
    ShapeError
        Where the curve jumps, and where it is smooth nowhere.
    """
    nodes = subdivided(np.array(domain), CELLS)
    start, end = nodes[:-1], nodes[1:]
    size = np.ptp(evaluate(nodes), axis=0).max()
    narrow = 8 * np.finfo(float).eps * np.abs(domain).max()
    for halvings in range(HALVINGS):
        turn, jump, scale = missed(evaluate, derivative, start, end)
        broken = (turn > MISSED) | (jump > TORN * np.maximum(size, scale)).any(axis=1)
        start, end, jump = start[broken], end[broken], jump[broken]
        if not broken.any() or halvings == HALVINGS - 1 or (end - start).max() < narrow:
            break
        if len(start) > MOST_CELLS:
            told = f"got more than {MOST_CELLS:,} pieces of u that wind or break"
            raise ShapeError(f"x, y and z must be smooth but for some corners, {told}")
        middle = (start + end) / 2
        start, end = np.append(start, middle), np.append(middle, end)
    if (jump > TORN * size).any():
        cell, axis = np.unravel_index(np.argmax(jump), jump.shape)
        raise ShapeError(
            f"must be in one piece, got a jump of {jump[cell, axis]:.6g} m near u = {start[cell]:.6g}", "xyz"[axis]
        )
    order = np.argsort(start)
    start, end = start[order], end[order]
    apart = start[1:] > end[:-1]  # cells side by side have the corner between them
    first, last = (np.append(True, apart), np.append(apart, True)) if len(start) else ([], [])
    return np.stack((start[first], end[last]), axis=1)


def missed(evaluate, derivative, start, end):
    """What quadrature over cells misses: of the turn in radians (k,), of the way in metres (k, 3); and their place."""
    half = (end - start) / 2
    inner = ((start + end) / 2 + half * NODES[:, None]).ravel()
    speed, bend = derivative(inner, 1), derivative(inner, 2)
    tangent, length = unit(speed), np.linalg.norm(speed, axis=1, keepdims=True)
    bend -= dot(bend, tangent)[:, None] * tangent
    rate = bend / np.where(length > 0, length, np.inf)
    turned, moved = (
        half[:, None] * np.einsum("m,mij->ij", WEIGHTS, part.reshape(len(NODES), -1, 3)) for part in (rate, speed)
    )
    ends, places = ([asked(end), asked(start)] for asked in (lambda u: unit(derivative(u, 1)), evaluate))
    turn = np.linalg.norm(ends[0] - ends[1] - turned, axis=1)
    return turn, np.abs(places[0] - places[1] - moved), np.abs(places).max(axis=0)
