# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The text of a program of a machine, as a parameter of a shape."""

from os import PathLike

from .parameters import require


class Program(str):
    """A text, which whoever needs the moves in it reads.

    >>> Program.coerced("G0 X1\\r\\n")
    'G0 X1\\n'
    """

    __slots__ = ()

    @classmethod
    def coerced(cls, value):
        """The text from a text, its lines ended as on any machine."""
        way = ", as .read_text() of a path gives" if isinstance(value, PathLike) else ""
        require(isinstance(value, str), f"must be the text of a program{way}", value)
        return cls(value.replace("\r\n", "\n").replace("\r", "\n"))
