# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which production each module of a word takes, and what the parameters of its successor are."""

from math import isfinite

import numpy as np

from ...declared.parameters import ShapeError
from ...formulas.expressions import DRAW
from .draws import LEVELS, drawn, even
from .evaluating import BLOCK, PREDECESSOR

FEW = 4  # kinds of modules, each of which is searched for whether there are any or not
MORE = 32  # of which there are some, each of which is searched for by itself


class Site:
    """Some modules of a word that may take a production, and what is known of them and of their neighbours.

    Parameters
    ----------
    state : State or Pool
    places : (m,) int array
        Those of the modules in the word, or their numbers in the pool.
    moment : int
        The step that is made, for random numbers.
    links : Neighbours, Pool or None
        Of the word, where a production has a context.
    """

    def __init__(self, state, places, moment, links=None):
        self.state, self.places, self.moment, self.links = state, places, moment, links
        self.size, self.rows, self.known = len(places), {PREDECESSOR: places}, {}

    def keep(self, chosen):
        """Those of the modules that are chosen, by rising numbers."""
        if len(chosen) == self.size:
            return self
        return Site(self.state, self.places.take(chosen), self.moment, self.links)

    def row(self, path):
        """(m,) int array: the places of the modules of a context to which a path leads, where its modules are there."""
        if path not in self.rows:
            steps, at = [], path
            while at not in self.rows:
                steps.append(at)
                at = at.origin
            found = self.rows[at]
            for step in reversed(steps):
                found = linked(self.links, step.link, step.number, found)
            self.rows[path] = found
        return self.rows[path]

    def values(self, formula, asking=False):
        """(m,) float array, or one number where it is the same for all: the value of a formula."""
        if self.size > BLOCK or formula.called:
            return formula.of(self.found, self.size, asking)
        known = self.known
        return formula.run([known[each] if each in known else self.value(each) for each in formula.sources], asking)

    def value(self, source):
        """The value of a source, which is kept where it is a parameter."""
        found = self.found(source)
        if isinstance(source, tuple):
            self.known[source] = found
        return found

    def found(self, source, part=slice(None)):
        """The value of a source for a part of the modules."""
        if isinstance(source, tuple):
            path, column = source
            return self.state.columns[column].take(self.row(path)[part])
        if source.startswith(DRAW):
            return self.even(1 + int(source.removeprefix(DRAW)), part)
        return self.state.variables[source]

    def parameter(self, column, place):
        """A parameter of one of the modules that are replaced."""
        return self.state.columns[column][self.places[place]]

    def even(self, draw, part=slice(None)):
        """(m,) float array: random numbers of these modules, or of a part."""
        return even(self.state.keys[self.places[part]], self.moment, draw)


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
        choices = [(choice, False) for choice in rules.choices[symbol]]
        yield from tried(Site(state, waiting, moment, links), choices, check)


def parted(symbols, kinds):
    """The places in a word of the modules of each of some kinds, of those that are there."""
    if len(kinds) <= FEW:
        for symbol in kinds:
            places = (symbols == symbol).nonzero()[0]
            if len(places):
                yield symbol, places
        return
    here = np.bincount(symbols) if len(symbols) else ()
    present = [symbol for symbol in kinds if symbol < len(here) and here[symbol]]
    if len(present) <= MORE:
        yield from ((symbol, np.flatnonzero(symbols == symbol)) for symbol in present)
        return
    order, stops = np.argsort(symbols, kind="stable"), np.cumsum(here)
    yield from ((symbol, order[stops[symbol] - here[symbol] : stops[symbol]]) for symbol in present)


def tried(site, choices, check):
    """The productions that modules take, of some in their order.

    Parameters
    ----------
    site : Site
    choices : list of (Choice, bool)
        What they may take, and whether their contexts are known to match.
    check : callable

    Yields
    ------
    Template
    Site
        The modules that it replaces.

    Returns
    -------
    Site or None
        The modules that take none of them.
    """
    for choice, known in choices:
        if not site.size:
            return None
        check()
        matches, found = matched(site, choice, known, check)
        if matches is None:
            yield from shared(found, choice)
            return None
        if len(matches):
            yield from shared(found, choice)
            others = np.ones(site.size, dtype=bool)
            others[matches] = False
            site = site.keep(others.nonzero()[0])
    return site


def matched(site, choice, known, check):
    """Which modules of a site match context and condition, None for all of them; and these."""
    found = None
    if choice.nodes and not known:
        found = context(site, choice, check)
        site = site.keep(found)
        if not site.size:
            return found, site
    if choice.condition is not None:
        holds = answer(site.values(choice.condition, asking=True), choice, site, site.moment)
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
    if not sound(value):
        refuse(value, choice.productions[0], "the condition", modules, moment)
    return value != 0


def context(site, choice, check):
    """Which modules of a site have the context of a choice."""
    found, rows = np.arange(site.size), {0: site.places}
    symbols = site.state.ended
    for node, (origin, link, number, symbol) in enumerate(choice.nodes, 1):
        check()
        rows[node] = linked(site.links, link, number, rows[origin])
        there = symbols[rows[node]] == symbol
        rows = {other: each for other, each in rows.items() if choice.last[other] > node}
        if not there.all():
            found, rows = found[there], {other: each[there] for other, each in rows.items()}
        if not found.size:
            break
    return found


def linked(links, link, number, rows):
    """(m,) int array: the neighbours of modules by a link, the so-manieth of a kind of which there are several."""
    return links.branch(number, rows) if link == "branch" else getattr(links, link).take(rows)


def shared(site, choice):
    """The productions of a choice, each with the modules whose random number takes it."""
    if choice.always:
        if site.size:
            yield choice.templates[0], site
        return
    which = drawn(choice.bounds, site.even(0))
    for number, template in enumerate(choice.templates):
        chosen = np.flatnonzero(which == number)
        if chosen.size:
            yield template, site.keep(chosen)


def sound(values):
    """Whether all values are finite."""
    return isfinite(np.add.reduce(values, axis=None)) or np.isfinite(values).all()


def refuse(values, production, what, modules, moment):
    """Refuse values that are not all finite, and say of which production, module and step they are.

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
    wrong = np.flatnonzero(~np.isfinite(np.ravel(values)))[0]
    name, count = production.predecessor.symbol
    parameters = [f"{modules.parameter(column, wrong):g}" for column in range(count)]
    module = f"{name}({','.join(parameters)})" if parameters else name
    where = f"line {production.line}: " if production.line else ""
    got = f"{np.ravel(values)[wrong]:g} for {module} in step {moment // LEVELS}"
    told = f"{where}{what} must be a finite number, got {got}"
    raise ShapeError(told, "productions")
