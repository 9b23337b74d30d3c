# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of a grammar, line by line, as a system; every line that is wrong is told of."""

import re
from dataclasses import fields
from math import isfinite, nan

from ...declared.hints import meant
from ...declared.parameters import ShapeError, require
from ...declared.refusals import MOST, together
from ...declared.wording import named
from ..deriving.statements import MOST_VARIABLES, assigned, statements
from ..dialects import OTHERS, placed, translated
from . import directives
from .constants import constants
from .directives import MOST_GENERATIONS, MOST_NAMES, directive
from .elsewhere import hint
from .going_on import AXIOM, SECTION, blocked, joined
from .grouping import check_probabilities
from .modules import NAME, Alphabet
from .passages import ENDED, Passage, PassageError, shown
from .printed import legend, typed
from .problems import GrammarError, Problem
from .productions import ARROW, production
from .vocabulary import value, without_degree, words

LONGEST = 1_000_000  # characters of a text
MOST_LINES = 20_000
MOST_PROBLEMS = 200  # before the rest of a text is left unread
DEPTH = 100  # levels of a decomposition or a homomorphism, where the text says nothing
AXIOM_WORD = re.compile(r"axiom\b", re.IGNORECASE)
CONTROL = re.compile(r"[\x00-\x08\x0a-\x1f\x7f]")  # but tabs
BREAK = re.compile(r"\r\n|\r|\n")


