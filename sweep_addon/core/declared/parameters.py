# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parameters: what a shape may be told, declared once as the fields of frozen dataclasses.

The type of a field says what it is, its metadata says the unit, the limits and the words for people. From this one
declaration come Blender's properties and panels, job files, the command line's help and the tables in the docs.
Every check is in `coerce`, or in the `check` of a kind where it takes two fields, and all of them run when a value
is made: whoever asks, the refusal is the same sentence.
"""

from contextlib import contextmanager, suppress
from enum import EnumMeta
from functools import cache, cached_property, partial
from math import inf
from numbers import Real
from types import UnionType
from typing import dataclass_transform, get_args, get_origin

import numpy as np

from .frozen import altered, bound, by_value, individual, unchanging
from .names import spelled
from .refusals import MOST, ShapeError, at, require, together
from .wording import MEASURES, Documented, item_of, longest, named, shown

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


def coerce(p, value):
    """The value that was meant, or a `ShapeError`."""
    if value is None and p.default is None and p.shown is not None:  # it need not be given
        return None
    if p.type is float or p.type is int:
        return coerce_number(p, value)
    if p.kinds:
        return coerce_kind(p, value)
    if isinstance(p.type, EnumMeta):
        return coerce_option(p, value)
    if p.type is Array:
        return coerce_array(p, value)
    if p.item:
        return coerce_items(p, value)
    if get_origin(p.type) is tuple:
        first, *rest = get_args(p.type)
        require(isinstance(value, (list, tuple)) or getattr(value, "ndim", 0), "must be a list", value)
        require(rest == [...] or len(value) == 1 + len(rest), f"must be a list of {1 + len(rest)}", value)
        require_few(p, sum(max(1, rows(item)) for item in value))
        flat = p.columns and rest == [...] and len(value) and rows(value[0]) and not any(map(rows, value[0]))
        require(not flat, f"must be a list of lists of {p.columns} numbers each", value)
        part = altered(p, type=first)
        return tuple(coerce(part, item) for item in value)
    if hasattr(p.type, "coerced"):
        return p.type.coerced(value)
    require(isinstance(value, p.type), {bool: "must be true or false", str: "must be text"}[p.type], value)
    return value


def coerce_option(p, value):
    """A member of an Enum from itself, from its name, or from what the Enum takes for it."""
    if not isinstance(value, str):
        with suppress(ValueError, TypeError):  # TypeError: a list, of which no Enum can ask whether it is one of some
            return p.type(value)
    return pick({spelled(member): member for member in p.type}, value)


def coerce_number(p, value):
    number = isinstance(value, Real) and not isinstance(value, (bool, np.bool_)) and abs(value) < inf
    within = number and p.above < value <= min(p.maximum, LARGEST) and value >= max(p.minimum, -LARGEST)
    if not (within and (p.type is float or value % 1 == 0)):
        refuse_number(p, value, number)
    return p.type(value) + 0  # turns -0.0 to 0.0


def refuse_number(p, value, number):
    """Say which limit a number is beyond, or that it is none."""
    require(number, "must be a whole number" if p.type is int else f"must be {MEASURES[p.unit]}", value)
    require(abs(value) <= LARGEST, f"must be at most {LARGEST:g} in size", value)
    require(p.type is float or value % 1 == 0, "must be a whole number", value)
    require(value > p.above, f"must be more than {p.above:g}", value)
    require(value >= p.minimum, f"must be at least {p.minimum:g}", value)
    require(value <= p.maximum, f"must be at most {p.maximum:g}", value)


def require_few(p, size):
    """Refuse a long list before anything is done that takes time for each of its rows."""
    require(size <= p.most, f"must have {longest(p.most, p.columns, p.item)}", size)


def rows(value):
    """The length of what may stand for an array; 0 for anything else."""
    return len(value) if isinstance(value, (Array, list, tuple)) or getattr(value, "ndim", 0) else 0


def coerce_array(p, value):
    require_few(p, rows(value))
    try:
        array = array_of(p, value)
    except (TypeError, ValueError, OverflowError):
        array = None
    row = (p.columns,) if p.columns else ()
    fits = array is not None and array.values.ndim == 1 + len(row) and array.values.shape[1:] == row
    if not fits:
        from .hints import first_wrong

        needed = f"{p.columns} numbers each" if p.columns else "numbers"
        raise ShapeError(f"must be a list of {needed}, got {first_wrong(value, p.columns)}")
    wrong = ~(np.abs(array.values) <= LARGEST)
    if wrong.any():
        got = f"{array.values[wrong][0]:g} in row {np.argwhere(wrong)[0, 0] + 1}"
        raise ShapeError(f"must have finite numbers up to {LARGEST:g} in size, got {got}")
    return array


def array_of(p, value):
    """An array from what has the form of one; with rows of none where nothing is what is meant by default."""
    array = value if isinstance(value, Array) else Array(value)
    nothing = p.columns and not array.values.size and not len(p.default)
    return Array(np.zeros((0, p.columns))) if nothing else array


def coerce_items(p, value):
    """Declared values from themselves, from their tables, or from what they hold in the order of its declaration."""
    require(isinstance(value, (list, tuple)), "must be a list", value)
    require_few(p, len(value))
    declared, made, refused = parameters(p.item), [], []
    for number, item in enumerate(value, 1):
        try:
            made.append(coerce_item(p, declared, item))
        except ShapeError as error:
            refused.append(error.inside(f"{number}"))
            if len(refused) == MOST:
                break
    if refused:
        raise together(refused)
    return tuple(made)


def coerce_item(p, declared, item):
    if isinstance(item, (list, tuple)):
        require(len(item) <= len(declared), f"must have at most {len(declared)} values", len(item))
        item = {q.name: part for q, part in zip(declared, item, strict=False)}
    elif len(declared) == 1 and not isinstance(item, (dict, p.item)):
        item = {declared[0].name: item}
    return item if isinstance(item, p.item) else filled(p.item, declared, item)


def coerce_kind(p, value):
    """A kind from itself, from its name, from its table, or from the one value that is its shorthand."""
    if isinstance(value, p.kinds):
        return value
    names = names_of(p.kinds)
    if isinstance(value, str) and value in names:
        value = {"kind": value}
    with measured(p.unit):
        for form, kind in shorthands(p.kinds):
            if isinstance(value, form):
                return kind(value)
        if isinstance(value, dict):
            return from_table(names, value, lambda kind: inside(p, kind))
    return pick(names, value)


@cache
def names_of(kinds):
    """Kinds by their names."""
    return {spelled(kind): kind for kind in kinds}


@cache
def shorthands(kinds):
    """What stands for a kind, and for which."""
    forms = {float: Real, str: str, Array: (list, tuple, np.ndarray, Array)}
    return [(forms[q.type], kind) for kind in kinds for q in parameters(kind) if q.shorthand]


@contextmanager
def measured(unit):
    """Say in a refusal what a number would be, of a formula too: it may have been meant as one with its unit."""

    def said(refusal):
        sentence = refusal.sentence.replace("must be a number,", f"must be {MEASURES[unit]},")
        formula = f"must be {MEASURES[unit]} or an expression" if unit else "must be an expression"
        law = f"must be {MEASURES[unit]}, a formula in text or a list of points [t, value]"
        listed = "must be a list of 2 numbers each"
        return sentence.replace("must be an expression", formula).replace(listed, listed if refusal.key else law)

    try:
        yield
    except ShapeError as error:
        raise error.worded(said) from error.__cause__


def from_table(names, table, declared, beside=()):
    """A value from a table of plain values whose ``kind`` is one of the names.

    Other keys that people may have meant, which were taken out of it, are told of too.
    """
    table = dict(table)
    if "kind" not in table:
        from .hints import kindless  # nobody needs it until something is refused

        raise kindless(names, table)
    word = table.pop("kind")
    try:
        with at("kind"):
            kind = pick(names, word)
    except ShapeError as refusal:
        from .hints import unmistakable

        kind = unmistakable(names, word)
        if kind is None:
            raise
        raise together([refusal, *wrong_in(kind, declared(kind), table, beside)]) from None
    return filled(kind, declared(kind), table, beside)


def wrong_in(kind, declared, table, beside):
    """What is wrong with a table of a kind: its refusal, or nothing."""
    try:
        filled(kind, declared, table, beside)
    except ShapeError as refusal:
        return [refusal]
    return []


def filled(kind, declared, table, beside=()):
    """A value of a kind from a table of some of its parameters."""
    require(isinstance(table, dict), f"must be a table of {', '.join(q.name for q in declared)}", table)
    known = {q.name: q.default for q in declared}
    unknown = [key for key in table if key not in known]
    given = known | completed(kind, table)
    if not unknown:
        return kind(**given)
    from .hints import has_none

    refused = [ShapeError(f"is {has_none(kind.__name__, key, known, beside)}", named(key)) for key in unknown[:MOST]]
    try:
        proven(kind, **{key: given[key] for key in known})  # what goes together is not asked where one is missing
    except ShapeError as error:
        refused.append(error)
    raise together(refused)


def pick(names, value):
    if isinstance(value, str) and value in names:
        return names[value]
    from .hints import hint, one_of

    raise ShapeError(f"must be {one_of(names, value)}, got {shown(value)}{hint(names, value)}")
