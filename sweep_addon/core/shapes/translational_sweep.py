# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The translational sweep: a contour moved along a line segment, its sides upright, oblique or drafted."""

from enum import Enum
from math import radians

import numpy as np

from ..contours import Fit, PlanarSet, Rectangle
from ..declared.options import Texture
from ..declared.parameters import Array, angle, count, declared, length, parameter, require
from ..later import later
from ..rings.ends import Cap, Flat
from .operand import Operand

extruding = later("core.shapes.extruding")

FEW = 100  # steps of any contour make no mesh that is too large
ATTRIBUTES = "UVs and Attributes"
STEEPEST = radians(89)
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
    the plane, as those of a casting do. A taper at which the whole contour becomes a point is a pyramid or a cone. An
    edge that has no length left is gone and its neighbours meet; where a hollow corner reaches another edge the contour
    parts, and where loops meet they join; so a rectangle may end in the ridge of a hip roof.

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
    >>> hipped = TranslationalSweep(Rectangle(3, 2), 3.0, taper=atan(1 / 3)).mesh()  # a pyramid, and a wedge between
    >>> round(hipped.volume(), 12), len(hipped.vertices)
    (7.0, 6)
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
        """Refuse a direction down or nearly along the contour's plane, drafts and steps within the plane, and what the
        contour cannot have: a fit, too many steps, drafts of open curves or of other loops, or steeper than its width.
        """
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
        if self.is_drafted or self.steps > FEW or self.fit is not Fit.INSCRIBED:  # else it needs no section yet
            extruding.require_possible(self)

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
            Where nothing is left of a tapered contour below the height, or where there would be too many vertices.

        Examples
        --------
        >>> TranslationalSweep(height=2.0, steps=3).mesh().vertices.shape
        (16, 3)
        """
        return extruding.mesh(self, dtype)

    def self_intersections(self):
        """Where the sweep meets itself: nowhere, for its plane moves one way, and edges that meet end there.

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

    @property
    def make_solid(self):
        """Whether the mesh takes so long that in a window the last one stays until it is made."""
        return extruding.takes_long(self)

    def surface(self, dtype=np.float64):
        """Nothing: a roof that is followed to half of its height would be another one."""

    def follow(self, progress=None):
        """Make what of the mesh takes long, which is kept for it; told of the progress as `solid` is."""
        extruding.follow(self, progress)

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

        self.follow(progress)
        return closed(self.mesh())

    def sections(self):
        """The sections of the contour as its reference point is at the origin: one, unless it is mixed."""
        return extruding.sections_of(self)

    def heights(self):
        """How far contours stand out of their plane, which is among them if they are drafted: (n,) float array."""
        return extruding.heights_of(self)

    @property
    def is_drafted(self):
        """Whether sides lean."""
        return bool(self.taper or self.hole_taper or self.tapers.values.any())

    @property
    def is_parted(self):
        """Whether edges of a drafted contour vanish, part or join on the way."""
        return self.is_drafted and extruding.is_parted(self)

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
        return extruding.frames(self, most)
