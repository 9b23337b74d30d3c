# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs of grammars: what a file of one derives, and what it is."""

import sys
from pathlib import Path

from ..core.declared.documents import contained, limited
from ..core.declared.parameters import ShapeError
from .job import decoded

LONGEST = 4_000_000  # bytes of a file
STANDARD_INPUT = "-"  # in the place of a file


def read(path):
    """The system in a file, or in what is written to standard input where the path is a minus.

    Raises
    ------
    ShapeError
        With file, line and column for each thing that is wrong.
    """
    from ..core.grammars import GrammarError, LSystem

    source, path = path, "standard input" if path == STANDARD_INPUT else path
    try:
        text = decoded(received(source))
        if text is None:
            raise ShapeError("must be text in UTF-8")
    except OSError as error:
        raise ShapeError(f"{path}: cannot be read: {error.strerror}") from None
    except ShapeError as refusal:
        raise ShapeError(f"{path}: {refusal}") from None
    try:
        return LSystem.parse(text)
    except GrammarError as refusal:
        if Path(path).suffix == ".toml":
            raise ShapeError(
                f"{path}: must be a grammar, got a job, which `check`, `build` and `render` take"
            ) from None
        raise ShapeError("\n".join(problem.placed(path) for problem in refusal.problems)) from None
    except ShapeError as refusal:
        raise ShapeError(f"{path}: {refusal}") from None


def received(path):
    """The bytes of a file, or of standard input."""
    return limited(sys.stdin.buffer, LONGEST) if path == STANDARD_INPUT else contained(Path(path), LONGEST)


def derive(told):
    """Print the word that a grammar derives, in the notation of The Algorithmic Beauty of Plants, or how many modules
    each generation has, a line each from that of the axiom on."""
    system = read(told.grammar)
    if told.count:
        sizes = system.sizes(told.generations, told.seed)
        sys.stdout.writelines(f"{size}\n" for size in sizes)
    else:
        sys.stdout.write(f"{system.derive(told.generations, told.seed)}\n")
    sys.stdout.flush()
    return 0


def describe(path):
    """Lines about the grammar in a file."""
    from ..core.grammars.deriving.describing import described

    return described(read(path))
