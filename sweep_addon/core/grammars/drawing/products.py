# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Products of rotations.

Quaternions of n rotations are one (2, n) complex array: z and w of `turns`, so that few calls multiply them.
"""

import numpy as np

LONG = 32  # rotations in a row that are multiplied one by one
RUNS = 1 << 14  # that a processor keeps with all that is on the way to their products


def multiplied(first, second):
    """The quaternions that turn by the second in the axes of the first."""
    (z1, w1), (z2, w2) = first, second
    found = np.empty(second.shape, dtype=complex)
    np.subtract(z1 * z2, w1 * w2.conj(), out=found[0])
    np.add(z1 * w2, w1 * z2.conj(), out=found[1])
    return found


class Rotations:
    """What tokens turn by.

    Parameters
    ----------
    pair : (2, r) complex array
        Rotations.
    which : (n,) int array, optional
        Which of them each token has; each has its own if this is not said.
    factors : (2, 2, r) complex array, optional
        Of rotations that many tokens have, the `columns`, made once.
    """

    def __init__(self, pair, which=None, factors=None):
        self.pair, self.which, self.factors = pair, which, factors

    def sorted(self, order):
        """Rotations: those of the tokens in another order."""
        return Rotations(self.pair, order if self.which is None else self.which.take(order), self.factors)

    def of(self, part):
        """(2, k) complex array: the rotations of some tokens."""
        return self.pair[:, part] if self.which is None else taken(self.pair, self.which[part])

    def behind(self, before, part):
        """The quaternions that turn by the rotations of some tokens in the axes of others."""
        if self.factors is None:
            return multiplied(before, self.of(part))
        factors = self.factors.take(self.which[part], axis=2)
        found = before[0] * factors[0]
        found += before[1] * factors[1]
        return found


def columns(pair):
    """(2, 2, n) complex array: by what the z and the w of a first quaternion go into its product with each of these."""
    found = np.empty((2, *pair.shape), dtype=complex)
    found[0] = pair
    np.conjugate(pair[::-1], out=found[1])
    np.negative(found[1, 0], out=found[1, 0])
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


def taken(pair, places):
    return pair.take(places, axis=1)


def put(pair, places, values):
    pair[0][places], pair[1][places] = values
