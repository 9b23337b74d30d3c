# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters: what a shape may be told, declared once as the fields of frozen dataclasses.

The type of a field says what it is, its metadata says the unit, the limits and the words for people. From this one
declaration come Blender's properties and panels, job files, the command line's help and the tables in the docs.
Every check is in `coercing`, or in the `check` of a kind where it takes two fields, and all of them run when a value
is made: whoever asks, the refusal is the same sentence.
"""

from functools import cache, cached_property, partial
from math import inf
from types import UnionType
from typing import dataclass_transform

import numpy as np

from .frozen import altered, bound, by_value, individual, unchanging
from .names import spelled  # noqa: F401, for whoever declares, as what is beside it
from .refusals import ShapeError, at, require, together  # noqa: F401
from .wording import Documented, item_of

LARGEST = 1e12  # of any number: far beyond any use, and far from where squares and products overflow


class Array:
    """Read-only numbers that compare and hash by their contents."""

    def __init__(self, values):
        values = np.asarray(values)
        if values.dtype.kind not in "iuf":  # NumPy would also read numbers from text
            raise TypeError(f"must be numbers, not {values.dtype}")
        self.values = values.astype(np.float64) + 0.0  # turns -0.0 to 0.0: equal numbers, equal bytes
        self.values.flags.writeable = False

    def __eq__(self, other):
        return isinstance(other, Array) and np.array_equal(self.values, other.values)

    def __hash__(self):
        return hash((self.values.shape, self.values.tobytes()))

    def __len__(self):
        return len(self.values)

    def __getitem__(self, index):
        return self.values[index]

    def __array__(self, dtype=None, copy=None):
        return np.array(self.values, dtype=dtype) if copy else np.asarray(self.values, dtype=dtype)

    def __repr__(self):
        return repr(self.values.tolist())


@individual
class Parameter:
    """One declared field: its name, type and default, and what its metadata says. There is one object for each."""

    name: str
    type: object
    default: object = None  # None: another parameter says it, or what it holds
    doc: str = ""
    unit: str | None = None  # "length" in metres, "angle" in radians
    minimum: float = -inf
    maximum: float = inf
    above: float = -inf  # a limit that is not itself allowed
    soft_maximum: float | None = None  # where a slider ends; typing may go on to the maximum
    columns: int | None = None  # numbers in a row of an array; None: a row is one number
    most: float = inf  # rows of an array, of all together where there are several
    others: tuple = ()  # values of kinds that are not the default, which such kinds have here by default
    accepts: tuple[str, ...] = ()  # the types of Blender objects that can stand for the value
    splines: tuple[str, ...] = ()  # asked of too where a Blender curve with such splines stands for the kind
    shown: object = None  # what a property of Blender, which knows no None, has for a default that is None
    shorthand: bool = False  # the only field of its kind, whose value can stand for the kind
    group: str = ""  # the sub-panel of the sidebar it is drawn in

    @property
    def metadata(self):
        """What its declaration says beside its default."""
        return {word: said for word, said in vars(self).items() if word in WORDS and said is not getattr(ANY, word)}

    @cached_property
    def kinds(self):
        return self.type.__args__ if isinstance(self.type, UnionType) else ()

    @cached_property
    def item(self):
        """The declared class of which the value is a list, or None."""
        return item_of(self.type)

    @cached_property
    def is_list(self):
        return self.type in (Array, tuple[Array, ...])


ANY = Parameter("", object)  # of which all others are altered copies: to check each word takes longer, and is a test's
SINGLE = {"kinds": (), "item": None, "is_list": False}  # what is known of a number, a text or a member of an Enum
WORDS = set(Parameter.__match_args__) - {"name", "type", "default"}


def parameter(default, doc, **metadata):
    """Declare a field: its default, its doc for people, and any of the words of `Parameter`."""
    return altered(ANY, default=default, doc=doc, **metadata)


length = partial(parameter, unit="length", above=0.0)
angle = partial(parameter, unit="angle")
count = partial(parameter, minimum=1)
points = partial(parameter, unit="length", columns=3, most=200_000)  # for which a few seconds are enough


@dataclass_transform(frozen_default=True, field_specifiers=(parameter,))
def declared(cls):
    """Make a frozen dataclass that coerces and checks its fields once, when a value is made, and documents them."""

    def settle(self, *values, **named):
        fill(self, completed(cls, bound(cls, values, named)))
        if hasattr(cls, "check"):
            self.check()

    cls.__declared__ = (*getattr(cls, "__declared__", ()), *own(cls))
    cls = unchanging(by_value(cls), settle, {p.name: p for p in cls.__declared__})
    cls.__doc__ = Documented(cls.__doc__)
    return cls


def own(cls):
    """The parameters that a class declares, which learn their names and types and leave their defaults there."""
    for name, type_ in cls.__annotations__.items():
        p = vars(cls)[name]
        p.__dict__.update(name=name, type=type_)
        if isinstance(type_, type) and type_ is not Array:
            p.__dict__.update(SINGLE)
        setattr(cls, name, p.default)
        yield p


def completed(cls, given):
    """What is given for some parameters, with what a class says that this means for others."""
    return cls.completed(given) if hasattr(cls, "completed") else given


def fill(value, given):
    """Set each field to what is given for it, as it is kept, or to its default; or tell of all that will not do.

    For what could not even be read, as a drawing in a file, its refusal is given.
    """
    from .coercing import coerce  # which asks for the parameters of kinds

    refused = []
    for p in parameters(type(value)):
        value.__dict__[p.name] = p.default
        if p.name in given:
            try:
                value.__dict__[p.name] = coerce(p, given[p.name])
            except ShapeError as error:
                unread = isinstance(given[p.name], ShapeError)
                refusal = given[p.name] if unread else error
                refused.append(refusal.inside("" if p.shorthand else p.name))  # a shorthand has no key
    if refused:
        raise together(refused)


def proven(cls, **given):
    """A value whose ``check`` a test has run, since it stands in the source: it may take what only making needs."""
    value = cls.__new__(cls)
    fill(value, given)
    return value


@cache
def parameters(cls):
    """The declared fields of a shape or of a kind, as a tuple of `Parameter`."""
    return tuple(map(settled, cls.__declared__))


def settled(p):
    """A parameter with its default as it is kept, as most are declared; a test asks whether all are within limits."""
    if type(p.default) is p.type or p.kinds and type(p.default) in p.kinds:
        return p
    from .coercing import array_of, coerce

    return changed(p, default=array_of(p, p.default) if p.type is Array else coerce(p, p.default))


@cache
def inside(union, kind):
    """The parameters of one kind of a union, with what the union says of them: defaults, unit, doc."""
    default = by_kind(union).get(kind)
    if default is None and hasattr(kind, "like"):
        default = kind.like(union.default)
    doc = union.doc if has_shorthand(kind) else ""
    says_nothing = default is None and union.unit is None and not doc
    return parameters(kind) if says_nothing else of_kind(kind, default, union.unit, doc)


@cache
def by_kind(union):
    """The values of the kinds that a union says, its default and the others."""
    return {type(value): value for value in (*union.others, union.default)}


@cache
def has_shorthand(kind):
    return any(p.shorthand for p in parameters(kind))


@cache
def of_kind(kind, default, unit, doc):
    """The same for all unions that say the same: the values of the default, if there is one, and of what is meant."""
    return tuple(
        told(p, getattr(default, p.name, p.default), p.unit or unit, doc if p.shorthand else p.doc)
        for p in parameters(kind)
    )


def told(p, default, unit, doc):
    """A parameter of a kind with what a union says of it; itself if it says so already."""
    return p if default is p.default and unit is p.unit and doc is p.doc else said(p, default, unit, doc)


@cache
def said(p, default, unit, doc):
    """A parameter of which unions say so, the same for all that do."""
    return changed(p, default=default, unit=unit, doc=doc)


def changed(p, **words):
    """A parameter of which some words are others; itself where none is, so that shapes share most of theirs."""
    for name, new in words.items():
        old = getattr(p, name)
        if not (old is new or type(old) is type(new) is not tuple and old == new):  # (0,) == (0.0,)
            return altered(p, **words)
    return p
