# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What tells of each kind of shape if points are in it, by ``labels(points, tolerance)``, ``distance`` and ``box``."""

from functools import lru_cache

import numpy as np

from .. import solids
from ..contours import Circle, Contour, Outline, Rectangle
from ..contours.region import Region
from ..csg import Placed, SweptContour, SweptSolid, Tree
from ..declared.names import titled
from ..declared.parameters import at, require, spelled
from ..offsets.in_the_plane import require_closed
from ..rings.ends import Flat
from ..shapes.canal_surface import BallEnd, CanalSurface
from ..shapes.general_sweep import GeneralSweep
from ..shapes.generalized_cylinder import GeneralizedCylinder
from ..shapes.machined_stock import MachinedStock
from ..shapes.offset_surface import OffsetSurface
from ..shapes.pd_curve_sweep import PDCurveSweep
from ..shapes.plant import Plant
from ..shapes.rotational_sweep import RotationalSweep
from ..shapes.translational_sweep import TranslationalSweep
from ..variation.motion import UNDEFORMED, UNSCALED, Motion
from .motion import ways
from .motion.changes import Scaling
from .motion.deformation import Deformation
from .motion.deforming import Deforming
from .plane.regions import region
from .plane.strands import Strands
from .sets import flat
from .sets.balls import BallsBody
from .sets.bodies import BallBody, MeshBody, OffsetBody
from .sets.deformed import DeformedBody
from .sets.discs import DiscsBody
from .sets.moving_plane import MovingPlane
from .sets.moving_rim import MovingRim
from .sets.moving_sheet import MovingSheet
from .sets.moving_solid import MovingSolid
from .sets.prisms import Prism
from .sets.sheet import SheetBody
from .sets.sides import Sided
from .sets.trees import PlacedMember, TreeMember


@lru_cache(maxsize=64)
def member(shape):
    """The set of points of a shape, a solid or a tree; ``is_sheet`` tells of one that it is without an inside."""
    made = next((made for kind, made in KINDS.items() if isinstance(shape, kind)), None)
    require(made, "must be a shape, a solid or a tree", shape, "shape")
    return made(shape)


def solid(shape):
    """The member of what is to be a solid, or a refusal."""
    found = member(shape)
    require(not found.is_sheet, "must be a solid: a surface has no inside", titled(type(shape)))
    return found


def planar(way_of):
    """What makes the member of a planar shape from its way."""

    def made(shape):
        return MovingPlane(way_of(shape))

    return made


def translated(shape):
    """A translational sweep; an upright one has the distance of its contour, one in its plane is flat.

    Of a draft whose edges vanish, part or join the faces are plane, so it is told from its mesh, and as exactly.
    """
    if shape.within_plane:
        return within_plane(shape)
    if shape.is_parted:
        return meshed(shape.mesh())
    plane = MovingPlane(ways.of_translation(shape))
    upright = not shape.is_drafted and not np.any(shape.way[:2])
    if upright and not isinstance(region(shape.contour), Strands):
        low, high = shape.heights()[[0, -1]]
        return Prism(plane, region(shape.contour), -np.array(ways.reference_of(shape)), low, high)
    return plane


def within_plane(shape):
    """A translational sweep in the plane of its contour, at true lines and arcs."""
    require(not shape.regularize, "must be off where no part is solid", shape.regularize, "regularize")
    shape.sections()  # refuses what the mesh would
    return flat.swept(shape.contour, *(shape.heights()[[0, -1], None] * shape.way[:2] - ways.reference_of(shape)))


def prism(contour, height):
    """A solid that is a contour along z, as far down as up."""
    return translated(TranslationalSweep(contour, height, "symmetric"))


def drilled(block):
    """A block with a round hole."""
    x, y, hole = block.width / 2, block.depth / 2, [(block.radius, 0), (-block.radius, 0)]
    return prism(Outline([[(-x, -y), (x, -y), (x, y), (-x, y)], hole], [(0, 0, 0, 0), (1, 1)]), block.height)


def bracket(solid):
    w, d, t = solid.width, solid.depth, solid.thickness
    return prism(Outline([[(0, 0), (w, 0), (w, t), (t, t), (t, d), (0, d)]]), solid.height)


