# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which production each module of a word takes, and what the parameters of its successor are."""

import numpy as np

from ..expressions import DRAW
from ..parameters import ShapeError
from .draws import even


class Site:
    """Some modules of a word that may take a production, with the modules of their context.

    Parameters
    ----------
    state : State
    rows : list of (m,) int array
        The places of the predecessors, and of each node of the context.
    moment : int
        The step that is made, for random numbers.
    """

    def __init__(self, state, rows, moment):
        self.state, self.rows, self.moment = state, rows, moment

    def keep(self, chosen):
        """Those of the modules that are chosen."""
        return Site(self.state, [rows[chosen] for rows in self.rows], self.moment)

    def values(self, expression, sources):
        """(m,) float array, or one number where it is the same for all: the value of a formula of parameters."""
        names = {}
        for name in expression.names:
            if name.startswith(DRAW):
                names[name] = self.even(1 + int(name.removeprefix(DRAW)))
            elif name not in sources:
                names[name] = self.state.variables[name]
            else:
                node, column = sources[name]
                names[name] = self.state.columns[column][self.rows[node]]
        return expression.run(names)

    def even(self, draw):
        """(m,) float array: random numbers of these modules."""
        return even(self.state.keys[self.rows[0]], self.moment, draw)


def taken(state, rules, moment, links):
    """The productions that modules of a word take.

    Parameters
    ----------
    state : State
    rules : Rules
    moment : int
    links : Neighbours or None
        Of the word, where a production has a context.

    Yields
    ------
    Template
    Site
        The modules that it replaces.
    """
    for symbol, choices in rules.choices.items():
        wanted = state.symbols == symbol
        waiting = np.flatnonzero(wanted if state.fresh is None else wanted & state.fresh)
        yield from tried(state, waiting, [(choice, False) for choice in choices], moment, links)


def tried(state, waiting, choices, moment, links):
    """The productions that modules take, of some in their order.

    Parameters
    ----------
    state : State or Pool
    waiting : (m,) int array
        The places of the modules.
    choices : list of (Choice, bool)
        What they may take, and whether their contexts are known to match.
    moment : int
    links : Neighbours, Pool or None

    Yields
    ------
    Template
    Site
        The modules that it replaces.
    """
    for choice, known in choices:
        if not waiting.size:
            return
        site = Site(state, [waiting], moment)
        matches = matched(site, choice, links, known)
        if matches is None:
            waiting = waiting[:0]
        else:
            site = site.keep(matches)
            still = np.ones(len(waiting), dtype=bool)
            still[matches] = False
            waiting = waiting[still]
        if choice.nodes:
            site = with_context(site, choice, links)
        yield from shared(site, choice)


def matched(site, choice, links, known):
    """Which modules of a site match context and condition; None for all of them."""
    found = None
    if choice.nodes and not known:
        found = context(site, choice, links)
    if choice.condition is not None and (found is None or found.size):
        site = with_context(site if found is None else site.keep(found), choice, links)
        holds = finite(site.values(choice.condition, choice.sources), choice.productions[0], "the condition") != 0
        holds = np.flatnonzero(np.broadcast_to(holds, site.rows[0].shape))
        found = holds if found is None else found[holds]
    return found


def context(site, choice, links):
    """Which modules of a site have the context of a choice."""
    found = np.arange(len(site.rows[0]))
    rows = [site.rows[0]]
    symbols = site.state.ended
    for origin, link, number, symbol in choice.nodes:
        table = links.branch[number] if link == "branch" else getattr(links, link)
        next_rows = table[rows[origin]]
        there = symbols[next_rows] == symbol
        found = found[there]
        rows = [each[there] for each in (*rows, next_rows)]
    return found


def with_context(site, choice, links):
    """The same modules with those of their context."""
    rows = list(site.rows[:1])
    for origin, link, number, _ in choice.nodes:
        table = links.branch[number] if link == "branch" else getattr(links, link)
        rows.append(table[rows[origin]])
    return Site(site.state, rows, site.moment)


def shared(site, choice):
    """The productions of a choice, each with the modules whose random number takes it."""
    if choice.always:
        if len(site.rows[0]):
            yield choice.templates[0], site
        return
    which = np.searchsorted(choice.bounds, site.even(0), side="right")
    for number, template in enumerate(choice.templates):
        chosen = np.flatnonzero(which == number)
        if chosen.size:
            yield template, site.keep(chosen)


def finite(values, production, what):
    """The values, or a refusal that says of which production they are."""
    if np.isfinite(np.sum(values)) or np.isfinite(values).all():
        return values
    wrong = np.ravel(values)[~np.isfinite(np.ravel(values))][0]
    where = f"line {production.line}: " if production.line else ""
    told = f"{where}{what} must be a finite number, got {wrong:g} for {production.predecessor}"
    raise ShapeError(told, "productions")
