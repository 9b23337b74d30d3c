# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Frozen dataclasses that share their functions.

`dataclass(frozen=True)` writes and compiles source for each class, from Python 3.13 on also where it is told to write
nothing. In Python 3.14 that takes a third of a millisecond, and enabling the extension makes seventy of them.
"""

from dataclasses import MISSING, FrozenInstanceError, dataclass, field
from functools import cache
from inspect import Parameter, Signature
from typing import dataclass_transform


@dataclass_transform(frozen_default=True)
def frozen(cls):
    """Make a dataclass of values that are set once, when it is made; equal if all of them are."""
    return unchanging(by_value(cls), filled)


@dataclass_transform(frozen_default=True, eq_default=False)
def individual(cls):
    """Make a dataclass of values that are set once; each object is equal to itself alone."""
    return unchanging(cls, filled)


def by_value(cls):
    """The class with objects that are equal if their values are; one that has ways of its own to tell keeps them."""
    if "__eq__" not in vars(cls):
        cls.__eq__, cls.__hash__ = equal, hashed
    return cls


def unchanging(cls, init, said=None):
    """The class as a dataclass whose fields only ``init`` sets; what is said of some is the metadata of theirs."""
    cls.__init__, cls.__setattr__, cls.__delattr__ = init, refuse, refuse
    if "__repr__" not in vars(cls):
        cls.__repr__ = written
    cls = described(cls, said or {}) if MARK else dataclass(**NOTHING)(with_fields(cls, said or {}))
    cls.__signature__ = WhenAsked(signature)
    return cls


NOTHING = {"init": False, "eq": False, "repr": False}


@dataclass(**NOTHING)
class Pattern:
    """From which other classes take what `dataclass` gives to all that it writes nothing for."""

    field: object = None


SHARED = {name: vars(Pattern)[name] for name in ("__dataclass_params__", "__replace__") if name in vars(Pattern)}
MARK = getattr(Pattern.__dataclass_fields__["field"], "_field_type", None)  # by which `fields` knows one; it is private


def described(cls, said):
    """The class with what the functions of `dataclasses` ask of one: the same that `dataclass` would give it."""
    cls.__match_args__ = tuple(dict.fromkeys((*getattr(cls, "__match_args__", ()), *cls.__annotations__)))
    cls.__dataclass_fields__ = Fields(cls, said)
    for name, value in SHARED.items():
        setattr(cls, name, value)
    return cls


class Fields:
    """The fields of a class, which are made when somebody asks for them: starting Blender asks for few."""

    def __init__(self, owner, said):
        self.owner, self.said = owner, said

    def __get__(self, value, cls):
        owner = self.owner
        made = dict(getattr(super(owner, owner), "__dataclass_fields__", {}))
        for name, type_ in owner.__annotations__.items():
            made[name] = told = told_field(owner, name, self.said)
            told.name, told.type, told.kw_only, told._field_type = name, type_, False, MARK
        owner.__dataclass_fields__ = made
        return made


def told_field(cls, name, said):
    """The field of a name, with its default and its metadata."""
    return field(default=vars(cls).get(name, MISSING), metadata=said[name].metadata if name in said else None)


def with_fields(cls, said):
    """The class with fields that have metadata in the place of their defaults, as `dataclass` takes them."""
    for name in said:
        setattr(cls, name, told_field(cls, name, said))
    return cls


class WhenAsked:
    """An attribute of a class that is made each time somebody asks: help and consoles do, starting Blender does not."""

    def __init__(self, made):
        self.made = made

    def __get__(self, value, cls):
        return self.made(cls)


def signature(cls):
    """What the class takes, for help and consoles."""
    defaults = {name: field.default for name, field in cls.__dataclass_fields__.items()}
    return Signature(
        Parameter(name, Parameter.POSITIONAL_OR_KEYWORD, default=Parameter.empty if default is MISSING else default)
        for name, default in defaults.items()
    )


def filled(self, *values, **named):
    """Set all fields to the values given for them, by place or by name, or to their defaults."""
    given = bound(type(self), values, named)
    optional, needed = defaults(type(self))
    for name in needed:
        if name not in given:
            raise TypeError(f"{type(self).__name__} needs a value for {name!r}")
    self.__dict__.update(optional)
    self.__dict__.update(given)


@cache
def defaults(cls):
    """The defaults of a class by the names of their fields, and the names of the fields that have none."""
    declared = {name: field.default for name, field in cls.__dataclass_fields__.items()}
    needed = [name for name, default in declared.items() if default is MISSING]
    return {name: default for name, default in declared.items() if default is not MISSING}, needed


def altered(value, **named):
    """A copy of which some fields are others, on which nothing depends that was kept: that is known of the copy too."""
    copy = object.__new__(type(value))
    copy.__dict__.update(value.__dict__, **named)
    return copy


def bound(cls, values, named):
    """The values given for fields, by the names of these."""
    names = cls.__match_args__
    if len(values) > len(names):
        raise TypeError(f"{cls.__name__} takes at most {len(names)} values but got {len(values)}")
    if named and not named.keys() <= set(names):
        from .hints import has_none  # nobody needs it until something is refused

        name = next(name for name in named if name not in names)
        raise TypeError(f"{name!r} is {has_none(cls.__name__, name, names)}")
    if not values:
        return named
    given = dict(zip(names, values, strict=False))
    if not named:
        return given
    for name in named.keys() & given.keys():
        raise TypeError(f"{cls.__name__} got two values for {name!r}")
    return given | named


def held(self):
    return tuple(map(self.__dict__.get, self.__match_args__))


def equal(self, other):
    return held(self) == held(other) if type(self) is type(other) else NotImplemented


def hashed(self):
    return hash((type(self), held(self)))


def written(self):
    told = ", ".join(f"{name}={getattr(self, name)!r}" for name in self.__match_args__)
    return f"{type(self).__qualname__}({told})"


def refuse(self, name, *value):
    raise FrozenInstanceError(f"cannot {'assign to' if value else 'delete'} field {name!r}")
