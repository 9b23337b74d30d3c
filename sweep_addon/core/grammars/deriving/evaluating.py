# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas of many modules, block by block: what is on the way to their values stays in a processor's cache."""

import numpy as np

from ...formulas.expressions import Expression

BLOCK = 1 << 14  # modules


def values(expression, find, size, asking=False):
    """The value of a formula for so many modules: an array, or a number where it is the same for all.

    Derivations tell NumPy once a step that no number is an error; there are thousands of formulas.

    Parameters
    ----------
    expression : Expression or Called
        A function of Python takes all modules at once.
    find : callable
        The value of a name for a slice of the modules.
    size : int
    asking : bool
        Whether answers stay bools.
    """

    names, whole = expression.names, slice(None)
    if not isinstance(expression, Expression):
        return expression.run({name: find(name, whole) for name in names})
    run = expression.answered if asking else expression.calculated
    if size <= BLOCK:
        return run({name: find(name, whole) for name in names})

    def part(start):
        return run({name: find(name, slice(start, start + BLOCK)) for name in names})

    first = part(0)
    if not np.ndim(first):
        return first
    found = np.empty(size, dtype=first.dtype)
    found[:BLOCK] = first
    for start in range(BLOCK, size, BLOCK):
        found[start : start + BLOCK] = part(start)
    return found
