# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""F12: a picture is sampled as renders ask for while the view keeps its own, also when the shape changes meanwhile.

A ring of three contours in the view and of 200 in a render, from above: the pixels it covers are counted. Whatever asks
for it, its mesh is written by the thread that draws it.
"""

from importlib import import_module

import bpy
import numpy as np
from _window import PICTURES, run

EXTENSION = "bl_ext.user_default.sweep_addon.sweep_addon"
live, drawing_thread = (import_module(f"{EXTENSION}.properties.{name}") for name in ("live", "drawing_thread"))

FIELD, PIXELS = 4.0, 256
RING = 2 * np.pi * 1.5 * 0.2  # square metres that a ring of 1.5 m covers, its wire 0.2 m thick


def covered(name):
    """The square metres that a picture shows something in."""
    image = bpy.data.images.load(str(PICTURES / name))
    alpha = np.array(image.pixels[:]).reshape(-1, 4)[:, 3]
    bpy.data.images.remove(image)
    return float(alpha.sum()) * (FIELD / PIXELS) ** 2


def settle(scene):
    """A camera that looks straight down on 4 m by 4 m."""
    scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(scene.camera)
    scene.camera.location.z, scene.camera.data.type, scene.camera.data.ortho_scale = 20, "ORTHO", FIELD
    scene.render.engine, scene.cycles.samples = "CYCLES", 24
    scene.render.resolution_x = scene.render.resolution_y = PIXELS
    scene.render.film_transparent, scene.render.image_settings.color_mode = True, "RGBA"


def rendered(person, name, meanwhile=lambda: None, **options):
    """What F12 calls; do something while it renders, and wait for the end."""
    scene = bpy.context.scene
    scene.render.filepath = str(PICTURES / name)
    with bpy.context.temp_override(window=person.window, area=person.area, region=person.view):
        bpy.ops.render.render("INVOKE_DEFAULT", write_still=True, **options)
    yield 0.1
    assert bpy.app.is_job_running("RENDER")
    meanwhile()
    while bpy.app.is_job_running("RENDER"):
        yield 0.1
    yield 0.5


def watched():
    """Whether what was written was, each time, by the thread that draws, or in its place: a list to be filled."""
    writers, put = [], live.put
    live.put = lambda *made: [writers.append(drawing_thread.is_drawing_thread()), put(*made)]
    return writers


def render(person):
    yield 0.5
    writers = watched()
    bpy.context.preferences.view.render_display_type = "NONE"
    PICTURES.mkdir(parents=True, exist_ok=True)
    bpy.data.batch_remove(list(bpy.data.objects))
    settle(bpy.context.scene)
    bpy.ops.mesh.generalized_cylinder_add(
        trajectory="ARC", trajectory_arc_radius=1.5, trajectory_arc_angle=2 * np.pi, samples="COUNT"
    )
    ring = bpy.context.active_object
    group = ring.data.sweep.generalized_cylinder
    group.samples_count_contours, group.samples_count_render = 3, 200
    assert len(ring.data.vertices) == 3 * 64
    yield from rendered(person, "r1.png")
    assert abs(covered("r1.png") / RING - 1) < 0.01
    assert len(ring.data.vertices) == 3 * 64 and not ring.data.sweep.edited

    def thicker():
        group.contour_circle_radius = 0.2

    yield from rendered(person, "r2.png", thicker)
    assert len(ring.data.vertices) == 3 * 64 and not ring.data.sweep.edited
    yield from rendered(person, "r3.png")
    assert abs(covered("r3.png") / (2 * RING) - 1) < 0.01

    group.samples_count_contours, group.samples_count_render = 200, 0
    for frame, radius in ((1, 0.1), (4, 0.4)):
        group.contour_circle_radius = radius
        ring.data.keyframe_insert("sweep.generalized_cylinder.contour_circle_radius", frame=frame)
    bpy.context.scene.frame_set(1)
    bpy.context.scene.frame_end = 4
    yield from rendered(person, "r-###", animation=True)
    covers = [covered(f"r-00{frame}.png") for frame in (1, 4)]
    assert np.allclose(np.divide(covers, RING), (1, 4), rtol=0.01), covers
    assert len(ring.data.vertices) == 200 * 64 and abs(ring.dimensions.z - 0.2) < 1e-3
    assert writers and all(writers), writers


run(render)
