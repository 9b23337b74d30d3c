# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The boundary of what a ball visits that moves over the surface of a solid, by the engine that suits the solid."""

from dataclasses import replace

import numpy as np

from ..declared.frozen import individual
from ..declared.options import Engine, Side
from ..declared.parameters import ShapeError, require
from ..declared.wording import shown
from ..distance import Tree, nearest
from ..meshes.facets import bent_facets
from ..meshes.polyhedron import polyhedron
from ..progress import unheard, within
from ..resolving.tidying import tidied_arrays
from ..vectors import cross, dot, norms
from .around import Around
from .band import MOST_CORNERS, TooFineError
from .convex import convex_inset, convex_offset, is_convex
from .dual import TornError
from .interval import enclosing
from .level_set import level_set
from .parts import inward_part
from .rounded_union import few_faces, offset_bodies, rounded

FEW = 2000  # flat faces: a hull for each takes four milliseconds, and a rough mesh stands meanwhile
FINEST = 160  # cells across, where nobody asks for a tolerance and the radius is small
ACROSS = 64  # cells across, where nobody asks for a tolerance and the radius is large
ARC = 0.1  # radians between neighbours on arcs, where nobody asks for a tolerance
SIDES = 16  # meridians of the ball, where nobody asks for a tolerance
MOST_SIDES = 64
ROUNDED = 4  # steps of single precision: as far as tidying may move what a union has made
MOST_DIRECTIONS = 1_000_000  # of domes: the hull of as many takes some seconds
MOST_PRODUCTS = 20_000_000_000  # of directions and vertices
PLACES = 27 * np.sqrt(3) / 4  # that are looked at for each square of a surface as large as a face of a cell
UNSURE = 4  # how many times too many may seem to come from the area of the solid
LEAST = 1e-7  # of the size of a solid is a radius: with less its faces are no longer apart
ROUGH = 0.8  # of the radius: where faces come nearer than this, it is told how to do better
RANGE = (0.005, 0.995)  # what 99 % of the triangles are between


@individual
class Offset:
    """An offset, how it was made, and what is known of its error.

    Parameters
    ----------
    vertices : (n, 3) float array
        In metres.
    triangles : (t, 3) int array
        Counter-clockwise from outside.
    engine : Engine
    reason : str
        Why that engine.
    lower, upper : (t,) float arrays
        No point of a triangle is nearer to the surface of the solid, or farther from it, in metres: proved.
    crossing : int
        Pairs of triangles that cross each other.
    tolerance : float
        What was asked for, in metres; 0 is nothing.

    Examples
    --------
    >>> from sweep_addon.core.solids import Block
    >>> found = offset(Block(1.0, 1.0, 1.0).mesh(), 0.5)
    >>> found.engine.name, found.reason
    ('CONVEX', 'the solid is convex')
    """

    vertices: np.ndarray
    triangles: np.ndarray
    engine: Engine
    reason: str
    lower: np.ndarray
    upper: np.ndarray
    crossing: int = 0
    tolerance: float = 0.0

    def told(self, radius):
        """Sentences about the offset for people."""
        bounds = [self.lower.min(), self.upper.max()]
        most = [np.quantile(self.lower, RANGE[0]), np.quantile(self.upper, RANGE[1])]
        between = dict.fromkeys(" to ".join(f"{x / radius:.3g}" for x in pair) for pair in (bounds, most))
        name = self.engine.name.lower().replace("_", " ")
        away = ", nearly all of it ".join(between)
        yield f"Engine {name}, as {self.reason}. The surface is proved to be {away} radii away."
        if bounds[0] < ROUGH * radius:
            cells = self.engine == Engine.LEVEL_SET
            large = "radius is small beside the cells" if cells else "tolerance is large beside the radius"
            yield f"The {large}: a smaller tolerance makes the offset nearer."
        if self.engine == Engine.ROUNDED_FACES and self.tolerance and meridians(radius, self.tolerance) > MOST_SIDES:
            off = radius - bounds[0]
            yield f"The tolerance is not kept: arcs are up to {off:.3g} m off, as a ball has {MOST_SIDES} meridians."
        if self.crossing:
            yield f"{self.crossing} pairs of faces cross each other: a smaller tolerance parts them."

    def mesh(self, radius, dtype=np.float64):
        """The offset as a `Mesh` that tells of it."""
        return polyhedron(self.vertices.astype(dtype), self.triangles, told=self.told(radius))


