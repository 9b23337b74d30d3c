# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products of rotations along the branches of a tree.

Quaternions of n tokens are one (2, n) complex array: z and w of `turns`, so that few calls multiply them.
"""

import numpy as np

from ..deriving.neighbours import narrow

LONG = 32  # rotations in a row that are multiplied one by one
BLOCK, RUNS = 1 << 12, 1 << 14  # tokens that a processor keeps with all that is on the way to their products
FEW = 300  # tokens in a wave below which blocks of waves are quicker
LEAST = np.finfo(float).tiny  # of the sine between a heading and a tropism, so that it divides
UPRIGHT = 1e-12  # of the sine between heading and up, below which nothing is level


def multiplied(first, second):
    """The quaternions that turn by the second in the axes of the first."""
    (z1, w1), (z2, w2) = first, second
    found = np.empty(second.shape, dtype=complex)
    np.subtract(z1 * z2, w1 * w2.conj(), out=found[0])
    np.add(z1 * w2, w1 * z2.conj(), out=found[1])
    return found


def products_of_runs(spins, run, count):
    """The products of the rotations of each run; none where a run is empty.

    Parameters
    ----------
    spins : (2, n) complex array
    run : (n,) int array
        The run of each, not falling.
    count : int
        How many runs there are.
    """
    whole = np.zeros((2, count), dtype=complex)
    whole[0] = 1
    edges = np.searchsorted(run, np.arange(0, count + RUNS, RUNS)).tolist()
    for part in map(slice, edges, edges[1:]):
        multiply(spins[:, part].copy(), run[part], whole)
    return whole


def multiply(spins, run, whole):
    """Write the products of the rotations of some runs."""
    while True:
        starts = np.flatnonzero(np.diff(run, prepend=-1))
        lengths = np.diff(np.append(starts, len(run)))
        if lengths.max(initial=0) <= LONG:
            break
        place = np.arange(len(run)) - np.repeat(starts, lengths)
        second = np.flatnonzero(place % 2)  # pair by pair, so that long runs take few rounds
        put(spins, second - 1, multiplied(taken(spins, second - 1), taken(spins, second)))
        stays = np.flatnonzero(place % 2 == 0)
        spins, run = taken(spins, stays), run.take(stays)
    of = run.take(starts)
    put(whole, of, taken(spins, starts))
    for number in range(1, int(lengths.max(initial=0))):
        longer = np.flatnonzero(lengths > number)
        starts, lengths, of = starts.take(longer), lengths.take(longer), of.take(longer)
        put(whole, of, multiplied(taken(whole, of), taken(spins, starts + number)))


class Tropism:
    """What segments bend towards.

    Orientations are multiplied in axes of which the first is its direction: there a heading turns towards it by a
    factor of z and one of w, as these are the cosine and the sine of half the angle between them, each times a number
    of size 1.

    Parameters
    ----------
    direction : (3,) float array
        Of length 1.
    ease : float
        By what times the sine between heading and direction a segment turns, in radians.
    """

    def __init__(self, direction, ease):
        x, across, self.ease = float(direction[0]), complex(*direction[1:].tolist()), ease
        longer = np.sqrt((1 + abs(x)) / 2)
        shorter = 1j * across / (2 * longer)
        self.axes = np.array((longer, shorter) if x >= 0 else (shorter, longer), dtype=complex)[:, None]
        self.back = np.stack((self.axes[0].conj(), -self.axes[1]))  # from these axes to those outside

    def bent(self, pair):
        """Turn headings towards it."""
        size = np.abs(pair)
        sine = 2 * size[0] * size[1]
        half = self.ease / 2 * sine
        by = 2 * np.sin(half) / np.maximum(sine, LEAST)
        size *= size
        factor = by * size[::-1]
        np.negative(factor[1], out=factor[1])
        factor += np.cos(half)
        return pair * factor


def level(pair, tropism=None):
    """Roll about the heading until the left is level; of orientations in the axes of a tropism, if there is one."""
    z, w = pair if tropism is None else multiplied(tropism.axes, pair)
    side = z.conj() ** 2 - w**2
    half = root(side.real, side.imag)
    return np.stack((pair[0] * half, pair[1] * half.conj()))


def root(x, y):
    """(n,) complex array: the square root of the direction of x + iy, 1 of none."""
    size = np.sqrt(x * x + y * y)
    none = size < UPRIGHT
    if none.any():
        x, y, size = np.where(none, 1, x), np.where(none, 0, y), np.where(none, 1, size)
    longer = np.sqrt(0.5 + 0.5 / size * np.abs(x))
    shorter = 0.5 / size * y / longer
    found = np.empty(len(size), dtype=complex)
    found.real = np.where(x < 0, np.abs(shorter), longer)
    found.imag = np.where(x < 0, np.copysign(longer, y), shorter)
    return found


def along_paths(rotations, which, parent, depth, start, levels=None, bends=None, tropism=None):
    """The orientation at tokens, of the rotations on their way from the root.

    Parameters
    ----------
    rotations : (2, k) complex array
    which : (n,) int array or None
        Which of these is the rotation of each token, in the axes that the token before it leaves; None if each has its
        own.
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
        return rotations[:, :0], None
    start = np.array(start)[:, None]
    waves = int(depth.max()) + 1
    if levels is None and bends is None and len(parent) < FEW * waves:
        relative = rotations if which is None else taken(rotations, which)
        if waves == len(parent):
            return chain(relative, start), None
        return by_blocks(relative, parent, depth, start, int(np.ceil(np.sqrt(waves)))), None
    order, stops = np.argsort(narrow(depth), kind="stable"), np.cumsum(np.bincount(depth)).tolist()
    rank = np.empty(len(parent) + 1, dtype=np.intp)
    rank[order], rank[-1] = np.arange(len(parent)), len(parent)
    which = order if which is None else which.take(order)
    above = rank.take(parent.take(order))  # so that each wave stands in a row
    levels, bends = (None if which is None else which.take(order) for which in (levels, bends))
    left = np.empty((2, len(parent) + 1), dtype=complex)
    found = left if bends is None else np.empty((2, len(parent)), dtype=complex)
    left[:, -1:] = start if tropism is None else multiplied(tropism.back, start)
    for part in pieces(stops):
        turned = multiplied(taken(left, above[part]), taken(rotations, which[part]))
        if levels is not None:
            turned = changed(turned, levels[part], lambda pair: level(pair, tropism))
        found[:, part] = turned
        if bends is not None:
            left[:, part] = changed(turned, bends[part], tropism.bent)
    return (found if tropism is None else multiplied(tropism.axes, found)), rank


