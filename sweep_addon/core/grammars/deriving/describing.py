# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What kind of grammar a system is, how its words are derived, and how large they become."""

from ..text.modules import ENVIRONMENT, QUERIES
from .budget import ranged, sized
from .derivation import WAYS, strategy
from .growth import bounds, foretold
from .noting import notes


def kind(system):
    """The class of a system in the words of the book.

    Parameters
    ----------
    system : LSystem

    Returns
    -------
    str

    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> kind(LSystem.parse("axiom: F\\nF -> F[+F]F"))
    'bracketed D0L-system'
    >>> kind(LSystem.parse("axiom: A(1)A(2)\\nA(x) < A(y) : y > x -> A(y/2)"))
    'parametric 1L-system with conditions'
    """
    rules = [*system.productions, *(rule for _, group in (*system.groups, *system.systems) for rule in group)]
    sides = max((bool(rule.left) + bool(rule.right) for rule in rules), default=0)
    several = any(len(rule.left) > 1 or len(rule.right) > 1 for rule in rules)
    context = "(k,l)" if several else f"{sides}L" if sides else "0L"
    chance = any(rule.probability for rule in rules)
    words = [system.axiom, *(rule.successor for rule in rules)]
    modules = [module for word in words for module in word]
    said = ["parametric"] if any(module.parameters for module in modules) else []
    said += ["stochastic"] if chance else []
    names = {module.name for module in modules if module.parameters}
    said = (["environmentally sensitive"] if names.intersection(QUERIES) else []) + said
    said = (["open"] if ENVIRONMENT in names else []) + said
    said += ["bracketed"] if any(module.name == "[" for module in modules) else []
    said += ["table"] if system.groups else []
    plain = not chance and not sides and not any(rule.condition for rule in rules)
    said += [f"{'D' if plain else ''}{context}-system"]
    extra = ["conditions"] if any(rule.condition for rule in rules) else []
    extra += [section for section in ("decomposition", "homomorphism") if getattr(system, section)]
    return " ".join(said) + (f" with {' and '.join(extra)}" if extra else "")


def described(system, generations=None):
    """Lines about a system: its class, how it is derived, and its size.

    Parameters
    ----------
    system : LSystem
    generations : int, optional
        Else as many as its text says.

    Returns
    -------
    list of str
    """
    generations = system.generations if generations is None else generations
    tables = system.compiled
    sizes = foretold(tables, generations)
    if sizes and len(sizes) > generations:
        size = f"{sized(sizes[-1])} modules after {generations} generations"
    elif sizes:
        size = f"more than {sized(sizes[-1])} modules after {generations} generations"
    else:
        limits = bounds(tables, generations)
        said = f"{ranged(*limits)} modules" if limits else "not foretold"
        size = f"{said} after {generations} generations"
    return [
        f"class: {kind(system)}",
        f"productions: {sum(1 for _ in productions(system))}",
        f"derived: {WAYS[strategy(tables)]}",
        f"size: {size}",
        *features(tables),
        *map(turned, system.constants),
        *(f"note: {note}" for note in notes(system)),
    ]


def productions(system):
    """All productions, of every section."""
    yield from system.productions
    for _, group in (*system.groups, *system.systems):
        yield from group
    yield from system.decomposition
    yield from system.homomorphism


def turned(constant):
    """A line about a constant: its value, and what its slider goes from and to, in which unit, and means.

    >>> from sweep_addon.core.grammars import LSystem
    >>> turned(*LSystem.parse("#define a 45  # 0 .. 90 deg between branches\\naxiom: F").constants)
    'constant: a = 45 deg, 0 to 90: between branches'
    """
    said = f"constant: {constant.name} = {constant.value:.9g}"
    said += {"angle": " deg", "length": " m"}.get(constant.unit, "")
    said += f", {constant.low:.9g} to {constant.high:.9g}" if constant.low is not None else ""
    return said + (f": {constant.doc}" if constant.doc else "")


def features(tables):
    """Lines about what a system has beside productions."""
    system = tables.system
    if system.systems:
        yield f"sub-systems: {', '.join(str(number) for number, _ in system.systems)}"
    if tables.variables:
        yield f"variables: {', '.join(tables.variables)}"
    asked = list(dict.fromkeys(name for name, _ in tables.queries.values()))
    of_turtle = [name for name in asked if name != ENVIRONMENT]
    if of_turtle:
        yield f"asks: {', '.join(of_turtle)}, which a turtle answers after each step"
    if ENVIRONMENT in asked:
        yield f"asks: {ENVIRONMENT}, which an environment answers; that is a function of Python, and no file has one"
    yield from map(always, filter(chancy, productions(system)))
    if system.heading:
        yield f"heading: {system.heading}"


def chancy(rule):
    """Whether a condition is a fraction, by constants: it always holds, but reads like a probability."""
    return rule.condition is not None and not rule.condition.names and 0 < rule.condition.run({}) < 1


def always(rule):
    """A line about a condition that is a fraction.

    >>> from sweep_addon.core.grammars import LSystem
    >>> always(*LSystem.parse("#define p 0.4\\naxiom: A\\nA : p -> B").productions)
    'condition: p of A is 0.4, which always holds; a probability stands in the arrow: -(p)->'
    """
    text = rule.condition.text
    told = f"condition: {text} of {rule.predecessor} is {rule.condition.run({}):.9g}, which always holds"
    return f"{told}; a probability stands in the arrow: -({text})->"
