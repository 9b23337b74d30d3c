# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws: how a quantity changes along a trajectory: a number, a formula, or a smooth curve through control points.

Each is evaluated at samples given by the trajectory's own parameter u, by t from 0 to 1, and by the arc length s.
A law is also made from what it holds: ``scale_x=0.5``, ``scale_x="1 - t/2"``, ``scale_x=[(0, 1), (1, 0.5)]``.
"""

from functools import lru_cache

import numpy as np

from ..declared.parameters import Array, declared, parameter, proven, require
from ..later import later

compile, finite = later("core.formulas.expressions", "compile", "finite")

__all__ = ["Constant", "Formula", "Law", "Points"]

NAMES = ("u", "t", "s")  # what a formula may use
CLOSEST = 1e-9  # the least distance in t of two control points


@declared
class Constant:
    """The same everywhere

    >>> Constant(2).evaluate(u=[0, 1], t=[0, 1], s=[0, 5]).tolist()
    [2.0, 2.0]
    """

    value: float = parameter(1.0, "Value everywhere", shorthand=True)

    is_constant = True

    def evaluate(self, u, t, s):
        """(n,) float array: the value at n samples, given as (n,) float arrays u, t in 0 to 1, and s in metres."""
        return np.full(np.shape(t), self.value)

    def jet(self, u, t, s):
        """The value as a jet, from jets of u, t and s by one variable."""
        return 0.0 * t + self.value


@declared
class Formula:
    """An expression of u, t and s, in the language of `expressions.compile`

    >>> Formula("1 - t/2").evaluate(u=[0, 9], t=[0, 1], s=[0, 5]).tolist()
    [1.0, 0.5]
    """

    text: str = parameter("1", "Expression of u, t (0 to 1) and s (arc length)", shorthand=True)

    def check(self):
        """Refuse what is no such expression."""
        compile(self.text, NAMES)

    @classmethod
    @lru_cache(maxsize=16)
    def like(cls, law):
        """The formula that says what a constant does, or nothing."""
        return proven(cls, text=f"{law.value:g}") if isinstance(law, Constant) else None

    @property
    def is_constant(self):
        return not compile(self.text, NAMES).names

    def evaluate(self, u, t, s):
        """(n,) float array: the value at n samples; `ShapeError` where it is not finite."""
        return compile(self.text, NAMES).evaluate(u=u, t=t, s=s)

    def jet(self, u, t, s):
        """The value as a jet, from jets of u, t and s by one variable: differentiated exactly."""
        return 0.0 * t + compile(self.text, NAMES).run({"u": u, "t": t, "s": s})


@declared
class Points:
    """A smooth curve through points (t, value), that never rises or falls more than the points do

    Before the first and after the last point the value stays.

    Source: Fritsch, Carlson: Monotone Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17(2), 1980, with the
    weighted harmonic slopes of Fritsch, Butland, SIAM J. Sci. Stat. Comput. 5(2), 1984 (PCHIP).

    >>> Points([(0, 1), (0.5, 1), (1, 0)]).evaluate(u=[0, 1, 2], t=[0.25, 0.5, 2], s=[0, 1, 2]).tolist()
    [1.0, 1.0, 0.0]
    """

    points: Array = parameter(((0, 1), (1, 1)), "Control points (t, value)", columns=2, shorthand=True)

    def check(self):
        """Refuse values of t that do not rise from point to point."""
        t = self.points.values[:, 0]
        require((np.diff(t) > CLOSEST).all(), "must have t rising from point to point", t.tolist())

    @classmethod
    @lru_cache(maxsize=16)
    def like(cls, law):
        """The points that say what a constant does, or nothing."""
        return proven(cls, points=[(0, law.value), (1, law.value)]) if isinstance(law, Constant) else None

    @property
    def is_constant(self):
        return bool(np.ptp(self.points.values[:, 1]) == 0)

    def evaluate(self, u, t, s):
        """(n,) float array: the value at n samples, given as (n,) float arrays u, t in 0 to 1, and s in metres."""
        knots, values = self.points.values.T
        if len(knots) == 1:
            return np.full(np.shape(t), values[0])
        with np.errstate(all="ignore"):
            found = hermite(knots, values, monotone_slopes(knots, values), np.clip(t, knots[0], knots[-1]))
        return finite(found, u=u, t=t, s=s)

    def jet(self, u, t, s):
        """The value as a jet, from jets of u, t and s by one variable."""
        knots, values = self.points.values.T
        if len(knots) == 1:
            return 0.0 * t + values[0]
        return hermite(knots, values, monotone_slopes(knots, values), np.minimum(np.maximum(t, knots[0]), knots[-1]))


Law = Constant | Formula | Points


def __dir__():
    return __all__  # what a console offers


def monotone_slopes(knots, values):
    """The slope at each knot: 0 at a turn, else a harmonic mean of the slopes beside it, so nothing overshoots.

    The values are (k,), or (k, ...) of many curves with the same knots.
    """
    steps = np.diff(knots).reshape(-1, *(1,) * (values.ndim - 1))
    rises = np.diff(values, axis=0) / steps
    if len(steps) == 1:
        return np.repeat(rises, 2, axis=0)
    before, after = rises[:-1], rises[1:]
    weight = (2 * steps[1:] + steps[:-1], steps[1:] + 2 * steps[:-1])
    same = np.sign(before) * np.sign(after) > 0
    before, after = np.where(same, before, 1.0), np.where(same, after, 1.0)
    inner = np.where(same, (weight[0] + weight[1]) / (weight[0] / before + weight[1] / after), 0.0)
    ends = end_slope(*steps[:2], *rises[:2]), end_slope(*steps[:-3:-1], *rises[:-3:-1])
    return np.concatenate((ends[0][None], inner, ends[1][None]))


def end_slope(step, next_step, rise, next_rise):
    """The slope at an end of the parabola through three points, held to what keeps the curve monotone."""
    slope = ((2 * step + next_step) * rise - step * next_rise) / (step + next_step)
    beyond = (np.sign(rise) != np.sign(next_rise)) & (np.abs(slope) > 3 * np.abs(rise))
    return np.where(np.sign(slope) != np.sign(rise), 0.0, np.where(beyond, 3 * rise, slope))


def hermite(knots, values, slopes, t):
    """The cubic between each two knots that has their values and slopes, at places (n,) or at a jet of them."""
    places = getattr(t, "series", (t,))[0]
    i = np.clip(np.searchsorted(knots, places, side="right") - 1, 0, len(knots) - 2)
    step = knots[i + 1] - knots[i]
    x = (t - knots[i]) / step
    blend = x * x * (3 - 2 * x)
    rising = x * (1 - x) ** 2 * slopes[i] - x * x * (1 - x) * slopes[i + 1]
    return (1 - blend) * values[i] + blend * values[i + 1] + step * rising
