# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The translational sweep: a contour moved along a line segment, its sides upright, oblique or drafted."""

from dataclasses import replace
from enum import Enum
from functools import lru_cache
from math import atan, degrees, radians, tan

import numpy as np

from ..contours import Fit, Mixed, PlanarSet, Rectangle, all_fitted
from ..declared.options import Texture
from ..declared.parameters import Array, ShapeError, angle, count, declared, length, parameter, require
from ..declared.wording import shown
from ..later import later
from ..rings.ends import Cap, Flat
from ..stations.frames import Frames, require_several
from .operand import Operand

caps, draft, in_plane = later("core.rings.caps"), later("core.rings.draft"), later("core.grids.in_plane")
Chart, lengths_around = later("core.grids.chart", "Chart", "lengths_around")
affine, drawn = later("core.grids.drawn", "affine", "drawn")
Grid = later("core.grids.grid", "Grid")
Mesh, require_few = later("core.meshes.mesh", "Mesh", "require_few")
finished, welded = later("core.meshes.welding", "finished", "welded")

ATTRIBUTES = "UVs and Attributes"
STEEPEST = radians(89)
PLANE = np.array(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))  # its origin and its axes
FLATTEST = 1e-6  # of a direction's length, out of the contour's plane


class Directions(Enum):
    UP = "From the contour's plane up by the height"
    SYMMETRIC = "Half of the height up and half of it down"
    BOTH = "Up by the height and down by the depth"


class Reference(Enum):
    ORIGIN = "The contour's own origin"
    CENTROID = "The centroid of the contour's area"
    POINT = "Any point of the contour's plane"


