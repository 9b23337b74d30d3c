# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sums of what items of a word add on the way from its root to each.

Where a branch ends the sum of its own stretches is taken off again; those within it have done so before.
"""

from functools import cached_property

import numpy as np


class Sums:
    """Sums at items of a word.

    What is kept for several sums is large, so a figure does not keep it: memory that is given back comes back slowly.

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
    def branches_of(self):
        """(b + 1,) int array: the branch of each stretch."""
        return self.branches.numbered()

    @cached_property
    def branch(self):
        """(n,) int array: the branch of each item."""
        found = self.branches_of.take(self.stretch)
        del self.branches_of, self.stretch  # of which there is no more use
        return found

    @cached_property
    def behind(self):
        """The first item behind each branch but the stem."""
        return self.first.take(self.branches.closing[1:] + 1)

    def of(self, values, out=None):
        """The sums before each item, and with it.

        Parameters
        ----------
        values : (n,) array
            Which the sums overwrite.
        out : two (n,) arrays, optional
            Where they are written instead.

        Returns
        -------
        two (n,) arrays
        """
        before, after = (np.empty_like(values), values) if out is None else out
        if not len(self.branches.brackets):
            np.cumsum(values, out=after)
            before[1:] = after[:-1]
        else:
            own = np.zeros(len(self.branches.starts), dtype=values.dtype)
            np.add.at(own, self.branch, values)
            back = np.zeros(len(values) + 1, dtype=values.dtype)  # what the sum before an item has more than its way
            np.add.at(back, self.behind, own[1:])
            values -= back[:-1]
            np.cumsum(values, out=after)
            np.subtract(after[:-1], back[1:-1], out=before[1:])
        before[:1] = 0
        return before, after
