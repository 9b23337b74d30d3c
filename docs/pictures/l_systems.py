# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The contact sheet of all grammars among the presets, as they are offered in the menu.

What is flat is seen from in front, what stands in space from a little above. A grammar says colours by number: which
colour each number is, is said here.

Run by `scripts/gallery` in Blender: l_systems.py -- PICTURE.
"""

import sys
from math import radians
from pathlib import Path

import bpy
import numpy as np
from mathutils import Euler, Matrix

from bl_ext.user_default.sweep_addon.sweep_addon import presets
from bl_ext.user_default.sweep_addon.sweep_addon.batch import scene, studio
from bl_ext.user_default.sweep_addon.sweep_addon.batch.job import Render
from bl_ext.user_default.sweep_addon.sweep_addon.bridge import meshes

COLUMNS, CELL, LINE = 10, 170, 23  # cells in a row, their pixels, and those of the title below
STEPS = 16  # of a colour from dark to light in the file
FILLED = 0.9  # of a cell by its figure
FLAT = 0.1  # depth of what is seen from in front, in its size
AZIMUTH, ELEVATION = -2.17, 0.28
PAPER, CARD, TITLE = (0.875, 0.875, 0.9375), (1.0, 1.0, 1.0), (0.125, 0.125, 0.1875)
INK, BARK, GREEN, LEAF = (0.10, 0.22, 0.48), (0.36, 0.25, 0.17), (0.18, 0.36, 0.16), (0.30, 0.52, 0.20)
PINK, VIOLET, GOLD, RED = (0.92, 0.55, 0.68), (0.45, 0.30, 0.70), (0.87, 0.62, 0.15), (0.75, 0.10, 0.12)
STEEL, GREY = (0.35, 0.55, 0.75), (0.62, 0.66, 0.62)
TUBES = {  # of the numbers of a figure's colours, in turn; a number beyond them has the last
    "alternate_leaf": [GREEN],
    "anabaena": [LEAF, GREEN],
    "bamboo": [LEAF],
    "blood_vessels": [RED],
    "cherry_twig": [BARK, GREEN],
    "conifer": [BARK, GREEN],
    "coral": [(0.93, 0.45, 0.30)],
    "daisy": [GREEN, GREEN, GOLD],
    "dandelion": [GREEN, GREY],
    "feather": [STEEL],
    "fibonacci_cells": [LEAF, GOLD],
    "heterocysts": [LEAF, GOLD],
    "lavender": [GREEN, VIOLET],
    "lightning": [VIOLET],
    "palm": [BARK],
    "parametric_words": [INK, GOLD, RED],
    "pine_cone": [BARK, (0.52, 0.37, 0.24)],
    "pineapple": [GOLD],
    "saguaro": [LEAF],
    "sea_fan": [(0.55, 0.20, 0.50)],
    "signal_down": [LEAF, RED],
    "signal_up": [LEAF, RED],
    "signal_wave": [LEAF, RED],
    "snow_crystal": [STEEL],
    "succulent": [GREEN, (0.36, 0.56, 0.40)],
    "sunflower": [(0.45, 0.28, 0.10)],
    "tendril": [LEAF],
    "wheat": [GREEN, GREEN, GOLD],
} | dict.fromkeys(
    ["crocus", "lychnis", "mycelis", "capsella", "flowering_plant", "grass", "fern", "kelp", "ivy"], [GREEN, GOLD]
)
FACES = {
    "cherry_twig": [PINK],
    "crocus": [LEAF, LEAF, VIOLET],
    "daisy": [LEAF, (0.78, 0.74, 0.93), LEAF, LEAF],
    "lychnis": [LEAF, (0.45, 0.60, 0.42), (0.80, 0.15, 0.45)],
    "pythagoras_tree": [LEAF],
    "kelp": [(0.42, 0.44, 0.12)],
}
PETALS = {"flowering_plant": (4, PINK)}  # faces of so many corners
WOODEN = ("tree", "oak", "birch", "willow", "poplar", "conifer", "roots", "bush")


def main(picture):
    scene.empty()
    shown = [preset for preset in presets.PRESETS if preset.group == presets.GROWN]
    rows = -(-len(shown) // COLUMNS)
    for number, preset in enumerate(shown):
        column, row = number % COLUMNS, number // COLUMNS
        middle = np.array([column + 0.5, 0.0, -(row + 0.5) * (CELL + LINE) / CELL])
        ground(middle)
        figure(preset, middle + (0, 0, LINE / CELL / 2))
        label(preset.title, middle - (0, 0, 0.5))
    photograph(rows, picture)


def figure(preset, middle):
    """A preset's mesh, turned towards the camera and as large as its cell."""
    name, mesh = preset.path.stem, presets.shape(preset.name).mesh()
    size = np.ptp(mesh.vertices, axis=0)
    if size[2] < FLAT * size.max():
        turned = Matrix.Rotation(np.pi / 2, 4, "X")
    elif size[1] < FLAT * size.max():
        turned = Matrix()
    else:
        turned = Matrix.Rotation(ELEVATION, 4, "X") @ Matrix.Rotation(AZIMUTH, 4, "Z")
    seen = mesh.vertices @ np.array(turned.to_3x3()).T
    low, high = seen.min(axis=0), seen.max(axis=0)
    scale = FILLED / (high - low)[[0, 2]].max()
    place = Matrix.Translation(middle - scale * (low + high) / 2) @ Matrix.Scale(scale, 4) @ turned
    data = bpy.data.meshes.new(name)
    meshes.write(data, mesh)
    coloured(data, name, mesh)
    studio.linked(bpy.context.scene, name, data).matrix_world = place


