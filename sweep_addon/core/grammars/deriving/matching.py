# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which production each module of a word takes, and what the parameters of its successor are."""

from math import isfinite

import numpy as np

from ...declared.parameters import ShapeError
from ...formulas.expressions import DRAW
from .draws import LEVELS, drawn, even
from .evaluating import BLOCK, values

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
    known : dict of (int, int) to (m,) float array
        Parameters by node and column, as far as they were asked for.
    """

    def __init__(self, state, rows, moment, known=()):
        self.state, self.rows, self.moment, self.known = state, rows, moment, dict(known)

    def keep(self, chosen):
        """Those of the modules that are chosen, by rising numbers."""
        if len(chosen) == len(self.rows[0]):
            return self
        return Site(self.state, {node: rows.take(chosen) for node, rows in self.rows.items()}, self.moment)

    def values(self, expression, sources, asking=False):
        """(m,) float array, or one number where it is the same for all: the value of a formula of parameters."""
        size = len(self.rows[0])

        def find(name, part):
            source = sources.get(name)
            if source is None:
                drawn = name.startswith(DRAW)
                return self.even(1 + int(name.removeprefix(DRAW)), part) if drawn else self.state.variables[name]
            if source in self.known:
                return self.known[source]
            node, column = source
            found = self.state.columns[column].take(self.rows[node][part])
            if size <= BLOCK:
                self.known[source] = found
            return found

        return values(expression, find, size, asking)

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
    site, matches = Site(state, {0: waiting}, moment), ()
    for choice, known in choices:
        if len(matches):
            others = np.ones(len(site.rows[0]), dtype=bool)
            others[matches] = False
            site = site.keep(others.nonzero()[0])
        if not len(site.rows[0]):
            return
        check()
        matches, found = matched(site, choice, links, known, check)
        if matches is None:
            yield from shared(found, choice)
            return
        if len(matches):
            yield from shared(found, choice)


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
        holds = answer(site.values(choice.condition, choice.sources, asking=True), choice, site, site.moment)
        if isinstance(holds, np.ndarray):
            holds = holds.nonzero()[0]
            return holds if found is None else found[holds], site.keep(holds) if len(holds) else site
        if not holds:
            return np.zeros(0, dtype=np.intp), site
    return found, site


def answer(value, choice, modules, moment):
    """Whether the condition of a choice holds: one that asks has answered, one that is a number must be finite."""
    if isinstance(value, (np.ndarray, np.bool_)) and value.dtype == np.bool_:
        return value
    return finite(value, choice.productions[0], "the condition", modules, moment) != 0


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
        found = linked(links, link, number, rows[origin])
        if node in choice.needed:
            kept[node] = found
        if choice.last[node]:  # whose neighbours are asked for too
            rows[node] = found
        if choice.last[origin] == node:
            del rows[origin]
    return Site(site.state, kept, site.moment, site.known)


def linked(links, link, number, rows):
    """(m,) int array: the neighbours of modules by a link, the so-manieth of a kind of which there are several."""
    return links.branch(number, rows) if link == "branch" else getattr(links, link).take(rows)


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
    if isfinite(np.add.reduce(values, axis=None)) or np.isfinite(values).all():
        return values
    wrong = np.flatnonzero(~np.isfinite(np.ravel(values)))[0]
    name, count = production.predecessor.symbol
    parameters = [f"{modules.parameter(column, wrong):g}" for column in range(count)]
    module = f"{name}({','.join(parameters)})" if parameters else name
    where = f"line {production.line}: " if production.line else ""
    got = f"{np.ravel(values)[wrong]:g} for {module} in step {moment // LEVELS}"
    told = f"{where}{what} must be a finite number, got {got}"
    raise ShapeError(told, "productions")
