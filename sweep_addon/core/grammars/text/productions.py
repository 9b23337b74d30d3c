# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Productions as they are written: ``left < predecessor > right : condition -(probability)-> successor``."""

import re

from ...declared.frozen import altered, frozen
from ...formulas.expressions import GREEK, Expression
from .brackets import first_outside, last_outside
from .elsewhere import hint
from .modules import CLOSE, NAME, OPEN, Alphabet, Module, Pattern, paired, patterns, undeclared
from .passages import Passage, shown
from .vocabulary import draws, formula, value, words

ARROW, EMPTY = "->", "*"
ALWAYS = "*"  # the book's condition where there is none
ANY = "*"  # its context where there is none
NAMED = re.compile(rf"(?<![\w.])[A-Za-z_{GREEK}]", re.ASCII)  # the e of a number is no name
FRACTION = re.compile(r"\S\s*[01]?\.\d+$", re.ASCII)  # behind a module
LABEL = re.compile(r"(p_?\d+)\s*:", re.ASCII)  # as the book numbers its productions


@frozen
class Production:
    """A rule: which modules it replaces, where, when, how often, and by what.

    Attributes
    ----------
    predecessor : Pattern
    successor : tuple of Module
        Empty where the module vanishes.
    left, right : tuple of Pattern
        The context on both sides; brackets may hold what a lateral branch begins with.
    condition : Expression or None
    probability : Expression or None
        A constant.
    chance : float
        The value of the probability; 1 where there is none.
    line : int
        Where it stands in its text, from 1; it is no part of what the production is.
    """

    predecessor: Pattern
    successor: tuple[Module, ...]
    left: tuple[Pattern, ...] = ()
    right: tuple[Pattern, ...] = ()
    condition: Expression | None = None
    probability: Expression | None = None
    chance: float = 1.0
    line: int = 0

    def __str__(self):
        return self.told()

    def told(self, alphabet=None):
        """The production as text, in which an alphabet finds the same modules."""
        left, right, made = (told(word, alphabet) for word in (self.left, self.right, self.successor))
        condition = f" : {self.condition.text}" if self.condition else ""
        arrow = f"-({self.probability.text})->" if self.probability else ARROW
        return f"{headed(left, self.predecessor, right)}{condition} {arrow} {made or EMPTY}"


def headed(left, strict, right):
    """What is replaced, between its neighbours where it has some.

    >>> headed("A", "B", None), headed("", "B", "C")
    ('A < B', 'B > C')
    """
    return (f"{left} < " if left else "") + f"{strict}" + (f" > {right}" if right else "")


def told(modules, alphabet=None):
    """A word as text, with blanks where an alphabet would find other modules without.

    >>> system = ["a", "b", "ab"]
    >>> told(map(Module, system)), told(map(Module, system), Alphabet(["ab"]))
    ('abab', 'a b ab')
    """
    modules = list(modules)
    text = "".join(map(str, modules))
    letters = alphabet.letters(Passage(text, 0)) if alphabet else ()
    same = [letter.name for letter in letters] == [module.name for module in modules]
    if alphabet is None or same and not undeclared(text, letters)[1]:
        return text
    return " ".join(map(str, modules))


def production(passage: Passage, alphabet: Alphabet, constants, variables=()):
    """The production in a passage.

    Parameters
    ----------
    passage : Passage
    alphabet : Alphabet
    constants : dict of str to float
    variables : tuple of str
        Names that statements give values to.

    Returns
    -------
    Production

    Raises
    ------
    PassageError
        With the place of what is wrong in its line.

    Examples
    --------
    >>> print(production(Passage("BC<S>G[H]M:1<2-(0.5)->T(1 + 1)", 1), Alphabet(), {}))
    BC < S > G[H]M : 1<2 -(0.5)-> T(1+1)
    """
    rule, names = patterned(passage, alphabet, constants, variables)
    successor = passage.part(arrow(passage) + len(ARROW))
    if not successor.text:
        successor.refuse("a word, or * for the empty one")
    if successor.text == EMPTY:
        return rule
    drawn = draws(rule.condition.names) if rule.condition else 0
    return altered(rule, successor=alphabet.word(successor, names, words(constants), drawn)[0])


def patterned(passage, alphabet, constants, variables=()):
    """A production without its successor, and the names of the parameters that this may use."""
    at = arrow(passage)
    chance, stop = probability(passage, at - longer(passage.text[:at]), constants)
    head = passage.part(0, stop)
    label = LABEL.match(head.text)
    if label and label.group(1) not in alphabet.names:
        head = head.part(label.end())
    head, condition = split(head, ":")
    left, predecessor, right = around(head)
    if left is not None and left.text.startswith(OPEN):
        left.refuse("a module before '[', behind which the branch stands")
    left, right = contextual(left, alphabet), contextual(right, alphabet)
    strict = strict_predecessor(predecessor, alphabet)
    names = names_of([*left, strict, *right], head)
    names += tuple(name for name in variables if name not in names)
    if condition is not None and condition.text == ALWAYS:
        condition = None
    if condition is not None:
        condition = conditional(condition, names, constants)
    share = value(chance, words(constants, random=False)) if chance else 1.0
    if not 0 <= share <= 1:
        chance.refuse("a probability from 0 to 1", 0, f"{share:g}")
    said = formula(chance, (), words(constants, random=False)) if chance else None
    return Production(strict, (), left, right, condition, said, share, passage.number), names


