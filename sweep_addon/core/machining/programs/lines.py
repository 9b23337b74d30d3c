# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which line of a program a refusal is about."""

from contextlib import contextmanager

from ...declared.refusals import ShapeError


class ProgramError(ShapeError):
    """A refusal that tells the line, and has its number."""

    def __init__(self, sentence, line):
        super().__init__(f"line {line} {sentence}")
        self.line = line


@contextmanager
def at_line(line):
    """Tell with a refusal its line, which counts from 0 here and from 1 for people."""
    try:
        yield
    except ProgramError:
        raise
    except ShapeError as error:
        raise ProgramError(error.sentence, int(line) + 1) from error.__cause__
