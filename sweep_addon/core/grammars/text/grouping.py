# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Productions that share a chance: those of one predecessor, context and condition that have a probability."""

from .passages import problem

ROUNDING = 1e-9  # by how much probabilities may miss 1


def head(rule):
    """What productions have in common that share a chance."""
    sides = tuple(tuple(pattern.symbol for pattern in side) for side in (rule.left, rule.right))
    if rule.condition is None:
        return rule.predecessor.symbol, sides, None
    names = tuple(pattern.parameters for pattern in (*rule.left, rule.predecessor, *rule.right))
    return rule.predecessor.symbol, sides, (names, rule.condition.program)


def grouped(rules):
    """Lists of productions, in the order in which they are tried; of those that share a chance one is taken.

    Parameters
    ----------
    rules : sequence of Production

    Returns
    -------
    list of list of Production
    """
    groups, shared = [], {}
    for rule in rules:
        if rule.probability is None:
            groups.append([rule])
        elif head(rule) in shared:
            shared[head(rule)].append(rule)
        else:
            groups.append([rule])
            shared[head(rule)] = groups[-1]
    return groups


def check_probabilities(rules, problems, lines):
    """Add to the problems where probabilities sum to more than 1."""
    source = {passage.number: passage.line for _, passage, _ in lines}
    sections = {}
    for section, rule in rules:
        sections.setdefault(section, []).append(rule)
    for each in sections.values():
        for group in grouped(each):
            total = sum(rule.chance for rule in group)
            if total > 1 + ROUNDING:
                last = group[-1]
                line = source[last.line]
                expected = f"probabilities of {last.predecessor} that sum to at most 1"
                problems.append(problem(line, last.line, line.find("-("), f"{total:.6g}", expected))