def conditional(passage, names, constants):
    """The formula of a condition. A mere number always holds, but who writes one most likely means a probability; 0 and
    1 are how programs write never and always."""
    read = formula(passage, names, words(constants))
    if not NAMED.search(passage.text) and read.run({}) not in (0, 1):
        expected = "a condition that compares, for a probability stands in the arrow as -(0.4)->"
        passage.refuse(expected, 0, shown(passage.text))
    return read


def arrow(passage):
    """The place of the last arrow outside of brackets."""
    text = passage.text
    found = last_outside(text, ARROW)
    if found < 0:
        behind = unclosed(text)
        if behind is not None and ARROW in text[behind:]:
            passage.refuse("')' after it and before the arrow", behind, "'('")
        passage.refuse(f"a production with '->', or further right the rest of one{hint(text)}", 0, shown(text))
    return found


def unclosed(text):
    """The place of the first bracket that is never closed, or None.

    >>> unclosed("G(x) : x > (1 -> F")
    11
    """
    opened = []
    for at, letter in enumerate(text):
        if letter == "(":
            opened.append(at)
        elif letter == ")" and opened:
            opened.pop()
    return opened[0] if opened else None


def longer(head):
    """Whether the last minus before an arrow is part of it, ``-->``, since what could be replaced stands before it."""
    return head.endswith("-") and bool(head[:-1].strip()) and head[:-1].rstrip()[-1] not in "<>:"


def probability(passage, at, constants):
    """The passage of a probability before an arrow, or None; and where the head ends.

    A minus with one parameter can be a module too: it is where it is the predecessor, and where its parameter is a name
    that is no constant.
    """
    text = passage.text[:at].rstrip()
    start = opening(text)
    before = text[:start].rstrip() if start else ""
    if not before.endswith("-") or not before[:-1].strip() or before[:-1].rstrip()[-1] in "<>:":
        return None, at
    inside = passage.part(start + 1, len(text) - 1)
    if NAME.fullmatch(inside.text) and inside.text not in constants:
        return None, at
    return inside, len(before) - 1


def opening(text):
    """Where the bracket opens that closes at the end of a text; 0 where none does."""
    depth = 0
    for at in range(len(text) - 1, -1, -1) if text.endswith(")") else ():
        depth += (text[at] == ")") - (text[at] == "(")
        if not depth:
            return at
    return 0


def split(passage, sign):
    """What is before and after the first such sign outside of brackets; None where there is no such sign."""
    at = first_outside(passage.text, sign)
    return (passage, None) if at < 0 else (passage.part(0, at), passage.part(at + 1))


def around(head):
    """The passages of the left context, the predecessor and the right context; None where there is none."""
    left, rest = split(head, "<")
    if rest is None:
        left, rest = None, head
    strict, right = split(rest, ">")
    left, right = (None if part is not None and part.text == ANY else part for part in (left, right))
    for part in filter(None, (left, strict, right)):
        for sign in "<>":
            at = first_outside(part.text, sign)
            if at >= 0:
                part.refuse("one '<' and behind it one '>'", at)
        if not part.text and part is not strict:
            part.refuse("a module of the context")
    return left, strict, right


def contextual(passage, alphabet):
    """The modules of a context; brackets in it are in pairs and hold what branches begin with."""
    if passage is None:
        return ()
    letters = alphabet.letters(passage)
    paired(passage, letters)
    for letter, following in zip(letters, letters[1:], strict=False):
        if letter.name == OPEN and following.name in (OPEN, CLOSE):
            passage.refuse("the module that a branch begins with", following.at)
    return tuple(patterns(letters))


def strict_predecessor(passage, alphabet):
    found = patterns(alphabet.letters(passage))
    if not found:
        passage.refuse("a module to be replaced")
    if len(found) > 1:
        several = f"{shown(passage.text)}, which is {len(found)} modules"
        passage.refuse(f"one module to be replaced{meant(passage, found)}", 0, several)
    if found[0].name in (OPEN, CLOSE):
        passage.refuse("a module to be replaced, for brackets stay")
    if found[0].name == "?" and found[0].parameters:
        passage.refuse("a module to be replaced, for what begins a sub-system stays")
    return found[0]


def meant(passage, found):
    """What somebody may have meant who wrote several modules before an arrow."""
    if NAME.fullmatch(passage.text):
        return f"; a name of several letters is declared: #names {passage.text}"
    if FRACTION.search(passage.text):
        return f"; a probability stands in the arrow: {found[0].name} -(0.5)-> ..."
    if found[-1].name == "-" and found[-1].parameters:
        name = found[-1].parameters[0]
        return f"; a probability is a constant, no parameter: #define {name} 0.5"
    return ""


def names_of(found, head):
    """The names of all parameters in reading order, each once."""
    names = {}
    for name in (name for pattern in found for name in pattern.parameters):
        if name in names:
            head.refuse("each name for one parameter", head.text.rfind(name), shown(name))
        names[name] = None
    return tuple(names)
