# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Texts that are no programs of RS-274 at all: compressed files, pictures, drawings, programs of other languages."""

import re

from ...declared.wording import shown
from .blocks import bare
from .lines import ProgramError

FOREIGN = re.compile(r"[a-z]{2}[^\[]*$|[^a-z0-9#@^$/.%(+-]|%.", re.DOTALL)  # how no line begins, bare of its blanks
CONTROL = re.compile("[\0-\x08\x0e-\x1f]")
G_WORD = re.compile(r"(?<![a-z_])g\d", re.IGNORECASE)
NEEDED = 'is of no program of RS-274 ("G-code"), whose lines are of words as G1 X2.5'


def refuse_foreign(text):
    """Refuse a text that is none of a program by its first line; one that has a word of G may have a mistake there.

    >>> refuse_foreign("%\\nG1 X2"), refuse_foreign("hello\\nG1 X2")
    (None, None)
    >>> try:
    ...     refuse_foreign("solid part\\nfacet normal 0 0 1")
    ... except ProgramError as refusal:
    ...     print(refusal)
    line 1 is of no program of RS-274 ("G-code"), whose lines are of words as G1 X2.5, got 'solid part'
    """
    number, first = next(((n, line) for n, line in enumerate(text.split("\n"), 1) if bare(line)), (0, ""))
    if not FOREIGN.match(bare(first)):
        return
    if CONTROL.search(first):
        raise ProgramError(f"{NEEDED}, got bytes that are no text, as those of a compressed file", number)
    if not G_WORD.search(text):
        raise ProgramError(f"{NEEDED}, got {shown(first.strip())}", number)
