# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The root of the extension: registers its parts with Blender and offers the library as its own names.

Nothing is imported until it is asked for, so that the checkout, which is this package, can be read by tools and tests
that have no Blender.
"""

import gc
from importlib import import_module

# What registers, each part after those it stands on.
PARTS = (".sweep_addon.properties", ".sweep_addon.batch", ".operators", ".panels")


def register():
    collecting = gc.isenabled()
    gc.disable()  # all that is made here stays: to look for garbage amid it takes two milliseconds
    try:
        for part in PARTS:
            import_module(part, __package__).register()
    finally:
        if collecting:
            gc.enable()


def unregister():
    for part in reversed(PARTS):
        import_module(part, __package__).unregister()


def __getattr__(name):
    # Only as an extension: test runners read the root under other names and ask it for names of their own. Blender asks
    # every extension for the bl_info of old add-ons.
    if name.startswith("__") or name == "bl_info" or not __package__.startswith("bl_ext."):
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(".sweep_addon", __package__), name)


def __dir__():
    return sorted({*globals(), *dir(import_module(".sweep_addon", __package__))})
