# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotations as quaternions of two complex numbers, and their products along the branches of a tree.

A quaternion a + bi + cj + dk is z + wj with z = a + bi and w = c + di. It turns the axes x, y, z to the turtle's
heading, its left and its up.
"""

import numpy as np

from ..deriving.neighbours import narrow

LONG = 32  # rotations in a row that are multiplied one by one
BLOCK, RUNS = 1 << 12, 1 << 14  # tokens
FEW = 300  # tokens in a wave below which blocks of waves are quicker
LEAST = np.finfo(float).tiny  # of the sine between a heading and a tropism, so that it divides
UPRIGHT = 1e-12  # of the sine between heading and up, below which nothing is level


def unit(degrees):
    """(n,) complex array: cosine and sine of angles in degrees, exact for quarters of a turn."""
    degrees = np.asarray(degrees, dtype=np.float64)
    quarter = np.rint(degrees / 90)
    angle = np.radians(degrees - 90 * quarter)
    found = np.empty(angle.shape, dtype=complex)
    found.real, found.imag = np.cos(angle), np.sin(angle)
    return found * QUARTERS[np.mod(quarter, 4).astype(np.intp)]


QUARTERS = np.array([1, 1j, -1, -1j])


def rotation(axis, degrees):
    """The quaternions that turn about an axis: 0 is the heading, 1 the left, 2 up."""
    half = unit(np.asarray(degrees, dtype=np.float64) / 2)
    if axis == 0:
        return half, np.zeros_like(half)
    return half.real + 0j, half.imag * (1 + 0j if axis == 1 else 1j)


def product(first, second):
    """The quaternions that turn by the second in the axes of the first."""
    (z1, w1), (z2, w2) = first, second
    return z1 * z2 - w1 * np.conj(w2), z1 * w2 + w1 * np.conj(z2)


def heading(z, w):
    """The first axis: its x, and y + iz."""
    return z.real**2 + z.imag**2 - w.real**2 - w.imag**2, -2j * z * w


def axes(z, w):
    """(n, 3, 3) float array: heading, left and up as rows."""
    a, b, c, d = z.real, z.imag, w.real, w.imag
    rows = [
        [a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)],
        [2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)],
        [2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d],
    ]
    return np.array(rows).transpose(2, 0, 1)


def products_of_runs(z, w, run, count):
    """The products of the rotations of each run; none where a run is empty.

    Parameters
    ----------
    z, w : (n,) complex array
    run : (n,) int array
        The run of each, not falling.
    count : int
        How many runs there are.
    """
    whole = np.ones(count, dtype=complex), np.zeros(count, dtype=complex)
    edges = np.searchsorted(run, np.arange(0, count + RUNS, RUNS)).tolist()
    for part in map(slice, edges, edges[1:]):
        multiply(z[part], w[part], run[part], whole)
    return whole


def multiply(z, w, run, whole):
    """Write the products of the rotations of some runs."""
    while True:
        starts = np.flatnonzero(np.diff(run, prepend=-1))
        lengths = np.diff(np.append(starts, len(run)))
        if lengths.max(initial=0) <= LONG:
            break
        place = np.arange(len(run)) - np.repeat(starts, lengths)
        second = np.flatnonzero(place % 2)  # pair by pair, so that long runs take few rounds
        z[second - 1], w[second - 1] = product(taken((z, w), second - 1), taken((z, w), second))
        z, w, run = z[place % 2 == 0], w[place % 2 == 0], run[place % 2 == 0]
    of = run.take(starts)
    whole[0][of], whole[1][of] = taken((z, w), starts)
    for number in range(1, int(lengths.max(initial=0))):
        longer = np.flatnonzero(lengths > number)
        starts, lengths, of = starts.take(longer), lengths.take(longer), of.take(longer)
        whole[0][of], whole[1][of] = product(taken(whole, of), taken((z, w), starts + number))


def level(z, w):
    """Roll about the heading until the left is level."""
    side = np.conj(z) ** 2 - w**2
    half = root(side.real, side.imag)
    return z * half, w * np.conj(half)


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


def bent(z, w, towards, ease):
    """Turn the heading towards a direction, its x and y + iz, by the sine between them times the ease, in radians."""
    x, yz = heading(z, w)
    tx, tyz = towards
    axis_x = (yz * -tyz.conjugate()).imag
    axis_yz = -1j * tx * yz - x * (-1j * tyz)
    size = np.sqrt(axis_x**2 + axis_yz.real**2 + axis_yz.imag**2)
    half = ease / 2 * size
    sine = np.sin(half) / np.maximum(size, LEAST)
    turn = np.cos(half) + 1j * sine * axis_x, sine * axis_yz
    return product(turn, (z, w))


def along_paths(relative, parent, depth, start, asked, levels=None, bends=None, bend=None):
    """The orientation at tokens, of the rotations on their way from the root.

    Parameters
    ----------
    relative : pair of (n,) complex array
        The rotation of each token in the axes that the token before it leaves.
    parent : (n,) int array
        The token before, or -1.
    depth : (n,) int array
        How many tokens are before it on its way.
    start : pair of complex
        The orientation at the root.
    asked : (m,) int array
        Of which tokens it is asked for.
    levels, bends : (n,) bool array, optional
        Which of them roll level behind their rotation, and which leave another orientation than they have, bent.
    bend : tuple, optional
        By what, as `bent` takes it.

    Returns
    -------
    pair of (m,) complex array
    """
    if not len(parent):
        return relative
    waves = int(depth.max()) + 1
    if levels is None and bends is None and waves == len(parent):
        return taken(chain(relative, start), asked)
    if levels is None and bends is None and len(parent) < FEW * waves:
        return taken(by_blocks(relative, parent, depth, start, int(np.ceil(np.sqrt(waves)))), asked)
    order, stops = np.argsort(narrow(depth), kind="stable"), np.cumsum(np.bincount(depth)).tolist()
    rank = np.empty(len(parent) + 1, dtype=np.intp)
    rank[order], rank[-1] = np.arange(len(parent)), len(parent)
    above = rank.take(parent.take(order))  # so that each wave stands in a row
    levels, bends = (None if which is None else which.take(order) for which in (levels, bends))
    left = empty(len(parent) + 1)
    found = left if bends is None else empty(len(parent))
    left[0][-1], left[1][-1] = start
    for part in pieces(stops):
        turned = product(taken(left, above[part]), taken(relative, order[part]))
        if levels is not None:
            turned = changed(level, levels[part], turned)
        found[0][part], found[1][part] = turned
        if bends is not None:
            left[0][part], left[1][part] = changed(lambda z, w: bent(z, w, *bend), bends[part], turned)
    return taken(found, rank.take(asked))


def pieces(stops):
    """Slices up to each stop, of which a processor keeps all that is on the way to their products."""
    for start, stop in zip([0, *stops], stops, strict=False):
        for begin in range(start, stop, BLOCK):
            yield slice(begin, min(begin + BLOCK, stop))


def changed(change, which, pair):
    """A pair of which a function changes some."""
    which = which.nonzero()[0]
    if len(which) == len(pair[0]):
        return change(*pair)
    if not len(which):
        return pair
    found = pair[0].copy(), pair[1].copy()
    found[0][which], found[1][which] = change(*taken(pair, which))
    return found


def chain(relative, start):
    """The same for one path: products within rows of tokens, in all rows at once, and then of rows."""
    count = len(relative[0])
    size = int(np.ceil(np.sqrt(count)))
    rows = -(-count // size)
    z, w = np.ones(rows * size, dtype=complex), np.zeros(rows * size, dtype=complex)
    z[:count], w[:count] = relative
    z, w = (np.ascontiguousarray(part.reshape(rows, size).T) for part in (z, w))
    for number in range(1, size):
        z[number], w[number] = product((z[number - 1], w[number - 1]), (z[number], w[number]))
    before = empty(rows)
    for row, last in enumerate(zip(z[-1].tolist(), w[-1].tolist(), strict=True)):
        before[0][row], before[1][row] = start
        start = product(start, last)
    return tuple(part.T.ravel()[:count] for part in product(before, (z, w)))


def by_blocks(relative, parent, depth, start, size):
    """The same for long paths: products within blocks of so many tokens in all blocks at once, and then of blocks."""
    block, place = np.divmod(depth, size)
    count = len(parent)
    within = (relative[0].copy(), relative[1].copy())
    anchor = parent.copy()  # the token before the first one of the same block
    order = np.argsort(narrow(place), kind="stable")
    waves = np.split(order, np.cumsum(np.bincount(place))[:-1])
    for wave in waves[1:]:
        before = parent[wave]
        within[0][wave], within[1][wave] = product(taken(within, before), taken(relative, wave))
        anchor[wave] = anchor[before]
    whole = empty(count + 1)
    whole[0][-1], whole[1][-1] = start
    last = np.flatnonzero(place == size - 1)
    order = last[np.argsort(narrow(block[last]), kind="stable")]
    for wave in np.split(order, np.cumsum(np.bincount(block[last]))[:-1]) if len(last) else ():
        whole[0][wave], whole[1][wave] = product(taken(whole, anchor[wave]), taken(within, wave))
    return product(taken(whole, anchor), within)


def empty(count):
    return np.empty(count, dtype=complex), np.empty(count, dtype=complex)


def taken(pair, places):
    return pair[0].take(places), pair[1].take(places)
