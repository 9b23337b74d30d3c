# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sub-systems: parts of a word that develop by productions of their own, and are drawn in a scale of their own.

``?(id, scale)`` begins one and ``$`` ends it; within them others may stand. A ``$`` that ends none rolls the turtle
level.

Source
------
Hanan: Virtual Plants, Integrating Architectural and Physiological Models, 1997; L-studio/cpfg User's Manual, 1999.
"""

import numpy as np

from ...declared.parameters import ShapeError, require
from ..drawing.filling import levels
from .neighbours import narrow

BEGINS, ENDS = "?", "$"


def beginning(symbols):
    """The numbers of modules that begin a sub-system, of those in a table of names and numbers of parameters."""
    return [number for number, (name, count) in enumerate(symbols) if name == BEGINS and count]


class Regions:
    """Which sub-system each module of a word is in.

    Parameters
    ----------
    tables : Tables
    state : State or Word

    Attributes
    ----------
    opener : (n,) int array
        The module that begins the innermost sub-system of each; -1 where there is none. Those that begin or end one
        are in it.
    bounds : (n,) bool array
        Which modules begin or end one.
    """

    def __init__(self, tables, state):
        self.tables, self.state = tables, state
        symbols = state.symbols
        opens = np.isin(symbols, beginning(tables.symbols))
        closes = symbols == tables.numbers.get((ENDS, 0), -1)
        level = levels(opens, closes)
        self.closing = closes & (level > 0)
        self.bounds = opens | self.closing
        inside = np.flatnonzero(level)
        order = inside[np.argsort(narrow(level[inside]), kind="stable")]
        latest = np.maximum.accumulate(np.where(opens[order], np.arange(len(order)), 0)) if len(order) else order
        self.opener = np.full(len(symbols), -1)
        self.opener[order] = order[latest]

    def shares(self, systems, rules):
        """Which productions replace which modules.

        Parameters
        ----------
        systems : dict of int to Rules
            The productions of sub-systems by their numbers.
        rules : Rules
            Those of the modules in none.

        Yields
        ------
        Rules
        (n,) bool array
        """
        within = self.opener >= 0
        yield rules, ~within
        number = np.where(within, self.state.columns[0][self.opener], 0)
        for system, productions in systems.items():
            yield productions, within & ~self.bounds & (number == system)

    def scales(self):
        """(n,) float array: by what all that is drawn is scaled at each module.

        Raises
        ------
        ShapeError
            For a scale that is not positive.
        """
        found = np.ones(len(self.state.symbols))
        given = np.array([count > 1 for _, count in self.tables.symbols])[self.state.symbols]
        begins = np.flatnonzero(self.bounds & ~self.closing & given)
        if not len(begins):
            return found
        told = self.state.columns[1][begins]
        if not (told > 0).all():
            raise ShapeError(f"must have a positive scale, got {told[~(told > 0)][0]:g}", BEGINS)
        logs = np.zeros(len(found))
        logs[begins] = np.log(told)
        ends = np.flatnonzero(self.closing)
        logs[ends] = -logs[self.opener[ends]]
        powers = np.cumsum(logs)
        within = self.opener >= 0
        with np.errstate(over="ignore"):
            found[within] = np.exp(powers[within])
        require(np.isfinite(found).all(), "must come to a finite scale", found.max(), BEGINS)
        outer = begins[self.outermost(begins)]  # whose scales need no rounding
        plain = within & ~self.closing & np.isin(self.opener, outer)
        found[plain] = self.state.columns[1][self.opener[plain]]
        return found

    def outermost(self, begins):
        """(k,) bool array: which beginnings stand in no other sub-system."""
        depth = np.cumsum((self.bounds & ~self.closing).astype(np.int32) - self.closing)
        return depth[begins] == 1
