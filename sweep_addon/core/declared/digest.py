# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A digest: a short text that is the same for equal values, in every session and on every machine."""

from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from hashlib import blake2b
from zlib import crc32

import numpy as np

from .parameters import Array


def digest(value):
    """The digest of a declared value, or of a list of them.

    Parameters
    ----------
    value : declared value, or list or tuple of such
        What its fields hold: numbers, text, options, arrays and further declared values.

    Returns
    -------
    str
        32 hexadecimal digits.

    Examples
    --------
    >>> from sweep_addon.core.contours import Circle
    >>> digest(Circle(1)) == digest(Circle(1.0)), digest(Circle(1)) == digest(Circle(2))
    (True, False)
    """
    sink = blake2b(digest_size=16)
    feed(sink, value)
    return sink.hexdigest()


def feed(sink, value):
    if isinstance(value, Array):
        sink.update(repr(value.values.shape).encode() + value.values.tobytes())
    elif isinstance(value, Enum):
        sink.update(value.name.encode())
    elif isinstance(value, (list, tuple)):
        sink.update(f"[{len(value)}".encode())
        for item in value:
            feed(sink, item)
    elif (names := held(type(value))) is not None:
        sink.update(f"<{type(value).__qualname__}".encode())
        for name in names:
            feed(sink, getattr(value, name))
    else:
        sink.update(repr(value).encode() + b"|")


@cache
def held(kind):
    """The names of the fields of a declared kind, None of any other class: to ask each value takes twice as long."""
    return tuple(field.name for field in fields(kind)) if is_dataclass(kind) else None


def checksum(*arrays):
    """A few digits for each array that differ where arrays differ."""
    return "".join(f"{crc32(np.ascontiguousarray(array).data):08x}" for array in arrays)