class Reader:
    """Reads one text: first what all lines need, names and constants, and then the lines."""

    def __init__(self, text, given):
        self.problems, self.told, self.following, self.rules = [], {}, {}, []
        lines = list(enumerate(map(typed, BREAK.split(text.removeprefix("\ufeff"))), 1))
        self.last = lines[-1]
        self.given = given
        self.lines = joined([found for line in lines if (found := self.attempt(self.parted, *reversed(line)))])

    def attempt(self, act, *told):
        """What reading a line gives, or nothing where it is wrong."""
        try:
            return act(*told)
        except PassageError as wrong:
            if wrong.problem not in self.problems:  # lines of statements are read twice
                self.problems.append(wrong.problem)
            if len(self.problems) > MOST_PROBLEMS:
                raise GrammarError(self.problems) from None

    def refuse(self, expected, found, passage):
        """Refuse the whole text for how many of something there are up to a passage."""
        try:
            passage.refuse(expected, 0, f"{len(found):,}")
        except PassageError as wrong:
            raise GrammarError([*self.problems, wrong.problem]) from None

    def parted(self, line, number):
        """A line as the word of its directive, or nothing, its passage without comment, and the comment."""
        found = directive(line, number)
        word, passage = found if found else ("", Passage(line, number))
        start = passage.start
        code, mark, comment = line[start:].partition("#")
        passage = Passage(line, number, start, start + len(code))
        control = CONTROL.search(code)
        if control:
            Passage(line, number, start + control.start()).refuse("text", 0, f"the character {ord(control.group())}")
        return (word, passage, comment.strip()) if word or passage.text else None

    def read(self):
        """The parts of the system, by their names."""
        names = [name for passage, _ in self.told_of("names") for name in self.attempt(directives.names, passage) or ()]
        self.told["names"] = tuple(dict.fromkeys(name for name in names if len(name) > 1))
        if len(names) > MOST_NAMES:
            self.refuse(f"at most {MOST_NAMES:,} names", names, self.told_of("names")[-1][0])
        self.alphabet = Alphabet(self.told["names"])
        self.told["constants"], problems = constants(self.told_of("define"), self.given)
        self.problems += problems
        self.constants = {constant.name: constant.value for constant in self.told["constants"]}
        unknown = [name for name in self.given if name not in self.constants]
        if unknown and not problems:
            known = ", ".join(self.constants) or "none"
            said = f"is no constant of the text, which has {known}"
            raise together(
                ShapeError(said + meant(self.constants, name), f"constants.{named(name)}") for name in unknown[:MOST]
            )
        self.vocabulary = words(self.constants, random=False)
        self.variables = self.assigned()
        for word, passage, _ in self.lines:
            if word:
                self.attempt(getattr(self, f"tell_{word}", self.number), passage, word)
        self.section, self.unnamed = ("productions", 0), self.unnamed_axiom()
        for word, passage, _ in self.lines:
            if not word:
                self.attempt(self.line, passage)
        if "axiom" not in self.told:
            number, line = self.last
            self.problems.append(Problem(number, len(line) + 1, ENDED, "a line 'axiom: ...' in the text", line))
        check_probabilities(self.rules, self.problems, self.lines)
        if self.problems:
            raise GrammarError(self.problems)
        return self.told | self.sections() | {"following": tuple(self.following.values())}

    def unnamed_axiom(self):
        """The passage that is the axiom though nothing says so: the first line above productions, as under a figure."""
        lines = [passage for word, passage, _ in self.lines if not word and passage.text and not legend(passage.text)]
        named = any((match := SECTION.match(passage.text)) and match[1].lower() in AXIOM for passage in lines)
        if named or not any(ARROW in passage.text for passage in lines[1:]):
            return None
        first = lines[0]
        known = SECTION.match(first.text) or blocked(first) or hint(first.text) or AXIOM_WORD.match(first.text)
        return None if known or ARROW in first.text else first

    def assigned(self):
        """The variables that statements somewhere give values to."""
        found = {}
        for word, passage, _ in self.lines:
            block = not word and blocked(passage)
            if block:
                found |= dict.fromkeys(name for name, _ in self.attempt(assigned, passage.part(block.end())) or ())
            if len(found) > MOST_VARIABLES:
                self.refuse(f"at most {MOST_VARIABLES:,} variables", found, passage)
        return tuple(found)

    def told_of(self, word):
        """The passages and comments of a directive."""
        return [(passage, comment) for other, passage, comment in self.lines if other == word]

    def tell_names(self, passage, word):
        """They are told before."""

    tell_define = tell_names

    def tell_dialect(self, passage, word):
        if passage.text not in directives.DIALECTS:
            known = ", ".join((*directives.DIALECTS, *OTHERS))
            passage.refuse(f"one of the dialects {known}", 0, shown(passage.text))
        self.told["dialect"] = passage.text

    def tell_ignore(self, passage, word):
        other = {"ignore": "consider", "consider": "ignore"}[word]
        if other in self.told:
            passage.refuse("either #ignore or #consider", 0, "both")
        self.told[word] = self.told.get(word, ()) + directives.ignored(passage, self.alphabet)

    tell_consider = tell_ignore

    def tell_generations(self, passage, word):
        self.tell(passage, word, directives.whole(passage, self.vocabulary, MOST_GENERATIONS))

    def tell_seed(self, passage, word):
        self.tell(passage, word, directives.whole(passage, self.vocabulary, directives.LARGEST_SEED))

    def tell_tropism(self, passage, word):
        told = directives.numbers(passage, self.vocabulary, 4, "a direction and the susceptibility")
        if not any(told[:3]):
            passage.refuse("a direction that is not 0", 0, shown(passage.text))
        self.tell(passage, word, told)

    def tell_heading(self, passage, word):
        self.told[word] = directives.heading(passage)

    def tell_groups(self, passage, word):
        self.told["schedule"] = directives.schedule(passage)

    def tell_angle(self, passage, word):
        self.number(without_degree(passage), word)

    def tell_width(self, passage, word):
        if value(passage, self.vocabulary) < 0:
            passage.refuse("a diameter of at least 0", 0, shown(passage.text))
        self.number(passage, word)

    def number(self, passage, word):
        self.tell(passage, word, value(passage, self.vocabulary))

    def tell(self, passage, word, told):
        """What a directive says, and as which formula if it needs constants."""
        self.told[word] = told
        self.following.pop(word, None)
        if not self.constants.keys().isdisjoint(NAME.findall(passage.text)):
            self.following[word] = (word, told, passage.text)

    def line(self, passage):
        """A line that is no directive: a section, the axiom or a production."""
        block = blocked(passage)
        if block:
            word = block.group(1).lower().replace(" ", "_")
            made = statements(passage.part(block.end()), self.variables, self.constants)
            self.told[word] = self.told.get(word, ()) + made
            return None
        match, printed = SECTION.match(passage.text), legend(passage.text)
        if passage is self.unnamed:
            return self.tell_axiom(passage)
        if match:
            passage = self.sectioned(match, passage)
        if printed:
            return self.legend(passage, *printed)
        if passage and passage.text:
            self.rules.append((self.section, production(passage, self.alphabet, self.constants, self.variables)))

    def legend(self, passage, generations, angle):
        """The line under a figure of a book."""
        for word, found in (("generations", generations), ("angle", angle)):
            if found is not None:
                start = passage.text.index(found)
                self.attempt(getattr(self, f"tell_{word}", self.number), passage.part(start, start + len(found)), word)

    def tell_axiom(self, passage):
        """The modules of the axiom."""
        self.told["axiom"] = ()  # there is one, right or wrong
        self.told["axiom"], _ = self.alphabet.word(passage, self.variables, words(self.constants))

    def sectioned(self, match, passage):
        """What is left of a line that begins with the name of a section."""
        kind, *number = match.group(1).lower().replace("interpretation", "homomorphism").split()
        rest = passage.part(match.end())
        if kind in AXIOM:
            if "axiom" in self.told:
                passage.refuse("one axiom", 0, "a second one")
            if not rest.text:
                rest.refuse("the modules of the axiom")
            return self.tell_axiom(rest)
        if kind == "maximum":
            if self.section[0] not in ("decomposition", "homomorphism"):
                passage.refuse("decomposition: or homomorphism: above a depth", 0, shown(match.group()))
            self.told[f"{self.section[0]}_depth"] = directives.whole(rest, self.vocabulary, DEPTH)
            return None
        self.section = (kind, int(number[0])) if number else (kind, 0)
        return rest

    def sections(self):
        """The productions of each section."""
        kinds = {section: [] for section, _ in self.rules}
        for section, rule in self.rules:
            kinds[section].append(rule)
        groups, systems = (
            tuple(sorted((number, tuple(rules)) for (kind, number), rules in kinds.items() if kind == word))
            for word in ("group", "lsystem")
        )
        named = {kind: tuple(kinds.get((kind, 0), ())) for kind in ("productions", "decomposition", "homomorphism")}
        return named | {"groups": groups, "systems": systems}


