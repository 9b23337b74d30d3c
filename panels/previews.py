# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the shapes for menus and the sidebar, read when one is first drawn."""

from functools import cache
from pathlib import Path

import bpy

from ..sweep_addon.core.declared.names import spelled

FOLDER = Path(__file__).parent / "pictures"


@cache
def collection():
    import bpy.utils.previews  # a module that Blender itself loads only when asked for

    return bpy.utils.previews.new()


def icon(shape):
    """The number of a shape's picture, as layouts take it."""
    name = spelled(shape, "_")
    known = collection()
    return (known.get(name) or known.load(name, str(FOLDER / f"{name}.png"), "IMAGE")).icon_id


def unregister():
    if collection.cache_info().currsize:
        bpy.utils.previews.remove(collection())
        collection.cache_clear()