@declared
class TranslationalSweep(Operand):
    """A contour that moves along a line segment: an extrusion, a prism, a frustum

    Its orientation does not change, and its shape only by a taper: then all edges of the contour move inwards, parallel
    to themselves and by the same distance, so that the sides stand at the angle of the taper to the direction out of
    the plane, as those of a casting do. A taper at which the whole contour becomes a point is a pyramid or a cone.

    Examples
    --------
    A frustum is as large as its contours and the mean of them, weighted 1, 4 and 1, say (Simpson's rule, exact here).

    >>> from math import atan
    >>> from sweep_addon.core.contours import Rectangle
    >>> round(TranslationalSweep(Rectangle(2, 2), 3.0, taper=atan(1 / 6)).mesh().volume(), 12)
    7.0
    >>> pyramid = TranslationalSweep(Rectangle(2, 2), 3.0, taper=atan(1 / 3)).mesh()
    >>> round(pyramid.volume(), 12), len(pyramid.vertices)
    (4.0, 5)
    """

    contour: PlanarSet = parameter(Rectangle(1.0, 1.0), "What moves", accepts=("CURVE", "FONT"))
    height: float = length(1.0, "How far it moves, measured out of its plane, or within it", soft_maximum=100.0)
    directions: Directions = parameter(Directions.UP, "Which way it moves from its plane")
    depth: float = length(0.5, "How far it moves down, where it moves in both directions", soft_maximum=100.0)
    direction: tuple[float, float, float] = parameter(
        (0.0, 0.0, 1.0), "Where to: straight up, obliquely, or within the plane"
    )
    steps: int = count(1, "Parts of equal height", maximum=100_000, soft_maximum=100)
    taper: float = angle(0.0, "Angle at which the sides lean inwards", minimum=-STEEPEST, maximum=STEEPEST,
                         group="Draft")  # fmt: skip
    hole_taper: float = angle(0.0, "Angle at which the sides of holes lean into the material, so that they widen",
                              minimum=-STEEPEST, maximum=STEEPEST, group="Draft")  # fmt: skip
    tapers: Array = parameter((), "Angle of each loop of the contour, instead of the two", unit="angle", group="Draft")
    reference: Reference = parameter(
        Reference.ORIGIN, "The contour's point that moves from the origin", group="Reference Point"
    )
    reference_x: float = parameter(0.0, "Where a chosen point is along x", unit="length", group="Reference Point")
    reference_y: float = parameter(0.0, "Where a chosen point is along y", unit="length", group="Reference Point")
    start: Cap = parameter(Flat(), "What closes the start", group="Ends")
    end: Cap = parameter(Flat(), "What closes the end", group="Ends")
    texture: Texture = parameter(Texture.LENGTHS, "How texture coordinates are measured", group=ATTRIBUTES)
    attributes: bool = parameter(True, "Keep u, v and arc_length of each vertex for materials", group=ATTRIBUTES)
    fit: Fit = parameter(Fit.INSCRIBED, "How the contour's polygon stands to its curves")
    regularize: bool = parameter(False, "Keep only the parts that are solid, closed and manifold")

    def check(self):
        """Refuse a direction down or nearly along the contour's plane, and drafts and steps within the plane."""
        size = float(np.linalg.norm(self.direction))
        up = self.direction[2] > FLATTEST * size or self.within_plane
        require(up, "must point up, out of the contour's plane, or lie within it", list(self.direction), "direction")
        if self.within_plane:
            require(self.steps == 1, "must be 1 where the direction lies in the plane", self.steps, "steps")
            steepest = max(self.taper, self.hole_taper, *self.tapers.values.tolist(), key=abs)
            require(not steepest, "must be 0 where the direction lies in the plane", steepest, "taper")
        tapers = self.tapers.values
        wrong = tapers[np.abs(tapers) > STEEPEST]
        require(not len(wrong), f"must be at most {STEEPEST:.4g} in size", float((*wrong, 0.0)[0]), "tapers")

    def mesh(self, dtype=np.float64):
        """The surface as a mesh: closed, manifold and outward unless an end is open.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres.

        Returns
        -------
        Mesh

        Raises
        ------
        ShapeError
            Where edges of a tapered contour vanish or meet below the height, or where there would be too many vertices.

        Examples
        --------
        >>> TranslationalSweep(height=2.0, steps=3).mesh().vertices.shape
        (16, 3)
        """
        mesh, mixed = self.whole(dtype)
        return finished(mesh, mixed, self.regularize, lambda few: replace(self, steps=few).whole()[0])

    def whole(self, dtype=np.float64):
        """The mesh, solid or not, and whether it may be of mixed dimension."""
        sections, mixed = self.sections(), self.within_plane or isinstance(self.contour, Mixed)
        if self.within_plane:
            sections = in_plane.swept(sections, *(self.heights()[:, None] * self.way[:2]))
        bodies = [self.body(section, dtype) for section in sections if section]
        return (welded(bodies, [s.points for s in sections if s]), True) if mixed else (bodies[0], False)

    def body(self, section, dtype):
        """The mesh of one section."""
        if self.within_plane:
            return in_plane.flat(section, PLANE, self.texture, self.attributes, dtype)
        heights = self.heights()
        require_few(len(heights) * len(section.points), "steps")
        drafted = self.drafted(section, heights)
        moves, points = drafted.moves, drafted.points
        s = (heights - heights[0]) / self.upright
        grid = Grid(
            rings=len(heights),
            tips=tuple(station for station, point in zip((0, len(heights) - 1), points, strict=True) if point),
            closed=False,
            creases=tuple(np.flatnonzero(heights == 0).tolist()) if moves.any() and heights[0] < 0 else (),
            offsets=tuple(section.offsets.tolist()),
            sharp=tuple(np.flatnonzero(section.sharp).tolist()),
            caps=caps.at_ends(drafted.ends, (self.start, self.end), points),
            gaps=tuple(section.gaps.tolist()),
        )
        flat = tuple(end.points for end in drafted.ends)
        around = lengths_around(section, np.ones(2))
        chart = Chart(grid, s / s[-1], s, s[-1], around, flat, self.texture, self.attributes)
        return Mesh(drawn(grid, *self.laid(section, moves, heights), dtype), grid.topology(), chart)

    def self_intersections(self):
        """Where the sweep meets itself: nowhere, for its plane moves one way, and a taper ends before edges meet.

        Within its plane a sweep covers each place once, however often the contour comes by.

        Returns
        -------
        Places
            Empty.

        Examples
        --------
        >>> len(TranslationalSweep(height=2.0).self_intersections())
        0
        """
        from ..self_intersection.places import Places

        return Places(())

    def solid(self, progress=None):
        """The boundary of all points that the contour visits, as one valid solid: each place counts once.

        Parameters
        ----------
        progress : callable, optional
            Is told which part is done, from 0 to 1; what it raises ends the work.

        Returns
        -------
        Mesh
            Closed, manifold and outward, in metres; faces that nothing has cut are as they were. Where the sweep does
            not meet itself it is the surface.

        Raises
        ------
        ShapeError
            For an open surface, a contour that turns too much from sample to sample, or where manifold3d is missing.

        Examples
        --------
        >>> round(TranslationalSweep(height=2.0).solid().volume(), 12)
        2.0
        """
        from ..resolving.resolve import closed

        return closed(self.mesh())

    def sections(self):
        """The sections of the contour as its reference point is at the origin: one, unless it is mixed."""
        return referred(self.contour, self.fit, self.reference, (self.reference_x, self.reference_y))

    def heights(self):
        """How far contours stand out of their plane, which is among them if they are drafted: (n,) float array."""
        low, high = {
            Directions.UP: (0.0, self.height),
            Directions.SYMMETRIC: (-self.height / 2, self.height / 2),
            Directions.BOTH: (-self.depth, self.height),
        }[self.directions]
        heights = np.linspace(low, high, self.steps + 1)
        if not self.is_drafted or low == 0:
            return heights
        heights[1:-1][np.abs(heights[1:-1]) <= draft.ALIKE * (high - low)] = 0.0  # but for rounding, also of the depth
        return np.union1d(heights, 0.0)

    @property
    def is_drafted(self):
        """Whether sides lean."""
        return bool(self.taper or self.hole_taper or self.tapers.values.any())

    @property
    def within_plane(self):
        """Whether it moves within the contour's plane."""
        return self.direction[2] == 0 and any(self.direction)

    @property
    def upright(self):
        """The part of its way that its height measures: the cosine of how oblique it is; within the plane all of it."""
        return 1.0 if self.within_plane else self.direction[2] / float(np.linalg.norm(self.direction))

    @property
    def way(self):
        """(3,) float array: how far it moves in a metre of height."""
        return np.array(self.direction) / (float(np.linalg.norm(self.direction)) * self.upright)

    def slopes(self, section):
        """The tangent of the taper of each loop: (k,) float array."""
        if len(self.tapers):
            loops = len(section.areas)
            require(len(self.tapers) == loops, f"must have one angle a loop, {loops}", len(self.tapers), "tapers")
            return np.tan(self.tapers.values)
        return np.where(section.areas >= 0, tan(self.taper), tan(self.hole_taper))

    def drafted(self, section, heights):
        """The section drafted to its ends: a `Draft`; refused where it does not reach them."""
        slopes, ends = self.slopes(section), np.abs(heights[[0, -1]]).tolist()
        if not section.closed:
            key, angle = self.steepest(slopes)
            require(
                not angle, "must be 0 where the contour has open curves or points, which have no inside", angle, key
            )
        found = draft.draft(section, tuple(slopes.tolist()), tuple(ends))
        for height, reached, point in zip(ends, found.reached, found.points, strict=True):
            if height > reached * (1 + draft.ALIKE if point else 1):
                raise self.refusal(slopes, height, reached, point)
        return found

    def refusal(self, slopes, height, reached, point):
        """What is said of a taper whose edges meet before the height: the largest angle, that of a point if all do."""
        key, angle = self.steepest(slopes)
        most = atan(tan(abs(angle)) * reached / height)
        most = f"must be {'at most' if point else 'less than'} {most:.9g} ({degrees(most):.9g} degrees) in size"
        return ShapeError(f"{most}: edges meet {reached:.6g} m from their plane, got {shown(angle)}", key)

    def steepest(self, slopes):
        """The parameter that the steepest slope is of, and its angle."""
        slope = max(slopes.tolist(), key=abs)
        key = "tapers" if len(self.tapers) else "taper" if abs(tan(self.taper)) == abs(slope) else "hole_taper"
        return key, atan(slope)

    def laid(self, section, moves, heights):
        """The weights of the section's points, (m, k), and the rings that they are of, (k, n, 3)."""
        axes = np.zeros((3, len(heights), 3))
        axes[0] = heights[:, None] * self.way
        axes[1, :, 0] = axes[2, :, 1] = 1.0
        weights = affine(section.points)
        if not moves.any():
            return weights, axes
        return np.column_stack((weights, moves)), np.concatenate((axes, axes[1:] * np.abs(heights)[:, None]))

    def frames(self, most=100):
        """The frames and contours at the stations, or at places spread evenly among them.

        Parameters
        ----------
        most : int
            Of places.

        Returns
        -------
        Frames

        Examples
        --------
        >>> frames = TranslationalSweep(height=2.0).frames()
        >>> frames.points.tolist(), frames.e1[0].tolist(), frames.contours[0].shape
        ([[0.0, 0.0, 0.0], [0.0, 0.0, 2.0]], [0.0, 0.0, 1.0], (2, 4, 3))
        """
        require_several(most)
        sections, heights, loops = self.sections(), self.heights(), []
        heights = heights[np.unique(np.linspace(0, len(heights) - 1, min(most, len(heights))).round().astype(int))]
        for section in sections:
            moves = self.drafted(section, heights).moves
            weights, rings = self.laid(section, moves, heights)
            loops += np.split(np.einsum("mk,kni->nmi", weights, rings), section.offsets[1:-1], axis=1)
        s = (heights - heights[0]) / self.upright
        ways = np.tile(self.direction / np.linalg.norm(self.direction), (len(heights), 1))
        return Frames(s / s[-1], s, rings[0], ways, rings[1], rings[2], tuple(loops))


@lru_cache(maxsize=16)
def referred(contour, fit, reference, point):
    """The sections of a contour with a point of its plane at the origin, made once for equal ones."""
    sections = all_fitted(contour, fit)
    if reference is Reference.ORIGIN:
        return sections
    origin = sections[0].centroid if reference is Reference.CENTROID else point
    return tuple(replace(section, points=section.points - origin) for section in sections)
