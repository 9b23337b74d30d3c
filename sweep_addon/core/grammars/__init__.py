# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars: L-systems, whose productions replace all modules of a word at once, and the turtle that draws the words.

Source
------
Prusinkiewicz, Lindenmayer: The Algorithmic Beauty of Plants, 1990, which the language follows.
"""

from .deriving.budget import Budget
from .lsystem import LSystem
from .text.problems import GrammarError, Problem
from .word import Word

__all__ = ["Budget", "GrammarError", "LSystem", "Problem", "Word"]
