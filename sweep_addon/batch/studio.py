# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A studio: the materials of a shape, light from large windows, the sky, and a ground that takes the shadow."""

import bmesh
import bpy
import numpy as np
from mathutils import Matrix

from .camera import axes

LIGHTS = {  # where from, in radii of the shape: right of the camera, up, towards it; its size in radii; its strength
    "Key": ((-2.2, 3.2, 2.0), 2.4, 125.0),
    "Fill": ((3.4, 1.8, 2.2), 3.6, 16.0),
    "Rim": ((2.2, 2.8, -2.6), 1.8, 45.0),
}
AMBIENT = (0.86, 0.91, 1.0), 0.45  # the sky's colour and strength


def paint(mesh, render):
    """Materials in the slots that faces name: for the side, for the ends, and for what else a plant has, as leaves."""
    while len(mesh.materials) < 2:
        mesh.materials.append(None)  # clear() would forget which faces are ends
    named = [("Side", render.side), ("Caps", render.caps)] + [("Leaves", render.leaves)] * (len(mesh.materials) - 2)
    for slot, (name, colour) in enumerate(named):
        material = bpy.data.materials.new(name)
        surface = tree(material).nodes["Principled BSDF"].inputs
        surface["Base Color"].default_value = material.diffuse_color = (*linear(colour), 1.0)
        surface["Metallic"].default_value = material.metallic = render.metallic
        surface["Roughness"].default_value = material.roughness = render.roughness
        mesh.materials[slot] = material


def tree(data):
    """The nodes of a material or world; Blender 5 makes them with it."""
    if data.node_tree is None:
        data.use_nodes = True
    return data.node_tree


def linear(colour):
    """A colour as people name it (sRGB) as Blender computes with it."""
    c = np.array(colour)
    return np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)


def facing(place, view):
    """The matrix of a camera or lamp: it looks along its own -z."""
    matrix = np.eye(4)
    matrix[:3, :3] = (view * [[1], [1], [-1]]).T
    matrix[:3, 3] = place
    return Matrix(matrix.tolist())


def illuminate(scene, middle, radius, azimuth):
    """Square lamps round a shape, that follow the camera round it."""
    right, up, away = axes(azimuth, 0.0)
    for name, (direction, size, strength) in LIGHTS.items():
        lamp = bpy.data.lights.new(name, "AREA")
        lamp.size, lamp.energy = size * radius, strength * radius**2
        place = radius * np.array(direction) @ [right, up, -away]
        looks = -place / np.linalg.norm(place)
        across = np.cross(looks, up) / np.linalg.norm(np.cross(looks, up))
        linked(scene, name, lamp).matrix_world = facing(
            middle + place, np.array([across, np.cross(across, looks), looks])
        )


def linked(scene, name, data):
    ob = bpy.data.objects.new(name, data)
    scene.collection.objects.link(ob)
    return ob


def surround(scene, background):
    """A world that lights as a sky does, and is seen as the background's plain colour."""
    world = scene.world = bpy.data.worlds.new("World")
    world.color = linear(background)
    nodes, links = tree(world).nodes, tree(world).links
    nodes.clear()
    sky, seen, mixed = (
        nodes.new(kind) for kind in ("ShaderNodeBackground", "ShaderNodeBackground", "ShaderNodeMixShader")
    )
    sky.inputs["Color"].default_value, sky.inputs["Strength"].default_value = (*AMBIENT[0], 1.0), AMBIENT[1]
    seen.inputs["Color"].default_value = (*linear(background), 1.0)
    rays = nodes.new("ShaderNodeLightPath")
    links.new(rays.outputs["Is Camera Ray"], mixed.inputs[0])
    links.new(sky.outputs[0], mixed.inputs[1])
    links.new(seen.outputs[0], mixed.inputs[2])
    links.new(mixed.outputs[0], nodes.new("ShaderNodeOutputWorld").inputs["Surface"])


def lay_ground(scene, place, radius, background):
    """A round ground under a shape that takes its shadow and fades into the background."""
    mesh = bpy.data.meshes.new("Ground")
    disc = bmesh.new()
    bmesh.ops.create_circle(disc, cap_ends=True, segments=128, radius=6 * radius)
    disc.to_mesh(mesh)
    disc.free()
    mesh.materials.append(fading(linear(background), radius))
    linked(scene, "Ground", mesh).location = np.subtract(place, (0, 0, 1e-4 * radius))


def fading(colour, radius):
    """A material of the ground: opaque under the shape, transparent six radii away."""
    material = bpy.data.materials.new("Ground")
    nodes, links = tree(material).nodes, tree(material).links
    surface = nodes["Principled BSDF"].inputs
    surface["Base Color"].default_value = (*colour, 1.0)
    surface["Roughness"].default_value = 0.9
    distance, fade = nodes.new("ShaderNodeVectorMath"), nodes.new("ShaderNodeMapRange")
    distance.operation, fade.interpolation_type = "LENGTH", "SMOOTHERSTEP"
    links.new(nodes.new("ShaderNodeTexCoord").outputs["Object"], distance.inputs[0])
    links.new(distance.outputs["Value"], fade.inputs["Value"])
    for name, value in {"From Min": 1.2 * radius, "From Max": 5.5 * radius, "To Min": 1.0, "To Max": 0.0}.items():
        fade.inputs[name].default_value = value
    links.new(fade.outputs["Result"], surface["Alpha"])
    return material
