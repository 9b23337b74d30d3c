# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Trees that name one operand many times: what is asked of all their nodes is asked of each once.

A tree of thirty steps may name its first operand a thousand million times, as ``tree = tree | tree`` does each time.
"""

from ..declared.parameters import spelled
from ..shapes.operand import Operand

LONGEST = 2_000  # characters of a line; what is longer is told by its number of operands
MANY = " operands)"
SIGNS = {"union": "|", "intersection": "&", "difference": "-"}


def inside(node):
    """The operands of a node; none of a leaf."""
    held = []
    for part in map(vars(node).get, getattr(node, "__dataclass_fields__", ())):
        if isinstance(part, Operand):
            held.append(part)
        elif isinstance(part, tuple):
            held += [step.operand for step in part if isinstance(getattr(step, "operand", None), Operand)]
    return tuple(held)


def ordered(root):
    """All nodes below a root and the root itself, each once, operands before what they are operands of."""
    found, todo = {}, [(root, False)]
    while todo:
        node, entered = todo.pop()
        if entered:
            found[id(node)] = node
        elif id(node) not in found:
            todo.append((node, True))
            todo += [(each, False) for each in inside(node) if id(each) not in found]
    return found.values()


def hashed(root):
    """The hash of a node."""
    known = {}
    for node in ordered(root):
        held = parts(node, lambda operand: known[id(operand)]) if inside(node) else node
        known[id(node)] = hash((type(node), held))
    return known[id(root)]


def parts(node, of_operand):
    """What the fields of a node hold, their operands as a function has them: a tuple."""
    held = []
    for part in (vars(node)[name] for name in node.__dataclass_fields__):
        if isinstance(part, Operand):
            part = of_operand(part)
        elif isinstance(part, tuple) and part and isinstance(getattr(part[0], "operand", None), Operand):
            part = tuple((step.operation, of_operand(step.operand)) for step in part)
        held.append(part)
    return tuple(held)


def equal(left, right):
    """Whether two nodes are of one type and have equal parts."""
    if type(left) is not type(right):
        return NotImplemented
    seen, todo = set(), [(left, right)]
    while todo:
        a, b = todo.pop()
        if a is b or (id(a), id(b)) in seen:
            continue
        seen.add((id(a), id(b)))
        if type(a) is not type(b) or len(inside(a)) != len(inside(b)):
            return False
        if not inside(a):
            if a != b:
                return False
        elif parts(a, lambda operand: None) != parts(b, lambda operand: None):
            return False
        todo += zip(inside(a), inside(b), strict=True)
    return True


def counted(root):
    """How many leaves a node has, each as often as it is named."""
    known = {}
    for node in ordered(root):
        known[id(node)] = sum(known[id(each)] for each in inside(node)) or 1
    return known[id(root)]


def line(root):
    """A node as one line: operands by their types' names, operations by their signs, brackets where they are needed."""
    known = {}
    for node in ordered(root):
        written = line_of(node, known)
        known[id(node)] = written if len(written) <= LONGEST else f"({counted(node):,}{MANY}"
    return known[id(root)]


def line_of(node, known):
    """The line of a node whose operands' lines are known."""
    kind, operands = type(node).__name__, inside(node)
    if kind == "Tree":
        written, before = known[id(node.base)], last_sign(node.base)
        if before is None:
            written = bracketed(node.base, written)
        for step in node.steps:
            sign = SIGNS[spelled(step.operation)]
            written = f"({written})" if before not in (None, sign) else written
            written, before = f"{written} {sign} {bracketed(step.operand, known[id(step.operand)])}", sign
        return written
    if kind == "SweptSolid":
        return f"sweep({known[id(node.solid)]})"
    return known[id(operands[0])] if kind == "Placed" else told(node)


def bracketed(node, written):
    """The line of an operand within that of a tree, in brackets if it is an expression."""
    bare = type(node).__name__ == "SweptSolid" or " " not in written or written.endswith(MANY)
    return written if bare else f"({written})"


def told(leaf):
    """A leaf by its own line, or by the name of its type."""
    return type(leaf).__name__ if type(leaf).__str__ is object.__str__ else str(leaf)


def last_sign(node):
    """The sign of the last step of a tree, None where there is none."""
    steps = getattr(node, "steps", ()) if type(node).__name__ == "Tree" else ()
    return SIGNS[spelled(steps[-1].operation)] if steps else None
