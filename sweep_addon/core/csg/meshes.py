# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The meshes of trees: each operand's closed mesh, and set operations of them by manifold3d."""

from dataclasses import replace

import numpy as np

from ..declared.parameters import at, require, spelled
from ..meshes import booleans
from ..meshes.booleans import body_of, combined, mesh_of
from ..meshes.facets import facets
from ..meshes.polyhedron import polyhedron
from ..meshes.runs import backward
from ..shapes.operand import standing
from ..shapes.translational_sweep import TranslationalSweep
from .placed import Placed
from .tree import Tree

EMPTY = "Tree: nothing is left: the steps take all of it away."
FACES = 1 << 32  # numbers for the faces of each operand


def evaluated(tree):
    """The boundary of a `Tree` as a closed `Mesh` of triangles, which tells if there is none."""
    mesh = mesh_of(body(tree, {}))
    return mesh if len(mesh.vertices) else replace(mesh, told=(EMPTY,))


def body(operand, made):
    """An operand in the form of manifold3d; each object is made once, however often a tree has it."""
    if id(operand) not in made:
        if isinstance(operand, Tree):
            made[id(operand)] = combination(operand, made)
        elif isinstance(operand, TranslationalSweep):
            made[id(operand)] = with_sides(closed_mesh(operand), FACES * len(made))
        else:
            made[id(operand)] = body_of(closed_mesh(operand))
    return made[id(operand)]


def with_sides(mesh, first):
    """An extrusion in the form of manifold3d, its faces numbered from a first one on.

    So corners on its straight lines stay, where the solver drops those between faces of one plane without numbers: what
    is united there later would miss the line by a last digit, and be a surface of its own.
    """
    triangles, face = facets(mesh)
    return booleans.body(mesh.vertices, triangles, first + face)


def combination(tree, made):
    """A tree in the form of manifold3d."""
    with at("base"):
        found = body(tree.base, made)
    for number, step in enumerate(tree.steps, 1):
        with at(f"steps.{number}.operand"):
            found = combined(spelled(step.operation), found, body(step.operand, made))
    return found


def closed_mesh(operand):
    """The mesh of an operand, closed; a sweep that meets itself is made a solid first: solvers keep the overlap."""
    if isinstance(operand, Placed):
        return operand.carried(closed_mesh(operand.solid))
    operand = standing(operand)
    mesh = operand.solid() if callable(getattr(operand, "solid", None)) else operand.mesh()
    wrong = len(mesh.non_manifold_edges())
    require(not wrong, "must be closed and manifold", f"{wrong} edges without two faces")
    return mesh


def transformed(mesh, axes, origin):
    """A mesh whose vertices are taken elsewhere; where they are mirrored its faces are turned over."""
    vertices = mesh.vertices @ axes.T + origin
    mirrored = np.linalg.det(axes) < 0
    corners = mesh.corners[backward(mesh.offsets)] if mirrored else mesh.corners
    return polyhedron(vertices, corners, mesh.offsets, mesh.topology.material, mesh.told)
