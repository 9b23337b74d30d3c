# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Machining: programs of milling machines, as the moves of a tool."""

from importlib import import_module

__all__ = ["Toolpath", "read"]

LATER = {"Toolpath": ".programs", "read": ".programs"}


def __dir__():
    return __all__  # what a console offers


def __getattr__(name):
    if name not in LATER:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(LATER[name], __package__), name)
