# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Operands: what set operations take, by ``a | b``, ``a & b`` and ``a - b``: shapes, solids and trees of them."""

from ..declared.coercing import from_table
from ..declared.parameters import ShapeError, parameters
from ..declared.wording import shown
from ..later import later

known = later("core.csg.known", "known")
combined = later("core.csg.tree", "combined")
moved = later("core.csg.placed", "moved")


class Operand:
    """A set of points that set operations take.

    Examples
    --------
    >>> from sweep_addon.core.solids import Ball, Block
    >>> drilled = Block() - Ball(0.3)
    >>> print(drilled)
    Block - Ball
    """

    def __or__(self, other):
        return combination(self, "union", other)

    def __and__(self, other):
        return combination(self, "intersection", other)

    def __sub__(self, other):
        return combination(self, "difference", other)

    def moved(self, x=0.0, y=0.0, z=0.0):
        """The same somewhere else, by a way along each axis in metres: a `Placed`."""
        return moved(self, (x, y, z))

    @classmethod
    def coerced(cls, value):
        """An operand from itself, from the table of one, or from its bare name, as the value of a parameter."""
        if isinstance(value, cls):
            value.require_solid()
            return value
        if isinstance(value, str) and value in known():
            value = {"kind": value}
        if not isinstance(value, dict):
            from ..declared.hints import hint  # nobody needs it until something is refused

            raise ShapeError(f"must be a shape, a solid or a tree, got {shown(value)}{hint(known(), value)}")
        return cls.coerced(from_table(known(), value, parameters))

    def require_solid(self):
        """Refuse what is known to be no solid before its mesh is made."""


def combination(left, operation, right):
    """The tree of a set operation; nothing that Python knows of for what is no set of points."""
    return combined(left, operation, right) if isinstance(right, Operand) else NotImplemented


def standing(value):
    """What stands for an operand in set operations: the solid of a plant's tubes, and of all others themselves."""
    return value.united() if hasattr(value, "united") else value
