# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sums of what items of a word add on the way from its root to each.

Where a branch ends the sum of its own stretches is taken off again; those within it have done so before.
"""

from functools import cached_property

import numpy as np


class Sums:
    """Sums at items of a word.

    Parameters
    ----------
    branches : Branches
    first : (b + 2,) int array
        Which of the items is the first of each stretch, and how many there are.

    Attributes
    ----------
    stretch : (n,) int array
        The stretch of each item.
    """

    def __init__(self, branches, first):
        self.branches, self.first = branches, first

    @cached_property
    def stretch(self):
        filled = np.flatnonzero(self.first[1:] > self.first[:-1])
        steps = np.zeros(self.first[-1], dtype=np.intp)
        steps[self.first[filled]] = np.diff(filled, prepend=0)
        return np.cumsum(steps, out=steps)

    @cached_property
    def branch(self):
        """(n,) int array: the branch of each item."""
        return self.branches.branch.take(self.stretch)

    @cached_property
    def behind(self):
        """The first item behind each branch but the stem."""
        return self.first[self.branches.closing[1:] + 1]

    @cached_property
    def ended(self):
        """Items before which a branch has ended, each once."""
        ended = np.zeros(self.first[-1] + 1, dtype=bool)
        ended[self.behind] = True
        return np.flatnonzero(ended[:-1])

    def of(self, values):
        """The sums with each item, and what those before an item have more than the way to it.

        Parameters
        ----------
        values : (n,) array

        Returns
        -------
        (n,) array
        (n,) array or int
        """
        if not len(self.branches.brackets):
            return np.cumsum(values, dtype=values.dtype), 0
        own = np.zeros(len(self.branches.starts), dtype=values.dtype)
        np.add.at(own, self.branch, values)
        back = np.zeros(len(values) + 1, dtype=values.dtype)
        np.add.at(back, self.behind, own[1:])
        back = back[:-1]
        after = values - back
        return np.cumsum(after, out=after), back
