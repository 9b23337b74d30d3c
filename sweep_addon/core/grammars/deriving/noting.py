# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Notes: what a system says and never does, most likely by a slip. None of it is refused, for it is no error."""

from ..text.grouping import grouped, head

PAIRS = (("{", "}"), ("@Gs", "@Ge"))  # modules that only do something together


def notes(system):
    """Sentences about productions that are never taken, and about modules that wait for others.

    Parameters
    ----------
    system : LSystem

    Returns
    -------
    list of str

    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> notes(LSystem.parse("axiom: A\\nA -> AB\\nA -> BA"))
    ['Line 3: A is replaced by line 2 first, always; where chance decides, both say how often: A -(0.5)-> ...']
    >>> notes(LSystem.parse("axiom: A {F+F\\nA(x) -> F(x)"))[0]
    'Line 2: A(x) never occurs; A does, and has no production: these are different modules.'
    """
    sections = [
        system.productions,
        system.decomposition,
        system.homomorphism,
        *(rules for _, rules in (*system.groups, *system.systems)),
    ]
    rules = [rule for section in sections for rule in section]
    occurring = {module.symbol for word in (system.axiom, *(rule.successor for rule in rules)) for module in word}
    return [*(said for section in sections for said in hidden(section)), *unmet(rules, occurring), *alone(occurring)]


def hidden(rules):
    """Productions behind one of the same section that is taken wherever they could be."""
    first = {}
    for group in grouped(rules):
        rule, told = group[0], head(group[0])
        free = (rule.predecessor.symbol, ((), ()), None)
        taken = first.get(free) or first.get(told)
        if taken:
            advice = f"where chance decides, both say how often: {rule.predecessor} -(0.5)-> ..."
            if head(taken) != told:
                advice = "what holds less often stands before what always holds"
            other = f"line {taken.line}" if taken.line else "another production"
            yield f"{place(rule)}{rule.predecessor} is replaced by {other} first, always; {advice}"
        first.setdefault(told, rule)


def unmet(rules, occurring):
    """Predecessors that never occur, while the same name with another number of parameters does and stays as it is."""
    replaced = {rule.predecessor.symbol for rule in rules}
    others = {}
    for name, count in sorted(occurring - replaced):
        others.setdefault(name, count)
    told = set()
    for rule in rules:
        name, _ = symbol = rule.predecessor.symbol
        if symbol not in occurring and name in others and symbol not in told:
            told.add(symbol)
            yield (
                f"{place(rule)}{rule.predecessor} never occurs; {spelled(name, others[name])} does, and has no "
                "production: these are different modules."
            )


def alone(occurring):
    """Modules of a pair of which the other never occurs."""
    names = {name for name, _ in occurring}
    for opening, closing in PAIRS:
        for here, missing in ((opening, closing), (closing, opening)):
            if here in names and missing not in names:
                yield f"{here} draws nothing without {missing}, which never occurs."


def place(rule):
    """Where a production stands in its text, if it was read from one."""
    return f"Line {rule.line}: " if rule.line else ""


def spelled(name, count):
    """A module with so many parameters.

    >>> spelled("A", 2), spelled("A", 0)
    ('A(...,...)', 'A')
    """
    return f"{name}({','.join(['...'] * count)})" if count else name
