# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects of other Blender files as outlines, trajectories and solids; of the file, nothing stays behind."""

import bpy

from ..core.declared.parameters import require
from . import curves, models


def outline(path, name):
    """The outline of the curve or text object of that name in a .blend file."""
    return from_file(path, name, ("CURVE", "FONT"), curves.outline)


def trajectory(path, name):
    """The trajectory along the one spline of the curve object of that name in a .blend file."""
    return from_file(path, name, ("CURVE",), along)


def along(ob):
    """The one trajectory of a curve object: a job holds one shape, and others would be left out without a word."""
    found = curves.trajectories(ob)
    require(len(found) == 1, "must be a curve of one spline, and of more each in an object of its own", len(found))
    return found[0]


def generator(path, name, types):
    """The triangles of the mesh object of that name in a .blend file, or the outline of a curve or text."""
    return from_file(path, name, types, lambda ob: (models.triangles if ob.type == "MESH" else curves.outline)(ob))


def told(types):
    """Types of objects as people call them."""
    return types.lower().replace("font", "text")


def from_file(path, name, types, read):
    before = set(bpy.data.user_map())
    try:
        try:
            with bpy.data.libraries.load(str(path)) as (there, here):
                known = list(there.objects)
                here.objects = [name] if name in known else []
        except OSError:
            require(False, "must be in a .blend file that Blender can read", str(path))
        require(name in known, f"must be one of the file's {len(known)} objects: {', '.join(known[:8])}", name)
        ob = here.objects[0]
        require(ob.type in types, f"must be a {told(' or '.join(types))} object", told(ob.type))
        bpy.context.scene.collection.objects.link(ob)  # a text is evaluated only in a scene
        return read(ob)
    finally:
        bpy.data.batch_remove(set(bpy.data.user_map()) - before)
