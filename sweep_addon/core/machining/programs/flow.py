# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The flow of a program: which line of a subroutine, branch or loop leads to which, found before it runs."""

import re
from dataclasses import dataclass, field

from ...declared.refusals import ShapeError
from .blocks import bare, block
from .lines import at_line

FLOW = re.compile(r"(?:n[\d.]+)?o")
LABELLED = re.compile(r"(?:n[\d.]+)?o(?:<([^>]+)>|(\d+))", re.ASCII)
DEEPEST = 100  # loops and branches within each other
LOOPS = ("repeat", "while", "do")
CLOSED_BY = {"if": "endif", "repeat": "endrepeat", "while": "endwhile", "do": "while", "sub": "endsub"}


@dataclass
class Construct:
    """A subroutine, branch or loop: its word, its label, and the lines of its parts in their order."""

    keyword: str
    label: object
    lines: list

    @property
    def end(self):
        return self.lines[-1]


@dataclass
class Flow:
    """What each line of the flow is part of, and where subroutines begin."""

    constructs: dict = field(default_factory=dict)  # line -> Construct
    subs: dict = field(default_factory=dict)  # label -> Construct
    around: dict = field(default_factory=dict)  # line of break or continue -> the loops around it, from the outermost
    labels: dict = field(default_factory=dict)  # label -> line, of programs in the manner of Fanuc


def linked(lines):
    """Find what belongs together among the lines of a program: a `Flow`."""
    flow, opened = Flow(), []
    for line, text in enumerate(lines):
        if ("o" in text or "O" in text) and FLOW.match(bare(text)):  # few lines need their comments taken out
            with at_line(line):
                link(flow, opened, line, text)
    if opened:
        with at_line(opened[-1].lines[0]):
            raise ShapeError(f"begins {opened[-1].keyword}, which does not end: {CLOSED_BY[opened[-1].keyword]}")
    return flow


def link(flow, opened, line, text):
    said = block(text)
    if said.keyword is None:
        return
    if said.keyword in ("break", "continue"):
        flow.around[line] = [construct for construct in opened if construct.keyword in LOOPS]
    if said.keyword in ("call", "return", "break", "continue"):
        return
    label = static(text)
    if said.keyword == "label":
        flow.labels.setdefault(label, line)
        return
    inside = next((c for c in reversed(opened) if c.label == label and c.keyword != "sub"), None)
    if said.keyword == "sub":
        begin_sub(flow, opened, label, line)
    elif said.keyword == "endsub":
        end_sub(flow, opened, label, line)
    elif said.keyword == "while" and inside and inside.keyword == "do":
        end(flow, opened, inside, line)
    elif said.keyword in CLOSED_BY:
        begin(flow, opened, said.keyword, label, line)
    elif said.keyword in ("elseif", "else") and inside and inside.keyword == "if":
        inside.lines.append(line)
        flow.constructs[line] = inside
    elif inside and CLOSED_BY[inside.keyword] == said.keyword:
        end(flow, opened, inside, line)
    else:
        raise ShapeError(f"has {said.keyword} of a label that nothing was begun with")


def static(text):
    """The label of a construct, which must not have to be calculated."""
    found = LABELLED.match(bare(text))
    if not found:
        raise ShapeError("needs a number or <name> as a label")
    return found[1] or int(found[2])


def begin(flow, opened, keyword, label, line):
    if len(opened) >= DEEPEST:
        raise ShapeError(f"begins loops and branches within each other more than {DEEPEST} deep, which is the most")
    opened.append(Construct(keyword, label, [line]))
    flow.constructs[line] = opened[-1]


def begin_sub(flow, opened, label, line):
    if any(c.keyword == "sub" for c in opened):
        raise ShapeError("begins a subroutine within another")
    if label in flow.subs:
        raise ShapeError("begins a subroutine that is there already")
    begin(flow, opened, "sub", label, line)
    flow.subs[label] = opened[-1]


def end_sub(flow, opened, label, line):
    if not opened or opened[-1].keyword != "sub" or opened[-1].label != label:
        raise ShapeError("ends a subroutine that was not begun, or with something in it that does not end")
    end(flow, opened, opened[-1], line)


def end(flow, opened, construct, line):
    if opened[-1] is not construct:
        raise ShapeError(f"ends {construct.keyword} before {opened[-1].keyword} in it has ended")
    construct.lines.append(line)
    flow.constructs[line] = opened.pop()
