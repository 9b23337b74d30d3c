# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A system as tables: modules are numbers, productions lists of numbers and formulas."""

from bisect import bisect_right
from functools import cached_property, lru_cache

import numpy as np

from ..text.grouping import ROUNDING, grouped
from ..text.modules import CLOSE, ENVIRONMENT, OPEN, QUERIES
from .draws import mix, salts
from .evaluating import PREDECESSOR, Formula, Path
from .statements import names

CUT = "%"
RECENT = 32  # groups whose tables are kept
HIDDEN, SEEN, OPENS, CLOSES, ASKS = range(5)  # what a module is to a context; ASKS is hidden, but has a context itself


class Tables:
    """What a derivation looks up.

    Attributes
    ----------
    symbols : list of (str, int)
        Name and number of parameters of each module, by its number.
    axiom : Template
    common, decomposition, homomorphism : Rules
        Productions of every step, and of the other sections.
    groups : dict of int to Rules
        Those of each group.
    systems : dict of int to Rules
        Those of each sub-system.
    nested : bool
        Whether words may have sub-systems.
    lives : set of int
        Modules that a production of some step replaces.
    kind : (s + 1,) uint8 array
        What each is to contexts; the last is no module.
    columns : int
        The most parameters of a module.
    cut : int or None
        The module that cuts.
    variables : tuple of str
        Names that statements give values to.
    queries : dict of int to (str, int)
        Modules that are filled in after each step, by their numbers: name and number of parameters.
    random : bool
        Whether anything hangs on chance.
    longest : int
        How many modules the axiom or the longest successor has.
    """

    def __init__(self, system):
        self.system = system
        self.numbers, self.symbols, self.paths = {}, [], {}
        sections = [
            system.productions,
            system.decomposition,
            system.homomorphism,
            *(rules for _, rules in (*system.groups, *system.systems)),
        ]
        self.axiom = Template(system.axiom, self)
        for rule in (rule for section in sections for rule in section):
            for module in (rule.predecessor, *rule.successor, *rule.left, *rule.right):
                self.number(module)
        self.groups = {number: Rules(rules, self) for number, rules in system.groups}
        self.systems = {number: Rules(rules, self) for number, rules in system.systems}
        self.common = Rules(system.productions, self)
        self.begun = sorted(self.groups)
        self.both = lru_cache(maxsize=RECENT)(lambda number: Both(self.groups[number], self.common))
        self.decomposition = Rules(system.decomposition, self)
        self.homomorphism = Rules(system.homomorphism, self)
        self.lives = {symbol for rules in (self.common, *self.groups.values()) for symbol in rules.choices}
        self.columns = max((count for _, count in self.symbols), default=0)
        self.dtype = np.uint8 if len(self.symbols) < 255 else np.uint16
        self.kind = self.kinds(sections)
        self.cut = self.numbers.get((CUT, 0))
        self.variables = names(system)
        asking = (*QUERIES, ENVIRONMENT)
        self.queries = {number: told for number, told in enumerate(self.symbols) if told[0] in asking and told[1]}
        self.nested = any(name == "?" and count for name, count in self.symbols)
        every = (self.common, self.decomposition, self.homomorphism, *self.groups.values(), *self.systems.values())
        self.random = self.axiom.random or any(rules.random for rules in every)
        self.longest = max([len(self.axiom.symbols), *(rules.longest for rules in every)])

    def number(self, module):
        """The number of a module or pattern."""
        symbol = module.symbol
        number = self.numbers.get(symbol)
        if number is None:
            number = self.numbers[symbol] = len(self.symbols)
            self.symbols.append(symbol)
        return number

    def path(self, origin, link, number):
        """The path that goes on so from another."""
        return self.paths.setdefault((origin, link, number), Path(origin, link, number))

    def kinds(self, sections):
        """(s + 1,) uint8 array: what each module is to contexts."""
        system = self.system
        asks = {rule.predecessor.symbol for rules in sections for rule in rules if rule.left or rule.right}
        found = []
        for name, count in self.symbols:
            seen = name in system.consider if system.consider is not None else name not in (system.ignore or ())
            hidden = ASKS if (name, count) in asks else HIDDEN
            found.append({OPEN: OPENS, CLOSE: CLOSES}.get(name, SEEN if seen else hidden))
        return np.array([*found, HIDDEN], dtype=np.uint8)

    def of_step(self, step):
        """The productions of a step, from 1."""
        number = self.group_of(step)
        return self.common if number is None else self.both(number)

    def group_of(self, step):
        """The number of the group of a step; None where it has none."""
        if self.system.schedule is None:
            place = bisect_right(self.begun, step) - 1
            return self.begun[place] if place >= 0 else None
        groups, again = self.system.schedule
        number = groups[(step - 1) % len(groups) if again else min(step, len(groups)) - 1]
        return number if number in self.groups else None


class Rules:
    """The productions of one section, by the modules that they replace."""

    def __init__(self, productions, tables):
        self.choices = {}
        for group in grouped(productions):
            self.choices.setdefault(tables.number(group[0].predecessor), []).append(Choice(group, tables))
        every = [choice for choices in self.choices.values() for choice in choices]
        self.context = any(choice.nodes for choice in every)
        self.lateral = any(link == "branch" for choice in every for _, link, _, _ in choice.nodes)
        self.random = any(choice.random for choice in every)
        self.count = len(every)
        self.longest = max((len(template.symbols) for choice in every for template in choice.templates), default=0)

    def __bool__(self):
        return bool(self.choices)


