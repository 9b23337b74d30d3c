# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""L-systems: an axiom, productions, and what a turtle needs to draw the words that they derive."""

from functools import cached_property

from ..declared.frozen import frozen
from ..declared.parameters import require
from .deriving.statements import Statement
from .text.constants import Constant
from .text.modules import Module
from .text.productions import Production
from .text.reading import read
from .text.writing import written


@frozen
class LSystem:
    """A grammar whose productions replace all modules of a word at once.

    Attributes
    ----------
    axiom : tuple of Module
        The word that every derivation begins with.
    productions : tuple of Production
        Those of every step.
    groups : tuple of (int, tuple of Production)
        Further ones by the numbers of their groups: a step tries those of its group first.
    systems : tuple of (int, tuple of Production)
        Those of sub-systems, by their numbers: of what stands between ``?(number, scale)`` and ``$``.
    schedule : tuple of (tuple of int, bool) or None
        Which group each step uses, and whether the list begins again at its end; without it, group n holds from step n
        on until the next.
    decomposition, homomorphism : tuple of Production
        What modules are made of, after each step, and what a turtle is told in their place.
    decomposition_depth, homomorphism_depth : int or None
        After how many levels these stop.
    start, start_each, end_each, end : tuple of Statement
        What gives variables their values: before a derivation, before and after each of its steps, and behind it.
    constants : tuple of Constant
    names : tuple of str
        Names of modules that have more than one letter.
    ignore, consider : tuple of str or None
        Modules that contexts pass over, or all that they see.
    angle : float
        What ``+ - & ^ \\ /`` turn by where they have no parameter, in degrees.
    step, width : float
        How far ``F f G`` go where they have no parameter, and the diameter of the first segment, in metres.
    tropism : tuple of 4 floats or None
        A direction, and how easily a segment bends towards it.
    heading : str or None
        The axis along which a turtle starts: "x", "y" or "z"; without it plants start along z and others along x.
    generations, seed : int
        The steps of a derivation and its random numbers, where nothing else is said.
    dialect : str
    following : tuple of (str, float or tuple of float, str)
        Which of these numbers the text says by constants: their names, the numbers, and the formulas.

    Examples
    --------
    >>> algae = LSystem.parse("axiom: A\\nA -> AB\\nB -> A")
    >>> [str(algae.derive(generations)) for generations in range(5)]
    ['A', 'AB', 'ABA', 'ABAAB', 'ABAABABA']
    >>> len(algae.derive(30))
    2178309
    """

    axiom: tuple[Module, ...]
    productions: tuple[Production, ...] = ()
    groups: tuple = ()
    systems: tuple = ()
    schedule: tuple | None = None
    decomposition: tuple[Production, ...] = ()
    decomposition_depth: int | None = None
    homomorphism: tuple[Production, ...] = ()
    homomorphism_depth: int | None = None
    start: tuple[Statement, ...] = ()
    start_each: tuple[Statement, ...] = ()
    end_each: tuple[Statement, ...] = ()
    end: tuple[Statement, ...] = ()
    constants: tuple[Constant, ...] = ()
    names: tuple[str, ...] = ()
    ignore: tuple[str, ...] | None = None
    consider: tuple[str, ...] | None = None
    angle: float = 90.0
    step: float = 1.0
    width: float = 0.1
    tropism: tuple | None = None
    heading: str | None = None
    generations: int = 0
    seed: int = 0
    dialect: str = "abop"
    following: tuple = ()

    def __new__(cls, axiom=(), *rest, **named):
        require(not isinstance(axiom, str), "must be modules, and a text be told to LSystem.parse", axiom, "axiom")
        return super().__new__(cls)

    @classmethod
    def parse(cls, text, constants=None):
        """Read a grammar in the notation of "The Algorithmic Beauty of Plants".

        Parameters
        ----------
        text : str
            Its lines: directives, the axiom, and productions.
        constants : dict of str to float, optional
            Values for some of its constants, instead of those in the text.

        Returns
        -------
        LSystem

        Raises
        ------
        ShapeError
            A `GrammarError` that tells of every line that is wrong, with line, column, and what would do.

        Examples
        --------
        >>> tree = LSystem.parse("#define r 0.5\\naxiom: F(1)\\nF(l) : l > 0.2 -> F(l)[+F(l*r)]")
        >>> str(tree.derive(2))
        'F(1)[+F(0.5)][+F(0.5)[+F(0.25)]]'
        >>> str(LSystem.parse(str(tree), {"r": 0.1}).derive(2))
        'F(1)[+F(0.1)][+F(0.1)]'
        """
        return read(cls, text, constants)

    @cached_property
    def compiled(self):
        """Its productions as tables of numbers."""
        from .deriving.tables import Tables

        return Tables(self)

    def derive(self, generations=None, seed=None, budget=None, progress=None, environment=None):
        """The word after so many steps.

        Parameters
        ----------
        generations : int, optional
            How many; else as many as the text says.
        seed : int, optional
            Of all random numbers; else that of the text. Each number hangs on the seed, the step and the ancestors of
            its module alone, so that the same seed gives the same word everywhere.
        budget : Budget, optional
            How large and how long it may grow.
        progress : callable, optional
            Called with the part that is done, from 0 to 1; to stop, it raises an exception.
        environment : callable, optional
            Answers modules ``?E(x, ...)`` after each step: takes an `Asked`, which has ``at``, ``heading``, ``left``,
            ``up``, ``values`` and ``generation``, and returns their new parameters, (m,) or (m, k) numbers. Without
            it they stay as they are.

        Returns
        -------
        Word

        Raises
        ------
        ShapeError
            If the word would be larger than the budget allows, or a parameter is not finite.

        Examples
        --------
        >>> from sweep_addon import ShapeError
        >>> fractal = LSystem.parse("axiom: F\\nF -> F[+F]F[-F]F")
        >>> fractal.derive(2)
        <Word of 61 modules>
        >>> try:
        ...     fractal.derive(40)
        ... except ShapeError as refusal:
        ...     print(refusal)
        generations: must make at most 20,000,000 modules, but 40 make 22,737,367,544,323,205,947,875,976,561
        """
        from .deriving.derivation import derived

        generations = self.generations if generations is None else generations
        return derived(self, generations, self.seed if seed is None else seed, budget, progress, environment)

    def sizes(self, generations=None, seed=None, budget=None, progress=None):
        """How many modules the words of all generations have; where that can be foretold, without deriving any.

        Parameters
        ----------
        generations, seed, budget, progress
            As of `derive`.

        Returns
        -------
        list of int

        Examples
        --------
        >>> LSystem.parse("axiom: F\\nF -> FF").sizes(200)[-1] == 2**200
        True
        """
        from .deriving.derivation import sizes

        generations = self.generations if generations is None else generations
        return sizes(self, generations, self.seed if seed is None else seed, budget, progress)

    def with_constants(self, **values):
        """The same system with other values of constants.

        >>> str(LSystem.parse("#define n 1\\naxiom: A(n)").with_constants(n=7).derive(0))
        'A(7)'
        >>> LSystem.parse("#define a 20\\n#angle 2*a\\naxiom: F").with_constants(a=30).angle
        60.0
        """
        return self.parse(str(self), values)

    def with_production(self, head, function):
        """The same system with one more production, behind the others, whose successor is a Python function.

        Parameters
        ----------
        head : str
            Predecessor, contexts and condition: ``A(x) < B(y) : x > y``.
        function : callable
            Takes the parameters of the head, each an array for all modules that are replaced, and returns a list of
            modules: a name, or a tuple of a name and its parameters. The names and how many parameters there are may
            not depend on the values.

        Returns
        -------
        LSystem
            It has no text: no file can hold a function.

        Raises
        ------
        ShapeError
            If the head is none, or the function returns no modules.

        Examples
        --------
        >>> import numpy as np
        >>> system = LSystem.parse("axiom: A(1)A(4)")
        >>> grown = system.with_production("A(x)", lambda x: [("F", np.sqrt(x)), "[", "+", ("A", x / 2), "]"])
        >>> str(grown.derive(1))
        'F(1)[+A(0.5)]F(2)[+A(2)]'
        """
        from .calls import with_production

        return with_production(self, head, function)

    def __str__(self):
        return written(self)