def pieces(stops):
    """Slices up to each stop, short enough to be kept by a processor."""
    for start, stop in zip([0, *stops], stops, strict=False):
        for begin in range(start, stop, BLOCK):
            yield slice(begin, min(begin + BLOCK, stop))


def changed(pair, which, change):
    """Orientations of which a function changes some."""
    which = which.nonzero()[0]
    if len(which) == pair.shape[1]:
        return change(pair)
    if not len(which):
        return pair
    found = pair.copy()
    put(found, which, change(taken(pair, which)))
    return found


def chain(relative, start):
    """The same for one path: products within rows of tokens, in all rows at once, and then of rows."""
    count = relative.shape[1]
    size = int(np.ceil(np.sqrt(count)))
    rows = -(-count // size)
    within = np.zeros((2, rows * size), dtype=complex)
    within[0], within[:, :count] = 1, relative
    within = np.ascontiguousarray(within.reshape(2, rows, size).transpose(2, 0, 1))
    for number in range(1, size):
        within[number] = multiplied(within[number - 1], within[number])
    before = np.empty((2, rows), dtype=complex)
    for row in range(rows):
        before[:, row : row + 1] = start
        start = multiplied(start, within[-1, :, row : row + 1])
    for number in range(size):
        within[number] = multiplied(before, within[number])
    return within.transpose(1, 2, 0).reshape(2, -1)[:, :count]


def by_blocks(relative, parent, depth, start, size):
    """The same for long paths: products within blocks of so many tokens in all blocks at once, and then of blocks."""
    block, place = np.divmod(depth, size)
    count = len(parent)
    within = relative.copy()
    anchor = parent.copy()  # the token before the first one of the same block
    order = np.argsort(narrow(place), kind="stable")
    waves = np.split(order, np.cumsum(np.bincount(place))[:-1])
    for wave in waves[1:]:
        before = parent[wave]
        put(within, wave, multiplied(taken(within, before), taken(relative, wave)))
        anchor[wave] = anchor[before]
    whole = np.empty((2, count + 1), dtype=complex)
    whole[:, -1:] = start
    last = np.flatnonzero(place == size - 1)
    order = last[np.argsort(narrow(block[last]), kind="stable")]
    for wave in np.split(order, np.cumsum(np.bincount(block[last]))[:-1]) if len(last) else ():
        put(whole, wave, multiplied(taken(whole, anchor[wave]), taken(within, wave)))
    return multiplied(taken(whole, anchor), within)


def taken(pair, places):
    return pair.take(places, axis=1)


def put(pair, places, values):
    pair[0][places], pair[1][places] = values