def numbers(given):
    """The values of constants, each a finite number."""
    require(given is None or isinstance(given, dict), "must be a dict of names and numbers", given, "constants")
    found = {}
    for name, told in (given or {}).items():
        try:
            found[name] = nan if isinstance(told, (str, bytes)) else float(told)
        except (TypeError, ValueError, OverflowError):
            found[name] = nan
        require(isfinite(found[name]), f"must have a finite number for {name!r}", told, "constants")
    return found


def check_length(text):
    """Refuse a text that is too long, where it begins to be."""
    lines = 1 + text.count("\n") + text.count("\r") - text.count("\r\n")
    if len(text) <= LONGEST and lines <= MOST_LINES:
        return
    allowed = BREAK.split(text[:LONGEST], MOST_LINES)
    number, column, source = len(allowed), len(allowed[-1]) + 1, allowed[-1]
    if number > MOST_LINES:
        column, source = 1, BREAK.split(source, 1)[0]
    most, found = f"at most {LONGEST:,} characters in {MOST_LINES:,} lines", f"{len(text):,} in {lines:,}"
    raise GrammarError([Problem(number, column, found, most, source)])


def read(kind, text, given):
    """The system that a text describes.

    Parameters
    ----------
    kind : class
        LSystem.
    text : str
    given : dict of str to float or None
        Values of constants that stand for those of the text.

    Raises
    ------
    GrammarError
        With every line that is wrong, up to 200.
    """
    require(isinstance(text, str), "must be text", text, "text")
    check_length(text)
    try:
        told = Reader(translated(text), numbers(given)).read()
    except GrammarError as refusal:
        raise placed(refusal, text) from None
    assert told.keys() <= {field.name for field in fields(kind)}
    return kind(**told)