def tree(shape):
    """A tree, its operands each as they are."""
    with at("base"):
        base = solid(shape.base)
    steps = []
    for number, step in enumerate(shape.steps, 1):
        with at(f"steps.{number}.operand"):
            operation, operand = spelled(step.operation), solid(step.operand)
        if steps or operand is not base or operation == "difference":  # of itself a union is what it is
            steps.append((operation, operand))
    return TreeMember(base, steps)


def placed(shape):
    with at("solid"):
        return PlacedMember(shape, member(shape.solid))


def moving(shape):
    """A solid that moves, or a surface, which is the one of its mesh."""
    if member(shape.solid).is_sheet:
        return surface(shape.sweep(solids.Triangles.of(shape.solid.mesh())))
    rigid = shape.rigid
    turns = rigid.turn_x, rigid.turn_y, rigid.turn_z
    with at("solid"):
        return MovingSolid(solid(shape.solid), Motion(rigid.trajectory, rigid.frame, turns, UNSCALED, UNDEFORMED))


def general(shape):
    """A general sweep: of a planar figure by its plane, of a solid by the way back."""
    if isinstance(shape.generator, Contour | Region):
        return deformed(shape) if shape.motion.deforms else planar(ways.of_planar)(shape)
    if len(shape.generator.mesh().boundary_edges()):
        return surface(shape)
    with at("generator"):
        body = solid(shape.generator)
    return MovingSolid(body, shape.motion, change(shape.motion, body.box))


def surface(shape):
    """The sweep of a surface, which stands at the ends that are not open."""
    motion, mesh = shape.motion, shape.swept().generator
    sheet, back = Sided(mesh), motion.comes_back(mesh.vertices)
    stands = tuple(isinstance(end, Flat) for end in (shape.start, shape.end))
    if back or all(stands):
        return MovingSheet(sheet, motion, back, change(motion, sheet.box))
    return MovingRim(sheet, motion, stands, change(motion, sheet.box))


def change(motion, box):
    """What a motion makes of what is in a box, if anything."""
    if motion.deforms:
        return Deformation(motion, box)
    return None if motion.scales == UNSCALED else Scaling(motion, box)


def deformed(shape):
    """The sweep of a planar figure that is deformed."""
    figure, closed = ways.figure(shape)
    return DeformedBody(Deforming(shape, figure), closed, ways.faces_of((shape.start, shape.end)))


def canal(shape):
    """All balls of a canal surface, or with ends that are not round its discs."""
    ends = () if shape.trajectory.closed else (shape.start, shape.end)
    return (BallsBody if all(end is BallEnd.ROUND for end in ends) else DiscsBody)(shape)


def offset(shape):
    """What a ball visits around a solid, or a disc along a contour in its plane."""
    if shape.is_plane:
        return in_plane(shape)
    with at("body"):
        return OffsetBody(solid(shape.body), shape.radius, shape.side)


def in_plane(shape):
    """The offset of a closed contour."""
    require_closed(shape.body)
    return flat.banded(shape.body, shape.radius, shape.side)


def meshed(mesh):
    """What a mesh bounds, or the mesh itself where it is open."""
    return SheetBody(mesh) if len(mesh.boundary_edges()) else MeshBody(mesh)


KINDS = {
    GeneralizedCylinder: planar(ways.of_cylinder),
    TranslationalSweep: translated,
    RotationalSweep: planar(ways.of_rotation),
    PDCurveSweep: planar(ways.of_pd_curve),
    CanalSurface: canal,
    OffsetSurface: offset,
    GeneralSweep: general,
    MachinedStock: lambda stock: meshed(stock.mesh()),
    Plant: lambda plant: member(plant.united()),
    solids.Block: lambda block: prism(Rectangle(block.width, block.depth), block.height),
    solids.Cylinder: lambda rod: prism(Circle(rod.radius), rod.height),
    solids.Bracket: bracket,
    solids.DrilledBlock: drilled,
    solids.Ball: BallBody,
    solids.Triangles: lambda body: meshed(body.mesh()),
    Tree: tree,
    Placed: placed,
    SweptSolid: moving,
    SweptContour: lambda primitive: member(primitive.sweep()),
}
