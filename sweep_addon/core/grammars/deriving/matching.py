# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which production each module of a word takes, and what the parameters of its successor are."""

import numpy as np

from ...declared.parameters import ShapeError
from ...formulas.expressions import DRAW
from .draws import LEVELS, drawn, even
from .evaluating import values

FEW = 32  # kinds of modules, each of which is searched for by itself


class Site:
    """Some modules of a word that may take a production, with the modules of their context.

    Parameters
    ----------
    state : State
    rows : dict of int to (m,) int array
        The places of the predecessors, node 0, and of those nodes of the context whose parameters are asked for.
    moment : int
        The step that is made, for random numbers.
    """

    def __init__(self, state, rows, moment):
        self.state, self.rows, self.moment = state, rows, moment

    def keep(self, chosen):
        """Those of the modules that are chosen."""
        return Site(self.state, {node: rows[chosen] for node, rows in self.rows.items()}, self.moment)

    def values(self, expression, sources):
        """(m,) float array, or one number where it is the same for all: the value of a formula of parameters."""

        def find(name, part):
            if name.startswith(DRAW):
                return self.even(1 + int(name.removeprefix(DRAW)), part)
            if name not in sources:
                return self.state.variables[name]
            node, column = sources[name]
            return self.state.columns[column][self.rows[node][part]]

        return values(expression, find, len(self.rows[0]))

    def parameter(self, column, place):
        """A parameter of one of the modules that are replaced."""
        return self.state.columns[column][self.rows[0][place]]

    def even(self, draw, part=slice(None)):
        """(m,) float array: random numbers of these modules, or of a part."""
        return even(self.state.keys[self.rows[0][part]], self.moment, draw)


def taken(state, rules, among, moment, links, check):
    """The productions that modules of a word take.

    Parameters
    ----------
    state : State
    rules : Rules
    among : (n,) bool array or None
        Which modules they replace; None for all of them.
    moment : int
    links : Neighbours or None
        Of the word, where a production has a context.
    check : callable
        Called now and then; it may refuse to go on.

    Yields
    ------
    Template
    Site
        The modules that it replaces.
    """
    for symbol, places in parted(state.symbols, rules.choices):
        waiting = places if state.fresh is None else places[state.fresh[places]]
        waiting = waiting if among is None else waiting[among[waiting]]
        yield from tried(state, waiting, [(choice, False) for choice in rules.choices[symbol]], moment, links, check)


def parted(symbols, kinds):
    """The places in a word of the modules of each of some kinds, of those that are there."""
    here = np.bincount(symbols) if len(symbols) else ()
    present = [symbol for symbol in kinds if symbol < len(here) and here[symbol]]
    if len(present) <= FEW:
        yield from ((symbol, np.flatnonzero(symbols == symbol)) for symbol in present)
        return
    order, stops = np.argsort(symbols, kind="stable"), np.cumsum(here)
    yield from ((symbol, order[stops[symbol] - here[symbol] : stops[symbol]]) for symbol in present)


def tried(state, waiting, choices, moment, links, check):
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
    check : callable

    Yields
    ------
    Template
    Site
        The modules that it replaces.
    """
    for choice, known in choices:
        if not waiting.size:
            return
        check()
        matches, site = matched(Site(state, {0: waiting}, moment), choice, links, known, check)
        if matches is None:
            waiting = waiting[:0]
        elif matches.size:
            still = np.ones(len(waiting), dtype=bool)
            still[matches] = False
            waiting = waiting[still]
        else:
            continue
        yield from shared(site, choice)


def matched(site, choice, links, known, check):
    """Which modules of a site match context and condition, None for all of them; and these with their context."""
    found = None
    if choice.nodes and not known:
        found = context(site, choice, links, check)
        site = site.keep(found)
    if found is not None and not found.size:
        return found, site
    if choice.needed:
        site = with_context(site, choice, links)
    if choice.condition is not None:
        holds = (
            finite(
                site.values(choice.condition, choice.sources), choice.productions[0], "the condition", site, site.moment
            )
            != 0
        )
        if np.ndim(holds) or not holds:
            holds = np.flatnonzero(holds)  # of one number that is 0, nothing
            found, site = holds if found is None else found[holds], site.keep(holds)
    return found, site


def context(site, choice, links, check):
    """Which modules of a site have the context of a choice."""
    found, rows = np.arange(len(site.rows[0])), {0: site.rows[0]}
    symbols = site.state.ended
    for node, (origin, link, number, symbol) in enumerate(choice.nodes, 1):
        check()
        rows[node] = linked(links, link, number, rows[origin])
        there = symbols[rows[node]] == symbol
        rows = {other: each for other, each in rows.items() if choice.last[other] > node}
        if not there.all():
            found, rows = found[there], {other: each[there] for other, each in rows.items()}
        if not found.size:
            break
    return found


def with_context(site, choice, links):
    """The same modules with those of their context whose parameters are asked for."""
    rows, kept = {0: site.rows[0]}, {0: site.rows[0]}
    for node, (origin, link, number, _) in enumerate(choice.nodes[: max(choice.needed, default=0)], 1):
        rows[node] = linked(links, link, number, rows[origin])
        if node in choice.needed:
            kept[node] = rows[node]
        rows = {other: each for other, each in rows.items() if choice.last[other] > node}
    return Site(site.state, kept, site.moment)


def linked(links, link, number, rows):
    """(m,) int array: the neighbours of modules by a link, the so-manieth of a kind of which there are several."""
    return links.branch(number, rows) if link == "branch" else getattr(links, link)[rows]


def shared(site, choice):
    """The productions of a choice, each with the modules whose random number takes it."""
    if choice.always:
        if len(site.rows[0]):
            yield choice.templates[0], site
        return
    which = drawn(choice.bounds, site.even(0))
    for number, template in enumerate(choice.templates):
        chosen = np.flatnonzero(which == number)
        if chosen.size:
            yield template, site.keep(chosen)


def finite(values, production, what, modules, moment):
    """The values, or a refusal that says of which production, module and step they are.

    Parameters
    ----------
    values : (m,) float array or float
    production : Production
    what : str
        What the values are.
    modules : Site or Chunk
        Those that are replaced.
    moment : int
    """
    if np.isfinite(np.add.reduce(values, axis=None)) or np.isfinite(values).all():
        return values
    wrong = np.flatnonzero(~np.isfinite(np.ravel(values)))[0]
    name, count = production.predecessor.symbol
    parameters = [f"{modules.parameter(column, wrong):g}" for column in range(count)]
    module = f"{name}({','.join(parameters)})" if parameters else name
    where = f"line {production.line}: " if production.line else ""
    got = f"{np.ravel(values)[wrong]:g} for {module} in step {moment // LEVELS}"
    told = f"{where}{what} must be a finite number, got {got}"
    raise ShapeError(told, "productions")
