# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Words: rows of modules, as arrays."""

from functools import cached_property

import numpy as np

from .deriving.budget import Budget

OF_MODULE = 50  # bytes of all arrays of a figure while it is drawn, for each module of the word


class Word:
    """A row of modules that a system derived.

    Attributes
    ----------
    tables : Tables
        Of the system.
    generations, seed : int
        How it was derived.
    symbols : (n,) uint8 or uint16 array
        The kind of each module, as a place in ``tables.symbols``.
    columns : list of (n,) float64 array
        The first parameter of each module, the second, ...; 0 where a module has none.

    Examples
    --------
    >>> from sweep_addon.core.grammars import LSystem
    >>> word = LSystem.parse("axiom: A(1)\\nA(x) -> F(x)[+A(x/2)]").derive(2)
    >>> str(word), len(word), word.count("F")
    ('F(1)[+F(0.5)[+A(0.25)]]', 9, 2)
    """

    def __init__(self, tables, state, generations, seed):
        self.tables, self.state, self.generations, self.seed = tables, state, generations, seed

    @property
    def symbols(self):
        return self.state.symbols

    @property
    def columns(self):
        return self.state.columns

    def __len__(self):
        return len(self.state)

    def __repr__(self):
        return f"<Word of {len(self):,} modules>"

    def count(self, name):
        """How many modules of a name there are, whatever their parameters."""
        numbers = [number for number, symbol in enumerate(self.tables.symbols) if symbol[0] == name]
        return int(np.isin(self.symbols, numbers).sum())

    @cached_property
    def births(self):
        """(n,) int array: the step that made each module."""
        return self.state.births() if callable(self.state.births) else self.state.births

    def interpreted(self, budget=None, progress=None):
        """The word that a turtle is told: modules are replaced by what the homomorphism of the system says.

        Returns
        -------
        Word

        Examples
        --------
        >>> from sweep_addon.core.grammars import LSystem
        >>> word = LSystem.parse("axiom: A\\nA -> IA\\nhomomorphism:\\nI -> F\\nA -> [+F]").derive(2)
        >>> str(word), str(word.interpreted())
        ('IIA', 'FF[+F]')
        """
        from .drawing.interpreting import interpreted

        return interpreted(self, budget, progress)

    def figure(self, upright=None, budget=None, system=None):
        """What a turtle draws when it walks the interpreted word.

        Parameters
        ----------
        upright : bool, optional
            Whether it starts upwards, along z with its left along -x, or along x with its left along y. Where nothing
            is said, it starts as the system says; else one with branches that turns out of the plane grows upwards.
        budget : Budget, optional
            Of the interpretation, and of the arrays of the figure.
        system : LSystem, optional
            Whose angle, step, width and tropism count; else that of the word.

        Returns
        -------
        Figure

        Examples
        --------
        >>> from sweep_addon.core.grammars import LSystem
        >>> koch = LSystem.parse("#angle 60\\naxiom: F\\nF -> F+F--F+F").derive(3).figure()
        >>> len(koch.start), [round(abs(x), 9) for x in koch.at.tolist()]
        (64, [27.0, 0.0, 0.0])
        """
        from .drawing.turtle import Walk

        told, budget = self.interpreted(budget), budget or Budget()
        budget.of_arrays(len(told) * OF_MODULE, "figure")
        return Walk(told, upright, system, budget=budget).figure()

    def __str__(self):
        """The modules in the notation of the book: parameters of six digits, no blanks."""
        names = self.tables.symbols
        if not self.columns and all(len(name) == 1 for name, _ in names) and self.symbols.dtype == np.uint8:
            letters = np.frombuffer("".join(name for name, _ in names).encode("ascii"), dtype=np.uint8)
            return letters[self.symbols].tobytes().decode("ascii") if len(self) else ""
        told = np.array([name for name, _ in names], dtype=object)[self.symbols]
        for number, (name, count) in enumerate(names):
            at = np.flatnonzero(self.symbols == number) if count else ()
            if len(at):
                form = f"{name.replace('%', '%%')}({','.join(['%.6g'] * count)})"
                values = zip(*(column[at].tolist() for column in self.columns[:count]), strict=True)
                told[at] = [form % each for each in values]
        return "".join(told.tolist())
