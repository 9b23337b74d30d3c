# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Running sums of steps as small as a byte, eight at a time.

A product with 0x0101010101010101 leaves in each byte of a word the sum of the bytes up to it, as long as none of them
passes 255. So one multiplication adds eight steps, and what adds up one by one is an eighth of them.
"""

import numpy as np

GROUP = 8  # bytes in a word of the processor
EACH = np.uint64(0x0101010101010101)
WORD = np.dtype("<u8")  # whose lowest byte comes first on every machine


WITHOUT = np.array([0, 0x0001020304050607], dtype=WORD)  # what leaves of steps and one each GROUP more than the steps


class Running:
    """The running sums of steps.

    Parameters
    ----------
    steps : (n,) int8 or bool array
        From -1 to 1.
    before : int
        What they add to.

    Attributes
    ----------
    bytes : (n,) uint8 array
        The sum at each step, with it; of which whole multiples of 256 are left out.

    Examples
    --------
    >>> sums = Running(np.array([1, 1, -1, 0, 0, 1, 1, 1, 1, -1, -1], dtype=np.int8), before=254)
    >>> sums.bytes.tolist()
    [255, 0, 255, 255, 255, 0, 1, 2, 3, 2, 1]
    >>> sums.at(np.array([0, 1, 10])).tolist(), sums.total
    ([255, 256, 257], 257)
    """

    def __init__(self, steps, before=0):
        bias, count = int(steps.dtype != np.bool_), len(steps)
        padded = np.empty(count // GROUP * GROUP + GROUP, dtype=np.uint8)  # with room for a last one
        padded[count:] = bias  # where nothing is added
        np.add(steps.view(np.uint8), np.uint8(bias), out=padded[:count])
        within = padded.view(WORD)
        within *= EACH
        within += WITHOUT[bias]
        self.before = np.empty(len(within) + 1, dtype=np.int32)  # each group
        self.before[0] = before
        np.subtract(padded[GROUP - 1 :: GROUP], GROUP * bias, out=self.before[1:], dtype=np.int32)
        np.cumsum(self.before, dtype=np.int32, out=self.before)
        lifted = (self.before[:-1] - GROUP * bias).astype(np.uint8).astype(WORD)
        lifted *= EACH
        padded += lifted.view(np.uint8)
        self.bytes = padded[:count]

    @property
    def total(self):
        return int(self.before[-1])

    def at(self, places):
        """(m,) int32 array: the whole sums at steps."""
        found = self.before.take(places >> 3)
        found += (self.bytes.take(places) - found.astype(np.uint8)).view(np.int8)  # at most eight more or less
        return found
