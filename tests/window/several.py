# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Several sweeps selected: Blender changes a parameter of all where Alt is held, in one step of undo.

By typing, by dragging, which adds the same to each, by choosing from a list, and by Copy to Selected of the menu that a
right click opens. The widths are measured on the meshes.
"""

import bpy
import numpy as np
from _window import run

CONTOUR, RADIUS = (0.55, 235), (0.55, 256)  # read off a picture
RECTANGLE = 70  # pixels from the contour's field down to the third line of its list
COPY_TO_SELECTED = (0.1, 404)
RADII = (0.1, 0.2, 0.3)


def groups():
    return [ob.data.sweep.generalized_cylinder for ob in bpy.data.objects]


def widths():
    """How far each mesh reaches along x."""
    bpy.context.view_layer.update()
    return np.round([ob.dimensions.x for ob in bpy.data.objects], 4).tolist()


def several(person):
    yield 0.5
    bpy.data.batch_remove(list(bpy.data.objects))
    for radius in RADII:
        place = (9 * radius, 0, 0)
        bpy.ops.mesh.generalized_cylinder_add(trajectory="LINE", contour_circle_radius=radius, location=place)
    for ob in bpy.data.objects:
        ob.select_set(True)
    bpy.ops.ed.undo_push(message="three sweeps")
    yield from person.open_sidebar("Sweep")
    yield from person.picture("s1-three-selected")
    before = widths()
    assert before == [0.2, 0.4, 0.6]

    yield from person.hold_alt(person.type_number(*person.top(*RADIUS), "0.25"))
    assert widths() == [0.5, 0.5, 0.5], "what is typed with Alt is typed for all"
    yield from undone(person, before)

    yield from person.hold_alt(person.drag(*person.top(*RADIUS), right=40))
    added = np.subtract(widths(), before)
    assert added.min() > 0.1 and np.ptp(added) < 1e-3, "what is dragged with Alt is added to all"
    yield from undone(person, before)

    yield from person.type_number(*person.top(*RADIUS), "0.5")
    assert widths() == [0.2, 0.4, 1.0], "without Alt the active sweep alone is changed"
    yield from person.click(*person.top(*RADIUS), button="RIGHTMOUSE")
    yield from person.picture("s2-right-click")
    yield from person.click(*person.top(*COPY_TO_SELECTED))
    assert widths() == [1.0, 1.0, 1.0]
    yield from undone(person, [0.2, 0.4, 1.0])
    yield from undone(person, before)

    x, y = person.top(*CONTOUR)
    yield from person.hold_alt(chosen(person, x, y))
    assert [group.contour for group in groups()] == ["RECTANGLE"] * 3 and widths() == [0.1, 0.1, 0.1]
    yield from person.picture("s4-three-rectangles")
    yield from undone(person, before)


def chosen(person, x, y):
    """A click on a list and one on its third line."""
    yield from person.click(x, y)
    yield from person.picture("s3-list")
    yield from person.click(x, y - RECTANGLE)


def undone(person, before):
    """One step of undo brings all of them back, mesh and parameters."""
    yield from person.undo()
    assert widths() == before
    assert {group.contour for group in groups()} == {"CIRCLE"}


run(several)
