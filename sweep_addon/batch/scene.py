# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The scene of a job: its shape in a studio, and a camera that fills the picture with it.

All sizes follow the shape's, so that a ring and a bridge look alike.
"""

import ctypes
import sys
from math import tau

import bpy
import numpy as np

from .. import properties
from ..bridge import objects, trees
from ..core.csg.meshes import EMPTY
from ..core.declared.parameters import require
from . import studio
from .camera import axes, fit, turned
from .export import PICTURES, silent, whole
from .job import Engine

CORNERS = np.array([(-1.0, -1.0, -1.0), (1.0, 1.0, 1.0)])  # of what is looked at where nothing is, in metres
LENS = 70.0  # mm on a sensor 36 mm wide: little perspective
SENSOR = 36.0
NOISE = 0.04, 0.01  # where a pixel has no need of more samples, with a denoiser and without


def compose(job, name, frame=0):
    """Replace all that is in Blender by the scene of a job.

    Parameters
    ----------
    job : Job
    name : str
        Of the object.
    frame : int
        Which picture of a turn round the shape, from 1; 0 for the first.

    Returns
    -------
    bpy.types.Object
        The shape, active and selected.
    """
    empty()
    ob = objects.to_object(job.shape, name)
    studio.paint(ob.data, job.render)
    stage([ob], job.render, frame)
    return ob


def told(ob):
    """What is to be told of an object, as that it shows nothing: sentences for people."""
    if trees.is_tree(ob):
        return (EMPTY,) if trees.is_empty(ob) else ()
    return tuple(ob.data.sweep.told.splitlines())


def empty():
    """Leave nothing in Blender."""
    if not hasattr(bpy.types.Mesh, "sweep"):  # Blender is a Python module, where no extension is enabled
        properties.register()
    bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)


def stage(shown, render, frame=0):
    """Put objects into a studio as large as they are; the first becomes the active one.

    Parameters
    ----------
    shown : list of bpy.types.Object
    render : Render
    frame : int
        Which picture of a turn round them, from 1; 0 for the first.
    """
    scene = bpy.context.scene
    bpy.context.view_layer.update()  # of objects that were moved since
    points = np.concatenate([places(ob) for ob in shown])
    if not len(points):  # where steps leave nothing the picture is empty, of where it would be
        points = np.concatenate([np.array(ob.location)[None] + CORNERS for ob in shown])
    low, high = points.min(axis=0), points.max(axis=0)
    radius = max(float(np.linalg.norm(high - low)) / 2, 1e-6)
    middle = (low + high) / 2

    azimuth = render.azimuth + tau * max(frame - 1, 0) / render.frames
    view = axes(azimuth, render.elevation)
    stand(scene, turned(points) if render.frames > 1 else points, view, render)
    studio.illuminate(scene, middle, radius, azimuth)
    studio.surround(scene, render.background)
    if render.ground and render.elevation > 0 and not render.transparent and render.engine is not Engine.WORKBENCH:
        studio.lay_ground(scene, (*middle[:2], low[2]), radius, render.background)
    settle(scene, render)
    for other in scene.objects:
        other.select_set(other in shown)
    bpy.context.view_layer.objects.active = shown[0]


def render_picture(render, output):
    """Render the staged scene into a file, written whole or not at all."""
    scene = bpy.context.scene
    with whole(output) as path, silent():
        scene.render.image_settings.file_format = PICTURES[output.suffix.lower()]
        alpha = render.transparent and output.suffix.lower() != ".jpg"
        scene.render.image_settings.color_mode = "RGBA" if alpha else "RGB"
        scene.render.use_file_extension = False
        scene.render.filepath = str(path)
        bpy.ops.render.render(write_still=True)


def places(ob):
    """The vertices of an object in the world, as its modifiers leave them, (n, 3) float array."""
    mesh = ob.evaluated_get(bpy.context.evaluated_depsgraph_get()).data if ob.modifiers else ob.data
    found = np.empty((len(mesh.vertices), 3), dtype=np.float32)
    mesh.attributes["position"].data.foreach_get("vector", found.ravel())
    matrix = np.array(ob.matrix_world)
    return found @ matrix[:3, :3].T + matrix[:3, 3]


def stand(scene, points, view, render):
    """Put the camera where it just shows the points."""
    camera = bpy.data.cameras.new("Camera")
    camera.lens, camera.sensor_width = LENS, SENSOR
    larger = max(render.width, render.height)
    slopes = [SENSOR / 2 / LENS * size / larger * (1 - 2 * render.margin) for size in (render.width, render.height)]
    place = fit(points, view, slopes)
    distance = float((points - place).dot(view[2]).max())
    camera.clip_start, camera.clip_end = distance / 1000, distance * 100
    scene.camera = studio.linked(scene, "Camera", camera)
    scene.camera.matrix_world = studio.facing(place, view)


def settle(scene, render):
    """The render settings of a scene."""
    settings = scene.render
    settings.engine = engine(render.engine)
    settings.resolution_x, settings.resolution_y, settings.resolution_percentage = render.width, render.height, 100
    settings.film_transparent = render.transparent
    scene.view_settings.view_transform = "Standard"
    if render.engine is Engine.CYCLES:
        import _cycles

        denoiser = bool(_cycles.with_openimagedenoise)
        scene.cycles.samples, scene.cycles.seed, scene.cycles.max_bounces = render.samples, 0, 6
        scene.cycles.use_light_tree = False  # it pays with many lamps
        scene.cycles.use_denoising, scene.cycles.denoising_prefilter = denoiser, "FAST"
        scene.cycles.adaptive_threshold = NOISE[not denoiser]
    elif render.engine is Engine.EEVEE:
        scene.eevee.taa_render_samples = render.samples
    else:
        scene.display.shading.light, scene.display.shading.color_type = "STUDIO", "MATERIAL"
        scene.display.shading.show_cavity, scene.display.shading.show_shadows = True, True
        scene.display.shading.background_type, scene.display.shading.background_color = "WORLD", scene.world.color


def engine(chosen):
    """Blender's name of an engine; one that draws by OpenGL is refused where that would end the process."""
    if chosen is Engine.CYCLES:
        return "CYCLES"
    if sys.platform == "linux":
        try:
            ctypes.CDLL("libEGL.so.1")
        except OSError:
            require(False, "must be cycles, as this machine has no libEGL", chosen.name.lower(), "render.engine")
    if chosen is Engine.WORKBENCH:
        return "BLENDER_WORKBENCH"
    return "BLENDER_EEVEE" if bpy.app.version >= (5, 0, 0) else "BLENDER_EEVEE_NEXT"
