# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The sweep-CSG tree: a solid, and what is done to it with others, in order."""

from enum import Enum

from ..declared.frozen import written
from ..declared.parameters import declared, parameter, require
from ..later import later
from ..shapes.operand import Operand
from ..solids import Block

evaluated, inside = later("core.csg.meshes", "evaluated"), later("core.csg.shared", "inside")
line, shared_hash, shared_equal = (later("core.csg.shared", name) for name in ("line", "hashed", "equal"))
counted = later("core.csg.shared", "counted")

MOST_STEPS = 2_000
MOST_WRITTEN = 1_000  # operands, each as often as it is named, that are told with all their values
DEEPEST = 100  # trees inside one another


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

    def __hash__(self):
        return shared_hash(self)

    def __eq__(self, other):
        return shared_equal(self, other)

    def __str__(self):
        return line(self)

    def __repr__(self):
        return written(self) if counted(self) <= MOST_WRITTEN else f"<Tree {self}>"


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