def coloured(data, name, mesh):
    """Materials of the colours that a figure's numbers are, tubes and faces apart: faces have no radius."""
    tubes, faces = palettes(name)
    first = mesh.corners[mesh.offsets[:-1]]
    number, filled = mesh.attributes["colour"][first].astype(int), mesh.attributes["radius"][first] == 0
    slot = np.where(filled, len(tubes) + np.minimum(number, len(faces) - 1), np.minimum(number, len(tubes) - 1))
    corners, petal = PETALS.get(name, (0, LEAF))
    slot[filled & (np.diff(mesh.offsets) == corners)] = len(tubes) + len(faces)
    data.materials.clear()
    for colour in (*tubes, *faces, petal):
        data.materials.append(matt(colour))
    data.polygons.foreach_set("material_index", slot.astype(np.int32))


def palettes(name):
    wooden = any(word in name for word in WOODEN) and name not in ("row_of_trees",)
    weed = any(word in name for word in ("plant_", "_plant", "leaf", "hogeweg", "pattern"))
    plain = [BARK] if wooden else [GREEN] if weed else [INK]
    return TUBES.get(name, plain), FACES.get(name, [LEAF])


def matt(colour):
    """A material of a colour without shine; each colour is made once."""
    name = f"matt {colour}"
    if name not in bpy.data.materials:
        surface = studio.tree(bpy.data.materials.new(name)).nodes["Principled BSDF"].inputs
        surface["Base Color"].default_value = (*studio.linear(colour), 1.0)
        surface["Roughness"].default_value = 0.8
    return bpy.data.materials[name]


def glowing(colour):
    """A material that is seen as its colour, whatever the light."""
    name = f"glowing {colour}"
    if name not in bpy.data.materials:
        material = bpy.data.materials.new(name)
        surface = studio.tree(material).nodes["Principled BSDF"].inputs
        surface["Base Color"].default_value = (0, 0, 0, 1)
        surface["Specular IOR Level"].default_value = 0
        surface["Emission Color"].default_value = (*studio.linear(colour), 1.0)
        surface["Emission Strength"].default_value = 1
    return bpy.data.materials[name]


def ground(middle):
    """The card behind a figure and its title."""
    data = bpy.data.meshes.new("card")
    half = np.array([0.5, 0, (CELL + LINE) / CELL / 2]) - (0.012, 0, 0.012)
    corners = [middle + half * sign + (0, 2, 0) for sign in ((-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1))]
    data.from_pydata(corners, [], [(0, 1, 2, 3)])
    data.materials.append(glowing(CARD))
    card = studio.linked(bpy.context.scene, "card", data)
    card.visible_diffuse = card.visible_glossy = card.visible_shadow = False


def label(text, middle):
    """The title of a preset, as wide as its cell at most."""
    data = bpy.data.curves.new("title", "FONT")
    data.body, data.size, data.align_x = text, 0.085, "CENTER"
    data.materials.append(glowing(TITLE))
    ob = studio.linked(bpy.context.scene, "title", data)
    bpy.context.view_layer.update()
    fits = min(1.0, 0.94 / ob.dimensions.x)
    ob.matrix_world = Matrix.Translation(middle) @ Matrix.Rotation(np.pi / 2, 4, "X") @ Matrix.Scale(fits, 4)


def photograph(rows, picture):
    """Render the wall of cells from in front, without perspective."""
    wide, high = COLUMNS * CELL, rows * (CELL + LINE)
    now = bpy.context.scene
    camera = bpy.data.cameras.new("Camera")
    camera.type, camera.ortho_scale = "ORTHO", max(wide, high) / CELL
    now.camera = studio.linked(now, "Camera", camera)
    middle = np.array([wide / 2, 0, -high / 2]) / CELL
    now.camera.matrix_world = Matrix.Translation(middle - (0, 20, 0)) @ Matrix.Rotation(np.pi / 2, 4, "X")
    sun = bpy.data.lights.new("Sun", "SUN")
    sun.energy, sun.angle = 2.6, radians(8)
    studio.linked(now, "Sun", sun).rotation_euler = Euler((radians(52), 0, radians(-38)))
    studio.surround(now, PAPER)
    render = Render(width=wide, height=high, samples=24, background=PAPER)
    scene.settle(now, render)
    now.cycles.max_bounces = 1
    scene.render_picture(render, picture)
    in_few_colours(picture)


def in_few_colours(picture):
    """Save the picture anew in 17 steps of each colour: a fifth of the bytes, and the eye sees no difference."""
    image = bpy.data.images.load(str(picture))
    values = np.empty(len(image.pixels), dtype=np.float32)
    image.pixels.foreach_get(values)
    image.pixels.foreach_set(np.round(values * STEPS) / STEPS)
    settings = bpy.context.scene.render.image_settings
    settings.file_format, settings.color_mode, settings.compression = "PNG", "RGB", 100
    bpy.context.scene.view_settings.view_transform = "Raw"
    image.save_render(str(picture), scene=bpy.context.scene)


main(Path(sys.argv[sys.argv.index("--") + 1]))
