# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A trajectory by formulas."""

from enum import Enum
from functools import cached_property
from math import tau

import numpy as np

from ..declared.parameters import LARGEST, ShapeError, at, declared, parameter, require
from ..later import later
from .curve import Trajectory, row

compile = later("core.formulas.expressions", "compile")
Jet = later("core.formulas.jets", "Jet")
breaks = later("core.trajectories.breaks", "breaks")

MEETING = 1e-5  # of the size: ends closer than this are one, for nobody writes all the digits of a turn
AXES, NAMES = "xyz", ("", "first", "second", "third")
LOOKED_AT = 2049  # places where a formula is tried when it is made


class Closing(int, Enum):
    """Whether a trajectory is closed; in Python None, True and False."""

    AUTO = -1, "Closed where place and direction agree at both ends"
    YES = 1, "The end is the start again"
    NO = 0, "Two ends, also where they meet"

    def __new__(cls, number, doc):
        made = int.__new__(cls, number)
        made._value_ = doc
        return made

    __repr__ = Enum.__str__

    @classmethod
    def _missing_(cls, value):
        return next((member for said, member in zip((None, True, False), cls, strict=True) if value is said), None)


@declared
class Formula(Trajectory):
    """Three expressions of u

    They are differentiated exactly. Where abs, min, if and their like make a corner, it is mitred.

    Examples
    --------
    >>> viviani = Formula("1 + cos(u)", "sin(u)", "2*sin(u/2)", end=4 * 3.141592653589793)
    >>> round(viviani.length(), 6), bool(viviani.closed)
    (15.280791, True)
    """

    x: str = parameter("cos(u)", "Expression of u, in metres")
    y: str = parameter("sin(u)", "Expression of u, in metres")
    z: str = parameter("0.2*sin(3*u)", "Expression of u, in metres")
    start: float = parameter(0.0, "First u")
    end: float = parameter(tau, "Last u")
    closed: Closing = parameter(Closing.AUTO, "Whether the end is the start again")

    def check(self):
        """Refuse what has no length or is not smooth at its ends, and ends apart that are to be closed."""
        require(self.end > self.start, f"must be more than the start, {self.start:g}", self.end, "end")
        points = self.evaluate(np.linspace(self.start, self.end, LOOKED_AT))
        for key, values in zip(AXES, points.T, strict=True):
            most = float(np.abs(values).max())
            require(most <= LARGEST, f"must be at most {LARGEST:g} in size", most, key)
        size = float(np.ptp(points, axis=0).max())
        require(size > 0, "x, y and z must change with u", [self.x, self.y, self.z])
        ends = np.array(self.domain)
        for order in (1, 2):
            self.derivative(ends, order)
        gap = float(np.linalg.norm(points[-1] - points[0]))
        if self.closed is Closing.YES:
            require(gap <= MEETING * size, "must be no or auto where the ends are apart, in metres", gap, "closed")
        elif self.closed is Closing.AUTO:
            leave, arrive = self.tangents(ends[:1]), self.tangents(ends[1:], before=True)
            meets = gap <= MEETING * size and np.linalg.norm(leave - arrive) <= 10 * MEETING
            object.__setattr__(self, "closed", Closing.YES if meets else Closing.NO)

    @property
    def domain(self):
        return self.start, self.end

    @cached_property
    def breaks(self):
        """The ends of the smallest cells that hold a corner: (k, 2)."""
        return breaks(self.evaluate, self.differentiated, self.domain)

    def joints(self):
        inner = self.breaks[(self.breaks[:, 0] > self.start) & (self.breaks[:, 1] < self.end)]
        return np.concatenate(([self.start], inner.mean(axis=1), [self.end]))

    def evaluate(self, u):
        u = row(u)
        found = []
        for key in AXES:
            with at(key):
                found.append(compile(getattr(self, key), ("u",)).evaluate(u=u))
        return np.stack(found, axis=1)

    def derivative(self, u, order=1, before=False):
        u = row(u)
        if len(self.breaks):
            near = np.clip(np.searchsorted(self.breaks[:, 0], u, side="right") - 1, 0, len(self.breaks) - 1)
            low, high = self.breaks[near].T
            aside = np.where((low > self.start) & (before | (high >= self.end)), low, high)
            u = np.where((low <= u) & (u <= high), aside, u)
        return self.differentiated(u, order)

    def differentiated(self, u, order):
        """Derivatives as the formulas have them, (n, 3); in a corner neither that before it nor that after it."""
        found = np.zeros((len(u), 3))
        for column, key in zip(found.T, AXES, strict=True):
            jet = compile(getattr(self, key), ("u",)).run({"u": Jet.variable(u, order)})
            column[:] = jet.derivative(order) if isinstance(jet, Jet) else 0.0
            wrong = ~np.isfinite(column)
            if wrong.any():
                first = int(np.argmax(wrong))
                sentence = f"must be smooth, got a {NAMES[order]} derivative of {column[first]:g} at u = {u[first]:.6g}"
                raise ShapeError(sentence, key)
        return found
