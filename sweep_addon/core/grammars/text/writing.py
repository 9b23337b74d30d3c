# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of a system in the notation of the book; reading it gives the same system."""

from ...declared.parameters import require
from ..deriving.statements import BLOCKS
from .modules import Alphabet
from .productions import told


def written(system):
    """The lines of a system as text.

    Parameters
    ----------
    system : LSystem

    Returns
    -------
    str
    """
    every = (
        system.productions,
        system.decomposition,
        system.homomorphism,
        *(rules for _, rules in (*system.groups, *system.systems)),
    )
    for rule in (rule for rules in every for rule in rules):
        functions = [p for module in rule.successor for p in module.parameters if not hasattr(p, "evaluate")]
        require(not functions, "has no text where a successor is a Python function", rule.predecessor, "productions")
    alphabet = Alphabet(system.names)
    axiom = f"axiom: {told(system.axiom, alphabet)}"
    return "\n".join([*settings(system), axiom, *blocks(system), *sections(system, alphabet), ""])


def blocks(system):
    """The statements, a line for each block."""
    for block in BLOCKS:
        if getattr(system, block):
            yield f"{block.replace('_', ' ')}: {'; '.join(map(str, getattr(system, block)))}"


def settings(system):
    """The directives that say what is not the default."""
    yield f"#dialect {system.dialect}"
    if system.names:
        yield f"#names {', '.join(system.names)}"
    yield from map(str, system.constants)
    for word, names in (("ignore", system.ignore), ("consider", system.consider)):
        if names is not None:
            yield f"#{word} {' '.join(names)}"
    if system.heading:
        yield f"#heading {system.heading}"
    defaults = type(system).__dataclass_fields__
    formulas = {word: (told, formula) for word, told, formula in system.following}
    for word in ("angle", "step", "width", "generations", "seed", "tropism"):
        value = getattr(system, word)
        told, formula = formulas.get(word, (defaults[word].default, ""))
        if formula and value == told:
            yield f"#{word} {formula}"
        elif value != defaults[word].default:
            yield f"#{word} {' '.join(map(repr, value)) if word == 'tropism' else repr(value)}"
    if system.schedule:
        groups, again = system.schedule
        yield f"#groups {' '.join(map(str, groups))}{' ...' if again else ''}"


def sections(system, alphabet):
    """The productions, each section under its name."""

    def lines(rules):
        return (rule.told(alphabet) for rule in rules)

    yield from lines(system.productions)
    for number, rules in system.groups:
        yield f"group {number}:"
        yield from lines(rules)
    for number, rules in system.systems:
        yield f"lsystem {number}:"
        yield from lines(rules)
    for section in ("decomposition", "homomorphism"):
        rules, depth = getattr(system, section), getattr(system, f"{section}_depth")
        if rules:
            yield f"{section}:"
            yield from [] if depth is None else [f"maximum depth: {depth}"]
            yield from lines(rules)
