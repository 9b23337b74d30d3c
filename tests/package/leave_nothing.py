# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run in a Blender that has the extension installed and not enabled: enable it, disable it, and find no trace."""

import sys

import bpy

import addon_utils

NAME = "bl_ext.user_default.sweep_addon"


def traces():
    """Everything in Blender that an extension can leave something in."""
    handlers = {name: len(found) for name, found in members(bpy.app.handlers) if isinstance(found, list)}
    menus = {
        name: len(draw_functions(kind))
        for name, kind in members(bpy.types)
        if isinstance(kind, type) and issubclass(kind, (bpy.types.Menu, bpy.types.Panel, bpy.types.Header))
    }
    properties = {name: set(dir(getattr(bpy.types, name))) for name in ("Mesh", "Object", "Scene", "WindowManager")}
    operators = {name: set(dir(getattr(bpy.ops, name))) for name in dir(bpy.ops)}
    keys = {m.name: len(m.keymap_items) for m in bpy.context.window_manager.keyconfigs.addon.keymaps}
    return {
        **{"types": set(dir(bpy.types)), "handlers": handlers, "menus": menus, "properties": properties},
        **{"operators": operators, "keys": keys, "path": list(sys.path)},
    }


def members(module):
    return [(name, getattr(module, name)) for name in dir(module)]


def draw_functions(kind):
    """What the extension has appended to a menu, panel or header."""
    appended = getattr(getattr(kind, "draw", None), "_draw_funcs", ())
    return [function for function in appended if function.__module__.startswith(NAME)]


before = traces()
if not addon_utils.enable(NAME, default_set=True):
    sys.exit("the extension does not enable")
assert traces() != before, "the extension was not there"
addon_utils.disable(NAME, default_set=True)
after = traces()
left = {kind: (before[kind], after[kind]) for kind in before if before[kind] != after[kind]}
for kind, (was, now) in left.items():
    print(f"left in {kind}: {set(now) ^ set(was) or {k for k in now if now[k] != was[k]}}")
sys.exit(1 if left else 0)
