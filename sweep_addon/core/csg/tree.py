# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep-CSG tree: a solid, and what is done to it with others, in order."""

from enum import Enum

from ..later import later
from ..operand import Operand
from ..parameters import declared, parameter, require, spelled
from ..solids import Block

evaluated = later("core.csg.meshes", "evaluated")

MOST_STEPS = 2_000
DEEPEST = 100  # trees inside one another
SIGNS = {"union": "|", "intersection": "&", "difference": "-"}


class Operation(Enum):
    UNION = "What is in either"
    INTERSECTION = "What is in both"
    DIFFERENCE = "What is in the first and not in the second"


@declared
class Step:
    """A set operation, and the solid with which it is done

    >>> Step("difference").operand == Block()
    True
    """

    operation: Operation = parameter(Operation.UNION, "What is done")
    operand: Operand = parameter(Block(), "With what")


@declared
class Tree(Operand):
    """A solid to which others are added, with which it is intersected, and which are taken from it

    The steps are done in their order, as the Boolean modifiers of an object in Blender are. Operands may be trees.
    ``a | b``, ``a & b`` and ``a - b`` make trees. Operations are regularized: what they leave is the closure of its
    interior.

    Source
    ------
    Requicha: Representations for rigid solids, ACM Computing Surveys 12(4), 1980: regularized set operations.

    Examples
    --------
    >>> from sweep_addon.core.solids import Cylinder
    >>> tree = (Block(1.0, 1.0, 1.0) | Block(2.0, 0.5, 0.5)) - Cylinder(0.2, 2.0)
    >>> print(tree)
    (Block | Block) - Cylinder
    >>> tree == Tree(Block(1.0, 1.0, 1.0), [("union", Block(2.0, 0.5, 0.5)), ("difference", Cylinder(0.2, 2.0))])
    True
    """

    base: Operand = parameter(Block(), "What the steps begin with")
    steps: tuple[Step, ...] = parameter((), "What is done to it, in order", most=MOST_STEPS)

    def check(self):
        """Refuse trees more than 100 deep."""
        require(depth(self) <= DEEPEST, f"must be at most {DEEPEST} trees deep", depth(self), "steps")

    def mesh(self, dtype=None):
        """The boundary as one closed mesh of triangles, by the meshes of the operands: a `Mesh`, in metres.

        Raises
        ------
        ShapeError
            For an operand that is not closed, or where manifold3d is missing.

        Examples
        --------
        >>> round((Block(1.0, 1.0, 1.0) - Block(0.5, 0.5, 2.0)).mesh().volume(), 12)
        0.75
        """
        mesh = evaluated(self)
        return mesh if dtype is None else mesh.astype(dtype)

    def solid(self, progress=None):
        """The same: what set operations leave is a solid."""
        return self.mesh()

    def __str__(self):
        line, before = told(self.base, nested=not isinstance(self.base, Tree)), last_sign(self.base)
        for step in self.steps:
            sign = SIGNS[spelled(step.operation)]
            line = f"({line})" if before not in (None, sign) else line
            line, before = f"{line} {sign} {told(step.operand)}", sign
        return line


def last_sign(operand):
    """The sign of the last step of a tree, None where there is none."""
    steps = operand.steps if isinstance(operand, Tree) else ()
    return SIGNS[spelled(steps[-1].operation)] if steps else None


def told(operand, nested=True):
    """An operand as the line of a tree names it, in brackets if it is an expression within another."""
    if type(operand).__str__ is object.__str__:
        return type(operand).__name__
    line, one = str(operand), type(operand).__name__ == "SweptSolid"
    return f"({line})" if nested and " " in line and not one else line


def combined(left, operation, right):
    """The tree of a set operation; one whose first operand is a tree has one step more than that."""
    step = Step(operation, right)
    return Tree(left.base, (*left.steps, step)) if isinstance(left, Tree) else Tree(left, (step,))


def depth(tree):
    """How many trees are inside one another."""
    level, deepest = [tree], 0  # each node once, however many name it
    while level and deepest <= DEEPEST:
        deepest += any(isinstance(node, Tree) for node in level)
        level = list({id(inner): inner for node in level for inner in inside(node)}.values())
    return deepest


def inside(node):
    """The operands of a node; none of a leaf."""
    if isinstance(node, Tree):
        return (node.base, *(step.operand for step in node.steps))
    return tuple(part for part in vars(node).values() if isinstance(part, Operand))
