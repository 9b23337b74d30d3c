# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is imported when it is first used: what makes meshes, in modules that declare what they are made of.

Whoever starts Blender waits for every module that enabling the extension imports, and may sweep nothing that day.
"""

from functools import cached_property
from importlib import import_module


def later(module, *names):
    """Functions and classes of a module, which is imported when one of them is first called.

    Parameters
    ----------
    module : str
        Its name within `sweep_addon`: ``core.meshes.mesh``.
    *names : str
        What is meant of it; without any, the module.

    Returns
    -------
    What stands for the one thing that is meant, or a tuple of such: to be called, or asked for what it has.

    Examples
    --------
    >>> norms, unit = later("core.vectors", "norms", "unit")
    >>> norms([[3.0, 4.0]])
    array([5.])
    >>> later("core.vectors").unit is unit.meant
    True
    """
    if len(names) > 1:
        return tuple([Later(module, name) for name in names])
    return Later(module, *names)


class Later:
    """What stands for a function, a class or a module until it is used, and afterwards passes on what it is asked."""

    def __init__(self, module, name=""):
        self.module, self.name = module, name

    @cached_property
    def meant(self):
        module = import_module(f"..{self.module}", __package__)
        return getattr(module, self.name) if self.name else module

    def __call__(self, *values, **named):
        return self.meant(*values, **named)

    def __instancecheck__(self, value):
        return isinstance(value, self.meant)

    def __getattr__(self, name):
        return getattr(self.meant, name)
