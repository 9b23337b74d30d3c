# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The region: the part of the plane where a formula is negative, which may fall apart and vanish on its way."""

import numpy as np

from ..declared.parameters import at, declared, length, parameter, require
from ..later import later

compile = later("core.formulas.expressions", "compile")

NAMES = ("x", "y", "t")
LOOKED_AT = 65  # places along each side of the square, and along the way
PARTING = (  # two discs that part, and a third that vanishes
    "min(sqrt((x - 0.15*t)^2 + y^2) - 0.1, sqrt((x + 0.15*t)^2 + y^2) - 0.1, sqrt(x^2 + (y - 0.2)^2) - 0.06 + 0.12*t)"
)


@declared
class Region:
    """Where a formula of x, y and t is negative: what moves may change its form, fall apart and vanish

    Only the square about the reference point is looked at.

    Examples
    --------
    A disc that shrinks to half its size:

    >>> disc = Region("x^2 + y^2 - (0.2 - 0.1*t)^2", size=0.5)
    >>> disc.evaluate(np.array([0.15, 0.15]), np.zeros(2), np.array([0.0, 1.0])).round(4).tolist()
    [-0.0175, 0.0125]
    """

    formula: str = parameter(PARTING, "Expression of x, y and t (0 to 1): negative inside")
    size: float = length(0.6, "Side of the square that is looked at")

    def check(self):
        """Refuse what is no such expression, or nowhere negative, or negative at the rim of the square."""
        with at("formula"):
            compile(self.formula, NAMES)
        side = np.linspace(-self.size / 2, self.size / 2, LOOKED_AT)
        x, y, t = np.meshgrid(side, side, np.linspace(0, 1, LOOKED_AT), indexing="ij")
        values = self.evaluate(x, y, t)
        require((values < 0).any(), "must be negative somewhere in the square", float(values.min()), "formula")
        rim = np.concatenate((values[[0, -1]].ravel(), values[:, [0, -1]].ravel()))
        require(rim.min() > 0, "must be so large that the formula is positive at its rim", self.size, "size")

    def evaluate(self, x, y, t):
        """The formula at x, y in metres and t from 0 to 1: a float array as large as these together."""
        with at("formula"):
            return compile(self.formula, NAMES).evaluate(x=x, y=y, t=t)
