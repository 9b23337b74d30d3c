# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Orientations along the branches of a tree: products of all rotations on the way from its root."""

import numpy as np

from ..deriving.neighbours import narrow
from .products import multiplied, taken
from .tropism import changed, level

BLOCK = 1 << 12  # tokens that a processor keeps with all that is on the way to their products
FEW = 200  # tokens in a wave below which blocks of waves are quicker


def along_paths(rotations, parent, depth, start, levels=None, bends=None, tropism=None):
    """The orientation at tokens, of the rotations on their way from the root.

    Parameters
    ----------
    rotations : Rotations
        Of tokens, in the axes that the token before leaves.
    parent : (n,) int array
        The token before, or -1.
    depth : (n,) int array
        How many tokens are before it on its way.
    start : pair of complex
        The orientation at the root.
    levels, bends : (n,) bool array, optional
        Which of them roll level behind their rotation, and which bend what they leave.
    tropism : Tropism, optional
        Towards what.

    Returns
    -------
    (2, n) complex array
        Orientations, of which there may be others too.
    (n,) int array or None
        Which of them each token has, if not its own.
    """
    if not len(parent):
        return np.empty((2, 0), dtype=complex), None
    start = np.array(start)[:, None]
    waves = int(depth.max()) + 1
    if levels is None and bends is None and waves == len(parent):
        return chain(rotations, waves, start), None
    if levels is None and bends is None and len(parent) < FEW * waves:
        return by_blocks(rotations, parent, depth, start, int(np.ceil(np.sqrt(waves))))
    order, rank, above = in_rows(depth, parent)
    rotations, stops = rotations.sorted(order), np.cumsum(np.bincount(depth)).tolist()
    levels, bends = (None if which is None else which.take(order) for which in (levels, bends))
    left = np.empty((2, len(parent) + 1), dtype=complex)
    found = left if bends is None else np.empty((2, len(parent)), dtype=complex)
    left[:, -1:] = start if tropism is None else multiplied(tropism.back, start)
    for part in pieces([0, *stops]):
        turned = rotations.behind(taken(left, above[part]), part)
        if levels is not None:
            turned = changed(turned, levels[part], lambda pair: level(pair, tropism))
        found[:, part] = turned
        if bends is not None:
            left[:, part] = changed(turned, bends[part], tropism.bent)
    return (found if tropism is None else multiplied(tropism.axes, found)), rank


def in_rows(key, parent):
    """The tokens sorted by a key, so that each wave of them stands in a row.

    Returns
    -------
    order : (n,) int array
        The tokens.
    rank : (n + 1,) int array
        Where each of them stands, and n.
    above : (n,) int array
        Where the one before each of these stands; n where that is none.
    """
    order = np.argsort(narrow(key), kind="stable")
    rank = np.empty(len(order) + 1, dtype=np.intp)
    rank[order], rank[-1] = np.arange(len(order)), len(order)
    return order, rank, rank.take(parent.take(order))


def pieces(edges):
    """Slices from edge to edge, short enough to be kept by a processor."""
    for start, stop in zip(edges, edges[1:], strict=False):
        for begin in range(start, stop, BLOCK):
            yield slice(begin, min(begin + BLOCK, stop))


def by_blocks(rotations, parent, depth, start, size):
    """The same for long paths: products within blocks of so many tokens in all blocks at once, and then of blocks."""
    block = depth // size
    place, blocks, count = depth - block * size, int(block.max()) + 1, len(parent)
    order, rank, before = in_rows(place * blocks + block, parent)
    rotations, stops = rotations.sorted(order), np.cumsum(np.bincount(place)).tolist()
    found = np.empty((2, count), dtype=complex)
    for part in pieces([0, stops[0]]):
        found[:, part] = rotations.of(part)
    for part in pieces(stops):
        above = before[part]
        found[:, part] = rotations.behind(taken(found, above), part)
        before[part] = before.take(above)  # the last one of the block before
    last = stops[-2] if size > 1 else 0  # from here on stand the last ones of blocks, one block behind the other
    before -= last
    whole = np.empty((2, count - last + 1), dtype=complex)
    whole[:, -1:] = start
    edges = last + np.cumsum(np.bincount(block.take(order[last:]), minlength=blocks))
    for part in pieces([last, *edges.tolist()]):
        whole[:, part.start - last : part.stop - last] = multiplied(taken(whole, before[part]), found[:, part])
    for part in pieces([0, count]):
        found[:, part] = multiplied(taken(whole, before[part]), found[:, part])
    return found, rank


def chain(rotations, count, start):
    """The same for one path: products within rows of tokens, in all rows at once, and then of rows."""
    size = int(np.ceil(np.sqrt(count)))
    rows = -(-count // size)
    within = np.empty((size, 2, rows), dtype=complex)
    within[0] = rotations.of(slice(0, count, size))
    for number in range(1, size):
        part = slice(number, count, size)
        filled = len(range(*part.indices(count)))  # all rows, or all but the last
        within[number] = within[number - 1]
        within[number, :, :filled] = rotations.behind(within[number - 1, :, :filled], part)
    before, (z, w) = [], start[:, 0].tolist()
    for other_z, other_w in within[-1].T.tolist():
        before.append((z, w))
        z, w = z * other_z - w * other_w.conjugate(), z * other_w + w * other_z.conjugate()
    before = np.array(before).T.copy()
    for number in range(size):
        within[number] = multiplied(before, within[number])
    return within.transpose(1, 2, 0).reshape(2, -1)[:, :count]
