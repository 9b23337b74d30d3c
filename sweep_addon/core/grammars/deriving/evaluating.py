# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas of many modules, block by block: what is on the way to their values stays in a processor's cache."""

import numpy as np

from ...formulas.expressions import DRAW, Expression

BLOCK = 1 << 14  # modules


class Named(dict):
    """The values of names, found when they are asked for. Random numbers are asked for once, and not kept."""

    def __init__(self, find, part):
        self.find, self.part = find, part

    def __missing__(self, name):
        found = self.find(name, self.part)
        if not name.startswith(DRAW):
            self[name] = found
        return found


def values(expression, find, size):
    """The value of a formula for so many modules: an array, or a number where it is the same for all.

    Derivations tell NumPy once a step that no number is an error; there are thousands of formulas.

    Parameters
    ----------
    expression : Expression or Called
        A function of Python takes all modules at once.
    find : callable
        The value of a name for a slice of the modules.
    size : int
    """
    whole = slice(None)
    if not isinstance(expression, Expression):
        return expression.run({name: find(name, whole) for name in expression.names})
    if size <= BLOCK:
        return expression.calculated(Named(find, whole))
    first = expression.calculated(Named(find, slice(0, BLOCK)))
    if not np.ndim(first):
        return first
    found = np.empty(size)
    found[:BLOCK] = first
    for start in range(BLOCK, size, BLOCK):
        part = slice(start, start + BLOCK)
        found[part] = expression.calculated(Named(find, part))
    return found
