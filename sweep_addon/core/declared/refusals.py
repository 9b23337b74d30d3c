# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Refusals: what is wrong with what a shape is told, each in one sentence, and all that is wrong with it at once."""

from contextlib import contextmanager

from ..later import later

shown = later("core.declared.wording", "shown")

MOST = 20  # mistakes of one kind that are told at once
FLATTEST = 1e-6  # single precision, which Blender keeps, tells the two sides of a figure as flat just apart


class ShapeError(ValueError):
    """A refusal: the key path of the parameter, what would do, and what it got.

    Attributes
    ----------
    sentence : str
        The refusal without the key path.
    key : str
        The key path of the parameter, as in a job file: ``contour.radius``.
    others : tuple of ShapeError
        What else is wrong with the same value, whatever becomes of this.

    Examples
    --------
    >>> from sweep_addon.core.contours import Circle
    >>> try:
    ...     Circle(radius=-1)
    ... except ShapeError as refusal:
    ...     print(refusal)
    radius: must be more than 0, got -1
    """

    def __init__(self, sentence, key=""):
        super().__init__(f"{key}: {sentence}" if key else sentence)
        self.sentence, self.key, self.others = sentence, key, ()

    @classmethod
    def read(cls, text):
        """The refusal that was written as text; a key has no blanks.

        >>> ShapeError.read("contour.radius: must be more than 0, got -1").key
        'contour.radius'
        """
        key, colon, sentence = text.partition(": ")
        return cls(sentence, key) if colon and " " not in key else cls(text)

    def inside(self, key):
        """The same refusal, of what is at a key of a larger value.

        >>> print(ShapeError("must be more than 0, got -1", "radius").inside("contour"))
        contour.radius: must be more than 0, got -1
        """
        return self.changed(lambda refusal: (refusal.sentence, ".".join(filter(None, (key, refusal.key)))))

    def worded(self, said):
        """The same refusal in other words, and the others too: the sentence that a function says for each."""
        return self.changed(lambda refusal: (said(refusal), refusal.key))

    def changed(self, change):
        made = ShapeError(*change(self))
        made.others = tuple(other.changed(change) for other in self.others)
        made.__cause__ = self.__cause__
        return made

    def each(self):
        """This refusal and the others."""
        return (self, *self.others)


def together(refusals):
    """One refusal that says the first of some, and knows the others."""
    first, *others = (each for refusal in refusals for each in refusal.each())
    for refusal in others:
        refusal.others = ()
    first.others = tuple(others)
    return first


@contextmanager
def at(key):
    """Say where in a larger value a refusal belongs."""
    try:
        yield
    except ShapeError as error:
        raise error.inside(key) from error.__cause__


def require(holds, sentence, value, key=""):
    """Refuse a value unless the sentence about it holds."""
    if not holds:
        raise ShapeError(f"{sentence}, got {shown(value)}", key)


def require_broad(contour, one, other):
    """Refuse a contour of which one of two lengths is less than a millionth of the other.

    Parameters
    ----------
    contour : declared value
    one, other : str
        The names of its parameters; the sentence is about the shorter one.
    """
    shorter, longer = sorted((one, other), key=lambda name: getattr(contour, name))
    least = FLATTEST * getattr(contour, longer)
    value = getattr(contour, shorter)
    require(value >= least, f"must be at least {least:.9g}, a millionth of {longer}", value, shorter)