def offset(mesh, radius, side=Side.OUTSIDE, tolerance=0.0, engine=Engine.AUTOMATIC, progress=unheard):
    """The boundary of what a ball visits that moves over the surface of a solid.

    Parameters
    ----------
    mesh : Mesh
        Closed, manifold and oriented; it does not cross itself.
    radius : float
        In metres.
    side : Side
    tolerance : float
        How far the offset may be from the true one on smooth parts, in metres; 0 is by the size of the solid.
    engine : Engine
    progress : callable, optional
        Is told which part is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    Offset

    Raises
    ------
    ShapeError
        For a mesh that is not closed, or crosses itself so that its inside is not clear; inside where nothing is left
        of the solid; for too small a tolerance or radius; for an engine that is not for the solid.
    """
    open_edges, odd = mesh.boundary_edges(), mesh.non_manifold_edges()
    closed = "must be closed, or a contour, in Blender a curve or text, that bounds a plane area"
    require(not len(open_edges), closed, f"{len(open_edges)} open edges", "body")
    require(not len(odd), "must be manifold and look outwards", f"{len(odd)} edges that are not", "body")
    volume = mesh.volume()
    require(volume > 0, "must look outwards and hold something", volume, "body")
    vertices, triangles = bent_facets(mesh)
    triangles = triangles.astype(np.int64)
    wrong = inward_part(vertices, triangles)
    require(not wrong, "must look outwards where it is not a cavity of another", f"part {wrong}", "body")
    least = LEAST * np.ptp(vertices, axis=0).max()
    require(radius >= least, f"must be at least {least:.3g}, {LEAST:g} of the size of the body", radius, "radius")
    engine, reason = chosen(engine, vertices, triangles, side, meridians(radius, tolerance))
    made = {Engine.CONVEX: by_hull, Engine.ROUNDED_FACES: by_faces, Engine.LEVEL_SET: by_level_set}[engine]
    found = made(vertices, triangles, radius, side, tolerance, progress)
    require(len(found[1]), "must leave something of the solid inside", radius, "radius")
    return replace(Offset(*found[:2], engine, reason, *found[2:]), tolerance=tolerance)


def chosen(engine, vertices, triangles, side, around):
    """The engine that suits a solid and the meridians of a ball that keep the tolerance, and why."""
    convex = engine in (Engine.AUTOMATIC, Engine.CONVEX) and is_convex(vertices, triangles)
    require(convex or engine != Engine.CONVEX, "must be another for a solid that is not convex", "convex", "engine")
    if engine != Engine.AUTOMATIC:
        return engine, "was asked for"
    if convex and side == Side.OUTSIDE:
        return Engine.CONVEX, "the solid is convex"
    if not few_faces(vertices, triangles, FEW):
        return Engine.LEVEL_SET, f"the solid has more than {FEW} flat faces"
    if convex:
        return Engine.CONVEX, "the solid is convex"
    if around > MOST_SIDES:
        return Engine.LEVEL_SET, "rounded faces do not keep the tolerance"
    return Engine.ROUNDED_FACES, f"the solid has no more than {FEW} flat faces"


def by_hull(vertices, triangles, radius, side, tolerance, progress):
    """The offset of a convex solid."""
    parts = []
    if side != Side.INSIDE:
        step = arc(radius, tolerance, len(vertices))
        made = convex_offset(vertices, triangles, radius, step)
        parts.append((*made, least_distances(*made, radius, step), np.full(len(made[1]), radius)))
        progress(1.0 if side == Side.OUTSIDE else 0.5)
    if side != Side.OUTSIDE:
        inner, faces = convex_inset(vertices, triangles, radius)
        exact = np.full(len(faces), radius)
        parts.append((inner, faces[:, ::-1] if side == Side.SHELL else faces, exact, exact))
    return together(parts)


def arc(radius, tolerance, vertices):
    """The angle between neighbours on arcs and domes that keeps the tolerance, unless domes would be too fine."""
    least = np.sqrt(4 * np.pi / min(MOST_DIRECTIONS, MOST_PRODUCTS / vertices))  # as all are on the unit sphere
    allowed = radius * (1 - np.cos(least / 2))
    require(
        not 0 < tolerance < allowed, f"must be at least {allowed * 1.01:.3g} for this radius", tolerance, "tolerance"
    )
    return min(2 * np.arccos(max(1 - tolerance / radius, 0)) if tolerance else ARC, 0.5)


def meridians(radius, tolerance):
    """How many of a ball keep the tolerance: a multiple of four, or infinite."""
    if not tolerance:
        return SIDES
    half = np.arccos(max(1 - tolerance / radius, 0))
    return max(4 * np.ceil(np.sqrt(2) * np.pi / half / 4), 8) if half else np.inf


