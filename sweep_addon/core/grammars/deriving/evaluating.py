# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas of many modules, block by block: what is on the way to their values stays in a processor's cache."""

import numpy as np

from ...formulas.expressions import DRAW, Expression

BLOCK = 1 << 14  # modules


PREDECESSOR = None  # the path to it


class Path:
    """How a module of a context is found: from that of another path by a link, the so-manieth of its kind."""

    def __init__(self, origin, link, number):
        self.origin, self.link, self.number = origin, link, number


class Formula:
    """A formula of a production, and where the values of its names are.

    Parameters
    ----------
    expression : Expression or Called
        A function of Python takes all modules at once.
    sources : dict of str to (Path or None, int)
        Of which module of the context, and column, each parameter is.

    Attributes
    ----------
    sources : list of (Path or None, int) or str
        That of each name in order; random numbers and variables have their names.
    copies : (Path or None, int) or None
        The parameter that is the value as it stands.
    random : bool
        Whether it draws random numbers.
    """

    def __init__(self, expression, sources):
        self.expression = expression
        self.sources = [sources.get(name, name) for name in expression.names]
        self.called = not isinstance(expression, Expression)
        bare = expression.program == expression.names and isinstance(self.sources[0], tuple)
        self.copies = self.sources[0] if bare else None
        self.random = any(name.startswith(DRAW) for name in expression.names)

    def run(self, values, asking=False):
        """The value, of values in the order of the sources."""
        if self.called:
            return self.expression.run(dict(zip(self.expression.names, values, strict=True)))
        return self.expression.answered(values) if asking else self.expression.calculated(values)

    def of(self, find, size, asking=False):
        """The value for so many modules: an array, or a number where it is the same for all.

        Derivations tell NumPy once a step that no number is an error; there are thousands of formulas.

        Parameters
        ----------
        find : callable
            The value of a source for a slice of the modules.
        size : int
        asking : bool
            Whether answers stay bools.
        """

        def part(where):
            return self.run([find(source, where) for source in self.sources], asking)

        if size <= BLOCK or self.called or self.copies:
            return part(slice(None))
        first = part(slice(BLOCK))
        if not np.ndim(first):
            return first
        found = np.empty(size, dtype=first.dtype)
        found[:BLOCK] = first
        for start in range(BLOCK, size, BLOCK):
            found[start : start + BLOCK] = part(slice(start, start + BLOCK))
        return found