class Both:
    """The productions of a group, and behind them those of every step."""

    def __init__(self, group, common):
        self.choices = common.choices | {
            symbol: [*choices, *common.choices.get(symbol, ())] for symbol, choices in group.choices.items()
        }
        self.context = group.context or common.context


class Choice:
    """Productions that share predecessor, context and condition; one of them is taken by its probability.

    Attributes
    ----------
    nodes : list of (int, str, int, int)
        The modules of the context: from which node, by which link, the so-manieth, and which module must be there. Node
        0 is the predecessor.
    condition : Formula or None
    bounds : (k,) float array
        Up to which random number each production is taken.
    templates : list of Template
    """

    def __init__(self, group, tables):
        first = group[0]
        self.productions = group
        self.nodes = nodes(first, tables)
        self.last = [0] * (1 + len(self.nodes))  # which node is the last that is next to each
        for node, (origin, *_) in enumerate(self.nodes, 1):
            self.last[origin] = node
        self.condition = None if first.condition is None else Formula(first.condition, sources(first, tables))
        self.bounds = np.cumsum([rule.chance for rule in group])
        if abs(self.bounds[-1] - 1) < ROUNDING:
            self.bounds[-1] = 1.0
        self.always = len(group) == 1 and self.bounds[-1] == 1
        self.templates = [Template(rule.successor, tables, rule) for rule in group]
        drawing = self.condition is not None and self.condition.random
        self.random = not self.always or drawing or any(template.random for template in self.templates)
        self.certain = self.condition is None and not self.nodes and self.always


def linked(rule):
    """The modules of a context from the predecessor outwards, and how each is found.

    Returns
    -------
    list of (int, str, int, Pattern)
        From which node, by which link, the so-manieth, and the module; node 0 is the predecessor, 1 the first listed.
    """
    found = []

    def ahead(patterns, at):
        behind, outer, link = 0, [], ("right", 0)
        for pattern in patterns:
            if pattern.name == OPEN:
                outer.append((at, behind + 1))
                link, behind = ("branch", behind), 0
            elif pattern.name == CLOSE:
                at, behind = outer.pop()
                link = ("right", 0)
            else:
                found.append((at, *link, pattern))
                at, behind, link = len(found), 0, ("right", 0)

    at = 0
    for pattern, laterals in reversed(axial(rule.left)):
        found.append((at, "left", 0, pattern))
        at = len(found)
        ahead(laterals, at)
    ahead(rule.right, 0)
    return found


def axial(patterns):
    """The modules of a left context that stand on the axis, each with the brackets behind it and what is in them."""
    found, depth = [], 0
    for pattern in patterns:
        depth += pattern.name == OPEN
        if depth:
            found[-1][1].append(pattern)
        else:
            found.append((pattern, []))
        depth -= pattern.name == CLOSE
    return found


def sources(rule, tables):
    """By which path, and in which column, each parameter of a production is."""
    patterns, paths = [rule.predecessor], [PREDECESSOR]
    for origin, link, number, pattern in linked(rule):
        patterns.append(pattern)
        paths.append(tables.path(paths[origin], link, number))
    return {name: (paths[node], column) for node, p in enumerate(patterns) for column, name in enumerate(p.parameters)}


def nodes(rule, tables):
    """The nodes of a context."""
    return [(origin, link, number, tables.number(pattern)) for origin, link, number, pattern in linked(rule)]


def stays(formula, targets):
    """Whether all that a formula does is to hand the parameter of a module on where it was."""
    return all(formula.copies == (PREDECESSOR, column) for _, column in targets)


class Template:
    """What replaces a module.

    Attributes
    ----------
    symbols : list of int
    fixed : dict of (int, int) to float
        Parameters that are the same everywhere, by place and column.
    formulas : list of (Formula, list of (int, int))
        The others: each formula with its places and columns.
    changes : list of (Formula, list of (int, int))
        The same without parameters that a module has already which it is the only one to replace.
    random : bool
        Whether formulas draw random numbers.
    """

    def __init__(self, modules, tables, rule=None):
        self.symbols = [tables.number(module) for module in modules]
        self.names = [module.name for module in modules]
        self.rule = rule
        each = [(k, c, p) for k, module in enumerate(modules) for c, p in enumerate(module.parameters)]
        fixed = [(k, c, p) for k, c, p in each if not p.names]
        values = {id(p): float(p.run({})) for p in {id(p): p for _, _, p in fixed}.values()}  # one for all alike
        self.fixed = {(k, c): values[id(p)] for k, c, p in fixed}
        told = [(k, c, p) for k, c, p in each if p.names]
        known = sources(rule, tables) if rule and told else {}
        found = {}
        for k, c, p in told:
            found.setdefault(p.program, (Formula(p, known), []))[1].append((k, c))
        self.formulas = list(found.values())
        self.changes = self.formulas if len(modules) > 1 else [each for each in self.formulas if not stays(*each)]
        self.random = any(formula.random for formula, _ in self.formulas)

    @cached_property
    def salts(self):
        """(k,) uint64 array: what makes keys of the modules at each place."""
        return salts(self.names)

    def child_keys(self, keys, place):
        """(m,) uint64 array: the keys of the modules at a place, from those of the modules that they replace."""
        return keys if self.rule and len(self.symbols) == 1 else mix(keys + self.salts[place])