def by_faces(vertices, triangles, radius, side, tolerance, progress):
    """The offset of a solid of few faces; where their union has gone wrong, they are united in another order."""
    sides, share = int(min(meridians(radius, tolerance), MOST_SIDES)), within(progress, 0, 0.9)
    surface = Tree.of(vertices[triangles])
    for faces in (triangles, triangles[::-1]):
        swept = rounded(vertices, faces, radius, sides, share)
        grown, shrunk = offset_bodies(vertices, triangles, swept.body)
        made = tidied_arrays({Side.OUTSIDE: grown, Side.INSIDE: shrunk, Side.SHELL: swept.body}[side])
        lower, upper = distances_kept(*made, surface, swept.inscribed * radius, radius)
        if (upper <= radius).all() and (lower >= swept.inscribed * radius).all():
            break
    return *made, lower, upper


def distances_kept(vertices, triangles, surface, least, most):
    """Bounds of the distances of triangles from a surface: the least and the most, where their middles keep these.

    Sometimes a union puts a triangle across many others, or leaves some out. One is as far as its middle, but for its
    size.
    """
    corners = vertices[triangles]
    middle = corners.mean(axis=1)
    far = nearest(surface, middle).distances
    reach = norms(corners - middle[:, None]).max(axis=1, initial=0.0)
    slack = ROUNDED * float(np.spacing(np.float32(np.abs(vertices).max(initial=0.0))))
    wrong = (far < least - slack) | (far > most + slack)
    return np.where(wrong, np.maximum(far - reach, 0), least), np.where(wrong, far + reach, most)


def by_level_set(vertices, triangles, radius, side, tolerance, progress):
    """The offset of any solid."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    step = cells(radius, tolerance, (high - low).max())
    sides = cross(*(vertices[triangles[:, i]] - vertices[triangles[:, 0]] for i in (1, 2)))
    area = norms(sides).sum() / 2
    if PLACES * area / step**2 > UNSURE * MOST_CORNERS:  # the search tree would also be too large
        about = high - low + 2 * radius
        raise too_fine(np.sqrt(PLACES * max(area, 2 * dot(about, np.roll(about, 1))) / MOST_CORNERS), radius, tolerance)
    parts, crossing = [], 0
    ways = {Side.OUTSIDE: (True,), Side.INSIDE: (False,), Side.SHELL: (True, False)}[side]
    for number, outward in enumerate(ways):
        field = Around(vertices, triangles, radius, outward, step)
        room = radius if outward else 0.0
        share = within(progress, number / len(ways), (number + 1) / len(ways))
        surface = clear(field, low - room, high + room, step, tolerance, share)
        if surface is not None:
            faces = surface.triangles if outward or side == Side.SHELL else surface.triangles[:, ::-1]
            parts.append((surface.vertices.places, faces, *field.interval(surface)))
            crossing += len(surface.crossing)
    return *together(parts), crossing


def clear(field, low, high, step, tolerance, progress):
    """The level set of a field, refusals told of what people gave."""
    try:
        return level_set(field, low, high, step, progress)
    except TornError as error:
        raise ShapeError("must not cross itself", "body") from error
    except TooFineError as error:
        raise too_fine(error.step, field.radius, tolerance) from error


def too_fine(step, radius, tolerance):
    """The refusal of a tolerance that takes smaller cells than of a step."""
    least = f"at least {1.01 * step**2 / (2 * radius):.3g}" if step <= radius / 2 else "0"
    sentence = f"must be {least} for this radius, or there are too many cells, got {shown(tolerance)}"
    return ShapeError(sentence, "tolerance")


def cells(radius, tolerance, size):
    """The side of a cell: its chords keep the tolerance, and no cell holds both sides of what the ball visits."""
    if tolerance:
        return min(np.sqrt(2 * radius * tolerance), radius / 2)
    return max(min((size + 2 * radius) / ACROSS, radius / 2), (size + 2 * radius) / FINEST)


def least_distances(vertices, triangles, radius, step):
    """A lower bound of the distance of each triangle from a convex solid, where all corners are at the radius.

    One is the sagitta in the smallest circle around it. The other holds for all: any direction in the cone of a vertex
    is at most 0.71 steps from one of its dome or from an edge of the cone, and that edge half a step from one of its
    arc; a vertex without a dome has a place no farther than 0.71 steps from any.
    """
    sagitta = np.sqrt(np.maximum(radius**2 - enclosing(vertices[triangles]) ** 2, 0))
    return np.maximum(sagitta, radius * np.cos(1.5 * step))


def together(parts):
    """Several surfaces as one: vertices, triangles, and the bounds of each."""
    if not parts:
        return np.zeros((0, 3)), np.zeros((0, 3), dtype=int), np.zeros(0), np.zeros(0)
    starts = np.cumsum([0, *(len(part[0]) for part in parts)])
    vertices, triangles, lower, upper = zip(*parts, strict=True)
    triangles = [faces + start for faces, start in zip(triangles, starts[:-1], strict=True)]
    return tuple(map(np.concatenate, (vertices, triangles, lower, upper)))
