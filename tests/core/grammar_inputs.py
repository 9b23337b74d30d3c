# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Random grammars, as text."""

from hypothesis import strategies as st

ARITY = {"A": 0, "B": 1, "C": 2, "F": 0, "+": 0, "-": 0, "%": 0, "f": 1}
PARTS = ["A(1)", "A(2)", "A(3)", "B", "+", "[A(2)]", "[B+A(1)B]"]
NAMES = "abcdghijklmnopqrstuvwxyz"  # of parameters: f is a module, and e a number
LETTERS = [letter for letter in ARITY if letter != "%"]
CONDITIONS = ["{0} > 1", "{0} < 2 || {0} > 3", "!({0} == 1)", "ran(1) < 0.5", "1"]
VALUES = ["1", "2", "0.5", "{0} + 1", "{0}/2", "2*{0} - {0}^2/4", "ran({0})", "nran(1, 0.5)"]


def letters(draw, names, count, parameters):
    """So many modules, each with the parameters that it takes."""
    return "".join(parameters(draw, draw(st.sampled_from(names))) for _ in range(count))


def formulas(known, stochastic):
    """Writes modules whose parameters are formulas of known names."""
    values = VALUES if stochastic else VALUES[:-2]

    def written(draw, letter):
        told = [draw(st.sampled_from(values)).format(draw(st.sampled_from(known))) for _ in range(ARITY[letter])]
        return f"{letter}({','.join(told)})" if told else letter

    return written


def word(draw, parameters, depth=2, cut=False):
    """A word with branches."""
    parts = []
    for _ in range(draw(st.integers(0, 4))):
        if depth and draw(st.integers(0, 3)) == 0:
            parts.append(f"[{word(draw, parameters, depth - 1, cut)}]")
        else:
            parts.append(parameters(draw, draw(st.sampled_from(list(ARITY) if cut else LETTERS))))
    return "".join(parts)


@st.composite
def sectioned(draw):
    """The text of a grammar with groups, a decomposition and a homomorphism."""
    lines, others = (draw(told).split("\n") for told in (grammars(), grammars(stochastic=False)))
    rules = [line for line in (*lines, *others) if "->" in line]
    sections = {name: [] for name in ("", "group 1:", "group 3:", "decomposition:", "homomorphism:")}
    for rule in rules:
        sections[draw(st.sampled_from(list(sections)))].append(rule)
    told = [draw(st.sampled_from(["", "", "#groups 3 1 ...", "#groups 1*2 3", "#groups 7 1"]))]
    told += [line for line in lines if "->" not in line]
    for name, each in sections.items():
        depth = (
            [f"maximum depth: {draw(st.integers(0, 3))}"] if name[:1] in ("d", "h") and draw(st.integers(0, 3)) else []
        )
        told += [name, *depth, *each] if each else []
    return "\n".join(filter(None, told))


@st.composite
def grammars(draw, context=True, stochastic=True, cut=True, axial=False):
    """The text of a grammar whose words stay small for a few generations.

    In an axial one successors keep a seen module on their axis, and ignored modules become ignored ones alone.
    """
    lines, shared, ignored = [], set(), ""
    if context:
        ignoring = draw(st.sampled_from(["", "#ignore + -", "#ignore f +", "#consider A B C F"]))
        ignored = ignoring.partition(" ")[2] if "ignore" in ignoring else "+-f%" * bool(ignoring)
        lines.append(ignoring)
    start = [word(draw, formulas(["2"], stochastic), cut=cut) for _ in range(3)]
    lines.append(f"axiom: A{start[0]}F{start[1]}[A{start[2]}]B(1)")
    for _ in range(draw(st.integers(1, 6))):
        fresh = iter(NAMES)

        def named(draw, letter, fresh=fresh):
            names = [next(fresh) for _ in range(ARITY[letter])]
            return f"{letter}({','.join(names)})" if names else letter

        sides, known = ["", "", ""], []
        strict = draw(st.sampled_from(LETTERS))
        sides[1], sees = named(draw, strict), context and not (axial and strict in ignored)
        if sees and draw(st.booleans()):
            sides[0] = letters(draw, LETTERS, draw(st.integers(1, 2)), named)
            for _ in range(draw(st.integers(-2, 0 if axial else 2))):
                sides[0] += f"[{letters(draw, LETTERS, draw(st.integers(1, 2)), named)}]"
            sides[0] += letters(draw, LETTERS, draw(st.integers(0, 1)), named)
        if sees and draw(st.booleans()):
            sides[2] = letters(draw, LETTERS, draw(st.integers(0, 1)), named)
            for _ in range(draw(st.integers(0, 0 if axial else 2))):
                sides[2] += f"[{letters(draw, LETTERS, 1, named)}]"
            sides[2] += letters(draw, LETTERS, draw(st.integers(0 if sides[2] else 1, 1)), named)
        known = sorted({letter for side in sides for letter in side if letter in NAMES}) or ["3"]
        head = f"{sides[0]} < " * bool(sides[0]) + sides[1] + f" > {sides[2]}" * bool(sides[2])
        if draw(st.booleans()):
            conditions = CONDITIONS if stochastic else CONDITIONS[:3]
            head += f" : {draw(st.sampled_from(conditions)).format(draw(st.sampled_from(known)))}"
        made = [word(draw, formulas(known, stochastic), 1, cut) for _ in range(2)]
        if axial and strict in ignored:
            made = [letters(draw, [strict], len(one) % 3, formulas(known, stochastic)) for one in made]
        elif axial:
            made = [f"{one}A{draw(st.sampled_from(['', '[F]']))}" for one in made]
        made = [one or "*" for one in made]
        if stochastic and head not in shared and draw(st.booleans()):
            shared.add(head)
            lines += [f"{head} -(0.4)-> {made[0]}", f"{head} -(0.35)-> {made[1]}"]
        else:
            lines.append(f"{head} -> {made[0]}")
    return "\n".join(filter(None, lines))


@st.composite
def crowded(draw):
    """The text of a grammar in which a module has many productions: what it tries hangs on its neighbours."""

    def one_of(*told):
        return draw(st.sampled_from(told))

    lines = [one_of("", "#ignore +"), f"axiom: A(2){''.join(draw(st.lists(st.sampled_from(PARTS), max_size=8)))}A(1)"]
    for _ in range(draw(st.integers(2, 8))):
        left, right = one_of("", "A(y) < ", "B < ", "BA(y) < "), one_of("", " > A(z)", " > B")
        known = ["x", *("y" * ("y" in left)), *("z" * ("z" in right))]
        condition = one_of("", "", " : x > 1", " : x < 3", " : x == 2", " : {0} - x", " : x + 1 < 2*{0}")
        made = one_of("A(x+1)", "A(x-1)B", "BA({0})", "[A({0})]A(x)", "A({0}/2)+A(x)", "A({0})B", "A(x,x)B")
        lines.append(f"{left}A(x){right}{condition} -> {made}".format(draw(st.sampled_from(known))))
    lines.append(one_of("", "A(x) < B > A(z) -> A(x-z)", "B > B -> B[A(1)]\nB > A(x) : x > 2 -> AB"))
    return "\n".join(filter(None, lines))
